// The style sheets of the element: each is made once and shared by all elements of the page.
//
// In: texts of style sheets. Out: the shadow root adopts them, after those it has.

const made = new Map<string, CSSStyleSheet>();

export function adopt(root: ShadowRoot, texts: readonly string[]): void {
  root.adoptedStyleSheets = [...new Set([...root.adoptedStyleSheets, ...texts.filter((text) => text !== '').map(sheet)])];
}

function sheet(text: string): CSSStyleSheet {
  const known = made.get(text);
  if (known !== undefined) return known;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  made.set(text, sheet);
  return sheet;
}
