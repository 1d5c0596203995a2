// The style sheets of the elements: each is created once and shared by all elements of the page.
//
// In: texts of style sheets. Out: the shadow root adopts them, after its existing ones. `rem` is replaced by the
// element's own text size, since many pages set the root size to 62.5 %.

const sheets = new Map<string, CSSStyleSheet>();

export function adoptStyles(root: ShadowRoot, texts: readonly string[]): void {
  root.adoptedStyleSheets = [
    ...new Set([...root.adoptedStyleSheets, ...texts.filter((text) => text !== '').map(getSheet)]),
  ];
}

function getSheet(text: string): CSSStyleSheet {
  const known = sheets.get(text);
  if (known !== undefined) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(withOwnRem(text));
  sheets.set(text, sheet);
  return sheet;
}

/** Container conditions cannot use variables, but `em` there is the text size of the container, which is the same. */
function withOwnRem(text: string): string {
  const conditions = text.replace(/@container[^{]*/g, (condition) => condition.replace(/([\d.])rem\b/g, '$1em'));
  return conditions.replace(/(-?[\d.]+)rem\b/g, 'calc($1 * var(--playground-rem))');
}

// A registered length is computed where it is set and inherited as a computed value.
try {
  CSS.registerProperty({ name: '--playground-rem', syntax: '<length>', inherits: true, initialValue: '16px' });
} catch {
  // Already registered by another copy of this file.
}
