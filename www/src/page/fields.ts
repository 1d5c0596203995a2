// Fields of a dialog with their captions, and copying of text to the clipboard.
//
// In: the field. Out: its label; whether its text was copied. Must not know: the purpose of the field.

import { make } from '../dom/dom';

interface Field {
  readonly label: HTMLLabelElement;
  readonly caption: HTMLElement;
}

/** A field with its caption above. */
export function field(input: HTMLElement): Field {
  const caption = make('span');
  return { label: make('label', { className: 'field-of-dialog' }, caption, input), caption };
}

/** A checkbox with its caption beside it. */
export function checkbox(input: HTMLInputElement): Field {
  const caption = make('span');
  return { label: make('label', { className: 'check' }, input, caption), caption };
}

/** Selects and copies the text of `output`. `show` is called if the text must become visible, for copying by hand. */
export async function copyField(
  output: HTMLTextAreaElement,
  show = (): void => undefined,
): Promise<'copied' | 'not-copied'> {
  output.select();
  try {
    await navigator.clipboard.writeText(output.value);
    return 'copied';
  } catch {
    // If the page may not write to the clipboard, `execCommand` may still work.
    show();
    output.select();
    return document.execCommand('copy') ? 'copied' : 'not-copied';
  }
}

/**
 * Copies a text that is still being computed. Call it directly in the event handler: Safari rejects a clipboard write
 * more than a second after the click. Returns false if the browser cannot or may not copy, or if there is no text.
 */
export async function copyWhenReady(text: Promise<string | undefined>): Promise<boolean> {
  try {
    const blob = text.then((text) => {
      if (text === undefined) throw new Error('there is nothing to copy');
      return new Blob([text], { type: 'text/plain' });
    });
    // If the browser rejects the item, nothing else handles a rejection of `blob`.
    blob.catch(() => undefined);
    await navigator.clipboard.write([new ClipboardItem({ 'text/plain': blob })]);
    return true;
  } catch {
    return false;
  }
}
