// Whether the page is being printed, for elements that are made after `beforeprint`.
//
// In: events of the browser. Out: true or false. Must not know: the printed contents.

let printing = false;

// There is no window in Node.
if (typeof window !== 'undefined') {
  window.addEventListener('beforeprint', () => (printing = true));
  window.addEventListener('afterprint', () => (printing = false));
}

/** True between `beforeprint` and `afterprint`. */
export function isPrinting(): boolean {
  return printing;
}
