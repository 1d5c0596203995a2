// The style sheets of the element: each is made once and shared by all elements of the page.
//
// In: texts of style sheets. Out: the shadow root adopts them, after those it has. `rem` in them is the size of type of
// the element, not that of the page, which many set to 62.5 %.

const made = new Map<string, CSSStyleSheet>();

export function adopt(root: ShadowRoot, texts: readonly string[]): void {
  root.adoptedStyleSheets = [
    ...new Set([...root.adoptedStyleSheets, ...texts.filter((text) => text !== '').map(sheet)]),
  ];
}

function sheet(text: string): CSSStyleSheet {
  const known = made.get(text);
  if (known !== undefined) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(withOwnRem(text));
  made.set(text, sheet);
  return sheet;
}

/** A container's conditions know no variables, but its own size of type, which is the same. */
function withOwnRem(text: string): string {
  const conditions = text.replace(/@container[^{]*/g, (condition) => condition.replace(/([\d.])rem\b/g, '$1em'));
  return conditions.replace(/(-?[\d.]+)rem\b/g, 'calc($1 * var(--playground-rem))');
}

// A length that is worked out where it is set, and inherited as such.
try {
  CSS.registerProperty({ name: '--playground-rem', syntax: '<length>', inherits: true, initialValue: '16px' });
} catch {
  // Another copy of this file has done it.
}
