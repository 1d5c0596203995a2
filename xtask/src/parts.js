// The parts of the module that are loaded after the first picture: src/parts.rs.
//
// In: the exports of the module. Out: the same module with the code and data of a part put into its memory
// and its table of functions. Made by `cargo xtask`, which fills in the files.
import { partLoaded } from './gcode_playground.js';

/** The files of each part, by its name; one that two parts need is in both lists. */
export const PART_FILES = {
  /* FILES */
};

/** What each module has been given: files, by the exports of the module. */
const given = new WeakMap();

/** Puts a part into a module, from its compiled files, in the order of `PART_FILES`. */
export function addPart(part, exports, compiled) {
  const files = given.get(exports) ?? new Set();
  given.set(exports, files);
  PART_FILES[part].forEach((file, index) => {
    if (files.has(file.href)) return;
    new WebAssembly.Instance(compiled[index], { __wasm_split: exports });
    files.add(file.href);
  });
  partLoaded(part);
}

/** Files that are being fetched, or have been and are in no module yet. */
const fetched = new Map();

/** Has the files of a part fetched, for a module that is still to come; one that cannot be had is tried again. */
export function fetchPart(part) {
  for (const file of PART_FILES[part]) compiled(file).catch(() => undefined);
}

/** Loads a part; rejected where one of its files cannot be had, after which it can be tried again. */
export async function loadPart(part, exports) {
  const files = given.get(exports);
  const missing = PART_FILES[part].map((file) => (files?.has(file.href) === true ? undefined : compiled(file)));
  addPart(part, exports, await Promise.all(missing));
  for (const file of PART_FILES[part]) fetched.delete(file.href);
}

function compiled(file) {
  const before = fetched.get(file.href);
  if (before !== undefined) return before;
  const now = compiledFrom(file);
  fetched.set(file.href, now);
  now.catch(() => fetched.delete(file.href));
  return now;
}

async function compiledFrom(file) {
  const response = await fetch(file);
  if (!response.ok) throw new Error(`${file.href}: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
