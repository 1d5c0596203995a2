// The setup form: assumed values are marked, invalid values are reported at their fields, and the setup is stored where
// the user chooses. Invalid setups in any place are reported and still give a picture.
import { expect, test, type Locator, type Page, nightUnless } from './engines';
import {
  chip,
  choose,
  chooseControl,
  editor,
  locate,
  open,
  openFile,
  openProblems,
  openReading,
  problems,
  reading,
  reload,
  status,
  tooltip,
  value,
} from './page';

const PROGRAM = 'O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX44\nG0 X100 Z100\nM30\n';

/** Recognised as inches: no code selects the unit. */
const INCHES =
  'O0001 (PIN 1/2 IN)\nT0101\nG97 G99 S800 M03\nG00 X0.87 Z0.1\nG01 Z-1.125 F0.008\nX0.95\nG00 X2.0 Z2.0\nM30\n';

const setupButton = (page: Page): Locator => page.getByRole('button', { name: /^Setup/ });
const form = (page: Page): Locator => page.getByRole('dialog', { name: 'Setup' });
const field = (page: Page, group: string, name: string): Locator =>
  form(page).getByRole('region', { name: group }).getByLabel(name, { exact: true });
const attribute = (page: Page): Promise<string | null> => page.locator('gcode-playground').getAttribute('setup');

async function openForm(page: Page): Promise<void> {
  await setupButton(page).click();
  await expect(form(page)).toBeVisible();
}

/** The part is drawn where it has material: the pixel differs from the background. */
async function expectPart(page: Page): Promise<void> {
  await expect(status(page)).toContainText(/^4 motions/);
  await expect(page.getByText('No motion yet')).toBeHidden();
}

async function begin(page: Page, text = PROGRAM): Promise<void> {
  await open(page);
  await openFile(page, 'own.nc', Buffer.from(text));
  await expect(page.getByText('Opened own.nc')).toBeVisible();
  await expectPart(page);
}

test('unset values are shown as assumed, and can be set by keyboard', async ({ page }) => {
  await begin(page);
  await expect(page.getByText('Tools assumed')).toBeVisible();
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeVisible();
  await setupButton(page).focus();
  await page.keyboard.press('Enter');
  await expect(field(page, 'Stock', 'Diameter')).toBeFocused();
  await expect(field(page, 'Stock', 'Diameter')).toHaveAttribute('placeholder', '44 (assumed)');
  await expect(field(page, 'Tool T0101', 'Kind')).toContainText('turning tool (assumed)');
  await expect(field(page, 'Tool T0101', 'Width')).toBeHidden();
  await field(page, 'Tool T0101', 'Kind').selectOption('grooving');
  await expect(field(page, 'Tool T0101', 'Width')).toHaveAttribute('placeholder', '3 (assumed)');
  await field(page, 'Tool T0101', 'Kind').selectOption('');
  await field(page, 'Stock', 'Diameter').fill('50');
  await page.keyboard.press('Enter');
  await expect(form(page)).toBeHidden();
  await expect(page.getByText('Tools assumed')).toBeVisible();
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeHidden();
  expect(JSON.parse((await attribute(page)) ?? '')).toEqual({ stock: { diameter: 50, length: 25 } });
  expect(await value(page)).toBe(PROGRAM);

  await test.step('the setup is stored with the text', async () => {
    await reload(page);
    await expect(page.getByText('Tools assumed')).toBeVisible();
    expect(JSON.parse((await attribute(page)) ?? '')).toMatchObject({ stock: { diameter: 50 } });
  });
});

test('a blank is given by its outline, and its sizes are those around it', async ({ page }) => {
  await begin(page);
  await openForm(page);
  const outline = field(page, 'Stock', 'Outline, X0 Z2 X30 …');
  await outline.fill('X44 Z1 X44 Z-15 X60');
  await expect(form(page).getByText('Points as X and Z: X0 Z2 X30 Z2')).toBeVisible();
  await outline.fill('X44 Z1 X44 Z-15 X60 Z-15 Z-40');
  await field(page, 'Stock', 'Clamping length').fill('15');
  await form(page).getByRole('button', { name: 'Apply' }).click();
  await expect(form(page)).toBeHidden();
  const points = [
    [44, 1],
    [44, -15],
    [60, -15],
    [60, -40],
  ];
  expect(JSON.parse((await attribute(page)) ?? '')).toEqual({ stock: { outline: points, grip: 15 } });
  await expectPart(page);
  await openForm(page);
  await expect(outline).toHaveValue('X44 Z1 X44 Z-15 X60 Z-15 X60 Z-40');
  await expect(field(page, 'Stock', 'Diameter')).toHaveAttribute('placeholder', '60 (assumed)');
  await field(page, 'Stock', 'Diameter').fill('50');
  await expect(form(page).getByText('The outline gives this size')).toBeVisible();
});

test('an assumed stock can be accepted, and collisions are checked', async ({ page }) => {
  const crash = PROGRAM.replace('G0 X100 Z100', 'G0 X42 Z-23\nG0 X100 Z100');
  await open(page);
  await openFile(page, 'own.nc', Buffer.from(crash));
  const assumedNotice = page.getByText('Stock assumed: collisions not checked');
  const use = page.getByRole('button', { name: 'use this stock' });
  await expect(assumedNotice).toBeVisible();
  // Also in the closed list.
  const inList = page.getByRole('region', { name: 'Problems', exact: true, includeHidden: true });
  await expect(inList.getByText(/rapid/i)).toHaveCount(0);
  await use.focus();
  await page.keyboard.press('Enter');
  await expect(assumedNotice).toBeHidden();
  await expect(inList.getByText(/rapid/i)).not.toHaveCount(0);
  await expect(setupButton(page)).toBeFocused();
  await expect(page.getByText('The setup is kept on this page')).toBeVisible();
  expect(JSON.parse((await attribute(page)) ?? '')).toEqual({ stock: { diameter: 44, length: 25 } });
  expect(await value(page)).toBe(crash);
  await openProblems(page);
  await expect(problems(page).getByRole('listitem').filter({ hasText: /rapid/i }).first()).toBeVisible();

  await test.step('a setup in the program is changed in the program', async () => {
    await openFile(page, 'other.nc', Buffer.from(`(MACHINE RAPIDX=8000)\n${PROGRAM}`));
    await expect(assumedNotice).toBeVisible();
    await use.click();
    await expect.poll(() => value(page)).toBe(`(STOCK D=44 LENGTH=25)\n(MACHINE RAPIDX=8000)\n${PROGRAM}`);
    await expect(assumedNotice).toBeHidden();
  });
});

test('unapplied input is restored when the form is opened again, until the program changes', async ({ page }) => {
  await begin(page);
  const left = form(page).getByText('not applied yet');
  await openForm(page);
  await expect(left).toBeHidden();
  await field(page, 'Stock', 'Diameter').fill('50');
  await form(page).getByLabel('Another tool').fill('T0303');
  await form(page).getByRole('button', { name: 'Add' }).click();
  await field(page, 'Tool T0303', 'Kind').selectOption('grooving');
  await form(page).getByLabel('in the program, as comments').check();
  await page.keyboard.press('Escape');
  await expect(form(page)).toBeHidden();
  expect(await attribute(page)).toBeNull();

  await openForm(page);
  await expect(left).toBeVisible();
  await expect(field(page, 'Stock', 'Diameter')).toHaveValue('50');
  await expect(field(page, 'Tool T0303', 'Kind')).toHaveValue('grooving');
  await expect(form(page).getByLabel('in the program, as comments')).toBeChecked();
  await form(page).getByRole('button', { name: 'Discard them' }).click();
  await expect(left).toBeHidden();
  await expect(field(page, 'Stock', 'Diameter')).toHaveValue('');
  await expect(form(page).getByRole('region', { name: 'Tool T0303' })).toHaveCount(0);

  // It is kept while the program is edited, also in a collapsed group.
  await form(page).getByText('Machine', { exact: true }).click();
  const rapid = form(page).getByLabel('Rapid traverse X', { exact: true });
  await rapid.fill('9000');
  await page.keyboard.press('Escape');
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.insertText('T0404\n');
  await expect.poll(() => value(page)).toContain('O0001\nT0404');
  await openForm(page);
  await expect(left).toBeVisible();
  await expect(rapid).toBeVisible();
  await expect(rapid).toHaveValue('9000');
  await form(page).getByRole('button', { name: 'Discard them' }).click();

  // Applied input is no longer restored.
  await field(page, 'Stock', 'Diameter').fill('52');
  await page.keyboard.press('Enter');
  await expect(form(page)).toBeHidden();
  await openForm(page);
  await expect(left).toBeHidden();
  await expect(field(page, 'Stock', 'Diameter')).toHaveValue('52');
  await field(page, 'Stock', 'Diameter').fill('54');
  await form(page).getByRole('button', { name: 'Close' }).click();
  await openFile(page, 'other.nc', Buffer.from(PROGRAM));
  await expect.poll(() => value(page)).toBe(PROGRAM);
  await openForm(page);
  await expect(left).toBeHidden();
  await expect(field(page, 'Stock', 'Diameter')).toHaveValue('');
});

test('a setup stored in the program is written as comments, and one undo removes them', async ({ page }) => {
  await begin(page);
  await openForm(page);
  await field(page, 'Stock', 'Diameter').fill('50');
  await field(page, 'Tool T0101', 'Nose radius').fill('0,8');
  await form(page).getByRole('radio', { name: 'in the program, as comments' }).check();
  await form(page).getByRole('button', { name: 'Apply' }).click();
  await expect(page.getByText('The setup is in the program now')).toBeVisible();
  const lines = (await value(page)).split('\n');
  expect(lines.slice(0, 3)).toEqual([
    'O0001',
    '(STOCK D=50 LENGTH=25)',
    '(TOOL T0101 TYPE=TURNING INSERT=C R=0.8 KR=95)',
  ]);
  await expect(page.getByText('Tools assumed')).toBeHidden();
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeHidden();

  await test.step('the form edits the comments', async () => {
    await openForm(page);
    await expect(form(page).getByRole('radio', { name: 'in the program, as comments' })).toBeChecked();
    await expect(field(page, 'Stock', 'Diameter')).toHaveValue('50');
    await field(page, 'Stock', 'Diameter').fill('55');
    await form(page).getByRole('button', { name: 'Apply' }).click();
    await expect.poll(() => value(page)).toContain('(STOCK D=55 LENGTH=25)');
  });
  await editor(page).focus();
  await page.keyboard.press('Control+z');
  expect(await value(page)).toContain('(STOCK D=50 LENGTH=25)');
  await page.keyboard.press('Control+z');
  expect(await value(page)).toBe(PROGRAM);
});

test('wear is entered with the offset of a tool, and moves the part', async ({ page }) => {
  await begin(page);
  await openForm(page);
  await expect(field(page, 'Tool T0101', 'Wear X')).toBeHidden();
  await form(page).getByText('Tool offset: geometry and wear').click();
  await field(page, 'Tool T0101', 'Wear X').fill('0.04');
  await form(page).getByRole('radio', { name: 'in the program, as comments' }).check();
  await form(page).getByRole('button', { name: 'Apply' }).click();
  await expect.poll(() => value(page)).toContain('WEARX=0.04');
  // X40 leaves 40.04 mm.
  const inside = await locate(page, 20, -10);
  await page.mouse.move(inside.x, inside.y);
  await expect(tooltip(page)).toContainText('Ø40.04');
});

test('a tool can be added', async ({ page }) => {
  await begin(page);
  await openForm(page);
  await form(page).getByLabel('Another tool').fill('hammer');
  await form(page).getByRole('button', { name: 'Add' }).click();
  await expect(form(page).getByText('Write T and up to four digits')).toBeVisible();
  await form(page).getByLabel('Another tool').fill('3');
  await form(page).getByRole('button', { name: 'Add' }).click();
  await expect(field(page, 'Tool T0303', 'Kind')).toBeFocused();
});

const pictureButton = (page: Page, label: string): Locator =>
  form(page)
    .getByRole('region', { name: 'Tool T0101' })
    .getByRole('button', { name: `${label}: choose by picture` });
const picture = (page: Page, name: string): Locator => form(page).getByRole('radio', { name, exact: true });

test('the tip direction is chosen by picture, for the side of the turret in force', async ({ page }) => {
  await begin(page);
  await openForm(page);
  const tip = field(page, 'Tool T0101', 'Tool-tip direction');
  const button = pictureButton(page, 'Tool-tip direction');
  const isAbove = async (one: string, other: string): Promise<boolean> =>
    ((await picture(page, one).boundingBox())?.y ?? 0) < ((await picture(page, other).boundingBox())?.y ?? 0);

  await test.step('by keys', async () => {
    await expect(tip).toHaveAttribute('placeholder', '3 (assumed)');
    await button.focus();
    await page.keyboard.press('Enter');
    await expect(form(page).getByRole('radio')).toHaveCount(9 + 2);
    // The assumed one has the focus, but is not chosen.
    await expect(picture(page, '3, X− Z−')).toBeFocused();
    await expect(picture(page, '3, X− Z−')).toHaveAttribute('aria-checked', 'false');
    expect(await isAbove('2, X+ Z−', '3, X− Z−')).toBe(true);
    // The picture above 3 is 7, and above 7 is 2.
    await page.keyboard.press('ArrowUp');
    await expect(picture(page, '7, Z−')).toHaveAttribute('aria-checked', 'true');
    await expect(tip).toHaveValue('7');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Enter');
    await expect(picture(page, '2, X+ Z−')).toBeHidden();
    await expect(button).toBeFocused();
    await expect(tip).toHaveValue('2');
    await expect(form(page)).toBeVisible();
  });
  await test.step('Escape closes the pictures, not the form', async () => {
    await button.click();
    await expect(picture(page, '2, X+ Z−')).toHaveAttribute('aria-checked', 'true');
    await page.keyboard.press('Escape');
    await expect(picture(page, '2, X+ Z−')).toBeHidden();
    await expect(form(page)).toBeVisible();
  });
  await test.step('a typed 9 is the centre, and stays', async () => {
    await tip.fill('9');
    await button.click();
    await expect(picture(page, '0, 9, centre of the nose')).toHaveAttribute('aria-checked', 'true');
    await page.keyboard.press('Escape');
    await expect(tip).toHaveValue('9');
  });
  await test.step('with the turret in front, X+ is below', async () => {
    await form(page).getByText('Machine', { exact: true }).click();
    await form(page).getByLabel('Turret', { exact: true }).selectOption('front');
    await button.click();
    expect(await isAbove('3, X− Z−', '2, X+ Z−')).toBe(true);
    await picture(page, '4, X− Z+').click();
    await expect(picture(page, '4, X− Z+')).toBeHidden();
    await form(page).getByRole('button', { name: 'Apply' }).click();
    await expect(form(page)).toBeHidden();
    expect(JSON.parse((await attribute(page)) ?? '')).toMatchObject({
      machine: { turret: 'front' },
      tools: { T0101: { tip: 4 } },
    });
  });
  await test.step('the side in the picture counts, too', async () => {
    await choose(page, 'more', /^Front turret/);
    await openForm(page);
    // The form is filled in.
    await expect(tip).toHaveValue('4');
    await button.click();
    await expect(picture(page, '2, X+ Z−')).toBeVisible();
    expect(await isAbove('2, X+ Z−', '3, X− Z−')).toBe(true);
  });
});

test('the shape of an insert is chosen by picture, and the rest of its designation stays', async ({ page }) => {
  await begin(page);
  await openForm(page);
  const insert = field(page, 'Tool T0101', 'Insert (ISO)');
  await expect(insert).toHaveAttribute('placeholder', 'C (assumed)');
  await pictureButton(page, 'Insert (ISO)').click();
  await picture(page, 'V, 35°').click();
  await expect(insert).toHaveValue('V');
  await insert.fill('CNMG120408');
  await expect(field(page, 'Tool T0101', 'Point angle')).toHaveAttribute('placeholder', '80 (assumed)');
  await pictureButton(page, 'Insert (ISO)').click();
  await expect(picture(page, 'C, 80°')).toHaveAttribute('aria-checked', 'true');
  await picture(page, 'D, 55°').click();
  await expect(insert).toHaveValue('DNMG120408');
  await expect(field(page, 'Tool T0101', 'Point angle')).toHaveAttribute('placeholder', '55 (assumed)');

  // A threading insert has no such shape.
  await field(page, 'Tool T0101', 'Kind').selectOption('threading');
  await expect(pictureButton(page, 'Insert (ISO)')).toBeHidden();
  await expect(insert).toHaveValue('DNMG120408');
  await expect(pictureButton(page, 'Tool-tip direction')).toBeVisible();
});

test('the rapid rate and the unit that the run assumes are shown in the fields', async ({ page }) => {
  await begin(page);
  await openForm(page);
  await form(page).getByText('Machine', { exact: true }).click();
  const rapid = (axis: string): Locator => form(page).getByLabel(`Rapid traverse ${axis}`, { exact: true });
  for (const axis of ['X', 'Z']) await expect(rapid(axis)).toHaveAttribute('placeholder', '8000 (assumed)');
  await form(page).getByText('Control', { exact: true }).first().click();
  const unit = form(page).getByLabel('Unit without G20 or G21', { exact: true });
  await expect(unit).toContainText('mm (assumed)');
  await form(page).getByRole('button', { name: 'Close' }).click();
  await openFile(page, 'inch.nc', Buffer.from(INCHES));
  await expect(chip(page)).toContainText('inch');
  await openForm(page);
  await expect(unit).toContainText('inch (assumed)');
});

test('invalid values are reported at their fields', async ({ page }) => {
  await begin(page);
  await openForm(page);
  for (const [name, text, message] of [
    ['Diameter', '-60', 'Must be greater than zero'],
    ['Diameter', 'NaN', 'Not a number'],
    ['Diameter', '1e999', 'Not a number'],
    ['Bore diameter', '70', 'Must be less than 44'],
  ] as const) {
    await field(page, 'Stock', 'Diameter').fill('');
    await field(page, 'Stock', name).fill(text);
    await expect(field(page, 'Stock', name)).toHaveAttribute('aria-invalid', 'true');
    await expect(form(page).getByText(message)).toBeVisible();
    await form(page).getByRole('button', { name: 'Apply' }).click();
    await expect(form(page)).toBeVisible();
    await expect(field(page, 'Stock', name)).toBeFocused();
  }
  await form(page).getByRole('button', { name: 'Close' }).click();
  await expectPart(page);
});

for (const [what, setup, message, where] of [
  ['negative stock', '{"stock": {"diameter": -60, "length": 80}}', /stock.diameter.* is -60/, 'problems'],
  [
    'a bore larger than the stock',
    '{"stock": {"diameter": 60, "length": 80, "bore": 70}}',
    /stock.bore.* is 70/,
    'problems',
  ],
  ['NaN', '{"stock": {"diameter": NaN, "length": 80}}', /The setup was not accepted/, 'alert'],
  ['garbage', 'garbage', /The setup was not accepted/, 'alert'],
  ['a tool that is missing', '{"tools": {"T0202": {"type": "turning"}}}', /T0101/, 'problems'],
] as const) {
  test(
    `an invalid setup in the attribute is reported: ${what}`,
    nightUnless(what === 'negative stock' || what === 'garbage'),
    async ({ page }) => {
      await begin(page);
      await page.locator('gcode-playground').evaluate((element, json) => element.setAttribute('setup', json), setup);
      if (where === 'alert') await expect(page.getByRole('alert').filter({ hasText: message })).toBeVisible();
      else {
        await openProblems(page);
        await expect(problems(page).getByText(message).first()).toBeVisible();
      }
      await expectPart(page);
      await openForm(page);
    },
  );
}

for (const [what, note, message] of [
  ['negative stock', '(STOCK D=-60 LENGTH=80)', /stock.diameter.* is -60/],
  ['a bore larger than the stock', '(STOCK D=60 BORE=70 LENGTH=80)', /stock.bore.* is 70/],
  ['NaN', '(STOCK D=NaN LENGTH=80)', /D=NaN/],
  ['garbage', '(STOCK D=60 LENGTH=80 HAMMER=1)', /HAMMER=1/],
  ['a tool that is missing', '(TOOL T0202 TYPE=TURNING)', /T0101/],
] as const) {
  test(
    `an invalid setup in comments is reported: ${what}`,
    nightUnless(what === 'negative stock' || what === 'garbage'),
    async ({ page }) => {
      await begin(page, `${note}\n${PROGRAM}`);
      await expect(problems(page).getByText(message).first()).toBeVisible();
      await expectPart(page);
      await openForm(page);
    },
  );
}

test('an opened file, and a cleared editor, start without the setup of the example', async ({ page }) => {
  await open(page, '#s001-o6003');
  const before = await attribute(page);
  expect(before).toContain('stock');
  await openFile(page, 'own.nc', Buffer.from(PROGRAM));
  await expect(page.getByText('Stock assumed: collisions not checked')).toBeVisible();
  expect((await attribute(page)) ?? '').not.toContain('stock');

  await test.step('undo restores the example and its setup', async () => {
    await editor(page).focus();
    await page.keyboard.press('Control+z');
    await expect.poll(() => attribute(page)).toBe(before);
    await page.keyboard.press('Control+A');
    await page.keyboard.press('Delete');
    expect((await attribute(page)) ?? '').not.toContain('stock');
    await page.keyboard.press('Control+z');
    await expect.poll(() => attribute(page)).toBe(before);
  });
  await test.step('the control changes with the program, too', async () => {
    await chooseControl(page, 'gsk');
    await expect(chip(page)).toContainText('GSK 980TD');
    const chosen = await attribute(page);
    await openFile(page, 'own.nc', Buffer.from(PROGRAM));
    await expect(page.getByText('Stock assumed: collisions not checked')).toBeVisible();
    await expect(chip(page)).toContainText('FANUC');
    await editor(page).focus();
    await page.keyboard.press('Control+z');
    await expect(chip(page)).toContainText('GSK 980TD');
    expect(chosen).toContain('gsk');
    expect(await attribute(page)).toBe(chosen);
  });
});

test('computing the part of a long program shows progress, and can be stopped', async ({ page }) => {
  await open(page);
  // Each pass leaves a wave, so that the part has many corners.
  const passes = Array.from(
    { length: 15_000 },
    (_, i) => `G1 X${(60 - i / 1000 - (i % 2) * 0.1).toFixed(3)} Z${(-(i % 300) / 3).toFixed(3)} F0.2`,
  );
  // A fast machine may finish before a polling test presses the button, so a script in the page presses it.
  const progressText = page.locator('gcode-playground').evaluate(
    (element) =>
      new Promise<string>((done) => {
        const look = (): void => {
          const root = element.shadowRoot!;
          const status = root.querySelector('[part~="status"]')?.textContent ?? '';
          const stop = [...root.querySelectorAll('button')].find(
            (button) => button.textContent === 'Stop' && button.checkVisibility(),
          );
          if (stop === undefined || !/Part … \d+ %/.test(status)) {
            requestAnimationFrame(look);
            return;
          }
          stop.click();
          done(status);
        };
        look();
      }),
  );
  await openFile(page, 'long.nc', Buffer.from(`T0101 S800 M3\nG0 X62 Z2\n${passes.join('\n')}\nM30\n`));
  expect(await progressText).toContain('Part');
  await openProblems(page);
  await expect(problems(page).getByText(/The material removal was stopped after \d+ of 15001 motions/)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Stop', exact: true })).toBeHidden();
});

test('the chip and the status say how numbers without a point are read, and the reading can be changed', async ({
  page,
}) => {
  const inches = 'O0001\nG20 G99 T0101\nG97 S800 M3\nG0 X2. Z.1\nG1 X1. F.016\nZ-1.\nX2.\nG0 W2000\nM30\n';
  await open(page);
  await openFile(page, 'inch.nc', Buffer.from(inches.replace('W2000', 'W.2')));
  await expect(status(page)).toContainText('motions');
  await expect(status(page)).not.toContainText('No point');
  await openFile(page, 'inch.nc', Buffer.from(inches));
  await expect(status(page)).toContainText('No point = 0.0001 in: W2000 is 0.2 in');
  await expect(chip(page)).toContainText('no point = 0.0001 in');
  await openReading(page);
  await reading(page).getByRole('button', { name: 'no point = 0.0001 in (recognised)' }).click();
  const choice = form(page).getByLabel('Number without a point');
  await expect(choice).toBeFocused();
  await choice.selectOption('calculator');
  await form(page).getByRole('button', { name: 'Apply' }).click();
  await expect(form(page)).toBeHidden();
  await expect(status(page)).toContainText('W2000 is read as 2000 in');
  await expect(chip(page)).toContainText('no point = in');
});

test('the reading of numbers is detected for an opened file, not for typed text', async ({ page }) => {
  const rest = 'G20 G99 T0101\nG97 S800 M3\nG0 X2. Z2.\nG1 Z-1. F.01\nX3.\nG0 X4. Z3.\nM30\n';
  await begin(page, `O0001\n${rest}`);
  await editor(page).focus();
  await page.keyboard.press('Control+Home');
  await page.keyboard.press('End');
  await page.keyboard.type('\nG04 X2000');
  await expect(status(page)).toContainText('X2000 is read as 2000 s');
  await openFile(page, 'dwell.nc', Buffer.from(`O0001\nG04 X2000\n${rest}`));
  await expect(status(page)).toContainText('X2000 is 2 s');
});
