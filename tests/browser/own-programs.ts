// Helpers for "My programs", and for the same page in a second, hidden tab.
import { expect, type BasicPage, type Locator, type Page } from './engines';

export const list = (page: BasicPage): Locator => page.getByRole('dialog', { name: 'My programs' });
export const items = (page: BasicPage): Locator => list(page).getByRole('listitem');

/** Waits until typed text is stored, which takes at most a second. */
export const kept = (page: BasicPage): Promise<void> => page.waitForTimeout(900);

/** Opens the page in a second tab, with `hash` as the fragment of the URL. */
export async function secondTab(page: Page, hash = ''): Promise<Page> {
  await page.evaluate((hash) => {
    const link = Object.assign(document.createElement('a'), {
      href: `${location.pathname}${hash}`,
      target: '_blank',
      textContent: 'second tab',
    });
    link.style.cssText = 'position: fixed; inset: 0 auto auto 0; z-index: 99';
    document.body.append(link);
  }, hash);
  const coming = page.waitForEvent('popup');
  await page.getByRole('link', { name: 'second tab' }).click();
  const second = await coming;
  await page.evaluate(() => document.querySelector('body > a')?.remove());
  await expect(second.getByRole('status').first()).toContainText(/\d/);
  await second
    .locator('gcode-playground')
    .evaluate((element) => (element as unknown as { settled: Promise<number> }).settled);
  // The list is loaded after the first picture.
  await second.waitForTimeout(500);
  return second;
}

/** Adds to the text like a user, in a hidden tab. */
export async function addInHiddenTab(page: BasicPage, text: string): Promise<void> {
  await page.locator('gcode-playground').evaluate((element, added) => {
    const content = element.shadowRoot?.querySelector('.cm-content') as HTMLElement;
    content.focus();
    document.getSelection()?.selectAllChildren(content);
    document.getSelection()?.collapseToEnd();
    document.execCommand('insertText', false, added);
  }, text);
}
