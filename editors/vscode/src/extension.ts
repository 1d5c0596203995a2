// Activation: the picture, and one of two checkers.
//
// In: how the native program is started, on systems that have programs. Out: messages, fixes and formatting, from the
// native program or, if there is none, from the library in the extension. A changed setting starts the checker again.
// Must not know: how programs are checked.

import { languages, workspace, type Disposable, type ExtensionContext, type LanguageStatusItem } from 'vscode';
import { Library } from './library';
import { Picture } from './picture';
import { LANGUAGE, SECTION, settings, type Settings } from './settings';

/** A checker in use. */
export interface Checker {
  /** Its name, for the user. */
  readonly name: string;
  dispose(): Promise<void> | void;
}

/** Starts the native program; undefined if there is none. */
export type StartServer = (settings: Settings, context: ExtensionContext) => Promise<Checker | undefined>;

let running: Activation | undefined;

export async function start(context: ExtensionContext, startServer?: StartServer): Promise<void> {
  running = new Activation(context, startServer);
  context.subscriptions.push(...running.parts);
  await running.restart();
}

/** VS Code waits for the end of the native program. */
export async function deactivate(): Promise<void> {
  await running?.end();
  running = undefined;
}

class Activation {
  readonly parts: readonly Disposable[];
  readonly #context: ExtensionContext;
  readonly #startServer: StartServer | undefined;
  readonly #library: Library;
  readonly #status: LanguageStatusItem;
  #checker: Checker | undefined;
  /** Starts and ends follow one another. */
  #last: Promise<void> = Promise.resolve();

  constructor(context: ExtensionContext, startServer: StartServer | undefined) {
    this.#context = context;
    this.#startServer = startServer;
    this.#library = new Library(context.extensionUri);
    this.#status = languages.createLanguageStatusItem(`${SECTION}.checker`, { language: LANGUAGE });
    this.#status.name = 'G-code playground';
    this.parts = [
      this.#status,
      new Picture(context.extensionUri),
      workspace.onDidChangeConfiguration((change) => {
        if (change.affectsConfiguration(SECTION)) void this.restart();
      }),
    ];
  }

  restart(): Promise<void> {
    return this.#next(async () => {
      await this.#checker?.dispose();
      this.#checker = (await this.#startServer?.(settings(), this.#context)) ?? this.#library.startChecking();
      this.#status.text = this.#checker.name;
    });
  }

  end(): Promise<void> {
    return this.#next(async () => {
      await this.#checker?.dispose();
      this.#checker = undefined;
    });
  }

  #next(act: () => Promise<void>): Promise<void> {
    this.#last = this.#last.then(act, act);
    return this.#last;
  }
}
