/** The message of the page to a waiting version, once the user accepts it. */
export const TAKE_OVER = 'take-over';
