// What axe finds wrong for readers of a screen: nothing, on the page, in every dialog, on pages of rules and of the
// reference, in each language, light and dark.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromiumTest as test, type ChromiumPage, expect } from './engines';
import { open, type } from './page';

const AXE = readFileSync(join(__dirname, '../../www/node_modules/axe-core/axe.min.js'), 'utf8');
const PROGRAM = 'O1\n/G50 S2000\nT0101\nG96 S150 M3\nG0 X52 Z2\nG90 X48 Z-30 F0.2\nX44\nX\nM01\nG0 X200 Z200\nM30\n';

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly target: readonly unknown[]; readonly failureSummary?: string }[];
}

/** What is wrong with the page as it is now, each with the places. */
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
  return found.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${where}: ${id}: ${JSON.stringify(target)} ${failureSummary ?? ''}`));
}

/** What opens a dialog, by the order of languages; `at-once` where it is a menu. */
const DIALOGS: readonly { readonly what: string; readonly button: RegExp }[] = [
  { what: 'gallery', button: /^(Gallery…|全部示例…|Все примеры…)$/ },
  { what: 'setup', button: /^(Setup|毛坯与刀具|Наладка)$/ },
  { what: 'machines', button: /^(Choose machine|选择机床|Выбрать станок)/ },
  { what: 'programs', button: /^(Programs|文本中的程序|程序…|Программы)/ },
  { what: 'solid', button: /^(3D|三维)/ },
  { what: 'export', button: /^(Export|导出|Экспорт)$/ },
  { what: 'cycles written out', button: /^(Expand cycles|展开循环|Развернуть циклы)$/ },
  { what: 'rewriting', button: /^(Write as a cycle…|写成循环…|Записать циклом…)$/ },
  { what: 'time', button: /^(Time|时间|Время)/ },
  { what: 'help', button: /^(Help|帮助|Справка) \(\?\)$/ },
];

for (const locale of ['en', 'zh', 'ru'] as const) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(`axe finds nothing on the page and in its dialogs: ${locale}, ${colorScheme}`, async ({ browser, baseURL }) => {
      test.setTimeout(120_000);
      const context = await browser.newContext({ ...(baseURL === undefined ? {} : { baseURL }), locale, colorScheme, viewport: { width: 1440, height: 900 } });
      const page = (await context.newPage()) as ChromiumPage;
      await open(page);
      const wrong = await violations(page, 'first');
      await type(page, PROGRAM);
      wrong.push(...(await violations(page, 'with problems')));
      for (const { what, button } of DIALOGS) {
        await page.getByRole('button', { name: button }).first().click();
        const shown = page.getByRole('dialog').or(page.getByRole('menu')).first();
        await expect(shown, what).toBeVisible();
        wrong.push(...(await violations(page, what)));
        if (what === 'help') {
          await page.getByRole('button', { name: /^(Supported codes|支持的代码|Поддерживаемые коды)$/ }).click();
          wrong.push(...(await violations(page, 'codes')));
        }
        for (let i = 0; i < 3 && (await page.getByRole('dialog').or(page.getByRole('menu')).count()) > 0; i++) await page.keyboard.press('Escape');
        await expect(page.getByRole('dialog')).toHaveCount(0);
      }
      await page.setViewportSize({ width: 390, height: 844 });
      wrong.push(...(await violations(page, 'on a phone')));
      for (const path of [`rules/${locale}/index.html`, `rules/${locale}/number-missing.html`, 'docs/index.html', 'docs/element.html']) {
        const answer = await page.goto(`./${path}`);
        expect(answer?.ok(), path).toBe(true);
        wrong.push(...(await violations(page, path)));
      }
      expect(wrong).toEqual([]);
      await context.close();
    });
  }
}
