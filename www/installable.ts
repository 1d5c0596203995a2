// Makes the page installable: a manifest in each language and icons. Also writes the notice for users who open
// `index.html` from a disk, where browsers load no modules.
//
// In: `icons`, the texts of the page. Out: files next to the page. Must not know: how the page is stored.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';

const ICONS = join(import.meta.dirname, 'icons');

/** As in `src/page/words.ts`, with a short name for the icon. */
const NAMES = {
  en: {
    name: 'G-code playground',
    short_name: 'G-code',
    description: 'Write a lathe program, see the tool path, find the mistakes.',
  },
  zh: { name: 'G 代码演练场', short_name: 'G 代码', description: '编写车床程序，查看刀具轨迹，找出错误。' },
  ru: {
    name: 'Песочница G-кода',
    short_name: 'G-код',
    description: 'Напишите программу для токарного станка, посмотрите траекторию, найдите ошибки.',
  },
} as const;

/** The file types of the page's "Open" button, without `.txt`: a text is not always a program. */
const PROGRAMS = ['.nc', '.cnc', '.tap', '.gcode', '.ngc', '.mpf', '.min', '.eia'];

function manifest(lang: keyof typeof NAMES): string {
  return JSON.stringify({
    // Identifies the same application, regardless of its name.
    id: './',
    start_url: './',
    scope: './',
    lang,
    ...NAMES[lang],
    display: 'standalone',
    background_color: '#f4f6f8',
    theme_color: '#0b6485',
    categories: ['education', 'productivity'],
    icons: [
      { src: 'icons/icon.svg', sizes: 'any', type: 'image/svg+xml' },
      { src: 'icons/icon-192.png', sizes: '192x192', type: 'image/png' },
      { src: 'icons/icon-512.png', sizes: '512x512', type: 'image/png' },
      { src: 'icons/maskable-512.png', sizes: '512x512', type: 'image/png', purpose: 'maskable' },
    ],
    file_handlers: [{ action: './', accept: { 'text/plain': PROGRAMS } }],
  });
}

export const installable: Plugin = {
  name: 'installable',
  generateBundle() {
    for (const lang of ['en', 'zh', 'ru'] as const)
      this.emitFile({ type: 'asset', fileName: `manifest-${lang}.webmanifest`, source: manifest(lang) });
    for (const name of readdirSync(ICONS))
      this.emitFile({ type: 'asset', fileName: `icons/${name}`, source: readFileSync(join(ICONS, name)) });
    this.emitFile({
      type: 'asset',
      fileName: 'from-disk.js',
      source: readFileSync(join(import.meta.dirname, 'from-disk.js'), 'utf8'),
    });
  },
};
