// Colors of layers, of faces and of values.

export const paper = '#f6f8fa';
export const failure = '#d81e1e';
export const layers = {input: '#566473', intrinsic: '#c8501e', flat: '#1f6fb2', sphere: '#1f6fb2',
  coarse: '#14202c', is_seam: '#7a2fa0', edges: '#566473'};
export const points = {is_cone: '#7a2fa0'};
export const others = '#147a5a';
export const plain = '#e4e2da';
export const missing = '#9a9a9a';
export const faces = ['#8db4e2', '#facd82', '#a0d796', '#eb968c', '#c9b3e0', '#9fd9d5'];

const rising = ['#27306b', '#2a6f9e', '#3fae9b', '#a5d77c', '#fbf2b0'];
const diverging = ['#2b5ea8', '#92bae0', '#f5f3ee', '#eba98c', '#b0362f'];

export const rgb = color => [1, 3, 5].map(i => parseInt(color.slice(i, i + 2), 16) / 255);

const mostSorted = 65536;

// The values to show, without outliers, and their colors; symmetric if there are both signs. Of very
// many values, some determine the outliers.
export function scaleOf(values) {
  const step = Math.ceil(values.length / mostSorted), whole = [Infinity, -Infinity];
  let sorted = new Float32Array(Math.ceil(values.length / step) || 0), n = 0;
  for(let i = 0; i < values.length; ++i)
    if(Number.isFinite(values[i])) {
      whole[0] = Math.min(whole[0], values[i]);
      whole[1] = Math.max(whole[1], values[i]);
      if(i % step === 0)
        sorted[n++] = values[i];
    }
  if(n === 0)
    return {low: 0, high: 1, stops: rising};
  sorted = sorted.subarray(0, n).sort();
  const at = part => sorted[Math.round(part * (n - 1))];
  let [low, high] = [at(.01), at(.99)];
  if(whole[1] - whole[0] < 3 * (high - low))
    [low, high] = whole;
  if(low < 0 && high > 0) {
    const most = Math.max(-low, high);
    return {low: -most, high: most, whole, stops: diverging};
  }
  return {low, high: high > low ? high : low + 1, whole, stops: rising};
}

// Of a value, in steps; grey if it is NaN.
export function colorOf(x, {low, high, stops}) {
  const steps = 48;
  const part = Math.round(steps * Math.min(Math.max((x - low) / (high - low), 0), 1)) / steps;
  if(Number.isNaN(part))
    return missing;
  const i = Math.min(Math.floor(part * (stops.length - 1)), stops.length - 2);
  const [a, b] = [rgb(stops[i]), rgb(stops[i + 1])], t = part * (stops.length - 1) - i;
  return `#${a.map((c, k) => Math.round(255 * (c + t * (b[k] - c))).toString(16).padStart(2, '0'))
    .join('')}`;
}

export const gradient = stops => `linear-gradient(to right, ${stops.join(', ')})`;

// A face has the color of its index in its triangulation.
export const colorOfFace = id => (Math.imul(id + 1, 0x9e3779b1) >>> 8) % faces.length;
