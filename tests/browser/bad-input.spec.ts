// With any bad input, the page responds within seconds, shows a message, and keeps working.
import { chromiumTest, expect, test, type Page, nightUnless } from './engines';
import { chooseFile, open, openFile, openProblems, problems, status, type } from './page';

const FIVE_MB = 5 * 1024 * 1024;

/** After the bad text, a good program must run as usual. */
async function stillWorks(page: Page): Promise<void> {
  await openFile(page, 'good.nc', Buffer.from('G0 X50 Z2\nG1 Z-20 F0.2\n'));
  await expect(status(page)).toContainText(/^2 motions/, { timeout: 15_000 });
}

test('the page handles an empty text', async ({ page }) => {
  await open(page);
  await type(page, '');
  await expect(status(page)).toContainText(/^0 motions/);
  await expect(page.getByText('No motion yet')).toBeVisible();
  await stillWorks(page);
});

test('the page handles a single opening parenthesis', async ({ page }) => {
  await open(page);
  await type(page, '(');
  await expect(status(page)).toContainText('1 problem');
  await openProblems(page);
  await expect(problems(page).getByRole('listitem')).toHaveCount(1);
  await stillWorks(page);
});

for (const byte of ['X', '(', '0', '\n', '%']) {
  test(`the page handles 5 MB of ${JSON.stringify(byte)}`, nightUnless(byte === 'X'), async ({ page }) => {
    await open(page);
    await chooseFile(page, 'same.nc', new Uint8Array(FIVE_MB).fill(byte.charCodeAt(0)));
    await expect(page.getByText('Opened same.nc')).toBeVisible();
    await expect(status(page)).toContainText(/^0 motions/, { timeout: 15_000 });
    await stillWorks(page);
  });
}

test('the page handles a program of 200,000 lines inside the element, with as many blank lines before it', async ({
  page,
}) => {
  await open(page);
  const length = await page.evaluate(() => {
    const element = document.createElement('gcode-playground') as HTMLElement & { value: string };
    element.textContent = `${'\n'.repeat(200_000)}${'  G4 X1\n'.repeat(200_000)}`;
    document.body.append(element);
    const { length } = element.value;
    element.remove();
    return length;
  });
  expect(length).toBe('G4 X1\n'.length * 200_000 - 1);
  await stillWorks(page);
});

chromiumTest('a report of a long text is made in linear time', async () => {
  const [{ makeFixture, reportText }, { REPORT_WORDS }] = await Promise.all([
    import('../../www/src/page/report'),
    import('../../www/src/page/report-words'),
  ]);
  const start = performance.now();
  const report = {
    text: `${'\n'.repeat(300_000)}${'`a'.repeat(300_000)}\nO12\n`,
    setup: '{}',
    line: 1,
    motions: [],
    machine: '',
    did: '',
    versions: '',
    link: undefined,
  };
  expect(makeFixture(report).name).toBe('machine-o12');
  expect(reportText(report, REPORT_WORDS.en)).toContain('```gcode');
  expect(performance.now() - start).toBeLessThan(2000);
});

test('the page handles a binary file', async ({ page }) => {
  await open(page);
  const bytes = new Uint8Array(256 * 1024).map((_, i) => (i * 7919 + (i >> 8) * 31) & 0xff);
  await chooseFile(page, 'picture.png', bytes);
  await expect(page.getByText(/does not look like text/)).toBeVisible();
  await expect(status(page)).toContainText(/problem/, { timeout: 15_000 });
  await stillWorks(page);
});
