// Converts a dump of an X window, as `xwd` writes it, to PNG.
import { crc32, deflateSync } from 'node:zlib';

/** Converts `height` rows of the dump from `top`, `width` pixels wide; 24-bit colour only. */
export function png(dump: Buffer, area: { top: number; width: number; height: number }): Buffer {
  const field = (index: number): number => dump.readUInt32BE(4 * index);
  // From X11/XWDFile.h: `header_size`, `pixmap_width`, `byte_order`, `bytes_per_line`, `ncolors`. `bits_per_pixel` is
  // not used, as its value differs by visual.
  const [header, wide, order, stride, colours] = [field(0), field(4), field(7), field(12), field(19)];
  if (stride !== 4 * wide || order !== 0)
    throw new Error(
      `xwd wrote rows of ${stride} bytes for ${wide} pixels in byte order ${order}: only four a pixel, lowest first, are read`,
    );
  const start = header + 12 * colours;
  const rows = Buffer.alloc(area.height * (1 + 3 * area.width));
  for (let y = 0, to = 0; y < area.height; y++) {
    to++; // each row begins with its filter, 0
    let from = start + (area.top + y) * stride;
    for (let x = 0; x < area.width; x++, from += 4) {
      rows[to++] = dump[from + 2]!;
      rows[to++] = dump[from + 1]!;
      rows[to++] = dump[from]!;
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(area.width, 0);
  head.writeUInt32BE(area.height, 4);
  head.set([8, 2, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', head),
    chunk('IDAT', deflateSync(rows, { level: 1 })),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

function chunk(name: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), data]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}
