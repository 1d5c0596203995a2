// The functions of the package in Node, without pauses. The module and its parts are read from the package at the first
// call.

import { readFileSync } from 'node:fs';
import * as functions from './functions.js';
import { initSync } from './gcode_playground.js';
import { PART_FILES } from './part-files.js';
import { addPart, isText } from './parts.js';

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

/** A function that runs a generator to its end. */
function now(work) {
  return (...args) => {
    if (functions.signalIn(args) !== undefined)
      throw new TypeError('there is no option `signal` in Node: a function returns when its work is done');
    load();
    const steps = work(...args);
    let step = steps.next();
    while (!step.done) step = steps.next();
    return step.value;
  };
}

export const check = now(functions.check);
export const motions = now(functions.motions);
export const svg = now(functions.svg);
export const summary = now(functions.summary);
export const part = now(functions.part);
export const expand = now(functions.expand);
export const repair = now(functions.repair);
export const format = now(functions.format);
export const renumber = now(functions.renumber);
export const convert = now(functions.convert);
export const diff = now(functions.diff);
export const clean = now(functions.clean);
