// Every dialog has the same shape: a title, a button that closes it, the main action last; Escape and a click outside
// close it, too, and the focus returns to its opener. It fits into the window, and has no blank part under its contents.
import { chromiumTest as test, expect, nightUnless, type Locator, type Page } from './engines';
import { chip, choose, editor, open, settled, title, type } from './page';

interface Opened {
  readonly name: string | RegExp;
  /** Has the focus after the dialog has closed. */
  readonly opener: (page: Page) => Locator;
  readonly open: (page: Page) => Promise<void>;
  /** Not modal: it stays open while the program is played, so a click outside does not close it. */
  readonly stays?: true;
}

const menuButton =
  (name: string) =>
  (page: Page): Locator =>
    page.getByRole('button', { name, exact: true });
const fromMenu = (menu: Parameters<typeof choose>[1], item: string | RegExp, name: string | RegExp): Opened => ({
  name,
  opener: menu === 'program' ? title : menuButton({ share: 'Share', help: 'Help', more: 'More' }[menu]),
  open: (page) => choose(page, menu, item),
});

const DIALOGS: readonly Opened[] = [
  fromMenu('program', 'New…', 'New program'),
  fromMenu('program', 'Gallery…', 'Gallery'),
  fromMenu('program', 'Exercises…', 'Exercises'),
  fromMenu('program', 'My programs…', 'My programs'),
  fromMenu('program', 'Programs in a text…', 'Programs in this text'),
  fromMenu('share', 'Link, task, QR code…', 'Share'),
  fromMenu('share', 'Exercise that checks the part…', 'Exercise that checks the part'),
  fromMenu('help', 'Keys and gestures', 'Keys and gestures'),
  fromMenu('help', 'Supported codes', 'Supported codes'),
  fromMenu('more', 'Compare with another version…', 'Compare with another version'),
  fromMenu('more', 'Report a difference to my machine…', /machine/),
  fromMenu('more', 'Convert…', 'Convert'),
  fromMenu('more', 'Expand cycles', /.*/),
  fromMenu('more', 'Write as a cycle…', /cycle/),
  fromMenu('more', /^Time and totals/, 'Time and totals'),
  { ...fromMenu('more', 'Motions', 'Motions in words'), stays: true },
  {
    name: 'Setup',
    opener: (page) => page.getByRole('button', { name: /^Setup/ }),
    open: (page) => page.getByRole('button', { name: /^Setup/ }).click(),
  },
  {
    name: /Machines/,
    opener: chip,
    open: async (page) => {
      await chip(page).click();
      await page.getByRole('button', { name: /^Choose machine/ }).click();
    },
  },
  {
    name: 'The part, a quarter cut away',
    opener: (page) => page.getByRole('button', { name: /^3D/ }),
    open: (page) => page.getByRole('button', { name: /^3D/ }).click(),
  },
  {
    name: 'Outline of the program',
    opener: editor,
    open: async (page) => {
      await editor(page).focus();
      await page.keyboard.press('Control+Shift+O');
    },
  },
  {
    name: 'Commands',
    opener: editor,
    open: async (page) => {
      await editor(page).focus();
      await page.keyboard.press('Control+K');
    },
  },
];

const PROGRAM = 'O0001\nG99 S800 M03\nT0101\nG00 X62 Z2\nG90 X55 Z-30 F0.2\nX50\nG00 X100 Z100\nM30\n';

interface Shape {
  readonly title: string;
  /** Names of the buttons at the end, and the index of the main one; -1 if there is none. */
  readonly buttons: readonly string[];
  readonly main: number;
  /** Distance from the end of the contents to the end of the part that contains them, CSS pixels. */
  readonly blank: number;
  /** Edges that are outside of the window. */
  readonly outside: readonly string[];
}

async function shapeOf(dialog: Locator): Promise<Shape> {
  return dialog.evaluate((element) => {
    const isShown = (each: Element): boolean => each.checkVisibility({ visibilityProperty: true });
    const box = element.getBoundingClientRect();
    const buttons = [...element.querySelectorAll(':scope > .actions > button')].filter(isShown);
    const body = element.querySelector('.dialog-body, .scroller');
    const last = [...(body?.children ?? [])].filter(isShown).at(-1);
    return {
      title: element.querySelector('h2')?.textContent ?? '',
      buttons: buttons.map((button) => button.textContent ?? ''),
      main: buttons.findIndex((button) => button.matches('.primary')),
      blank:
        body === null || last === undefined
          ? 0
          : body.getBoundingClientRect().bottom - last.getBoundingClientRect().bottom,
      outside: [
        ...(box.left < 0 || box.right > innerWidth ? ['inline'] : []),
        ...(box.top < 0 || box.bottom > innerHeight ? ['block'] : []),
      ],
    };
  });
}

for (const [index, { name, opener, open: openDialog, stays }] of DIALOGS.entries()) {
  const title = `a dialog has its shape, and closes in each way: ${name.toString()}`;
  test(title, nightUnless(index % 4 === 0), async ({ page }) => {
    await page.setViewportSize({ width: 1440, height: 900 });
    await open(page);
    await type(page, PROGRAM);
    await settled(page);
    // The completion list may still be open.
    await page.keyboard.press('Escape');
    const dialog = (page as Page).getByRole('dialog');
    await openDialog(page);
    await expect(dialog).toHaveCount(1);
    await expect((page as Page).getByRole('dialog', { name })).toHaveCount(1);
    const shape = await shapeOf(dialog);
    expect(shape.title).toMatch(name);
    expect(shape.outside).toEqual([]);
    expect(shape.blank).toBeLessThanOrEqual(24);
    expect([-1, shape.buttons.length - 1], shape.buttons.join(' · ')).toContain(shape.main);
    expect(shape.buttons).not.toContain('Close');

    await dialog.getByRole('button', { name: 'Close', exact: true }).click();
    await expect(dialog).toHaveCount(0);
    await expect(opener(page)).toBeFocused();

    await openDialog(page);
    await expect(dialog).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(dialog).toHaveCount(0);
    await expect(opener(page)).toBeFocused();

    await openDialog(page);
    await expect(dialog).toHaveCount(1);
    if (stays !== true) {
      // A press in the dialog that ends outside does not close it.
      const { x, y } = (await dialog.getByRole('heading').first().boundingBox()) ?? { x: 0, y: 0 };
      await page.mouse.move(x + 2, y + 2);
      await page.mouse.down();
      await page.mouse.move(3, 3);
      await page.mouse.up();
      await expect(dialog).toHaveCount(1);
      await page.mouse.click(3, 3);
      await expect(dialog).toHaveCount(0);
      await expect(opener(page)).toBeFocused();
      await openDialog(page);
      await expect(dialog).toHaveCount(1);
    }
    await page.setViewportSize({ width: 390, height: 844 });
    await expect(async () => {
      expect((await shapeOf(dialog)).outside).toEqual([]);
    }).toPass();
  });
}

test('a menu and a popover close by Escape and by a click outside, and return the focus', async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await open(page);
  const openers: readonly Locator[] = [
    title(page),
    ...['Share', 'Help', 'More'].map((name) => menuButton(name)(page)),
    chip(page),
    (page as Page).getByRole('button', { name: /^Speed and steps/ }),
  ];
  for (const opener of openers) {
    const opened = page.getByRole('menu').or(page.getByRole('dialog'));
    await opener.click();
    await expect(opened).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(opened).toHaveCount(0);
    await expect(opener).toBeFocused();
    await opener.click();
    await expect(opened).toHaveCount(1);
    await page.mouse.click(700, 880);
    await expect(opened).toHaveCount(0);
  }
});
