/** A part of the module that is loaded after the first picture. */
export type PartName = /* NAMES */;

/** The files of each part; one that two parts need is in both lists. */
export const PART_FILES: Readonly<Record<PartName, readonly URL[]>>;

/** Puts a part into a module (what `init` or `initSync` returned), from its compiled files, in the order of `PART_FILES`. */
export function addPart(part: PartName, exports: object, compiled: readonly WebAssembly.Module[]): void;

/** Has the files of a part fetched, for a module that is still to come; one that cannot be had is tried again. */
export function fetchPart(part: PartName): void;

/** Loads a part; rejected where one of its files cannot be had, after which it can be tried again. */
export function loadPart(part: PartName, exports: object): Promise<void>;
