// The worker's half of the pictures: the section, the end face and the side, each on a separate canvas.
//
// In: changes of a picture. Out: images, and the contents of the views besides the section. Must not know: when to
// draw.

import { Drawn, type PictureName, type Playground } from '../../pkg/gcode_playground.js';
import { PICTURES, type CanvasCommand, type Pictures, type SectionScale, type ViewsState } from '../protocol/protocol';

type CanvasHandler<K extends CanvasCommand['kind']> = (
  core: Playground,
  picture: PictureName,
  command: Extract<CanvasCommand, { readonly kind: K }>,
) => void;

const CANVAS_HANDLERS: { readonly [K in CanvasCommand['kind']]: CanvasHandler<K> } = {
  canvas(core, picture, { size }) {
    core.attachCanvas(picture, new OffscreenCanvas(1, 1));
    core.resize(picture, size.width, size.height, size.pixelRatio);
  },
  resize: (core, picture, { size }) => core.resize(picture, size.width, size.height, size.pixelRatio),
  repaint: (core) => core.paintAgain(),
  fit: (core, picture) => core.fit(picture),
  pan: (core, picture, { dx, dy }) => core.pan(picture, dx, dy),
  zoom: (core, picture, { factor, x, y }) => core.zoom(picture, factor, x, y),
};

export function changePicture(core: Playground, picture: PictureName, command: CanvasCommand): void {
  (CANVAS_HANDLERS[command.kind] as CanvasHandler<typeof command.kind>)(core, picture, command);
}

/** Fits each picture to its content. */
export function fitAll(core: Playground): void {
  for (const picture of PICTURES) core.fit(picture);
}

/** Paints the pictures of the current run; returns the state of the first one that is not finished. */
export function drawAll(core: Playground): Drawn {
  return PICTURES.map((picture) => core.draw(picture)).find((drawn) => drawn !== Drawn.All) ?? Drawn.All;
}

/** Takes the images painted since the last call. */
export function takePictures(core: Playground): Pictures | undefined {
  const images: Partial<Record<PictureName, ImageBitmap>> = {};
  for (const picture of PICTURES) {
    const image = core.takeImage(picture);
    if (image !== undefined) images[picture] = image;
  }
  return Object.keys(images).length === 0 ? undefined : images;
}

/** A length from which the scale of the section is computed, mm. */
const SCALE_LENGTH = 100;

export function sectionScale(core: Playground): SectionScale {
  const [x0 = 0, y0 = 0] = core.screenOf('section', 0, 0);
  const [x1 = 0, y1 = 0] = core.screenOf('section', SCALE_LENGTH, SCALE_LENGTH);
  return { origin: [x0, y0], perZ: (x1 - x0) / SCALE_LENGTH, perX: (y1 - y0) / SCALE_LENGTH };
}

export function viewsState(core: Playground): ViewsState {
  const pictures = PICTURES.filter((picture) => picture === 'section' || core.has(picture));
  return { pictures, work: core.workShown(), turret: core.turret(), comparison: core.comparison() };
}
