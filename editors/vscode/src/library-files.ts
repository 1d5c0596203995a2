// The files of the library: its modules and texts.
//
// The library is written for Node and reads its files with `readFileSync`. VS Code reads the files of an extension only
// asynchronously, in a browser by requests. So the files are read before, and `build.mjs` puts this file in place of
// `node:fs` in the library. Must not know: the content of a file.

import { Uri, workspace } from 'vscode';

/** The names of the files; `build.mjs` fills them in. */
declare const ELEMENT_FILES: readonly string[];

const contents = new Map<string, Uint8Array>();

/** Reads all files of a folder of the extension. */
export async function readFiles(folder: Uri): Promise<void> {
  await Promise.all(
    ELEMENT_FILES.map(async (name) => contents.set(name, await workspace.fs.readFile(Uri.joinPath(folder, name)))),
  );
}

/** The content of a file that has been read, by an address that ends with its name. */
export function readFileSync(address: URL, encoding?: 'utf8'): Uint8Array | string {
  const name = address.pathname.slice(address.pathname.lastIndexOf('/') + 1);
  const content = contents.get(name);
  if (content === undefined) throw new Error(`${name} has not been read`);
  return encoding === undefined ? content : new TextDecoder().decode(content);
}
