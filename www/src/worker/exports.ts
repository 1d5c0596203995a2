// The files that the page exports, made in the worker.
//
// In: the `Playground` and the format. Out: the bytes of the file. Must not know: the content of the files.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { ExportResult, ExportFormat } from '../protocol/protocol';

/** Device pixels of a PNG for each CSS pixel of the drawing. */
const PNG_PIXEL_RATIO = 2;

export function exportFile(playground: Playground, format: ExportFormat): ExportResult | Promise<ExportResult> {
  // The interpreter makes every other format; a PNG needs a canvas.
  if (format === 'png') return exportPng(playground);
  const content = playground.exportFile(format) as Uint8Array<ArrayBuffer> | undefined;
  return content === undefined ? { kind: 'no-part' } : { kind: 'file', content, ending: playground.fileEnding(format) };
}

async function exportPng(playground: Playground): Promise<ExportResult> {
  const canvas = new OffscreenCanvas(1, 1);
  playground.paint(canvas, PNG_PIXEL_RATIO);
  const image = await canvas.convertToBlob({ type: 'image/png' });
  return { kind: 'file', content: new Uint8Array(await image.arrayBuffer()), ending: '.png' };
}
