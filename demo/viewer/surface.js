// A surface as the page has it: points, polygons and the triangles they are cut into, edges, and
// what is known about each of them.

import { Developed } from './developed.js';

// Of polygons: where the corners of each begin.
function beginnings(sizes) {
  const result = new Uint32Array(sizes.length + 1);
  for(let i = 0; i < sizes.length; ++i)
    result[i + 1] = result[i] + sizes[i];
  return result;
}

export function readPolygons(arrays, {sizes, corners}) {
  return {begin: beginnings(arrays.read(sizes)), corners: arrays.read(corners)};
}

const withData = (arrays, descriptions) =>
  Object.fromEntries(Object.entries(descriptions).map(([name, d]) =>
    [name, {isReal: d.code !== 'differences', values: arrays.read(d)}]));

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
    this.edges = arrays.read(description.edges);
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
    this.pointOfCorner = corners;
    this.polygons.corners = new Int32Array(corners.length).map((_, i) => i);
    this.developed = new Developed(description, arrays, this.points, corners);
  }

  // Into fans.
  cut() {
    const {begin, corners} = this.polygons;
    const n = begin.length - 1;
    let size = 0;
    for(let i = 0; i < n; ++i)
      size += Math.max(begin[i + 1] - begin[i] - 2, 0);
    this.triangles = new Uint32Array(3 * size);
    this.polygonOfTriangle = new Uint32Array(size);
    let t = 0;
    for(let i = 0; i < n; ++i)
      for(let k = begin[i] + 2; k < begin[i + 1]; ++k, ++t) {
        this.triangles[3 * t] = corners[begin[i]];
        this.triangles[3 * t + 1] = corners[k - 1];
        this.triangles[3 * t + 2] = corners[k];
        this.polygonOfTriangle[t] = i;
      }
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
    this.pointOfCorner.forEach((p, c) => {
      for(let k = 0; k < components; ++k)
        result[components * c + k] = values[components * p + k];
    });
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
    return Object.keys(this.pointData).filter(name => name.startsWith('is_'));
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
    const owner = this.edgeData[`${layer}_edge`];
    return owner ? countDistinct(owner.values) : this.countParts(layer);
  }

  countParts(layer) {
    if(this.developed)
      return this.countEdges(layer);
    this.parts ??= new Map();
    if(!this.parts.has(layer)) {
      const isIn = this.isInLayer(layer);
      let result = 0;
      for(let e = 0; 2 * e < this.edges.length; ++e)
        result += isIn(e);
      this.parts.set(layer, result);
    }
    return this.parts.get(layer);
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

// Negative numbers do not count.
function countDistinct(values) {
  const isSeen = new Uint8Array(values.reduce((a, b) => Math.max(a, b), -1) + 1);
  let result = 0;
  for(const x of values)
    if(x >= 0 && isSeen[x] === 0) {
      isSeen[x] = 1;
      ++result;
    }
  return result;
}

export function positionsOf(indices, points) {
  const result = new Float32Array(3 * indices.length);
  for(let i = 0; i < indices.length; ++i)
    for(let k = 0; k < 3; ++k)
      result[3 * i + k] = points[3 * indices[i] + k];
  return result;
}
