// A part of the stage with its own camera: a surface, or its picture.

import { BufferAttribute, BufferGeometry, Group, Mesh, MeshBasicMaterial, OrthographicCamera,
  PerspectiveCamera, Points, PointsMaterial, Raycaster, Scene, Sphere, Vector2, Vector3,
  CanvasTexture } from 'three';
import { TrackballControls } from './TrackballControls.js';

// Returns the direction from which the broadest side of a box is seen, and the direction up. Most
// meshes have y up; z is up if the box is clearly longer along z.
function outlook({low, high}) {
  const size = high.map((x, k) => Math.max(x - low[k], 0));
  const axis = size[2] <= size[0] && size[2] <= size[1] ? 2 : size.indexOf(Math.min(...size));
  const isFlat = size[axis] < 1e-6;
  const up = axis === 1 ? [0, 0, 1] : axis === 0 && size[2] > 1.1 * size[1] ? [0, 0, 1] : [0, 1, 0];
  const oblique = isFlat ? 0 : 1;
  const way = new Vector3().setComponent(axis, axis === 1 ? -1 : 1)
    .addScaledVector(new Vector3(...up), .22 * oblique)
    .addScaledVector(new Vector3().setComponent(axis === 0 ? 1 : 0, 1), .32 * oblique);
  return {way: way.normalize(), up: new Vector3(...up)};
}

let discTexture;
function disc() {
  if(!discTexture) {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 64;
    const pen = canvas.getContext('2d');
    pen.fillStyle = '#fff';
    pen.beginPath();
    pen.arc(32, 32, 30, 0, 2 * Math.PI);
    pen.fill();
    discTexture = new CanvasTexture(canvas);
  }
  return discTexture;
}

export class Pane {
  constructor(stage, caption, {isPlane, onChange}) {
    this.isPlane = isPlane;
    this.element = document.createElement('div');
    this.element.className = 'pane';
    this.element.tabIndex = 0;
    const text = document.createElement('div');
    text.className = 'caption';
    text.textContent = caption;
    this.element.append(text);
    stage.append(this.element);
    this.scene = new Scene();
    this.camera = isPlane ? new OrthographicCamera(-1, 1, 1, -1, -10, 10)
      : new PerspectiveCamera(28, 1, .01, 100);
    this.makeControls(onChange);
    this.layers = new Map();
    this.dots = new Group();
    this.scene.add(this.dots);
  }

  makeControls(onChange) {
    this.controls = new TrackballControls(this.camera, this.element);
    Object.assign(this.controls,
      {staticMoving: true, noRotate: this.isPlane, rotateSpeed: 3, zoomSpeed: 1.5, panSpeed: .6});
    if(this.isPlane)
      this.controls.mouseButtons = {LEFT: 2, MIDDLE: 1, RIGHT: 0};
    this.controls.addEventListener('change', () => onChange(this));
  }

  // Takes the triangles to be drawn, whose positions are about between -1 and 1.
  // `extent` are those that the camera shows.
  setSurface(positions, attributes, triangles, material, extent) {
    this.positions = positions;
    this.extent = extent;
    this.extentBox = boxOf(extent);
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    for(const [name, attribute] of Object.entries(attributes))
      this.geometry.setAttribute(name, attribute);
    this.geometry.boundingSphere = new Sphere(new Vector3(), 2); // nothing needs the exact one
    this.geometry.setIndex(triangles);
    this.triangles = triangles;
    this.mesh = new Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  resetCamera() {
    const {way, up} = this.isPlane
      ? {way: new Vector3(0, 0, 1), up: new Vector3(0, 1, 0)} : outlook(this.extentBox);
    const center = this.isPlane ? new Vector3() : middle(this.extentBox);
    this.controls.target.copy(center);
    this.camera.up.copy(up);
    this.camera.zoom = 1;
    this.camera.position.copy(center).addScaledVector(
      way, this.isPlane ? 5 : this.distance(center, way, up));
    this.camera.lookAt(center);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  // From where all is within the view, which goes against `way`.
  distance(center, way, up) {
    const right = new Vector3().crossVectors(up, way).normalize();
    const top = new Vector3().crossVectors(way, right);
    const height = Math.tan(Math.PI / 180 * this.camera.fov / 2) / 1.1;
    const width = height * this.camera.aspect;
    const along = ({x, y, z}, i) => x * (this.extent[i] - center.x) +
      y * (this.extent[i + 1] - center.y) + z * (this.extent[i + 2] - center.z);
    let result = .01;
    for(let i = 0; i < this.extent.length; i += 3) {
      const most = along(way, i) + Math.max(
        Math.abs(along(right, i)) / width, Math.abs(along(top, i)) / height);
      if(most > result && most < Infinity)
        result = most;
    }
    return result;
  }

  place(left, top, width, height) {
    Object.assign(this.element.style,
      {left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px`});
    this.box = {left, top, width, height};
    const aspect = width / height;
    if(this.isPlane) {
      const half = 1.08 * Math.max(1, 1 / aspect);
      Object.assign(this.camera,
        {left: -half * aspect, right: half * aspect, top: half, bottom: -half});
    } else
      this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.controls.handleResize();
    this.resetCamera();
  }

  // A layer is made when it is shown for the first time.
  show(name, isShown, make) {
    if(isShown && !this.layers.has(name)) {
      this.layers.set(name, make());
      this.scene.add(this.layers.get(name));
    }
    if(this.layers.has(name))
      this.layers.get(name).visible = isShown;
  }

  remove(name) {
    const layer = this.layers.get(name);
    layer?.removeFromParent();
    layer?.geometry.dispose();
    this.layers.delete(name);
  }

  // What is hit at a position in the pane, in pixels: a triangle, and where in it.
  pick(x, y) {
    const at = new Vector2(2 * x / this.box.width - 1, 1 - 2 * y / this.box.height);
    const ray = new Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(at, this.camera);
    const [hit] = ray.intersectObject(this.pickMesh, false);
    return hit && {triangle: hit.faceIndex, point: hit.point};
  }

  // All triangles in their order, whatever is drawn.
  get pickMesh() { return this.pickable ??= this.makePickable(); }

  makePickable() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.geometry.getAttribute('position'));
    geometry.setIndex(this.triangles);
    return new Mesh(geometry, new MeshBasicMaterial({side: 2}));
  }

  // Where a point is in the pane, in pixels.
  project(point) {
    this.camera.updateMatrixWorld();
    const p = point.clone().project(this.camera);
    return [(p.x + 1) / 2 * this.box.width, (1 - p.y) / 2 * this.box.height];
  }
}

export function pointCloud(positions, color, size) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  const result = new Points(geometry, new PointsMaterial(
    {color, size, sizeAttenuation: false, map: disc(), alphaTest: .5, depthTest: false}));
  result.renderOrder = 50;
  result.frustumCulled = false;
  return result;
}

// Without points that are not finite.
function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for(let i = 0; i < positions.length; i += 3)
    if(Number.isFinite(positions[i] + positions[i + 1] + positions[i + 2]))
      for(let k = 0; k < 3; ++k) {
        const x = positions[i + k];
        if(x < low[k])
          low[k] = x;
        if(x > high[k])
          high[k] = x;
      }
  return {low, high};
}

const middle = ({low, high}) => low[0] <= high[0]
  ? new Vector3(...low.map((x, k) => (x + high[k]) / 2)) : new Vector3();
