// The shell: the editor, the panels around it, and what they ask of each other, of the
// worker and of the page around.
//
// In: what the reader does, what the worker reports. Out: the same to the panels; attributes and events of
// the element, its host. Which panels there are, it knows from `panels/index.ts` alone. Must not know:
// G-code. What is written and what it means is the interpreter's business, behind core-client.ts.

import type { Language } from '../dom/language';
import { words } from '../dom/words';
import { Program } from '../editor/program';
import { programText, type ProgramFile, type ProgramText } from '../editor/program-text';
import { PANELS } from '../panels/index';
import { REGIONS, type NewestQuestion, type Panel, type Region, type Services, type Shell } from '../panels/panel';
import type { Answer, Command, Diagnostic, QuestionKind, Questions, Readout, Report, Stroke, Summary } from '../protocol/protocol';
import type { Loss } from '../worker/core-client';
import { layout } from './layout';
import { ProgramSetup, type Attributes, type RunAs } from './program-setup';
import { Runs } from './runs';
import { mergedSetup, switchesSet } from './start';

/** The element, whose attributes say how the program is run. */
export interface Host {
  readonly language: Language;
  readonly control: string | null;
  setup: string | null;
  blockSkip: string | null;
  program: string | null;
}

/** Events for the page around. */
export interface ShellEvents {
  fire<Detail>(type: string, detail: Detail): void;
  /** The reader has made another program, or another file, of it. */
  changed(): void;
  /** Something that may change what is shown is under way. */
  unsettled(): void;
  /** There is nothing more to show of the run. */
  settled(run: number): void;
}

export class PlaygroundShell implements Shell {
  readonly root: ShadowRoot;
  readonly editor: Program;
  readonly #host: Host;
  readonly #events: ShellEvents;
  readonly #regions: Readonly<Record<Region, HTMLElement>>;
  readonly #panels: readonly Panel[];
  readonly #services: Partial<Services> = {};
  readonly #runs: Runs;
  readonly #programSetup = new ProgramSetup();
  readonly #dark = matchMedia('(prefers-color-scheme: dark)');
  #language: Language;
  /** Why the setup could not even be sent. */
  #setupUnreadable: string | undefined;

  constructor(root: ShadowRoot, host: Host, events: ShellEvents) {
    this.root = root;
    this.#host = host;
    this.#events = events;
    this.#language = host.language;
    this.editor = new Program(this.#language, {
      changed: (how) => this.#typed(how),
      cursorMoved: () => this.#runs.cursorMoved(),
      viewMoved: () => void this.#runs.askTokens(),
      fileChanged: () => this.#tell((panel) => panel.fileChanged?.(this.editor.file)),
      pasted: (from, to) => {
        this.cameAtOnce();
        this.#tell((panel) => panel.textArrived?.(from, to));
      },
    });
    this.#runs = new Runs(this.editor, {
      setup: () => this.#mergedSetup(),
      heard: (event) => {
        this.#tell((panel) => panel.heard?.(event));
        if (event.kind === 'report') this.#reported(event.report);
        else if (event.kind === 'part-failed') this.#partFailed(event.reason);
      },
      pictures: (pictures) => this.#tell((panel) => panel.showPictures?.(pictures)),
      outdated: () => this.#tell((panel) => panel.outdated?.()),
      textChanged: () => {
        for (const topic of ['core', 'program'] as const) this.service('hideNotice')(topic);
      },
      sent: () => events.changed(),
      // Not earlier: what brings the picture has the line for itself.
      ready: () => void this.#edit(),
      connected: (client) => {
        client.send({ kind: 'language', tag: this.#language });
        this.#tell((panel) => panel.connected?.((command) => client.send(command)));
      },
      lost: (loss) => this.#lost(loss),
      unsettled: () => events.unsettled(),
      settled: (run) => events.settled(run),
    });
    const { frame, regions } = layout(this.editor.element);
    this.#regions = regions;
    this.#panels = PANELS.map(({ make }) => make(this));
    for (const panel of this.#panels) {
      for (const region of REGIONS) regions[region].append(...(panel.places[region] ?? []));
      Object.assign(this.#services, panel.services);
      panel.language = this.#language;
    }
    root.append(frame);
  }

  // ---- for the element ----------------------------------------------------------------------------

  connect(): void {
    this.#dark.addEventListener('change', this.coloursChanged);
    this.#runs.connect();
    this.#runs.wanted('keep');
  }

  disconnect(): void {
    this.#dark.removeEventListener('change', this.coloursChanged);
    this.#tell((panel) => panel.left?.());
    this.#runs.end();
  }

  languageChanged(): void {
    this.#language = this.#host.language;
    // What a panel asks then is answered in this language.
    this.send({ kind: 'language', tag: this.#language });
    for (const panel of this.#panels) panel.language = this.#language;
    this.editor.language = this.#language;
  }

  readonly coloursChanged = (): void => this.#tell((panel) => panel.coloursChanged?.());

  setupChanged(): void {
    this.#runs.setupChanged();
  }

  /** The program the element starts with. */
  start(text: string, file: ProgramFile | undefined): void {
    this.editor.setText(programText(text), file, 'final');
    this.#programSetup.know(this.editor.length);
  }

  /** Another program from outside, with no word to the page around. */
  put(program: ProgramText, file: ProgramFile | undefined): void {
    this.editor.setText(program, file, this.editor.length > 0 ? 'undoable' : 'final');
    this.#programSetup.know(this.editor.length);
    this.#runs.forgetCursor();
    this.#runs.textChanged('fit');
  }

  pressed(event: KeyboardEvent): void {
    if (this.#panels.some(({ takesKeys }) => takesKeys === true)) return;
    const target = event.composedPath()[0];
    const typing = target instanceof HTMLElement && (target.isContentEditable || target.matches('input:not([type=range]), textarea'));
    const key = { event, inside: typing ? 'text' : 'elsewhere' } as const;
    if (!this.#panels.some((panel) => panel.pressed?.(key) === 'own')) return;
    event.preventDefault();
    event.stopPropagation();
  }

  // ---- for the panels -----------------------------------------------------------------------------

  get language(): Language {
    return this.#language;
  }

  get setup(): string | null {
    return this.#host.setup;
  }

  region(region: Region): HTMLElement {
    return this.#regions[region];
  }

  service<S extends keyof Services>(name: S): Services[S] {
    const service = this.#services[name];
    if (service === undefined) throw new Error(`no panel offers ${name}`);
    return service;
  }

  send(command: Command): void {
    this.#runs.client?.send(command);
  }

  async ask<K extends QuestionKind>(about: K, ask: Questions[K]['ask']): Promise<Answer<K> | undefined> {
    return this.#runs.client?.ask(about, ask);
  }

  newest<K extends QuestionKind>(about: K, answered: (answer: Answer<K>) => void): NewestQuestion<K> {
    return this.#runs.newest(about, answered);
  }

  flush(): void {
    this.#runs.flush();
  }

  edited(): void {
    this.#runs.send();
  }

  rewrite(text: string): void {
    this.editor.rewrite(text);
    this.#runs.forgetCursor();
    this.#runs.send();
  }

  take(program: ProgramText, file: ProgramFile | undefined, as: 'another' | 'same'): void {
    if (as === 'another') {
      // The switches were set for another program, too; who empties the editor still sees them.
      this.#runAs({ setup: this.#programSetup.another(this.editor.length, this.#attributes), blockSkip: null, program: null });
    }
    this.put(program, file);
    this.changed();
    if (as === 'another') this.#tell((panel) => panel.textArrived?.(0, this.editor.length));
  }

  changed(): void {
    this.#events.changed();
  }

  cameAtOnce(): void {
    this.#runs.cameAtOnce();
  }

  choose(stroke: Stroke, focus: 'focus' | 'keep-focus'): void {
    this.editor.select(stroke);
    if (focus === 'focus') this.editor.focus();
    this.#runs.cursorAt(stroke.from);
    this.#events.fire('gcode-select', { stroke });
  }

  toolMoved(place: Readout | undefined): void {
    this.#tell((panel) => panel.toolMoved?.(place));
  }

  changeSetup(setup: string | null): void {
    if (this.#host.setup === setup) return;
    this.#host.setup = setup;
    this.#events.fire('gcode-setup', { setup });
  }

  turn({ blockSkip, program }: { readonly blockSkip?: string; readonly program?: string }): void {
    const host = this.#host;
    if (blockSkip !== undefined) host.blockSkip = blockSkip;
    if (program !== undefined) host.program = program;
    this.#events.fire('gcode-switch', { blockSkip: host.blockSkip, program: host.program });
  }

  // ---- between them -------------------------------------------------------------------------------

  #tell(tell: (panel: Panel) => void): void {
    for (const panel of this.#panels) tell(panel);
  }

  #typed(how: 'edited' | 'undone'): void {
    const runAs = this.#programSetup.follow(how, this.editor.length, this.#attributes);
    if (runAs !== undefined) this.#runAs(runAs);
    this.#runs.typed();
  }

  get #attributes(): Attributes {
    const { control, setup, blockSkip, program } = this.#host;
    return { control, runAs: { setup, blockSkip, program } };
  }

  #runAs({ setup, blockSkip, program }: RunAs): void {
    this.#host.blockSkip = blockSkip;
    this.#host.program = program;
    this.changeSetup(setup);
  }

  /** The setup as the attributes have it; nothing where it cannot be read. */
  #mergedSetup(): string | undefined {
    const { control, setup, blockSkip, program } = this.#host;
    const merged = mergedSetup(setup, { control, blockSkip, program });
    this.#tell((panel) => panel.switched?.(switchesSet(merged)));
    this.#setupUnreadable = merged.kind === 'unreadable' ? merged.reason : undefined;
    return merged.kind === 'setup' ? merged.json : undefined;
  }

  #reported({ summary, diagnostics, setupRejected }: Report): void {
    const rejected = this.#setupUnreadable ?? setupRejected;
    if (rejected === undefined) this.service('hideNotice')('setup');
    else this.service('notice')(WORDS[this.#language].setupRejected(rejected), 'setup');
    this.#available(summary.finished && summary.motions > 0);
    this.editor.diagnostics = diagnostics;
    this.#events.fire<{ summary: Summary; diagnostics: readonly Diagnostic[] }>('gcode-report', { summary, diagnostics });
  }

  /** Puts the editor in its place. */
  async #edit(): Promise<void> {
    try {
      await this.editor.edit(this.root);
      this.service('hideNotice')('editor');
    } catch (error) {
      const texts = WORDS[this.#language];
      const reason = error instanceof Error ? error.message : String(error);
      this.service('notice')(texts.editorFailed(reason), 'editor', { title: texts.tryAgain, act: () => void this.#edit() });
    }
  }

  #partFailed(reason: string): void {
    const texts = WORDS[this.#language];
    const remedy = { title: texts.tryAgain, act: () => this.send({ kind: 'load-parts' }) };
    this.service('notice')(texts.partFailed(reason), 'core', remedy);
  }

  #available(available: boolean): void {
    for (const panel of this.#panels) if ('available' in panel) panel.available = available;
  }

  #lost(loss: Loss): void {
    console.error('gcode-playground: the interpreter was lost', loss);
    this.#available(false);
    this.#tell((panel) => panel.lost?.());
    const texts = WORDS[this.#language];
    const text = loss.kind === 'load-failed' ? texts.loadFailed(loss.reason) : loss.kind === 'silent' ? texts.stopped : texts.crashed;
    this.service('notice')(text, 'core');
    void this.#edit();
  }
}

const WORDS = words({
  en: {
    loadFailed: (reason: string) => `The interpreter could not be loaded (${reason}). Reload the page to try again.`,
    partFailed: (reason: string) => `Not all of the playground could be loaded (${reason}). What is drawn is right, and you can go on editing.`,
    editorFailed: (reason: string) => `The editor could not be loaded (${reason}). The picture is right.`,
    tryAgain: 'Try again',
    stopped: 'The run took too long and was stopped. Your program is still here: change it to run it again.',
    crashed: 'The interpreter failed on this program; that is our fault. Your program is still here: change it to run it again.',
    setupRejected: (reason: string) => `The setup was not accepted: ${reason}`,
  },
  zh: {
    loadFailed: (reason) => `解释器加载失败（${reason}）。请刷新页面重试。`,
    partFailed: (reason) => `部分内容加载失败（${reason}）。已画出的轨迹是正确的，可以继续编辑。`,
    editorFailed: (reason) => `编辑器加载失败（${reason}）。图形是正确的。`,
    tryAgain: '重试',
    stopped: '运行时间过长，已停止。您的程序仍在，修改后会重新运行。',
    crashed: '解释器处理此程序时出错，这是我们的问题。您的程序仍在，修改后会重新运行。',
    setupRejected: (reason) => `设置未被接受：${reason}`,
  },
  ru: {
    loadFailed: (reason) => `Не удалось загрузить интерпретатор (${reason}). Обновите страницу.`,
    partFailed: (reason) => `Загружено не всё (${reason}). То, что нарисовано, верно; можно редактировать дальше.`,
    editorFailed: (reason) => `Не удалось загрузить редактор (${reason}). Чертёж верен.`,
    tryAgain: 'Повторить',
    stopped: 'Выполнение длилось слишком долго и было остановлено. Программа сохранена: измените её, чтобы запустить снова.',
    crashed: 'Интерпретатор не справился с этой программой — это наша ошибка. Программа сохранена: измените её, чтобы запустить снова.',
    setupRejected: (reason) => `Наладка отклонена: ${reason}`,
  },
});
