// axe (checks for screen readers) finds no violation on the page, in every menu, popover and dialog, on pages of rules
// and of the reference, in each language, in light and dark.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromiumTest as test, type ChromiumPage, expect, nightUnless } from './engines';
import { makeLink, EMPTY_SHARED } from '../../www/src/files/shared-link';
import { manual, openHtml } from './embedded';
import { chip, choose, open, openMenu, openProblems, settled, type } from './page';

const AXE = readFileSync(join(__dirname, '../../www/node_modules/axe-core/axe.min.js'), 'utf8');
const PROGRAM = 'O1\n/G50 S2000\nT0101\nG96 S150 M3\nG0 X52 Z2\nG90 X48 Z-30 F0.2\nX44\nX\nM01\nG0 X200 Z200\nM30\n';

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly target: readonly unknown[]; readonly failureSummary?: string }[];
}

/** Violations that axe reports for the current page, each with the selectors. */
async function violations(page: ChromiumPage, where: string): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    interface Axe {
      run(context: Document, options: object): Promise<{ violations: Violation[] }>;
    }
    const { violations } = await (Reflect.get(window, 'axe') as Axe).run(document, {
      rules: { 'label-content-name-mismatch': { enabled: true } },
    });
    return violations;
  });
  return found.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${where}: ${id}: ${JSON.stringify(target)} ${failureSummary ?? ''}`),
  );
}

/** A link to a task, or to an answer to it. */
async function linked(what: 'task' | 'answer'): Promise<string> {
  const extra = what === 'task' ? { task: { sentence: 'Turn the shoulder', solution: PROGRAM } } : { name: 'Anna' };
  const made = await makeLink({ ...EMPTY_SHARED, text: 'G00 X52 Z2\n', ...extra });
  return made.kind === 'link' ? made.link : '';
}

/** Opens something by its button. */
const press =
  (name: RegExp) =>
  (page: ChromiumPage): Promise<void> =>
    page.getByRole('button', { name }).first().click();
/** Opens something by an item of a menu. */
const item =
  (...of: readonly [menu: Parameters<typeof choose>[1], name: RegExp]) =>
  (page: ChromiumPage): Promise<void> =>
    choose(page, ...of);

/** Each menu, popover and dialog, and how it is opened in each language. */
const OPENERS: Readonly<Record<string, (page: ChromiumPage) => Promise<void>>> = {
  'menu Program': (page) => openMenu(page, 'program'),
  'menu Share': (page) => openMenu(page, 'share'),
  'menu Help': (page) => openMenu(page, 'help'),
  'menu More': (page) => openMenu(page, 'more'),
  gallery: item('program', /^(Gallery|全部示例|Все примеры)…$/),
  share: item('share', /^(Link, task, QR code|链接、任务、二维码|Ссылка, задание, QR-код)…$/),
  'own programs': item('program', /^(My programs|我的程序|Мои программы)…$/),
  'how the program was read': (page) => chip(page).click(),
  'speed and steps': press(/^(Speed and steps|速度与步进|Скорость и шаг)/),
  // The cursor is in the blank line after the program.
  'insert cycle': press(/^(Insert cycle|插入循环|Вставить цикл)…$/),
  setup: press(/^(Setup|毛坯与刀具|Наладка)/),
  'pictures of the setup': async (page) => {
    await press(/^(Setup|毛坯与刀具|Наладка)/)(page);
    await press(/(: choose by picture|：按图选择|: выбрать по рисунку)$/)(page);
  },
  machines: async (page) => {
    await chip(page).click();
    await press(/^(Choose machine|选择机床|Выбрать станок)/)(page);
  },
  programs: item('program', /^(Programs in a text|文本中的程序|Программы в тексте)…$/),
  solid: press(/^(3D|三维)/),
  'cycles written out': item('more', /^(Expand cycles|展开循环|Развернуть циклы)$/),
  rewriting: item('more', /^(Write as a cycle|写成循环|Записать циклом)…$/),
  motions: item('more', /^(Motions|动作|Перемещения)$/),
  exercises: item('program', /^(Exercises|练习|Упражнения)…$/),
  'make exercise': item('share', /^(Exercise that checks the part|检查零件的练习|Упражнение с проверкой детали)…$/),
  time: item('more', /^(Time and totals|时间与合计|Время и итоги)/),
  keys: item('help', /^(Keys and gestures|按键与手势|Клавиши и жесты)$/),
  codes: item('help', /^(Supported codes|支持的代码|Поддерживаемые коды)$/),
};

for (const locale of ['en', 'zh', 'ru'] as const) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(
      `axe finds nothing on the page and in its dialogs: ${locale}, ${colorScheme}`,
      nightUnless(locale === 'en' && colorScheme === 'light'),
      async ({ browser, baseURL }) => {
        test.setTimeout(120_000);
        // axe adds a style sheet, which the policies of the pages block.
        const context = await browser.newContext({
          bypassCSP: true,
          ...(baseURL === undefined ? {} : { baseURL }),
          locale,
          colorScheme,
          viewport: { width: 1440, height: 900 },
        });
        const page = (await context.newPage()) as ChromiumPage;
        await open(page);
        const wrong = await violations(page, 'first');
        await type(page, PROGRAM);
        // Completions would open and close while axe runs; `completion` has its own tests. The list may open after the
        // first Escape, so wait until it stays closed.
        await expect(async () => {
          await page.keyboard.press('Escape');
          await page.waitForTimeout(500);
          expect(await page.getByRole('listbox').count()).toBe(0);
        }).toPass();
        await openProblems(page);
        wrong.push(...(await violations(page, 'with problems')));
        for (const [what, openIt] of Object.entries(OPENERS)) {
          await openIt(page);
          const shown = page.getByRole('dialog').or(page.getByRole('menu')).first();
          await expect(shown, what).toBeVisible();
          wrong.push(...(await violations(page, what)));
          if (what === 'own programs') {
            await page.locator('.own-programs .more-of').first().click();
            wrong.push(...(await violations(page, 'what can be done with a program')));
            await page.locator('.own-programs .acts button').nth(2).click();
            wrong.push(...(await violations(page, 'earlier states')));
          }
          for (let i = 0; i < 3 && (await page.getByRole('dialog').or(page.getByRole('menu')).count()) > 0; i++)
            await page.keyboard.press('Escape');
          await expect(page.getByRole('dialog').or(page.getByRole('menu')), what).toHaveCount(0);
        }
        await choose(page, 'more', /^(Compare with another version|与其他版本比较|Сравнить с другой версией)…$/);
        await page.getByRole('dialog').getByRole('textbox').fill(PROGRAM.replace('X48', 'X47'));
        await page
          .getByRole('dialog')
          .getByRole('button', { name: /^(Compare|比较|Сравнить)$/ })
          .click();
        await expect(
          page.getByRole('dialog').getByRole('img', { name: /^(Tool paths|两者的刀具轨迹|Траектории)/ }),
        ).toBeVisible();
        wrong.push(...(await violations(page, 'comparison')));
        await page.keyboard.press('Escape');
        await page.evaluate((hash) => void (location.hash = hash), await linked('task'));
        await page
          .getByRole('button', { name: /^(Copy link to hand in|复制用于提交的链接|Копировать ссылку для сдачи)$/ })
          .click();
        await page.getByRole('button', { name: /^(Show solution|显示答案|Показать решение)$/ }).click();
        await expect(page.locator('#solution a')).toHaveAttribute('href', /#share/);
        wrong.push(...(await violations(page, 'a task')));
        await page.evaluate((hash) => void (location.hash = hash), await linked('answer'));
        await expect(page.locator('#link-bar bdi')).toBeVisible();
        wrong.push(...(await violations(page, 'an answer')));
        await page.setViewportSize({ width: 390, height: 844 });
        wrong.push(...(await violations(page, 'on a phone')));
        for (const path of [
          `rules/${locale}/index.html`,
          `rules/${locale}/number-missing.html`,
          `manual/${locale}/feed.html`,
          'docs/index.html',
          'docs/element.html',
        ]) {
          const answer = await page.goto(`./${path}`);
          expect(answer?.ok(), path).toBe(true);
          wrong.push(...(await violations(page, path)));
        }
        expect(wrong).toEqual([]);
        await context.close();
      },
    );
  }
}

for (const colorScheme of ['light', 'dark'] as const) {
  test(
    `axe finds nothing in a manual with an element of each kind, and Tab reaches all of them in order: ${colorScheme}`,
    nightUnless(colorScheme === 'light'),
    async ({ page }) => {
      const kinds = [
        'view="all" caption="Figure 1"',
        'view="all" readonly lines="3-8" highlight="4" caption="Figure 2"',
        'view="picture" caption="Figure 3"',
        'view="playback" step="3" caption="Figure 4"',
        'view="code" caption="Figure 5"',
      ];
      const elements = kinds.map(
        (attributes) =>
          `<gcode-playground ${attributes} language="en"><pre slot="fallback">A</pre><pre>${PROGRAM}G999\n</pre></gcode-playground>`,
      );
      await openHtml(
        page,
        manual(
          `<main><h1>A manual</h1>${elements.join('')}</main>`,
          `<style>:root { color-scheme: ${colorScheme}; background: Canvas; color: CanvasText; }</style>`,
        ),
      );
      for (let which = 0; which < kinds.length; which++) await settled(page, which);
      expect(await violations(page, 'manual')).toEqual([]);
      // Tab moves through the elements in order; each focused control has a name.
      const stops: { element: number; name: string }[] = [];
      for (let at = 0; at < 200; at++) {
        await page.keyboard.press('Tab');
        const stop = await page.evaluate(() => {
          const host = document.activeElement;
          const inner = host?.shadowRoot?.activeElement;
          if (inner === null || inner === undefined) return undefined;
          const name =
            inner.getAttribute('aria-label') ??
            (inner.getAttribute('aria-labelledby') !== null ? 'labelled' : inner.textContent) ??
            '';
          return { element: [...document.querySelectorAll('gcode-playground')].indexOf(host!), name: name.trim() };
        });
        if (stop === undefined) break;
        stops.push(stop);
      }
      expect(stops.filter(({ name }) => name === '')).toEqual([]);
      const order = stops.map(({ element }) => element);
      expect(order).toEqual([...order].sort((a, b) => a - b));
      expect(new Set(order)).toEqual(new Set([0, 1, 2, 3, 4]));
      expect(
        stops.filter(({ element }) => element === 3).map(({ name }) => name.replace(/[.,(].*/, '').trim()),
      ).toEqual([
        'Show the whole path',
        'Drawing of the tool path',
        'Previous motion',
        'Play',
        'Next motion',
        'Position along the path',
        'Speed and steps: all in 20 s',
        'Show all',
        'Zoom in',
        'Zoom out',
        'Open in the playground',
      ]);
    },
  );
}
