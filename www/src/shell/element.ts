// <gcode-playground>: a lathe program, its drawing, its problems, and the tool moving along it.
//
//   <script type="module" src="element.js"></script>
//   <gcode-playground control="fanuc" setup='{"stock": {"diameter": 60, "length": 80}}'>
//     G00 X62 Z2
//     G90 X50 Z-30 F0.2
//   </gcode-playground>
//
// The program is at the address in `src`, or stands inside: in a script, in a `pre`, or as text (source.ts). Attributes
// (each is a property too):
//   src       the address of the program
//   control   fanuc | gsk | forum      overrides `dialect.control` of the setup
//   setup     JSON, the property also an object: start point, tools, stock, dialect switches
//   language  en | zh | ru             of the page and of the messages
//   theme     auto | light | dark     auto: as the page around
//   block-skip  "1,2"              the levels of block skip that are on; overrides `blockSkip` of the setup
//   program   2                    the O number that is run; overrides `program` of the setup
//   view      all | picture | playback | code   the picture alone, with the bar that plays it, or the program alone; what is
//                                  not shown is not loaded
//   controls  "playback status"    the groups of panels that are shown (panels/panel.ts), or none
//   readonly                       the reader cannot change the program
//   step      12 | line 8          where the tool stands at the start
//   highlight "6-8, 12"            lines that are marked, with their strokes
//   lines     "3-20"               lines that are shown at first; the others are folded
//   fit       part | path          what the picture shows
//   turret    front | rear
//   caption   a line under the element, which names it
//   playground https://…               the page that "Open in the playground" leads to; none where it is empty
//   rules, docs https://…              the folders of the rule pages and of the documents; no links to them where they are empty
//   loading   lazy | eager | click     when it starts: near the view, at once, or when the reader asks for it
//   split     40                       percent of the width for the program, where it stands beside the drawing; follows the divider
//   hints     "edit play pick"     the hints of the first minute that are still to be shown; none without it
// `hints`, `block-skip` and `program` follow the reader, who finds a switch for each where the text has a use for it.
// Other `view`, `controls` or `readonly`: it is made anew around the program, what could be undone is forgotten.
// Properties: value (the program), length (of it, each line end counted as one), opened (its file, with the
// text as it is in it), origin (any text by which the page knows whose the program is). Setting one, or an attribute, fires no event.
// The text it has already changes nothing. A text of the reader's that replaces most of the one before is another program: the attributes of the program
// are removed and `origin` becomes null; undo brings all of it back. A text that the page sets leaves them. Methods: play(), pause(),
// openFile(file), saveFile(), exported(format): the bytes of a file of the menu "Export", focus(), keepPart() to lay the parts of later programs over this one's,
// endComparison(), differenceFrom({text, names}) for the blocks and motions in which another version differs, currentStep() and pictureFile(format),
// both promises, cursorLine, goToLine(line) and wholeSetup, and for automation
//   settled: Promise<number>   a property: resolved once all there is to show of the program, setup, language,
//                              size and colours of now is shown, the part with all its material off included;
//                              with the number of the run. Numbers grow with every change of text or setup.
//                              Nothing settles in a tab that nobody sees.
//   locate(x, z): Promise<{clientX, clientY}>   where a place (X a diameter, mm) is in the window
//   locateOnFace(x, c): the same of the face
//   locateOnSide(z, c): the same of the side, C in degrees; Y in mm where its ruler shows Y
// Events (bubbling, only for what the reader did, and `report` for each finished run):
//   gcode-change   detail {value}
//   gcode-select   detail {stroke}: `from` and `to` are UTF-16 offsets into the text as it was given, with its own line ends (`opened.text`)
//   gcode-report   detail {summary, diagnostics}: offsets likewise, also of edits
//   gcode-settled  detail {run}: as `settled`, each time
//   gcode-switch   detail {blockSkip, program}
//   gcode-setup    detail {setup}: the attribute follows the form
//   gcode-hint     detail {left}: the hints that are left
//   gcode-split    detail {split}: the reader has dragged the divider
//   gcode-context  detail {control, setup, blockSkip, program, origin}: another program has taken the place of the
//                  one before, or undo has brought one back; attributes and `origin` are as the detail says
// Slots: `intro` above the program; `fallback`, what is shown until there is a picture.
// CSS custom properties: --playground-height, --playground-type-size, --playground-font, --playground-code-font,
// --playground-code-size and the colours of colours.css. Parts: frame intro bar file switches editor problems
// drawing canvas old-picture what-if at-cursor legend tooltip setup views assumptions playback play readout doing status notice hint totals units
// open-link motions written-out rewrite codes solid export-menu paste help read-as profiles caption fallback.
//
// What is inside is the shell's: see shell.ts, and panels/panel.ts for how to add to it.

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

/** Attributes that say what is there at all. */
const MAKES_ANEW: readonly string[] = ['view', 'controls', 'readonly'];
/** What the author says of lines and picture. */
const AUTHORS: readonly string[] = ['highlight', 'lines', 'fit', 'turret', 'caption', 'playground'];

/** Read when the pointer or the focus reaches a link. */
const PAGES: readonly string[] = ['rules', 'docs'];

/** Where Node reads this, there are no elements, and nobody makes one. */
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

  /** Whose the program is: set by the page, which knows it by this; none after another program has taken its place. */
  #origin: string | null = null;
  /** Made when the element is first in a document. */
  #made: PlaygroundShell | undefined;
  /** The view, and what else is there at all. */
  #madeFor = '';
  /** What was set before. */
  #early: OpenedProgram | undefined;
  /** Where the program comes from as long as nobody sets one. */
  #source: Source | undefined;
  /** Ends the wait for the element to come near the view. */
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

  /** What is typed inside is no command of the page around: manuals turn their pages with arrow keys and open a search with letters. */
  #keep(event: KeyboardEvent): void {
    const [origin] = event.composedPath();
    if (isTyped(event) && origin instanceof Node && origin.getRootNode() === this.shadowRoot) event.stopPropagation();
  }

  /** A key that was pressed outside of the element, and is its own all the same. */
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

  /** Resolved with the number of the run once all there is to show of it is shown. Who asks does not wait for the reader to come near. */
  get settled(): Promise<number> {
    if (this.#made === undefined) whenParsed(this, () => this.isConnected && this.#begin());
    return this.#settling.promise;
  }

  get value(): string {
    return this.#made?.editor.text ?? this.#early?.text ?? textInside(this);
  }

  /** The text it has already changes nothing: a page that hands back each change keeps the cursor, the history and the file. */
  set value(text: string) {
    const { text: own } = this.opened;
    if (text !== own && text !== this.value) this.opened = { text, file: undefined };
  }

  /** UTF-16 units of the program, every line end counted as one. */
  get length(): number {
    return this.#made?.editor.length ?? this.value.length;
  }

  /** The file the program came from. */
  get file(): ProgramFile | undefined {
    return this.#made?.editor.file ?? this.#early?.file;
  }

  /** The program and the file it came from; the text has the file's own line ends. */
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

  /** The address of the program. */
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

  /** JSON, or what it says. */
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

  /** The panels that are shown: names of groups, or `none`; all where nothing is said. */
  get controls(): string | null {
    return this.getAttribute('controls');
  }

  set controls(names: string | null) {
    this.#setOrRemove('controls', names);
  }

  /** The reader cannot change the program. */
  get readonly(): boolean {
    return this.hasAttribute('readonly');
  }

  set readonly(readonly: boolean) {
    this.toggleAttribute('readonly', readonly);
  }

  /** Where the tool stands at the start: after so many motions, or before `line 8`. */
  get step(): string | null {
    return this.getAttribute('step');
  }

  set step(step: string | number | null) {
    this.#setOrRemove('step', step);
  }

  /** The lines that are marked, with their strokes: `6-8, 12`. */
  get highlight(): string | null {
    return this.getAttribute('highlight');
  }

  set highlight(lines: string | number | null) {
    this.#setOrRemove('highlight', lines);
  }

  /** The lines that are shown at first: `3-20`. */
  get lines(): string | null {
    return this.getAttribute('lines');
  }

  set lines(lines: string | number | null) {
    this.#setOrRemove('lines', lines);
  }

  /** What the picture shows: the `part`, or the whole `path`. */
  get fit(): string | null {
    return this.getAttribute('fit');
  }

  set fit(fit: string | null) {
    this.#setOrRemove('fit', fit);
  }

  /** Where the turret is drawn: `front` or `rear`. */
  get turret(): string | null {
    return this.getAttribute('turret');
  }

  set turret(side: string | null) {
    this.#setOrRemove('turret', side);
  }

  /** The line under the element, which names it for screen readers. */
  get caption(): string | null {
    return this.getAttribute('caption');
  }

  set caption(text: string | null) {
    this.#setOrRemove('caption', text);
  }

  /** The page that "Open in the playground" leads to: an address; none where it is empty. */
  get playground(): string | null {
    return this.getAttribute('playground');
  }

  set playground(address: string | null) {
    this.#setOrRemove('playground', address);
  }

  /** The folder of the rule pages: an address; no links to them where it is empty. */
  get rules(): string | null {
    return this.getAttribute('rules');
  }

  set rules(address: string | null) {
    this.#setOrRemove('rules', address);
  }

  /** The folder of the documents: an address; no link to them where it is empty. */
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

  /** Where the place X (a diameter), Z in mm is drawn, in the window's CSS pixels. */
  async locate(x: number, z: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('section', x, z);
  }

  /** The same of the end face: X a diameter, C in mm. */
  async locateOnFace(x: number, c: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('face', x, c);
  }

  /** The same of the side: Z in mm, C in degrees; or Y in mm where its ruler shows Y. */
  async locateOnSide(z: number, c: number): Promise<ClientPlace> {
    return this.#shell.service('locate')('side', z, c);
  }

  /** Opens a file as the program; what it replaces can be brought back with undo. */
  async openFile(file: File): Promise<void> {
    const shell = this.#shell;
    await shell.complete;
    return shell.service('openFile')(file);
  }

  /** Saves the program as a file, in the encoding and with the line ends it was opened with. */
  saveFile(): void {
    this.#with('saveFile', (save) => save());
  }

  /** A file as the menu "Export" makes it; nothing where there is no part, or no interpreter. */
  async exported(format: ExportFormat): Promise<Uint8Array | undefined> {
    const shell = this.#shell;
    await shell.complete;
    const exported = await shell.service('exported')(format);
    return exported?.kind === 'file' ? exported.content : undefined;
  }

  /** Keeps the part, to lay those of later programs over it. */
  keepPart(): void {
    this.#with('keepPart', (keep) => keep());
  }

  /** What differs between another version, the first, and the program; nothing where the program has changed meanwhile. */
  async differenceFrom(other: OtherVersion): Promise<Differed | undefined> {
    const shell = this.#shell;
    await shell.complete;
    return shell.ask('difference', other);
  }

  /** Ends the comparison that `keepPart` began; one that the reader began goes on. */
  endComparison(): void {
    this.#with('endComparison', (end) => end());
  }

  /** What is asked of an element that waits to be seen starts it. */
  get #shell(): PlaygroundShell {
    if (this.isConnected && this.#made === undefined) this.#begin();
    if (this.#made === undefined) throw new Error('the playground is not in a document');
    return this.#made;
  }

  /** Begins when it is time. */
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

  /** The element's box is there with its styles before anything stands in it. */
  #root(): ShadowRoot {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    adopt(root, [colours, styles]);
    return root;
  }

  /** Where the tool stands now, as `step` says it; null where all of the path is shown. */
  async currentStep(): Promise<string | null> {
    const place = await this.#shell.ask('readout', undefined);
    if (place === undefined || place.share >= 1) return null;
    const { motion, x, z, atX, atZ } = place.stroke;
    // On its way along a motion, or before one, the last place that has a number is the end of the one before.
    const isAtItsEnd = Math.abs(x - atX) < 1e-6 && Math.abs(z - atZ) < 1e-6;
    // A dwell ends where it begins; at the end of the last motion all of the path would be shown.
    const isLast = (await this.#shell.ask('strokes', { first: motion + 1, end: motion + 2 }))?.length === 0;
    const done = isAtItsEnd && !isLast ? motion + 1 : motion;
    return done === 0 ? null : String(done);
  }

  /** The line of the cursor, from 1. */
  get cursorLine(): number {
    const { editor } = this.#shell;
    return editor.lineOf(editor.cursor) + 1;
  }

  /** Puts the cursor into a line, from 1, and marks it; where there is no such line nothing happens. */
  goToLine(line: number): void {
    const lines = this.value.split('\n');
    const text = lines[line - 1];
    if (text === undefined) return;
    const from = lines.slice(0, line - 1).reduce((length, before) => length + before.length + 1, 0);
    this.#shell.goTo({ from, to: from + text.length });
  }

  /** All of the setup the program is run with, as JSON: that of `setup` and of the other attributes. Nothing where it cannot be read. */
  get wholeSetup(): string | undefined {
    const merged = mergedSetup(this.setup, this);
    return merged.kind === 'setup' && isJson(merged.json) ? merged.json : undefined;
  }

  /** The drawing, or the picture as it is shown; nothing before there is one. */
  async pictureFile(format: 'svg' | 'png'): Promise<Blob | undefined> {
    const shell = this.#shell;
    shell.flush();
    const made = await shell.ask('export', { format });
    return made?.kind === 'file'
      ? new Blob([made.content], { type: format === 'svg' ? 'image/svg+xml' : 'image/png' })
      : undefined;
  }

  /** At once where the view has what it takes; as soon as that is loaded where it is on its way. */
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

  /** What is there at all is another: it is made anew, around the same program. */
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

  /** What was set on the element before its class was there stands in the way of the properties. */
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
    // Made only for who asks: a program can be 20 MB long, and this follows each key.
    this.#fire('gcode-change', {
      get value() {
        return element.value;
      },
    });
  }

  #fire<Detail>(type: string, detail: Detail): void {
    this.dispatchEvent(new CustomEvent<Detail>(type, { detail, bubbles: true, composed: true }));
  }

  /** Frameworks take nothing away by `undefined`. */
  #setOrRemove(attribute: string, value: string | number | null | undefined): void {
    if (value === null || value === undefined) this.removeAttribute(attribute);
    else this.setAttribute(attribute, String(value));
  }
}

/** The elements of the page; the one that was used last is the last. */
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

/** Keys of which pages make commands of one key, and that write or move in a text, a list or a picture. */
function isTyped({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return !ctrlKey && !metaKey && !altKey && key !== 'Escape' && key !== 'Tab' && !/^F\d+$/.test(key);
}

/** The keys of the playback work where nothing else has the focus that could want them. */
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
 * Puts elements around the marked programs of a part of a page that came after the page was read:
 * `<script type="text/x-gcode" data-gcode-playground>` and `<pre data-gcode-playground>`.
 */
export function upgrade(root: ParentNode = document): void {
  upgradeIn(root, GcodePlayground.observedAttributes);
}

if (typeof customElements !== 'undefined') {
  if (customElements.get('gcode-playground') === undefined) customElements.define('gcode-playground', GcodePlayground);
  upgradeThePage(GcodePlayground.observedAttributes);
}
