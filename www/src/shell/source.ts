// Where the program of an element comes from: a script or a `pre` inside of it, its own text, or a file.
//
// In: the element as the page has it. Out: the program's text, and word when that changes. What stands in a slot, as a
// picture for readers without scripts, is no program. Must not know: what becomes of the text.

/** What a program is written in where the page's language could read signs of it as its own. */
const SCRIPT = 'script[type="text/x-gcode"]';
const SETUP = 'script[type="application/json"]';
/** In Markdown these can stand outermost: there an element ends at a blank line. */
const MARKED = `${SCRIPT}[data-gcode-playground], pre[data-gcode-playground]`;

/**
 * The program that the page has written into the element: that of a script, of a `pre`, or the element's own text; without
 * the blank first and last lines and the common indent.
 */
export function writtenProgram(element: Element): string {
  const own = [...element.childNodes].filter((node) => !(node instanceof Element && (node.hasAttribute('slot') || node.matches(SETUP))));
  const holder = child(own, SCRIPT) ?? child(own, 'pre');
  return holder === undefined ? withoutIndent(own.map(textOf).join('')) : withoutIndent([...holder.childNodes].filter(isNotSlotted).map(textOf).join(''));
}

/** The setup that the page has written into the element, as JSON. */
export function writtenSetup(element: Element): string | null {
  return child([...element.children], SETUP)?.textContent ?? null;
}

/** Calls when what is written in the element changes: also while the page is still being read. */
export function watchWritten(element: Element, changed: () => void): MutationObserver {
  const observer = new MutationObserver(changed);
  observer.observe(element, { childList: true, characterData: true, subtree: true });
  return observer;
}

/**
 * Puts an element in the place of each `<script type="text/x-gcode" data-gcode-playground>` and
 * `<pre data-gcode-playground>`, with that inside. What is said of it as `data-view` and the like is said of the element.
 */
export function upgrade(root: ParentNode = document): void {
  for (const marked of root.querySelectorAll<HTMLElement>(MARKED)) {
    if (marked.parentElement?.localName === 'gcode-playground') continue;
    const element = document.createElement('gcode-playground');
    for (const { name, value } of marked.attributes) if (name.startsWith('data-') && name !== 'data-gcode-playground') element.setAttribute(name.slice('data-'.length), value);
    marked.replaceWith(element);
    // Pictures for readers without scripts belong to the element.
    const slotted = [...marked.children].filter((inside) => inside.hasAttribute('slot'));
    element.append(...slotted, marked);
  }
}

/** The text of a file of a program. */
export async function fetchedProgram(address: string): Promise<string> {
  const response = await fetch(address, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return response.text();
}

function child(nodes: readonly Node[], selector: string): Element | undefined {
  return nodes.find((node): node is Element => node instanceof Element && node.matches(selector));
}

function isNotSlotted(node: Node): boolean {
  return !(node instanceof Element && node.hasAttribute('slot'));
}

function textOf(node: Node): string {
  return node.nodeType === Node.COMMENT_NODE ? '' : (node.textContent ?? '');
}

function withoutIndent(text: string): string {
  const lines = text.replace(/\r\n?/g, '\n').split('\n');
  while (lines.length > 0 && lines[0]?.trim() === '') lines.shift();
  while (lines.length > 0 && lines.at(-1)?.trim() === '') lines.pop();
  const indents = lines.filter((line) => line.trim() !== '').map((line) => line.length - line.trimStart().length);
  const indent = indents.length === 0 ? 0 : Math.min(...indents);
  return lines.map((line) => line.slice(indent)).join('\n');
}
