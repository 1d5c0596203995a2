import type { PartName } from './part-files.js';

/** Puts a part into a module (what `init` or `initSync` returned), from its files and, in the same order, their contents. */
export function addPart(part: PartName, exports: object, files: readonly string[], contents: readonly (WebAssembly.Module | string)[]): void;

/** Whether a file contains texts; the others are WebAssembly. */
export function isText(file: string): boolean;

/** Has the files of a part fetched, for a module that is still to come; one that cannot be had is tried again. */
export function fetchPart(files: readonly string[]): void;

/** Loads a part; rejected where one of its files cannot be had, after which it can be tried again. */
export function loadPart(part: PartName, exports: object, files: readonly string[]): Promise<void>;
