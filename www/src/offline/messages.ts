// The messages of the page to the service worker.

/** To a waiting version, once the user accepts it. */
export const TAKE_OVER = 'take-over';

/** Stores the pages in a language: that of the reader. */
export interface StoreLanguage {
  readonly kind: 'store-language';
  readonly language: string;
}
