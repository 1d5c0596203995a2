// Renders the differences between two versions.
//
// In: the answer of the interpreter, with texts already in the user's language. Out: one element with blocks side by
// side, their effects, totals, messages and the drawing. Must not know: where it is shown.

import { make, prose } from '../dom/dom';
import type { Language } from '../dom/language';
import type { Differed, ProgramDifference } from '../protocol/protocol';
import { COMPARE_WORDS } from './compare-words';

type Hunk = ProgramDifference['hunks'][number];
type Row = Hunk['rows'][number];
type Change = Row['changes'][number];
type Later = Hunk['later'];
type Block = NonNullable<Row['first']>;
type Names = readonly [string, string];

/** Options for rendering the result. */
interface Shown {
  readonly names: Names;
  readonly language: Language;
  /** Called when the user clicks a line of the second version, from 1. */
  readonly goTo: (line: number) => void;
}

/** Further hunks are only counted: rendering them all would block the page. */
const MOST_HUNKS = 200;

export function result({ rows, drawing }: Differed, shownWith: Shown): HTMLElement {
  const { names, language } = shownWith;
  const texts = COMPARE_WORDS[language];
  const shown = make('div', { className: 'difference' });
  if (rows.readAs.length > 0) shown.append(changes(rows.readAs));
  for (const hunk of rows.hunks.slice(0, MOST_HUNKS)) shown.append(hunkShown(hunk, shownWith));
  const blocks = rows.hunks.slice(MOST_HUNKS).reduce((sum, hunk) => sum + hunk.rows.length, rows.moreBlocks);
  if (blocks > 0) shown.append(make('p', {}, texts.more(blocks)));
  if (rows.unexplained.blocks > 0)
    shown.append(later(rows.unexplained, texts.unexplained(rows.unexplained.blocks), shownWith));
  if (rows.sameText && rows.sameMotions) return shown;
  shown.append(make('h3', {}, texts.totals), totals(rows.totals, names, texts.what));
  shown.append(make('h3', {}, texts.part), part(rows, names, language));
  for (const [heading, found, which] of [
    [texts.gone, rows.gone, 'first'],
    [texts.new, rows.new, 'second'],
  ] as const) {
    if (found.length === 0) continue;
    const items = found.map(({ line, code, message }) =>
      make('li', {}, lineShown(which, line, texts.line(line), shownWith), `: ${code} `, ...prose(message)),
    );
    shown.append(make('h3', {}, heading), make('ul', {}, ...items));
  }
  const picture = drawn(drawing, `${texts.drawing}: ${names.join(', ')}`);
  if (picture !== undefined)
    shown.append(make('h3', {}, texts.drawing), make('div', { className: 'paths' }, picture), legend(names, language));
  return shown;
}

function hunkShown(hunk: Hunk, shownWith: Shown): HTMLElement {
  const { names, language } = shownWith;
  const texts = COMPARE_WORDS[language];
  const section = make('section', {});
  for (const row of hunk.rows) {
    section.append(
      make(
        'div',
        { className: 'pair' },
        block('first', row.first, names[0], shownWith),
        block('second', row.second, names[1], shownWith),
      ),
    );
    if (row.changes.length > 0) section.append(changes(row.changes));
  }
  const still = hunk.later.blocks === 0 && hunk.rows.every((row) => row.changes.length === 0);
  if (still) section.append(make('p', { className: 'still' }, texts.still));
  if (hunk.later.blocks > 0) section.append(later(hunk.later, texts.later(hunk.later.blocks), shownWith));
  return section;
}

function block(which: 'first' | 'second', own: Block | undefined, name: string, shownWith: Shown): HTMLElement {
  const texts = COMPARE_WORDS[shownWith.language];
  const tag = which === 'first' ? 'del' : 'ins';
  if (own === undefined)
    return make('div', { className: `block ${tag} none` }, make('span', { className: 'line' }, texts.noBlock));
  const line = make(
    'span',
    { className: 'line' },
    lineShown(which, own.line, `${name}, ${texts.line(own.line)}`, shownWith),
  );
  return make('div', { className: `block ${tag}` }, line, make(tag, {}, make('code', { lang: 'en' }, own.text)));
}

/** The line of a version; lines of the program on the page are links. */
function lineShown(which: 'first' | 'second', line: number, text: string, { goTo }: Shown): HTMLElement | string {
  if (which === 'first') return text;
  const button = make('button', { type: 'button', className: 'link' }, text);
  button.addEventListener('click', () => goTo(line));
  return button;
}

function changes(all: readonly Change[]): HTMLElement {
  return make('ul', { className: 'changes' }, ...all.map((change) => make('li', {}, told(change))));
}

function told({ name, first, second }: Change): string {
  return first === '' && second === '' ? name : `${name}: ${first} → ${second}`;
}

function later(all: Later, heading: string, shownWith: Shown): HTMLElement {
  const texts = COMPARE_WORDS[shownWith.language];
  const items = all.rows.map((row) => {
    const own = row.second ?? row.first;
    const code = make('code', { lang: 'en' }, own?.text ?? '');
    const line = lineShown(
      row.second === undefined ? 'first' : 'second',
      own?.line ?? 0,
      texts.line(own?.line ?? 0),
      shownWith,
    );
    return make('li', {}, line, ': ', code, ` · ${row.changes.map(told).join('; ')}`);
  });
  return make('div', { className: 'later' }, make('p', {}, heading), make('ul', {}, ...items));
}

function totals(rows: readonly Change[], names: Names, what: string): HTMLElement {
  const head = make('tr', {}, ...[what, ...names].map((text) => make('th', { scope: 'col' }, text)));
  const lines = rows.map(({ name, first, second }) =>
    make(
      'tr',
      { className: first === second ? '' : 'differs' },
      make('th', { scope: 'row' }, name),
      make('td', {}, first),
      make('td', {}, second),
    ),
  );
  return make('table', {}, make('thead', {}, head), make('tbody', {}, ...lines));
}

function part({ part: found }: ProgramDifference, names: Names, language: Language): HTMLElement {
  const texts = COMPARE_WORDS[language];
  if (found === undefined) return make('p', {}, texts.noPart);
  if (found.differences.length === 0) return make('p', {}, texts.samePart);
  const places = found.differences.map(({ only, radial, z }) => {
    const [from, to] = [radial.from.x, radial.to.x].map(shortened);
    const [back, front] = z.map(shortened);
    return make(
      'li',
      {},
      `${texts.onlyIn(only === 'first' ? names[0] : names[1])}: X${from} … X${to}, Z${back} … Z${front}`,
    );
  });
  return make('ul', {}, ...places);
}

function shortened(mm: number): string {
  return String(Number(mm.toFixed(4)));
}

/** The legend, in the text size of the page, since the drawing may be small. */
function legend(names: Names, language: Language): HTMLElement {
  const texts = COMPARE_WORDS[language];
  const entries = [
    ['first', texts.onlyIn(names[0])],
    ['second', texts.onlyIn(names[1])],
    ['both', texts.inBoth],
  ] as const;
  return make(
    'ul',
    { className: 'strokes' },
    ...entries.map(([owner, text]) => make('li', { className: owner }, text)),
  );
}

/** The drawing in the colours of the page, without its own style sheet and legend. */
function drawn(svg: string, label: string): Element | undefined {
  // The page's Content-Security-Policy blocks a style sheet as soon as it is parsed, so remove it before.
  const unstyled = svg.replace(/<style[^>]*>.*?<\/style>/gs, '');
  const parsed = new DOMParser().parseFromString(unstyled, 'image/svg+xml').documentElement;
  if (parsed.localName !== 'svg') return undefined;
  for (const title of parsed.querySelectorAll('title')) title.remove();
  for (const text of parsed.querySelectorAll('text.legend')) {
    text.previousElementSibling?.remove();
    text.remove();
  }
  for (const inner of parsed.querySelectorAll('svg')) inner.setAttribute('role', 'presentation');
  parsed.setAttribute('aria-label', label);
  parsed.removeAttribute('width');
  parsed.removeAttribute('height');
  return document.importNode(parsed, true);
}
