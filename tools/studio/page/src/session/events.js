// SPDX-License-Identifier: Apache-2.0
// The server's stream of events. A lost connection is taken up again by itself; the server then
// sends everything that is present.

import { get } from "./api.js";

const LONGEST_WAIT = 5000; // ms between attempts

/**
 * @param {(kind: string, data: any) => void} tell
 * @param {(connected: boolean, why: string) => void} connection
 * @param {number=} heard where another stream was left; without, notices of before are not told
 * @returns {() => void} ends it
 */
export function follow(tell, connection, heard) {
  let source = null;
  let wait = 250;
  let why = ""; // the last attempt was refused
  let timer = 0;
  let closed = false;

  const connect = () => {
    source = new EventSource(heard === undefined ? "/api/events" : `/api/events?heard=${heard}`);
    source.onopen = () => {
      wait = 250;
      heard = undefined;
      why = "";
      connection(true, why);
    };
    for (const kind of KINDS)
      source.addEventListener(kind, (event) => tell(kind, JSON.parse(event.data)));
    source.onmessage = (event) => {
      const data = JSON.parse(event.data);
      tell(data.kind, data);
    };
    source.onerror = async () => {
      source.close();
      connection(false, why); // at once: what is asked next may take its time
      why = await refusal();
      if (closed) return;
      connection(false, why);
      timer = setTimeout(connect, wait);
      wait = Math.min(LONGEST_WAIT, 2 * wait);
    };
  };
  connect();
  return () => {
    closed = true;
    clearTimeout(timer);
    source.close();
  };
}

/** Why the server refuses a stream, which no browser tells; empty where it does not, or is away. */
async function refusal() {
  try {
    await get("/api/room", AbortSignal.timeout(LONGEST_WAIT));
  } catch (error) {
    if (error.status) return error.message;
  }
  return "";
}

const KINDS = [
  "opened",
  "state",
  "assembly",
  "design",
  "motion",
  "point",
  "alternatives",
  "physics",
  "judge",
  "job",
  "notice",
];
