// <gcode-playground>: a lathe program, its drawing, its problems, and the tool moving along it.
//
//   <script type="module" src="element.js"></script>
//   <gcode-playground control="fanuc" setup='{"stock": {"diameter": 60, "length": 80}}'>
//     G00 X62 Z2
//     G90 X50 Z-30 F0.2
//   </gcode-playground>
//
// Its own text is the program it starts with. Attributes (each is a property too):
//   control   fanuc | gsk | forum      overrides `dialect.control` of the setup
//   setup     JSON: start point, tools, stock, dialect switches
//   language  en | zh | ru             of the page and of the messages
//   theme     auto | light | dark
//   block-skip  "1,2"                  the levels of block skip that are on; overrides `blockSkip` of the setup
//   program   2                        the O number that is run; overrides `program` of the setup
// The last two follow the reader, who finds a switch for each where the text has a use for it.
// Properties: value (the program), length (of it, each line end counted as one), opened (its file, with the text as it is
// in it). Setting one, or an attribute, fires no event. Methods: play(), pause(), openFile(file), saveFile(), focus(), and for
// automation
//   settled: Promise<number>   a property: resolved once all there is to show of the program, setup, language, size and colours of
//                              now is shown, the part with all its material off included; with the number of the run. Numbers
//                              grow with every change of text or setup. Nothing settles in a tab that nobody sees.
//   locate(x, z): Promise<{clientX, clientY}>   where a place (X a diameter, mm) is in the window; locateOnFace(x, c) of the face.
// Events (bubbling, only for what the reader did, and `report` for each finished run):
//   gcode-change  detail {value}      gcode-select  detail {stroke}      gcode-report  detail {summary, diagnostics}
//   gcode-settled detail {run}: as `settled`, each time
//   gcode-switch  detail {blockSkip, program}      gcode-setup  detail {setup}: the attribute follows the form
// Slot: `intro` above the program.
// CSS custom properties: --playground-height, --playground-font, --playground-code-font, --playground-code-size and
// the colours of colours.css. Parts: frame intro bar file switches editor problems drawing canvas legend tooltip
// setup views assumptions playback play readout doing status notice written-out rewrite codes solid export-menu paste help.
//
// Must not know: G-code. What is written and what it means is the interpreter's business, behind core-client.ts.

import { AssumedStock } from '../panels/assumed-stock';
import { CodesDialog } from '../panels/codes';
import { CoreClient, Newest, type Heard, type Loss } from '../worker/core-client';
import { make } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import { dimensionText } from '../panels/dimension';
import { Drawing } from '../panels/drawing';
import { Editor } from '../editor/editor';
import { programText, type ProgramFile, type ProgramText } from '../editor/file';
import { ENCODING_NAMES, ENCODINGS, type Encoding } from '../files/encodings';
import { exportName, Exports } from '../panels/exports';
import { FileBar } from '../panels/file-bar';
import { bytesToSave, download, readProgram, reread } from '../editor/program-files';
import { Help } from '../panels/help';
import { strings, type Strings } from '../dom/i18n';
import { languageOf, type Language } from '../dom/language';
import { Notice } from '../panels/notice';
import { Pasting } from '../panels/paste';
import { Playback } from '../panels/playback';
import { Problems } from '../panels/problems';
import type { Came, FileFormat, Readout, Report, Rewriting, SetupAnswer, SetupForm, SetupGroup, SetupPlace, Stroke, Summary, CanvasCommand } from '../protocol/protocol';
import { RewriteDialog } from '../panels/rewrite';
import { SetupBar } from '../panels/setup-bar';
import { SetupDialog, type SetupEntries } from '../panels/setup-form';
import { Settling } from './settling';
import { SolidDialog } from '../panels/solid';
import { initialProgram, mergedSetup, neutralSetup, switchesSet } from './start';
import { StatusLine } from '../panels/status-line';
import { Switches } from '../panels/switches';
import { Views, type Pictures } from '../panels/views';
import { WrittenOutDialog } from '../panels/written-out';
import colours from '../colours.css?inline';
import pasteStyles from '../panels/paste.css?inline';
import playbackStyles from '../panels/playback.css?inline';
import setupStyles from '../panels/setup.css?inline';
import styles from './styles.css?inline';

const sheets = [colours, styles, setupStyles, playbackStyles, pasteStyles].map((text) => {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  return sheet;
});

const SEND_AFTER_MS = 30;

/** What one worker is asked for; replaced as a whole when the worker is. */
interface Line {
  readonly client: CoreClient;
  readonly pointer: Newest<'pick'>;
  readonly tool: Newest<'seek'>;
  readonly section: Newest<'section'>;
  readonly onFace: Newest<'pickOnFace'>;
  readonly edge: Newest<'dimension'>;
}

export interface OpenedProgram {
  readonly text: string;
  readonly file: ProgramFile | undefined;
}

export class GcodePlayground extends HTMLElement {
  static readonly observedAttributes = ['control', 'setup', 'block-skip', 'program', 'language', 'theme'];

  #editor: Editor | undefined;
  #line: Line | undefined;
  #strings: Strings = strings('en');
  #drawing!: Drawing;
  #face!: Drawing;
  #views!: Views;
  #pictures!: HTMLElement;
  #playback!: Playback;
  #problems!: Problems;
  #status!: StatusLine;
  /** How the newest change of the text came. */
  #came: Came = 'typed';
  #notice!: Notice;
  #fileBar!: FileBar;
  #switches!: Switches;
  #setupBar!: SetupBar;
  #setupForm!: SetupDialog;
  #assumedStock!: AssumedStock;
  /** How the program before this one was run, for undo. */
  #before: { readonly length: number; readonly setup: string | null; readonly blockSkip: string | null; readonly program: string | null } | undefined;
  #help!: Help;
  #writtenOut!: WrittenOutDialog;
  #rewrite!: RewriteDialog;
  #codes!: CodesDialog;
  #exports!: Exports;
  #solid!: SolidDialog;
  #pasting!: Pasting;
  #sending: ReturnType<typeof setTimeout> | undefined;
  #opening: Promise<unknown> | undefined;
  #cursorKnown = false;
  /** Why the setup could not even be sent. */
  #setupUnreadable: string | undefined;
  /** UTF-16 units of the program before the last change. */
  #lengthBefore = 0;
  #hovered: number | undefined;
  #running: number | undefined;
  readonly #dark = matchMedia('(prefers-color-scheme: dark)');
  readonly #settling = new Settling((run) => this.#fire('gcode-settled', { run }));
  /** What has changed since the last run was begun. */
  #changes: { readonly framing: 'fit' | 'keep' } | undefined;
  /** The worker knows the setup as it is. */
  #setupSent = false;
  readonly #showPalette = (): void => this.#client?.send({ kind: 'palette', palette: this.#drawing.palette });
  /** What was set before the element was in a document. */
  #early: OpenedProgram | undefined;

  connectedCallback(): void {
    if (this.#editor === undefined) this.#build();
    this.#dark.addEventListener('change', this.#showPalette);
    this.#connect();
    this.#runWanted('keep');
  }

  disconnectedCallback(): void {
    this.#dark.removeEventListener('change', this.#showPalette);
    this.#playback.pause();
    this.#solid.close();
    this.#line?.client.end();
    this.#line = undefined;
  }

  attributeChangedCallback(attribute: string, before: string | null, now: string | null): void {
    if (before === now || this.#editor === undefined) return;
    if (attribute === 'language') this.#showLanguage();
    else if (attribute === 'theme') this.#showPalette();
    else this.#setupChanged();
  }

  /** Resolved with the number of the run once all there is to show of it is shown. */
  get settled(): Promise<number> {
    return this.#settling.promise;
  }

  get value(): string {
    return this.#editor?.text ?? this.#early?.text ?? '';
  }

  set value(text: string) {
    this.opened = { text, file: undefined };
  }

  /** UTF-16 units of the program, every line end counted as one. */
  get length(): number {
    return this.#editor?.length ?? this.value.length;
  }

  /** The file the program came from. */
  get file(): ProgramFile | undefined {
    return this.#editor?.file ?? this.#early?.file;
  }

  /** The program and the file it came from; the text has the file's own line ends. */
  get opened(): OpenedProgram {
    const editor = this.#editor;
    if (editor === undefined) return this.#early ?? { text: '', file: undefined };
    return { text: editor.textWithLineEnds, file: editor.file };
  }

  set opened(opened: OpenedProgram) {
    const { text, file } = opened;
    const editor = this.#editor;
    if (editor === undefined) {
      this.#early = opened;
      return;
    }
    const known = file !== undefined && ENCODINGS.includes(file.encoding) ? file : undefined;
    this.#take(editor, programText(text), known);
  }

  get language(): Language {
    return languageOf(this.getAttribute('language') ?? this.closest('[lang]')?.getAttribute('lang'));
  }

  set language(language: Language) {
    this.setAttribute('language', language);
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

  set setup(json: string | null) {
    this.#setOrRemove('setup', json);
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

  get theme(): string {
    return this.getAttribute('theme') ?? 'auto';
  }

  set theme(theme: string) {
    this.setAttribute('theme', theme);
  }

  play(): void {
    this.#playback.play();
  }

  pause(): void {
    this.#playback.pause();
  }

  override focus(): void {
    this.#editor?.focus();
  }

  /** Where the place X (a diameter), Z in mm is drawn, in the window's CSS pixels. */
  async locate(x: number, z: number): Promise<{ clientX: number; clientY: number }> {
    const client = this.#client;
    if (client === undefined) throw new Error('the playground is not in a document');
    const place = await client.ask('locate', { x, z });
    const origin = this.#drawing.origin;
    return { clientX: origin.x + place.x, clientY: origin.y + place.y };
  }

  /** The same of the end face: X a diameter, C in mm. */
  async locateOnFace(x: number, c: number): Promise<{ clientX: number; clientY: number }> {
    const client = this.#client;
    if (client === undefined) throw new Error('the playground is not in a document');
    const place = await client.ask('locateOnFace', { x, c });
    const origin = this.#face.origin;
    return { clientX: origin.x + place.x, clientY: origin.y + place.y };
  }

  /** Opens a file as the program; what it replaces can be brought back with undo. */
  async openFile(file: File): Promise<void> {
    const editor = this.#editor;
    if (editor === undefined) throw new Error('the playground is not in a document');
    const opening = (this.#opening = readProgram(file));
    const opened = await opening;
    const texts = this.#strings;
    // The reader has opened another one since.
    if (this.#opening !== opening) return;
    if (opened.kind === 'too-large') this.#notice.show(texts.fileTooLarge(opened.name));
    else if (opened.kind === 'unreadable') this.#notice.show(texts.fileUnreadable(opened.name));
    else {
      const { name, encoding } = opened.file;
      this.#beginAnother(editor.length);
      // The switches were set for another program, too; who empties the editor still sees them.
      this.blockSkip = this.program = null;
      this.#take(editor, opened.program, opened.file);
      if (opened.binary) this.#notice.show(texts.openedBinary(name));
      else if (encoding === 'utf-8') this.#notice.show(texts.opened(name));
      else this.#notice.show(texts.openedAs(name, ENCODING_NAMES[encoding]));
      this.#changed();
      this.#pasting.arrived();
    }
  }

  /** Saves the program as a file, in the encoding and with the line ends it was opened with. */
  saveFile(): void {
    const { text, file: before } = this.opened;
    const { bytes, file, noPlaceFor } = bytesToSave(text, before);
    download(file.name, bytes);
    if (noPlaceFor === undefined || before === undefined) return;
    if (this.#editor !== undefined) this.#editor.file = file;
    this.#notice.show(this.#strings.savedAsUtf8(file.name, ENCODING_NAMES[before.encoding], noPlaceFor));
    this.#changed();
  }

  #take(editor: Editor, program: ProgramText, file: ProgramFile | undefined): void {
    editor.setText(program, file, editor.length > 0 ? 'undoable' : 'final');
    this.#lengthBefore = editor.length;
    this.#cursorKnown = false;
    this.#textChanged('fit');
  }

  // ---- building -----------------------------------------------------------------------------------

  #build(): void {
    const root = this.shadowRoot ?? this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = sheets;
    const language = this.language;
    const texts = (this.#strings = strings(language));
    const editor = (this.#editor = new Editor(root, language, {
      changed: (how) => {
        this.#cursorKnown = true;
        this.#textEdited(how);
      },
      cursorMoved: () => {
        this.#cursorKnown = true;
        if (this.#sending === undefined) this.#client?.send({ kind: 'cursor', offset: editor.cursor });
      },
      viewMoved: () => void this.#askTokens(),
      fileChanged: () => (this.#fileBar.file = this.#editor?.file),
      pasted: (from, to) => {
        this.#came = 'at-once';
        this.#pasting.arrived(from, to);
      },
    }));
    this.#drawing = new Drawing(texts, {
      resized: (size) => this.#client?.send({ kind: 'resize', size }),
      fit: () => this.#client?.send({ kind: 'fit' }),
      pan: (dx, dy) => this.#client?.send({ kind: 'pan', dx, dy }),
      zoom: (factor, x, y) => this.#client?.send({ kind: 'zoom', factor, x, y }),
      pointed: (x, y) => {
        this.#line?.pointer.ask({ x, y });
        this.#line?.edge.ask({ x, y });
      },
      left: () => {
        this.#line?.pointer.forget();
        this.#line?.edge.forget();
        this.#client?.send({ kind: 'leave-edge' });
        this.#drawing.showEdge(undefined);
        this.#showHovered(undefined);
      },
      clicked: (x, y, keepFocus) => void this.#clicked('pick', x, y, keepFocus),
      companion: () => this.#face,
    });
    this.#buildViews(texts);
    this.#playback = new Playback(texts, {
      play: async (from, seconds, pace, stops) => {
        const place = await this.#client?.ask('play', { from, seconds, pace, stops });
        this.#askSection();
        this.#markRunning(place);
        return place;
      },
      seek: (share) => this.#line?.tool.ask({ share }),
      step: (unit, direction) => {
        editor.follow();
        // The block is shown even if it is the same one.
        this.#running = undefined;
        void this.#client?.ask('step', { unit, direction }).then((place) => this.#showTool(place));
      },
      wholePath: () => this.#line?.tool.ask({ share: undefined }),
    });
    this.#problems = new Problems(texts, {
      chosen: (diagnostic) => editor.show(diagnostic),
      fixed: (edits) => {
        editor.apply(edits);
        // The button that was pressed goes with its problem.
        editor.focus();
      },
    });
    this.#status = new StatusLine(texts, {
      stopped: () => {
        this.#client?.send({ kind: 'stop' });
        editor.focus();
      },
      change: () => void this.#openSetup('control'),
    });
    this.#notice = new Notice(texts);
    this.#fileBar = new FileBar(texts, { chosen: (encoding) => this.#chooseEncoding(encoding) });
    this.#switches = new Switches(texts, {
      skipped: (levels) => this.#turn(() => (this.blockSkip = levels.join(','))),
      chosen: (program) => this.#turn(() => (this.program = String(program))),
    });
    this.#setupBar = new SetupBar(texts, () => void this.#openSetup());
    const readSetup = async (entries: SetupEntries): Promise<SetupAnswer | undefined> =>
      this.#client?.ask('read-setup', { ...entries, json: this.setup ?? '{}' });
    this.#setupForm = new SetupDialog(texts, {
      read: readSetup,
      another: async (word) => this.#client?.ask('another-tool', { word }),
      kept: (answer, place) => this.#keepSetup(answer, place),
    });
    this.#assumedStock = new AssumedStock(texts, {
      form: () => this.#askSetup(),
      read: readSetup,
      taken: (answer, place) => {
        this.#keepSetup(answer, place);
        // The button that was pressed goes.
        this.#setupBar.button.focus();
      },
    });
    this.#codes = new CodesDialog(texts);
    this.#help = new Help(texts, () => void this.#showCodes());
    this.#writtenOut = new WrittenOutDialog(root, texts, {
      wanted: () => void this.#writeOut(),
      taken: (text) => this.#takeOver(text),
    });
    this.#rewrite = new RewriteDialog(texts, {
      wanted: () => void this.#offerRewritings(),
      taken: (rewriting) => this.#writeAsCycle(rewriting),
    });
    this.#exports = new Exports(texts, { chosen: (format) => void this.#export(format) });
    this.#solid = new SolidDialog(texts, { wanted: () => this.#askSection() });
    this.#pasting = new Pasting(texts, {
      client: () => this.#client,
      editor: () => this.#editor,
      language: () => this.language,
      taken: () => (this.#came = 'at-once'),
      notice: (text) => this.#notice.show(text, 'program'),
    });
    this.#views.element.prepend(this.#setupBar.element);
    this.#playback.element.append(this.#drawing.legend, this.#drawing.viewButtons);
    const bar = make('div', { className: 'bar', part: 'bar' }, this.#fileBar.element, this.#switches.element);
    const assumed = make('div', { className: 'assumptions', part: 'assumptions' }, this.#assumedStock.element);
    const frame = make(
      'div',
      { className: 'frame', part: 'frame' },
      make('div', { className: 'written' }, make('slot', { name: 'intro' }), this.#notice.element, bar, editor.element, this.#problems.element),
      make('div', { className: 'shown' }, this.#views.element, assumed, this.#pictures, this.#playback.element),
      make('div', { className: 'foot' }, this.#status.element, this.#status.stop, this.#pasting.button, this.#solid.button, this.#exports.button, this.#rewrite.button, this.#writtenOut.button, this.#help.button),
      this.#help.element,
      this.#writtenOut.element,
      this.#rewrite.element,
      this.#codes.element,
      this.#setupForm.element,
      this.#exports.element,
      this.#solid.element,
      this.#pasting.element,
    );
    root.append(frame);
    acceptFiles(editor.element, {
      hint: () => this.#strings.dropHere,
      dropped: (file) => void this.openFile(file),
    });
    this.addEventListener('keydown', (event) => this.#key(event), { capture: true });
    const { text, file } = this.#early ?? { text: initialProgram(this), file: undefined };
    editor.setText(programText(text), file, 'final');
    this.#lengthBefore = editor.length;
  }

  /** The end face beside the section, and the row that chooses between them. */
  #buildViews(texts: Strings): void {
    const onFace = (what: CanvasCommand): void => this.#client?.send({ kind: 'on-face', what });
    this.#face = new Drawing(
      texts,
      {
        resized: (size) => onFace({ kind: 'resize', size }),
        fit: () => onFace({ kind: 'fit' }),
        pan: (dx, dy) => onFace({ kind: 'pan', dx, dy }),
        zoom: (factor, x, y) => onFace({ kind: 'zoom', factor, x, y }),
        pointed: (x, y) => this.#line?.onFace.ask({ x, y }),
        left: () => {
          this.#line?.onFace.forget();
          this.#showHovered(undefined, this.#face);
        },
        clicked: (x, y, keepFocus) => void this.#clicked('pickOnFace', x, y, keepFocus),
      },
      (words) => words.views.faceDrawing,
    );
    this.#views = new Views(texts, {
      chosen: (pictures) => this.#showPictures(pictures),
      turned: (side) => this.#client?.send({ kind: 'turret', side }),
      kept: () => this.#client?.send({ kind: 'keep' }),
      ended: () => this.#client?.send({ kind: 'end-comparison' }),
    });
    this.#pictures = make('div', { className: 'pictures' }, this.#drawing.element, this.#face.element);
    this.#showPictures('section');
  }

  #showPictures(pictures: Pictures): void {
    this.#drawing.element.hidden = pictures === 'face';
    this.#face.element.hidden = pictures === 'section';
  }

  #key(event: KeyboardEvent): void {
    if (this.#writtenOut.open || this.#rewrite.open || this.#codes.open || this.#setupForm.open || this.#pasting.open) return;
    const inside = event.composedPath()[0];
    const typing = inside instanceof HTMLElement && (inside.isContentEditable || inside.matches('input:not([type=range]), textarea'));
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) this.#playback.toggle();
    else if (event.key.toLowerCase() === 's' && (event.ctrlKey || event.metaKey) && !event.shiftKey && !event.altKey) this.saveFile();
    else if (event.key === 'F9') this.#playback.step(event.ctrlKey || event.metaKey ? 'block' : event.altKey ? 'pass' : 'motion', event.shiftKey ? 'previous' : 'next');
    else if (event.key === 'F8') this.#editor?.nextProblem(event.shiftKey ? 'previous' : 'next');
    else if (event.key === 'Enter' && event.altKey && !(inside instanceof HTMLInputElement)) void this.#offerRewritings();
    else if (event.key === '?' && !typing) this.#help.toggle();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // ---- the worker ---------------------------------------------------------------------------------

  /** The line to the worker, which then knows all that was changed before. */
  get #client(): CoreClient | undefined {
    this.#beginRun();
    return this.#line?.client;
  }

  #connect(): void {
    const client = new CoreClient({
      event: (event) => this.#heard(event),
      pictures: ({ section, face }) => {
        if (section !== undefined) this.#drawing.show(section);
        if (face !== undefined) this.#face.show(face);
      },
      unsettled: () => this.#settling.unsettle(),
      settled: (run) => this.#settling.settle(run),
      lost: (loss) => this.#lost(loss),
    });
    this.#line = {
      client,
      pointer: new Newest(client, 'pick', (stroke) => this.#showHovered(stroke)),
      tool: new Newest(client, 'seek', (place) => this.#showTool(place)),
      section: new Newest(client, 'section', (pieces) => {
        if (pieces !== undefined) this.#solid.section = pieces;
      }),
      onFace: new Newest(client, 'pickOnFace', (stroke) => this.#showHovered(stroke, this.#face)),
      edge: new Newest(client, 'dimension', (edge) =>
        this.#drawing.showEdge(edge === undefined ? undefined : dimensionText(this.#strings, edge))),
    };
    this.#editor?.unsend();
    client.send({ kind: 'language', tag: this.language });
    client.send({ kind: 'canvas', size: this.#drawing.size, palette: this.#drawing.palette });
    client.send({ kind: 'on-face', what: { kind: 'canvas', size: this.#face.size } });
    this.#setupSent = false;
  }

  #heard(event: Heard): void {
    switch (event.kind) {
      case 'report':
        this.#showReport(event.report);
        break;
      case 'progress':
        this.#status.progress(event.work, event.done);
        break;
      case 'views':
        this.#views.state = event.views;
        break;
      case 'switches':
        this.#switches.inText = event.inText;
        break;
    }
  }

  /** A new worker, waiting for the reader's next change: the same text would only fail again. */
  #lost(loss: Loss): void {
    console.error('gcode-playground: the interpreter was lost', loss);
    this.#playback.program(0, 0);
    this.#drawing.summary = undefined;
    this.#writtenOut.available = this.#rewrite.available = this.#exports.available = this.#solid.available = false;
    this.#drawing.showTip(undefined);
    const texts = this.#strings;
    if (loss.kind === 'load-failed') {
      this.#line = undefined;
      this.#status.fail();
      this.#notice.show(texts.loadFailed(loss.reason), 'core');
      return;
    }
    this.#connect();
    this.#status.fail();
    this.#notice.show(loss.kind === 'silent' ? texts.stopped : texts.crashed, 'core');
  }

  /** What is typed quickly goes together. */
  #textEdited(how: 'edited' | 'undone' = 'edited'): void {
    this.#followSetup(how);
    // What comes of the text as it was is of no use from here on.
    this.#outdate();
    clearTimeout(this.#sending);
    this.#sending = setTimeout(() => {
      this.#sendText();
      this.#changed();
    }, SEND_AFTER_MS);
  }

  #sendText(): void {
    this.#textChanged();
    this.#beginRun();
  }

  /** The text is another one: at the end of this turn a run of it begins. */
  #textChanged(framing: 'fit' | 'keep' = 'keep'): void {
    clearTimeout(this.#sending);
    this.#sending = undefined;
    this.#runWanted(framing);
    this.#notice.hide('core');
    this.#notice.hide('program');
  }

  #setupChanged(): void {
    this.#setupSent = false;
    this.#runWanted('keep');
  }

  /** What is changed in one go is run in one go. */
  #runWanted(framing: 'fit' | 'keep'): void {
    const before = this.#changes;
    this.#changes = { framing: before?.framing === 'fit' ? 'fit' : framing };
    this.#outdate();
    if (before === undefined) queueMicrotask(() => this.#beginRun());
  }

  /** What belongs to the run that was shown must not meet the text or the setup of now. */
  #outdate(): void {
    this.#line?.client.outdate();
    this.#playback.pause();
    this.#drawing.showTip(undefined);
    this.#drawing.showEdge(undefined);
    this.#face.showTip(undefined);
    if (this.#hovered === undefined) return;
    this.#hovered = undefined;
    if (this.#editor !== undefined) this.#editor.hovered = undefined;
  }

  #beginRun(): void {
    const [changes, client, editor] = [this.#changes, this.#line?.client, this.#editor];
    if (changes === undefined || client === undefined || editor === undefined) return;
    this.#changes = undefined;
    const setup = this.#setupSent ? undefined : this.#mergedSetup();
    this.#setupSent = true;
    const text = editor.takeUnsent();
    const came = this.#came;
    this.#came = 'typed';
    client.begin({ setup, text, came, framing: changes.framing, cursor: this.#cursorKnown ? editor.cursor : undefined });
    if (text !== undefined) void this.#askTokens();
  }

  /** The setup as the attributes have it; nothing where it cannot be read. */
  #mergedSetup(): string | undefined {
    const { control, blockSkip, program } = this;
    const merged = mergedSetup(this.setup, { control, blockSkip, program });
    this.#switches.state = switchesSet(merged);
    this.#setupUnreadable = merged.kind === 'unreadable' ? merged.reason : undefined;
    return merged.kind === 'setup' ? merged.json : undefined;
  }

  async #askTokens(): Promise<void> {
    const editor = this.#editor;
    const line = this.#line;
    // While an edit waits to be sent, the worker would colour older text.
    if (editor === undefined || line === undefined || this.#sending !== undefined) return;
    const lines = editor.linesInSight;
    if (lines === undefined) return;
    const { revision } = editor;
    const tokens = await line.client.ask('tokens', lines);
    if (tokens !== undefined && editor.revision === revision) editor.tokens = tokens;
  }

  async #clicked(about: 'pick' | 'pickOnFace', x: number, y: number, keepFocus: boolean): Promise<void> {
    const stroke = await this.#client?.ask(about, { x, y });
    if (stroke === undefined) return;
    this.#cursorKnown = true;
    this.#editor?.select(stroke);
    if (!keepFocus) this.#editor?.focus();
    this.#client?.send({ kind: 'cursor', offset: stroke.from });
    this.#fire('gcode-select', { stroke });
  }

  async #writeOut(): Promise<void> {
    const editor = this.#editor;
    const line = this.#line;
    if (editor === undefined || line === undefined) return;
    // What was typed a moment ago is written out too.
    if (this.#sending !== undefined) {
      this.#sendText();
      this.#changed();
    }
    const { revision } = editor;
    const written = await line.client.ask('expand', undefined);
    if (written !== undefined && editor.revision === revision) this.#writtenOut.show(written, editor.text);
  }

  async #offerRewritings(): Promise<void> {
    const editor = this.#editor;
    const line = this.#line;
    if (editor === undefined || line === undefined || !this.#rewrite.available) return;
    if (this.#sending !== undefined) {
      this.#sendText();
      this.#changed();
    }
    const { revision } = editor;
    const rewritings = await line.client.ask('rewritings', editor.selection);
    if (rewritings !== undefined && editor.revision === revision) this.#rewrite.show(rewritings);
  }

  #writeAsCycle({ edits, cycle }: Rewriting): void {
    this.#editor?.change(edits);
    this.#sendText();
    this.#notice.show(this.#strings.rewrite.took(cycle), 'program');
    this.#editor?.focus();
    this.#changed();
  }

  /** Only while it is looked at. */
  #askSection(): void {
    if (this.#solid.open) this.#line?.section.ask(undefined);
  }

  async #export(format: FileFormat): Promise<void> {
    if (this.#sending !== undefined) {
      this.#sendText();
      this.#changed();
    }
    const content = await this.#client?.ask('export', { format });
    if (content === undefined) {
      this.#notice.show(this.#strings.noPartToExport);
      return;
    }
    const file = this.file;
    const name = exportName(file?.name, format);
    // A program is written in the encoding of its file, as "Save file" does.
    const asProgram = file !== undefined && format === 'program';
    download(name, asProgram ? bytesToSave(new TextDecoder().decode(content), { ...file, name }).bytes : content);
  }

  async #showCodes(): Promise<void> {
    const codes = await this.#client?.ask('codes', undefined);
    if (codes !== undefined) this.#codes.show(codes);
  }

  /** The written out program takes the place of the one in the editor, which undo brings back. */
  #takeOver(text: string): void {
    this.#editor?.rewrite(text);
    this.#cursorKnown = false;
    this.#sendText();
    this.#notice.show(this.#strings.tookOver, 'program');
    this.#editor?.focus();
    this.#changed();
  }

  // ---- the file and the switches ------------------------------------------------------------------

  #chooseEncoding(encoding: Encoding): void {
    const editor = this.#editor;
    const file = editor?.file;
    if (editor === undefined || file === undefined) return;
    const texts = this.#strings;
    const [chosen, present] = [ENCODING_NAMES[encoding], ENCODING_NAMES[file.encoding]];
    const answer = reread(editor.textWithLineEnds, file.encoding, encoding);
    switch (answer.kind) {
      case 'text':
        this.opened = { text: answer.text, file: { ...file, encoding } };
        this.#notice.show(texts.rereadAs(chosen));
        break;
      case 'kept':
        editor.file = { ...file, encoding };
        this.#notice.show(texts.savedFromNowAs(chosen));
        break;
      case 'not-this-encoding':
        this.#notice.show(texts.notThisEncoding(file.name, chosen, present));
        return;
      case 'no-place':
        this.#notice.show(texts.noPlace(answer.character, chosen, present));
        return;
    }
    this.#changed();
  }

  // ---- the setup ----------------------------------------------------------------------------------

  async #openSetup(opened?: SetupGroup['group']): Promise<void> {
    const form = await this.#askSetup();
    if (form !== undefined) this.#setupForm.show(form, opened);
  }

  async #askSetup(): Promise<SetupForm | undefined> {
    // What was typed a moment ago counts too.
    if (this.#sending !== undefined) {
      this.#sendText();
      this.#changed();
    }
    return this.#client?.ask('setup-form', undefined);
  }

  #keepSetup({ setup, edits }: SetupAnswer, place: SetupPlace): void {
    this.#editor?.change(edits);
    const texts = this.#strings.setup.kept;
    this.#changeSetup(setup === '' ? null : setup);
    this.#notice.show(place === 'program' ? texts.program : texts.page, 'program-setup');
  }

  #changeSetup(setup: string | null): void {
    if (this.setup === setup) return;
    this.setup = setup;
    this.#fire('gcode-setup', { setup });
  }

  /** The setup was made for another program; only the control stays. */
  #beginAnother(length: number): void {
    const { setup, blockSkip, program } = this;
    this.#before = { length, setup, blockSkip, program };
    // Where there is an attribute for the control, it stays by itself.
    this.#changeSetup(this.control === null ? neutralSetup(setup) : null);
  }

  /** An emptied editor begins another program; undo brings back the one before, and how it was run. */
  #followSetup(how: 'edited' | 'undone'): void {
    const length = this.length;
    if (length === 0 && how === 'edited') this.#beginAnother(this.#lengthBefore);
    else if (how === 'undone' && this.#before?.length === length) {
      const { setup, blockSkip, program } = this.#before;
      this.#before = undefined;
      this.blockSkip = blockSkip;
      this.program = program;
      this.#changeSetup(setup);
    }
    this.#lengthBefore = length;
  }

  #turn(turn: () => void): void {
    turn();
    this.#fire('gcode-switch', { blockSkip: this.blockSkip, program: this.program });
  }

  // ---- showing ------------------------------------------------------------------------------------

  #showReport(report: Report): void {
    const { summary, diagnostics, fitted, decimal, stage, views, switches } = report;
    const setupRejected = this.#setupUnreadable ?? report.setupRejected;
    if (setupRejected === undefined) this.#notice.hide('setup');
    else this.#notice.show(this.#strings.setupRejected(setupRejected), 'setup');
    if (views !== undefined) this.#views.state = views;
    if (switches !== undefined) this.#switches.inText = switches;
    this.#status.show(summary, decimal);
    this.#drawing.summary = summary;
    this.#setupBar.fitted = this.#assumedStock.fitted = fitted;
    this.#writtenOut.available = this.#rewrite.available = this.#exports.available = this.#solid.available = summary.finished && summary.motions > 0;
    this.#askSection();
    this.#problems.diagnostics = diagnostics;
    // The path was there before, and the reader may be playing it.
    if (stage === 'whole' || stage === 'path') {
      this.#playback.program(summary.motions, summary.optionalStops);
      this.#showTool(undefined);
    } else if (stage === 'again' && this.#playback.place !== undefined) {
      void this.#client?.ask('readout', undefined).then((place) => this.#showTool(place));
    }
    if (this.#editor !== undefined) this.#editor.diagnostics = diagnostics;
    this.#drawing.lookAgain();
    this.#face.lookAgain();
    this.#fire<{ summary: Summary; diagnostics: Report['diagnostics'] }>('gcode-report', { summary, diagnostics });
  }

  #showHovered(stroke: Stroke | undefined, where = this.#drawing): void {
    where.showTip(stroke);
    if (stroke?.motion === this.#hovered) return;
    this.#hovered = stroke?.motion;
    this.#client?.send({ kind: 'hover', motion: stroke?.motion });
    if (this.#editor !== undefined) this.#editor.hovered = stroke;
  }

  #showTool(place: Readout | undefined): void {
    this.#playback.place = place;
    this.#askSection();
    this.#markRunning(place);
  }

  /** The block that runs, or that holds the tool, is marked in the text. */
  #markRunning(place: Readout | undefined): void {
    const block = place?.stop ?? place?.stroke;
    if (block?.from === this.#running) return;
    this.#running = block?.from;
    if (this.#editor !== undefined) this.#editor.running = block;
  }

  #showLanguage(): void {
    const language = this.language;
    const texts = (this.#strings = strings(language));
    for (const shown of [
      this.#drawing, this.#face, this.#views, this.#playback, this.#problems, this.#status, this.#notice, this.#fileBar, this.#switches, this.#help,
      this.#writtenOut, this.#rewrite, this.#codes, this.#setupBar, this.#setupForm, this.#assumedStock, this.#exports, this.#solid, this.#pasting,
    ]) {
      shown.strings = texts;
    }
    if (this.#editor !== undefined) this.#editor.language = language;
    this.#client?.send({ kind: 'language', tag: language });
    if (this.#codes.open) void this.#showCodes();
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

  #setOrRemove(attribute: string, value: string | null): void {
    if (value === null) this.removeAttribute(attribute);
    else this.setAttribute(attribute, value);
  }
}

if (customElements.get('gcode-playground') === undefined) customElements.define('gcode-playground', GcodePlayground);
