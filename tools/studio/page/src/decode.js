// SPDX-License-Identifier: Apache-2.0
// Arrays out of base64, as the server and a report write them: little-endian, like every machine
// that runs a browser.

/** @param {string} text @returns {ArrayBuffer} */
export function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

/** @param {string|number[]|Float32Array|null|undefined} data base64, or an array as it is */
export function floatsOf(data) {
  if (!data) return new Float32Array(0);
  return typeof data === "string" ? new Float32Array(bytesOf(data)) : Float32Array.from(data);
}

/** @param {string|number[]} data */
export function indicesOf(data) {
  return typeof data === "string" ? new Uint32Array(bytesOf(data)) : Uint32Array.from(data);
}

/** The index of a body that is given by its name or by its index; -1 where there is none. */
export function bodyIndex(bodies, body) {
  if (typeof body === "number") return body;
  return bodies.findIndex((each) => (typeof each === "string" ? each : each.name) === body);
}
