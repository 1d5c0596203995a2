// How long a link may be. A file of its own, since links in plain text are read without what packs and unpacks.

/** Characters of a link that are read at most, and that one has at most. */
export const LINK_LIMIT = 1_000_000;
