// What the element starts from: its light-DOM text and its setup.
//
// In: the element, its attributes. Out: the program's text; the setup as one JSON text.
// Must not know: what a setup may hold beyond the place of the control's name.

/** The element's own text, without slotted children, without the blank first and last line and the common indent. */
export function initialProgram(element: HTMLElement): string {
  const own = [...element.childNodes].filter((node) => !(node instanceof Element && node.hasAttribute('slot')));
  const lines = own.map((node) => (node.nodeType === Node.COMMENT_NODE ? '' : (node.textContent ?? ''))).join('').split('\n');
  while (lines.length > 0 && lines[0]?.trim() === '') lines.shift();
  while (lines.length > 0 && lines.at(-1)?.trim() === '') lines.pop();
  const indents = lines.filter((line) => line.trim() !== '').map((line) => line.length - line.trimStart().length);
  const indent = indents.length === 0 ? 0 : Math.min(...indents);
  return lines.map((line) => line.slice(indent)).join('\n');
}

export type MergedSetup =
  | { readonly kind: 'setup'; readonly json: string }
  | { readonly kind: 'unreadable'; readonly reason: string };

/** The `setup` attribute with the `control` attribute put in its place. */
export function mergedSetup(json: string | null, control: string | null): MergedSetup {
  if (control === null) return { kind: 'setup', json: json ?? '{}' };
  let setup: unknown;
  try {
    setup = JSON.parse(json ?? '{}');
  } catch (error) {
    return { kind: 'unreadable', reason: error instanceof Error ? error.message : String(error) };
  }
  // Anything but an object is the interpreter's to refuse.
  if (typeof setup !== 'object' || setup === null || Array.isArray(setup)) return { kind: 'setup', json: json ?? '{}' };
  const dialect: unknown = Reflect.get(setup, 'dialect');
  const switches = typeof dialect === 'object' && dialect !== null ? dialect : {};
  return { kind: 'setup', json: JSON.stringify({ ...setup, dialect: { ...switches, control } }) };
}
