// Files the reader opens or drops: bytes to text, ready for the editor.
//
// In: a `File`. Out: the text and how it was read, or why there is none. Loaded when a file is first opened:
// it makes the editor's document. Must not know: what the text is for.

import { Text } from '@codemirror/state';
import type { ReaderEvent } from '../files/file-reader';
import script from '../files/file-reader.ts?worker&url';
import { startWorker } from '../worker/start-worker';
import { append } from './file';
import type { ProgramFile, ProgramText } from './program-text';

/** Bytes; a longer text the interpreter would refuse. */
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
          // Each piece is a task of its own, so that a long text does not make the page stand still.
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
