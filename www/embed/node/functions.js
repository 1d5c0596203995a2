// The functions of the package: generators, which yield where a long run can pause.
//
// In: a program, a setup. Out: its messages, its motions, its drawing, its part; the program written in another way;
// differences, other programs. The module and its parts must be loaded. Must not know: files, the page or the element.

import { PastedText, Playground } from './gcode_playground.js';

/** Blocks that are run, and motions that are simulated, without a pause. */
const [BLOCKS, MOTIONS] = [20_000, 20];

const LANGUAGES = ['en', 'zh', 'ru'];

/** The signal in the arguments of a function. */
export function signalIn(args) {
  return args.map((arg) => Object(arg).signal).find((signal) => signal instanceof AbortSignal);
}

/** The options with defaults. Throws if one is unknown. */
function checked(options = {}) {
  if (typeof options !== 'object' || options === null) throw new TypeError('the options are an object');
  const { language = 'en', signal, ...others } = options;
  const [other] = Object.keys(others);
  if (other !== undefined)
    throw new TypeError(`there is no option \`${other}\`; there are \`language\` and, in browsers, \`signal\``);
  if (!LANGUAGES.includes(language))
    throw new RangeError(`there is no language \`${language}\`; there are ${LANGUAGES.join(', ')}`);
  return { language, signal };
}

/** A program that has run, with all material removed if `hasPart`. The caller frees it. */
function* opened(text, setup, options, hasPart) {
  if (typeof text !== 'string' && !(text instanceof Uint8Array))
    throw new TypeError('the program is a string or a Uint8Array');
  const { language, signal } = checked(options);
  signal?.throwIfAborted();
  const playground = new Playground();
  let isReady = false;
  try {
    playground.setLanguage(language);
    playground.setSetup(typeof setup === 'string' ? setup : JSON.stringify(setup ?? {}));
    if (typeof text === 'string') playground.setText(text);
    else playground.setBytes(text);
    const work = [() => playground.advance(BLOCKS), ...(hasPart ? [() => playground.removeMaterial(MOTIONS)] : [])];
    for (const advance of work)
      while (!advance()) {
        yield;
        signal?.throwIfAborted();
      }
    isReady = true;
    return playground;
  } finally {
    if (!isReady) playground.free();
  }
}

/** Runs a program, passes it to `use`, and frees it. */
function* withRun(text, setup, options, use, hasPart = false) {
  const playground = yield* opened(text, setup, options, hasPart);
  try {
    return use(playground);
  } finally {
    playground.free();
  }
}

/** As `withRun`, with all material removed. */
function withPart(text, setup, options, use) {
  return withRun(text, setup, options, use, true);
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

export function convert(text, form, setup, options) {
  return withRun(text, setup, options, (playground) => {
    const answer = playground.converted(form);
    return { text: changed(textOf(text), answer, 'converted'), left: answer.left, firstLeft: answer.firstLeft };
  });
}

export function* diff(before, after, setup, options) {
  const first = yield* opened(before, setup, options, true);
  try {
    return yield* withPart(after, setup, options, (second) => second.differenceFrom(first));
  } finally {
    first.free();
  }
}

export function* clean(text, options) {
  const { language, signal } = checked(options);
  signal?.throwIfAborted();
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
