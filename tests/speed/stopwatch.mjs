// What a measurement needs, in Node and in a page: the time of an action, and the middle of many.

/** Milliseconds an action takes. */
export function time(action) {
  const begun = performance.now();
  action();
  return performance.now() - begun;
}

/** The middle one of some numbers. */
export function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}
