// Small charts as SVG.

const width = 274, height = 110, left = 34, bottom = 16, top = 6;

function element(name, attributes, ...children) {
  const result = document.createElementNS('http://www.w3.org/2000/svg', name);
  for(const [key, value] of Object.entries(attributes))
    result.setAttribute(key, value);
  result.append(...children);
  return result;
}

const label = (x, y, text, anchor = 'middle') =>
  element('text', {x, y, 'text-anchor': anchor}, document.createTextNode(text));

function chart(...children) {
  const axis = element('path', {fill: 'none', stroke: '#c3ccd4',
    d: `M${left} ${top}V${height - bottom}H${width}`});
  return element('svg', {class: 'chart', viewBox: `0 0 ${width} ${height}`}, axis, ...children);
}

const xOf = (i, n) => left + (width - left) * i / n;
const yOf = part => top + (height - bottom - top) * (1 - part);

function steps(counts, most) {
  const sum = counts.reduce((a, b) => a + b, 0);
  return counts.map((c, i) =>
    `V${yOf(c / sum / most)}H${xOf(i + 1, counts.length)}`).join('');
}

// Of counts in intervals of 0 to 180 degrees, as shares.
export function angleChart(histograms, colors) {
  const shares = histograms.map(({counts}) => {
    const sum = counts.reduce((a, b) => a + b, 0);
    return Math.max(...counts) / Math.max(sum, 1);
  });
  const most = Math.max(...shares, .01);
  const areas = histograms.map(({counts}, i) => element('path', {
    fill: colors[i], 'fill-opacity': .25, stroke: colors[i], 'stroke-width': 1.3,
    d: `M${left} ${yOf(0)}${steps(counts, most)}V${yOf(0)}`}));
  const degrees = [0, 60, 120, 180].map(d =>
    label(Math.min(Math.max(xOf(d, 180), left + 5), width - 12), height - 3, `${d}°`));
  return chart(...areas, ...degrees,
    label(left - 4, top + 8, `${Math.round(100 * most)} %`, 'end'));
}

// Of positive values over their indices, with a logarithmic axis.
export function curveChart(values, color) {
  const logs = values.map(v => Math.log10(Math.max(v, 1e-17)));
  const low = Math.floor(Math.min(...logs)), high = Math.max(Math.ceil(Math.max(...logs)), low + 1);
  const n = Math.max(values.length - 1, 1);
  const points = logs.map((v, i) => `${xOf(i, n)},${yOf((v - low) / (high - low))}`);
  return chart(
    element('polyline', {
      fill: 'none', stroke: color, 'stroke-width': 1.6, points: points.join(' ')}),
    label(left - 4, top + 8, `1e${high}`, 'end'), label(left - 4, yOf(0), `1e${low}`, 'end'),
    label(left + 4, height - 3, '0'), label(width - 8, height - 3, `${values.length - 1}`));
}
