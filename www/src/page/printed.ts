// Pages to print, as files: a heading and tables, without scripts.
//
// In: texts. Out: HTML, and links that save a file. Must not know: the purpose of a page.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';

const STYLE =
  'body{font:16px system-ui;margin:2cm}table{border-collapse:collapse}table>*>*>*{padding:.3em 1em;border:1px solid;text-align:start;vertical-align:top}@page{margin:1cm}';

/** An HTML page with a heading. */
export function printedPage(title: string, language: Language, ...content: readonly HTMLElement[]): string {
  const heading = make('h1', {}, title);
  const name = make('title', {}, title);
  const body = content.map((element) => element.outerHTML).join('');
  return `<!doctype html><html lang="${language}"><meta charset="utf-8">${name.outerHTML}<style>${STYLE}</style>${heading.outerHTML}${body}</html>`;
}

export function printedTable(head: readonly string[], rows: readonly (readonly string[])[]): HTMLElement {
  const cells = (kind: 'th' | 'td', row: readonly string[]): HTMLElement =>
    make('tr', {}, ...row.map((text) => make(kind, {}, text)));
  return make(
    'table',
    {},
    make('thead', {}, cells('th', head)),
    make('tbody', {}, ...rows.map((row) => cells('td', row))),
  );
}

/** Sets the file that a link with `download` saves. */
export function setFile(link: HTMLAnchorElement, content: BlobPart, type: string): void {
  URL.revokeObjectURL(link.href);
  link.href = URL.createObjectURL(new Blob([content], { type }));
}
