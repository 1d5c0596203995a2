// The picture of a program, in a panel beside its text.
//
// In: the program, its changes and its cursor. Out: a page with the element, whose files are in the extension, and the
// selection of the block whose stroke was clicked. The panel follows the G-code editor that is used. Must not know: the
// element; that is the page's part (`picture-page.ts`).

import {
  commands,
  Disposable,
  Uri,
  ViewColumn,
  window,
  workspace,
  type TextDocument,
  type TextEditor,
  type Webview,
  type WebviewPanel,
} from 'vscode';
import type { FromPicture, ToPicture } from './messages';
import { LANGUAGE, language, SECTION, settings } from './settings';
import { words } from './words';

/** The picture follows a change of the text or of the cursor after this time, ms. */
const PAUSE_MS = 150;

export class Picture {
  readonly #extension: Uri;
  readonly #subscriptions: Disposable;
  #panel: WebviewPanel | undefined;
  #editor: TextEditor | undefined;
  /** The text that the page has. */
  #sent: { readonly document: TextDocument; readonly version: number } | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(extension: Uri) {
    this.#extension = extension;
    this.#subscriptions = Disposable.from(
      commands.registerCommand(`${SECTION}.showPicture`, () => this.#show()),
      window.onDidChangeActiveTextEditor((editor) => this.#follow(editor)),
      window.onDidChangeTextEditorSelection(({ textEditor }) => {
        if (textEditor === this.#editor) this.#schedule();
      }),
      workspace.onDidChangeTextDocument(({ document }) => {
        if (document === this.#editor?.document) this.#schedule();
      }),
      workspace.onDidChangeConfiguration((change) => {
        if (change.affectsConfiguration(SECTION)) this.#reload();
      }),
    );
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#panel?.dispose();
    this.#subscriptions.dispose();
  }

  #show(): void {
    this.#panel ??= this.#open();
    this.#panel.reveal(undefined, true);
    this.#follow(window.activeTextEditor);
  }

  #open(): WebviewPanel {
    const options = {
      enableScripts: true,
      localResourceRoots: ['element', 'dist'].map((folder) => Uri.joinPath(this.#extension, folder)),
    };
    const column = { viewColumn: ViewColumn.Beside, preserveFocus: true };
    const panel = window.createWebviewPanel(`${SECTION}.picture`, 'G-code', column, options);
    panel.webview.onDidReceiveMessage((message: FromPicture) => {
      if (message.kind === 'selected') return this.#select(message.line);
      // A page that was hidden has been loaded again.
      this.#sent = undefined;
      return this.#send();
    });
    panel.onDidDispose(() => {
      this.#panel = undefined;
      this.#sent = undefined;
    });
    panel.webview.html = this.#page(panel.webview);
    return panel;
  }

  #reload(): void {
    if (this.#panel !== undefined) this.#panel.webview.html = this.#page(this.#panel.webview);
  }

  #follow(editor: TextEditor | undefined): void {
    if (this.#panel === undefined || editor?.document.languageId !== LANGUAGE) return;
    this.#editor = editor;
    this.#panel.title = words().pictureOf(editor.document.uri.path.replace(/^.*\//, ''));
    this.#schedule();
  }

  #schedule(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#send(), PAUSE_MS);
  }

  async #send(): Promise<void> {
    if (this.#panel === undefined || this.#editor === undefined) return;
    const { document, selection } = this.#editor;
    const { version } = document;
    const isSent = this.#sent?.document === document && this.#sent.version === version;
    const message: ToPicture = {
      control: settings().control,
      line: selection.active.line + 1,
      ...(isSent ? {} : { text: document.getText() }),
    };
    // A hidden page receives nothing, and asks again when it is loaded.
    if (await this.#panel.webview.postMessage(message)) this.#sent = { document, version };
  }

  /** Selects the block of a line, from 1. */
  async #select(line: number): Promise<void> {
    const document = this.#editor?.document;
    if (document === undefined || line > document.lineCount) return;
    const { range, firstNonWhitespaceCharacterIndex: start } = document.lineAt(line - 1);
    const shown = window.visibleTextEditors.find((editor) => editor.document === document);
    this.#editor = await window.showTextDocument(document, {
      viewColumn: shown?.viewColumn ?? ViewColumn.One,
      selection: range.with(range.start.with(undefined, start)),
      preserveFocus: true,
    });
  }

  /** The page: nothing in it comes from elsewhere, and only the scripts of the extension run. */
  #page(webview: Webview): string {
    const address = (...path: readonly string[]): string =>
      webview.asWebviewUri(Uri.joinPath(this.#extension, ...path)).toString();
    const nonce = crypto.randomUUID();
    const policy = [
      `default-src 'none'`,
      `script-src 'nonce-${nonce}' 'wasm-unsafe-eval'`,
      `style-src 'nonce-${nonce}'`,
      `connect-src ${webview.cspSource} blob:`,
      `worker-src blob:`,
      `img-src blob:`,
    ].join('; ');
    return `<!doctype html>
<html lang="${language()}">
  <head>
    <meta charset="utf-8">
    <meta http-equiv="Content-Security-Policy" content="${policy}">
    <meta name="element" content="${escaped(address('element'))}">
    <meta name="pages" content="${escaped(settings().pages)}">
    <style nonce="${nonce}">
      body { padding: 0; }
      gcode-playground { display: block; --playground-height: 100vh; }
    </style>
    <script type="module" nonce="${nonce}" src="${escaped(address('dist', 'picture-page.js'))}"></script>
  </head>
  <body></body>
</html>`;
  }
}

/** A text in an attribute. */
function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
}
