// Whether the page is just being printed: what is made in the meantime has not heard of it.
//
// In: what the browser announces. Out: yes or no. Must not know: what is printed.

let printing = false;

// Where Node reads this, nothing is printed.
if (typeof window !== 'undefined') {
  window.addEventListener('beforeprint', () => (printing = true));
  window.addEventListener('afterprint', () => (printing = false));
}

/** Between the announcement that the page is printed and its end. */
export function isPrinting(): boolean {
  return printing;
}
