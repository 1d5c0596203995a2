// The shipped module under Node, with all its parts.
import { readFileSync } from 'node:fs';
import { initSync } from '../../www/pkg/gcode_playground.js';
import { PART_FILES } from '../../www/pkg/part-files.js';
import { addPart } from '../../www/pkg/parts.js';

/** What `initSync` returns. */
export const wasm = initSync({ module: readFileSync(new URL('../../www/pkg/gcode_playground_bg.wasm', import.meta.url)) });
for (const [part, files] of Object.entries(PART_FILES)) {
  addPart(part, wasm, files, files.map((file) => new WebAssembly.Module(readFileSync(new URL(file)))));
}

export { Playground } from '../../www/pkg/gcode_playground.js';
