// Accepts files dropped on a part of the page.
//
// In: the element to drop on. Out: `onDrop`, with the files. While a file is over the element, its `data-drop`
// has the hint. Must not know: what happens to a file.

interface DropEvents {
  /** The hint while a file is over the element. */
  hint(): string;
  onDrop(first: File, ...further: readonly File[]): void;
}

/**
 * `all`: files dropped anywhere inside, before any inner element handles them; `left-over`: only files that no inner
 * element has handled.
 */
type DropScope = 'all' | 'unhandled';

export function acceptFiles(target: HTMLElement, events: DropEvents, scope: DropScope = 'all'): void {
  const isAccepted = (event: DragEvent): boolean =>
    (event.dataTransfer?.types.includes('Files') ?? false) && (scope === 'all' || !event.defaultPrevented);
  const mark = (on: boolean): void => {
    if (on) target.dataset['drop'] = events.hint();
    else delete target.dataset['drop'];
  };
  target.addEventListener('dragover', (event) => {
    const accepted = isAccepted(event);
    mark(accepted);
    if (accepted) event.preventDefault();
  });
  target.addEventListener('dragleave', (event) => {
    if (!target.contains(event.relatedTarget as Node | null)) mark(false);
  });
  target.addEventListener(
    'drop',
    (event) => {
      mark(false);
      const [first, ...further] = isAccepted(event) ? (event.dataTransfer?.files ?? []) : [];
      if (first === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      events.onDrop(first, ...further);
    },
    { capture: scope === 'all' },
  );
}
