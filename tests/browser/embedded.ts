// Pages with elements of the playground in them, as a manual has them.
import { expect, type BasicPage } from './engines';

export interface Playground extends HTMLElement {
  value: string;
  readonly settled: Promise<number>;
}

/** Where the pages are, as the browser sees them; the built element is two folders up. */
const PLACE = './rules/en/index.html';
export const SCRIPT = '<script type="module" async src="../../element.js"></script>';

/** A page of this HTML, read by the browser's own parser. */
export async function openHtml(page: BasicPage, html: string): Promise<void> {
  await openInPieces(page, html);
}

/** The HTML comes in pieces; the class of the element is there before the second of them. */
export async function openInPieces(page: BasicPage, ...pieces: string[]): Promise<void> {
  await page.goto(PLACE);
  await page.evaluate(async (pieces) => {
    document.open();
    for (const piece of pieces) {
      document.write(piece);
      if (piece === pieces.at(-1)) document.close();
      await customElements.whenDefined('gcode-playground');
      // The page is shown, and what follows it looks at it.
      await new Promise((done) => setTimeout(done, 100));
    }
  }, pieces);
}

/** The page with the script of the element in its head. */
export function manual(body: string, head = ''): string {
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A manual</title>${SCRIPT}${head}</head><body>${body}</body></html>`;
}

/** Waits until an element shows all there is to show. */
export async function settled(page: BasicPage, which = 0): Promise<void> {
  await expect(page.locator('gcode-playground').nth(which)).toBeVisible();
  await page.locator('gcode-playground').nth(which).evaluate(async (element) => void (await (element as Playground).settled));
}

/** The program of an element. */
export function programOf(page: BasicPage, which = 0): Promise<string> {
  return page.locator('gcode-playground').nth(which).evaluate((element) => (element as Playground).value);
}

/** What stands for `<` and `&` in the text of a page. */
export function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}
