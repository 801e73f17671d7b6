// The shader of surfaces: one color, a checkerboard, the color of a value, or those of faces that are
// developed.

import { BufferAttribute, DoubleSide, ShaderMaterial, Vector3 } from 'three';
import { failure, faces, layers, missing, plain, rgb } from './colors.js';
import { glsl as development } from './developed.js';

export const modes = {plain: 0, projective: 1, linear: 2, value: 3, inputFaces: 4,
  intrinsicFaces: 5};

const vertexShader = `
  in vec3 uvw;
  in float value;
  #ifdef DEVELOPED
  in vec2 place;
  in float start;
  out vec2 vPlace;
  out vec3 vWeights;
  flat out int vStart, vFace;
  #endif
  out vec3 vHomogeneous;
  out vec2 vLinear;
  out vec3 vPosition;
  out float vValue;
  void main() {
    vHomogeneous = uvw;
    vLinear = uvw.xy / uvw.z;
    vValue = value;
    #ifdef DEVELOPED
    vPlace = place;
    vStart = int(start);
    vFace = gl_VertexID / 3;
    vWeights = vec3(equal(ivec3(0, 1, 2), ivec3(gl_VertexID % 3)));
    #endif
    vec4 p = modelViewMatrix * vec4(position, 1.);
    vPosition = p.xyz;
    gl_Position = projectionMatrix * p;
  }`;

// The homogeneous coordinates are linear on triangles, so their quotient is projective.
const fragmentShader = `
  uniform int mode;
  uniform vec3 base, missing, stops[5];
  uniform float squares, low, high, isolines, light;
  in vec3 vHomogeneous;
  in vec2 vLinear;
  in vec3 vPosition;
  in float vValue;

  // The mean over a pixel.
  float checker(vec2 p) {
    vec2 w = fwidth(p) + 1e-5;
    vec2 i = 2. * (abs(fract(.5 * (p - .5 * w)) - .5) - abs(fract(.5 * (p + .5 * w)) - .5)) / w;
    return .5 - .5 * i.x * i.y;
  }

  vec3 board(vec2 uv) {
    if(isnan(uv.x + uv.y))
      return missing;
    return mix(vec3(.96), vec3(.30, .47, .62), checker(uv * squares));
  }

  vec3 colorOf(float x) {
    float t = 4. * clamp((x - low) / (high - low), 0., 1.);
    int i = int(min(t, 3.));
    return mix(stops[i], stops[i + 1], t - float(i));
  }

  // Where a value changes this much over a pixel.
  float isoline(float x, float change) {
    float t = (x - low) / (high - low) * 20.;
    float w = change / (high - low) * 20.;
    return w > .5 ? 0. : 1. - smoothstep(.6 * w, 1.4 * w, abs(fract(t - .5) - .5));
  }

  vec3 colorWithLines(float x, float change) {
    return mix(colorOf(x), vec3(.1), .55 * isolines * isoline(x, change));
  }

  #ifdef DEVELOPED
  uniform vec3 palette[6], colorOfLines[2], colorOfMarks;
  uniform float widthOfLines[2], marks;
  uniform int picked;
  uniform bool isIntrinsic; // the value
  in vec2 vPlace;
  in vec3 vWeights;
  flat in int vStart, vFace;
  ${development}

  vec3 colorOfFace(int f) {
    return palette[((uint(f) + 1u) * 0x9e3779b1u >> 8) % 6u];
  }

  // How much of a pixel lines cover; less if the face is hardly larger.
  float line(vec3 distances, float width, float size) {
    float least = min(distances.x, min(distances.y, distances.z));
    return clamp(.5 * width + .5 - least, 0., 1.) * mix(.25, 1., smoothstep(4., 12., size)) *
      step(.01, width);
  }

  // In pixels.
  vec3 distancesToSides(vec2 p, vec2 dx, vec2 dy, vec2 corners[3]) {
    vec3 result;
    for(int k = 0; k < 3; ++k) {
      vec2 side = corners[(k + 1) % 3] - corners[k];
      result[k] = abs(turn(side, p - corners[k])) / length(vec2(turn(side, dx), turn(side, dy)));
    }
    return result;
  }

  // Faces of the input that are hardly larger than a pixel need no development if they have one color.
  vec3 developed(vec3 color, vec3 light) {
    vec2 dx = dFdx(vPlace), dy = dFdy(vPlace);
    vec3 wx = dFdx(vWeights), wy = dFdy(vWeights);
    vec3 heights = inversesqrt(wx * wx + wy * wy);
    float size = 1. / abs(wx.x * wy.y - wx.y * wy.x) /
      min(heights.x, min(heights.y, heights.z)); // of the longest edge
    vec3 distances = vec3(0.);
    if(mode >= 4 || marks > 0. || size > 4.) {
      vec2 corners[3];
      int h = locate(vStart, vPlace, corners), f = h / 3;
      if(mode == 3 && isIntrinsic) {
        float x = valueAt(vPlace, corners, h);
        color = colorWithLines(x, abs(valueAt(vPlace + dx, corners, h) - x) +
          abs(valueAt(vPlace + dy, corners, h) - x));
      }
      if(mode >= 4)
        color = colorOfFace(mode == 4 ? vFace : f);
      color = mix(color, colorOfMarks, marks * halfedgeAt(3 * f).w);
      color = mix(color, vec3(1., .82, .24), f == picked ? .7 : 0.);
      distances = distancesToSides(vPlace, dx, dy, corners);
    }
    color = mix(color * light, colorOfLines[0],
      line(abs(vWeights) * heights, widthOfLines[0], size));
    return mix(color, colorOfLines[1], line(distances, widthOfLines[1], size));
  }
  #endif

  vec3 surface() {
    if(mode == 1)
      return board(vHomogeneous.xy / vHomogeneous.z);
    if(mode == 2)
      return board(vLinear);
    if(mode == 3)
      return colorWithLines(vValue, fwidth(vValue));
    return base;
  }

  void main() {
    vec3 n = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    vec3 side = gl_FrontFacing ? vec3(1.) : vec3(.80, .84, .90);
    float lit = .54 + .42 * abs(n.z) + .10 * n.y;
    vec3 shade = mix(vec3(1.), side * lit, light);
    #ifdef DEVELOPED
    gl_FragColor = vec4(developed(surface(), shade), 1.);
    #else
    gl_FragColor = vec4(surface() * shade, 1.);
    #endif
  }`;

const vectorOf = color => new Vector3(...rgb(color));

const developedUniforms = () => ({
  halfedges: {value: null}, sources: {value: null}, isIntrinsic: {value: false},
  palette: {value: faces.map(vectorOf)}, picked: {value: -1},
  colorOfLines: {value: [layers.input, layers.intrinsic].map(vectorOf)},
  widthOfLines: {value: [0, 0]}, marks: {value: 0}, colorOfMarks: {value: vectorOf(failure)}});

export function surfaceMaterial(isLit) {
  return new ShaderMaterial({
    vertexShader, fragmentShader, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4,
    uniforms: {
      mode: {value: 0}, base: {value: vectorOf(plain)}, missing: {value: vectorOf(missing)},
      squares: {value: 8},
      stops: {value: Array.from({length: 5}, () => new Vector3())}, low: {value: 0},
      high: {value: 1}, isolines: {value: 0}, light: {value: isLit ? 1 : 0},
      ...developedUniforms()}});
}

// Compiles what develops faces only while something of it is seen: it takes time at each pixel.
export function updateDevelopment({surface: {developed}, pane, material}) {
  const {mode, marks, picked, widthOfLines, isIntrinsic} = material.uniforms;
  const isColored = mode.value >= modes.inputFaces || mode.value === modes.value && isIntrinsic.value;
  const isSeen = isColored || picked.value >= 0 || marks.value > 0 ||
    widthOfLines.value.some(width => width > 0);
  if(isSeen !== ('DEVELOPED' in material.defines)) {
    material.defines = isSeen ? {DEVELOPED: 1} : {};
    material.needsUpdate = true;
  }
  if(isSeen && !pane.geometry.hasAttribute('place')) {
    material.uniforms.halfedges.value = developed.texture;
    pane.geometry.setAttribute('place', new BufferAttribute(developed.places, 2));
    pane.geometry.setAttribute('start', new BufferAttribute(developed.starts, 1));
  }
}

// A copy that has a color of its own and everything else in common.
export function withBase(material, color) {
  const result = material.clone();
  result.uniforms = {...material.uniforms, base: {value: new Vector3(...rgb(color))}};
  return result;
}
