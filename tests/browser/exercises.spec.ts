// Exercises: a learner opens one, fails, takes a hint, passes, and finds the work and the progress again.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { FOREIGN, manual, openHtml } from './embedded';
import { expect, test, type BasicPage, type Locator } from './engines';
import { choose, chooseLanguage, editor, open, settled, titleText, type, type Playground } from './page';

const course = join(__dirname, '../../www/exercises/course.json');
const ids = JSON.parse(readFileSync(course, 'utf8')) as readonly string[];
const [id = ''] = ids;
const program = (name: string): string => readFileSync(join(__dirname, '../exercise', id, `${name}.nc`), 'utf8');

const report = (page: BasicPage): Locator => page.locator('.exercise-report');
const check = (page: BasicPage): Promise<void> => page.getByRole('button', { name: 'Check', exact: true }).click();

const openList = (page: BasicPage): Promise<void> => choose(page, 'program', 'Exercises…');

test('a learner fails, takes a hint, passes, reloads and goes on', async ({ page }) => {
  await open(page);
  await openList(page);
  const list = page.getByRole('dialog', { name: 'Exercises' });
  await expect(list.getByRole('listitem')).toHaveCount(ids.length);
  await expect(list.getByRole('status')).toContainText(`0 of ${ids.length} passed`);
  await list.getByRole('link').first().click();
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  await expect(page.getByRole('img', { name: 'Drawing of the part' })).toBeVisible();
  await expect(titleText(page)).toHaveText('Face a bar');
  const isKept = page.getByText('Your work on this exercise is kept');
  await settled(page);
  await expect(isKept).toBeHidden();

  await type(page, 'G00 X100 Z100\nM30');
  await check(page);
  await expect(page.locator('.exercise-verdict')).toHaveText('Not passed');
  // The report begins in view, with what failed.
  await expect(page.locator('.exercise-verdict')).toBeInViewport();
  await expect(page.getByRole('button', { name: 'Check', exact: true })).toBeInViewport();
  await expect(page.locator('.exercise-checks li').first()).toContainText('Not passed');
  await expect(isKept).toBeVisible();
  await expect(page.locator('.exercise-hints li')).toHaveCount(0);
  await page.getByRole('button', { name: 'Hint 1 of 3' }).click();
  await expect(page.locator('.exercise-hints li')).toHaveCount(1);

  await type(page, program('reference'));
  await check(page);
  await expect(page.locator('.exercise-verdict.passed')).toBeVisible();
  await expect(report(page)).not.toContainText('Not passed');
  await expect(page.getByText('Same part')).toBeVisible();
  await expect(page.getByRole('button', { name: 'End comparison' })).toBeHidden();
  await expect(page.getByRole('link', { name: /^Next exercise: \S/ })).toHaveAttribute('href', /^#exercise=/);

  await page.reload();
  await settled(page);
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  expect(await page.evaluate(() => document.querySelector<Playground>('gcode-playground')!.value.trim())).toBe(
    program('reference').trim(),
  );
  await openList(page);
  await expect(list.getByRole('status')).toContainText(`1 of ${ids.length} passed`);
  await expect(list.getByRole('link', { name: 'Certificate' })).toBeVisible();
});

test('the task is printed with an empty form, and the program with its task', async ({ page }) => {
  await page.addInitScript(() => {
    window.print = () => {
      dispatchEvent(new Event('beforeprint'));
      const sheet = document.querySelector('gcode-playground')?.shadowRoot?.querySelector('.sheet');
      const drawing = sheet?.querySelector('img');
      Reflect.set(window, 'printed', {
        text: sheet?.textContent ?? '',
        rows: sheet?.querySelectorAll('.sheet-form tbody tr').length,
        drawing: drawing === undefined || drawing === null ? 0 : drawing.naturalWidth,
      });
      dispatchEvent(new Event('afterprint'));
    };
  });
  await open(page, `#exercise=${id}`);
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  const task = ((await page.locator('.exercise-task').textContent()) ?? '').trim();
  await expect(page.locator('.exercise-buttons').getByRole('link', { name: 'Manual' })).toHaveAttribute(
    'href',
    /\/manual\/en\/[a-z0-9-]+\.html$/,
  );
  await expect(page.getByRole('img', { name: 'Drawing of the part' })).toBeVisible();
  await type(page, 'G00 X77 Z7\nM30');
  await settled(page);
  const printed = (): Promise<{ text: string; rows: number; drawing: number }> =>
    page.evaluate(() => Reflect.get(window, 'printed'));

  await page.getByRole('button', { name: 'Print the task' }).click();
  await expect.poll(async () => (await printed())?.rows).toBe(20);
  const sheet = await printed();
  expect(sheet.text).toContain(task);
  expect(sheet.text).toContain('Name:');
  expect(sheet.drawing).toBeGreaterThan(0);
  // A form does not show the program of the learner.
  expect(sheet.text).not.toContain('X77');

  await editor(page).focus();
  await page.keyboard.press('Control+P');
  await expect.poll(async () => (await printed())?.text).toContain('X77');
  expect((await printed()).text).toContain(task);
  expect((await printed()).rows).toBe(0);
});

test('an exercise is in the language of the page', async ({ page }) => {
  await open(page, `#exercise=${id}`);
  const task = page.locator('.exercise-task');
  await expect(task).toContainText(/\S/);
  const english = await task.textContent();
  await chooseLanguage(page, 'zh');
  await expect(page.getByRole('button', { name: '检查', exact: true })).toBeVisible();
  expect(await task.textContent()).not.toBe(english);
});

test('an element reports each check of its exercise', async ({ page }) => {
  await openHtml(page, manual(`<gcode-playground exercise="/exercises/${id}.md"></gcode-playground>`));
  await settled(page);
  await expect(page.locator('.exercise-task')).toContainText(/\S/);
  const detail = page.evaluate(
    () =>
      new Promise((resolve) =>
        document.addEventListener('gcode-checked', (event) => resolve((event as CustomEvent<object>).detail), {
          once: true,
        }),
      ),
  );
  await check(page);
  expect(await detail).toMatchObject({ id, passed: false, hints: 0 });
});

test('a frame reports each check of its exercise to the page around it', async ({ page }) => {
  const text = readFileSync(join(__dirname, '../../www/exercises', `${id}.md`), 'utf8');
  const address = `/index.html#exercise=${encodeURIComponent(text)}`;
  await page.goto(FOREIGN);
  await page.evaluate((address) => {
    const heard: unknown[] = [];
    Object.assign(window, { heard });
    addEventListener('message', ({ data }) => heard.push(data));
    const frame = document.createElement('iframe');
    frame.src = `/embed${address}`;
    document.body.append(frame);
  }, address);
  await expect
    .poll(() =>
      page.evaluate(() => {
        const frame = document.querySelector('iframe')!.contentDocument;
        const button = frame
          ?.querySelector('gcode-playground')
          ?.shadowRoot?.querySelector('.exercise-buttons .primary');
        (button as HTMLElement | null | undefined)?.click();
        return (Reflect.get(window, 'heard') as { type?: string; id?: string; passed?: boolean }[]).find(
          ({ type }) => type === 'gcode-playground:checked',
        );
      }),
    )
    .toMatchObject({ id, passed: false });
});

test('a faulty exercise file names its line', async ({ page }) => {
  await openHtml(page, manual('<gcode-playground exercise="data:text/plain,no%20head"></gcode-playground>'));
  await settled(page);
  await expect(report(page)).toContainText('The exercise file has a fault in line 1');
});
