// The files that the page exports, made in the worker.
//
// In: the `Playground` and the format. Out: the bytes of the file. Must not know: the content of the files.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { Exported, ExportFormat } from '../protocol/protocol';

/** Device pixels of a PNG for each CSS pixel of the drawing. */
const PNG_PIXELS = 2;

export function exported(playground: Playground, format: ExportFormat): Exported | Promise<Exported> {
  // The interpreter makes every other format; a PNG needs a canvas.
  if (format === 'png') return png(playground);
  const content = playground.exportFile(format) as Uint8Array<ArrayBuffer> | undefined;
  return content === undefined ? { kind: 'no-part' } : { kind: 'file', content, ending: playground.fileEnding(format) };
}

async function png(playground: Playground): Promise<Exported> {
  const canvas = new OffscreenCanvas(1, 1);
  playground.paint(canvas, PNG_PIXELS);
  const image = await canvas.convertToBlob({ type: 'image/png' });
  return { kind: 'file', content: new Uint8Array(await image.arrayBuffer()), ending: '.png' };
}
