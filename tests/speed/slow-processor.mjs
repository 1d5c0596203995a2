// Simulates a slower processor: stops the renderer processes most of the time.
//
// The emulation in the browser slows down only the main thread, not the worker that runs programs, nor the threads that
// compile WebAssembly. The clock of the page continues while it is stopped, so tasks appear to take longer by the same
// factor.

const RUNNING_MS = 4;
const LOOK_AGAIN_MS = 30;

/** Slows down all current and later renderers of a browser. Call the returned function to stop. */
export async function slowProcessor(browser, factor) {
  const session = await browser.newBrowserCDPSession();
  const processes = new Set();
  let ended = false;
  const look = async () => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    for (const { type, id } of processInfo) if (type === 'renderer') processes.add(id);
  };
  const lookOn = async () => {
    while (!ended) {
      await pause(LOOK_AGAIN_MS);
      // The browser may have been closed.
      await look().catch(() => undefined);
    }
  };
  const all = (signal) => {
    for (const id of processes) {
      try {
        process.kill(id, signal);
      } catch {
        processes.delete(id);
      }
    }
  };
  const slow = async () => {
    // Timers fire late: a longer run is followed by a longer stop.
    let owed = 0;
    while (!ended) {
      const begun = performance.now();
      await pause(RUNNING_MS);
      all('SIGSTOP');
      const stopped = performance.now();
      owed += (stopped - begun) * (factor - 1);
      await pause(Math.max(owed, 1));
      all('SIGCONT');
      owed -= performance.now() - stopped;
    }
  };
  await look();
  void lookOn();
  const slowing = slow();
  return async () => {
    ended = true;
    await slowing;
    all('SIGCONT');
  };
}

function pause(ms) {
  return new Promise((resolve) => setTimeout(resolve, ms));
}
