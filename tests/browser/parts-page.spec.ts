// The page "Parts" shows the parts in each language, light and dark: no two controls overlap, none is cut off, and all
// icons are on one grid.
import { chromiumTest as test, expect } from './engines';

test('the parts of the page are shown in three languages, light and dark, without overlaps', async ({ page }) => {
  test.setTimeout(120_000);
  page.on('pageerror', (error) => {
    throw error;
  });
  await page.setViewportSize({ width: 1440, height: 1000 });
  await page.goto('./parts.html');
  const samples = page.getByRole('region', { name: /, (light|dark|浅色|深色)|, (светлая|тёмная)|，(浅色|深色)/ });
  await expect(samples).toHaveCount(6);
  const found: string[] = [];
  for (let at = 0; at < 6; at++) {
    const sample = samples.nth(at);
    for (const element of await sample.locator('gcode-playground').all()) {
      await element.scrollIntoViewIfNeeded();
      await expect(element.getByRole('button', { name: /^(Go to line|第|Строка|.*X|.*2O)/ }).first()).toBeVisible();
    }
    for (const name of [/^(Create|新建|Создать)$/, /^(Menu|菜单|Меню)$/])
      await expect(sample.getByRole('button', { name }).or(sample.getByRole('menu', { name })).first()).toBeVisible();
    await expect(sample.getByRole('dialog')).toBeVisible();
    // The key row and the tabs of the narrow element.
    await expect(sample.getByRole('toolbar').last()).toBeVisible();
    await expect(sample.getByRole('tab')).toHaveCount(3);
    found.push(
      ...(await sample.evaluate((section) => {
        const all: HTMLElement[] = [];
        const walk = (root: ParentNode): void => {
          for (const element of root.querySelectorAll<HTMLElement>('*')) {
            if (element.shadowRoot !== null) walk(element.shadowRoot);
            if (element.matches('button, select, a[href], input') && element.checkVisibility()) all.push(element);
          }
        };
        walk(section);
        const nameOf = (element: Element): string =>
          `${section.getAttribute('aria-label') ?? ''}: ${element.className} ${element.textContent ?? ''}`;
        // The part of the box that its scrolling ancestors show.
        const boxOf = (element: Element): DOMRect => {
          let { left, right, top, bottom } = element.getBoundingClientRect();
          const parentOf = (of: Element): Element | null =>
            of.assignedSlot ??
            of.parentElement ??
            ((of.getRootNode() as ShadowRoot).host as Element | undefined) ??
            null;
          for (let of = parentOf(element); of !== null && of !== section; of = parentOf(of)) {
            if (getComputedStyle(of).overflow === 'visible') continue;
            const box = of.getBoundingClientRect();
            [left, right] = [Math.max(left, box.left), Math.min(right, box.right)];
            [top, bottom] = [Math.max(top, box.top), Math.min(bottom, box.bottom)];
          }
          return new DOMRect(left, top, Math.max(0, right - left), Math.max(0, bottom - top));
        };
        const boxes = all.map(boxOf);
        const overlaps = all.flatMap((one, i) =>
          all.slice(i + 1).flatMap((other, j) => {
            const [a, b] = [boxes[i], boxes[i + 1 + j]];
            if (a === undefined || b === undefined || one.contains(other)) return [];
            const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            return across > 1 && down > 1 ? [`${nameOf(one)} | ${nameOf(other)}`] : [];
          }),
        );
        const bounds = section.getBoundingClientRect();
        const isScrolled = (element: Element): boolean => element.closest('.keys, .views') !== null;
        const outside = all.filter((element, at) => !isScrolled(element) && (boxes[at]?.right ?? 0) > bounds.right);
        return [...overlaps, ...outside.map((element) => `outside: ${nameOf(element)}`)];
      })),
    );
  }
  expect(found).toEqual([]);
});

test('every icon is on one grid, and in the middle of its button', async ({ page }) => {
  await page.goto('./parts.html');
  const icons = page.locator('.icons').first().locator('svg');
  await expect(icons.first()).toBeVisible();
  const off = await page
    .locator('.icons')
    .first()
    .evaluate((row) =>
      [...row.querySelectorAll('svg')].flatMap((svg) => {
        const { width, height } = svg.getBoundingClientRect();
        const boxes = [...svg.querySelectorAll('path')].map((path) => path.getBBox());
        const [top, bottom] = [
          Math.min(...boxes.map(({ y }) => y)),
          Math.max(...boxes.map(({ y, height }) => y + height)),
        ];
        const name = svg.parentElement?.className ?? '';
        return [
          ...(svg.getAttribute('viewBox') === '0 0 20 20' && width === height && [16, 20].includes(width)
            ? []
            : [`${name}: size`]),
          // Half a unit; an arrow that leaves a box may be higher.
          ...(Math.abs((top + bottom) / 2 - 10) <= 0.75 ? [] : [`${name}: ${top} to ${bottom}`]),
        ];
      }),
    );
  expect(off).toEqual([]);
  const buttons = await page
    .locator('.sample')
    .first()
    .evaluate((sample) =>
      [...sample.querySelectorAll('button:has(.icon)')].flatMap((button) => {
        const [box, icon] = [button.getBoundingClientRect(), button.querySelector('svg')?.getBoundingClientRect()];
        const middle = icon === undefined ? 0 : (icon.top + icon.bottom) / 2;
        return Math.abs((box.top + box.bottom) / 2 - middle) <= 0.5 ? [] : [button.textContent];
      }),
    );
  expect(buttons).toEqual([]);
});
