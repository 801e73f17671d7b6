// The shader of surfaces: one color, a checkerboard, or the color of a value.

import { DoubleSide, ShaderMaterial, Vector3 } from 'three';
import { plain, rgb } from './colors.js';

export const modes = {plain: 0, projective: 1, linear: 2, value: 3};

const vertexShader = `
  in vec3 uvw;
  in float value;
  out vec3 vHomogeneous;
  out vec2 vLinear;
  out vec3 vPosition;
  out float vValue;
  void main() {
    vHomogeneous = uvw;
    vLinear = uvw.xy / uvw.z;
    vValue = value;
    vec4 p = modelViewMatrix * vec4(position, 1.);
    vPosition = p.xyz;
    gl_Position = projectionMatrix * p;
  }`;

// The homogeneous coordinates are linear on triangles, so their quotient is projective.
const fragmentShader = `
  uniform int mode;
  uniform vec3 base, stops[5];
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
    return mix(vec3(.96), vec3(.30, .47, .62), checker(uv * squares));
  }

  vec3 colorOf(float x) {
    float t = 4. * clamp((x - low) / (high - low), 0., 1.);
    int i = int(min(t, 3.));
    return mix(stops[i], stops[i + 1], t - float(i));
  }

  float isoline(float x) {
    float t = (x - low) / (high - low) * 20.;
    float w = fwidth(t);
    return w > .5 ? 0. : 1. - smoothstep(.6 * w, 1.4 * w, abs(fract(t - .5) - .5));
  }

  vec3 surface() {
    if(mode == 1)
      return board(vHomogeneous.xy / vHomogeneous.z);
    if(mode == 2)
      return board(vLinear);
    if(mode == 3)
      return mix(colorOf(vValue), vec3(.1), .55 * isolines * isoline(vValue));
    return base;
  }

  void main() {
    vec3 n = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    vec3 side = gl_FrontFacing ? vec3(1.) : vec3(.80, .84, .90);
    float lit = .54 + .42 * abs(n.z) + .10 * n.y;
    gl_FragColor = vec4(surface() * mix(vec3(1.), side * lit, light), 1.);
  }`;

export function surfaceMaterial(isLit) {
  return new ShaderMaterial({
    vertexShader, fragmentShader, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 4,
    uniforms: {
      mode: {value: 0}, base: {value: new Vector3(...rgb(plain))}, squares: {value: 8},
      stops: {value: Array.from({length: 5}, () => new Vector3())}, low: {value: 0},
      high: {value: 1}, isolines: {value: 0}, light: {value: isLit ? 1 : 0}}});
}

// A copy that has a color of its own and everything else in common.
export function withBase(material, color) {
  const result = material.clone();
  result.uniforms = {...material.uniforms, base: {value: new Vector3(...rgb(color))}};
  return result;
}
