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
//   calculator r-of-g90                a calculator over the program; its result becomes the program
//   caption   a line under the element, which is also its accessible name
//   playground https://…               target of "Open in the playground"; empty: no link
//   rules, docs, manual https://…       the folders of the rule pages, the documents, the pages of the manual; empty: no links to them
//   loading   lazy | eager | click     start near the viewport, immediately, or on click
//   split     40                       width of the program beside the drawing, percent; follows the divider
//   hints     "play pick"              the introductory hints that are still to be shown; missing: none
//   labels                             names chuck, tool and start point on the picture, where there is room
// The element updates `hints`, `block-skip` and `program` when the user dismisses a hint or uses a switch. A change of
// `view`, `controls`, `readonly` or `calculator` renders the element again with the same program; the undo history is lost.
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
// Slots: `intro` under the program; `fallback`, shown until there is a picture; `title` of the program in the row at the
// top; `about` beside how the program was read; items of the menus: `program-menu`, `share-menu`, `help-menu`, `more-menu`.
// CSS custom properties: --playground-height, --playground-type-size, --playground-font, --playground-code-font,
// --playground-code-size and the tokens of tokens.css.
// Parts: frame head menu program-menu share-menu help-menu more-menu intro bar file switches editor problems drawing canvas old-picture what-if at-cursor legend tooltip
// setup views assumptions playback play readout doing pace time status notice hint totals units open-link motions written-out
// rewrite codes solid paste help read-as reading profiles caption fallback.
//
// The shadow DOM belongs to the shell: see shell.ts, and panels/panel.ts for how to add to it.

import { make } from '../dom/dom';
import { languageOf, type Language } from '../dom/language';
import { programText, type ProgramFile } from '../editor/program-text';
import { ENCODINGS } from '../files/encoding-list';
import type { DifferenceResult, ExportFormat, OtherVersion } from '../protocol/protocol';
import type { ClientPoint, Services, UserCommand } from '../panels/panel';
import { shownControls, parseView, type View } from './layout';
import { whenParsed } from './parsed';
import { Settling } from './settling';
import { mergeSetup } from './merged-setup';
import { PlaygroundShell } from './shell';
import { Source, textInside } from './source';
import { adoptStyles } from './style-sheets';
import { upgradeIn, upgradeDocument } from './upgrade';
import { parseLoading, startButton, whenNear, type Loading } from './when-seen';
import controls from '../dom/controls.css?inline';
import tokens from '../tokens.css?inline';
import styles from './styles.css?inline';

export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

/** A change of these attributes renders the element again. */
const RERENDERING_ATTRIBUTES: readonly string[] = ['view', 'controls', 'readonly', 'calculator'];
/** The author's attributes for lines and picture. */
const AUTHOR_ATTRIBUTES: readonly string[] = [
  'highlight',
  'lines',
  'fit',
  'turret',
  'annotate',
  'caption',
  'playground',
];

/** These need no update: they are read when the pointer or the focus reaches a link. */
const LINK_ATTRIBUTES: readonly string[] = ['rules', 'docs', 'manual'];

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
    'annotate',
    'calculator',
    'caption',
    'loading',
    'playground',
    'rules',
    'docs',
    'manual',
  ];

  /** Set by the page to identify the program; null after another program has replaced it. */
  #origin: string | null = null;
  /** Created when the element is first inserted into a document. */
  #createdShell: PlaygroundShell | undefined;
  /** The values of `view`, `controls` and `readonly` for which the shell was created. */
  #renderedView = '';
  /** A program that was set before the shell was created. */
  #initialProgram: OpenedProgram | undefined;
  /** The source of the program, until one is set. */
  #source: Source | undefined;
  /** Stops waiting for the element to come near the viewport. */
  #stopWaiting: (() => void) | undefined;
  readonly #settling = new Settling((run) => this.#fire('gcode-settled', { run }));

  constructor() {
    super();
    this.addEventListener('keydown', (event) => this.#createdShell?.handleKey(event), { capture: true });
    for (const use of ['focusin', 'pointerdown']) this.addEventListener(use, () => markAsLastUsed(this));
    for (const type of ['keydown', 'keypress', 'keyup'] as const)
      this.addEventListener(type, (event) => this.#keepKeyInside(event));
  }

  connectedCallback(): void {
    connectedElements.add(this);
    if (connectedElements.size === 1) document.addEventListener('keydown', onDocumentKeydown);
    this.#upgradeProperties();
    if (this.#createdShell !== undefined) return this.#start();
    this.#prepareRoot();
    if (this.#initialProgram !== undefined) this.#scheduleStart();
    else whenParsed(this, () => this.#scheduleStart());
  }

  disconnectedCallback(): void {
    connectedElements.delete(this);
    if (connectedElements.size === 0) document.removeEventListener('keydown', onDocumentKeydown);
    this.#stopWaiting?.();
    this.#createdShell?.disconnect();
  }

  /**
   * Keys typed inside must not trigger commands of the page: manuals turn pages with arrow keys and open a search with
   * letters.
   */
  #keepKeyInside(event: KeyboardEvent): void {
    const [origin] = event.composedPath();
    if (isPlainKey(event) && origin instanceof Node && origin.getRootNode() === this.shadowRoot)
      event.stopPropagation();
  }

  /** Handles a key that was pressed outside of the element. */
  handleKey(event: KeyboardEvent): void {
    this.#createdShell?.handleKey(event);
  }

  attributeChangedCallback(attribute: string, oldValue: string | null, newValue: string | null): void {
    if (oldValue === newValue || LINK_ATTRIBUTES.includes(attribute)) return;
    if (attribute === 'language') this.#createdShell?.languageChanged();
    else if (attribute === 'theme') this.#createdShell?.coloursChanged();
    else if (RERENDERING_ATTRIBUTES.includes(attribute)) this.#rerender();
    else if (attribute === 'step') this.#createdShell?.stepChanged();
    else if (AUTHOR_ATTRIBUTES.includes(attribute)) this.#createdShell?.authorChanged();
    else if (attribute === 'src') this.#source?.addressChanged();
    else if (attribute === 'loading') this.#scheduleStart();
    else this.#createdShell?.setupChanged();
  }

  /** Resolved with the number of the run when everything is shown. Reading it starts a lazy element. */
  get settled(): Promise<number> {
    if (this.#createdShell === undefined) whenParsed(this, () => this.isConnected && this.#start());
    return this.#settling.promise;
  }

  get value(): string {
    return this.#createdShell?.editor.text ?? this.#initialProgram?.text ?? textInside(this);
  }

  /** Setting the current text has no effect: a page that writes back each change keeps cursor, history and file. */
  set value(text: string) {
    const { text: currentText } = this.opened;
    if (text !== currentText && text !== this.value) this.opened = { text, file: undefined };
  }

  /** Length of the program in UTF-16 units, each line end counted as one. */
  get length(): number {
    return this.#createdShell?.editor.length ?? this.value.length;
  }

  /** The file that the program was opened from. */
  get file(): ProgramFile | undefined {
    return this.#createdShell?.editor.file ?? this.#initialProgram?.file;
  }

  /** The program with the line ends of its file, and the file. */
  get opened(): OpenedProgram {
    const editor = this.#createdShell?.editor;
    if (editor === undefined) return this.#initialProgram ?? { text: textInside(this), file: undefined };
    return { text: editor.textWithLineEnds, file: editor.file };
  }

  set opened(opened: OpenedProgram) {
    const { text, file } = opened;
    if (this.#createdShell === undefined) {
      this.#initialProgram = opened;
      return;
    }
    this.#createdShell.setProgram(
      programText(text),
      file !== undefined && ENCODINGS.includes(file.encoding) ? file : undefined,
    );
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
    return parseLoading(this.getAttribute('loading'));
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

  /** The calculator over the program, such as `r-of-g90`; its result becomes the program. */
  get calculator(): string | null {
    return this.getAttribute('calculator');
  }

  set calculator(name: string | null) {
    this.#setOrRemove('calculator', name);
  }

  /** The dimensions and letters in the picture: `none`, `word`, `cycle` or `part`. */
  get annotate(): string | null {
    return this.getAttribute('annotate');
  }

  set annotate(choice: string | null) {
    this.#setOrRemove('annotate', choice);
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

  /** The address of the folder of the pages of the manual; empty: no link to them. */
  get manual(): string | null {
    return this.getAttribute('manual');
  }

  set manual(address: string | null) {
    this.#setOrRemove('manual', address);
  }

  play(): void {
    this.#callService('play', (play) => play());
  }

  pause(): void {
    this.#callService('pause', (pause) => pause());
  }

  override focus(): void {
    this.#createdShell?.editor.focus();
  }

  /** The position of the point X (a diameter), Z in mm, in CSS pixels of the window. */
  async locate(x: number, z: number): Promise<ClientPoint> {
    return this.#shell.forPanels.service('locate')('section', x, z);
  }

  /** The same for the end face: X a diameter, C in mm. */
  async locateOnFace(x: number, c: number): Promise<ClientPoint> {
    return this.#shell.forPanels.service('locate')('face', x, c);
  }

  /** The same for the side: Z in mm, C in degrees, or Y in mm if its ruler shows Y. */
  async locateOnSide(z: number, c: number): Promise<ClientPoint> {
    return this.#shell.forPanels.service('locate')('side', z, c);
  }

  /** Opens a file as the program; undo restores the replaced one. */
  async openFile(file: File): Promise<void> {
    const shell = this.#shell;
    await shell.complete;
    return shell.forPanels.service('openFile')(file);
  }

  /** Saves the program as a file, in the encoding and with the line ends of the opened file. */
  saveFile(): void {
    this.#callService('saveFile', (save) => save());
  }

  /** The content of a file of the menu "Export"; undefined if there is no part or no interpreter. */
  async exported(format: ExportFormat): Promise<Uint8Array | undefined> {
    const shell = this.#shell;
    await shell.complete;
    const exported = await shell.forPanels.service('exported')(format);
    return exported?.kind === 'file' ? exported.content : undefined;
  }

  /** Stores the part, so that later programs are drawn over it. */
  keepPart(): void {
    this.#callService('keepPart', (keep) => keep());
  }

  /**
   * The differences from another version, which counts as the first; undefined if the program has changed meanwhile.
   */
  async differenceFrom(other: OtherVersion): Promise<DifferenceResult | undefined> {
    const shell = this.#shell;
    await shell.complete;
    return shell.forPanels.ask('difference', other);
  }

  /** Ends the comparison that `keepPart` started; one that the user started continues. */
  endComparison(): void {
    this.#callService('endComparison', (end) => end());
  }

  /** Creates the shell if the element is still waiting for the viewport. */
  get #shell(): PlaygroundShell {
    if (this.isConnected && this.#createdShell === undefined) this.#start();
    if (this.#createdShell === undefined) throw new Error('the playground is not in a document');
    return this.#createdShell;
  }

  /** Starts according to `loading`. */
  #scheduleStart(): void {
    this.#stopWaiting?.();
    if (!this.isConnected || this.#createdShell !== undefined) return;
    const root = this.#prepareRoot();
    root.replaceChildren();
    if (this.loading === 'eager') this.#start();
    else if (this.loading === 'lazy') this.#stopWaiting = whenNear(this, () => this.#start());
    else
      root.append(
        make('slot', { name: 'fallback' }),
        make(
          'div',
          { className: 'own' },
          startButton(this.language, () => this.#start()),
        ),
      );
  }

  #start(): void {
    this.#stopWaiting?.();
    if (this.#createdShell === undefined) {
      this.#prepareRoot().replaceChildren();
      this.#createdShell = this.#createShell();
    }
    this.#createdShell.connect();
  }

  /** Attaches the styles first, so that the element has its size before it has content. */
  #prepareRoot(): ShadowRoot {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    adoptStyles(root, [tokens, controls, styles]);
    return root;
  }

  /** The current position of the tool in the format of `step`; null if the whole path is shown. */
  async currentStep(): Promise<string | null> {
    const place = await this.#shell.forPanels.ask('readout', undefined);
    if (place === undefined || place.share >= 1) return null;
    const { motion, x, z, atX, atZ } = place.stroke;
    // Within a motion, the last position with a number is the end of the previous motion.
    const isAtItsEnd = Math.abs(x - atX) < 1e-6 && Math.abs(z - atZ) < 1e-6;
    // A dwell ends where it begins. The end of the last motion does not count: it would show the whole path.
    const isLast = (await this.#shell.forPanels.ask('strokes', { first: motion + 1, end: motion + 2 }))?.length === 0;
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
    this.#shell.forPanels.goTo({ from, to: from + text.length });
  }

  /**
   * The complete setup of the run as JSON, merged from `setup` and the other attributes; undefined if it is invalid.
   */
  get wholeSetup(): string | undefined {
    const result = mergeSetup(this.setup, this);
    return result.kind === 'setup' && isJson(result.json) ? result.json : undefined;
  }

  /** What the user can do, for the command palette of the page. */
  get commands(): readonly UserCommand[] {
    return this.#shell.commands;
  }

  /** The drawing as SVG, or the shown picture as PNG; undefined if there is none yet. */
  async pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined> {
    const shell = this.#shell;
    shell.forPanels.flush();
    const made = await shell.forPanels.ask('export', { format });
    return made?.kind === 'file'
      ? new Blob([made.content], { type: format === 'svg' ? 'image/svg+xml' : 'image/png' })
      : undefined;
  }

  /** Calls a service of the view: immediately, or when its panel is loaded. */
  #callService<S extends 'play' | 'pause' | 'saveFile' | 'keepPart' | 'endComparison'>(
    name: S,
    callback: (service: Services[S]) => void,
  ): void {
    const shell = this.#shell;
    if (!shell.offers(name)) throw new Error(`view="${shell.view}" does not offer ${name}`);
    void shell.complete.then(
      () => callback(shell.forPanels.service(name)),
      () => undefined,
    );
  }

  /** `view`, `controls` or `readonly` has changed: creates another shell with the same program. */
  #rerender(): void {
    const made = this.#createdShell;
    if (made === undefined || this.#viewKey === this.#renderedView) return;
    this.#initialProgram = this.opened;
    made.disconnect();
    this.#createdShell = undefined;
    this.shadowRoot?.replaceChildren();
    if (this.isConnected) this.#start();
  }

  get #viewKey(): string {
    return JSON.stringify([this.view, shownControls(this.view, this.controls), this.readonly, this.calculator]);
  }

  /** Properties that were set before the class was defined hide its accessors: set them again. */
  #upgradeProperties(): void {
    for (const name of Object.getOwnPropertyNames(this)) {
      if (Object.getOwnPropertyDescriptor(GcodePlayground.prototype, name)?.set === undefined) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }

  #createShell(): PlaygroundShell {
    const root = this.#prepareRoot();
    this.#renderedView = this.#viewKey;
    const shell = new PlaygroundShell(root, this, {
      fire: (type, detail) => this.#fire(type, detail),
      onChange: () => this.#fireChange(),
      onUnsettled: () => this.#settling.unsettle(),
      onSettled: (run) => this.#settling.settle(run),
    });
    if (this.#initialProgram === undefined) {
      this.#source = this.#createSource(() => this.#createdShell ?? shell);
      shell.start(this.#source.start(), undefined);
    } else shell.start(this.#initialProgram.text, this.#initialProgram.file);
    return shell;
  }

  #createSource(shell: () => PlaygroundShell): Source {
    return new Source(this, {
      current: () => shell().editor.text,
      onProgram: (text, file) => shell().programLoaded(text, file),
      onSetup: (json) => this.setAttribute('setup', json),
      onLoading: (address, how) => shell().programLoading(address, how),
      onFailed: (address, reason, retry) => shell().programFailed(address, reason, retry),
    });
  }

  #fireChange(): void {
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
const connectedElements = new Set<GcodePlayground>();

function markAsLastUsed(element: GcodePlayground): void {
  if (!connectedElements.delete(element)) return;
  connectedElements.add(element);
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
function isPlainKey({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return !ctrlKey && !metaKey && !altKey && key !== 'Escape' && key !== 'Tab' && !/^F\d+$/.test(key);
}

/** The keys of the playback also work if the focus is outside, but not in a text field. */
function onDocumentKeydown(event: KeyboardEvent): void {
  const isPlayKey = event.key === 'F9' || (event.key === 'Enter' && (event.ctrlKey || event.metaKey));
  if (!isPlayKey || event.defaultPrevented) return;
  const path = event.composedPath();
  const isText = path.some(
    (part) => part instanceof HTMLElement && (part.isContentEditable || part.matches('input, textarea')),
  );
  if (isText || path.some((part) => part instanceof GcodePlayground)) return;
  [...connectedElements].at(-1)?.handleKey(event);
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
  upgradeDocument(GcodePlayground.observedAttributes);
}
