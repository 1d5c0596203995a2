// The interpreter in Node: functions of a text, without configuration.
//
// In: a program, a setup. Out: its messages, its motions, its drawing, its part; the program written in another way;
// differences, other programs. The module and its parts are read from the package at the first call. Must not know: the
// page or the element.

import { readFileSync } from 'node:fs';
import { initSync, PastedText, Playground } from './gcode_playground.js';
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

/** As `withRun`, with all material removed. */
function withPart(text, setup, options, use) {
  return withRun(text, setup, options, (playground) => {
    while (!playground.removeMaterial(AT_ONCE));
    return use(playground);
  });
}

export function check(text, setup, options) {
  return withPart(text, setup, options, (playground) => playground.diagnosticsAsWritten());
}

export function motions(text, setup, options) {
  return withRun(text, setup, options, (playground) => playground.motions(0, playground.summary().motions));
}

export function svg(text, setup, options) {
  return withPart(text, setup, options, (playground) => new TextDecoder().decode(playground.exportFile('svg')));
}

export function summary(text, setup, options) {
  return withPart(text, setup, options, (playground) => playground.summary());
}

export function part(text, setup, options) {
  return withPart(text, setup, options, (playground) => playground.part());
}

export function expand(text, setup, options) {
  return withRun(text, setup, options, (playground) => playground.expand());
}

export function repair(text, setup, options) {
  return withRun(text, setup, options, (playground) => playground.repaired());
}

export function format(text, setup, options) {
  return withRun(text, setup, options, (playground) => changed(textOf(text), playground.formatted(), 'formatted'));
}

export function renumber(text, { from = 10, step = 10, blocks = 'numbered' } = {}, setup, options) {
  for (const [name, value] of Object.entries({ from, step }))
    if (!Number.isInteger(value) || value < 1) throw new RangeError(`\`${name}\` is a whole number from 1 on`);
  return withRun(text, setup, options, (playground) =>
    changed(textOf(text), playground.renumbered(from, step, blocks), 'renumbered'),
  );
}

export function diff(before, after, setup, options) {
  return withPart(before, setup, options, (first) =>
    withPart(after, setup, options, (second) => second.differenceFrom(first)),
  );
}

export function clean(text, options) {
  const { language } = checked(options);
  load();
  const pasted = new PastedText(textOf(text));
  try {
    return pasted.programs().programs.map((_, index) => {
      const pieces = pasted.pieces(index, language);
      return pieces.map(({ now, choices }) => choices[0] ?? now).join('');
    });
  } finally {
    pasted.free();
  }
}

function textOf(text) {
  return typeof text === 'string' ? text : new TextDecoder('utf-8', { ignoreBOM: true }).decode(text);
}

/** The text with the edits of an answer. Throws the reason if the program stays as it is. */
function changed(text, answer, action) {
  if (answer.kind === 'refused') {
    const place = answer.line === undefined ? '' : `line ${answer.line}: `;
    throw new Error(`${place}not ${action}: ${answer.reason}`);
  }
  const indexOf = indices(text);
  let [written, end] = ['', 0];
  for (const { from, to, text: inserted } of answer.edits) {
    written += text.slice(end, indexOf(from)) + inserted;
    end = indexOf(to);
  }
  return written + text.slice(end);
}

/** Converts ascending offsets of edits, which count CR LF as one unit, to indices of the text. */
function indices(text) {
  let [index, offset] = [0, 0];
  return (wanted) => {
    for (; offset < wanted; offset++) index += text.startsWith('\r\n', index) ? 2 : 1;
    return index;
  };
}
