// Builds the static page into www/dist. Addresses are relative, so the folder works wherever it is put.
import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: { target: 'es2022', outDir: 'dist', emptyOutDir: true, assetsInlineLimit: 0, cssTarget: 'chrome123' },
  worker: { format: 'es' },
  // The gallery's programs stand in tests/programs, one level above this folder.
  server: { fs: { allow: ['..'] } },
});
