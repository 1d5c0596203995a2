// The Content-Security-Policy of the page, as a `meta` element, because a static host may not be able to send headers.
//
// In: the built HTML. Out: the HTML with its policy, which contains the hash of each inline script. The frame
// (`embed/index.html`), the rule pages, the documents and the pages of the manual contain their own policies.
import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** The sources of each kind of content. Everything else is blocked. */
const SOURCES: Readonly<Record<string, readonly string[]>> = {
  'default-src': ["'none'"],
  'script-src': ["'self'", "'wasm-unsafe-eval'"],
  'worker-src': ["'self'"],
  'connect-src': ["'self'"],
  'style-src': ["'self'"],
  // The icon is a `data:` address. The printed drawing and the shared picture are `blob:` addresses.
  'img-src': ["'self'", 'data:', 'blob:'],
  'manifest-src': ["'self'"],
  'base-uri': ["'none'"],
  'form-action': ["'none'"],
};

const CHARSET = '<meta charset="utf-8" />';

export const policy: Plugin = {
  name: 'policy',
  // The development server adds inline scripts and styles.
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: withPolicy,
  },
};

/** The page with its policy. */
export function withPolicy(html: string): string {
  if (!html.includes(CHARSET)) throw new Error(`index.html does not contain ${CHARSET}`);
  // The HTML parser turns CRLF into LF before a script is hashed.
  const text = html.replaceAll('\r\n', '\n');
  const hashes = [...text.matchAll(/<script>(.*?)<\/script>/gs)].map(
    ([, script = '']) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`,
  );
  const all = { ...SOURCES, 'script-src': [...(SOURCES['script-src'] ?? []), ...hashes] };
  const content = Object.entries(all)
    .map(([directive, sources]) => `${directive} ${sources.join(' ')}`)
    .join('; ');
  return text.replace(CHARSET, `${CHARSET}\n    <meta http-equiv="Content-Security-Policy" content="${content}" />`);
}
