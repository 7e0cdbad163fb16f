// SPDX-License-Identifier: Apache-2.0
// The server's stream of events. A lost connection is taken up again by itself; the server then
// sends everything that is present.

const LONGEST_WAIT = 5000; // ms between attempts

/**
 * @param {(kind: string, data: any) => void} tell
 * @param {(connected: boolean) => void} connection
 * @param {number=} heard where another stream was left; without, notices of before are not told
 * @returns {() => void} ends it
 */
export function follow(tell, connection, heard) {
  let source = null;
  let wait = 250;
  let timer = 0;
  let closed = false;

  const connect = () => {
    source = new EventSource(heard === undefined ? "/api/events" : `/api/events?heard=${heard}`);
    source.onopen = () => {
      wait = 250;
      heard = undefined;
      connection(true);
    };
    for (const kind of KINDS)
      source.addEventListener(kind, (event) => tell(kind, JSON.parse(event.data)));
    source.onmessage = (event) => {
      const data = JSON.parse(event.data);
      tell(data.kind, data);
    };
    source.onerror = () => {
      source.close();
      connection(false);
      if (closed) return;
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
