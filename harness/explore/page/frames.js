// The messages between the page and the program (harness/explore/frame.h): a JSON text, and bytes.

const HEAD = 8;

export function encodeFrame(json, bytes = new Uint8Array(0)) {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = Math.ceil(text.length / 8) * 8;
  const frame = new Uint8Array(HEAD + padded + bytes.byteLength);
  const head = new DataView(frame.buffer);
  head.setUint32(0, padded, true);
  head.setUint32(4, bytes.byteLength, true);
  frame.fill(32, HEAD, HEAD + padded);
  frame.set(text, HEAD);
  frame.set(new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength), HEAD + padded);
  return frame;
}

// Frames out of a stream of bytes, cut wherever it may be.
export class FrameReader {
  #parts = [];
  #size = 0;

  // The frames that are complete with this part: [{json, bytes: ArrayBuffer}].
  add(part) {
    this.#parts.push(part);
    this.#size += part.length;
    const frames = [];
    for (let frame = this.#next(); frame; frame = this.#next()) frames.push(frame);
    return frames;
  }

  #next() {
    if (this.#size < HEAD) return null;
    this.#join(HEAD);
    const head = new DataView(this.#parts[0].buffer, this.#parts[0].byteOffset);
    const jsonSize = head.getUint32(0, true);
    const size = HEAD + jsonSize + head.getUint32(4, true);
    if (this.#size < size) return null;
    this.#join(size);
    const all = this.#parts[0];
    this.#parts[0] = all.subarray(size);
    this.#size -= size;
    const json = JSON.parse(new TextDecoder().decode(all.subarray(HEAD, HEAD + jsonSize)));
    return { json, bytes: all.slice(HEAD + jsonSize, size).buffer };
  }

  // Makes the first part at least so long.
  #join(size) {
    if (this.#parts[0].length >= size) return;
    const all = new Uint8Array(this.#size);
    let position = 0;
    for (const part of this.#parts) {
      all.set(part, position);
      position += part.length;
    }
    this.#parts = [all];
  }
}
