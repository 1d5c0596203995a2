// A program in an address in plain text: `program=…&setup=…`, percent-encoded, as `shared-link.ts` describes version 0.
//
// In: a program with its context. Out: the part of an address after `#`, for the playground and for the page that is one
// element. Must not know: which of them reads it.

import type { Shared } from './shared-link';

export type Written = Pick<
  Shared,
  'text' | 'setup' | 'control' | 'blockSkip' | 'program' | 'language' | 'view' | 'step' | 'readonly'
>;

export function writtenLink(shared: Written): string {
  const { text, control, blockSkip, language, view, step, readonly } = shared;
  const said = [
    ['view', view],
    ['control', control],
    ['block-skip', blockSkip],
    ['language', language],
    ['step', step],
    ['readonly', readonly ? '' : null],
    ['setup', setupWithProgram(shared)],
    ['program', text],
  ] as const;
  return said.flatMap(([name, value]) => (value === null ? [] : [`${name}=${encoded(value)}`])).join('&');
}

/** Half of a pair, which no address can hold, becomes the sign for what cannot be shown. */
function encoded(text: string): string {
  return encodeURIComponent(
    text.replace(/[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g, '\ufffd'),
  );
}

/** `program` is the text in an address: the O number stands in the setup. */
function setupWithProgram({ setup, program }: Written): string | null {
  if (program === null) return setup;
  try {
    const parsed: unknown = JSON.parse(setup ?? '{}');
    if (typeof parsed === 'object' && parsed !== null && !Array.isArray(parsed))
      return JSON.stringify({ ...parsed, program: /^\d+$/.test(program) ? Number(program) : program });
  } catch {
    // The interpreter says what is wrong with it.
  }
  return setup;
}
