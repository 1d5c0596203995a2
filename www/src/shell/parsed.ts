// Whether all of an element has come: a page is read while it arrives, and a script that is there early meets
// elements without their children.
//
// In: a node, what is to be done with it. Out: a call once it is whole. Must not know: what it is.

const waiting = new Map<Node, () => void>();
let observer: MutationObserver | undefined;

/** Whether the page goes on after the node, or has come to its end. */
export function isParsed(node: Node): boolean {
  if (document.readyState !== 'loading') return true;
  for (let at: Node | null = node; at !== null; at = at instanceof ShadowRoot ? at.host : at.parentNode) {
    if (at.nextSibling !== null) return true;
  }
  return false;
}

/** Acts once the node is whole: now, where it is; of several acts for a node the last one counts. */
export function whenParsed(node: Node, act: () => void): void {
  if (isParsed(node)) {
    waiting.delete(node);
    act();
    return;
  }
  waiting.set(node, act);
  if (observer !== undefined) return;
  observer = new MutationObserver(look);
  observer.observe(document, { childList: true, subtree: true });
  document.addEventListener('readystatechange', look);
}

function look(): void {
  for (const [node, act] of [...waiting]) {
    // One of those before may have taken it away.
    if (waiting.get(node) !== act || !isParsed(node)) continue;
    waiting.delete(node);
    act();
  }
  if (waiting.size > 0) return;
  observer?.disconnect();
  observer = undefined;
  document.removeEventListener('readystatechange', look);
}
