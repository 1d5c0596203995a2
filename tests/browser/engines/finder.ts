// Runs in the page: finds elements by role, label, text or selector through shadow roots, and reports their state. It
// is injected into a page as one script when it is first needed. Names and roles come from dom-accessibility-api.
import { computeAccessibleName, getRole } from 'dom-accessibility-api';

export type Wanted =
  | { readonly text: string; readonly exact: boolean }
  | { readonly source: string; readonly flags: string };

/** One step of a locator; it starts from the elements that the previous step has found. */
export type Step =
  | { readonly by: 'css'; readonly css: string }
  | {
      readonly by: 'role';
      readonly role: string;
      readonly name?: Wanted;
      readonly level?: number;
      readonly hidden: boolean;
    }
  | { readonly by: 'text' | 'label' | 'placeholder'; readonly text: Wanted }
  | { readonly by: 'visible' }
  | { readonly by: 'has'; readonly steps: readonly Step[] }
  | { readonly by: 'hasText'; readonly text: Wanted }
  | { readonly by: 'nth'; readonly index: number }
  | { readonly by: 'or'; readonly steps: readonly Step[] };

/** Queries on elements. */
export type Question =
  | 'text'
  | 'value'
  | 'visible'
  | 'enabled'
  | 'checked'
  | 'focused'
  | 'inViewport'
  | 'box'
  | { readonly attribute: string }
  | { readonly property: string };

const folded = (text: string): string =>
  text
    .replace(/[\u200b\u00ad]/g, '')
    .replace(/\s+/g, ' ')
    .trim();

function fits(wanted: Wanted, text: string): boolean {
  if ('source' in wanted) return new RegExp(wanted.source, wanted.flags).test(folded(text));
  if (wanted.exact) return folded(text) === folded(wanted.text);
  return folded(text).toLowerCase().includes(folded(wanted.text).toLowerCase());
}

/** Light children come before the children of the shadow root, as in Playwright's locators. */
const childrenOf = (node: ParentNode): Element[] => [
  ...node.children,
  ...(node instanceof Element && node.shadowRoot ? node.shadowRoot.children : []),
];

function* below(node: ParentNode): Generator<Element> {
  for (const child of childrenOf(node)) {
    yield child;
    yield* below(child);
  }
}

const parentOf = (element: Element): Element | null => {
  const root = element.getRootNode();
  return element.assignedSlot ?? element.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
};

/** Text of an element, including its shadow root. */
function textOf(node: Node): string {
  if (node instanceof Text) return node.data;
  if (node instanceof HTMLInputElement && ['button', 'submit'].includes(node.type)) return node.value;
  if (!(node instanceof Element) && !(node instanceof ShadowRoot)) return '';
  if (node instanceof HTMLScriptElement || node instanceof HTMLStyleElement) return '';
  const shadow = node instanceof Element && node.shadowRoot ? textOf(node.shadowRoot) : '';
  return shadow + Array.from(node.childNodes, textOf).join('');
}

function visible(element: Element): boolean {
  const { width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && element.checkVisibility({ visibilityProperty: true });
}

/** `getRole` only supports column headers. */
function roleOf(element: Element): string | null {
  const header = element instanceof HTMLTableCellElement && element.tagName === 'TH' && !element.hasAttribute('role');
  return header && element.scope.startsWith('row') ? 'rowheader' : getRole(element);
}

/** Whether an element is exposed to assistive technology. */
function accessible(element: Element): boolean {
  // The system draws options, and announces them with their list.
  if (element instanceof HTMLOptionElement && element.parentElement instanceof HTMLSelectElement)
    return accessible(element.parentElement);
  for (let at: Element | null = element; at !== null; at = parentOf(at))
    if (at.getAttribute('aria-hidden') === 'true') return false;
  return element.checkVisibility({ visibilityProperty: true });
}

function labels(element: Element): string[] {
  const root = element.getRootNode() as Document | ShadowRoot;
  const by = (element.getAttribute('aria-labelledby') ?? '')
    .split(/\s+/)
    .filter((id) => id !== '')
    .map((id) => root.getElementById(id));
  if (by.length > 0) return by.map((label) => (label === null ? '' : textOf(label)));
  const own = element.getAttribute('aria-label');
  const labelled = Array.from((element as HTMLInputElement).labels ?? [], textOf);
  return own === null ? labelled : [own, ...labelled];
}

/** The innermost elements that contain a text. */
function byText(node: ParentNode, wanted: Wanted, found: Element[]): void {
  for (const child of childrenOf(node)) {
    if (child instanceof HTMLScriptElement || child instanceof HTMLStyleElement) continue;
    const before = found.length;
    byText(child, wanted, found);
    if (found.length === before && fits(wanted, textOf(child))) found.push(child);
  }
}

function matches(element: Element, step: Step): boolean {
  switch (step.by) {
    case 'css':
      return element.matches(step.css);
    case 'role':
      return (
        roleOf(element) === step.role &&
        (step.hidden || accessible(element)) &&
        (step.level === undefined || element.matches(`h${step.level}, [aria-level='${step.level}']`)) &&
        (step.name === undefined || fits(step.name, computeAccessibleName(element, { hidden: step.hidden })))
      );
    case 'label':
      return labels(element).some((label) => fits(step.text, label));
    case 'placeholder':
      return fits(step.text, element.getAttribute('placeholder') ?? '');
    default:
      throw new Error(`no step to look for: ${step.by}`);
  }
}

function follow(from: readonly ParentNode[], step: Step): Element[] {
  const elements = (): Element[] => from.filter((node) => node instanceof Element);
  switch (step.by) {
    case 'visible':
      return elements().filter(visible);
    case 'has':
      return elements().filter((element) => find(step.steps, [element]).length > 0);
    case 'hasText':
      return elements().filter((element) => fits(step.text, textOf(element)));
    case 'nth':
      return elements().slice(step.index, step.index === -1 ? undefined : step.index + 1);
    case 'or':
      return [...new Set([...elements(), ...find(step.steps)])].sort((a, b) =>
        a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1,
      );
    case 'text': {
      const found: Element[] = [];
      for (const node of from) byText(node, step.text, found);
      return [...new Set(found)];
    }
    default: {
      const found = new Set<Element>();
      for (const node of from) for (const element of below(node)) if (matches(element, step)) found.add(element);
      return [...found];
    }
  }
}

export function find(steps: readonly Step[], from: readonly ParentNode[] = [document]): Element[] {
  return steps.reduce<readonly ParentNode[]>(follow, from) as Element[];
}

/** The focused element, through shadow roots. */
export function active(): Element | null {
  let at = document.activeElement;
  while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
  return at;
}

async function inViewport(element: Element): Promise<boolean> {
  return new Promise((resolve) => {
    const observer = new IntersectionObserver((entries) => {
      observer.disconnect();
      resolve(entries.some((entry) => entry.intersectionRatio > 0));
    });
    observer.observe(element);
  });
}

function enabled(element: Element): boolean {
  return !element.matches(':disabled') && element.closest('[aria-disabled=true]') === null;
}

/** Answers the question for each of the elements. */
export async function ask(steps: readonly Step[], question: Question): Promise<unknown[]> {
  const answer = (element: Element): unknown => {
    switch (question) {
      case 'text':
        return textOf(element);
      case 'value':
        return (element as HTMLInputElement).value;
      case 'visible':
        return visible(element);
      case 'enabled':
        return enabled(element);
      case 'checked':
        return element instanceof HTMLInputElement ? element.checked : element.getAttribute('aria-checked') === 'true';
      case 'focused':
        return active() === element;
      case 'inViewport':
        return inViewport(element);
      case 'box': {
        const { x, y, width, height } = element.getBoundingClientRect();
        return visible(element) ? { x, y, width, height } : null;
      }
      default:
        return 'attribute' in question
          ? element.getAttribute(question.attribute)
          : Reflect.get(element, question.property);
    }
  };
  return Promise.all(find(steps).map(answer));
}

/** The only matching element, or the reason why there is none. */
function one(steps: readonly Step[]): Element | string {
  const found = find(steps);
  if (found.length === 1) return found[0]!;
  return found.length === 0
    ? 'there is none'
    : `there are ${found.length}: ${found.map((each) => each.outerHTML.slice(0, 80)).join(' | ')}`;
}

export type Ready = { readonly x: number; readonly y: number } | { readonly why: string };

const frame = (): Promise<void> => new Promise((resolve) => void requestAnimationFrame(() => resolve()));

/** The element that a click at a position would hit. */
function hit(x: number, y: number): Element | null {
  let [found, root]: [Element | null, Document | ShadowRoot] = [null, document];
  for (;;) {
    const inner: Element | null = root.elementFromPoint(x, y);
    if (inner === null || inner === found) return found;
    found = inner;
    if (inner.shadowRoot === null) return found;
    root = inner.shadowRoot;
  }
}

/** Position of the pointer for an action on the only element, once it is visible, stable and not covered. */
export async function ready(steps: readonly Step[], to: 'click' | 'hover'): Promise<Ready> {
  const element = one(steps);
  if (typeof element === 'string') return { why: element };
  if (!visible(element)) return { why: 'it cannot be seen' };
  if (to === 'click' && !enabled(element)) return { why: 'it is disabled' };
  let covered = '';
  for (const block of ['nearest', 'center'] as const) {
    element.scrollIntoView({ block, inline: 'nearest', behavior: 'instant' });
    const before = element.getBoundingClientRect();
    await frame();
    const box = element.getBoundingClientRect();
    if (box.x !== before.x || box.y !== before.y || box.width !== before.width) return { why: 'it moves' };
    const [x, y] = [Math.floor(box.x + box.width / 2), Math.floor(box.y + box.height / 2)];
    const top = hit(x, y);
    for (let at = top; at !== null; at = parentOf(at)) {
      if (at === element || (at instanceof HTMLLabelElement && at.control === element)) return { x, y };
    }
    covered = top?.outerHTML.slice(0, 120) ?? 'nothing';
  }
  return { why: `it is covered by ${covered}` };
}

/** Events of a click, in their order. */
const CLICK_EVENTS = ['pointerdown', 'mousedown', 'pointerup', 'mouseup', 'click'] as const;

let watched: { arrived: boolean; missed: boolean; readonly stop: () => void } | undefined;

/**
 * Watches the next click, as Playwright does: if the layout has changed and the press meets another element than the
 * only one, it has no effect.
 */
export function watchClick(steps: readonly Step[]): void {
  watched?.stop();
  watched = undefined;
  const element = one(steps);
  // A list of the system sends no click.
  if (element instanceof HTMLSelectElement) return;
  const isHit = (event: Event): boolean =>
    event.composedPath().some((at) => at === element || (at instanceof HTMLLabelElement && at.control === element));
  let isMissed = false;
  const watch = (event: Event): void => {
    if (event.type === 'pointerdown' || event.type === 'mousedown') {
      isMissed = !isHit(event);
      // A button that acts on the press and disappears gets no `click`.
      own.arrived = !isMissed;
      own.missed = isMissed;
    }
    if (!isMissed) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  };
  const stop = (): void => {
    for (const type of CLICK_EVENTS) removeEventListener(type, watch, { capture: true });
  };
  const own = { arrived: false, missed: false, stop };
  for (const type of CLICK_EVENTS) addEventListener(type, watch, { capture: true });
  watched = own;
}

/**
 * Whether the watched click has arrived at its element. A press may take seconds to arrive on a busy machine, and a second
 * one would undo it: close a menu, for example.
 */
export async function clickArrived(): Promise<boolean> {
  const own = watched;
  if (own === undefined) return true;
  for (let tries = 0; tries < 300 && !own.arrived && !own.missed; tries++)
    await new Promise((done) => setTimeout(done, 16));
  own.stop();
  watched = undefined;
  return own.arrived;
}

/**
 * Performs an action without the pointer on the only element. Returns the reason if it is impossible, otherwise an
 * empty string.
 */
export function act(steps: readonly Step[], what: 'focus' | 'fill' | 'select' | 'scroll', text = ''): string {
  const element = one(steps);
  if (typeof element === 'string') return element;
  if (what !== 'scroll' && !visible(element)) return 'it cannot be seen';
  if ((what === 'fill' || what === 'select') && !enabled(element)) return 'it is disabled';
  switch (what) {
    case 'scroll':
      element.scrollIntoView({ block: 'nearest', behavior: 'instant' });
      return '';
    case 'focus':
      (element as HTMLElement).focus();
      return '';
    case 'fill': {
      const input = element as HTMLInputElement;
      input.focus();
      input.select();
      if (text === '') document.execCommand('delete');
      else document.execCommand('insertText', false, text);
      return input.value === text ? '' : `it holds "${input.value}"`;
    }
    case 'select': {
      const select = element as HTMLSelectElement;
      const option = Array.from(select.options).find((each) => each.value === text || folded(each.label) === text);
      if (option === undefined) return `it has no option "${text}"`;
      select.focus();
      select.value = option.value;
      select.dispatchEvent(new Event('input', { bubbles: true, composed: true }));
      select.dispatchEvent(new Event('change', { bubbles: true }));
      return '';
    }
  }
}

/** Inserts a text at the cursor in one step. */
export function insert(text: string): void {
  document.execCommand('insertText', false, text);
}
