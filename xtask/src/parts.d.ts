import type { PartName } from './part-files.js';

/**
 * Adds a part to a module (the result of `init` or `initSync`), from its files and, in the same order, their contents.
 */
export function addPart(part: PartName, exports: object, files: readonly string[], contents: readonly (WebAssembly.Module | string)[]): void;

/** Whether a file contains texts; all others are WebAssembly. */
export function isText(file: string): boolean;

/** Starts fetching the files of a part before the module exists. A file that fails is fetched again later. */
export function fetchPart(files: readonly string[]): void;

/** Loads a part. Rejects if one of its files cannot be loaded; it can then be called again. */
export function loadPart(part: PartName, exports: object, files: readonly string[]): Promise<void>;
