/** A part of the module that is loaded after the first picture. */
export type PartName = /* NAMES */;

/** The addresses of the files of each part, in the order in which they are added; one that two parts need is in both lists. */
export const PART_FILES: Readonly<Record<PartName, readonly string[]>>;
