// Detects whether an element is parsed completely: a script that runs while the page is still loading can find elements
// without their children.
//
// In: a node, and a callback. Out: the call once the node is complete. Must not know: the kind of node.

const waiting = new Map<Node, () => void>();
let observer: MutationObserver | undefined;

/** Whether content follows the node, or the document is complete. */
function isParsed(node: Node): boolean {
  if (document.readyState !== 'loading') return true;
  for (
    let ancestor: Node | null = node;
    ancestor !== null;
    ancestor = ancestor instanceof ShadowRoot ? ancestor.host : ancestor.parentNode
  ) {
    if (ancestor.nextSibling !== null) return true;
  }
  return false;
}

/**
 * Calls `callback` once the node is complete, or immediately if it is; a later `callback` for the same node replaces
 * it.
 */
export function whenParsed(node: Node, callback: () => void): void {
  if (isParsed(node)) {
    waiting.delete(node);
    callback();
    return;
  }
  waiting.set(node, callback);
  if (observer !== undefined) return;
  observer = new MutationObserver(callReady);
  observer.observe(document, { childList: true, subtree: true });
  document.addEventListener('readystatechange', callReady);
}

function callReady(): void {
  for (const [node, callback] of [...waiting]) {
    // A previous callback may have removed it.
    if (waiting.get(node) !== callback || !isParsed(node)) continue;
    waiting.delete(node);
    callback();
  }
  if (waiting.size > 0) return;
  observer?.disconnect();
  observer = undefined;
  document.removeEventListener('readystatechange', callReady);
}
