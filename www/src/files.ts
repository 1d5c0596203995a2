// A file the reader opened or dropped, made into text.
//
// In: a `File`. Out: its text, or why there is none. Bytes that are not UTF-8 become U+FFFD and are counted.
// Must not know: what the text is for.

const SIZE_LIMIT = 64 * 1024 * 1024;

export type Opened =
  | { readonly kind: 'text'; readonly name: string; readonly text: string; readonly damaged: number }
  | { readonly kind: 'too-large'; readonly name: string }
  | { readonly kind: 'unreadable'; readonly name: string };

export async function readProgram(file: File): Promise<Opened> {
  const { name } = file;
  if (file.size > SIZE_LIMIT) return { kind: 'too-large', name };
  let bytes: ArrayBuffer;
  try {
    bytes = await file.arrayBuffer();
  } catch {
    return { kind: 'unreadable', name };
  }
  const text = new TextDecoder('utf-8').decode(bytes);
  let damaged = 0;
  for (let at = text.indexOf('\uFFFD'); at >= 0; at = text.indexOf('\uFFFD', at + 1)) damaged++;
  return { kind: 'text', name, text, damaged };
}
