// Asking the browser not to delete what it keeps when it needs room.
//
// In: nothing. Out: at most one question in the life of the page, since one browser puts it to the reader. Must not
// know: what is kept.

const ASKED = 'gcode-playground:asked-to-persist';

/** Called when the reader looks at what is kept: a question that comes then can be understood. */
export function askToPersist(): void {
  try {
    if (localStorage.getItem(ASKED) !== null) return;
    localStorage.setItem(ASKED, 'yes');
  } catch {
    return;
  }
  // Pages without a certificate have no `storage`.
  const { storage } = navigator as { readonly storage?: StorageManager };
  void storage?.persist().catch(() => false);
}
