// The next frame of the page, or of a worker.
//
// In: a callback. Out: its call, once. A hidden page has no frames, and a browser may skip those of a page that it takes
// for covered: then a timer calls.

/** The longest time until the call, ms. */
const LONGEST_MS = 1000;

/** Calls back in the next frame. Returns a function that cancels the call. */
export function inNextFrame(callback: () => void): () => void {
  const cancel = (): void => {
    cancelAnimationFrame(frame);
    clearTimeout(timer);
  };
  const call = (): void => {
    cancel();
    callback();
  };
  const frame = requestAnimationFrame(call);
  const timer = setTimeout(call, LONGEST_MS);
  return cancel;
}
