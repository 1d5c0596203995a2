// The interpreter in Node: three functions of a text, without configuration.
//
// In: a program, a setup. Out: its messages, its motions, its drawing. The module and its parts are read from the
// package at the first call. Must not know: the page or the element.

import { readFileSync } from 'node:fs';
import { initSync, Playground } from './gcode_playground.js';
import { PART_FILES } from './part-files.js';
import { addPart, isText } from './parts.js';

/** Blocks to run, and motions to simulate, in one call. */
const AT_ONCE = 1_000_000;

let isLoaded = false;

/** Loads the module with all its parts, once. */
function load() {
  if (isLoaded) return;
  const read = (address) =>
    isText(address) ? readFileSync(new URL(address), 'utf8') : new WebAssembly.Module(readFileSync(new URL(address)));
  const wasm = initSync({ module: read(new URL('../core.wasm', import.meta.url)) });
  for (const [part, files] of Object.entries(PART_FILES)) addPart(part, wasm, files, files.map(read));
  isLoaded = true;
}

const LANGUAGES = ['en', 'zh', 'ru'];

/** The options with defaults. Throws if one is unknown. */
function checked(options = {}) {
  if (typeof options !== 'object' || options === null) throw new TypeError('the options are an object');
  const { language = 'en', ...others } = options;
  const [other] = Object.keys(others);
  if (other !== undefined) throw new TypeError(`there is no option \`${other}\`; there is \`language\``);
  if (!LANGUAGES.includes(language))
    throw new RangeError(`there is no language \`${language}\`; there are ${LANGUAGES.join(', ')}`);
  return { language };
}

/** Runs a program, passes it to `use`, and frees it. */
function withRun(text, setup, options, use) {
  if (typeof text !== 'string' && !(text instanceof Uint8Array))
    throw new TypeError('the program is a string or a Uint8Array');
  const { language } = checked(options);
  load();
  const playground = new Playground();
  try {
    playground.setLanguage(language);
    playground.setSetup(typeof setup === 'string' ? setup : JSON.stringify(setup ?? {}));
    if (typeof text === 'string') playground.setText(text);
    else playground.setBytes(text);
    while (!playground.advance(AT_ONCE));
    return use(playground);
  } finally {
    playground.free();
  }
}

export function check(text, setup, options) {
  return withRun(text, setup, options, (playground) => {
    while (!playground.removeMaterial(AT_ONCE));
    return playground.diagnosticsAsWritten();
  });
}

export function motions(text, setup, options) {
  return withRun(text, setup, options, (playground) => playground.motions(0, playground.summary().motions));
}

export function svg(text, setup, options) {
  return withRun(text, setup, options, (playground) => {
    while (!playground.removeMaterial(AT_ONCE));
    return new TextDecoder().decode(playground.exportFile('svg'));
  });
}
