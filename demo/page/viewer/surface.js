// A surface as the page has it: points, polygons and the triangles they are cut into, edges, and
// what is known about each of them.

import { Developed } from './developed.js';

// Of polygons: where the corners of each begin. They have one size, or each its own.
function beginnings(sizes, corners) {
  const result = new Uint32Array((sizes.length ?? corners / sizes) + 1);
  for(let i = 1; i < result.length; ++i)
    result[i] = result[i - 1] + (sizes.length === undefined ? sizes : sizes[i - 1]);
  return result;
}

export function readPolygons(arrays, {sizes, corners}) {
  const read = arrays.read(corners);
  const each = typeof sizes === 'number' ? sizes : arrays.read(sizes);
  return {begin: beginnings(each, read.length), corners: read, areTriangles: each === 3};
}

// Numbers of elements, which are read when they are needed.
class Data {
  constructor(arrays, description) {
    Object.assign(this, {arrays, description});
  }

  get isReal() { return this.description.code !== 'differences'; }
  get values() { return this.numbers ??= this.arrays.read(this.description); }
  // Of elements that are parts of an owner, or marked, and of owners.
  get parts() { return this.description.parts ?? 0; }
  get owners() { return this.description.owners ?? 0; }
}

const withData = (arrays, descriptions) =>
  Object.fromEntries(Object.entries(descriptions).map(([name, d]) => [name, new Data(arrays, d)]));

const namesOfReals = data => Object.keys(data).filter(name => data[name].isReal);

// "input_edge" and the like are attributes of elements of a triangulation "input".
const ownersOf = (data, suffix) =>
  Object.keys(data)
    .filter(name => name.endsWith(suffix)).map(name => name.slice(0, -suffix.length));

export class Surface {
  constructor(description, arrays) {
    this.description = description;
    this.name = description.name;
    this.points = arrays.read(description.points);
    this.arrays = arrays;
    this.pointData = withData(arrays, description.point_data);
    this.edgeData = withData(arrays, description.edge_data);
    this.polygonData = withData(arrays, description.polygon_data);
    this.polygons = readPolygons(arrays, description.polygons);
    this.readTexture(description, arrays);
    if(description.developed)
      this.develop(description.developed, arrays);
    this.cut();
    this.marks = description.marks.map(mark => ({...mark,
      polygons: arrays.read(mark.polygons), points: arrays.read(mark.points),
      lines: readPolygons(arrays, mark.lines)}));
    if(this.developed)
      this.marks.forEach(mark => this.developed.mark(mark.polygons));
  }

  // Corners are texture coordinates if there are some, otherwise points.
  readTexture(description, arrays) {
    if(description.texture) {
      this.pointOfCorner = arrays.read(description.point_of_corner);
      this.texture = arrays.read(description.texture);
    }
    if(description.picture)
      this.picture = {...description.picture,
        positions: arrays.read(description.picture.positions)};
    const outlines = description.picture?.outlines;
    if(outlines)
      this.picture.outlines = {begin: beginnings(arrays.read(outlines.sizes)),
        points: arrays.read(outlines.points)};
  }

  // Each face has corners of its own.
  develop(description, arrays) {
    const {corners} = this.polygons;
    if(this.texture)
      this.texture = positionsOf(corners, this.texture);
    this.pointOfCorner = this.pointOfCorner ? corners.map(c => this.pointOfCorner[c]) : corners;
    this.polygons.corners = indices(new Int32Array(corners.length));
    this.developed = new Developed(description, arrays, this.points, this.pointOfCorner);
  }

  // Into fans.
  cut() {
    const {begin, corners, areTriangles} = this.polygons;
    if(areTriangles) {
      this.triangles = new Uint32Array(corners.buffer);
      return;
    }
    const n = begin.length - 1;
    let size = 0;
    for(let i = 0; i < n; ++i)
      size += Math.max(begin[i + 1] - begin[i] - 2, 0);
    this.triangles = new Uint32Array(3 * size);
    this.parents = new Uint32Array(size);
    let t = 0;
    for(let i = 0; i < n; ++i)
      for(let k = begin[i] + 2; k < begin[i + 1]; ++k, ++t) {
        this.triangles[3 * t] = corners[begin[i]];
        this.triangles[3 * t + 1] = corners[k - 1];
        this.triangles[3 * t + 2] = corners[k];
        this.parents[t] = i;
      }
  }

  get polygonOfTriangle() {
    return this.parents ??= indices(new Uint32Array(this.triangles.length / 3));
  }

  // The ends of edges: those that are sides of polygons if nothing is known about them.
  get edges() {
    const {edges} = this.description;
    return this.ends ??= edges.code ? this.arrays.read(edges) : this.sides();
  }

  sides() {
    const n = this.numberOfPoints, keys = new Float64Array(this.polygons.corners.length);
    let i = 0;
    this.forEachSide((c, d) => {
      const p = this.point(c), q = this.point(d);
      keys[i++] = Math.min(p, q) * n + Math.max(p, q);
    });
    keys.sort();
    const result = new Int32Array(this.description.edges.size);
    i = 0;
    keys.forEach((key, k) => {
      if(key === keys[k - 1])
        return;
      result[i++] = Math.floor(key / n);
      result[i++] = key % n;
    });
    return result;
  }

  point(corner) { return this.pointOfCorner ? this.pointOfCorner[corner] : corner; }
  get numberOfPoints() { return this.points.length / 3; }
  get numberOfCorners() {
    return this.pointOfCorner ? this.pointOfCorner.length : this.numberOfPoints;
  }

  // One value, or several, of each corner, from those of points.
  atCorners(values, components) {
    if(!this.pointOfCorner)
      return values;
    const result = new Float32Array(this.pointOfCorner.length * components);
    for(let c = 0; c < this.pointOfCorner.length; ++c)
      for(let k = 0; k < components; ++k)
        result[components * c + k] = values[components * this.pointOfCorner[c] + k];
    return result;
  }

  get triangulations() {
    if(this.developed)
      return ['input', 'intrinsic'];
    const withEdges = ownersOf(this.edgeData, '_edge');
    return [...new Set([...withEdges, ...ownersOf(this.polygonData, '_face')])];
  }

  // The real attributes of points or polygons, and those of points and edges that begin with "is_".
  get fields() {
    return [...namesOfReals(this.pointData), ...namesOfReals(this.polygonData)];
  }
  field(name) { return (this.pointData[name] ?? this.polygonData[name]).values; }
  get markedPoints() {
    return Object.keys(this.pointData).filter(name => this.pointData[name].parts > 0);
  }
  get markedEdges() { return Object.keys(this.edgeData).filter(name => name.startsWith('is_')); }

  // Whether each edge is one of a layer: the edges of a triangulation, or those marked.
  isInLayer(layer) {
    const marked = this.edgeData[layer];
    if(marked)
      return e => marked.values[e] === 1;
    const owner = this.edgeData[`${layer}_edge`];
    return owner ? e => owner.values[e] >= 0 : () => true;
  }

  // Edges of a triangulation are cut into parts by others.
  countEdges(layer) {
    if(this.developed)
      return this.developed.edges[layer] ?? 0;
    const data = this.edgeData[layer] ?? this.edgeData[`${layer}_edge`];
    return data ? data.owners : this.description.edges.size / 2;
  }

  countParts(layer) {
    const data = this.edgeData[layer] ?? this.edgeData[`${layer}_edge`];
    return data ? data.parts : this.countEdges(layer);
  }

  // Positions of both ends of the edges of a layer.
  segments(layer) {
    const isIn = this.isInLayer(layer);
    const result = [];
    for(let e = 0; 2 * e < this.edges.length; ++e)
      if(isIn(e))
        result.push(this.edges[2 * e], this.edges[2 * e + 1]);
    return positionsOf(result, this.points);
  }

  // The same in the picture, where an edge has an image at each polygon.
  segmentsInPicture(layer) {
    if(!this.pointOfCorner)
      return positionsOf(this.endsOf(layer), this.picture.positions);
    const isIn = this.isInLayer(layer);
    const result = [];
    this.forEachSide((c, d) => {
      const e = this.edgeBetween(this.point(c), this.point(d));
      if(e !== undefined && isIn(e))
        result.push(c, d);
    });
    return positionsOf(result, this.picture.positions);
  }

  endsOf(layer) {
    const isIn = this.isInLayer(layer);
    return Array.from(this.edges).filter((_, i) => isIn(i >> 1));
  }

  forEachSide(visit) {
    const {begin, corners} = this.polygons;
    for(let i = 0; i + 1 < begin.length; ++i)
      for(let k = begin[i]; k < begin[i + 1]; ++k)
        visit(corners[k], corners[k + 1 < begin[i + 1] ? k + 1 : begin[i]], i);
  }

  edgeBetween(p, q) {
    const key = (a, b) => Math.min(a, b) * this.numberOfPoints + Math.max(a, b);
    if(!this.edgeOfEnds) {
      this.edgeOfEnds = new Map();
      for(let e = 0; 2 * e < this.edges.length; ++e)
        this.edgeOfEnds.set(key(this.edges[2 * e], this.edges[2 * e + 1]), e);
    }
    return this.edgeOfEnds.get(key(p, q));
  }

  // Corners at the ends of the sides of the face `id` of a triangulation.
  outline(triangulation, id) {
    if(this.developed)
      return triangulation === 'input' ? [0, 1, 1, 2, 2, 0].map(k => 3 * id + k) : [];
    const owner = this.polygonData[`${triangulation}_face`].values;
    const sides = new Map();
    this.forEachSide((c, d, polygon) => {
      if(owner[polygon] !== id)
        return;
      if(!sides.delete(`${this.point(d)} ${this.point(c)}`))
        sides.set(`${this.point(c)} ${this.point(d)}`, [c, d]);
    });
    return [...sides.values()].flat();
  }
}

function indices(result) {
  for(let i = 0; i < result.length; ++i)
    result[i] = i;
  return result;
}

export function positionsOf(indices, points) {
  const result = new Float32Array(3 * indices.length);
  for(let i = 0; i < indices.length; ++i)
    for(let k = 0; k < 3; ++k)
      result[3 * i + k] = points[3 * indices[i] + k];
  return result;
}
