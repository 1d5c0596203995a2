// Fields of a dialog with their captions, and a text that is copied from one.
//
// In: the field. Out: its label; whether its text was copied. Must not know: what it is for.

import { make } from '../dom/dom';

export interface Field {
  readonly label: HTMLLabelElement;
  readonly caption: HTMLElement;
}

/** The caption stands over it. */
export function field(input: HTMLElement): Field {
  const caption = make('span');
  return { label: make('label', { className: 'field-of-dialog' }, caption, input), caption };
}

/** The caption stands beside it. */
export function check(input: HTMLInputElement): Field {
  const caption = make('span');
  return { label: make('label', { className: 'check' }, input, caption), caption };
}

/** Selects all of a text, and copies it; `show` is called where the text has to be seen, to be copied by hand. */
export async function copied(
  output: HTMLTextAreaElement,
  show = (): void => undefined,
): Promise<'copied' | 'not-copied'> {
  output.select();
  try {
    await navigator.clipboard.writeText(output.value);
    return 'copied';
  } catch {
    // Where a page may not write there, the old way may still work.
    show();
    output.select();
    return document.execCommand('copy') ? 'copied' : 'not-copied';
  }
}

/**
 * Copies a text that is still being made at the press, to be called at the press itself: Safari refuses what a page writes
 * more than a second after it. False where the browser cannot, may not, or there is no text.
 */
export async function copiedOnceMade(text: Promise<string | undefined>): Promise<boolean> {
  try {
    const made = text.then((text) => {
      if (text === undefined) throw new Error('there is nothing to copy');
      return new Blob([text], { type: 'text/plain' });
    });
    // Where the browser takes none, nobody else hears that it failed.
    made.catch(() => undefined);
    await navigator.clipboard.write([new ClipboardItem({ 'text/plain': made })]);
    return true;
  } catch {
    return false;
  }
}
