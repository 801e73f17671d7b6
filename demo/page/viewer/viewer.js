// The stage: surfaces beside their pictures, and what is shown on them.

import { BufferAttribute, Color, Mesh, MeshBasicMaterial, BufferGeometry, Vector3,
  WebGLRenderer } from 'three';
import * as colors from './colors.js';
import { lines } from './lines.js';
import { modes, surfaceMaterial, updateDevelopment, withBase } from './material.js';
import { Pane, pointCloud } from './pane.js';
import { locate } from './pick.js';
import { positionsOf } from './surface.js';

const captions = {plane: 'in the plane', disk: 'in the Poincaré disk', sphere: 'on the sphere'};
const mostShown = 60000; // more edges hide the surface
const mostSmooth = 200000; // triangles

function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  return names && /swiftshader|llvmpipe|softpipe|basic render/i
    .test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
}

// Without a graphics processor, multisampling more than doubles the time of a picture of many triangles.
export function makeRenderer(canvas, triangles) {
  const antialias = triangles <= mostSmooth || !drawsInSoftware();
  const renderer = new WebGLRenderer({canvas, antialias});
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setClearColor(new Color(colors.paper));
  renderer.setScissorTest(true);
  renderer.autoClear = false;
  return renderer;
}

export class Viewer {
  constructor(stage, renderer, surfaces) {
    this.stage = stage;
    this.surfaces = surfaces;
    this.renderer = renderer;
    this.views = [];
    this.views = surfaces.flatMap(surface => this.viewsOf(surface));
    this.state = this.initialState();
    new ResizeObserver(() => this.resize()).observe(stage);
    this.resize();
    this.update();
  }

  viewsOf(surface) {
    const result = [this.makeView(surface, surface.name, false)];
    if(surface.picture)
      result.push(this.makeView(surface, captions[surface.picture.kind], true));
    return result;
  }

  // A picture is of the triangles of its surface, at other positions.
  makeView(surface, caption, isPicture) {
    const isPlane = isPicture && surface.picture.kind !== 'sphere';
    const onChange = pane => this.follow(pane);
    const pane = new Pane(this.stage, caption, {isPlane, onChange});
    const positions = isPicture ? surface.picture.positions : surface.atCorners(surface.points, 3);
    const texture = isPicture && surface.picture.kind === 'plane'
      ? positions.map((x, i) => i % 3 === 2 ? 1 : x) : surface.texture;
    const {developed} = surface;
    surface.triangleIndex ??= developed ? null : new BufferAttribute(surface.triangles, 1);
    const material = surfaceMaterial(!isPlane);
    pane.setSurface(positions, texture ? {uvw: new BufferAttribute(texture, 3)} : {},
      surface.triangleIndex, material, developed ? surface.points : positions);
    return {surface, pane, material, isPicture};
  }

  // ---- What is shown ----

  get layers() { return this.allLayers ??= this.findLayers(); }

  findLayers() {
    const all = this.surfaces.flatMap(s => [
      ...(s.triangulations.length > 0 ? s.triangulations : ['edges']), ...s.markedEdges]);
    return [...new Set(all)].filter(layer => this.countParts(layer) > 0);
  }

  get fields() { return [...new Set(this.surfaces.flatMap(s => s.fields))]; }
  get triangulations() { return [...new Set(this.surfaces.flatMap(s => s.triangulations))]; }
  get markedPoints() {
    return [...new Set(this.surfaces.flatMap(s => s.markedPoints))];
  }
  get marks() { return this.surfaces.flatMap(s => s.marks); }
  get hasSphere() { return this.surfaces.some(s => s.picture?.kind === 'sphere'); }
  get isFlattened() { return this.surfaces.some(s => s.texture && s.picture); }
  get hasTexture() { return this.surfaces.some(s => s.texture); }

  countEdges(layer) {
    return this.surfaces.reduce((sum, s) => sum + s.countEdges(layer), 0);
  }

  countParts(layer) {
    return this.surfaces.reduce((sum, s) => sum + s.countParts(layer), 0);
  }

  initialState() {
    const shown = {};
    const isCalm = this.isFlattened || this.hasSphere || this.mainField !== undefined;
    for(const layer of this.layers)
      shown[layer] = this.countParts(layer) <= mostShown &&
        (layer === 'is_seam' || layer === 'coarse' || !isCalm && !this.layers.includes('coarse'));
    for(const name of [...this.markedPoints, ...this.marks.map(m => m.name)])
      shown[name] = true;
    return {color: this.initialColor(), shown, squares: 16, isolines: true};
  }

  // that the command has computed
  get mainField() {
    return ['distance', 'transferred_function'].find(name => this.fields.includes(name));
  }

  initialColor() {
    if(this.isFlattened)
      return 'projective';
    if(this.mainField !== undefined)
      return `field ${this.mainField}`;
    if(this.hasSphere)
      return 'field log_scale';
    return this.layers.includes('coarse') ? 'faces coarse' : 'plain';
  }

  set(changes) {
    Object.assign(this.state, {...changes, shown: {...this.state.shown, ...changes.shown}});
    this.update();
  }

  update() {
    for(const view of this.views) {
      this.updateColor(view);
      this.updateLayers(view);
      this.updateMarks(view);
      if(view.surface.developed)
        updateDevelopment(view);
    }
    this.invalidate();
  }

  updateColor(view) {
    const {surface, pane, material} = view;
    const [kind, name] = partsOf(this.state.color);
    material.uniforms.squares.value = this.state.squares / 2;
    material.uniforms.isolines.value = this.state.isolines ? 1 : 0;
    material.uniforms.mode.value = kind === 'field' && surface.pointData[name] ? modes.value
      : surface.texture && modes[kind] || modes.plain;
    pane.mesh.material = material;
    pane.geometry.setIndex(surface.triangleIndex);
    pane.geometry.clearGroups();
    if(kind === 'field')
      this.colorByField(view, name);
    if(kind === 'faces' && surface.developed)
      material.uniforms.mode.value = name === 'input' ? modes.inputFaces : modes.intrinsicFaces;
    else if(kind === 'faces')
      this.colorByFace(view, name);
  }

  scale(name) {
    const values = this.surfaces.filter(s => s.fields.includes(name))
      .map(s => s.field(name));
    this.scales ??= new Map();
    if(!this.scales.has(name))
      this.scales.set(name, colors.scaleOf(values.length === 1 ? values[0]
        : values.flatMap(v => Array.from(v))));
    return this.scales.get(name);
  }

  colorByField(view, name) {
    const {surface, pane, material} = view;
    if(!surface.fields.includes(name))
      return;
    if(!surface.pointData[name]) {
      const values = surface.field(name), scale = this.scale(name);
      this.colorByPolygon(view, name, i => colors.colorOf(values[i], scale));
      return;
    }
    surface.fieldAttributes ??= new Map();
    if(!surface.fieldAttributes.has(name))
      surface.fieldAttributes.set(name,
        new BufferAttribute(surface.atCorners(surface.pointData[name].values, 1), 1));
    pane.geometry.setAttribute('value', surface.fieldAttributes.get(name));
    const isIntrinsic = surface.developed?.hasFunction(name) ?? false;
    material.uniforms.isIntrinsic.value = isIntrinsic;
    material.uniforms.sources.value = isIntrinsic ? surface.developed.textureOfValues(name) : null;
    const {low, high, stops} = this.scale(name);
    material.uniforms.low.value = low;
    material.uniforms.high.value = high;
    stops.forEach((stop, i) => material.uniforms.stops.value[i].set(...colors.rgb(stop)));
  }

  colorByFace(view, triangulation) {
    const {polygonData} = view.surface;
    const owner = polygonData[`${triangulation}_face`]?.values;
    if(owner)
      this.colorByPolygon(view, triangulation, triangulation === 'coarse' && polygonData.red
        ? colorsGiven(view.surface) : colorsByOwner(owner));
  }

  // Triangles of one color follow each other.
  colorByPolygon({surface, pane, material}, name, colorOf) {
    surface.groups ??= {};
    const {index, groups, palette} = surface.groups[name] ??= groupsOf(surface, colorOf);
    pane.geometry.setIndex(index);
    for(const [i, {start, count}] of groups.entries())
      pane.geometry.addGroup(start, count, i);
    pane.mesh.material = palette.map(color => withBase(material, color));
  }

  updateLayers({surface, pane, isPicture, material}) {
    if(surface.developed) {
      material.uniforms.widthOfLines.value = ['input', 'intrinsic'].map(layer =>
        this.state.shown[layer] ? widthOf(layer, this.countParts(layer)) : 0);
      return;
    }
    for(const [i, layer] of this.layers.entries()) {
      const style = {color: colors.layers[layer] ?? colors.others, order: 10 + i,
        width: widthOf(layer, this.countParts(layer))};
      pane.show(layer, this.state.shown[layer], () => lines(
        isPicture ? surface.segmentsInPicture(layer) : surface.segments(layer), style));
    }
    if(isPicture && surface.picture.outlines)
      pane.show('outlines', true, () => lines(outlineSegments(surface.picture.outlines),
        {color: '#9aa7b3', width: 1, order: 5}));
  }

  updateMarks({surface, pane, isPicture, material}) {
    const positions = isPicture ? surface.picture.positions : surface.points;
    for(const name of surface.markedPoints)
      pane.show(name, this.state.shown[name], () => pointCloud(positionsOf(
        placesOf(surface, surface.pointData[name].values, isPicture), positions),
      colors.points[name] ?? colors.others, 10));
    for(const mark of surface.marks)
      this.showMark(mark, {surface, pane, isPicture});
    if(surface.developed)
      material.uniforms.marks.value = surface.marks.some(
        mark => mark.polygons.length > 0 && this.state.shown[mark.name]) ? 1 : 0;
  }

  showMark(mark, {surface, pane, isPicture}) {
    const color = mark.is_failure ? colors.failure : colors.others;
    const isShown = this.state.shown[mark.name];
    const positions = isPicture ? surface.picture.positions : surface.points;
    if(mark.polygons.length > 0 && !surface.developed)
      pane.show(`${mark.name} faces`, isShown, () => overlay(surface, pane, mark.polygons, color));
    if(mark.lines.corners.length > 0 && !isPicture)
      for(const isBehind of mark.is_failure ? [false] : [true, false])
        pane.show(`${mark.name} lines${isBehind ? ' behind' : ''}`, isShown, () => lines(
          positionsOf(segmentsOf(mark.lines), positions),
          {color, width: 3.5, order: isBehind ? 39 : 40, isBehind}));
    if(mark.points.length > 0 && !isPicture)
      pane.show(`${mark.name} points`, isShown, () =>
        pointCloud(positionsOf(mark.points, positions), color, 11));
  }

  // ---- Points that are picked ----

  // At a position on the stage, in pixels; nothing if no surface is there.
  pick(x, y) {
    const view = this.views.find(({pane: {box}}) => x >= box.left && x < box.left + box.width &&
      y >= box.top && y < box.top + box.height);
    const hit = view?.pane.pick(x - view.pane.box.left, y - view.pane.box.top);
    if(!hit)
      return null;
    const place = locate(view, hit);
    for(const v of this.views)
      this.showPlace(v, v.surface === view.surface ? place : null);
    this.invalidate();
    return place.description;
  }

  showPlace({surface, pane, isPicture, material}, place) {
    if(surface.developed) {
      material.uniforms.picked.value = place?.description.faces.intrinsic ?? -1;
      updateDevelopment({surface, pane, material});
    }
    for(const name of [...pane.layers.keys()].filter(n => n.startsWith('picked')))
      pane.remove(name);
    if(!place)
      return;
    const at = isPicture ? place.inPicture : place.onSurface;
    pane.show('picked', true, () => pointCloud(new Float32Array(at), '#101010', 12));
    pane.show('picked dot', true, () => pointCloud(new Float32Array(at), '#ffd23e', 8));
    pane.layers.get('picked dot').renderOrder = 51;
    for(const [i, [triangulation, id]] of Object.entries(place.description.faces).entries())
      this.outlineFace({surface, pane, isPicture}, triangulation, id, i);
  }

  outlineFace({surface, pane, isPicture}, triangulation, id, i) {
    const corners = surface.outline(triangulation, id);
    const positions = isPicture ? positionsOf(corners, surface.picture.positions)
      : positionsOf(corners.map(c => surface.point(c)), surface.points);
    pane.show(`picked ${triangulation}`, corners.length > 0, () => lines(positions,
      {color: colors.layers[triangulation] ?? colors.others, width: 4, order: 30 + i}));
  }

  // ---- Drawing ----

  resize() {
    const {clientWidth: width, clientHeight: height} = this.stage;
    if(this.size?.join() === [width, height].join())
      return;
    this.size = [width, height];
    this.renderer.setSize(width, height, false);
    const n = this.views.length;
    const columns = n < 4 ? (width > height ? n : 1) : Math.ceil(Math.sqrt(n));
    const rows = Math.ceil(n / columns);
    this.views.forEach(({pane}, i) => pane.place(i % columns * width / columns,
      Math.floor(i / columns) * height / rows, width / columns, height / rows));
    this.invalidate();
  }

  // Surfaces that are compared are seen from one side.
  follow(pane) {
    const leader = this.views.find(v => v.pane === pane);
    for(const {pane: other, isPicture} of this.views)
      if(leader && !leader.isPicture && !isPicture && other !== pane) {
        other.camera.position.copy(pane.camera.position);
        other.camera.quaternion.copy(pane.camera.quaternion);
        other.camera.up.copy(pane.camera.up);
        other.controls.target.copy(pane.controls.target);
      }
    this.invalidate();
  }

  resetCameras() {
    this.views.forEach(({pane}) => pane.resetCamera());
    this.invalidate();
  }

  invalidate() { this.isDirty = true; }

  frame() {
    this.views.forEach(({pane}) => pane.controls.update());
    if(this.isDirty)
      this.draw();
    this.isDirty = false;
  }

  draw() {
    const {clientHeight} = this.stage;
    for(const {pane: {box, scene, camera}} of this.views) {
      const view = [box.left, clientHeight - box.top - box.height, box.width, box.height];
      this.renderer.setViewport(...view);
      this.renderer.setScissor(...view);
      this.renderer.clear();
      this.renderer.render(scene, camera);
    }
  }

  // The color at a position on the stage, in pixels.
  pixel(x, y) {
    this.draw();
    const gl = this.renderer.getContext();
    const ratio = this.renderer.getPixelRatio();
    const result = new Uint8Array(4);
    gl.readPixels(Math.round(x * ratio), gl.drawingBufferHeight - 1 - Math.round(y * ratio), 1, 1,
      gl.RGBA, gl.UNSIGNED_BYTE, result);
    return Array.from(result.slice(0, 3));
  }

  // Where a point of a surface is on the stage.
  project(point, surface = 0) {
    const {pane, surface: {description}} =
      this.views.find(v => v.surface === this.surfaces[surface] && !v.isPicture);
    const p = new Vector3(...point.map((x, k) =>
      (x - description.center[k]) / description.radius));
    const [x, y] = pane.project(p);
    return [x + pane.box.left, y + pane.box.top];
  }
}

// What colors surfaces and, after a blank, its name.
export function partsOf(color) {
  const [kind] = color.split(' ', 1);
  return [kind, color.slice(kind.length + 1)];
}

function widthOf(layer, parts) {
  if(layer === 'is_seam')
    return 3;
  const isThin = layer === 'input' || layer === 'edges';
  return (isThin ? 1.2 : 1.8) * (parts > 8000 ? .7 : 1);
}

const colorsByOwner = owner => i => colors.faces[colors.colorOfFace(owner[i])];

function colorsGiven(surface) {
  const [r, g, b] = ['red', 'green', 'blue'].map(name => surface.polygonData[name].values);
  return i => `#${[r[i], g[i], b[i]].map(x => x.toString(16).padStart(2, '0')).join('')}`;
}

function groupsOf(surface, colorOf) {
  const byColor = new Map();
  surface.polygonOfTriangle.forEach((polygon, t) => {
    const color = colorOf(polygon);
    if(!byColor.has(color))
      byColor.set(color, []);
    byColor.get(color).push(t);
  });
  const index = new Uint32Array(surface.triangles.length);
  const groups = [];
  let at = 0;
  for(const triangles of byColor.values()) {
    groups.push({start: at, count: 3 * triangles.length});
    for(const t of triangles)
      for(let k = 0; k < 3; ++k)
        index[at++] = surface.triangles[3 * t + k];
  }
  return {index: new BufferAttribute(index, 1), groups, palette: [...byColor.keys()]};
}

// Of marked points, those or their corners.
function placesOf(surface, values, isPicture) {
  const result = [];
  const n = isPicture ? surface.numberOfCorners : surface.numberOfPoints;
  for(let i = 0; i < n; ++i)
    if(values[isPicture ? surface.point(i) : i] === 1)
      result.push(i);
  return result;
}

function segmentsOf({begin, corners}) {
  const result = [];
  for(let i = 0; i + 1 < begin.length; ++i)
    for(let k = begin[i] + 1; k < begin[i + 1]; ++k)
      result.push(corners[k - 1], corners[k]);
  return result;
}

function outlineSegments({begin, points}) {
  const flat = segmentsOf({begin, corners: Array.from({length: points.length / 2}, (_, i) => i)});
  return new Float32Array(flat.flatMap(i => [points[2 * i], points[2 * i + 1], 0]));
}

// Polygons once more, in one color, before the others.
function overlay(surface, pane, polygons, color) {
  const wanted = new Set(polygons);
  const triangles = [];
  surface.polygonOfTriangle.forEach((polygon, t) => {
    if(wanted.has(polygon))
      triangles.push(...surface.triangles.subarray(3 * t, 3 * t + 3));
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', pane.geometry.getAttribute('position'));
  geometry.setIndex(triangles);
  const result = new Mesh(geometry, new MeshBasicMaterial({color, side: 2}));
  result.renderOrder = 8;
  result.frustumCulled = false;
  return result;
}
