// Encodes and decodes program files without loss.
//
// In: bytes, or a text and the name of an encoding. Out: the other one, or the reason for a failure. A text is returned
// only if it encodes to exactly the same bytes. The encoder is derived from the browser's decoder, so no tables are
// included. Must not know: the purpose of a text, or which encoding is probable.

import type { Encoding } from './encoding-list';

type Encoded =
  | { readonly kind: 'bytes'; readonly bytes: Uint8Array<ArrayBuffer> }
  /** The first character that the encoding cannot represent. */
  | { readonly kind: 'unencodable'; readonly character: string };

/** Whether the encoding can represent every character. */
export function isUnicode(encoding: Encoding): boolean {
  return encoding.startsWith('utf-');
}

const BYTE_ORDER_MARKS: Readonly<Partial<Record<Encoding, readonly number[]>>> = {
  'utf-8-bom': [0xef, 0xbb, 0xbf],
  'utf-16le': [0xff, 0xfe],
  'utf-16be': [0xfe, 0xff],
};

/** Decodes bytes; undefined if the text would not encode to the same bytes. */
export function decode(bytes: Uint8Array, encoding: Encoding): string | undefined {
  const mark = BYTE_ORDER_MARKS[encoding] ?? [];
  if (mark.some((byte, i) => bytes[i] !== byte)) return undefined;
  if (encoding === 'utf-8' && BYTE_ORDER_MARKS['utf-8-bom']?.every((byte, i) => bytes[i] === byte) === true)
    return undefined;
  const label = encoding.replace(/(-no)?-bom$/, '');
  let text: string;
  try {
    text = new TextDecoder(label, { fatal: true, ignoreBOM: true }).decode(bytes.subarray(mark.length));
  } catch {
    return undefined;
  }
  // UTF-8 and one-byte encodings encode a text in only one way.
  if (label === 'utf-8') return text;
  const encoded = encode(text, encoding);
  return encoded.kind === 'bytes' && isEqual(encoded.bytes, bytes) ? text : undefined;
}

/** Encodes a text. */
export function encode(text: string, encoding: Encoding): Encoded {
  switch (encoding) {
    case 'utf-8':
      return { kind: 'bytes', bytes: new TextEncoder().encode(text) };
    case 'utf-8-bom':
      return { kind: 'bytes', bytes: new TextEncoder().encode(`\uFEFF${text}`) };
    case 'utf-16le':
    case 'utf-16be':
      return { kind: 'bytes', bytes: utf16(`\uFEFF${text}`, encoding === 'utf-16le') };
    case 'utf-16le-no-bom':
    case 'utf-16be-no-bom':
      return { kind: 'bytes', bytes: utf16(text, encoding === 'utf-16le-no-bom') };
    case 'gb18030':
    case 'windows-1251':
    case 'windows-1252':
      return encodeByTable(text, encoding);
  }
}

function utf16(text: string, littleEndian: boolean): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(2 * text.length);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < text.length; i++) view.setUint16(2 * i, text.charCodeAt(i), littleEndian);
  return bytes;
}

type Legacy = 'gb18030' | 'windows-1251' | 'windows-1252';

/** Bytes of each UTF-16 unit as one number, the first byte highest; 0 if the encoding has none. */
const tables = new Map<Legacy, Uint32Array>();

function encodeByTable(text: string, encoding: Legacy): Encoded {
  let table = tables.get(encoding);
  if (table === undefined)
    tables.set(encoding, (table = encoding === 'gb18030' ? gb18030Table() : byteTable(encoding)));
  let bytes = new Uint8Array(text.length + (text.length >> 1) + 16);
  let length = 0;
  for (let i = 0; i < text.length; i++) {
    if (length + 4 > bytes.length) {
      const longer = new Uint8Array(2 * bytes.length);
      longer.set(bytes);
      bytes = longer;
    }
    const unit = text.charCodeAt(i);
    if (unit < 0x80) {
      bytes[length++] = unit;
      continue;
    }
    let code = table[unit] ?? 0;
    if (code === 0) {
      const point = text.codePointAt(i) ?? 0;
      if (encoding !== 'gb18030' || point < 0x10000)
        return { kind: 'unencodable', character: String.fromCodePoint(point) };
      code = fourByteCode(FIRST_CODE_ABOVE_FFFF + point - 0x10000);
      i++;
    }
    for (let shift = 24; shift >= 0; shift -= 8) {
      const byte = (code >>> shift) & 0xff;
      // Leading zeros of the number are not bytes, except for the last one; bytes of non-ASCII characters are never 0.
      if (byte !== 0 || shift === 0) bytes[length++] = byte;
    }
  }
  return { kind: 'bytes', bytes: bytes.slice(0, length) };
}

function byteTable(encoding: Legacy): Uint32Array {
  const table = new Uint32Array(0x10000);
  const text = new TextDecoder(encoding).decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
  for (let byte = 0x80; byte < 0x100; byte++) table[text.charCodeAt(byte)] = byte;
  return table;
}

/** Four-byte codes are numbered in order; this is the number of the first one for a character above U+FFFF. */
const FIRST_CODE_ABOVE_FFFF = 189_000;
/** Number of four-byte codes for characters up to U+FFFF: 0x81308130 to 0x8431A439. */
const FOUR_BYTE_CODES_TO_FFFF = 39_420;

function fourByteCode(number: number): number {
  const last = 0x30 + (number % 10);
  const third = 0x81 + (Math.floor(number / 10) % 126);
  const second = 0x30 + (Math.floor(number / 1260) % 10);
  const first = 0x81 + Math.floor(number / 12_600);
  return ((first << 24) | (second << 16) | (third << 8) | last) >>> 0;
}

/** Decodes every code of two and four bytes, each on a separate line. */
function gb18030Table(): Uint32Array {
  const codes: number[] = [];
  for (let lead = 0x81; lead <= 0xfe; lead++) {
    for (let trail = 0x40; trail <= 0xfe; trail++) if (trail !== 0x7f) codes.push((lead << 8) | trail);
  }
  for (let number = 0; number < FOUR_BYTE_CODES_TO_FFFF; number++) codes.push(fourByteCode(number));
  const bytes: number[] = [];
  for (const code of codes) {
    if (code > 0xffff) bytes.push(code >>> 24, (code >>> 16) & 0xff);
    bytes.push((code >>> 8) & 0xff, code & 0xff, 0x0a);
  }
  const table = new Uint32Array(0x10000);
  const decoded = new TextDecoder('gb18030').decode(Uint8Array.from(bytes)).split('\n');
  codes.forEach((code, i) => {
    const character = decoded[i] ?? '';
    const unit = character.charCodeAt(0);
    if (character.length === 1 && unit !== 0xfffd && table[unit] === 0) table[unit] = code;
  });
  return table;
}

function isEqual(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((byte, i) => byte === b[i]);
}
