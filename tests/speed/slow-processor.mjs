// A processor that is so many times slower: the processes that run scripts are stopped most of the time.
//
// The browser's own emulation slows down the main thread alone, not the worker in which programs are run, nor the
// threads that compile WebAssembly. Times of the page go on while it is stopped, so tasks take as much longer.

const RUNNING_MS = 4;
const LOOK_AGAIN_MS = 30;

/** Slows down all renderers of a browser, those that are yet to come included; call what it answers to end that. */
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
    // Timers are late: what ran too long is stopped for longer.
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
