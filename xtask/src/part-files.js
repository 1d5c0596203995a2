// Where the files of the parts are: src/parts.rs. Made by `cargo xtask`, which fills in the files.
//
// Apart from the script that loads them: the worker, which does, can have an address from which nothing is found.

/** The files of each part and language, by its name; files of the parts before it come first. */
export const PART_FILES = {
  /* FILES */
};
