// The shell: connects the editor, the panels, the worker and the page.
//
// In: input of the user, events of the worker. Out: the same to the panels; attributes and events of the host element.
// It knows the panels from `panels/index.ts` and, in views that show more than the picture, `panels/further.ts`, which
// is loaded later. Must not know: G-code. The interpreter, behind core-client.ts, handles the meaning of a program.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Span } from '../editor/text-store';
import { Program } from '../editor/program';
import { programText, type ProgramFile, type ProgramText } from '../editor/program-text';
import { ALWAYS, PICTURES } from '../panels/index';
import type { NewestQuestion, Region, Services, Shell, UserCommand } from '../panels/panel';
import type {
  Answer,
  Command,
  CompletionHelp,
  Diagnostic,
  HelpRequest,
  QuestionKind,
  Questions,
  Readout,
  Stroke,
} from '../protocol/protocol';
import type { Step } from './author';
import { AuthorSettings } from './author-settings';
import { strokeInFile } from './file-offsets';
import { HostContext } from './host-context';
import { createLayout, VIEW_CONTENTS, type Layout, type OptionalService, type View } from './layout';
import { initialParts, LateLoading } from './late-loading';
import { Missing } from './missing';
import { PanelSet } from './panel-set';
import { Paper } from './paper';
import { PendingParts } from './pending-parts';
import { completionAt, wordAt } from './place-help';
import { RunReports } from './run-reports';
import { Runs } from './runs';
import { adoptStyles } from './style-sheets';

/** The element, whose attributes set how the program is run. */
interface Host {
  readonly language: Language;
  readonly view: View;
  readonly controls: string | null;
  readonly readonly: boolean;
  readonly highlight: string | null;
  readonly lines: string | null;
  readonly step: string | null;
  readonly fit: string | null;
  readonly turret: string | null;
  readonly caption: string | null;
  readonly playground: string | null;
  readonly value: string;
  getAttribute(name: string): string | null;
  control: string | null;
  setup: string | null;
  blockSkip: string | null;
  program: string | null;
  origin: string | null;
}

/** Events for the page. */
interface ShellEvents {
  fire<Detail>(type: string, detail: Detail): void;
  /** The user has changed the program or its file. */
  onChange(): void;
  /** Something that may change the display is in progress. */
  onUnsettled(): void;
  /** Everything of this run is shown. */
  onSettled(run: number): void;
}

export class PlaygroundShell implements Shell {
  readonly root: ShadowRoot;
  readonly editor: Program;
  readonly view: View;
  readonly readonly: boolean;
  readonly frame: HTMLElement;
  readonly #host: Host;
  readonly #events: ShellEvents;
  readonly #layout: Layout;
  readonly #panels: PanelSet;
  readonly #author: AuthorSettings;
  readonly #paper: Paper;
  readonly #context: HostContext;
  readonly #runs: Runs;
  readonly #reports: RunReports;
  readonly #darkScheme = matchMedia('(prefers-color-scheme: dark)');
  #language: Language;
  readonly #pending: PendingParts;
  readonly #late: LateLoading;
  readonly #help = {
    revision: () => this.editor.revision,
    ask: (request: HelpRequest) => this.ask('help', request),
  };
  readonly #missing: Missing;
  constructor(root: ShadowRoot, host: Host, events: ShellEvents) {
    this.root = root;
    this.#host = host;
    this.#events = events;
    this.#language = host.language;
    this.#missing = new Missing(this.#language, {
      show: (text, action) => this.service('notice')(text, 'missing', action),
      hide: () => this.service('hideNotice')('missing'),
    });
    this.view = host.view;
    this.readonly = host.readonly;
    this.#pending = new PendingParts(initialParts(this.view, host.playground), {
      step: () => host.step,
      complete: () => this.complete,
      moveTool: (step) => this.#moveTool(step),
      onUnsettled: () => events.onUnsettled(),
      onSettled: (run) => events.onSettled(run),
    });
    this.#late = new LateLoading({
      view: this.view,
      missing: this.#missing,
      pending: this.#pending,
      addPanels: ({ FURTHER, SHARED_STYLES }) => {
        adoptStyles(root, SHARED_STYLES);
        this.#panels.addLast(FURTHER, this, this.editor.file, this.#reports.hasFailed);
      },
      loadEditor: () => this.editor.loadEditor(root),
    });
    this.#context = new HostContext(host, {
      defaultSetup: () => this.#panels.findService('defaultSetup')?.() ?? null,
      onReplaced: () => this.#panels.notify((panel) => panel.onProgramReplaced?.('user')),
      onSwitches: (switches) => this.#panels.onSwitchesChanged(switches),
      fire: (type, detail) => events.fire(type, detail),
    });
    this.editor = new Program(this.#language, host.readonly ? 'readonly' : 'editable', {
      onTextChanged: (input) => {
        this.#pending.dropStep();
        if (input === 'typed') this.#reports.onTyped();
        this.#runs.onTyped();
      },
      context: () => this.#context.current,
      neutral: () => this.#context.neutral,
      onContextChanged: (context) => {
        this.#runs.onProgramReplaced();
        this.#context.replace(context);
      },
      onCursorMoved: () => {
        this.#runs.cursorMoved();
        this.#reports.onCursorMoved();
        this.#panels.notify((panel) => panel.onCursorMoved?.());
      },
      onTrialChanged: () => {
        this.#runs.requestRun('keep');
        this.#panels.notify((panel) => panel.onTrialChanged?.());
      },
      wordAt: (offset) => wordAt(this.#help, offset),
      completionAt: (offset, isExplicit) => this.completionAt(offset, isExplicit),
      onShowProgram: () => this.#panels.notify((panel) => panel.onShowProgram?.()),
      onCompletionFailed: (reason, retry) => this.#missing.markFailed('completion', reason, retry),
      onCompletionLoaded: () => this.#missing.markLoaded('completion'),
      onSettingChosen: (setting) => this.service('applySetting')(setting),
      onViewMoved: () => void this.#runs.askTokens(),
      onFileChanged: () => this.#panels.notify((panel) => panel.onFileChanged?.(this.editor.file)),
      onPasted: (from, to) => {
        this.markAsInserted();
        this.#panels.notify((panel) => panel.onTextInserted?.(from, to));
      },
    });
    this.#runs = new Runs(this.editor, {
      setup: () => this.#context.mergedSetup(),
      onEvent: (event) => {
        this.#reports.onEvent(event);
        this.#late.onEvent(event);
      },
      onPictures: (pictures, scale) => {
        this.#panels.notify((panel) => panel.onPictures?.(pictures, scale));
        this.#layout.fallback.hidden = true;
        this.#late.loadEditorIfShown();
      },
      onInputChanged: () => this.#reports.onInputChanged(),
      onTextChanged: () => this.service('hideNotice')('program'),
      onRunRequested: () => this.#missing.onEdit(),
      onRunStarted: () => this.#reports.onRunStarted(),
      onSent: () => events.onChange(),
      onReady: () => this.#late.onReady(),
      onConnected: (client) => {
        this.#missing.markLoaded('parts');
        client.send({ kind: 'language', tag: this.#language });
        this.#author.sendInitial((command) => client.send(command));
        this.#panels.notify((panel) => panel.onWorkerConnected?.((command) => client.send(command)));
      },
      onLost: (loss) => {
        this.#reports.onLost(loss);
        this.#late.loadEditorIfShown();
      },
      onUnsettled: () => this.#pending.onRunUnsettled(),
      onSettled: (run) => {
        this.editor.flushDecorations();
        this.#pending.onRunSettled(run);
        void this.#late.loadLink(host, this.frame);
      },
    });
    const layout = (this.#layout = createLayout(this.view, this.editor.element));
    this.frame = layout.frame;
    this.#author = new AuthorSettings(host, this.editor, layout);
    const { view, controls, readonly, language } = host;
    this.#panels = new PanelSet({ root, regions: layout.regions, view, controls, readonly, language });
    // Before the editor is loaded, too.
    this.editor.element.addEventListener('keydown', () => this.#missing.onEdit());
    this.#reports = new RunReports({
      editor: this.editor,
      panels: this.#panels,
      missing: this.#missing,
      readonly,
      language: () => this.#language,
      setupError: () => this.#context.setupError,
      loadParts: () => this.send({ kind: 'load-parts' }),
      restart: () => this.#runs.restart(),
      fire: (type, detail) => events.fire(type, detail),
    });
    this.#panels.add(VIEW_CONTENTS[view].picture ? PICTURES : ALWAYS, this);
    this.authorChanged();
    this.#paper = new Paper((from, to) => this.editor.textBetween(from, to));
    layout.container.append(this.#paper.element);
    root.append(layout.container);
    // The panels have a better print layout.
    this.#late.loadPanels(() => this.#paper.end());
  }

  /** Resolved when all panels of the view are loaded; rejected if they could not be loaded. */
  get complete(): Promise<void> {
    return this.#late.panels;
  }

  // ---- for the element ----------------------------------------------------------------------------

  connect(): void {
    this.#darkScheme.addEventListener('change', this.coloursChanged);
    this.#paper.connect();
    this.#runs.connect();
    this.#runs.requestRun('keep');
    this.#missing.retryAll();
    this.stepChanged();
  }

  disconnect(): void {
    this.#darkScheme.removeEventListener('change', this.coloursChanged);
    this.#paper.disconnect();
    this.#missing.cancelRetries();
    this.#reports.disconnect();
    this.#panels.notify((panel) => panel.onDisconnected?.());
    this.#runs.end();
  }

  languageChanged(): void {
    this.#language = this.#host.language;
    this.#late.updateLink();
    this.#author.showCaption(this.#language);
    this.#missing.language = this.#language;
    // Answers to questions that a panel asks from now on are in this language.
    this.send({ kind: 'language', tag: this.#language });
    this.#panels.language = this.#language;
    this.editor.language = this.#language;
  }

  /** Applies the author's attributes for lines, picture and caption. */
  authorChanged(): void {
    this.#author.apply((command) => this.send(command));
    this.#late.updateLink();
    this.#author.showCaption(this.#language);
  }

  refit(): void {
    this.#author.sendFrame((command) => this.send(command));
  }

  /** The attribute `step` has changed. */
  stepChanged(): void {
    this.#pending.stepChanged();
  }

  async #moveTool(step: Step): Promise<void> {
    if (step.kind === 'motion') {
      const goTo = this.#panels.findService('goTo');
      await (goTo?.(step.motion) ?? this.ask('go-to', { motion: step.motion }));
      return;
    }
    const offset = this.editor.startOfLine(step.line);
    if (offset === undefined) return;
    const goToBlock = this.#panels.findService('goToBlock');
    await (goToBlock?.(offset) ?? this.ask('seek-block', { offset }));
  }

  readonly coloursChanged = (): void => this.#panels.notify((panel) => panel.onColoursChanged?.());

  setupChanged(): void {
    this.#runs.setupChanged();
  }

  /** Sets the initial program. */
  start(text: string, file: ProgramFile | undefined): void {
    this.editor.setText(programText(text), file, 'final');
  }

  /** The program of the element was loaded from its address, or has changed in the page. */
  programLoaded(text: string, file: ProgramFile | undefined): void {
    this.editor.setText(programText(text), file, this.editor.length > 0 ? 'undoable' : 'final');
    this.service('hideNotice')('source');
    this.#runs.resetCursor();
    this.#runs.textChanged('fit');
    this.stepChanged();
    this.#pending.finish('program');
  }

  /** The program is being loaded: the element cannot settle before. */
  programLoading(address: string, how: 'started' | 'slow'): void {
    if (how === 'slow') return this.service('notice')(WORDS[this.#language].programLoading(address), 'source');
    this.#pending.add('program');
  }

  programFailed(address: string, reason: string, retry: () => void): void {
    const texts = WORDS[this.#language];
    this.service('notice')(texts.programFailed(address, reason), 'source', { title: texts.tryAgain, act: retry });
    this.#pending.finish('program');
  }

  /** Sets another text without an event for the page; the attributes stay. */
  setProgram(program: ProgramText, file: ProgramFile | undefined): void {
    const { editor } = this;
    editor.setText(program, file, editor.length > 0 ? 'undoable' : 'final', this.#context.current);
    this.#panels.notify((panel) => panel.onProgramReplaced?.('host'));
    // A notice about a file does not apply to this program.
    this.service('hideNotice')('file');
    this.#runs.resetCursor();
    this.#runs.textChanged('fit');
  }

  handleKey(event: KeyboardEvent): void {
    this.#panels.handleKey(event);
  }

  // ---- for the panels -----------------------------------------------------------------------------

  get language(): Language {
    return this.#language;
  }

  get commands(): readonly UserCommand[] {
    return this.#panels.commands;
  }

  get diagnostics(): readonly Diagnostic[] {
    return this.#reports.diagnostics;
  }

  get setup(): string | null {
    return this.#host.setup;
  }

  get showsProgram(): boolean {
    return VIEW_CONTENTS[this.view].program;
  }

  offers(name: OptionalService): boolean {
    return VIEW_CONTENTS[this.view].offers.includes(name);
  }

  region(region: Region): HTMLElement {
    return this.#panels.regions[region];
  }

  service<S extends keyof Services>(name: S): Services[S] {
    return this.#panels.service(name);
  }

  hasService(name: keyof Services): boolean {
    return this.#panels.findService(name) !== undefined;
  }

  send(command: Command): void {
    this.#runs.client?.send(command);
  }

  async ask<K extends QuestionKind>(about: K, ask: Questions[K]['args']): Promise<Answer<K> | undefined> {
    return this.#runs.client?.ask(about, ask);
  }

  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K> {
    return this.#runs.newest(about, answered);
  }

  flush(): void {
    this.#runs.flush();
  }

  commitEdit(): void {
    this.#runs.send();
  }

  rewrite(text: string): void {
    this.editor.rewrite(text);
    this.#runs.resetCursor();
    this.#runs.send();
  }

  replaceProgram(program: ProgramText, file: ProgramFile | undefined, as: 'another' | 'same'): void {
    if (as === 'another') {
      const context = this.#context.neutral;
      this.editor.setText(program, file, 'undoable', context);
      this.#context.replace(context);
    } else this.editor.setText(program, file, 'undoable');
    this.#runs.resetCursor();
    this.#runs.textChanged('fit');
    this.notifyFileChanged();
    if (as === 'another') this.#panels.notify((panel) => panel.onTextInserted?.(0, this.editor.length));
  }

  addStyles(styles: string): void {
    adoptStyles(this.root, [styles]);
  }

  notifyFileChanged(): void {
    this.#events.onChange();
  }

  markAsInserted(): void {
    this.#runs.markAsInserted();
  }

  goTo(span: Span): void {
    this.editor.select(span);
    this.editor.focus();
    this.#onCursorSet(span.from);
  }

  chooseStroke(stroke: Stroke, focus: 'focus' | 'keep-focus'): void {
    this.editor.select(stroke);
    if (focus === 'focus') this.editor.focus();
    this.#onCursorSet(stroke.from);
    this.#events.fire('gcode-select', { stroke: strokeInFile(stroke, this.editor) });
  }

  chooseProblem(problem: Diagnostic): void {
    this.editor.selectProblem(problem);
    this.#onCursorSet(problem.from);
  }

  async completionAt(offset: number, isExplicit: boolean): Promise<CompletionHelp | undefined> {
    this.flush();
    return completionAt(this.#help, offset, isExplicit);
  }

  /** The page has moved the cursor on behalf of the user. */
  #onCursorSet(offset: number): void {
    this.#runs.setCursor(offset);
    this.#panels.notify((panel) => panel.onCursorMoved?.());
  }

  notifyToolMoved(place: Readout | undefined): void {
    this.#panels.notify((panel) => panel.onToolMoved?.(place));
  }

  changeSetup(setup: string | null): void {
    this.#context.changeSetup(setup);
  }

  setSwitches(switches: { readonly blockSkip?: string; readonly program?: string }): void {
    this.#context.setSwitches(switches);
  }

  // ---- between them -------------------------------------------------------------------------------
}

const WORDS = words({
  en: {
    programLoading: (address: string) => `The program is being loaded: ${address}`,
    programFailed: (address: string, reason: string) => `The program could not be loaded from ${address} (${reason}).`,
    tryAgain: 'Try again',
  },
  zh: {
    programLoading: (address) => `正在加载程序：${address}`,
    programFailed: (address, reason) => `无法从 ${address} 加载程序（${reason}）。`,
    tryAgain: '重试',
  },
  ru: {
    programLoading: (address) => `Программа загружается: ${address}`,
    programFailed: (address, reason) => `Не удалось загрузить программу ${address} (${reason}).`,
    tryAgain: 'Повторить',
  },
});
