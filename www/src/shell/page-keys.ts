// Keys between the element and the page around it: the keys of the playback also work outside of the elements, and keys
// that are typed inside do not reach the page.
//
// In: the elements in the document, key presses. Out: the key for the element that was used last. Must not know: the
// effect of a key.

/** An element of the playground. */
interface KeyTarget extends HTMLElement {
  /** Handles a key that was pressed outside of the element. */
  handleKey(event: KeyboardEvent): void;
}

/** The elements of the document, the last used one last. */
const connectedElements = new Set<KeyTarget>();

export function connectKeys(element: KeyTarget): void {
  connectedElements.add(element);
  if (connectedElements.size === 1) document.addEventListener('keydown', onDocumentKeydown);
}

export function disconnectKeys(element: KeyTarget): void {
  connectedElements.delete(element);
  if (connectedElements.size === 0) document.removeEventListener('keydown', onDocumentKeydown);
}

export function markAsLastUsed(element: KeyTarget): void {
  if (!connectedElements.delete(element)) return;
  connectedElements.add(element);
}

/**
 * Keys typed inside must not trigger commands of the page: manuals turn pages with arrow keys and open a search with
 * letters.
 */
export function keepKeyInside(element: KeyTarget, event: KeyboardEvent): void {
  const [origin] = event.composedPath();
  if (isPlainKey(event) && origin instanceof Node && origin.getRootNode() === element.shadowRoot)
    event.stopPropagation();
}

/** Keys without a modifier, which pages use as commands, and which type or move in a text, list or drawing. */
function isPlainKey({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return !ctrlKey && !metaKey && !altKey && key !== 'Escape' && key !== 'Tab' && !/^F\d+$/.test(key);
}

/** The keys of the playback also work if the focus is outside, but not in a text field. */
function onDocumentKeydown(event: KeyboardEvent): void {
  const isPlayKey = event.key === 'F9' || (event.key === 'Enter' && (event.ctrlKey || event.metaKey));
  if (!isPlayKey || event.defaultPrevented) return;
  const path = event.composedPath();
  const isText = path.some(
    (part) => part instanceof HTMLElement && (part.isContentEditable || part.matches('input, textarea')),
  );
  if (isText || [...connectedElements].some((element) => path.includes(element))) return;
  [...connectedElements].at(-1)?.handleKey(event);
}
