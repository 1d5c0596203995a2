// The module of the interpreter: fetched and compiled once for all elements of the page and all their workers.
//
// Out: the compiled module. It is fetched here and not by the worker, so that it is on its way before the
// worker's own script has come, and so that a preload of the page around is the same request. Must not know:
// what is in it, or who asks for it.

let compiled: Promise<WebAssembly.Module> | undefined;
/** A file that failed once may be in the browser's cache. */
let cache: RequestCache = 'default';

/** Rejected where it cannot be had, after which it can be tried again. */
export function coreModule(): Promise<WebAssembly.Module> {
  compiled ??= load().catch((reason: unknown) => {
    forgetCoreModule();
    throw reason;
  });
  return compiled;
}

/** The module cannot be used: the next caller has it fetched again. */
export function forgetCoreModule(): void {
  compiled = undefined;
  cache = 'reload';
}

async function load(): Promise<WebAssembly.Module> {
  const address = new URL('../../pkg/gcode_playground_bg.wasm', import.meta.url);
  // As `<link rel="preload" as="fetch" crossorigin>` asks for it: another way of asking would be another request.
  const response = await fetch(address, { mode: 'cors', credentials: 'same-origin', cache });
  if (!response.ok) throw new Error(`${address.href}: ${response.status}`);
  // A server that does not know wasm is no reason to give up.
  const streams = response.headers.get('content-type')?.startsWith('application/wasm') === true;
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
