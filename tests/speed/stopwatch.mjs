// Helpers for measurements, in Node and in a page: the time of an action, and the median.

/** Milliseconds an action takes. */
export function time(action) {
  const begun = performance.now();
  action();
  return performance.now() - begun;
}

/** The median of some numbers. */
export function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}
