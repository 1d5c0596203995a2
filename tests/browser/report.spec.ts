// The report of a difference to the user's machine as a text, and as a folder for tests/programs.
import { readFileSync } from 'node:fs';
import { unzipSync, strFromU8 } from 'fflate';
import { chromiumTest as test, type ChromiumPage, expect, nightUnless } from './engines';
import { choose, open, type } from './page';

const PROGRAM =
  'O0042\n(STOCK D=60 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X62 Z2\nG90 X50 Z-20 F0.2\nX40\nG00 X100 Z100\nM30\n';
/** The steps of G90: infeed, cut, retract, return. */
const DRAWN = [
  ['rapid', 40, 2],
  ['feed', 40, -20],
  ['feed', 62, -20],
  ['rapid', 62, 2],
] as const;

const WORDS = {
  en: {
    language: 'English',
    open: 'Report a difference to my machine…',
    machine: 'Machine and control',
    did: 'What the machine did',
    line: 'Line of the block',
    copy: 'Copy',
    save: 'Save as a folder for tests',
  },
  zh: {
    language: '中文',
    open: '报告与我的机床不同之处…',
    machine: '机床与数控系统',
    did: '机床的实际动作',
    line: '程序段所在行',
    copy: '复制',
    save: '保存为测试文件夹',
  },
  ru: {
    language: 'Русский',
    open: 'Сообщить об отличии от моего станка…',
    machine: 'Станок и система ЧПУ',
    did: 'Что сделал станок',
    line: 'Строка кадра',
    copy: 'Копировать',
    save: 'Сохранить папку для тестов',
  },
} as const;

async function openReport(page: ChromiumPage, language: keyof typeof WORDS): Promise<void> {
  await choose(page, 'more', WORDS[language].open);
}

for (const language of ['en', 'zh', 'ru'] as const) {
  test(
    `a report contains program, setup, block, drawn motions and the machine's behaviour: ${language}`,
    nightUnless(language === 'en'),
    async ({ page, context }) => {
      await context.grantPermissions(['clipboard-read', 'clipboard-write']);
      const words = WORDS[language];
      await open(page);
      await type(page, PROGRAM);
      await choose(page, 'more', words.language);
      await openReport(page, language);
      const dialog = page.getByRole('dialog');
      await dialog.getByLabel(words.machine).fill('GSK 980TDb');
      await dialog.getByLabel(words.line).fill('7');
      await expect(dialog.locator('.block')).toHaveText('X40');
      await dialog.getByLabel(words.did).fill('It stood at X60 Z2.');
      const output = dialog.locator('#report-output');
      await expect(output).toHaveValue(/\| feed \| 40 \| -20 \|/);
      await expect(output).toHaveValue(/#share=1\./);
      await dialog.getByRole('button', { name: words.copy, exact: true }).click();
      const text = await page.evaluate(() => navigator.clipboard.readText());
      expect(text).toBe(await output.inputValue());
      for (const part of ['GSK 980TDb', '`X40`', 'It stood at X60 Z2.', PROGRAM.trim(), 'G-code playground 0.'])
        expect(text).toContain(part);

      const saved = page.waitForEvent('download');
      await dialog.getByRole('button', { name: words.save }).click();
      const download = await saved;
      expect(download.suggestedFilename()).toBe('machine-o0042.zip');
      const files = unzipSync(readFileSync(await download.path()));
      const file = (name: string): string => strFromU8(files[`machine-o0042/${name}`] ?? new Uint8Array());
      expect(
        Object.keys(files)
          .filter((name) => !name.endsWith('/'))
          .sort(),
      ).toEqual(
        ['about.json', 'expect.json', 'motions.jsonl', 'program.nc', 'setup.json'].map(
          (name) => `machine-o0042/${name}`,
        ),
      );
      expect(file('program.nc')).toBe(PROGRAM);
      const about = JSON.parse(file('about.json')) as { readonly seed: string; readonly source: string };
      expect(about.seed).toBe('machine');
      expect(about.source).toContain('GSK 980TDb, block 7: It stood at X60 Z2.');
      expect(typeof JSON.parse(file('setup.json'))).toBe('object');
      const motions = file('motions.jsonl')
        .trim()
        .split('\n')
        .map((row) => JSON.parse(row) as { kind: string; line: number; to: { x: number; z: number } });
      expect(motions.filter(({ line }) => line === 7).map(({ kind, to }) => [kind, to.x, to.z])).toEqual(DRAWN);
    },
  );
}

test('the report waits for the motions, and cannot be copied before', async ({ page }) => {
  await open(page);
  await type(page, PROGRAM);
  // Delay the table of motions.
  await page
    .locator('gcode-playground')
    .evaluate((element: HTMLElement & { exported(format: string): Promise<unknown> }) => {
      const own = element.exported.bind(element);
      element.exported = async (format) => {
        await new Promise((done) => setTimeout(done, 1500));
        return own(format);
      };
    });
  await openReport(page, 'en');
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByText('The report is being prepared…')).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Copy', exact: true })).toBeDisabled();
  await expect(dialog.locator('#report-output')).toHaveValue('');
  await expect(dialog.locator('#report-output')).toHaveValue(/What the playground draws there/);
  await expect(dialog.getByRole('button', { name: 'Copy', exact: true })).toBeEnabled();
});

test('backticks in a program do not break its report, and the link in the report opens the program', async ({
  page,
}) => {
  await open(page);
  await type(page, '(A ``` B)\nG00 X40 Z2\nM30\n');
  await openReport(page, 'en');
  const output = page.getByRole('dialog').locator('#report-output');
  await expect(output).toHaveValue(/````gcode\n\(A ``` B\)\nG00 X40 Z2\nM30\n````/);
  await expect(output).toHaveValue(/#share=1\./);
  const link = /\*\*Open it\*\*: (\S+)/.exec(await output.inputValue())?.[1] ?? '';
  await page.goto('about:blank');
  await page.goto(link);
  await expect(page.getByText('(A ``` B)')).toBeVisible();
});
