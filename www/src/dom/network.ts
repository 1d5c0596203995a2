// Loads parts of the page on demand, and tries again after a network failure.
//
// In: a function that imports a part. Out: the part, immediately or on a later attempt. Must not know: the contents of
// a part, or the messages about it.

let retryCount = 0;

/** Calls `onOnline` once the network is available again. The returned function cancels it. */
export function whenOnline(onOnline: () => void): () => void {
  const abort = new AbortController();
  addEventListener('online', onOnline, { once: true, signal: abort.signal });
  return () => abort.abort();
}

/** Whether the browser knows that there is no network. False does not mean that there is one. */
export function isOffline(): boolean {
  return !navigator.onLine;
}

/**
 * Thrown if the browser caches the failed import of a file, and its address cannot be changed because the part imports
 * it.
 */
export class ReloadRequiredError extends Error {}

/**
 * Imports a part. After a failure, a later call can succeed, even if the browser caches the failure: Firefox caches
 * every failed import, all browsers cache that of a script with an error.
 *
 * @throws NeedsReload if the failure of a file that the part imports is cached.
 */
export async function importWithRetry<Part>(load: () => Promise<Part>): Promise<Part> {
  try {
    return await load();
  } catch (error) {
    const failed = addressIn(error);
    if (failed?.endsWith('.css') === true) {
      // The next import of the script succeeds without the style sheet.
      loadStyleSheet(failed);
      throw error;
    }
    const imported = importIn(load);
    const address = imported && addressOf(imported.file, failed);
    // A browser that names no file, WebKit, does not cache a failed import.
    if (address === undefined) return load();
    const importAgain = async (): Promise<Part> => {
      const chunk = (await import(/* @vite-ignore */ `${address}?again=${++retryCount}`)) as Readonly<
        Record<string, unknown>
      >;
      return (imported?.member === undefined ? chunk : chunk[imported.member]) as Part;
    };
    try {
      return await importAgain();
    } catch (failure) {
      if (!(await isComplete(address, 'with-imports'))) throw failure;
    }
    // The files are available by now: the network may have returned after the import failed.
    return importAgain().catch(() => {
      throw new ReloadRequiredError('the page has to be reloaded');
    });
  }
}

/** The address of the file that an error names. */
function addressIn(error: unknown): string | undefined {
  return /\bhttps?:\S+?\.(?:js|css)\b/.exec(error instanceof Error ? error.message : '')?.[0];
}

/**
 * The file that a function imports, as the build writes it: `import("./a.js")`, or `import("./a.js").then(n=>n.b)` if
 * several parts share a file.
 */
function importIn(load: () => unknown): { readonly file: string; readonly member: string | undefined } | undefined {
  const found =
    /import\(\s*["'`](?:[^"'`]*\/)?([^"'`/]+\.js)["'`]\s*\)(?:\.then\(\s*\(?([\w$]+)\)?\s*=>\s*\2\.([\w$]+))?/.exec(
      String(load),
    );
  return found?.[1] === undefined ? undefined : { file: found[1], member: found[3] };
}

/** The address of a file. An error may name no file, or a file that the part imports. */
function addressOf(file: string, failed: string | undefined): string | undefined {
  if (failed?.endsWith(`/${file}`) === true) return failed;
  // Not every browser lists a failed preload as a resource entry.
  const preload = document.querySelector<HTMLLinkElement>(`link[href$="/${file}"]`)?.href;
  return preload ?? performance.getEntriesByType('resource').find(({ name }) => name.endsWith(`/${file}`))?.name;
}

/**
 * Whether a script, and optionally each script that it imports, can be loaded completely. Refreshes them in the HTTP
 * cache.
 */
async function isComplete(address: string, which: 'with-imports' | 'alone'): Promise<boolean> {
  const text = await fetch(address, { cache: 'reload' }).then(
    (response) => (response.ok ? response.text() : ''),
    () => '',
  );
  // Every script of the build ends with its exports.
  if (!/\bexport\s*\{[^{}]*\};?\s*$/.test(text)) return false;
  if (which === 'alone') return true;
  const imports = [...text.matchAll(/\b(?:from|import)\s*["'](\.[^"']+\.js)["']/g)].map(
    ([, file = '']) => new URL(file, address).href,
  );
  return (await Promise.all(imports.map((file) => isComplete(file, 'alone')))).every(Boolean);
}

/** Loads a style sheet; after a failure, tries again when the network returns. */
function loadStyleSheet(address: string): void {
  const link = Object.assign(document.createElement('link'), { rel: 'stylesheet', href: address });
  link.addEventListener('error', () => {
    link.remove();
    whenOnline(() => loadStyleSheet(address));
  });
  document.head.append(link);
}
