// The attributes of the element, and the properties of the same names.
//
// In: attributes and properties that the page sets. Out: the same as properties and attributes. Must not know: the
// effect of an attribute. `www/docs/element.md` describes each of them.

import { languageOf, type Language } from '../dom/language';
import { parseView, type View } from './layout';
import { parseLoading, type Loading } from './when-seen';

/** Node has no `HTMLElement`; there the class is only imported, never instantiated. */
const Base = (globalThis as { HTMLElement?: typeof HTMLElement }).HTMLElement ?? (class {} as typeof HTMLElement);

export class ElementAttributes extends Base {
  static readonly observedAttributes = [
    'src',
    'control',
    'setup',
    'block-skip',
    'program',
    'language',
    'theme',
    'view',
    'controls',
    'readonly',
    'step',
    'highlight',
    'lines',
    'fit',
    'turret',
    'annotate',
    'calculator',
    'exercise',
    'caption',
    'loading',
    'playground',
    'rules',
    'docs',
    'manual',
    'speed',
    'height',
    'rows-min',
    'rows-max',
  ];

  get language(): Language {
    return languageOf(this.getAttribute('language') ?? this.closest('[lang]')?.getAttribute('lang'));
  }

  set language(language: Language) {
    this.setAttribute('language', language);
  }

  get src(): string | null {
    return this.getAttribute('src');
  }

  set src(address: string | null) {
    setOrRemove(this, 'src', address);
  }

  get loading(): Loading {
    return parseLoading(this.getAttribute('loading'));
  }

  set loading(loading: Loading) {
    this.setAttribute('loading', loading);
  }

  get control(): string | null {
    return this.getAttribute('control');
  }

  set control(control: string | null) {
    setOrRemove(this, 'control', control);
  }

  get setup(): string | null {
    return this.getAttribute('setup');
  }

  /** JSON, or an object. */
  set setup(setup: string | object | null) {
    setOrRemove(this, 'setup', typeof setup === 'object' && setup !== null ? JSON.stringify(setup) : setup);
  }

  get blockSkip(): string | null {
    return this.getAttribute('block-skip');
  }

  set blockSkip(levels: string | null) {
    setOrRemove(this, 'block-skip', levels);
  }

  get program(): string | null {
    return this.getAttribute('program');
  }

  set program(number: string | null) {
    setOrRemove(this, 'program', number);
  }

  get theme(): string {
    return this.getAttribute('theme') ?? 'auto';
  }

  set theme(theme: string) {
    this.setAttribute('theme', theme);
  }

  get view(): View {
    return parseView(this.getAttribute('view'));
  }

  set view(view: View) {
    this.setAttribute('view', view);
  }

  /** The groups of panels that are shown, or `none`; null: all. */
  get controls(): string | null {
    return this.getAttribute('controls');
  }

  set controls(names: string | null) {
    setOrRemove(this, 'controls', names);
  }

  /** Whether the user cannot edit the program. */
  get readonly(): boolean {
    return this.hasAttribute('readonly');
  }

  set readonly(readonly: boolean) {
    this.toggleAttribute('readonly', readonly);
  }

  /** Initial position of the tool: after a number of motions, or before `line 8`. */
  get step(): string | null {
    return this.getAttribute('step');
  }

  set step(step: string | number | null) {
    setOrRemove(this, 'step', step);
  }

  /** The marked lines, for example `6-8, 12`; their strokes are marked as well. */
  get highlight(): string | null {
    return this.getAttribute('highlight');
  }

  set highlight(lines: string | number | null) {
    setOrRemove(this, 'highlight', lines);
  }

  /** The lines that are shown initially, for example `3-20`. */
  get lines(): string | null {
    return this.getAttribute('lines');
  }

  set lines(lines: string | number | null) {
    setOrRemove(this, 'lines', lines);
  }

  /** What the drawing is fitted to: the `part`, or the whole `path`. */
  get fit(): string | null {
    return this.getAttribute('fit');
  }

  set fit(fit: string | null) {
    setOrRemove(this, 'fit', fit);
  }

  /** The side of the turret: `front` or `rear`. */
  get turret(): string | null {
    return this.getAttribute('turret');
  }

  set turret(side: string | null) {
    setOrRemove(this, 'turret', side);
  }

  /** The calculator over the program, such as `r-of-g90`; its result becomes the program. */
  get calculator(): string | null {
    return this.getAttribute('calculator');
  }

  set calculator(name: string | null) {
    setOrRemove(this, 'calculator', name);
  }

  /** The address of an exercise, or the text of its file; its task is shown over the program. */
  get exercise(): string | null {
    return this.getAttribute('exercise');
  }

  set exercise(address: string | null) {
    setOrRemove(this, 'exercise', address);
  }

  /** The dimensions and letters in the picture: `none`, `word`, `cycle` or `part`. */
  get annotate(): string | null {
    return this.getAttribute('annotate');
  }

  set annotate(choice: string | null) {
    setOrRemove(this, 'annotate', choice);
  }

  /** The line under the element, which is also its accessible name. */
  get caption(): string | null {
    return this.getAttribute('caption');
  }

  set caption(text: string | null) {
    setOrRemove(this, 'caption', text);
  }

  /** The address that "Open in the playground" leads to; empty: no link. */
  get playground(): string | null {
    return this.getAttribute('playground');
  }

  set playground(address: string | null) {
    setOrRemove(this, 'playground', address);
  }

  /** The address of the folder of the rule pages; empty: no links to them. */
  get rules(): string | null {
    return this.getAttribute('rules');
  }

  set rules(address: string | null) {
    setOrRemove(this, 'rules', address);
  }

  /** The address of the folder of the documents; empty: no links to them. */
  get docs(): string | null {
    return this.getAttribute('docs');
  }

  set docs(address: string | null) {
    setOrRemove(this, 'docs', address);
  }

  /** The address of the folder of the pages of the manual; empty: no link to them. */
  get manual(): string | null {
    return this.getAttribute('manual');
  }

  set manual(address: string | null) {
    setOrRemove(this, 'manual', address);
  }

  /** The playback speed: a multiple of the machine's speed, `5`, or the duration of the whole program, `20 s`. */
  get speed(): string | null {
    return this.getAttribute('speed');
  }

  set speed(speed: string | number | null) {
    setOrRemove(this, 'speed', speed);
  }

  /** `auto`: the element is as high as its contents. */
  get height(): string | null {
    return this.getAttribute('height');
  }

  set height(height: string | null) {
    setOrRemove(this, 'height', height);
  }

  /** The least number of lines of the program that an element with `height="auto"` has room for. */
  get rowsMin(): string | null {
    return this.getAttribute('rows-min');
  }

  set rowsMin(rows: string | number | null) {
    setOrRemove(this, 'rows-min', rows);
  }

  /** The largest number of lines; a longer program scrolls. */
  get rowsMax(): string | null {
    return this.getAttribute('rows-max');
  }

  set rowsMax(rows: string | number | null) {
    setOrRemove(this, 'rows-max', rows);
  }
}

/** Frameworks set a property to `undefined` to remove the attribute. */
function setOrRemove(element: Element, attribute: string, value: string | number | null | undefined): void {
  if (value === null || value === undefined) element.removeAttribute(attribute);
  else element.setAttribute(attribute, String(value));
}
