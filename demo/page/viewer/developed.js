// An intrinsic triangulation that is drawn without its common subdivision with the input: each pixel
// develops the intrinsic faces between a corner of its face of the input and itself into the plane.
// Halfedges 3 f, 3 f + 1 and 3 f + 2 are those of face f. See Developed_faces.h.

import { DataTexture, FloatType, NearestFilter, RedFormat, RGBAFormat } from 'three';

const width = 4096; // of the texture, a power of two
const mostSteps = 4096;

export const glsl = `
  uniform highp sampler2D halfedges, sources;

  ivec2 texel(int h) { return ivec2(h % ${width}, h / ${width}); }
  vec4 halfedgeAt(int h) { return texelFetch(halfedges, texel(h), 0); }
  float sourceAt(int h) { return texelFetch(sources, texel(h), 0).x; }
  int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  float turn(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
  vec2 apex(vec2 a, vec2 b, vec4 halfedge) {
    vec2 d = b - a;
    return a + halfedge.y * d + halfedge.z * vec2(-d.y, d.x);
  }

  // The corners, in counterclockwise order, and a halfedge of the intrinsic face in which p is; h goes
  // from 0 to 1. Faces follow each other on the segment from 0 to p.
  int locate(int h, vec2 p, out vec2 corners[3]) {
    vec2 o = vec2(0.), b = vec2(1., 0.), c = apex(o, b, halfedgeAt(h));
    int steps = 0;
    for(; steps < ${mostSteps} && turn(c, p) > 0.; ++steps) {
      int g = int(halfedgeAt(prev(h)).x);
      if(g < 0)
        break;
      h = g;
      b = c;
      c = apex(o, b, halfedgeAt(h));
    }
    h = next(h);
    for(; steps < ${mostSteps} && turn(c - b, p - b) < 0.; ++steps) {
      int g = int(halfedgeAt(h).x);
      if(g < 0)
        break;
      vec2 d = apex(c, b, halfedgeAt(g));
      bool isLeft = turn(d, p) > 0.;
      h = isLeft ? prev(g) : next(g);
      o = isLeft ? b : c;
      if(isLeft)
        b = d;
      else
        c = d;
    }
    corners = vec2[3](o, b, c);
    return h;
  }

  // The function on the face with these corners whose second side is h.
  float valueAt(vec2 p, vec2 corners[3], int h) {
    vec2 b = corners[1] - corners[0], c = corners[2] - corners[0], d = p - corners[0];
    float value = sourceAt(prev(h));
    return value + (turn(d, c) * (sourceAt(h) - value) + turn(b, d) * (sourceAt(next(h)) - value)) /
      turn(b, c);
  }`;

// From each halfedge to the other of its edge.
function oppositesOf(greater, size) {
  const result = new Int32Array(size).fill(-2);
  let i = 0;
  for(let h = 0; h < size; ++h)
    if(result[h] === -2) {
      result[h] = greater[i++];
      if(result[h] >= 0)
        result[result[h]] = h;
    }
  return result;
}

// What the third corner of a face becomes if its next halfedge goes from 0 to 1.
function rotated([x, y]) {
  const norm = (x - 1) * (x - 1) + y * y;
  return [(1 - x) / norm, y / norm];
}

export class Developed {
  constructor(description, arrays, points, corners) {
    Object.assign(this, {description, arrays, points, corners, edges: description.edges, marked: [],
      functions: {}, valueTextures: {}});
  }

  // What is read and computed when it is needed.
  get opposites() {
    const {opposites, shapes} = this.description;
    return this.opposite ??= oppositesOf(this.arrays.read(opposites), shapes.size / 2 * 3);
  }
  get data() { return this.halfedges ??= this.halfedgeData(); }
  get texture() { return this.dataTexture ??= textureOf(this.data, RGBAFormat); }
  get places() { return this.developments.places; }
  get starts() { return this.developments.starts; }
  get developments() { return this.faces ??= this.developFaces(); }

  halfedgeData() {
    const {opposites} = this, shapes = this.arrays.read(this.description.shapes);
    const height = Math.ceil(opposites.length / width);
    const data = new Float32Array(4 * width * height);
    for(let h = 0; h < opposites.length; h += 3) {
      let z = [shapes[h / 3 * 2], shapes[h / 3 * 2 + 1]];
      for(let k = h; k < h + 3; ++k, z = rotated(z)) {
        data[4 * k] = opposites[k];
        data[4 * k + 1] = z[0];
        data[4 * k + 2] = z[1];
      }
    }
    for(const faces of this.marked)
      for(const f of faces)
        for(let k = 3 * f; k < 3 * f + 3; ++k)
          data[4 * k + 3] = 1;
    return data;
  }

  // For each corner of the input its place in the development of its face, which starts at the first
  // corner, and the halfedge of that start.
  developFaces() {
    const {points, corners} = this;
    const given = this.arrays.read(this.description.starts);
    const firstEdges = this.arrays.read(this.description.first_edges);
    const places = new Float32Array(2 * corners.length), starts = new Float32Array(corners.length);
    for(let f = 0, i = 0; f < given.length; ++f) {
      const isAlong = given[f] % 2 === 0;
      const x = isAlong ? 1 : firstEdges[i++], y = isAlong ? 0 : firstEdges[i++];
      const [u, v] = shapeOf(points, 3 * corners[3 * f], 3 * corners[3 * f + 1], 3 * corners[3 * f + 2]);
      places[6 * f + 2] = x;
      places[6 * f + 3] = y;
      places[6 * f + 4] = u * x - v * y;
      places[6 * f + 5] = u * y + v * x;
      starts.fill(given[f] >> 1, 3 * f, 3 * f + 3);
    }
    return {places, starts};
  }

  mark(faces) { this.marked.push(faces); }

  // A function on the intrinsic triangulation: its values at the sources of halfedges.
  hasFunction(name) { return name in this.description.values; }
  valuesOf(name) { return this.functions[name] ??= this.arrays.read(this.description.values[name]); }
  textureOfValues(name) {
    return this.valueTextures[name] ??= textureOf(padded(this.valuesOf(name)), RedFormat);
  }

  // At a point of a face of the input, by the weights of its corners.
  faceAt(face, weights) { return Math.floor(this.locate(face, weights).halfedge / 3); }
  valueAt(name, face, weights) {
    const {point, corners: [o, p, q], halfedge: h} = this.locate(face, weights);
    const [b, c, d] = [p, q, point].map(x => minus(x, o)), values = this.valuesOf(name);
    const [value, atB, atC] = [prev(h), h, next(h)].map(k => values[k]);
    return value + (turn(d, c) * (atB - value) + turn(b, d) * (atC - value)) / turn(b, c);
  }

  // The corners of the intrinsic face there, and its second side.
  locate(face, weights) {
    const at = k => weights.reduce((sum, w, i) => sum + w * this.places[6 * face + 2 * i + k], 0);
    const p = [at(0), at(1)];
    let h = this.starts[3 * face], o = [0, 0], b = [1, 0], c = this.apex(o, b, h), steps = 0;
    for(; steps < mostSteps && turn(c, p) > 0 && this.opposites[prev(h)] >= 0; ++steps) {
      h = this.opposites[prev(h)];
      [b, c] = [c, this.apex(o, c, h)];
    }
    h = next(h);
    for(; steps < mostSteps && turn(minus(c, b), minus(p, b)) < 0 && this.opposites[h] >= 0;
        ++steps) {
      const g = this.opposites[h];
      const d = this.apex(c, b, g);
      const isLeft = turn(d, p) > 0;
      h = isLeft ? prev(g) : next(g);
      [o, b, c] = isLeft ? [b, d, c] : [c, b, d];
    }
    return {point: p, corners: [o, b, c], halfedge: h};
  }

  apex(a, b, h) {
    const [x, y] = minus(b, a), u = this.data[4 * h + 1], v = this.data[4 * h + 2];
    return [a[0] + u * x - v * y, a[1] + u * y + v * x];
  }
}

function padded(values) {
  const result = new Float32Array(Math.ceil(values.length / width) * width);
  result.set(values);
  return result;
}

function textureOf(data, format) {
  const size = format === RGBAFormat ? 4 : 1;
  const result = new DataTexture(data, width, data.length / size / width, format, FloatType);
  result.minFilter = result.magFilter = NearestFilter;
  result.needsUpdate = true;
  return result;
}

const next = h => h % 3 === 2 ? h - 2 : h + 1;
const prev = h => h % 3 === 0 ? h + 2 : h - 1;
const turn = (a, b) => a[0] * b[1] - a[1] * b[0];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];

// The third corner of a triangle with points at a, b and c if its first edge goes from 0 to 1. There are
// many: no arrays are made on the way.
function shapeOf(points, a, b, c) {
  const [ex, ey, ez] = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
  const [dx, dy, dz] = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
  const norm = ex * ex + ey * ey + ez * ez;
  const x = ey * dz - ez * dy, y = ez * dx - ex * dz, z = ex * dy - ey * dx;
  return [(ex * dx + ey * dy + ez * dz) / norm, Math.sqrt(x * x + y * y + z * z) / norm];
}
