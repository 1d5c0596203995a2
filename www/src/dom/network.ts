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

/** The browser keeps the failure of a file that the part imports, under an address that cannot be changed. */
export class NeedsReload extends Error {}

/**
 * Imports a part. One that could not be had can be had with a later call, also where the browser keeps the failure: all keep
 * that of a script with a fault, Firefox every failure.
 *
 * @throws NeedsReload where that is so of a file that the part imports.
 */
export async function loaded<Part>(load: () => Promise<Part>): Promise<Part> {
  try {
    return await load();
  } catch (error) {
    const failed = addressIn(error);
    if (failed?.endsWith('.css') === true) {
      // Its script is imported without it the next time.
      styles(failed);
      throw error;
    }
    const imported = importIn(load);
    const address = imported && addressOf(imported.file, failed);
    if (address === undefined) throw error;
    const again = async (): Promise<Part> => {
      const chunk = (await import(/* @vite-ignore */ `${address}?again=${++tries}`)) as Readonly<
        Record<string, unknown>
      >;
      return (imported?.member === undefined ? chunk : chunk[imported.member]) as Part;
    };
    try {
      return await again();
    } catch (failure) {
      if (!(await isWhole(address, 'with-imports'))) throw failure;
    }
    // The files can be had by now: the network may have returned after the import failed.
    return again().catch(() => {
      throw new NeedsReload('the page has to be reloaded');
    });
  }
}

/** The file that an error names. */
function addressIn(error: unknown): string | undefined {
  return /\bhttps?:\S+?\.(?:js|css)\b/.exec(error instanceof Error ? error.message : '')?.[0];
}

/** What a function imports, as the build writes it: `import("./a.js")`, or `import("./a.js").then(n=>n.b)` where several parts share a file. */
function importIn(load: () => unknown): { readonly file: string; readonly member: string | undefined } | undefined {
  const found =
    /import\(\s*["'`](?:[^"'`]*\/)?([^"'`/]+\.js)["'`]\s*\)(?:\.then\(\s*\(?([\w$]+)\)?\s*=>\s*\2\.([\w$]+))?/.exec(
      String(load),
    );
  return found?.[1] === undefined ? undefined : { file: found[1], member: found[3] };
}

/** The address of a file. An error may name none, or that of a file which the part imports. */
function addressOf(file: string, failed: string | undefined): string | undefined {
  if (failed?.endsWith(`/${file}`) === true) return failed;
  // A preload that fails is no entry in every browser.
  const preload = document.querySelector<HTMLLinkElement>(`link[href$="/${file}"]`)?.href;
  return preload ?? performance.getEntriesByType('resource').find(({ name }) => name.endsWith(`/${file}`))?.name;
}

/** Whether a script can be had with all of its bytes, and the scripts it imports too. What the browser's cache has of them is replaced. */
async function isWhole(address: string, which: 'with-imports' | 'alone'): Promise<boolean> {
  const text = await fetch(address, { cache: 'reload' }).then(
    (response) => (response.ok ? response.text() : ''),
    () => '',
  );
  // So ends each script of the build.
  if (!/\bexport\s*\{[^{}]*\};?\s*$/.test(text)) return false;
  if (which === 'alone') return true;
  const imports = [...text.matchAll(/\b(?:from|import)\s*["'](\.[^"']+\.js)["']/g)].map(
    ([, file = '']) => new URL(file, address).href,
  );
  return (await Promise.all(imports.map((file) => isWhole(file, 'alone')))).every(Boolean);
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
