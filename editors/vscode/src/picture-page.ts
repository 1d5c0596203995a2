// The page of the picture, in the webview.
//
// In: the program and the line of the cursor, from the extension. Out: the element, which draws the program and marks
// the block of that line; the line of a stroke that the user has clicked. Must not know: the editor.

import type { GcodePlayground } from 'gcode-playground/element';
import type { FromPicture, ToPicture } from './messages';

/** The names of the files of the interpreter; `build.mjs` fills them in. */
declare const ELEMENT_FILES: readonly string[];

declare function acquireVsCodeApi(): { postMessage(message: FromPicture): void };

const vscode = acquireVsCodeApi();
const meta = (name: string): string => document.querySelector<HTMLMetaElement>(`meta[name=${name}]`)?.content ?? '';
const FOLDER = meta('element');

/** The line that the picture marks. */
let markedLine: number | undefined;

await giveFilesToWorkers();
await import(`${FOLDER}/element.js`);
const element = document.createElement('gcode-playground');
element.loading = 'eager';
element.view = 'playback';
element.language = languageOf(document.documentElement.lang);
linkPages(meta('pages'));
followColours();
element.addEventListener('gcode-select', ({ detail: { stroke } }) => {
  markedLine = stroke.line;
  vscode.postMessage({ kind: 'selected', line: stroke.line });
});
addEventListener('message', ({ data }: MessageEvent<ToPicture>) => show(data));
document.body.append(element);
vscode.postMessage({ kind: 'ready' });

function show({ text, control, line }: ToPicture): void {
  if (element.control !== (control || null)) element.control = control || null;
  if (text !== undefined) {
    element.value = text;
    markedLine = undefined;
  }
  if (line === markedLine) return;
  markedLine = line;
  element.goToLine(line);
}

/**
 * VS Code gives the files of an extension to the documents of a webview, not to their workers. So the page fetches the
 * files of the interpreter, and a worker of the page reads copies in memory in their place.
 */
async function giveFilesToWorkers(): Promise<void> {
  const script = `${FOLDER}/worker.js`;
  const copies = await Promise.all(
    // The page fetches `core.wasm` anyway.
    ELEMENT_FILES.filter((name) => name !== 'core.wasm').map(async (name) => [
      `${FOLDER}/${name}`,
      URL.createObjectURL(await content(`${FOLDER}/${name}`)),
    ]),
  );
  const substitute = `{
    const [copies, fetchFile] = [new Map(${JSON.stringify(copies)}), self.fetch.bind(self)];
    self.fetch = (address, options) => fetchFile(copies.get(address) ?? address, options);
  }\n`;
  const parts = [substitute, await content(script)];
  const copy = URL.createObjectURL(new Blob(parts, { type: 'text/javascript' }));
  globalThis.Worker = class extends Worker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(String(address) === script ? copy : address, options);
    }
  };
}

async function content(address: string): Promise<Blob> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return response.blob();
}

/** Links lead to the pages of a site; without one there are none. */
function linkPages(site: string): void {
  const at = (path: string): string => (site === '' ? '' : `${site}/${path}`);
  element.playground = at('index.html');
  for (const name of ['rules', 'docs', 'manual'] as const) element[name] = at(`${name}/`);
}

/** The element has the colours of the editor. */
function followColours(): void {
  const update = (): void => {
    const { classList } = document.body;
    const isLight = ['vscode-light', 'vscode-high-contrast-light'].some((name) => classList.contains(name));
    element.theme = isLight ? 'light' : 'dark';
  };
  update();
  new MutationObserver(update).observe(document.body, { attributeFilter: ['class'] });
}

function languageOf(tag: string): GcodePlayground['language'] {
  return tag === 'zh' || tag === 'ru' ? tag : 'en';
}
