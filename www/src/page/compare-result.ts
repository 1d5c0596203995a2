// Renders the differences between two versions.
//
// In: the answer of the interpreter, with texts already in the user's language. Out: one element with blocks side by
// side, their effects, totals, messages and the drawing. Must not know: where it is shown.

import { make, renderProse } from '../dom/dom';
import type { Language } from '../dom/language';
import type { DifferenceResult, ProgramDifference } from '../protocol/protocol';
import { COMPARE_WORDS } from './compare-words';

type Hunk = ProgramDifference['hunks'][number];
type Row = Hunk['rows'][number];
type Change = Row['changes'][number];
type Later = Hunk['later'];
type Block = NonNullable<Row['first']>;
type Names = readonly [string, string];

/** Options for rendering the result. */
interface RenderOptions {
  readonly names: Names;
  readonly language: Language;
  /** Called with the 1-based line that the user clicked in the second version. */
  readonly goTo: (line: number) => void;
}

/** Maximum number of hunks that are rendered; the rest are only counted, because rendering all would block the page. */
const MAX_HUNKS = 200;

export function renderResult({ rows, drawing }: DifferenceResult, options: RenderOptions): HTMLElement {
  const { names, language } = options;
  const texts = COMPARE_WORDS[language];
  const shown = make('div', { className: 'difference' });
  if (rows.readAs.length > 0) shown.append(renderChanges(rows.readAs));
  for (const hunk of rows.hunks.slice(0, MAX_HUNKS)) shown.append(renderHunk(hunk, options));
  const blocks = rows.hunks.slice(MAX_HUNKS).reduce((sum, hunk) => sum + hunk.rows.length, rows.moreBlocks);
  if (blocks > 0) shown.append(make('p', {}, texts.more(blocks)));
  // Unchanged blocks whose motions differ although no hunk can be the cause.
  if (rows.unexplained.blocks > 0)
    shown.append(renderLater(rows.unexplained, texts.unexplained(rows.unexplained.blocks), options));
  if (rows.sameText && rows.sameMotions) return shown;
  shown.append(make('h3', {}, texts.totals), renderTotals(rows.totals, names, texts.what));
  shown.append(make('h3', {}, texts.part), renderPart(rows, names, language));
  for (const [heading, found, which] of [
    [texts.gone, rows.gone, 'first'],
    [texts.new, rows.new, 'second'],
  ] as const) {
    if (found.length === 0) continue;
    const items = found.map(({ line, code, message }) =>
      make('li', {}, renderLine(which, line, texts.line(line), options), `: ${code} `, ...renderProse(message)),
    );
    shown.append(make('h3', {}, heading), make('ul', {}, ...items));
  }
  const picture = renderDrawing(drawing, `${texts.drawing}: ${names.join(', ')}`);
  if (picture !== undefined)
    shown.append(
      make('h3', {}, texts.drawing),
      make('div', { className: 'paths' }, picture),
      renderLegend(names, language),
    );
  return shown;
}

function renderHunk(hunk: Hunk, options: RenderOptions): HTMLElement {
  const { names, language } = options;
  const texts = COMPARE_WORDS[language];
  const section = make('section', {});
  for (const row of hunk.rows) {
    section.append(
      make(
        'div',
        { className: 'pair' },
        renderBlock('first', row.first, names[0], options),
        renderBlock('second', row.second, names[1], options),
      ),
    );
    if (row.changes.length > 0) section.append(renderChanges(row.changes));
  }
  const isMotionUnchanged = hunk.later.blocks === 0 && hunk.rows.every((row) => row.changes.length === 0);
  if (isMotionUnchanged) section.append(make('p', { className: 'still' }, texts.still));
  if (hunk.later.blocks > 0) section.append(renderLater(hunk.later, texts.later(hunk.later.blocks), options));
  return section;
}

function renderBlock(
  which: 'first' | 'second',
  version: Block | undefined,
  name: string,
  options: RenderOptions,
): HTMLElement {
  const texts = COMPARE_WORDS[options.language];
  const tag = which === 'first' ? 'del' : 'ins';
  if (version === undefined)
    return make('div', { className: `block ${tag} none` }, make('span', { className: 'line' }, texts.noBlock));
  const line = make(
    'span',
    { className: 'line' },
    renderLine(which, version.line, `${name}, ${texts.line(version.line)}`, options),
  );
  return make('div', { className: `block ${tag}` }, line, make(tag, {}, make('code', { lang: 'en' }, version.text)));
}

/** The line of a version. For the second version, which is on the page, it is a button that goes to the line. */
function renderLine(
  which: 'first' | 'second',
  line: number,
  text: string,
  { goTo }: RenderOptions,
): HTMLElement | string {
  if (which === 'first') return text;
  const button = make('button', { type: 'button', className: 'link' }, text);
  button.addEventListener('click', () => goTo(line));
  return button;
}

function renderChanges(changes: readonly Change[]): HTMLElement {
  return make('ul', { className: 'changes' }, ...changes.map((change) => make('li', {}, describeChange(change))));
}

function describeChange({ name, first, second }: Change): string {
  return first === '' && second === '' ? name : `${name}: ${first} → ${second}`;
}

function renderLater(later: Later, heading: string, options: RenderOptions): HTMLElement {
  const texts = COMPARE_WORDS[options.language];
  const items = later.rows.map((row) => {
    const version = row.second ?? row.first;
    const code = make('code', { lang: 'en' }, version?.text ?? '');
    const line = renderLine(
      row.second === undefined ? 'first' : 'second',
      version?.line ?? 0,
      texts.line(version?.line ?? 0),
      options,
    );
    return make('li', {}, line, ': ', code, ` · ${row.changes.map(describeChange).join('; ')}`);
  });
  return make('div', { className: 'later' }, make('p', {}, heading), make('ul', {}, ...items));
}

function renderTotals(rows: readonly Change[], names: Names, what: string): HTMLElement {
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

function renderPart({ part }: ProgramDifference, names: Names, language: Language): HTMLElement {
  const texts = COMPARE_WORDS[language];
  if (part === undefined) return make('p', {}, texts.noPart);
  if (part.differences.length === 0) return make('p', {}, texts.samePart);
  const places = part.differences.map(({ only, radial, z }) => {
    const [from, to] = [radial.from.x, radial.to.x].map(roundMm);
    const [back, front] = z.map(roundMm);
    return make(
      'li',
      {},
      `${texts.onlyIn(only === 'first' ? names[0] : names[1])}: X${from} … X${to}, Z${back} … Z${front}`,
    );
  });
  return make('ul', {}, ...places);
}

function roundMm(mm: number): string {
  return String(Number(mm.toFixed(4)));
}

/** The legend, in the text size of the page, since the drawing may be small. */
function renderLegend(names: Names, language: Language): HTMLElement {
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
function renderDrawing(svg: string, label: string): Element | undefined {
  // The page's Content-Security-Policy blocks a style sheet as soon as it is parsed, so remove it before.
  const unstyled = svg.replace(/<style[^>]*>.*?<\/style>/gs, '');
  const parsed = new DOMParser().parseFromString(unstyled, 'image/svg+xml').documentElement;
  if (parsed.localName !== 'svg') return undefined;
  for (const title of parsed.querySelectorAll('title')) title.remove();
  for (const text of parsed.querySelectorAll('text.legend')) {
    // The sample that the text explains.
    text.previousElementSibling?.remove();
    text.remove();
  }
  for (const inner of parsed.querySelectorAll('svg')) inner.setAttribute('role', 'presentation');
  parsed.setAttribute('aria-label', label);
  parsed.removeAttribute('width');
  parsed.removeAttribute('height');
  return document.importNode(parsed, true);
}
