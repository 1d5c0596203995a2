// The files the page saves, made in the interpreter's own thread.
//
// In: the `Playground` and the kind of file. Out: its bytes. Must not know: what the files hold.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { FileFormat } from '../protocol/protocol';

/** Device pixels of a PNG to each CSS pixel of the drawing. */
const PNG_PIXELS = 2;

type File = Uint8Array<ArrayBuffer>;

export function fileOf(playground: Playground, format: FileFormat): File | undefined | Promise<File> {
  switch (format) {
    case 'card':
      return bytes(playground.card());
    case 'svg':
      return bytes(playground.svg());
    case 'png':
      return png(playground);
    case 'csv':
      return bytes(playground.csv());
    case 'dxf':
      return bytes(playground.dxf());
    case 'stl':
      return playground.stl() as File | undefined;
    case 'program':
      return bytes(playground.expand());
  }
}

function bytes(text: string | undefined): File | undefined {
  return text === undefined ? undefined : new TextEncoder().encode(text);
}

async function png(playground: Playground): Promise<File> {
  const canvas = new OffscreenCanvas(1, 1);
  playground.paint(canvas, PNG_PIXELS);
  const image = await canvas.convertToBlob({ type: 'image/png' });
  return new Uint8Array(await image.arrayBuffer());
}
