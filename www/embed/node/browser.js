// The functions of the package in browsers and their workers: promises, with pauses in which the thread does other work.
// The module and its parts are fetched from the package at the first call.

import * as functions from './functions.js';
import init from './gcode_playground.js';
import { PART_FILES } from './part-files.js';
import { fetchPart, loadPart } from './parts.js';

/** Time without a pause, ms: less than a frame. */
const BUSY = 12;

let loading;

/** Loads the module with all its parts, once. After a failure, the next call tries again. */
function load() {
  loading ??= fetched().catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

async function fetched() {
  for (const files of Object.values(PART_FILES)) fetchPart(files);
  const wasm = await init();
  for (const [part, files] of Object.entries(PART_FILES)) await loadPart(part, wasm, files);
}

/** The result of a promise, or the rejection by a signal before. */
async function unlessAborted(promise, signal) {
  signal?.throwIfAborted();
  let end;
  const aborted = new Promise((_, reject) => {
    end = () => reject(signal.reason);
    signal?.addEventListener('abort', end);
  });
  try {
    return await Promise.race([promise, aborted]);
  } finally {
    signal?.removeEventListener('abort', end);
  }
}

/** A function that does the work of a generator in slices. */
function later(work) {
  return async (...args) => {
    await unlessAborted(load(), functions.signalIn(args));
    const steps = work(...args);
    for (let begun = performance.now(); ; ) {
      const { done, value } = steps.next();
      if (done) return value;
      if (performance.now() - begun < BUSY) continue;
      await new Promise((resolve) => setTimeout(resolve));
      begun = performance.now();
    }
  };
}

export const check = later(functions.check);
export const motions = later(functions.motions);
export const svg = later(functions.svg);
export const summary = later(functions.summary);
export const part = later(functions.part);
export const expand = later(functions.expand);
export const repair = later(functions.repair);
export const format = later(functions.format);
export const renumber = later(functions.renumber);
export const convert = later(functions.convert);
export const diff = later(functions.diff);
export const clean = later(functions.clean);
