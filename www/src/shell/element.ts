// <gcode-playground>: a lathe program, its drawing, its messages, and the playback of the tool.
//
//   <script type="module" src="element.js"></script>
//   <gcode-playground control="fanuc" setup='{"stock": {"diameter": 60, "length": 80}}'>
//     G00 X62 Z2
//     G90 X50 Z-30 F0.2
//   </gcode-playground>
//
// In: attributes (element-attributes.ts), the program from its source (source.ts), methods and properties of the host
// page. Out: the events, and the shadow DOM, which belongs to the shell: see shell.ts, and panels/panel.ts for how to
// add to it. `www/docs/element.md` describes the interface; `www/embed/element.d.ts` has its types.
//
// Attributes for the page of the playground only, which the user changes: `split`, the program's share of the width in
// percent; `hints`, the introductory hints that are still to be shown; `labels`, names on the picture. Its method: `ask`.
// Methods for tests only: `locate`, `locateOnFace`, `locateOnSide`.

import { make } from '../dom/dom';
import { programText, type ProgramFile } from '../editor/program-text';
import { ENCODINGS } from '../files/encoding-list';
import type {
  Answer,
  Diagnostic,
  DifferenceResult,
  ExportFormat,
  OtherVersion,
  QuestionKind,
  Questions,
  Readout,
  Summary,
} from '../protocol/protocol';
import type { ClientPoint, Services, UserCommand } from '../panels/panel';
import { ElementAttributes } from './element-attributes';
import { shownControls } from './layout';
import { connectKeys, disconnectKeys, keepKeyInside, markAsLastUsed } from './page-keys';
import { whenParsed } from './parsed';
import { Settling } from './settling';
import { mergeSetup } from './merged-setup';
import type { SeekTarget } from './seek';
import { PlaygroundShell } from './shell';
import { Source, textInside } from './source';
import { adoptStyles } from './style-sheets';
import { upgradeIn, upgradeDocument } from './upgrade';
import { startButton, whenNear } from './when-seen';
import controls from '../dom/controls.css?inline';
import tokens from '../tokens.css?inline';
import styles from './styles.css?inline';

export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

const NO_DIAGNOSTICS: readonly Diagnostic[] = Object.freeze([]);

/** A change of these attributes renders the element again. */
const RERENDERING_ATTRIBUTES: readonly string[] = ['view', 'controls', 'readonly', 'calculator', 'exercise'];
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

const HEIGHT_ATTRIBUTES: readonly string[] = ['height', 'rows-min', 'rows-max'];
/** These need no update: they are read when the pointer or the focus reaches a link. */
const LINK_ATTRIBUTES: readonly string[] = ['rules', 'docs', 'manual'];

export class GcodePlayground extends ElementAttributes {
  /**
   * Set by the page to identify the program; null after another program has replaced it; undefined if the page has never
   * set it.
   */
  #origin: string | null | undefined;
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
      this.addEventListener(type, (event) => keepKeyInside(this, event));
  }

  connectedCallback(): void {
    connectKeys(this);
    this.#upgradeProperties();
    if (this.#createdShell !== undefined) return this.#start();
    this.#prepareRoot();
    if (this.#initialProgram !== undefined) this.#scheduleStart();
    else whenParsed(this, () => this.#scheduleStart());
  }

  disconnectedCallback(): void {
    disconnectKeys(this);
    this.#stopWaiting?.();
    this.#createdShell?.disconnect();
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
    else if (attribute === 'speed') this.#createdShell?.speedChanged();
    else if (HEIGHT_ATTRIBUTES.includes(attribute)) this.#createdShell?.heightChanged();
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

  get origin(): string | null {
    return this.#origin ?? null;
  }

  set origin(origin: string | null) {
    this.#origin = origin;
  }

  /** Whether the page marks its programs with `origin`. */
  get marksPrograms(): boolean {
    return this.#origin !== undefined;
  }

  /** The messages about the current program, with offsets into `opened.text`; empty until it is checked. */
  get diagnostics(): readonly Diagnostic[] {
    return this.#createdShell?.checked?.diagnostics ?? NO_DIAGNOSTICS;
  }

  /** The summary of the current program; undefined until it is checked. */
  get summary(): Summary | undefined {
    return this.#createdShell?.checked?.summary;
  }

  /** Whether the tool is moving along the path. */
  get playing(): boolean {
    return this.#createdShell?.playback.playing ?? false;
  }

  /** The position of the tool; undefined if the whole path is shown. */
  get readout(): Readout | undefined {
    return this.#createdShell?.playback.readout;
  }

  /** Moves the tool, once the program has run; null shows the whole path. Returns the position of the tool. */
  async seek(to: SeekTarget | null): Promise<Readout | undefined> {
    const shell = this.#shell;
    shell.expectOffer('seek');
    return shell.seek(to);
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

  /** The worker's answer to a question about the current text; undefined if the text has changed meanwhile. */
  async ask<K extends QuestionKind>(about: K, args: Questions[K]['args']): Promise<Answer<K> | undefined> {
    const shell = this.#shell;
    await shell.complete;
    shell.forPanels.flush();
    return shell.forPanels.ask(about, args);
  }

  /** Ends the comparison that `keepPart` started; one that the user started continues. */
  endComparison(): void {
    this.#callService('endComparison', (end) => end());
  }

  /** Checks the program as the answer to the exercise, as a click on "Check" does. */
  checkExercise(): void {
    this.#callService('checkExercise', (check) => check());
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
    this.#shell.forPanels.showPlace({ from, to: from + text.length });
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
  #callService<S extends 'play' | 'pause' | 'saveFile' | 'keepPart' | 'endComparison' | 'checkExercise'>(
    name: S,
    callback: (service: Services[S]) => void,
  ): void {
    const shell = this.#shell;
    shell.expectOffer(name);
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
    return JSON.stringify([
      this.view,
      shownControls(this.view, this.controls),
      this.readonly,
      this.calculator,
      this.exercise,
    ]);
  }

  /** Properties that were set before the class was defined hide its accessors: set them again. */
  #upgradeProperties(): void {
    const classes = [GcodePlayground.prototype, ElementAttributes.prototype];
    for (const name of Object.getOwnPropertyNames(this)) {
      if (classes.every((of) => Object.getOwnPropertyDescriptor(of, name)?.set === undefined)) continue;
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
}

function isJson(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
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
