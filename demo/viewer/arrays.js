// The arrays of numbers that the program has put into the page; see Page_arrays.h.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for(let i = 0; i < bytes.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes;
}

export class Arrays {
  constructor(base64) {
    this.bytes = bytesOf(base64);
  }

  read(description) {
    return this[description.code](description);
  }

  single({at, size}) {
    return new Float32Array(this.bytes.slice(at, at + 4 * size).buffer);
  }

  quantized({at, size, components, ranges}) {
    const numbers = new Uint16Array(this.bytes.slice(at, at + 2 * size).buffer);
    const steps = ranges.map(([low, high]) => (high - low) / 65534);
    return new Float32Array(size).map((_, i) => numbers[i] === 65535 ? NaN
      : ranges[i % components][0] + numbers[i] * steps[i % components]);
  }

  differences({at, size}) {
    const result = new Int32Array(size);
    for(let i = 0, last = 0; i < size; ++i) {
      let factor = 1, n = 0, byte;
      do {
        byte = this.bytes[at++];
        n += byte % 128 * factor;
        factor *= 128;
      } while(byte >= 128);
      last += n % 2 ? -(n - 1) / 2 - 1 : n / 2;
      result[i] = last;
    }
    return result;
  }
}
