// Reads files that the user opens or drops: bytes to text, prepared for the editor.
//
// In: a `File`. Out: the text and its encoding, or an error. Loaded when a file is first opened, since it creates
// CodeMirror documents. Must not know: the purpose of the text.

import { Text } from '@codemirror/state';
import type { ReaderEvent } from '../files/file-reader';
import script from '../files/file-reader.ts?worker&url';
import { startWorker } from '../worker/start-worker';
import { appendText } from './file';
import type { ProgramFile, ProgramText } from './program-text';

/** Bytes; the interpreter would reject a longer text. */
const SIZE_LIMIT = 64 * 1024 * 1024;

export type OpenedFile =
  | { readonly kind: 'text'; readonly program: ProgramText; readonly file: ProgramFile; readonly binary: boolean }
  | { readonly kind: 'too-large'; readonly name: string }
  | { readonly kind: 'unreadable'; readonly name: string };

export function readProgram(file: File): Promise<OpenedFile> {
  const { name } = file;
  if (file.size > SIZE_LIMIT) return Promise.resolve({ kind: 'too-large', name });
  return new Promise<OpenedFile>((resolve) => {
    let doc = Text.empty;
    const pieces: string[] = [];
    const finish = (opened: OpenedFile): void => {
      reader.end();
      resolve(opened);
    };
    const onEvent = (event: ReaderEvent): void => {
      switch (event.kind) {
        case 'piece':
          // Each piece arrives in a separate task, so that a long text does not block the page.
          pieces.push(event.text);
          doc = appendText(doc, event.text);
          return;
        case 'read': {
          const { ends, encoding, binary } = event;
          finish({ kind: 'text', program: { doc, pieces, ends }, file: { name, encoding }, binary });
          return;
        }
        case 'unreadable':
          finish({ kind: 'unreadable', name });
      }
    };
    const reader = startWorker(script, onEvent, () => finish({ kind: 'unreadable', name }));
    reader.post(file);
  });
}
