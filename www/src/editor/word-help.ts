// Help at the word: what it is, its value, and what is known of it, as an element.
//
// In: an answer of the interpreter. Out: a line, or that with the facts; a fact that names another block is a button that
// leads there. Must not know: what a word means.

import { make } from '../dom/dom';
import type { HelpLine, WordHelp } from '../protocol/protocol';

/** The word, what it is, its value. */
export function wordLine({ word, title, value }: WordHelp): HTMLElement {
  const line = make(
    'span',
    { className: 'word-line' },
    make('code', { lang: 'en' }, word),
    ' ',
    make('span', { className: 'word-title' }, title),
  );
  if (value !== undefined) line.append(' ', make('span', { className: 'word-value' }, value));
  return line;
}

/** What is known of it; `go`: the reader wants to see the block at an offset. */
export function factList(facts: readonly HelpLine[], go: (offset: number) => void): HTMLElement {
  return make(
    'ul',
    { className: 'word-facts' },
    ...facts.map(({ text, at }) => make('li', {}, at === undefined ? text : linked(text, at, go))),
  );
}

/** All of it, for a tooltip. */
export function wordCard(help: WordHelp, go: (offset: number) => void): HTMLElement {
  return make(
    'div',
    { className: 'word-card' },
    wordLine(help),
    ...(help.facts.length === 0 ? [] : [factList(help.facts, go)]),
  );
}

function linked(text: string, offset: number, go: (offset: number) => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'to-block' }, text);
  button.addEventListener('click', () => go(offset));
  return button;
}
