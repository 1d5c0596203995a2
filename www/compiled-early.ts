// Compiles the editor's scripts completely and in the background while they load, not function by function at the
// user's first keys: on a slow processor the first key in a program took a third longer.
import type { Plugin } from 'vite';

/** Chromium looks for this at the start of a script; for other browsers it is a comment. */
const HINT = '//# allFunctionsCalledOnLoad\n';

export const compiledEarly: Plugin = {
  name: 'compiled-early',
  // After all other plugins, because the minifier removes comments.
  generateBundle: {
    order: 'post',
    handler(_options, bundle) {
      // Only the scripts that are loaded when the user first focuses the text: they must be ready soon.
      const isEditor = (id: string): boolean => /\/node_modules\/@codemirror\/(view|lint|search)\//.test(id);
      const scripts = Object.values(bundle).filter((file) => file.type === 'chunk' && file.moduleIds.some(isEditor));
      if (scripts.length === 0) this.error('no script of the editor was found');
      for (const script of scripts) if (script.type === 'chunk') script.code = HINT + script.code;
    },
  },
};
