// HTML and Markdown that embed a program in another web page.
//
// In: a program with its context, and addresses. Out: text to copy, with the program escaped. Must not know: where the
// text is pasted.

import type { Shared } from '../files/shared-link';
import { plainTextLink } from '../files/plain-text-link';

/** The element with its program in a `pre`, which is readable without JavaScript. */
export function elementText(shared: Shared, script: string): string {
  const { text, control, setup, blockSkip, program, language, view, step, readonly } = shared;
  const values = [
    ['view', view],
    ['control', control],
    ['block-skip', blockSkip],
    ['program', program],
    ['language', language],
    ['step', step],
    ['setup', setup],
  ] as const;
  const attributes = values
    .flatMap(([name, value]) => (value === null ? [] : [` ${name}="${escapeHtml(value)}"`]))
    .join('');
  // HTML ignores the line end after `<pre>`.
  return `<script type="module" src="${escapeHtml(script)}"></script>\n<gcode-playground${attributes}${readonly ? ' readonly' : ''}><pre>\n${escapeHtml(text)}\n</pre></gcode-playground>\n`;
}

/** An `iframe` with the page that contains one element, for platforms that allow no scripts. */
export function frameText(shared: Shared, page: string, title: string): string {
  return `<iframe sandbox="allow-scripts allow-popups allow-popups-to-escape-sandbox" title="${escapeHtml(title)}" width="100%" height="480"\n  src="${escapeHtml(`${page}#${plainTextLink(shared)}`)}"></iframe>\n`;
}

/** A Markdown link; the characters of `title` that could end it are escaped. */
export function markdownText(title: string, link: string): string {
  return `[${title.replace(/\s+/g, ' ').replace(/[\\[\]<>*_`]/g, '\\$&')}](<${link}>)`;
}

/** Escapes a text for HTML and XML, also inside double quotes. */
export function escapeHtml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
}
