// Packs a text into characters that are valid in any address: compressed by the browser's streams, then base64url.
//
// In: a text, or its packed characters. Out: the other one. Unpacking stops at a limit, regardless of the contents. The
// characters begin with their number and end with a checksum, which distinguishes a truncated text from a changed one.
// Must not know: the contents of the text.
//
//   <count>.<how><body><check>   `count`: characters after the full stop; `how`: z compressed, b not; `check`: CRC-32
//   of `<how><body>`, 8 hexadecimal digits, so that no mail program drops the last character.

/** Most UTF-8 bytes that are unpacked. */
export const UNPACKED_LIMIT = 4_000_000;

const CHECKSUM_LENGTH = 8;
/** `String.fromCharCode` accepts this many arguments in all browsers. */
const CHUNK_SIZE = 1 << 13;

type Unpacked =
  | { readonly kind: 'text'; readonly text: string }
  /** Characters are missing at the end; `missing`: how many, if the count is readable. */
  | { readonly kind: 'cut'; readonly missing: number | undefined }
  | { readonly kind: 'damaged' }
  | { readonly kind: 'too-long'; readonly limit: number }
  /** The browser has no decompression streams. */
  | { readonly kind: 'unsupported' };

/** Undefined if the text is too long to be unpacked again. */
export async function pack(text: string): Promise<string | undefined> {
  const bytes = new TextEncoder().encode(text);
  if (bytes.length > UNPACKED_LIMIT) return undefined;
  const plain = `b${base64url(bytes)}`;
  const smaller =
    typeof CompressionStream === 'undefined'
      ? undefined
      : `z${base64url(await pipe(bytes, new CompressionStream('deflate-raw'), Infinity))}`;
  const body = smaller !== undefined && smaller.length < plain.length ? smaller : plain;
  return `${body.length + CHECKSUM_LENGTH}.${body}${checksum(body)}`;
}

/** Characters after the end are ignored: mail programs include a following full stop in a link. */
export async function unpack(characters: string): Promise<Unpacked> {
  const head = /^(\d{1,9})\./.exec(characters);
  if (head === null) return /^\d{0,9}$/.test(characters) ? { kind: 'cut', missing: undefined } : { kind: 'damaged' };
  const count = Number(head[1]);
  const rest = characters.slice(head[0].length);
  if (count <= CHECKSUM_LENGTH) return { kind: 'damaged' };
  if (rest.length < count) return { kind: 'cut', missing: count - rest.length };
  const body = rest.slice(0, count - CHECKSUM_LENGTH);
  if (rest.slice(body.length, count) !== checksum(body)) return { kind: 'damaged' };
  const bytes = bytesFromBase64Url(body.slice(1));
  if (bytes === undefined) return { kind: 'damaged' };
  if (body.startsWith('b'))
    return bytes.length > UNPACKED_LIMIT ? { kind: 'too-long', limit: UNPACKED_LIMIT } : decodeUtf8(bytes);
  if (!body.startsWith('z')) return { kind: 'damaged' };
  if (typeof DecompressionStream === 'undefined') return { kind: 'unsupported' };
  try {
    return decodeUtf8(await pipe(bytes, new DecompressionStream('deflate-raw'), UNPACKED_LIMIT));
  } catch (error) {
    return error instanceof RangeError ? { kind: 'too-long', limit: UNPACKED_LIMIT } : { kind: 'damaged' };
  }
}

function decodeUtf8(bytes: Uint8Array): Unpacked {
  try {
    return { kind: 'text', text: new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes) };
  } catch {
    return { kind: 'damaged' };
  }
}

/** The output of a stream. Throws a `RangeError` if it exceeds the limit. */
async function pipe(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
  limit: number,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader() as ReadableStreamDefaultReader<Uint8Array>;
  const pieces: Uint8Array[] = [];
  let length = 0;
  for (let read = await reader.read(); !read.done; read = await reader.read()) {
    length += read.value.length;
    if (length > limit) {
      void reader.cancel().catch(() => undefined);
      throw new RangeError(`more than ${limit} bytes`);
    }
    pieces.push(read.value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

function base64url(bytes: Uint8Array): string {
  let binary = '';
  for (let at = 0; at < bytes.length; at += CHUNK_SIZE)
    binary += String.fromCharCode(...bytes.subarray(at, at + CHUNK_SIZE));
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function bytesFromBase64Url(characters: string): Uint8Array<ArrayBuffer> | undefined {
  if (/[^\w-]/.test(characters)) return undefined;
  try {
    return Uint8Array.from(atob(characters.replaceAll('-', '+').replaceAll('_', '/')), (letter) =>
      letter.charCodeAt(0),
    );
  } catch {
    return undefined;
  }
}

/** CRC-32 of ASCII characters. */
function checksum(characters: string): string {
  let crc = -1;
  for (let at = 0; at < characters.length; at++) {
    crc ^= characters.charCodeAt(at);
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ ((crc & 1) === 0 ? 0 : 0xedb88320);
  }
  return (~crc >>> 0).toString(16).padStart(CHECKSUM_LENGTH, '0');
}
