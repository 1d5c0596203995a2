// Writes a plain-text link: `program=…&setup=…`, percent-encoded, version 0 of `shared-link.ts`.
//
// In: a program with its context. Out: the part of an address after `#`, for the playground and for the page with a
// single element. Must not know: which of them reads it.

import type { Shared } from './shared-link';

type PlainTextFields = Pick<
  Shared,
  'text' | 'setup' | 'control' | 'blockSkip' | 'program' | 'language' | 'view' | 'step' | 'readonly'
>;

export function plainTextLink(shared: PlainTextFields): string {
  const { text, control, blockSkip, language, view, step, readonly } = shared;
  const entries = [
    ['view', view],
    ['control', control],
    ['block-skip', blockSkip],
    ['language', language],
    ['step', step],
    ['readonly', readonly ? '' : null],
    ['setup', setupWithProgram(shared)],
    ['program', text],
  ] as const;
  return entries.flatMap(([name, value]) => (value === null ? [] : [`${name}=${percentEncode(value)}`])).join('&');
}

/** Percent-encodes a text. A lone surrogate, which no address can contain, becomes U+FFFD. */
function percentEncode(text: string): string {
  return encodeURIComponent(
    text.replace(/[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g, '\ufffd'),
  );
}

/** Puts the O number into the setup: in an address, `program` is the text. */
function setupWithProgram({ setup, program }: PlainTextFields): string | null {
  if (program === null) return setup;
  try {
    const parsed: unknown = JSON.parse(setup ?? '{}');
    if (typeof parsed === 'object' && parsed !== null && !Array.isArray(parsed))
      return JSON.stringify({ ...parsed, program: /^\d+$/.test(program) ? Number(program) : program });
  } catch {
    // The interpreter reports what is wrong with it.
  }
  return setup;
}
