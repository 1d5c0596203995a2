// The shipped module under Node, with all its parts.
import { readFileSync } from 'node:fs';
import { initSync } from '../../www/pkg/gcode_playground.js';
import { PART_FILES } from '../../www/pkg/part-files.js';
import { addPart, isText } from '../../www/pkg/parts.js';

/** What `initSync` returns. */
export const wasm = initSync({ module: readFileSync(new URL('../../www/pkg/gcode_playground_bg.wasm', import.meta.url)) });
const read = (file) => (isText(file) ? readFileSync(new URL(file), 'utf8') : new WebAssembly.Module(readFileSync(new URL(file))));
for (const [part, files] of Object.entries(PART_FILES)) addPart(part, wasm, files, files.map(read));

export { Playground } from '../../www/pkg/gcode_playground.js';
