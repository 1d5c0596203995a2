// Builds the static page into www/dist. Addresses are relative, so the folder works at any location.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig, type HtmlTagDescriptor, type Plugin } from 'vite';
import { compiledEarly } from './compiled-early';
import { examples } from './examples';
import { exercises } from './exercises';
import { installable } from './installable';
import { policy, withPolicy } from './policy';

/**
 * The page preloads everything that the first picture needs in parallel, instead of one script after another: the
 * panels, which are imported when the element is made, and the module of the interpreter. The worker's script is not
 * preloaded: no preload matches its request in all browsers, and it arrives long before the module.
 */
const preloads: Plugin = {
  name: 'preloads',
  transformIndexHtml: {
    order: 'post',
    handler(_html, { bundle }) {
      const files = Object.values(bundle ?? {});
      const module = files.filter(({ fileName }) => /gcode_playground_bg-[\w-]+\.wasm$/.test(fileName));
      const chunks = files.filter((file) => file.type === 'chunk');
      const scripts = new Set<string>();
      const preload = (name: string): void => {
        if (name === 'element.js' || scripts.has(name)) return;
        scripts.add(name);
        for (const imported of chunks.find(({ fileName }) => fileName === name)?.imports ?? []) preload(imported);
      };
      for (const { name, isDynamicEntry, fileName } of chunks)
        if (isDynamicEntry && name === 'further') preload(fileName);
      const link = (attrs: Record<string, string | boolean>): HtmlTagDescriptor => ({
        tag: 'link',
        attrs,
        injectTo: 'head',
      });
      return [
        ...module.map(({ fileName }) =>
          link({ rel: 'preload', as: 'fetch', type: 'application/wasm', crossorigin: true, href: `./${fileName}` }),
        ),
        ...[...scripts].map((file) => link({ rel: 'modulepreload', crossorigin: true, href: `./${file}` })),
      ];
    },
  },
};

/** The page "Parts" is a separate entry without a preload, so it does not change the scripts of the main page. */
const partsPage: Plugin = {
  name: 'parts-page',
  apply: 'build',
  generateBundle() {
    const source = readFileSync('parts.html', 'utf8').replace('./src/page/parts.ts', './parts.js');
    this.emitFile({ type: 'asset', fileName: 'parts.html', source: withPolicy(source) });
  },
};

/** `vite preview` serves an empty page without a policy. The browser tests write pages of other sites into it. */
const foreignPage: Plugin = {
  name: 'foreign-page',
  configurePreviewServer({ middlewares }) {
    middlewares.use('/foreign/site/page.html', (_request, response) => {
      response.setHeader('content-type', 'text/html; charset=utf-8');
      response.end(
        '<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A manual</title></head><body></body></html>',
      );
    });
  },
};

/**
 * `cargo xtask play`: serves the rule pages, the reference and the pages of the manual from another folder, and reloads the page
 * when there is a new interpreter module.
 */
const developmentServer: Plugin = {
  name: 'development-server',
  configureServer({ middlewares, watcher, ws }) {
    const folder = process.env['PLAYGROUND_DOCUMENTS'];
    // The server ends with the command that started it, which holds the other end of the pipe.
    if (folder !== undefined) process.stdin.resume().once('end', () => process.exit());
    // The built script of the element, which the pages of the manual load.
    middlewares.use('/element.js', (_request, response) => {
      response.setHeader('content-type', 'text/javascript');
      response.end("export * from '/src/shell/element.ts';");
    });
    middlewares.use('/search.js', (_request, response) => {
      response.setHeader('content-type', 'text/javascript');
      response.end("import '/src/page/manual-search.ts';");
    });
    middlewares.use((request, response, next) => {
      const path = /^\/((?:rules|docs|manual)\/[\w./-]*)/.exec(request.url ?? '')?.[1];
      if (folder === undefined || path === undefined || path.includes('..')) return next();
      try {
        const file = path.endsWith('/') ? `${path}index.html` : path;
        const text = readFileSync(join(folder, file));
        if (file.endsWith('.html')) response.setHeader('content-type', 'text/html; charset=utf-8');
        response.end(text);
      } catch {
        next();
      }
    });
    // The stamp file of the package is written last.
    const reload = (file: string): void => void (file.endsWith('.built-by-xtask') && ws.send({ type: 'full-reload' }));
    watcher.on('add', reload).on('change', reload);
  },
};

/** Version of the crate: the code that a user copies to embed the element names its folder after it. */
const version = /^version = "(.*)"$/m.exec(readFileSync('../Cargo.toml', 'utf8'))?.[1] ?? '';

/**
 * A script is imported immediately, so preloading it gains nothing, and WebKit caches a failed preload. Firefox also
 * caches failed imports, so of the parts that the page loads later, perhaps offline, only the styles are preloaded.
 */
function isPreloaded(file: string, host: string): boolean {
  return file.endsWith('.css') || !/(^|\/)index-/.test(host);
}

export default defineConfig({
  base: './',
  define: { PLAYGROUND_VERSION: JSON.stringify(version) },
  plugins: [
    preloads,
    examples,
    exercises,
    installable,
    compiledEarly,
    policy,
    partsPage,
    foreignPage,
    developmentServer,
  ],
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: true,
    assetsInlineLimit: 0,
    cssTarget: 'chrome123',
    modulePreload: {
      resolveDependencies: (file, needed, { hostId, hostType }) =>
        hostType === 'html' ? needed : needed.filter((each) => each !== file && isPreloaded(each, hostId)),
    },
    rollupOptions: {
      input: {
        index: 'index.html',
        parts: 'src/page/parts.ts',
        element: 'src/shell/element.ts',
        search: 'src/page/manual-search.ts',
      },
      // Other sites use the element, so its name is stable.
      output: {
        entryFileNames: ({ name }) =>
          ['element', 'parts', 'search'].includes(name) ? '[name].js' : 'assets/[name]-[hash].js',
      },
      preserveEntrySignatures: 'allow-extension',
    },
  },
  // A classic worker: only that can start from memory in a sandboxed frame.
  worker: { format: 'iife' },
  // The gallery's programs are in tests/programs, outside of this folder.
  server: { fs: { allow: ['..'] } },
});
