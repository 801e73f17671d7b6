// Reads the page's data, shows it, and lets it be used by hand and by scripts.

import { Arrays } from './arrays.js';
import { Panel } from './panel.js';
import { Surface } from './surface.js';
import { makeRenderer, Viewer } from './viewer.js';

const textOf = id => document.getElementById(id).textContent;

// A click is a press and release at one place.
function onClick(stage, pick) {
  let start;
  stage.addEventListener('pointerdown', event => { start = [event.clientX, event.clientY]; });
  stage.addEventListener('pointerup', event => {
    const box = stage.getBoundingClientRect();
    if(start && Math.hypot(event.clientX - start[0], event.clientY - start[1]) < 4)
      pick(event.clientX - box.left, event.clientY - box.top);
  });
}

function keepDrawing(viewer) {
  viewer.frame();
  requestAnimationFrame(() => keepDrawing(viewer));
}

// When the document has ended, and its arrays are there.
const isRead = new Promise(resolve => {
  if(document.readyState === 'loading')
    addEventListener('DOMContentLoaded', resolve);
  else
    resolve();
});

const numberOfTriangles = ({surfaces}) =>
  surfaces.reduce((sum, {polygons}) => sum + polygons.corners.size / 3, 0);

// The graphics start while the page is still read, and draw while the panel is made.
export async function show() {
  const page = JSON.parse(textOf('page'));
  const renderer = makeRenderer(document.getElementById('canvas'), numberOfTriangles(page));
  await isRead;
  const arrays = new Arrays(textOf('arrays'));
  const surfaces = page.surfaces.map(description => new Surface(description, arrays));
  const stage = document.getElementById('stage');
  const viewer = new Viewer(stage, renderer, surfaces);
  viewer.frame();
  const panel = new Panel(document.getElementById('panel'), viewer, page);
  const pick = (x, y) => {
    const place = viewer.pick(x, y);
    panel.showPoint(place);
    return place;
  };
  onClick(stage, pick);
  addEventListener('keydown', event => panel.press(event.key));
  keepDrawing(viewer);
  window.intrinsicView = {page, viewer, pick, setColor: color => panel.setColor(color),
    set: changes => {
      viewer.set(changes);
      panel.showState();
    }, pixel: (x, y) => viewer.pixel(x, y),
    project: (point, surface) => viewer.project(point, surface)};
  window.dispatchEvent(new Event('intrinsic-view-ready'));
}
