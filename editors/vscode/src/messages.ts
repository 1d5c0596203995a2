// The messages between the extension and the page of the picture.

/** What the picture shows. */
export interface ToPicture {
  /** The program; omitted if it has not changed. */
  readonly text?: string;
  /** The control; empty: the default. */
  readonly control: string;
  /** The line of the cursor, from 1. */
  readonly line: number;
}

/** The page can receive messages, or the user has selected a stroke. */
export type FromPicture =
  | { readonly kind: 'ready' }
  | {
      readonly kind: 'selected';
      /** The line of its block, from 1. */
      readonly line: number;
    };
