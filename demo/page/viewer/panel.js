// The panel beside the stage: what is shown, legends, charts and numbers.

import { angleChart, curveChart } from './charts.js';
import * as colors from './colors.js';
import { partsOf } from './viewer.js';

const names = {
  input: 'edges of the input', intrinsic: 'intrinsic edges',
  flat: 'edges of the flat triangulation',
  sphere: 'edges of the polyhedron', coarse: 'coarse edges', edges: 'edges', is_seam: 'seams',
  is_cone: 'cones', log_scale: 'logarithmic scale factor', curvature: 'Gaussian curvature',
  distance: 'distance', distance_error: 'error of the distance',
  angle_distortion: 'distortion of angles',
  linear_angle_distortion: 'distortion of angles, linear',
  area_distortion: 'distortion of areas (logarithm)',
  interpolation_error: 'linear against projective',
  area_change: 'change of areas (logarithm)'};

export const nameOf = key => names[key] ?? key.replace(/^is_/, '').replace(/_/g, ' ');

export function format(x) {
  if(x === null || x === undefined)
    return '–';
  if(typeof x !== 'number')
    return String(x);
  return Number.isInteger(x) ? String(x).replace(/\B(?=(\d{3})+$)/g, '\u202f')
    : String(Number(x.toPrecision(5)));
}

function make(tag, properties = {}, ...children) {
  const result = Object.assign(document.createElement(tag), properties);
  result.append(...children);
  return result;
}

const section = (title, ...children) =>
  make('section', {}, make('h2', {textContent: title}), ...children);

function table(rows) {
  return make('table', {}, make('tbody', {}, ...rows.map(([name, value]) => make('tr', {},
    make('td', {textContent: name}), make('td', {textContent: value})))));
}

function swatch(color, isDot) {
  const result = make('span', {className: isDot ? 'swatch dot' : 'swatch'});
  result.style.background = color;
  return result;
}

export class Panel {
  constructor(element, viewer, page) {
    this.viewer = viewer;
    this.boxes = new Map();
    this.legend = make('div');
    this.point = make('div', {}, make('p', {className: 'hint',
      textContent: 'Click on a surface, or on its picture.'}));
    element.append(this.heading(page), this.layerSection(), this.colorSection(),
      ...this.markSection(), section('Point', this.point), ...this.charts(page),
      section('Statistics', table(rowsOf(page.statistics))), help(), licence());
    this.update();
  }

  heading(page) {
    const {command = 'view', input = ''} = page.statistics;
    const file = input.split('/').pop();
    document.title = `${file} – intrinsic ${command}`;
    return make('header', {}, make('h1', {textContent: file || 'Surfaces'}),
      make('p', {className: 'subtitle', textContent: `intrinsic ${command}`}));
  }

  checkBox(key, color, isDot, count) {
    const box = make('input', {type: 'checkbox', checked: this.viewer.state.shown[key]});
    box.addEventListener('change', () => this.viewer.set({shown: {[key]: box.checked}}));
    this.boxes.set(key, box);
    return make('label', {}, box, swatch(color, isDot), nameOf(key),
      make('span', {className: 'count', textContent: format(count)}));
  }

  layerSection() {
    const boxes = this.viewer.layers.map(layer => this.checkBox(layer,
      colors.layers[layer] ?? colors.others, false, this.viewer.countEdges(layer)));
    const points = this.viewer.markedPoints.map(name => this.checkBox(name,
      colors.points[name] ?? colors.others, true, this.countPoints(name)));
    return section('Lines and points', ...boxes, ...points);
  }

  countPoints(name) {
    return this.viewer.surfaces.reduce((sum, s) =>
      sum + (s.pointData[name]?.parts ?? 0), 0);
  }

  markSection() {
    const boxes = this.viewer.marks.map(mark => this.checkBox(mark.name,
      mark.is_failure ? colors.failure : colors.others, true, Math.max(
        mark.polygons.length, mark.lines.begin.length - 1, mark.points.length)));
    return boxes.length > 0 ? [section('Marked', ...boxes)] : [];
  }

  // ---- Colors ----

  choices() {
    const {viewer} = this;
    return [['plain', 'one color'],
      ...(viewer.hasTexture ? [['projective', 'checkerboard, projective'],
        ['linear', 'checkerboard, linear']] : []),
      ...viewer.fields.map(name => [`field ${name}`, nameOf(name)]),
      ...viewer.triangulations.map(t => [`faces ${t}`, `faces: ${t}`])];
  }

  colorSection() {
    this.select = make('select', {id: 'color'}, ...this.choices().map(([value, text]) =>
      make('option', {value, textContent: text})));
    this.select.value = this.viewer.state.color;
    this.select.addEventListener('change', () => this.setColor(this.select.value));
    return section('Surface', this.select, this.legend);
  }

  setColor(color) {
    this.viewer.set({color});
    this.select.value = color;
    this.update();
  }

  update() {
    const [kind, name] = partsOf(this.viewer.state.color);
    this.legend.replaceChildren(...(kind === 'field' ? this.fieldLegend(name)
      : kind === 'projective' || kind === 'linear' ? [this.slider()] : []));
  }

  fieldLegend(name) {
    const {low, high, whole, stops} = this.viewer.scale(name);
    const bar = make('div', {className: 'legend-bar'});
    bar.style.background = colors.gradient(stops);
    const isCut = whole && (whole[0] < low || whole[1] > high);
    const ticks = [low, (low + high) / 2, high].map(x => make('span', {textContent: format(x)}));
    const range = make('p', {className: 'hint',
      textContent: isCut ? `all values: ${format(whole[0])} to ${format(whole[1])}` : ''});
    const box = make('input', {type: 'checkbox', checked: this.viewer.state.isolines});
    box.addEventListener('change', () => this.viewer.set({isolines: box.checked}));
    const hasLines = this.viewer.surfaces.some(s => s.pointData[name]);
    return [bar, make('div', {className: 'legend-ticks'}, ...ticks), range,
      ...(hasLines ? [make('label', {}, box, 'isolines')] : [])];
  }

  slider() {
    const input = make('input', {type: 'range', min: 2, max: 128, step: 2,
      value: this.viewer.state.squares});
    input.addEventListener('input', () => this.viewer.set({squares: Number(input.value)}));
    return make('label', {}, 'squares', input);
  }

  // ---- Points, charts ----

  showPoint(place) {
    if(!place)
      return;
    const list = values => values.map(x => format(x)).join(', ');
    this.point.replaceChildren(table([
      ['position', list(place.point)],
      ...(place.picture ? [['in the picture', list(place.picture)]] : []),
      ['nearest vertex', format(place.nearestVertex)],
      ...Object.entries(place.faces).map(([t, id]) => [`face, ${t}`, format(id)]),
      ...Object.entries(place.values).map(([name, x]) => [nameOf(name), format(x)])]));
  }

  charts(page) {
    const result = [];
    if(page.angles.length > 0) {
      const shades = [colors.layers.input, colors.layers.intrinsic, colors.layers.flat];
      const key = make('div', {className: 'key'}, ...page.angles.map((h, i) =>
        make('span', {}, swatch(shades[i]), h.name)));
      result.push(section('Angles', key, angleChart(page.angles, shades)));
    }
    for(const {name, values} of page.curves)
      result.push(section(name, curveChart(values, colors.layers.flat)));
    return result;
  }

  // ---- Keys ----

  // After a script has changed what is shown.
  showState() {
    for(const [key, box] of this.boxes)
      box.checked = this.viewer.state.shown[key];
    this.setColor(this.viewer.state.color);
  }

  press(key) {
    const layer = this.viewer.layers[Number(key) - 1];
    if(layer)
      this.boxes.get(layer).click();
    if(key === 'r')
      this.viewer.resetCameras();
    if(key === 'c') {
      const values = this.choices().map(([value]) => value);
      this.setColor(values[(values.indexOf(this.viewer.state.color) + 1) % values.length]);
    }
  }
}

// Nested values have the names of both; of a list of records there is the number.
function rowsOf(statistics, prefix = '') {
  return Object.entries(statistics).flatMap(([key, value]) => {
    const name = prefix + key.replace(/_/g, ' ');
    if(Array.isArray(value))
      return [[name, value.every(x => typeof x !== 'object') ? value.map(x => format(x)).join(', ')
        : format(value.length)]];
    if(value !== null && typeof value === 'object')
      return rowsOf(value, `${name}, `);
    return key === 'command' || key === 'input' ? [] : [[name, format(value)]];
  });
}

function help() {
  const result = section('Help', make('p', {className: 'hint'}));
  result.lastChild.innerHTML = 'Drag to turn, right button to move, wheel to zoom; in the plane, ' +
    'drag to move. Click to see a point everywhere. <kbd>1</kbd> <kbd>2</kbd> … show lines, ' +
    '<kbd>c</kbd> next color, <kbd>r</kbd> first view.';
  return result;
}

function licence() {
  return section('Licence', make('p', {className: 'hint', textContent:
    'Drawn with three.js, © three.js authors, MIT licence; its text is in the source ' +
    'of this page.'}));
}
