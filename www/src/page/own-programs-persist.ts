// Asks the browser not to delete the stored programs when it needs space.
//
// In: nothing. Out: at most one request per browser, since some browsers ask the user. Must not know: the stored data.

const ASKED_KEY = 'gcode-playground:asked-to-persist';

/** Call it when the user looks at the stored programs, so that the browser's question makes sense. */
export function askToPersist(): void {
  try {
    if (localStorage.getItem(ASKED_KEY) !== null) return;
    localStorage.setItem(ASKED_KEY, 'yes');
  } catch {
    return;
  }
  // `storage` is missing on pages that are not served over HTTPS.
  const { storage } = navigator as { readonly storage?: StorageManager };
  void storage?.persist().catch(() => false);
}
