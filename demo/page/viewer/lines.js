// Lines on surfaces: wide ones, or thin ones where there are very many.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { LineMaterial } from './LineMaterial.js';
import { LineSegments2 } from './LineSegments2.js';
import { LineSegmentsGeometry } from './LineSegmentsGeometry.js';

const mostWide = 120000;

function thinLines(positions, color) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return new LineSegments(geometry, new LineBasicMaterial({color}));
}

function wideLines(positions, color, width) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions);
  return new LineSegments2(geometry, new LineMaterial({color, linewidth: width}));
}

// `positions` are those of both ends of each segment; later layers have a greater `order`.
export function lines(positions, {color, width, order}) {
  const result = positions.length / 6 > mostWide
    ? thinLines(positions, color) : wideLines(positions, color, width);
  result.renderOrder = order;
  result.frustumCulled = false;
  return result;
}
