// Pages with elements of the playground in them, as in a manual.
import type { BasicPage } from './engines';
import type { Playground } from './page';

/**
 * A page of another site: empty and without a policy (served by www/vite.config.ts). The built element is two folders
 * up.
 */
export const FOREIGN = './foreign/site/page.html';
export const SCRIPT = '<script type="module" async src="../../element.js"></script>';

/** Opens a page with this HTML, parsed by the browser's own parser. */
export async function openHtml(page: BasicPage, html: string): Promise<void> {
  await openInPieces(page, html);
}

/** The HTML arrives in pieces; the custom element is defined before the second piece. */
export async function openInPieces(page: BasicPage, ...pieces: string[]): Promise<void> {
  await page.goto(FOREIGN);
  await page.evaluate(async (pieces) => {
    document.open();
    for (const piece of pieces) {
      document.write(piece);
      if (piece === pieces.at(-1)) document.close();
      await customElements.whenDefined('gcode-playground');
      // Let the page render before the next piece arrives.
      await new Promise((done) => setTimeout(done, 100));
    }
  }, pieces);
}

/** The page with the script of the element in its head. */
export function manual(body: string, head = ''): string {
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A manual</title>${SCRIPT}${head}</head><body>${body}</body></html>`;
}

/** Clicks each button of an element once, and closes what opens. Returns the number of buttons. */
export function pressEveryButton(page: BasicPage): Promise<number> {
  return page.locator('gcode-playground').evaluate(async (element) => {
    const root = element.shadowRoot!;
    const buttons = [...root.querySelectorAll('button')];
    for (const button of buttons) {
      button.click();
      await new Promise((done) => setTimeout(done, 100));
      for (const dialog of root.querySelectorAll<HTMLDialogElement>('dialog[open]')) dialog.close();
    }
    return buttons.length;
  });
}

/** The program of an element. */
export function programOf(page: BasicPage, which = 0): Promise<string> {
  return page
    .locator('gcode-playground')
    .nth(which)
    .evaluate((element) => (element as Playground).value);
}

/** Escapes `<` and `&` for the text of a page. */
export function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}
