// Colours in the drawing.
import type { BasicPage } from './engines';

/** Number of pixels in the section that have a colour of the style sheet. */
export function pixels(page: Pick<BasicPage, 'evaluate'>, colour: string): Promise<number> {
  return page.evaluate((colour) => {
    const root = document.querySelector('gcode-playground')!.shadowRoot!;
    const canvas = root.querySelector('canvas')!;
    const probe = root.querySelector('[part~=drawing]')!.appendChild(document.createElement('span'));
    probe.style.color = `var(--playground-${colour})`;
    const [red = 0, green = 0, blue = 0] = (getComputedStyle(probe).color.match(/[\d.]+/g) ?? []).map(Number);
    probe.remove();
    const context = Object.assign(document.createElement('canvas'), {
      width: canvas.width,
      height: canvas.height,
    }).getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let found = 0;
    for (let at = 0; at < data.length; at += 4) {
      if (Math.abs(data[at]! - red) + Math.abs(data[at + 1]! - green) + Math.abs(data[at + 2]! - blue) < 40) found++;
    }
    return found;
  }, colour);
}
