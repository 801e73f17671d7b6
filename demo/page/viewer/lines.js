// Lines on surfaces: wide ones, or thin ones where there are very many.

import { BufferAttribute, BufferGeometry, Color, GreaterDepth, LineBasicMaterial, LineSegments }
  from 'three';
import { plain } from './colors.js';
import { LineMaterial } from './LineMaterial.js';
import { LineSegments2 } from './LineSegments2.js';
import { LineSegmentsGeometry } from './LineSegmentsGeometry.js';

const mostWide = 120000;

// Lines behind surfaces show through them, pale.
const behind = color => ({color: new Color(color).lerp(new Color(plain), .3),
  depthFunc: GreaterDepth, depthWrite: false});

function thinLines(positions, style) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return new LineSegments(geometry, new LineBasicMaterial(style));
}

function wideLines(positions, style, linewidth) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(positions);
  return new LineSegments2(geometry, new LineMaterial({...style, linewidth}));
}

// `positions` are those of both ends of each segment; later layers have a greater `order`.
export function lines(positions, {color, width, order, isBehind}) {
  const style = isBehind ? behind(color) : {color};
  const result = positions.length / 6 > mostWide
    ? thinLines(positions, style) : wideLines(positions, style, width);
  result.renderOrder = order;
  // On segments that two layers share, the later one is visible.
  Object.assign(result.material, {polygonOffset: true, polygonOffsetUnits: -6 * order});
  result.frustumCulled = false;
  return result;
}
