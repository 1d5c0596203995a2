// The WebAssembly module of the interpreter: fetched and compiled once for all elements of the page and all their
// workers.
//
// Out: the compiled module. The page fetches it, not the worker, so that the request starts before the worker's script
// is loaded, and so that a preload of the page is the same request. Must not know: the content of the module, or its
// users.

let compiled: Promise<WebAssembly.Module> | undefined;
/** `reload` after a failure: a faulty file may be in the browser's cache. */
let cache: RequestCache = 'default';

/** The compiled module. Rejected if it cannot be loaded; the next call retries. */
export function coreModule(): Promise<WebAssembly.Module> {
  compiled ??= load().catch((reason: unknown) => {
    discardCoreModule();
    throw reason;
  });
  return compiled;
}

/** Call this if the module is unusable: the next caller fetches it again. */
export function discardCoreModule(): void {
  compiled = undefined;
  cache = 'reload';
}

async function load(): Promise<WebAssembly.Module> {
  const address = new URL('../../pkg/gcode_playground_bg.wasm', import.meta.url);
  // Must match `<link rel="preload" as="fetch" crossorigin>`, otherwise the browser sends a second request.
  const response = await fetch(address, { mode: 'cors', credentials: 'same-origin', cache });
  if (!response.ok) throw new Error(`${address.href}: ${response.status}`);
  // Some servers send another content type for wasm; streaming compilation would reject it.
  const canStream = response.headers.get('content-type')?.startsWith('application/wasm') === true;
  return canStream ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
