// Guesses the encoding of a program file.
//
// In: bytes. Out: an encoding that decodes them, and encodes the text to the same bytes again. A byte order mark, a
// zero in every other byte (UTF-16) and valid UTF-8 are certain. Otherwise, text that is not ASCII (usually comments)
// is read as Chinese, Russian and Western text, and the most probable reading wins. `src/cli/encoding.rs` does the same
// on the command line, with the same table; `tests/encodings.json` tests both. Must not know: what a program contains.

import plausible from '../../../src/cli/plausible.json';
import type { Encoding } from './encoding-list';
import { decode } from './encodings';

/** Most non-ASCII bytes that are examined; more do not change the guess. */
const SAMPLE_LIMIT = 100_000;

interface Guess {
  readonly encoding: Encoding;
  readonly text: string;
  /** Whether the bytes are probably not text. */
  readonly binary: boolean;
}

export function guessEncoding(bytes: Uint8Array): Guess {
  const binary = isBinary(bytes);
  const certain: Encoding[] = ['utf-8-bom', 'utf-16le', 'utf-16be', ...unmarkedUtf16(bytes)];
  if (!isLikelyGb18030(bytes)) certain.push('utf-8');
  for (const encoding of [...certain, ...encodingsByLikelihood(bytes)]) {
    const text = decode(bytes, encoding);
    if (text !== undefined) return { encoding, text, binary: binary && !encoding.startsWith('utf-16') };
  }
  // Unreachable: Windows-1252 decodes every byte.
  return { encoding: 'windows-1252', text: new TextDecoder('windows-1252').decode(bytes), binary };
}

/**
 * UTF-16 without a byte order mark, if the bytes suggest it: ASCII characters, most of a program, have a zero high byte
 * and never a zero low byte. The leader of paper tape is a run of zeros and fits both byte orders.
 */
function unmarkedUtf16(bytes: Uint8Array): Encoding[] {
  const pairs = bytes.length >> 1;
  const zeros = [0, 0];
  for (let at = 0; at < 2 * pairs; at++) if (bytes[at] === 0) zeros[at & 1] = (zeros[at & 1] ?? 0) + 1;
  const [first = 0, second = 0] = zeros;
  const minimum = Math.max(2, Math.ceil(pairs / 2));
  if (first === 0 && second >= minimum) return ['utf-16le-no-bom'];
  return second === 0 && first >= minimum ? ['utf-16be-no-bom'] : [];
}

/**
 * Whether at least one byte in a hundred is a control character other than whitespace, line ends, tape codes and the
 * end-of-file mark.
 */
function isBinary(bytes: Uint8Array): boolean {
  let controlCharacters = 0;
  for (const byte of bytes) {
    if (byte < 0x20 && byte !== 0 && byte !== 0x1a && (byte < 0x09 || byte > 0x0d) && (byte < 0x11 || byte > 0x14))
      controlCharacters++;
  }
  return 100 * controlCharacters > bytes.length;
}

/**
 * Whether valid UTF-8 is probably GB18030, as short Chinese comments can be: in UTF-8 it has letters of alphabets that
 * no program uses, and in GB18030 they are common characters.
 */
function isLikelyGb18030(bytes: Uint8Array): boolean {
  let beyondAscii = 0;
  let hasUnusedAlphabet = false;
  for (const byte of bytes) {
    if (byte >= 0xe0) return false;
    if (byte >= 0x80) beyondAscii++;
    hasUnusedAlphabet ||= (byte >= 0xc6 && byte <= 0xcd) || byte >= 0xd2;
  }
  return hasUnusedAlphabet && chineseSurprise(bytes) <= (COMMON_HANZI_SURPRISE * beyondAscii) / 2;
}

function encodingsByLikelihood(bytes: Uint8Array): Encoding[] {
  const { end, count } = sampleOf(bytes);
  if (count === 0) return ['windows-1252'];
  const sample = bytes.subarray(0, end);
  const surprises: [Encoding, number][] = [
    ['gb18030', chineseSurprise(sample)],
    ['windows-1252', westernSurprise(sample)],
    ['windows-1251', russianSurprise(sample)],
  ];
  return surprises.sort((a, b) => a[1] - b[1]).map(([encoding]) => encoding);
}

function sampleOf(bytes: Uint8Array): { end: number; count: number } {
  let count = 0;
  let end = 0;
  for (; end < bytes.length && count < SAMPLE_LIMIT; end++) if ((bytes[end] ?? 0) >= 0x80) count++;
  return { end, count };
}

// ---- surprise of each reading: the sum of negative natural logarithms of a rough probability ----

/** Highest surprise of a character in level 1 of GB 2312. */
const COMMON_HANZI_SURPRISE = 9.8;

/** Surprise of each byte as a letter or sign of a one-byte encoding. */
interface ByteTable {
  readonly surprise: Float64Array;
  readonly upper: Uint8Array;
  readonly lower: Uint8Array;
}

function byteTable(encoding: 'windows-1251' | 'windows-1252', surpriseOf: (character: string) => number): ByteTable {
  const table = { surprise: new Float64Array(256), upper: new Uint8Array(256), lower: new Uint8Array(256) };
  const text = new TextDecoder(encoding).decode(Uint8Array.from({ length: 256 }, (_, byte) => byte));
  for (let byte = 0x80; byte < 0x100; byte++) {
    const character = text.charAt(byte);
    table.surprise[byte] = surpriseOf(character);
    table.upper[byte] = character.toLowerCase() === character ? 0 : 1;
    table.lower[byte] = character.toUpperCase() === character ? 0 : 1;
  }
  return table;
}

let russianTable: ByteTable | undefined;
let westernTable: ByteTable | undefined;
let commonHanzi: ReadonlySet<string> | undefined;

/**
 * Surprise as Russian: expects words of Cyrillic letters, frequent letters more than rare ones. Capitals after small
 * letters, and Latin neighbours, are improbable.
 */
function russianSurprise(bytes: Uint8Array): number {
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

/** Surprise as a Western language: expects single accented letters among Latin ones, and signs next to numbers. */
function westernSurprise(bytes: Uint8Array): number {
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

/** Surprise as Chinese: expects pairs of bytes, workshop characters more than others. An invalid pair excludes it. */
function chineseSurprise(bytes: Uint8Array): number {
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
    else total += lead >= 0xb0 && lead <= 0xd7 ? COMMON_HANZI_SURPRISE : 12.8;
    i++;
  }
  return total;
}

function isLatin(byte: number): boolean {
  const letter = byte | 0x20;
  return letter >= 0x61 && letter <= 0x7a;
}
