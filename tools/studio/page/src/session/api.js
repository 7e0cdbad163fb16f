// SPDX-License-Identifier: Apache-2.0
// What the page asks of its server. A refusal is an ApiError that says what the program would
// print; its message begins with the place.

export class ApiError extends Error {
  constructor(status, { where = "", message = "", line = 0 } = {}) {
    super(message || `the server answered ${status}`);
    this.status = status;
    this.where = where;
    this.line = line;
  }
}

async function answerOf(response) {
  const text = await response.text();
  let json = {};
  try {
    json = text ? JSON.parse(text) : {};
  } catch {
    json = { error: { message: text.slice(0, 300) } };
  }
  if (!response.ok) throw new ApiError(response.status, json.error);
  return json;
}

async function send(method, path, body, signal) {
  let response;
  try {
    response = await fetch(path, {
      method,
      signal,
      headers: body === undefined ? {} : { "Content-Type": "application/json" },
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new ApiError(0, { message: "legwright studio does not answer; is it still running?" });
  }
  return answerOf(response);
}

export const get = (path, signal) => send("GET", path, undefined, signal);
export const post = (path, body = {}, signal) => send("POST", path, body, signal);
export const remove = (path) => send("DELETE", path);

/** A command of the session. @param {string} name @param {object} fields */
export const command = (name, fields = {}) => post("/api/command", { do: name, ...fields });

const meshes = new Map();

/** A mesh by its id; each is asked for once. */
export function meshSource(id) {
  if (!meshes.has(id)) meshes.set(id, get(`/api/mesh/${encodeURIComponent(id)}`));
  return meshes.get(id);
}
