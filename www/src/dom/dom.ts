// Helpers that make elements; the page has no UI framework.
//
// In: a tag, properties, children. Out: the element. Must not know: its purpose.

type Child = Node | string;

/** Makes an element; `properties` are set as properties, except `part`, `role`, `aria-…` and `data-…`. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Readonly<Record<string, string | boolean | number>> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name === 'part' || name === 'role' || name.includes('-')) element.setAttribute(name, String(value));
    else Reflect.set(element, name, value);
  }
  element.append(...children);
  return element;
}

/** Shows a text. An unchanged text is not set again, because each change causes a new layout. */
export function setText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Shows these children in this order. Children that are already in place are not moved. */
export function setChildren(parent: HTMLElement, children: readonly HTMLElement[]): void {
  const kept = new Set<Element>(children);
  for (const child of [...parent.children]) if (!kept.has(child)) child.remove();
  for (const [at, child] of children.entries()) {
    const existing = parent.children[at];
    if (existing !== child) parent.insertBefore(child, existing ?? null);
  }
}

/** A shape of an icon: filled if it has no width, otherwise a line of this width; `filled` makes it both. */
interface IconShape {
  readonly d: string;
  readonly width?: number;
  readonly filled?: boolean;
  /** Drawn over another shape. */
  readonly overlaid?: boolean;
}

/** The icons: 20 × 20, in the text colour. */
const ICONS = {
  play: [{ d: 'M6 3.5v13l10.5-6.5z' }],
  screen: [{ d: 'M11.5 3.5h5v5M16.5 3.5l-5.2 5.2M8.5 16.5h-5v-5M3.5 16.5l5.2-5.2', width: 1.7 }],
  'from-here': [{ d: 'M3.5 3v14', width: 2 }, { d: 'M7.5 4.5v11l8.5-5.5z' }],
  pause: [{ d: 'M5.5 4h3v12h-3zM11.5 4h3v12h-3z' }],
  next: [{ d: 'M4 4v12l8-6zM13.5 4h2.5v12h-2.5z' }],
  previous: [{ d: 'M16 4v12l-8-6zM4 4h2.5v12H4z' }],
  whole: [{ d: 'M5 5l10 10M15 5L5 15', width: 1.8 }],
  fit: [{ d: 'M3.5 7.5v-4h4M12.5 3.5h4v4M16.5 12.5v4h-4M7.5 16.5h-4v-4', width: 1.7 }],
  dimensions: [{ d: 'M3.5 5v10M16.5 5v10M4.5 10h11M7.5 7l-3 3 3 3M12.5 7l3 3-3 3', width: 1.5 }],
  plus: [{ d: 'M10 4v12M4 10h12', width: 1.8 }],
  minus: [{ d: 'M4 10h12', width: 1.8 }],
  gallery: [{ d: 'M3.5 3.5h5.5v5.5H3.5zM11 3.5h5.5v5.5H11zM3.5 11h5.5v5.5H3.5zM11 11h5.5v5.5H11z', width: 1.6 }],
  folder: [{ d: 'M3 5h5l1.8 2.2H17V16H3z', width: 1.6 }],
  more: [{ d: 'M4.5 10h.1M10 10h.1M15.5 10h.1', width: 2.8 }],
  undo: [{ d: 'M7 4.5L3.5 8 7 11.5M4 8h8a4.2 4.2 0 0 1 0 8.4H8', width: 1.7 }],
  redo: [{ d: 'M13 4.5L16.5 8 13 11.5M16 8H8a4.2 4.2 0 0 0 0 8.4h4', width: 1.7 }],
  help: [{ d: 'M7 7.4a3 3 0 1 1 4.6 2.5c-1 .7-1.6 1.2-1.6 2.3M10 15.3v.2', width: 1.8 }],
  open: [{ d: 'M11.5 3.5h5v5M16.5 3.5l-7.5 7.5M14.5 11.5v5h-11v-11h5', width: 1.7 }],
  share: [{ d: 'M10 12.5V3.2M6.4 6.6L10 3l3.6 3.6M6 9.5H4.5v7h11v-7H14', width: 1.6 }],
  outline: [{ d: 'M3.5 4.5h9M6.5 10h10M6.5 15.5h7', width: 1.7 }],
  chevron: [{ d: 'M5 7.5l5 5 5-5', width: 1.8 }],
  error: [
    { d: 'M2.8 10a7.2 7.2 0 1 0 14.4 0 7.2 7.2 0 1 0-14.4 0' },
    { d: 'M10 6v5M10 13.6v.4', width: 1.9, overlaid: true },
  ],
  warning: [
    { d: 'M10 2.8l7.6 13.6H2.4z', width: 1.2, filled: true },
    { d: 'M10 8v3.6M10 14v.3', width: 1.8, overlaid: true },
  ],
  info: [
    { d: 'M2.8 10a7.2 7.2 0 1 0 14.4 0 7.2 7.2 0 1 0-14.4 0' },
    { d: 'M10 9.4V14M10 6v.3', width: 1.9, overlaid: true },
  ],
} satisfies Readonly<Record<string, readonly IconShape[]>>;

export type IconName = keyof typeof ICONS;

export function iconNames(): readonly IconName[] {
  return Object.keys(ICONS) as IconName[];
}

export function icon(name: IconName): HTMLElement {
  const svg = makeSvg('svg', { viewBox: '0 0 20 20', width: 20, height: 20 });
  for (const { d, width, filled, overlaid } of ICONS[name] as readonly IconShape[]) {
    const colour = overlaid === true ? 'var(--playground-surface)' : 'currentColor';
    const line =
      width === undefined
        ? {}
        : { stroke: colour, 'stroke-width': width, 'stroke-linecap': 'round', 'stroke-linejoin': 'round' };
    svg.append(makeSvg('path', { d, fill: width === undefined || filled === true ? colour : 'none', ...line }));
  }
  return make('span', { className: `icon icon-${name}`, 'aria-hidden': 'true' }, svg);
}

/** Makes an element of SVG. Not from HTML: a page's policy may forbid setting HTML from a script. */
export function makeSvg(tag: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/** A message of the interpreter; backticks enclose program text. */
export function renderProse(text: string): (Node | string)[] {
  return text
    .split('`')
    .flatMap((part, i) => (i % 2 === 1 ? make('code', { lang: 'en' }, ...renderUnbroken(part)) : renderUnbroken(part)));
}

/** A sentence in which `Z-30` never wraps after its minus sign. */
export function renderUnbroken(text: string): (Node | string)[] {
  const parts: (Node | string)[] = [];
  for (const run of text.split(/([!-~]+)/)) {
    const last = parts.at(-1);
    if (/-\d/.test(run)) parts.push(make('span', { className: 'unbroken' }, run));
    else if (typeof last === 'string') parts[parts.length - 1] = last + run;
    else parts.push(run);
  }
  return parts;
}

/** Gives a button its name for screen readers and its tooltip. */
export function setAccessibleName(element: HTMLElement, text: string): void {
  element.setAttribute('aria-label', text);
  element.title = text;
}

/** Returns a function that schedules `work`, at most once per painted frame. */
export function perFrame(work: () => void): () => void {
  let scheduled = false;
  return () => {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(() => {
      scheduled = false;
      work();
    });
  };
}
