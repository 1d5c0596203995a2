// Programs of a page that are made elements in their places: `<script type="text/x-gcode" data-gcode-playground>` and
// `<pre data-gcode-playground>`. Where Markdown is written, these are the tags that hold a program with blank lines.
//
// In: a part of a page. Out: around each such program an element, with the attributes that are written as `data-…`.
// Must not know: what an attribute means.

import { whenParsed } from './parsed';
import { PROGRAM_SCRIPT } from './source';

const TAG = 'gcode-playground';
const MARK = 'data-gcode-playground';
const MARKED = `${PROGRAM_SCRIPT}[${MARK}], pre[${MARK}]`;

/** Those of the element and no others: `data-onclick` must stay what it is. */
export type Attributes = readonly string[];

export function upgradeIn(root: ParentNode, attributes: Attributes): void {
  const found = [...root.querySelectorAll(MARKED)];
  if (root instanceof Element && root.matches(MARKED)) found.push(root);
  for (const marked of found) whenParsed(marked, () => putAround(marked, attributes));
}

/** Those of the page, and those that come while the page is read. */
export function upgradeThePage(attributes: Attributes): void {
  const upgrade = (): void => upgradeIn(document, attributes);
  upgrade();
  if (document.readyState !== 'loading') return;
  const observer = new MutationObserver(upgrade);
  observer.observe(document, { childList: true, subtree: true });
  document.addEventListener('DOMContentLoaded', () => {
    observer.disconnect();
    upgrade();
  });
}

function putAround(marked: Element, attributes: Attributes): void {
  const { parentNode, nextSibling } = marked;
  if (parentNode === null || marked.closest(TAG) !== null) return;
  const element = document.createElement(TAG);
  for (const name of attributes) {
    const value = marked.getAttribute(`data-${name}`);
    if (value !== null) element.setAttribute(name, value);
  }
  // A picture for readers without scripts is one of the element.
  element.append(...[...marked.children].filter((inside) => inside.hasAttribute('slot')), marked);
  parentNode.insertBefore(element, nextSibling);
}
