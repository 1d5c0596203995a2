// Loads a text file of the site or of another one.
//
// In: an address, relative to the document. Out: the text. Must not know: the purpose of the text.

import { withTimeout } from './timeout';

const TIMEOUT_MS = 20_000;

const isPage = ({ headers }: Response): boolean => headers.get('content-type')?.startsWith('text/html') === true;

/** The text of a file; undefined if it cannot be loaded in time. Some servers answer a request for a missing file with a page. */
export async function loadText(address: string): Promise<string | undefined> {
  try {
    const response = await withTimeout(fetch(new URL(address, document.baseURI)), TIMEOUT_MS);
    if (response === 'timeout' || !response.ok || isPage(response)) return undefined;
    return await response.text();
  } catch {
    return undefined;
  }
}
