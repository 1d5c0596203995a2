// Loads the parts of the module that are loaded after the first picture: src/parts.rs.
//
// In: the exports of the module, and the files of a part (`part-files.js`). Out: the same module with the code and data
// of the part put into its memory and its table of functions.
import { partLoaded } from './gcode_playground.js';

/** What each module has been given: addresses of files, by the exports of the module. */
const given = new WeakMap();

/** Puts a part into a module, from its files and what they are compiled to. */
export function addPart(part, exports, files, compiled) {
  const before = given.get(exports) ?? new Set();
  given.set(exports, before);
  files.forEach((file, index) => {
    if (before.has(file)) return;
    new WebAssembly.Instance(compiled[index], { __wasm_split: exports });
    before.add(file);
  });
  partLoaded(part);
}

/** Files that are being fetched, or have been and are in no module yet. */
const fetched = new Map();
/** Files that could not be used: the browser's cache may hold what they were. */
const failedBefore = new Set();

/** Has the files of a part fetched, for a module that is still to come; one that cannot be had is tried again. */
export function fetchPart(files) {
  for (const file of files) compiled(file).catch(() => undefined);
}

/** Loads a part; rejected where one of its files cannot be had, after which it can be tried again. */
export async function loadPart(part, exports, files) {
  const before = given.get(exports);
  const missing = files.map((file) => (before?.has(file) === true ? undefined : compiled(file)));
  const modules = await Promise.all(missing);
  for (const file of files) fetched.delete(file);
  try {
    addPart(part, exports, files, modules);
  } catch (reason) {
    for (const file of files) failedBefore.add(file);
    throw reason;
  }
}

function compiled(file) {
  const before = fetched.get(file);
  if (before !== undefined) return before;
  const now = compiledFrom(file);
  fetched.set(file, now);
  now.catch(() => {
    fetched.delete(file);
    failedBefore.add(file);
  });
  return now;
}

async function compiledFrom(file) {
  const response = await fetch(file, { cache: failedBefore.has(file) ? 'reload' : 'default' });
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
