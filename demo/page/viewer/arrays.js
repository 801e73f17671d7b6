// The arrays of numbers that the program has put into the page; see Page_arrays.h.

// Older browsers decode text only.
function bytesOf(base64) {
  if(Uint8Array.fromBase64)
    return Uint8Array.fromBase64(base64);
  const text = atob(base64.trim());
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
    return new Float32Array(this.bytes.buffer, at, size);
  }

  quantized({at, size, components, ranges}) {
    const numbers = new Uint16Array(this.bytes.buffer, at, size);
    const result = new Float32Array(size);
    for(const [k, [low, high]] of ranges.entries()) {
      const step = (high - low) / 65534;
      for(let i = k; i < size; i += components)
        result[i] = numbers[i] === 65535 ? NaN : low + numbers[i] * step;
    }
    return result;
  }

  differences({at, size}) {
    const {bytes} = this;
    const result = new Int32Array(size);
    for(let i = 0, last = 0; i < size; ++i) {
      let n = bytes[at++];
      if(n >= 128) {
        n -= 128;
        for(let factor = 128, byte = 128; byte >= 128; factor *= 128) {
          byte = bytes[at++];
          n += byte % 128 * factor;
        }
      }
      last += n % 2 ? -(n + 1) / 2 : n / 2;
      result[i] = last;
    }
    return result;
  }
}
