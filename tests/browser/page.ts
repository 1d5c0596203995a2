// Helpers of the browser tests for the page: roles, labels, and the element's one method for automation.
import type { Browser } from '@playwright/test';
import { expect, type BasicPage, type ChromiumPage, type Locator } from './engines';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export interface Playground extends HTMLElement {
  value: string;
  readonly settled: Promise<number>;
  locate(x: number, z: number): Promise<{ clientX: number; clientY: number }>;
}

/** Text of a program in tests/programs. */
export function program(id: string): string {
  return read(id, 'program.nc');
}

/** Expected number of motions of a program in tests/programs. */
export function motionCount(id: string): number {
  return read(id, 'motions.jsonl')
    .split('\n')
    .filter((line) => line.trim() !== '').length;
}

/** The programs of the gallery, in its order. */
export const examples: readonly { readonly id: string }[] = (
  JSON.parse(read('.', 'gallery.json')) as { readonly programs: readonly string[] }[]
).flatMap(({ programs }) => programs.map((id) => ({ id })));

export const editor = (page: BasicPage): Locator => page.getByRole('textbox', { name: /^(Program|程序|Программа)$/ });
export const status = (page: BasicPage): Locator => page.getByRole('status');
export const drawing = (page: BasicPage): Locator => page.getByRole('img', { name: /tool path|轨迹|траектории/ });
export const play = (page: BasicPage): Locator => page.getByRole('button', { name: 'Play' });
export const tooltip = (page: BasicPage): Locator => page.getByRole('tooltip');
/** Tabs of a small window. */
const TABS = {
  program: /^(Program|程序|Программа)$/,
  problems: /^(Problems|问题|Замечания)/,
  explain: /^(Explain|说明|Пояснение)$/,
} as const;

export const tab = (page: BasicPage, which: keyof typeof TABS): Locator => page.getByRole('tab', { name: TABS[which] });
export const problems = (page: BasicPage): Locator => page.getByRole('region', { name: /^(Problems|问题|Замечания)$/ });

/** A page of a phone, 390 CSS pixels wide; with its keyboard open the height is 510. The caller closes its context. */
export async function newPhonePage(
  browser: Browser,
  baseURL: string | undefined,
  { height = 844, locale = 'en-US' } = {},
): Promise<ChromiumPage> {
  const context = await browser.newContext({
    ...(baseURL === undefined ? {} : { baseURL }),
    viewport: { width: 390, height },
    deviceScaleFactor: 2,
    isMobile: true,
    hasTouch: true,
    locale,
  });
  return (await context.newPage()) as ChromiumPage;
}

/**
 * Opens the page and waits until its program has run and its part and messages are shown. Without a hash, the program is
 * the stored one, or the example `s000-o0002`: many tests rely on its content. `openFirstVisit` opens the first example.
 * Any error on the page fails the test, and so does any violation of its policy.
 */
export async function open(page: BasicPage, hash = ''): Promise<void> {
  await page.addInitScript(() => {
    const { pathname, hash } = location;
    if (window !== top || hash !== '' || !/\/(index\.html)?$/.test(pathname) || /\/(docs|rules)\//.test(pathname))
      return;
    const last = localStorage.getItem(`gcode-playground:last:${pathname}`) ?? '""';
    // The program of a page from before there was a list.
    const earlier = localStorage.getItem(`gcode-playground:program:${pathname}`);
    if (last === '""' && earlier === null) history.replaceState(null, '', '#s000-o0002');
  });
  await openFirstVisit(page, hash);
}

/** Like `open`, but without a hash the page opens its first example. */
export async function openFirstVisit(page: BasicPage, hash = ''): Promise<void> {
  page.on('pageerror', (error) => {
    throw error;
  });
  await page.addInitScript(() => {
    if (Reflect.has(globalThis, 'policyIsWatched')) return;
    Reflect.set(globalThis, 'policyIsWatched', true);
    addEventListener(
      'securitypolicyviolation',
      ({ effectiveDirective, blockedURI }) =>
        void setTimeout(() => {
          throw new Error(`the policy of the page blocks ${effectiveDirective}: ${blockedURI}`);
        }),
    );
  });
  await page.goto(`./${hash}`);
  await settled(page);
  await expect(status(page)).toContainText(/\d/);
  // The status ends with dots while something is still loading.
  await expect(status(page)).not.toContainText('…');
}

/**
 * Waits until an element, the first by default, shows all of its newest run. Faster than an expectation, which
 * Playwright repeats after 100, 250, 500 and then 1000 ms.
 */
export async function settled(page: BasicPage, which = 0): Promise<void> {
  await page
    .locator('gcode-playground')
    .nth(which)
    .evaluate(async (element) => {
      await customElements.whenDefined('gcode-playground');
      await (element as Playground).settled;
    });
}

/** Reloads the page and waits until its program is shown: before, a click may meet a layout that still changes. */
export async function reload(page: BasicPage): Promise<void> {
  await page.reload();
  await settled(page);
}

/** Replaces the text like a user, select all, then type, and waits until its run is shown. */
export async function type(page: BasicPage, text: string): Promise<void> {
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(text);
  await settled(page);
}

/** The panel below the editor about the word and the block at the cursor. */
export const atCursor = (page: BasicPage): Locator =>
  page.getByRole('region', { name: /^(At the cursor|光标处|У курсора)/ });

/** Moves the cursor by keys to a line (from 1), after `letter` characters. */
export async function goTo(page: BasicPage, line: number, letter = 0): Promise<void> {
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  for (let at = 1; at < line; at++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Home');
  for (let at = 0; at < letter; at++) await page.keyboard.press('ArrowRight');
}

/** Chooses a file in the dialog of "Open…", and does not wait until it is open. */
export async function chooseFile(page: BasicPage, name: string, bytes: Uint8Array): Promise<void> {
  await page
    .locator('input[type=file][accept*=".nc"]')
    .setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(bytes) });
}

/** Opens a UTF-8 text as a file and waits until it is the program; for texts that are too long to type. */
export async function openFile(page: BasicPage, name: string, bytes: Uint8Array): Promise<void> {
  const text = new TextDecoder('utf-8', { fatal: true }).decode(bytes).replaceAll(/\r\n?/g, '\n');
  await chooseFile(page, name, bytes);
  // A failure does not print the texts, which may be long.
  await expect
    .poll(async () => ((await value(page)) === text ? 'the file' : 'another program'), { timeout: 30_000 })
    .toBe('the file');
}

/** The whole text of the editor. */
export async function value(page: BasicPage): Promise<string> {
  return page.locator('gcode-playground').evaluate((element) => (element as Playground).value);
}

/**
 * Screen position of a point (X as a diameter, Z; mm), once the picture is shown. The position changes with the picture
 * of the next run.
 */
export async function locate(page: BasicPage, x: number, z: number): Promise<{ x: number; y: number }> {
  const place = await page.locator('gcode-playground').evaluate(
    async (element, at) => {
      await (element as Playground).settled;
      return (element as Playground).locate(at.x, at.z);
    },
    { x, z },
  );
  return { x: place.clientX, y: place.clientY };
}

/** Pixel at a fraction of the way between two points: 0.5 is the middle of the stroke. */
export async function between(
  page: BasicPage,
  from: { x: number; z: number },
  to: { x: number; z: number },
  share = 0.5,
): Promise<{ x: number; y: number }> {
  return locate(page, from.x + (to.x - from.x) * share, from.z + (to.z - from.z) * share);
}

/**
 * Copies a text to the clipboard like a user, by a field and its keys: scripts need a permission that cannot be granted
 * in every engine.
 */
export async function copy(page: BasicPage, text: string): Promise<void> {
  await page.evaluate((text) => {
    const field = document.body.appendChild(document.createElement('textarea'));
    field.id = 'clipboard';
    field.value = text;
    field.select();
  }, text);
  await page.keyboard.press('Control+C');
  await page.evaluate(() => document.getElementById('clipboard')?.remove());
}

/** The text in the clipboard. Restores the focus. */
export async function clipboard(page: BasicPage): Promise<string> {
  await page.evaluate(() => {
    Reflect.set(window, 'before', document.activeElement);
    const dialog = document.querySelector('gcode-playground')?.shadowRoot?.querySelector('dialog[open]');
    const field = (dialog ?? document.body).appendChild(document.createElement('textarea'));
    field.id = 'clipboard';
    field.focus();
    Reflect.set(window, 'field', field);
  });
  await page.keyboard.press('Control+V');
  return page.evaluate(() => {
    const field = Reflect.get(window, 'field') as HTMLTextAreaElement;
    field.remove();
    (Reflect.get(window, 'before') as HTMLElement | null)?.focus();
    return field.value;
  });
}

/**
 * Runs the same text again by changing the block-skip level, which no block uses, and waits until the requests about it
 * have been answered.
 */
export async function runAgain(page: BasicPage): Promise<void> {
  await page.locator('gcode-playground').evaluate(async (element) => {
    element.setAttribute('block-skip', element.getAttribute('block-skip') === '9' ? '8' : '9');
    await (element as Playground).settled;
  });
  await page.waitForTimeout(500);
}

/** The selected text of the editor. */
export async function selected(page: BasicPage): Promise<string> {
  return page.evaluate(() => {
    const root = document.querySelector('gcode-playground')?.shadowRoot;
    const selection =
      (root as unknown as { getSelection?: () => Selection | null })?.getSelection?.() ?? getSelection();
    return selection?.toString() ?? '';
  });
}

function read(id: string, file: string): string {
  return readFileSync(join(__dirname, '..', 'programs', id, file), 'utf8');
}

const MENUS = {
  share: /^(Share|分享|Поделиться)$/,
  help: /^(Help|帮助|Справка)$/,
  more: /^(More|更多|Ещё)$/,
} as const;

/** The button with the title of the program, which opens the menu "Program". */
export const title = (page: BasicPage): Locator => page.locator('button[aria-haspopup=menu]').first();

/** The title of the program, which the page puts into that button. */
export const titleText = (page: BasicPage): Locator => page.locator('#title');

/** Opens a menu of the row at the top. */
export async function openMenu(page: BasicPage, menu: 'program' | keyof typeof MENUS): Promise<void> {
  await (menu === 'program' ? title(page) : page.getByRole('button', { name: MENUS[menu] })).click();
}

/** Chooses an item of a menu of the row at the top; `item` is its whole text or a pattern. */
export async function choose(
  page: BasicPage,
  menu: 'program' | keyof typeof MENUS,
  item: string | RegExp,
): Promise<void> {
  await openMenu(page, menu);
  const name = typeof item === 'string' ? { name: item, exact: true } : { name: item };
  await page
    .getByRole('menuitem', name)
    .or(page.getByRole('menuitemradio', name))
    .or(page.getByRole('menuitemcheckbox', name))
    .click();
}

/** Opens a program of the gallery by its title. */
export async function chooseExample(page: BasicPage, name: string | RegExp): Promise<void> {
  await choose(page, 'program', /^(Gallery|全部示例|Все примеры)…$/);
  await page.getByRole('dialog').getByRole('button').filter({ hasText: name }).first().click();
}

/** The chip that says how the program was read. */
export const chip = (page: BasicPage): Locator =>
  page.getByRole('button', { name: /^(How the program was read|程序的读法|Как прочитана программа)/ });

/** Chooses the control in the setup form. */
export async function chooseControl(page: BasicPage, name: string): Promise<void> {
  await chip(page).click();
  await page.getByRole('button', { name: /^(Change…|更改…|Изменить…)$/ }).click();
  const form = page.getByRole('dialog', { name: /^(Setup|毛坯与刀具|Наладка)/ });
  await form.getByRole('combobox', { name: /^(Control|数控系统|Система ЧПУ)/ }).selectOption(name);
  await form.getByRole('button', { name: /^(Apply|应用|Применить)$/ }).click();
  // A dialog that closes returns the focus to its opener.
  await expect(form).toBeHidden();
  await settled(page);
}

/** Opens the list of problems, unless it is open. A new program with errors opens it, too: possibly at the same time. */
export async function openProblems(page: BasicPage): Promise<void> {
  await expect(async () => {
    if ((await problems(page).count()) === 0) await problemsButton(page).click();
    await expect(problems(page)).toBeVisible({ timeout: 1000 });
  }).toPass({ timeout: 20_000 });
}

const LANGUAGE_NAMES = { en: 'English', zh: '中文', ru: 'Русский' } as const;

/** Chooses the language of the page in the menu "More". */
export async function chooseLanguage(page: BasicPage, language: keyof typeof LANGUAGE_NAMES): Promise<void> {
  await choose(page, 'more', LANGUAGE_NAMES[language]);
}

/** Opens the popover beside the slider with speed, steps and stops; Escape closes it. */
export async function openPace(page: BasicPage): Promise<void> {
  await page.getByRole('button', { name: /^(Speed and steps|速度与步进|Скорость и шаг)/ }).click();
}

/** The button over the program that says how many problems there are; it opens and closes their list. */
export const problemsButton = (page: BasicPage): Locator =>
  page.getByRole('button', {
    name: /^(Problems|问题|Замечания)[:：]|^(no problems|没有问题|замечаний нет)$/,
  });

/** What the chip over the program opens: how the program was read, switches, unit. */
export const reading = (page: BasicPage): Locator =>
  page.getByRole('dialog', { name: /^(How the program was read|程序的读法|Как прочитана программа)$/ });

/** Opens what the chip over the program opens, unless it is open. */
export async function openReading(page: BasicPage): Promise<void> {
  if ((await reading(page).count()) === 0) await chip(page).click();
  await expect(reading(page)).toBeVisible();
}

/** Number of lines of the program that are fully in view. */
export const linesInView = (page: BasicPage): Promise<number> =>
  page.locator('.cm-line').evaluateAll(
    (lines) =>
      lines.filter((line) => {
        const { top, bottom } = line.getBoundingClientRect();
        const scroller = line.closest('.cm-scroller')?.getBoundingClientRect();
        return scroller !== undefined && top >= scroller.top - 1 && bottom <= scroller.bottom + 1;
      }).length,
  );
