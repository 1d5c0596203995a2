// The next frame of the page, or of a worker.
//
// In: a callback. Out: one call. A hidden page has no frames, and a browser may skip the frames of a page that it
// considers covered: then a timer calls.

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
