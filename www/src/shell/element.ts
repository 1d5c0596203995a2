// <gcode-playground>: a lathe program, its drawing, its messages, and the playback of the tool.
//
//   <script type="module" src="element.js"></script>
//   <gcode-playground control="fanuc" setup='{"stock": {"diameter": 60, "length": 80}}'>
//     G00 X62 Z2
//     G90 X50 Z-30 F0.2
//   </gcode-playground>
//
// The program is loaded from the address in `src`, or is a child of the element: a script, a `pre`, or text
// (source.ts).
//
// Attributes; each of them is a property too:
//   src       the address of the program
//   control   fanuc | gsk | forum      overrides `dialect.control` of the setup
//   setup     JSON (as a property also an object): start point, tools, stock, dialect switches
//   language  en | zh | ru             language of the element and of the messages
//   theme     auto | light | dark      auto: the theme of the page
//   block-skip  "1,2"                  the active levels of block skip; overrides `blockSkip` of the setup
//   program   2                        the O number of the program to run; overrides `program` of the setup
//   view      all | picture | playback | code   picture: the drawing only; playback: with the playback bar; code: the
//                                      program only. What is not shown is not loaded.
//   controls  "playback status"        the groups of panels that are shown (panels/panel.ts), or none
//   readonly                           the user cannot edit the program
//   step      12 | line 8              initial position of the tool
//   highlight "6-8, 12"                lines that are marked, together with their strokes
//   lines     "3-20"                   lines that are shown initially; the others are folded
//   fit       part | path              what the drawing is fitted to
//   turret    front | rear
//   caption   a line under the element, which is also its accessible name
//   playground https://…               target of "Open in the playground"; empty: no link
//   rules, docs https://…              the folders of the rule pages and of the documents; empty: no links to them
//   loading   lazy | eager | click     start near the viewport, immediately, or on click
//   split     40                       width of the program beside the drawing, percent; follows the divider
//   hints     "edit play pick"         the introductory hints that are still to be shown; missing: none
// The element updates `hints`, `block-skip` and `program` when the user dismisses a hint or uses a switch. A change of
// `view`, `controls` or `readonly` renders the element again with the same program; the undo history is lost.
//
// Properties: value (the program), length (of the program, each line end counted as one), opened (the file of the
// program, and the text with its own line ends), origin (any text by which the page identifies the program),
// cursorLine, wholeSetup. Setting a property or an attribute fires no event; setting the current text has no effect. If
// the user replaces most of the text, it counts as another program: the attributes of the program are removed and
// `origin` becomes null; undo restores both. A text set by the page keeps the attributes.
//
// Methods: play(), pause(), openFile(file), saveFile(), exported(format) (a promise of the bytes of a file of the menu
// "Export"), focus(), goToLine(line), keepPart() (to draw later programs over the part of this one), endComparison(),
// differenceFrom({text, names}) (a promise of the blocks and motions in which another version differs), currentStep()
// and pictureFile(format) (both return promises), and for tests:
//   settled: Promise<number>   a property: resolved with the number of the run when everything is shown for the
//                              current program, setup, language, size and colours, including the machined part.
//                              Numbers increase with every change of text or setup. Nothing settles in a hidden tab.
//   locate(x, z): Promise<{clientX, clientY}>   the position of a point (X a diameter, mm) in the window
//   locateOnFace(x, c): the same for the end face
//   locateOnSide(z, c): the same for the side, C in degrees; Y in mm if its ruler shows Y
// Events (bubbling; only for actions of the user, and `report` for each finished run):
//   gcode-change   detail {value}
//   gcode-select   detail {stroke}: `from` and `to` are UTF-16 offsets into `opened.text`, which has its own line ends
//   gcode-report   detail {summary, diagnostics}: offsets likewise, also in edits
//   gcode-settled  detail {run}: each time that `settled` is resolved
//   gcode-switch   detail {blockSkip, program}
//   gcode-setup    detail {setup}: the form has changed the attribute
//   gcode-hint     detail {left}: the remaining hints
//   gcode-split    detail {split}: the user has dragged the divider
//   gcode-context  detail {control, setup, blockSkip, program, origin}: another program has replaced the current one,
//                  or undo has restored one; attributes and `origin` have the values of the detail
// Slots: `intro` above the program; `fallback`, shown until there is a picture.
// CSS custom properties: --playground-height, --playground-type-size, --playground-font, --playground-code-font,
// --playground-code-size and the colours of colours.css.
// Parts: frame intro bar file switches editor problems drawing canvas old-picture what-if at-cursor legend tooltip
// setup views assumptions playback play readout doing status notice hint totals units open-link motions written-out
// rewrite codes solid export-menu paste help read-as profiles caption fallback.
//
// The shadow DOM belongs to the shell: see shell.ts, and panels/panel.ts for how to add to it.

import { make } from '../dom/dom';
import { languageOf, type Language } from '../dom/language';
import { programText, type ProgramFile } from '../editor/program-text';
import { ENCODINGS } from '../files/encodings';
import type { Differed, ExportFormat, OtherVersion } from '../protocol/protocol';
import type { ClientPlace, Services } from '../panels/panel';
import { controlsOf, viewOf, type View } from './layout';
import { whenParsed } from './parsed';
import { Settling } from './settling';
import { mergedSetup } from './start';
import { PlaygroundShell } from './shell';
import { Source, textInside } from './source';
import { adopt } from './style-sheets';
import { upgradeIn, upgradeThePage } from './upgrade';
import { loadingOf, startButton, whenNear, type Loading } from './when-seen';
import colours from '../colours.css?inline';
import styles from './styles.css?inline';

export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

/** A change of these attributes renders the element again. */
const MAKES_ANEW: readonly string[] = ['view', 'controls', 'readonly'];
/** The author's attributes for lines and picture. */
const AUTHORS: readonly string[] = ['highlight', 'lines', 'fit', 'turret', 'caption', 'playground'];

/** These need no update: they are read when the pointer or the focus reaches a link. */
const PAGES: readonly string[] = ['rules', 'docs'];

/** Node has no `HTMLElement`; there the class is only imported, never instantiated. */
const Base = (globalThis as { HTMLElement?: typeof HTMLElement }).HTMLElement ?? (class {} as typeof HTMLElement);

export class GcodePlayground extends Base {
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
    'caption',
    'loading',
    'playground',
    'rules',
    'docs',
  ];

  /** Set by the page to identify the program; null after another program has replaced it. */
  #origin: string | null = null;
  /** Created when the element is first inserted into a document. */
  #made: PlaygroundShell | undefined;
  /** The values of `view`, `controls` and `readonly` for which the shell was created. */
  #madeFor = '';
  /** A program that was set before the shell was created. */
  #early: OpenedProgram | undefined;
  /** The source of the program, until one is set. */
  #source: Source | undefined;
  /** Stops waiting for the element to come near the viewport. */
  #stopWaiting: (() => void) | undefined;
  readonly #settling = new Settling((run) => this.#fire('gcode-settled', { run }));

  constructor() {
    super();
    this.addEventListener('keydown', (event) => this.#made?.pressed(event), { capture: true });
    for (const use of ['focusin', 'pointerdown']) this.addEventListener(use, () => used(this));
    for (const type of ['keydown', 'keypress', 'keyup'] as const)
      this.addEventListener(type, (event) => this.#keep(event));
  }

  connectedCallback(): void {
    inDocument.add(this);
    if (inDocument.size === 1) document.addEventListener('keydown', playKeys);
    this.#takeEarlyProperties();
    if (this.#made !== undefined) return this.#begin();
    this.#root();
    if (this.#early !== undefined) this.#wait();
    else whenParsed(this, () => this.#wait());
  }

  disconnectedCallback(): void {
    inDocument.delete(this);
    if (inDocument.size === 0) document.removeEventListener('keydown', playKeys);
    this.#stopWaiting?.();
    this.#made?.disconnect();
  }

  /**
   * Keys typed inside must not trigger commands of the page: manuals turn pages with arrow keys and open a search with
   * letters.
   */
  #keep(event: KeyboardEvent): void {
    const [origin] = event.composedPath();
    if (isTyped(event) && origin instanceof Node && origin.getRootNode() === this.shadowRoot) event.stopPropagation();
  }

  /** Handles a key that was pressed outside of the element. */
  pressed(event: KeyboardEvent): void {
    this.#made?.pressed(event);
  }

  attributeChangedCallback(attribute: string, before: string | null, now: string | null): void {
    if (before === now || PAGES.includes(attribute)) return;
    if (attribute === 'language') this.#made?.languageChanged();
    else if (attribute === 'theme') this.#made?.coloursChanged();
    else if (MAKES_ANEW.includes(attribute)) this.#lookChanged();
    else if (attribute === 'step') this.#made?.stepChanged();
    else if (AUTHORS.includes(attribute)) this.#made?.authorChanged();
    else if (attribute === 'src') this.#source?.addressChanged();
    else if (attribute === 'loading') this.#wait();
    else this.#made?.setupChanged();
  }

  /** Resolved with the number of the run when everything is shown. Reading it starts a lazy element. */
  get settled(): Promise<number> {
    if (this.#made === undefined) whenParsed(this, () => this.isConnected && this.#begin());
    return this.#settling.promise;
  }

  get value(): string {
    return this.#made?.editor.text ?? this.#early?.text ?? textInside(this);
  }

  /** Setting the current text has no effect: a page that writes back each change keeps cursor, history and file. */
  set value(text: string) {
    const { text: own } = this.opened;
    if (text !== own && text !== this.value) this.opened = { text, file: undefined };
  }

  /** Length of the program in UTF-16 units, each line end counted as one. */
  get length(): number {
    return this.#made?.editor.length ?? this.value.length;
  }

  /** The file that the program was opened from. */
  get file(): ProgramFile | undefined {
    return this.#made?.editor.file ?? this.#early?.file;
  }

  /** The program with the line ends of its file, and the file. */
  get opened(): OpenedProgram {
    const editor = this.#made?.editor;
    if (editor === undefined) return this.#early ?? { text: textInside(this), file: undefined };
    return { text: editor.textWithLineEnds, file: editor.file };
  }

  set opened(opened: OpenedProgram) {
    const { text, file } = opened;
    if (this.#made === undefined) {
      this.#early = opened;
      return;
    }
    this.#made.put(programText(text), file !== undefined && ENCODINGS.includes(file.encoding) ? file : undefined);
  }

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
    this.#setOrRemove('src', address);
  }

  get loading(): Loading {
    return loadingOf(this.getAttribute('loading'));
  }

  set loading(loading: Loading) {
    this.setAttribute('loading', loading);
  }

  get control(): string | null {
    return this.getAttribute('control');
  }

  set control(control: string | null) {
    this.#setOrRemove('control', control);
  }

  get setup(): string | null {
    return this.getAttribute('setup');
  }

  /** JSON, or an object. */
  set setup(setup: string | object | null) {
    this.#setOrRemove('setup', typeof setup === 'object' && setup !== null ? JSON.stringify(setup) : setup);
  }

  get blockSkip(): string | null {
    return this.getAttribute('block-skip');
  }

  set blockSkip(levels: string | null) {
    this.#setOrRemove('block-skip', levels);
  }

  get program(): string | null {
    return this.getAttribute('program');
  }

  set program(number: string | null) {
    this.#setOrRemove('program', number);
  }

  get origin(): string | null {
    return this.#origin;
  }

  set origin(origin: string | null) {
    this.#origin = origin;
  }

  get theme(): string {
    return this.getAttribute('theme') ?? 'auto';
  }

  set theme(theme: string) {
    this.setAttribute('theme', theme);
  }

  get view(): View {
    return viewOf(this.getAttribute('view'));
  }

  set view(view: View) {
    this.setAttribute('view', view);
  }

  /** The groups of panels that are shown, or `none`; null: all. */
  get controls(): string | null {
    return this.getAttribute('controls');
  }

  set controls(names: string | null) {
    this.#setOrRemove('controls', names);
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
    this.#setOrRemove('step', step);
  }

  /** The marked lines, for example `6-8, 12`; their strokes are marked as well. */
  get highlight(): string | null {
    return this.getAttribute('highlight');
  }

  set highlight(lines: string | number | null) {
    this.#setOrRemove('highlight', lines);
  }

  /** The lines that are shown initially, for example `3-20`. */
  get lines(): string | null {
    return this.getAttribute('lines');
  }

  set lines(lines: string | number | null) {
    this.#setOrRemove('lines', lines);
  }

  /** What the drawing is fitted to: the `part`, or the whole `path`. */
  get fit(): string | null {
    return this.getAttribute('fit');
  }

  set fit(fit: string | null) {
    this.#setOrRemove('fit', fit);
  }

  /** The side of the turret: `front` or `rear`. */
  get turret(): string | null {
    return this.getAttribute('turret');
  }

  set turret(side: string | null) {
    this.#setOrRemove('turret', side);
  }

  /** The line under the element, which is also its accessible name. */
  get caption(): string | null {
    return this.getAttribute('caption');
  }

  set caption(text: string | null) {
    this.#setOrRemove('caption', text);
  }

  /** The address that "Open in the playground" leads to; empty: no link. */
  get playground(): string | null {
    return this.getAttribute('playground');
  }

  set playground(address: string | null) {
    this.#setOrRemove('playground', address);
  }

  /** The address of the folder of the rule pages; empty: no links to them. */
  get rules(): string | null {
    return this.getAttribute('rules');
  }

  set rules(address: string | null) {
    this.#setOrRemove('rules', address);
  }

  /** The address of the folder of the documents; empty: no links to them. */
  get docs(): string | null {
    return this.getAttribute('docs');
  }

  set docs(address: string | null) {
    this.#setOrRemove('docs', address);
  }

  play(): void {
    this.#with('play', (play) => play());
  }

  pause(): void {
    this.#with('pause', (pause) => pause());
  }

  override focus(): void {
    this.#made?.editor.focus();
  }

  /** The position of the point X (a diameter), Z in mm, in CSS pixels of the window. */
  async locate(x: number, z: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('section', x, z);
  }

  /** The same for the end face: X a diameter, C in mm. */
  async locateOnFace(x: number, c: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('face', x, c);
  }

  /** The same for the side: Z in mm, C in degrees, or Y in mm if its ruler shows Y. */
  async locateOnSide(z: number, c: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('side', z, c);
  }

  /** Opens a file as the program; undo restores the replaced one. */
  async openFile(file: File): Promise<void> {
    const shell = this.#shell;
    await shell.complete;
    return shell.service('openFile')(file);
  }

  /** Saves the program as a file, in the encoding and with the line ends of the opened file. */
  saveFile(): void {
    this.#with('saveFile', (save) => save());
  }

  /** The content of a file of the menu "Export"; undefined if there is no part or no interpreter. */
  async exported(format: ExportFormat): Promise<Uint8Array | undefined> {
    const shell = this.#shell;
    await shell.complete;
    const exported = await shell.service('exported')(format);
    return exported?.kind === 'file' ? exported.content : undefined;
  }

  /** Stores the part, so that later programs are drawn over it. */
  keepPart(): void {
    this.#with('keepPart', (keep) => keep());
  }

  /**
   * The differences from another version, which counts as the first; undefined if the program has changed meanwhile.
   */
  async differenceFrom(other: OtherVersion): Promise<Differed | undefined> {
    const shell = this.#shell;
    await shell.complete;
    return shell.ask('difference', other);
  }

  /** Ends the comparison that `keepPart` started; one that the user started continues. */
  endComparison(): void {
    this.#with('endComparison', (end) => end());
  }

  /** Creates the shell if the element is still waiting for the viewport. */
  get #shell(): PlaygroundShell {
    if (this.isConnected && this.#made === undefined) this.#begin();
    if (this.#made === undefined) throw new Error('the playground is not in a document');
    return this.#made;
  }

  /** Starts according to `loading`. */
  #wait(): void {
    this.#stopWaiting?.();
    if (!this.isConnected || this.#made !== undefined) return;
    const root = this.#root();
    root.replaceChildren();
    if (this.loading === 'eager') this.#begin();
    else if (this.loading === 'lazy') this.#stopWaiting = whenNear(this, () => this.#begin());
    else
      root.append(
        make('slot', { name: 'fallback' }),
        make(
          'div',
          { className: 'own' },
          startButton(this.language, () => this.#begin()),
        ),
      );
  }

  #begin(): void {
    this.#stopWaiting?.();
    if (this.#made === undefined) {
      this.#root().replaceChildren();
      this.#made = this.#make();
    }
    this.#made.connect();
  }

  /** Attaches the styles first, so that the element has its size before it has content. */
  #root(): ShadowRoot {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    adopt(root, [colours, styles]);
    return root;
  }

  /** The current position of the tool in the format of `step`; null if the whole path is shown. */
  async currentStep(): Promise<string | null> {
    const place = await this.#shell.ask('readout', undefined);
    if (place === undefined || place.share >= 1) return null;
    const { motion, x, z, atX, atZ } = place.stroke;
    // Within a motion, the last position with a number is the end of the previous motion.
    const isAtItsEnd = Math.abs(x - atX) < 1e-6 && Math.abs(z - atZ) < 1e-6;
    // A dwell ends where it begins. The end of the last motion does not count: it would show the whole path.
    const isLast = (await this.#shell.ask('strokes', { first: motion + 1, end: motion + 2 }))?.length === 0;
    const done = isAtItsEnd && !isLast ? motion + 1 : motion;
    return done === 0 ? null : String(done);
  }

  /** The line of the cursor, from 1. */
  get cursorLine(): number {
    const { editor } = this.#shell;
    return editor.lineOf(editor.cursor) + 1;
  }

  /** Selects a line, from 1, and moves the cursor there; no effect if the line does not exist. */
  goToLine(line: number): void {
    const lines = this.value.split('\n');
    const text = lines[line - 1];
    if (text === undefined) return;
    const from = lines.slice(0, line - 1).reduce((length, before) => length + before.length + 1, 0);
    this.#shell.goTo({ from, to: from + text.length });
  }

  /**
   * The complete setup of the run as JSON, merged from `setup` and the other attributes; undefined if it is invalid.
   */
  get wholeSetup(): string | undefined {
    const merged = mergedSetup(this.setup, this);
    return merged.kind === 'setup' && isJson(merged.json) ? merged.json : undefined;
  }

  /** The drawing as SVG, or the shown picture as PNG; undefined if there is none yet. */
  async pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined> {
    const shell = this.#shell;
    shell.flush();
    const made = await shell.ask('export', { format });
    return made?.kind === 'file'
      ? new Blob([made.content], { type: format === 'svg' ? 'image/svg+xml' : 'image/png' })
      : undefined;
  }

  /** Calls a service of the view: immediately, or when its panel is loaded. */
  #with<S extends 'play' | 'pause' | 'saveFile' | 'keepPart' | 'endComparison'>(
    name: S,
    act: (service: Services[S]) => void,
  ): void {
    const shell = this.#shell;
    if (!shell.offers(name)) throw new Error(`view="${shell.view}" does not offer ${name}`);
    void shell.complete.then(
      () => act(shell.service(name)),
      () => undefined,
    );
  }

  /** `view`, `controls` or `readonly` has changed: creates another shell with the same program. */
  #lookChanged(): void {
    const made = this.#made;
    if (made === undefined || this.#look === this.#madeFor) return;
    this.#early = this.opened;
    made.disconnect();
    this.#made = undefined;
    this.shadowRoot?.replaceChildren();
    if (this.isConnected) this.#begin();
  }

  get #look(): string {
    return JSON.stringify([this.view, controlsOf(this.view, this.controls), this.readonly]);
  }

  /** Properties that were set before the class was defined hide its accessors: set them again. */
  #takeEarlyProperties(): void {
    for (const name of Object.getOwnPropertyNames(this)) {
      if (Object.getOwnPropertyDescriptor(GcodePlayground.prototype, name)?.set === undefined) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }

  #make(): PlaygroundShell {
    const root = this.#root();
    this.#madeFor = this.#look;
    const shell = new PlaygroundShell(root, this, {
      fire: (type, detail) => this.#fire(type, detail),
      changed: () => this.#changed(),
      unsettled: () => this.#settling.unsettle(),
      settled: (run) => this.#settling.settle(run),
    });
    if (this.#early === undefined) {
      this.#source = this.#sourceFor(() => this.#made ?? shell);
      shell.start(this.#source.begin(), undefined);
    } else shell.start(this.#early.text, this.#early.file);
    return shell;
  }

  #sourceFor(shell: () => PlaygroundShell): Source {
    return new Source(this, {
      current: () => shell().editor.text,
      program: (text, file) => shell().programCame(text, file),
      setup: (json) => this.setAttribute('setup', json),
      coming: (address, how) => shell().programComing(address, how),
      failed: (address, reason, again) => shell().programFailed(address, reason, again),
    });
  }

  #changed(): void {
    const element = this;
    // A getter, since this runs after each key and a program can be 20 MB long.
    this.#fire('gcode-change', {
      get value() {
        return element.value;
      },
    });
  }

  #fire<Detail>(type: string, detail: Detail): void {
    this.dispatchEvent(new CustomEvent<Detail>(type, { detail, bubbles: true, composed: true }));
  }

  /** Frameworks set a property to `undefined` to remove the attribute. */
  #setOrRemove(attribute: string, value: string | number | null | undefined): void {
    if (value === null || value === undefined) this.removeAttribute(attribute);
    else this.setAttribute(attribute, String(value));
  }
}

/** The elements of the page, the last used one last. */
const inDocument = new Set<GcodePlayground>();

function used(element: GcodePlayground): void {
  if (!inDocument.delete(element)) return;
  inDocument.add(element);
}

function isJson(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

/** Keys without a modifier, which pages use as commands, and which type or move in a text, list or drawing. */
function isTyped({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return !ctrlKey && !metaKey && !altKey && key !== 'Escape' && key !== 'Tab' && !/^F\d+$/.test(key);
}

/** The keys of the playback also work if the focus is outside, but not in a text field. */
function playKeys(event: KeyboardEvent): void {
  const isOne = event.key === 'F9' || (event.key === 'Enter' && (event.ctrlKey || event.metaKey));
  if (!isOne || event.defaultPrevented) return;
  const path = event.composedPath();
  const isText = path.some(
    (part) => part instanceof HTMLElement && (part.isContentEditable || part.matches('input, textarea')),
  );
  if (isText || path.some((part) => part instanceof GcodePlayground)) return;
  [...inDocument].at(-1)?.pressed(event);
}

/**
 * Creates elements around the marked programs in a part of a page that was added after loading:
 * `<script type="text/x-gcode" data-gcode-playground>` and `<pre data-gcode-playground>`.
 */
export function upgrade(root: ParentNode = document): void {
  upgradeIn(root, GcodePlayground.observedAttributes);
}

if (typeof customElements !== 'undefined') {
  if (customElements.get('gcode-playground') === undefined) customElements.define('gcode-playground', GcodePlayground);
  upgradeThePage(GcodePlayground.observedAttributes);
}
