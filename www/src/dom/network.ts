// Parts of the page that are loaded when they are needed, and what is done where the network is missing.
//
// In: how a part is imported. Out: the part, now or with a later try. Must not know: what is in a part, or what is said of it.

let tries = 0;

/** Acts once the network is there again; the answer ends the waiting. */
export function whenOnline(act: () => void): () => void {
  const waiting = new AbortController();
  addEventListener('online', act, { once: true, signal: waiting.signal });
  return () => waiting.abort();
}

/** The browser knows that there is no network; where it says nothing there may be none all the same. */
export function isOffline(): boolean {
  return !navigator.onLine;
}

/** Imports a part; one that could not be had is had with a later call, also where the browser remembers the failure (Firefox). */
export async function loaded<Part>(load: () => Promise<Part>): Promise<Part> {
  try {
    return await load();
  } catch (error) {
    const address = /\bhttps?:\S+?\.(?:js|css)\b/.exec(error instanceof Error ? error.message : '')?.[0];
    if (address === undefined) throw error;
    if (address.endsWith('.css')) {
      // Its script is imported without it the next time.
      styles(address);
      throw error;
    }
    // Under its own address a browser may answer with an earlier failure.
    return (await import(/* @vite-ignore */ `${address}?again=${++tries}`)) as Part;
  }
}

/** A style sheet that could not be had comes with the network. */
function styles(address: string): void {
  const link = Object.assign(document.createElement('link'), { rel: 'stylesheet', href: address });
  link.addEventListener('error', () => {
    link.remove();
    whenOnline(() => styles(address));
  });
  document.head.append(link);
}
