/** A part of the module that is loaded later, or the texts of a language. */
export type PartName = /* NAMES */;

/** The addresses of the files of each part, in order: files of earlier parts come first. */
export const PART_FILES: Readonly<Record<PartName, readonly string[]>>;
