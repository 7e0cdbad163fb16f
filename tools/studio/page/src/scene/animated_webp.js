// SPDX-License-Identifier: Apache-2.0
// Still WebP pictures, as browsers write them, put together into one that moves.

const ANIMATION = 0x02; // flags of VP8X
const ALPHA = 0x10;
const REPLACE = 0x02; // of ANMF: a frame takes the place of what is below, it is not blended
const LONGEST = 0xffffff; // ms of a frame

/** The chunks of a WebP file that hold a picture: its alpha, where it has any, and its pixels. */
function pictureChunks(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const name = (at) => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (bytes.length < 20 || name(0) !== "RIFF" || name(8) !== "WEBP")
    throw new Error("This is no WebP picture.");
  const found = [];
  for (let at = 12; at + 8 <= bytes.length; ) {
    const size = 8 + view.getUint32(at + 4, true);
    const padded = size + (size % 2);
    if (["ALPH", "VP8 ", "VP8L"].includes(name(at))) found.push(bytes.subarray(at, at + padded));
    at += padded;
  }
  return found;
}

/** A chunk of a name and parts of bytes; sizes are even, as RIFF has it. */
function chunk(name, ...parts) {
  const size = parts.reduce((sum, part) => sum + part.length, 0);
  const out = new Uint8Array(8 + size + (size % 2));
  out.set([...name].map((c) => c.charCodeAt(0)));
  new DataView(out.buffer).setUint32(4, size, true);
  let at = 8;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** Numbers of 24 bits, the lowest byte first. */
const wide = (...values) =>
  Uint8Array.from(values.flatMap((v) => [v & 255, (v >> 8) & 255, (v >> 16) & 255]));

/**
 * @param {number} width [pixels]
 * @param {number} height
 * @param {{bytes: Uint8Array, duration: number, at?: [number, number, number, number]}[]} frames
 * still WebP files, each for so long [ms]; `at` is the part of the picture that it replaces: x and
 * y, which are even, width and height
 * @returns {Uint8Array} a file that plays again and again
 */
export function animatedWebp(width, height, frames) {
  const still = ({ bytes, duration, at: [x, y, w, h] = [0, 0, width, height] }) =>
    chunk(
      "ANMF",
      wide(x / 2, y / 2, w - 1, h - 1, Math.min(LONGEST, Math.max(1, Math.round(duration)))),
      Uint8Array.of(REPLACE),
      ...pictureChunks(bytes),
    );
  const head = chunk(
    "VP8X",
    Uint8Array.of(ANIMATION | ALPHA, 0, 0, 0),
    wide(width - 1, height - 1),
  );
  const forever = chunk("ANIM", new Uint8Array(6));
  const name = Uint8Array.from([..."WEBP"].map((c) => c.charCodeAt(0)));
  return chunk("RIFF", name, head, forever, ...frames.map(still));
}
