// When an element starts: at once, when it comes near the view, or when the reader asks for it.
//
// In: the element, and what it says of `loading`. Out: one call, when it is time. Until then its box is there with its height, and nothing
// is loaded for it. Must not know: what is started.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';

export const LOADINGS = ['lazy', 'eager', 'click'] as const;
export type Loading = (typeof LOADINGS)[number];

export function loadingOf(attribute: string | null): Loading {
  return LOADINGS.find((loading) => loading === attribute) ?? 'lazy';
}

/** How far from the view an element is started, in heights of the window: reading goes on while it is made. */
const NEAR = 1;

/** What waits to come near the view. */
const waiting = new Map<Element, () => void>();
let observer: IntersectionObserver | undefined;

/** Calls once the element is near the view, or is to be printed. What is returned ends the wait. */
export function whenNear(element: HTMLElement, start: () => void): () => void {
  if (isNear(element)) {
    start();
    return () => undefined;
  }
  if (observer === undefined) {
    observer = new IntersectionObserver(
      (entries) => {
        for (const { isIntersecting, target } of entries) if (isIntersecting) startNow(target);
      },
      { rootMargin: `${NEAR * 100}%` },
    );
    addEventListener('beforeprint', () => {
      for (const target of [...waiting.keys()]) startNow(target);
    });
  }
  waiting.set(element, start);
  observer.observe(element);
  return () => forget(element);
}

/** The button over the box of an element that waits for it. */
export function startButton(language: Language, start: () => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'framed start' }, WORDS[language].show);
  button.addEventListener('click', start, { once: true });
  return button;
}

/** Asked at once: the first picture of a page does not wait for the next frame. */
function isNear(element: HTMLElement): boolean {
  const { top, bottom, width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && bottom > -NEAR * innerHeight && top < (1 + NEAR) * innerHeight;
}

function startNow(element: Element): void {
  const start = waiting.get(element);
  forget(element);
  start?.();
}

function forget(element: Element): void {
  waiting.delete(element);
  observer?.unobserve(element);
}

const WORDS = words({
  en: { show: 'Show the tool path' },
  zh: { show: '显示刀具轨迹' },
  ru: { show: 'Показать траекторию' },
});
