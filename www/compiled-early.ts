// The editor's scripts are compiled whole while they are loaded, in a thread of the browser's, and not function by function
// under the writer's first keys: at a slow processor the first key in a program was the slowest by a third.
import type { Plugin } from 'vite';

/** What Chromium looks for at the beginning of a script; to other browsers it is a comment. */
const HINT = '//# allFunctionsCalledOnLoad\n';

export const compiledEarly: Plugin = {
  name: 'compiled-early',
  // Last of all, since what makes scripts small takes comments away.
  generateBundle: {
    order: 'post',
    handler(_options, bundle) {
      // What is loaded when the reader first is in the text is to be there soon, and runs less at once.
      const isEditor = (id: string): boolean => /\/node_modules\/@codemirror\/(view|lint|search)\//.test(id);
      const scripts = Object.values(bundle).filter((file) => file.type === 'chunk' && file.moduleIds.some(isEditor));
      if (scripts.length === 0) this.error('no script of the editor was found');
      for (const script of scripts) if (script.type === 'chunk') script.code = HINT + script.code;
    },
  },
};
