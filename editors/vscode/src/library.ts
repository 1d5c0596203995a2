// The library in the extension: the interpreter of the npm package, in the process of the extension.
//
// In: the open programs, if there is no native program. Out: messages, fixes and formatting. It reads no configuration
// files and no subprograms in other files. Must not know: the files of the library.

import {
  CodeAction,
  CodeActionKind,
  Diagnostic,
  DiagnosticSeverity,
  languages,
  Range,
  TextEdit,
  Uri,
  window,
  workspace,
  WorkspaceEdit,
  type CodeActionContext,
  type CodeActionProvider,
  type DocumentFormattingEditProvider,
  type TextDocument,
} from 'vscode';
import { check, format, repair, type Diagnostic as Found, type Setup } from 'gcode-playground';
import type { Checker } from './extension';
import { readFiles } from './library-files';
import { LANGUAGE, language, settings } from './settings';
import { words } from './words';

/** A program is checked this long after the last change, ms. */
const PAUSE_MS = 300;

/** As the language server names it, for `editor.codeActionsOnSave`. */
const FIX_ALL = CodeActionKind.SourceFixAll.append('gcode-playground');

const SEVERITIES = {
  error: DiagnosticSeverity.Error,
  warning: DiagnosticSeverity.Warning,
  info: DiagnosticSeverity.Information,
};

export class Library {
  readonly #extension: Uri;
  #files: Promise<void> | undefined;

  constructor(extension: Uri) {
    this.#extension = extension;
  }

  /** Starts to check the open programs. */
  startChecking(): Checker {
    return new LibraryChecker(() => this.load());
  }

  /** Reads the files of the library, once. */
  load(): Promise<void> {
    this.#files ??= readFiles(Uri.joinPath(this.#extension, 'element')).catch((error: unknown) => {
      this.#files = undefined;
      throw error;
    });
    return this.#files;
  }
}

/** A message of a version of a program. */
interface Shown {
  readonly found: Found;
  readonly diagnostic: Diagnostic;
}

/** The action that applies all safe fixes; its edit is made when the user chooses it. */
class FixAll extends CodeAction {
  readonly document: TextDocument;

  constructor(document: TextDocument) {
    super(words().fixAll, FIX_ALL);
    this.document = document;
  }
}

class LibraryChecker implements Checker, CodeActionProvider, DocumentFormattingEditProvider {
  readonly name = words().ownChecker;
  readonly #load: () => Promise<void>;
  readonly #shown = languages.createDiagnosticCollection('gcode-playground');
  /** The messages of each program, by address, with the version of its text. */
  readonly #results = new Map<string, { readonly version: number; readonly shown: readonly Shown[] }>();
  readonly #timers = new Map<string, ReturnType<typeof setTimeout>>();
  readonly #subscriptions = [
    workspace.onDidOpenTextDocument((document) => this.#schedule(document, 0)),
    workspace.onDidChangeTextDocument(({ document }) => this.#schedule(document, PAUSE_MS)),
    workspace.onDidCloseTextDocument((document) => this.#forget(document)),
    languages.registerCodeActionsProvider({ language: LANGUAGE }, this, {
      providedCodeActionKinds: [CodeActionKind.QuickFix, FIX_ALL],
    }),
    languages.registerDocumentFormattingEditProvider({ language: LANGUAGE }, this),
  ];

  constructor(load: () => Promise<void>) {
    this.#load = load;
    for (const document of workspace.textDocuments) this.#schedule(document, 0);
  }

  dispose(): void {
    for (const part of this.#subscriptions) part.dispose();
    for (const timer of this.#timers.values()) clearTimeout(timer);
    this.#shown.dispose();
  }

  async provideCodeActions(document: TextDocument, range: Range, { only }: CodeActionContext): Promise<CodeAction[]> {
    const shown = await this.#check(document);
    const here = shown.filter(({ diagnostic }) => diagnostic.range.intersection(range) !== undefined);
    const actions = here.flatMap((one) => quickFixes(document, one));
    const isSafe = shown.some(({ found }) => found.fixes.some(({ safe }) => safe));
    if (isSafe) actions.push(new FixAll(document));
    return actions.filter(({ kind }) => only === undefined || (kind !== undefined && only.contains(kind)));
  }

  resolveCodeAction(action: CodeAction): CodeAction {
    if (action instanceof FixAll) {
      const { document } = action;
      const edit = new WorkspaceEdit();
      edit.set(document.uri, changedLines(document, repair(document.getText(), setup())));
      action.edit = edit;
    }
    return action;
  }

  async provideDocumentFormattingEdits(document: TextDocument): Promise<TextEdit[]> {
    await this.#load();
    try {
      const text = document.getText();
      return changedLines(document, format(text, setup(), { language: language() }));
    } catch (error) {
      // The program would not be the same.
      void window.showWarningMessage(error instanceof Error ? error.message : String(error));
      return [];
    }
  }

  #schedule(document: TextDocument, delay: number): void {
    // A program in the history of a repository is not changed any more.
    if (document.languageId !== LANGUAGE || document.uri.scheme === 'git') return;
    const address = document.uri.toString();
    clearTimeout(this.#timers.get(address));
    this.#timers.set(
      address,
      setTimeout(() => void this.#check(document), delay),
    );
  }

  #forget(document: TextDocument): void {
    const address = document.uri.toString();
    clearTimeout(this.#timers.get(address));
    this.#timers.delete(address);
    this.#results.delete(address);
    this.#shown.delete(document.uri);
  }

  /** The messages of the current text. */
  async #check(document: TextDocument): Promise<readonly Shown[]> {
    await this.#load();
    const address = document.uri.toString();
    const { version } = document;
    const known = this.#results.get(address);
    if (known?.version === version) return known.shown;
    if (document.isClosed) return [];
    const { pages } = settings();
    const found = check(document.getText(), setup(), { language: language() });
    const shown = found.map((found) => ({ found, diagnostic: diagnostic(document, found, pages) }));
    this.#results.set(address, { version, shown });
    this.#shown.set(
      document.uri,
      shown.map(({ diagnostic }) => diagnostic),
    );
    return shown;
  }
}

function setup(): Setup {
  const { control } = settings();
  return control === 'fanuc' || control === 'gsk' || control === 'forum' ? { dialect: { control } } : {};
}

function diagnostic(document: TextDocument, found: Found, pages: string): Diagnostic {
  const { from, to, message, help, severity, code, slug } = found;
  const text = help === undefined ? message : `${message}\n${help}`;
  const shown = new Diagnostic(rangeOf(document, { from, to }), text, SEVERITIES[severity]);
  shown.source = 'gcode-playground';
  shown.code = pages === '' ? code : { value: code, target: Uri.parse(`${pages}/rules/${language()}/${slug}.html`) };
  return shown;
}

/** The fixes of a message. One that changes the setup has no edits, and there is no setup here. */
function quickFixes(document: TextDocument, { found, diagnostic }: Shown): CodeAction[] {
  return found.fixes
    .filter(({ edits }) => edits.length > 0)
    .map(({ title, safe, edits }) => {
      const action = new CodeAction(title, CodeActionKind.QuickFix);
      action.edit = new WorkspaceEdit();
      action.edit.set(
        document.uri,
        edits.map((edit) => TextEdit.replace(rangeOf(document, edit), edit.text)),
      );
      action.diagnostics = [diagnostic];
      action.isPreferred = safe;
      return action;
    });
}

function rangeOf(document: TextDocument, { from, to }: { readonly from: number; readonly to: number }): Range {
  return new Range(document.positionAt(from), document.positionAt(to));
}

/** The edits from a program to a new text: its changed lines or, if their number is different, all of it. */
function changedLines(document: TextDocument, text: string): TextEdit[] {
  const lines = text.split(/\r\n|\r|\n/);
  if (lines.length !== document.lineCount) return [TextEdit.replace(new Range(0, 0, document.lineCount, 0), text)];
  return lines.flatMap((line, number) => {
    const before = document.lineAt(number);
    return line === before.text ? [] : [TextEdit.replace(before.range, line)];
  });
}
