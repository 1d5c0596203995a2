// Detects whether an element is parsed completely: a script that runs while the page is still loading can find elements
// without their children.
//
// In: a node, and a callback. Out: the call once the node is complete. Must not know: the kind of node.

const waiting = new Map<Node, () => void>();
let observer: MutationObserver | undefined;

/** Whether content follows the node, or the document is complete. */
export function isParsed(node: Node): boolean {
  if (document.readyState !== 'loading') return true;
  for (let at: Node | null = node; at !== null; at = at instanceof ShadowRoot ? at.host : at.parentNode) {
    if (at.nextSibling !== null) return true;
  }
  return false;
}

/** Calls `act` once the node is complete, or immediately if it is; a later `act` for the same node replaces it. */
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
    // A previous callback may have removed it.
    if (waiting.get(node) !== act || !isParsed(node)) continue;
    waiting.delete(node);
    act();
  }
  if (waiting.size > 0) return;
  observer?.disconnect();
  observer = undefined;
  document.removeEventListener('readystatechange', look);
}
