// Renders the small picture of a program, in the gallery and in the list of saved programs.
//
// In: strokes as SVG paths. Out: the drawing; its colours come from the style sheet of the dialog. Must not know: how
// the strokes were computed.

import type { SmallPicture } from '../../small-picture';

/** The size for which `small-picture.ts` computes the paths. */
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
