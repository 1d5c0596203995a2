/** What the page says to a version that waits, once the reader wants it. */
export const TAKE_OVER = 'take-over';
