// The length limit of links. In a separate file, so that plain-text links can be read without the code for packed ones.

/** Most characters of a link, for reading and writing. */
export const LINK_LIMIT = 1_000_000;
