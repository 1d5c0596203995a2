// Code points that WebDriver assigns to keys without a character (w3.org/TR/webdriver2, 17.4.2).
const KEYS: Readonly<Record<string, string>> = {
  Alt: '\ue00a',
  ArrowDown: '\ue015',
  ArrowLeft: '\ue012',
  ArrowRight: '\ue014',
  ArrowUp: '\ue013',
  Backspace: '\ue003',
  Control: '\ue009',
  Delete: '\ue017',
  End: '\ue010',
  Enter: '\ue007',
  Escape: '\ue00c',
  Home: '\ue011',
  PageDown: '\ue00f',
  PageUp: '\ue00e',
  Shift: '\ue008',
  Space: ' ',
  Tab: '\ue004',
};

/** WebDriver's code of a key. */
export function keyCode(key: string): string {
  const place = /^F(\d+)$/.exec(key)?.[1];
  return place === undefined ? (KEYS[key] ?? key) : String.fromCharCode(0xe030 + Number(place));
}
