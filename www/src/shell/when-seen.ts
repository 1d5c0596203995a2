// Decides when an element starts: immediately, near the viewport, or on click (`loading`).
//
// In: the element, and its attribute `loading`. Out: one call of `start`. Until then the element has its size, and
// nothing is loaded for it. Must not know: the shell.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';

const LOADINGS = ['lazy', 'eager', 'click'] as const;
export type Loading = (typeof LOADINGS)[number];

export function parseLoading(attribute: string | null): Loading {
  return LOADINGS.find((loading) => loading === attribute) ?? 'lazy';
}

/**
 * Distance to the viewport at which an element starts, in viewport heights, so that it is ready when the user scrolls
 * to it.
 */
const START_DISTANCE = 1;

/** The elements that wait to come near the viewport. */
const waiting = new Map<Element, () => void>();
let observer: IntersectionObserver | undefined;

/** Calls `start` once the element is near the viewport or is printed. Returns a function that stops waiting. */
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
      { rootMargin: `${START_DISTANCE * 100}%` },
    );
    addEventListener('beforeprint', () => {
      for (const target of [...waiting.keys()]) startNow(target);
    });
  }
  waiting.set(element, start);
  observer.observe(element);
  return () => stopWaiting(element);
}

/** The button that starts the element. */
export function startButton(language: Language, start: () => void): HTMLElement {
  const button = make('button', { type: 'button', className: 'framed start' }, WORDS[language].show);
  button.addEventListener('click', start, { once: true });
  return button;
}

/** Measured synchronously, so that the first picture does not wait for the next frame. */
function isNear(element: HTMLElement): boolean {
  const { top, bottom, width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && bottom > -START_DISTANCE * innerHeight && top < (1 + START_DISTANCE) * innerHeight;
}

function startNow(element: Element): void {
  const start = waiting.get(element);
  stopWaiting(element);
  start?.();
}

function stopWaiting(element: Element): void {
  waiting.delete(element);
  observer?.unobserve(element);
}

const WORDS = words({
  en: { show: 'Show the tool path' },
  zh: { show: '显示刀具轨迹' },
  ru: { show: 'Показать траекторию' },
});
