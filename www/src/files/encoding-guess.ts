// Which encoding a program file is in.
//
// In: bytes. Out: an encoding in which they are text that becomes the same bytes again. Files with a byte
// order mark, UTF-16 with a zero in every other byte and valid UTF-8 are certain; otherwise what is not ASCII (comments, as a rule) is read as
// Chinese, Russian and Western text, and the reading that surprises least is taken. src/cli/encoding.rs does
// the same on the command line, with the same table; tests/encodings.json holds both to it. Must not know:
// what stands in a program.

import plausible from '../../../src/cli/plausible.json';
import { decode, type Encoding } from './encodings';

/** More bytes beyond ASCII than these change no guess. */
const LOOKED_AT = 100_000;

export interface Guess {
  readonly encoding: Encoding;
  readonly text: string;
  /** The bytes are hardly those of a text. */
  readonly binary: boolean;
}

export function guess(bytes: Uint8Array): Guess {
  const binary = isBinary(bytes);
  const certain: Encoding[] = ['utf-8-bom', 'utf-16le', 'utf-16be', ...unmarkedUtf16(bytes)];
  if (!isRatherChinese(bytes)) certain.push('utf-8');
  for (const encoding of [...certain, ...byLikelihood(bytes)]) {
    const text = decode(bytes, encoding);
    if (text !== undefined) return { encoding, text, binary: binary && !encoding.startsWith('utf-16') };
  }
  // Not reached: every byte is a character of Windows-1252.
  return { encoding: 'windows-1252', text: new TextDecoder('windows-1252').decode(bytes), binary };
}

/**
 * UTF-16 without a byte order mark, if these are its bytes: ASCII characters, most of a program, have a zero as their
 * high byte, and none has one as its low byte. The feed of paper tape is zeros in a row, so both.
 */
function unmarkedUtf16(bytes: Uint8Array): Encoding[] {
  const pairs = bytes.length >> 1;
  const zeros = [0, 0];
  for (let at = 0; at < 2 * pairs; at++) if (bytes[at] === 0) zeros[at & 1] = (zeros[at & 1] ?? 0) + 1;
  const [first = 0, second = 0] = zeros;
  const least = Math.max(2, Math.ceil(pairs / 2));
  if (first === 0 && second >= least) return ['utf-16le-no-bom'];
  return second === 0 && first >= least ? ['utf-16be-no-bom'] : [];
}

/**
 * Control characters other than blanks, line ends, tape codes and the end of a file,
 * one in a hundred or more.
 */
function isBinary(bytes: Uint8Array): boolean {
  let strange = 0;
  for (const byte of bytes) {
    if (byte < 0x20 && byte !== 0 && byte !== 0x1a && (byte < 0x09 || byte > 0x0d) && (byte < 0x11 || byte > 0x14))
      strange++;
  }
  return 100 * strange > bytes.length;
}

/**
 * Whether what may be valid UTF-8 is so by chance, as short Chinese comments can be: letters of alphabets
 * nobody has in a program, in UTF-8, that are common characters in GB18030.
 */
function isRatherChinese(bytes: Uint8Array): boolean {
  let beyondAscii = 0;
  let ofFarAlphabet = false;
  for (const byte of bytes) {
    if (byte >= 0xe0) return false;
    if (byte >= 0x80) beyondAscii++;
    ofFarAlphabet ||= (byte >= 0xc6 && byte <= 0xcd) || byte >= 0xd2;
  }
  return ofFarAlphabet && chinese(bytes) <= (COMMON * beyondAscii) / 2;
}

function byLikelihood(bytes: Uint8Array): Encoding[] {
  const { end, count } = lookedAt(bytes);
  if (count === 0) return ['windows-1252'];
  const looked = bytes.subarray(0, end);
  const surprises: [Encoding, number][] = [
    ['gb18030', chinese(looked)],
    ['windows-1252', western(looked)],
    ['windows-1251', russian(looked)],
  ];
  return surprises.sort((a, b) => a[1] - b[1]).map(([encoding]) => encoding);
}

function lookedAt(bytes: Uint8Array): { end: number; count: number } {
  let count = 0;
  let end = 0;
  for (; end < bytes.length && count < LOOKED_AT; end++) if ((bytes[end] ?? 0) >= 0x80) count++;
  return { end, count };
}

// ---- how much each reading surprises: natural logarithms of one over a rough
// probability, added up ----------

/** The most that characters of the first level of GB 2312 surprise. */
const COMMON = 9.8;

/** Surprise by byte when it is read as a letter or sign of a one-byte encoding. */
interface ByteTable {
  readonly surprise: Float64Array;
  readonly upper: Uint8Array;
  readonly lower: Uint8Array;
}

function byteTable(encoding: 'windows-1251' | 'windows-1252', of: (character: string) => number): ByteTable {
  const table = { surprise: new Float64Array(256), upper: new Uint8Array(256), lower: new Uint8Array(256) };
  const text = new TextDecoder(encoding).decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
  for (let byte = 0x80; byte < 0x100; byte++) {
    const character = text.charAt(byte);
    table.surprise[byte] = of(character);
    table.upper[byte] = character.toLowerCase() === character ? 0 : 1;
    table.lower[byte] = character.toUpperCase() === character ? 0 : 1;
  }
  return table;
}

let russianTable: ByteTable | undefined;
let westernTable: ByteTable | undefined;
let commonHanzi: ReadonlySet<string> | undefined;

/**
 * Words of Cyrillic letters, the frequent ones more likely; capitals after small letters and
 * Latin neighbours are not.
 */
function russian(bytes: Uint8Array): number {
  const { surprise, upper, lower } = (russianTable ??= byteTable('windows-1251', (character) => {
    const rank = plausible.cyrillic.indexOf(character.toLowerCase());
    if (rank >= 0) return 2.2 + 0.12 * rank;
    return plausible.signs.includes(character) ? 5 : /\p{L}/u.test(character) ? 8 : 9;
  }));
  let total = 0;
  for (let i = 0; i < bytes.length; i++) {
    const byte = bytes[i] ?? 0;
    if (byte < 0x80) continue;
    const before = bytes[i - 1] ?? 0;
    total += surprise[byte] ?? 0;
    const letter = upper[byte] === 1 || lower[byte] === 1;
    if (upper[byte] === 1 && lower[before] === 1) total += 4;
    if (letter && isLatin(before)) total += 3;
    if (letter && isLatin(bytes[i + 1] ?? 0)) total += 3;
  }
  return total;
}

/** Single accented letters among Latin ones, and signs beside numbers. */
function western(bytes: Uint8Array): number {
  const { surprise, upper, lower } = (westernTable ??= byteTable('windows-1252', (character) => {
    if (plausible.western.includes(character)) return 3.4;
    return plausible.signs.includes(character) ? 4.5 : /\p{L}/u.test(character) ? 6.5 : 9;
  }));
  let total = 0;
  let run = 0;
  for (let i = 0; i < bytes.length; i++) {
    const byte = bytes[i] ?? 0;
    if (byte < 0x80) {
      run = 0;
      continue;
    }
    total += (surprise[byte] ?? 0) + (run === 0 ? 0 : run === 1 ? 3 : 5);
    run++;
    const letter = upper[byte] === 1 || lower[byte] === 1;
    if (letter && !isLatin(bytes[i - 1] ?? 0) && !isLatin(bytes[i + 1] ?? 0)) total += 1;
  }
  return total;
}

/**
 * Pairs of bytes, those of the characters of a workshop most likely; one that is no pair at all rules it out.
 */
function chinese(bytes: Uint8Array): number {
  commonHanzi ??= new Set(plausible.hanzi);
  const decoder = new TextDecoder('gb18030');
  let total = 0;
  for (let i = 0; i < bytes.length; i++) {
    const lead = bytes[i] ?? 0;
    if (lead < 0x80) continue;
    if (lead === 0x80 || lead === 0xff) return Infinity;
    const trail = bytes[i + 1];
    if (trail === undefined) return total;
    if (trail >= 0x30 && trail <= 0x39) {
      total += 20;
      i += 3;
      continue;
    }
    if (trail < 0x40 || trail === 0x7f || trail === 0xff) return Infinity;
    if (trail < 0xa1 || lead < 0xa1) total += 15;
    else if (lead <= 0xa3) total += 7.6;
    else if (commonHanzi.has(decoder.decode(bytes.subarray(i, i + 2)))) total += 6;
    else total += lead >= 0xb0 && lead <= 0xd7 ? COMMON : 12.8;
    i++;
  }
  return total;
}

function isLatin(byte: number): boolean {
  const letter = byte | 0x20;
  return letter >= 0x61 && letter <= 0x7a;
}
