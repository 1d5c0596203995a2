// Loads the parts of the module that are needed after the first picture: src/parts.rs.
//
// In: the exports of the module, and the files of a part or a language (`part-files.js`). Out: the same module with the
// code and data of the part added to its memory and its function table, or with the texts of the language.
import { partLoaded, textsLoaded } from './gcode_playground.js';

/** The file addresses already added to each module, by the exports of the module. */
const given = new WeakMap();

/** Adds a part to a module, from its files and their contents. */
export function addPart(part, exports, files, contents) {
  const before = given.get(exports) ?? new Set();
  given.set(exports, before);
  files.forEach((file, index) => {
    if (before.has(file)) return;
    const content = contents[index];
    if (typeof content === 'string') {
      if (!textsLoaded(part, content)) throw new Error(`${file}: other texts`);
    } else new WebAssembly.Instance(content, { __wasm_split: exports });
    before.add(file);
  });
  partLoaded(part);
}

/** Whether a file contains texts; all others are WebAssembly. */
export function isText(file) {
  return new URL(file).pathname.endsWith('.txt');
}

/** Files that are being fetched, or are fetched but not yet part of a module. */
const fetched = new Map();
/** Files that could not be used: the browser may have cached an old version. */
const failedBefore = new Set();

/** Starts fetching the files of a part before the module exists. A file that fails is fetched again later. */
export function fetchPart(files) {
  for (const file of files) contentOf(file).catch(() => undefined);
}

/** Loads a part. Rejects if one of its files cannot be loaded; it can then be called again. */
export async function loadPart(part, exports, files) {
  const before = given.get(exports);
  const missing = files.map((file) => (before?.has(file) === true ? undefined : contentOf(file)));
  const contents = await Promise.all(missing);
  for (const file of files) fetched.delete(file);
  try {
    addPart(part, exports, files, contents);
  } catch (reason) {
    for (const file of files) failedBefore.add(file);
    throw reason;
  }
}

function contentOf(file) {
  const before = fetched.get(file);
  if (before !== undefined) return before;
  const now = fetchContent(file);
  fetched.set(file, now);
  now.catch(() => {
    fetched.delete(file);
    failedBefore.add(file);
  });
  return now;
}

async function fetchContent(file) {
  const response = await fetch(file, { cache: failedBefore.has(file) ? 'reload' : 'default' });
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return isText(file) ? response.text() : WebAssembly.compile(await response.arrayBuffer());
}
