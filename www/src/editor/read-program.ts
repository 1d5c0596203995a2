// Reads files that the user opens or drops: bytes to text, prepared for the editor.
//
// In: a `File`. Out: the text and its encoding, or an error. Loaded when a file is first opened, since it creates
// CodeMirror documents. Must not know: the purpose of the text.

import { Text } from '@codemirror/state';
import type { ReaderEvent } from '../files/file-reader';
import script from '../files/file-reader.ts?worker&url';
import { startWorker } from '../worker/start-worker';
import { append } from './file';
import type { ProgramFile, ProgramText } from './program-text';

/** Bytes; the interpreter would reject a longer text. */
const SIZE_LIMIT = 64 * 1024 * 1024;

export type Opened =
  | { readonly kind: 'text'; readonly program: ProgramText; readonly file: ProgramFile; readonly binary: boolean }
  | { readonly kind: 'too-large'; readonly name: string }
  | { readonly kind: 'unreadable'; readonly name: string };

export function readProgram(file: File): Promise<Opened> {
  const { name } = file;
  if (file.size > SIZE_LIMIT) return Promise.resolve({ kind: 'too-large', name });
  return new Promise<Opened>((resolve) => {
    let doc = Text.empty;
    const pieces: string[] = [];
    const end = (opened: Opened): void => {
      reader.end();
      resolve(opened);
    };
    const heard = (event: ReaderEvent): void => {
      switch (event.kind) {
        case 'piece':
          // Each piece arrives in a separate task, so that a long text does not block the page.
          pieces.push(event.text);
          doc = append(doc, event.text);
          return;
        case 'read': {
          const { ends, encoding, binary } = event;
          end({ kind: 'text', program: { doc, pieces, ends }, file: { name, encoding }, binary });
          return;
        }
        case 'unreadable':
          end({ kind: 'unreadable', name });
      }
    };
    const reader = startWorker(script, heard, () => end({ kind: 'unreadable', name }));
    reader.post(file);
  });
}
