// Loads a text file of the site or of another one.
//
// In: an address, relative to the document. Out: the text. Must not know: the purpose of the text.

import { withTimeout } from './timeout';

const TIMEOUT_MS = 20_000;

/** The text of a file; undefined if it cannot be loaded in time. */
export async function loadText(address: string): Promise<string | undefined> {
  try {
    const response = await withTimeout(fetch(new URL(address, document.baseURI)), TIMEOUT_MS);
    return response === 'timeout' || !response.ok ? undefined : await response.text();
  } catch {
    return undefined;
  }
}
