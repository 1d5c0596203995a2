// The native program as a language server.
//
// In: the settings. Out: a running `gcode-playground server`, which gives messages, fixes, formatting, help, completion,
// navigation and renaming. Must not know: the answers of the server.

import { execFile } from 'node:child_process';
import { window, type ExtensionContext } from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';
import type { Checker } from './extension';
import { LANGUAGE, type Settings } from './settings';
import { words } from './words';

/** The name of the program on `PATH`. */
const PROGRAM = 'gcode-playground';

/** A program that does not answer within this time, ms, is not the right one. */
const PATIENCE_MS = 10_000;

/** Starts the server; undefined, with a warning if the user has named a program, if there is none. */
export async function startServer(settings: Settings, context: ExtensionContext): Promise<Checker | undefined> {
  const { path, control, pages, codeLens, hints } = settings;
  const command = path === '' ? PROGRAM : path;
  // Not the folder of the user: on Windows a program there would be found before the one on `PATH`.
  const cwd = context.extensionUri.fsPath;
  if (!(await isServer(command, cwd))) {
    if (path !== '') void window.showWarningMessage(words().notServer(path));
    return undefined;
  }
  const args = ['server', ...(control === '' ? [] : ['--control', control])];
  const client = new LanguageClient(
    PROGRAM,
    'G-code playground',
    { command, args, options: { cwd } },
    {
      documentSelector: [
        { language: LANGUAGE, scheme: 'file' },
        { language: LANGUAGE, scheme: 'untitled' },
      ],
      initializationOptions: { ...(pages === '' ? {} : { pages }), codeLens, hints },
    },
  );
  try {
    await client.start();
  } catch {
    // The client has shown the error.
    return undefined;
  }
  return { name: `${command} server`, dispose: () => client.dispose() };
}

/** Whether a program has the server. The command line of the npm package, which has the same name, has none. */
function isServer(command: string, cwd: string): Promise<boolean> {
  return new Promise((resolve) => {
    execFile(command, ['server', '--help'], { cwd, timeout: PATIENCE_MS }, (error) => resolve(error === null));
  });
}
