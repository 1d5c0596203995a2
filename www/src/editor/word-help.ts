// Renders the help for a word: its meaning, its value, and facts about it.
//
// In: an answer of the interpreter. Out: a line, or the line with the facts; a fact that refers to another block is a
// button that leads there. Must not know: the meaning of a word.

import { make, renderUnbroken } from '../dom/dom';
import type { HelpLine, WordHelp } from '../protocol/protocol';

/** The word, its value and its meaning. */
export function wordLine({ word, title, value }: WordHelp): HTMLElement {
  const line = make(
    'span',
    { className: 'word-line' },
    make('code', { lang: 'en' }, word),
    ' ',
    ...(value === undefined ? [] : [make('span', { className: 'word-value' }, ...renderUnbroken(value)), ' ']),
    make('span', { className: 'word-title' }, ...renderUnbroken(title)),
  );
  return line;
}

/** The facts about a word; `go` is called to show the block at an offset. */
export function factList(facts: readonly HelpLine[], go: (offset: number) => void): HTMLElement {
  return make(
    'ul',
    { className: 'word-facts' },
    ...facts.map(({ text, at }) =>
      make('li', {}, ...(at === undefined ? renderUnbroken(text) : [linkButton(text, at, go)])),
    ),
  );
}

/** The line and the facts, for a tooltip. */
export function wordCard(help: WordHelp, go: (offset: number) => void): HTMLElement {
  return make(
    'div',
    { className: 'word-card' },
    wordLine(help),
    ...(help.facts.length === 0 ? [] : [factList(help.facts, go)]),
  );
}

function linkButton(text: string, offset: number, go: (offset: number) => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'link' }, ...renderUnbroken(text));
  button.addEventListener('click', () => go(offset));
  return button;
}
