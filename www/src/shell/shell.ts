// The shell: connects the editor, the panels, the worker and the page.
//
// In: input of the user, events of the worker. Out: the same to the panels; attributes and events of the host element.
// It knows the panels from `panels/index.ts` and, in views that show more than the picture, `panels/further.ts`, which
// is loaded later. Must not know: G-code. The interpreter, behind core-client.ts, handles the meaning of a program.

import type { Language } from '../dom/language';
import { Program } from '../editor/program';
import { programText, type ProgramFile, type ProgramText } from '../editor/program-text';
import { ALWAYS, PICTURES } from '../panels/index';
import type { UserCommand } from '../panels/panel';
import type { Readout } from '../protocol/protocol';
import { AuthorSettings } from './author-settings';
import { AutoHeight } from './auto-height';
import { HostContext } from './host-context';
import { HostPlayback } from './host-playback';
import { createLayout, VIEW_CONTENTS, type OptionalMethod, type View } from './layout';
import { initialParts, LateLoading } from './late-loading';
import { Missing, type HostError } from './missing';
import { PanelSet } from './panel-set';
import { Paper } from './paper';
import { PendingParts } from './pending-parts';
import { RunReports, type Checked } from './run-reports';
import { Runs } from './runs';
import { toolTarget, type SeekTarget, type ToolTarget } from './seek';
import { ShellForPanels } from './shell-for-panels';
import { showFailedLoad, showSlowLoad } from './source-notice';
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
  readonly annotate: string | null;
  readonly calculator: string | null;
  readonly exercise: string | null;
  readonly caption: string | null;
  readonly playground: string | null;
  readonly value: string;
  readonly marksPrograms: boolean;
  readonly height: string | null;
  readonly rowsMin: string | null;
  readonly rowsMax: string | null;
  get speed(): string | null;
  set speed(speed: string | number | null);
  getAttribute(name: string): string | null;
  control: string | null;
  setup: string | null;
  blockSkip: string | null;
  program: string | null;
  origin: string | null;
}

/** Events for the page. */
interface ShellEvents {
  readonly fire: <Detail>(type: string, detail: Detail) => void;
  /** The user has changed the program or its file. */
  readonly onChange: () => void;
  /** Something that may change the display is in progress. */
  readonly onUnsettled: () => void;
  /** Everything of this run is shown. */
  readonly onSettled: (run: number) => void;
}

export class PlaygroundShell {
  readonly editor: Program;
  readonly view: View;
  readonly forPanels: ShellForPanels;
  readonly #host: Host;
  readonly #fire: ShellEvents['fire'];
  readonly #panels: PanelSet;
  readonly #author: AuthorSettings;
  readonly #paper: Paper;
  readonly #context: HostContext;
  readonly #runs: Runs;
  readonly #reports: RunReports;
  readonly playback: HostPlayback;
  readonly #darkScheme = matchMedia('(prefers-color-scheme: dark)');
  #language: Language;
  readonly #pending: PendingParts;
  readonly #late: LateLoading;
  readonly #missing: Missing;
  readonly #height: AutoHeight;

  constructor(root: ShadowRoot, host: Host, events: ShellEvents) {
    const { fire, onChange, onUnsettled, onSettled } = events;
    this.#host = host;
    this.#fire = fire;
    this.#language = host.language;
    this.#missing = new Missing(this.#language, {
      show: (text, action) => this.#panels.service('notice')(text, 'missing', action),
      hide: () => this.#panels.service('hideNotice')('missing'),
      onFailed: (error) => fire('gcode-error', error),
    });
    this.view = host.view;
    this.#pending = new PendingParts(initialParts(this.view, host.playground), {
      step: () => host.step,
      complete: () => this.complete,
      moveTool: (step) => this.#moveTool(step),
      onUnsettled,
      onSettled,
    });
    this.#late = new LateLoading({
      view: this.view,
      missing: this.#missing,
      pending: this.#pending,
      addPanels: ({ FURTHER, SHARED_STYLES }) => {
        adoptStyles(root, SHARED_STYLES);
        this.#panels.addLast(FURTHER, this.forPanels, this.editor.file, this.#reports.hasFailed);
      },
      loadEditor: () => this.editor.loadEditor(root),
    });
    this.#context = new HostContext(host, {
      defaultSetup: () => this.#panels.findService('defaultSetup')?.() ?? null,
      onReplaced: () => this.#panels.notify((panel) => panel.onProgramReplaced?.('user')),
      onSwitches: (switches) => this.#panels.onSwitchesChanged(switches),
      fire,
    });
    this.editor = new Program(this.#language, host.readonly ? 'readonly' : 'editable', {
      onTextChanged: (input) => {
        this.#pending.dropStep();
        if (input === 'typed') this.#reports.onTyped();
        this.#runs.onTyped();
        this.forPanels.notifyCursor();
      },
      context: () => this.#context.current,
      neutral: () => this.#context.neutral,
      typedCanReplace: () => this.#context.marksPrograms,
      onContextChanged: (context) => {
        this.#runs.onProgramReplaced();
        this.#context.replace(context);
      },
      onCursorMoved: () => {
        this.#runs.cursorMoved();
        this.#reports.onCursorMoved();
        this.#panels.notify((panel) => panel.onCursorMoved?.());
        this.forPanels.notifyCursor();
      },
      onTrialChanged: () => {
        this.#runs.requestRun('keep');
        this.#panels.notify((panel) => panel.onTrialChanged?.());
      },
      help: () => this.forPanels,
      onShowProgram: () => this.#panels.notify((panel) => panel.onShowProgram?.()),
      onCompletionFailed: (reason, retry) => this.#missing.markFailed('completion', reason, retry),
      onCompletionLoaded: () => this.#missing.markLoaded('completion'),
      onSettingChosen: (setting) => this.#panels.service('applySetting')(setting),
      onViewMoved: () => void this.#runs.askTokens(),
      onFileChanged: () => this.#panels.notify((panel) => panel.onFileChanged?.(this.editor.file)),
      onPasted: (from, to) => {
        this.#runs.markAsInserted();
        this.#panels.notify((panel) => panel.onTextInserted?.(from, to));
      },
    });
    this.playback = new HostPlayback({ editor: this.editor, fire });
    const layout = createLayout(this.view, this.editor.element);
    this.#height = new AutoHeight({ root, host, layout, editor: this.editor, pending: this.#pending });
    this.#runs = new Runs(this.editor, {
      setup: () => this.#context.mergedSetup(),
      onEvent: (event) => {
        this.#reports.onEvent(event);
        this.#late.onEvent(event);
      },
      onPictures: (pictures, scale) => {
        this.#panels.notify((panel) => panel.onPictures?.(pictures, scale));
        layout.fallback.hidden = true;
        this.#late.loadEditorIfShown();
      },
      onInputChanged: () => {
        this.#reports.onInputChanged();
        this.playback.onInputChanged();
        this.#height.update();
      },
      onTextChanged: () => this.#panels.service('hideNotice')('program'),
      onRunRequested: () => this.#missing.onEdit(),
      onRunStarted: () => this.#reports.onRunStarted(),
      onSent: onChange,
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
        this.#height.update();
        this.#pending.onRunSettled(run);
        void this.#late.loadLink(host, layout.frame);
      },
    });
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
      loadParts: () => this.forPanels.send({ kind: 'load-parts' }),
      restart: () => this.#runs.restart(),
      fire,
    });
    this.forPanels = new ShellForPanels({
      root,
      frame: layout.frame,
      editor: this.editor,
      readonly,
      language: () => this.#language,
      showsProgram: VIEW_CONTENTS[view].program,
      panels: this.#panels,
      runs: this.#runs,
      reports: this.#reports,
      context: this.#context,
      author: this.#author,
      playback: this.playback,
      fire,
      onChange,
    });
    this.#panels.add(VIEW_CONTENTS[view].picture ? PICTURES : ALWAYS, this.forPanels);
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
    this.#height.connect();
    this.#runs.connect();
    this.#runs.requestRun('keep');
    this.#missing.retryAll();
    this.stepChanged();
  }

  disconnect(): void {
    this.#darkScheme.removeEventListener('change', this.coloursChanged);
    this.#paper.disconnect();
    this.#height.disconnect();
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
    this.forPanels.send({ kind: 'language', tag: this.#language });
    this.#panels.language = this.#language;
    this.editor.language = this.#language;
  }

  /** Applies the author's attributes for lines, picture and caption. */
  authorChanged(): void {
    this.#author.apply((command) => this.forPanels.send(command));
    this.#late.updateLink();
    this.#author.showCaption(this.#language);
  }

  /** The attribute `step` has changed. */
  stepChanged(): void {
    this.#pending.stepChanged();
  }

  /** The attribute `height`, `rows-min` or `rows-max` has changed. */
  heightChanged(): void {
    this.#height.changed();
  }

  /** The attribute `speed` has changed. */
  speedChanged(): void {
    this.#panels.notify((panel) => panel.onSpeedChanged?.());
  }

  /** The result of the current program; undefined until it is reported. */
  get checked(): Checked | undefined {
    return this.#reports.checked;
  }

  /** Moves the tool when the current program has run. Returns its position, with offsets into `opened.text`. */
  async seek(to: SeekTarget | null): Promise<Readout | undefined> {
    const target = toolTarget(to);
    await this.complete.catch(() => undefined);
    this.forPanels.flush();
    await this.#reports.whenReported();
    await this.#moveTool(target);
    return this.playback.readout;
  }

  async #moveTool(target: ToolTarget): Promise<void> {
    const answer = this.#askForTool(target);
    if (answer === undefined) return;
    const moveTool = this.#panels.findService('moveTool');
    if (moveTool === undefined) this.forPanels.notifyToolMoved(await answer);
    else await moveTool(answer);
  }

  /** Undefined if there is no such line. */
  #askForTool(target: ToolTarget): Promise<Readout | undefined> | undefined {
    switch (target.kind) {
      case 'motion':
        return this.forPanels.ask('go-to', { motion: target.motion });
      case 'share':
        return this.forPanels.ask('seek', { share: target.share });
      case 'whole':
        return this.forPanels.ask('seek', { share: undefined });
      case 'line': {
        const offset = this.editor.startOfLine(target.line);
        return offset === undefined ? undefined : this.forPanels.ask('seek-block', { offset });
      }
    }
  }

  readonly coloursChanged = (): void => this.#panels.notify((panel) => panel.onColoursChanged?.());

  setupChanged(): void {
    this.#reports.onSetupChanged();
    this.#runs.setupChanged();
  }

  /** Sets the initial program. */
  start(text: string, file: ProgramFile | undefined): void {
    this.editor.setText(programText(text), file, 'final');
  }

  /** The program of the element was loaded from its address, or has changed in the page. */
  programLoaded(text: string, file: ProgramFile | undefined): void {
    this.editor.setText(programText(text), file, this.editor.length > 0 ? 'undoable' : 'final');
    this.#panels.service('hideNotice')('source');
    this.#runs.resetCursor();
    this.#runs.textChanged('fit');
    this.stepChanged();
    this.#pending.finish('program');
  }

  /** The program is being loaded: the element cannot settle before. */
  programLoading(address: string, how: 'started' | 'slow'): void {
    if (how === 'slow') return showSlowLoad(this.#panels, this.#language, address);
    this.#pending.add('program');
  }

  programFailed(address: string, reason: string, retry: () => void): void {
    const message = showFailedLoad(this.#panels, this.#language, { address, reason, retry });
    this.#pending.finish('program');
    this.#fire<HostError>('gcode-error', { kind: 'source', reason, message });
  }

  /** Sets another text without an event for the page; the attributes stay. */
  setProgram(program: ProgramText, file: ProgramFile | undefined): void {
    const { editor } = this;
    editor.setText(program, file, editor.length > 0 ? 'undoable' : 'final', this.#context.current);
    this.#panels.notify((panel) => panel.onProgramReplaced?.('host'));
    // A notice about a file does not apply to this program.
    this.#panels.service('hideNotice')('file');
    this.#runs.resetCursor();
    this.#runs.textChanged('fit');
  }

  handleKey(event: KeyboardEvent): void {
    this.#panels.handleKey(event);
  }

  /** What the user can do, for the command palette of the page. */
  get commands(): readonly UserCommand[] {
    return this.#panels.commands;
  }

  /** Throws an error if the view does not offer a method. */
  expectOffer(name: OptionalMethod): void {
    if (!VIEW_CONTENTS[this.view].offers.includes(name)) throw new Error(`view="${this.view}" does not offer ${name}`);
  }
}
