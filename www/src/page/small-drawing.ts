// A small picture of a program as an element, in the gallery and in the list of the reader's own programs.
//
// In: strokes as paths of SVG. Out: the drawing; its colours come from the style sheet of the dialog. Must not know:
// how the strokes were found.

import type { SmallPicture } from '../../small-picture';

/** As the small pictures are drawn (`small-picture.ts`). */
const [WIDTH, HEIGHT] = [240, 144];
const SVG = 'http://www.w3.org/2000/svg';

export function smallDrawing(picture: SmallPicture | undefined): Element {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
  svg.setAttribute('aria-hidden', 'true');
  const path = (className: string, d: string): void => {
    const drawn = svg.appendChild(document.createElementNS(SVG, 'path'));
    drawn.setAttribute('class', className);
    drawn.setAttribute('d', d);
  };
  if (picture?.axis !== undefined) path('axis', `M0 ${picture.axis}H${WIDTH}`);
  path('rapid', picture?.rapid ?? '');
  path('cut', picture?.cut ?? '');
  return svg;
}
