// Replaces programs in a page by elements: `<script type="text/x-gcode" data-gcode-playground>` and
// `<pre data-gcode-playground>`. In Markdown, these are the tags whose content may have blank lines.
//
// In: a part of a page. Out: an element around each such program, with the attributes that are written as `data-…`.
// Must not know: the meaning of an attribute.

import { whenParsed } from './parsed';
import { PROGRAM_SCRIPT } from './source';

const TAG = 'gcode-playground';
const MARK_ATTRIBUTE = 'data-gcode-playground';
const MARKED_SELECTOR = `${PROGRAM_SCRIPT}[${MARK_ATTRIBUTE}], pre[${MARK_ATTRIBUTE}]`;

/** Only the attributes of the element are copied: `data-onclick` must not become `onclick`. */
export type Attributes = readonly string[];

export function upgradeIn(root: ParentNode, attributes: Attributes): void {
  const found = [...root.querySelectorAll(MARKED_SELECTOR)];
  if (root instanceof Element && root.matches(MARKED_SELECTOR)) found.push(root);
  for (const marked of found) whenParsed(marked, () => wrapInElement(marked, attributes));
}

/** Upgrades all programs of the page, including those that are parsed later. */
export function upgradeDocument(attributes: Attributes): void {
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

function wrapInElement(marked: Element, attributes: Attributes): void {
  const { parentNode, nextSibling } = marked;
  if (parentNode === null || marked.closest(TAG) !== null) return;
  const element = document.createElement(TAG);
  for (const name of attributes) {
    const value = marked.getAttribute(`data-${name}`);
    if (value !== null) element.setAttribute(name, value);
  }
  // A picture for users without scripts moves into the slot of the element.
  element.append(...[...marked.children].filter((child) => child.hasAttribute('slot')), marked);
  parentNode.insertBefore(element, nextSibling);
}
