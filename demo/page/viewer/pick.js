// Where a picked point is: on the surface, in its picture, and in the faces of each triangulation.

import { Triangle, Vector3 } from 'three';

const vectorAt = (positions, i) =>
  new Vector3(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);

function weightsIn(positions, corners, point) {
  const result = new Vector3();
  Triangle.getBarycoord(point, ...corners.map(c => vectorAt(positions, c)), result);
  return result.toArray();
}

// Linear on the triangle with these weights of its corners.
const mix = (positions, corners, weights) => corners.reduce(
  (sum, c, i) => sum.addScaledVector(vectorAt(positions, c), weights[i]), new Vector3());

// The map between a triangle and its image is projective: weights are multiplied by those of
// homogeneous coordinates.
function scaled(weights, factors) {
  const products = weights.map((w, i) => w * factors[i]);
  const sum = products.reduce((a, b) => a + b, 0);
  return products.map(p => p / sum);
}

function valueAt(surface, name, polygon, corners, weights) {
  if(surface.developed?.hasFunction(name))
    return surface.developed.valueAt(name, polygon, weights);
  if(!surface.pointData[name])
    return surface.polygonData[name].values[polygon];
  return corners.reduce((sum, c, i) =>
    sum + weights[i] * surface.pointData[name].values[surface.point(c)], 0);
}

function facesOf(surface, polygon, weights) {
  if(surface.developed)
    return {input: polygon, intrinsic: surface.developed.faceAt(polygon, weights)};
  return Object.fromEntries(surface.triangulations
    .filter(t => surface.polygonData[`${t}_face`])
    .map(t => [t, surface.polygonData[`${t}_face`].values[polygon]]));
}

function nearestPoint(surface, corners, weights) {
  return surface.point(corners[weights.indexOf(Math.max(...weights))]);
}

// `hit` is a triangle of a view and a point in it.
export function locate({surface, pane, isPicture}, {triangle, point}) {
  const {description, picture} = surface;
  const corners = Array.from(surface.triangles.subarray(3 * triangle, 3 * triangle + 3));
  const factors = corners.map(c => surface.texture ? surface.texture[3 * c + 2] : 1);
  const found = weightsIn(pane.positions, corners, point);
  const weights = isPicture ? scaled(found, factors.map(f => 1 / f)) : found;
  const inPicture = picture && mix(picture.positions, corners, scaled(weights, factors));
  if(picture?.kind === 'sphere')
    inPicture.normalize();
  const onSurface = mix(surface.points, corners.map(c => surface.point(c)), weights);
  const polygon = surface.polygonOfTriangle[triangle];
  return {
    onSurface: onSurface.toArray(), inPicture: inPicture?.toArray(),
    description: {
      surface: surface.name, polygon,
      point: onSurface.toArray().map((x, k) => description.center[k] + description.radius * x),
      picture: inPicture && unframed(inPicture.toArray(), surface),
      nearestVertex: nearestPoint(surface, corners, weights),
      faces: facesOf(surface, polygon, weights),
      values: Object.fromEntries(surface.fields.map(
        name => [name, valueAt(surface, name, polygon, corners, weights)]))}};
}

// In its own disk, if there are several.
function unframed(position, {picture: {kind, center, radius}}) {
  const [x, y, z] = position.map((t, k) => center[k] + radius * t);
  return kind === 'sphere' ? [x, y, z] : [kind === 'disk' ? x - 2.04 * Math.round(x / 2.04) : x, y];
}
