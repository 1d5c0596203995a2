// The bar under the drawing: play, step, scrub, speed, stops, and the readout of the tool position.
//
// In: whether there is anything to play and, as answers, where the tool is. Out: where the tool is to be; the block it
// is in is marked in the text. While it plays, each painted frame asks how far the tool has moved; while it is paused,
// nothing runs. Must not know: how the path is drawn, or the meaning of a stroke.

import { icon, make, setAccessibleName, setText, renderUnbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { placePopover, returnFocus } from '../dom/popover';
import { COMMON, words } from '../dom/words';
import type {
  HeldBy,
  PauseConditions,
  LengthUnit,
  PlayResult,
  Readout,
  StepDirection,
  StepUnit,
  StopSwitch,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Key, NewestQuestion, Panel, PanelKind, Services, Shell, UserCommand } from './panel';
import { formatCoordinate } from './lengths';
import playbackStyles from './playback.css?inline';
import { ReadoutBoard } from './readout';
import { SpeedChoice } from './speed-choice';

const STEP_UNITS: readonly StepUnit[] = ['motion', 'block', 'pass'];
/** The keys of a step forward; Shift reverses the direction. */
const STEP_KEYS: Record<StepUnit, string> = { motion: 'F9', block: 'Ctrl F9', pass: 'Alt F9' };
/** Maximum time between two frames that is played, seconds; exceeded if the page was hidden or the computer slept. */
const MAX_FRAME_S = 0.5;

/** Where one run of the playback pauses, besides stops and breakpoints: after its block, or before a line (from 0). */
interface ExtraPause {
  readonly block?: true;
  readonly line?: number;
}

/** An action of the user that waits for the path of the current text. */
interface PendingAction {
  readonly act: () => void;
  /** Whether the action starts the playback. */
  readonly startsPlayback: boolean;
}

/** Play, and a step back and forward. */
class PlaybackButtons {
  readonly play = make('button', { type: 'button', className: 'primary play', part: 'play' });
  readonly previous = make('button', { type: 'button' }, icon('previous'));
  readonly next = make('button', { type: 'button' }, icon('next'));
  readonly #icon = make('span', { className: 'play-icon' });
  readonly #text = make('span', { className: 'play-text' });

  constructor() {
    this.play.append(this.#icon, this.#text);
  }

  get all(): readonly HTMLButtonElement[] {
    return [this.previous, this.play, this.next];
  }

  showPlay(text: string, shown: 'play' | 'pause'): void {
    this.#icon.replaceChildren(icon(shown));
    this.#text.textContent = text;
    this.play.title = `${text} (Ctrl Enter)`;
  }
}

export const playback: PanelKind = {
  control: 'playback',
  styles: playbackStyles,
  make: (shell) => new Playback(shell),
};

class Playback implements Panel {
  readonly #shell: Shell;
  readonly #row: HTMLElement;
  readonly #seek: NewestQuestion<'seek'>;
  readonly #buttons = new PlaybackButtons();
  readonly #play = this.#buttons.play;
  /** The buttons of the bar and of dialogs. */
  readonly #buttonSets: PlaybackButtons[] = [this.#buttons];
  readonly #fromCursor = make('button', { type: 'button' }, icon('from-here'));
  readonly #stepUnit = make('select', { className: 'speed unit' });
  readonly #wholePath = make('button', { type: 'button' }, icon('whole'));
  readonly #slider = make('input', { type: 'range', min: '0', max: '1', step: 'any', value: '0', className: 'scrub' });
  readonly #speed: SpeedChoice;
  readonly #optionalStopToggle = make(
    'button',
    { type: 'button', className: 'framed optional', 'aria-pressed': 'true', hidden: true },
    'M01',
  );
  readonly #singleBlockToggle = make('button', { type: 'button', className: 'framed single', 'aria-pressed': 'false' });
  readonly #unitCaption = make('span');
  readonly #paceText = make('span');
  readonly #paceButton = make(
    'button',
    { type: 'button', className: 'pace-button', 'aria-haspopup': 'dialog', 'aria-expanded': 'false' },
    this.#paceText,
    icon('chevron'),
  );
  readonly #options: HTMLElement;
  /** What the tool does, over the picture; hidden while there is no tool. */
  readonly #overPicture: HTMLElement;
  readonly #status = make('p', { className: 'doing', 'aria-live': 'polite' });
  readonly #readout: ReadoutBoard;
  /** Start of the block that is marked as running. */
  #runningBlock: number | undefined;
  #toolPlace: Readout | undefined;
  /** The requested animation frame; undefined while paused. */
  #frame: number | undefined;
  /** Whether an answer about the tool is pending. */
  #isAsking = false;
  #lastFrame: number | undefined;
  /** Seconds since the last question. */
  #elapsed = 0;
  #startFrom: 'here' | 'start' = 'here';
  /** Number of the current playback run; answers to an earlier run are ignored. */
  #playId = 0;
  #extraPause: ExtraPause = {};
  /** Number of changes of text and setup. */
  #revision = 0;
  /** The revision that the current path belongs to. */
  #pathRevision = -1;
  #pendingAction: PendingAction | undefined;
  #heldBy: HeldBy = 'nothing';
  #shownStatus = '';
  #lengthUnit: LengthUnit = 'mm';
  readonly elements: Panel['elements'];
  readonly services: Partial<Services> = {
    play: () => this.#startWhenReady({}),
    pause: () => this.#stop(),
    playOrPause: () => this.#togglePlayback(),
    playbackButtons: () => this.#makeButtons(),
    step: (unit, direction) => this.#stepTool(unit, direction),
    moveTool: (answer) => this.#moveTool(answer),
    playBlock: () => this.#playFromHere({ block: true }),
    playToCursor: () => this.#playToCursor(),
    toggleBreakpoint: () => this.#toggleBreakpoint(),
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#row = shell.region('playback');
    this.#seek = shell.newest('seek', (place) => this.#setTool(place));
    this.#readout = new ReadoutBoard(shell.language);
    this.#speed = new SpeedChoice(shell, () => this.#showPace());
    this.#stepUnit.append(...STEP_UNITS.map((unit) => make('option', { value: unit })));
    const options = make(
      'div',
      { className: 'popover pace', part: 'pace', role: 'dialog', popover: 'auto' },
      make('label', { className: 'choice-line' }, this.#speed.caption, this.#speed.element),
      make('label', { className: 'choice-line' }, this.#unitCaption, this.#stepUnit),
      make('div', { className: 'choice-line' }, this.#singleBlockToggle, this.#optionalStopToggle),
      make('div', { className: 'choice-line' }, this.#fromCursor),
    );
    this.#options = options;
    this.#paceButton.popoverTargetElement = options;
    returnFocus(this.#paceButton, options);
    options.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.#paceButton.setAttribute('aria-expanded', String(open));
      if (open) placePopover(this.#paceButton, options);
    });
    const bar = [...this.#buttons.all, this.#slider, this.#paceButton];
    const overPicture = make(
      'div',
      { className: 'over-picture', part: 'doing' },
      this.#readout.element,
      this.#status,
      this.#wholePath,
    );
    this.#overPicture = overPicture;
    this.elements = { playback: bar, pictures: [overPicture], dialogs: [options] };
    this.#listenTo(this.#buttons);
    this.#fromCursor.hidden = !shell.showsProgram;
    this.#fromCursor.addEventListener('click', () => {
      options.hidePopover();
      this.#playFromHere({});
    });
    this.#stepUnit.addEventListener('change', () => this.#nameStepButtons());
    this.#wholePath.addEventListener('click', () => this.#showWholePath());
    this.#slider.addEventListener('input', () => this.#scrub());
    this.#optionalStopToggle.addEventListener('click', () => {
      this.#optionalStopToggle.setAttribute('aria-pressed', String(this.#stops === 'not-optional'));
    });
    this.#singleBlockToggle.addEventListener('click', () => {
      this.#singleBlockToggle.setAttribute('aria-pressed', String(!this.#isSingle));
    });
    this.#renderReadout(undefined);
  }

  get commands(): readonly UserCommand[] {
    const texts = this.#words;
    const stepsBy = (unit: StepUnit): readonly UserCommand[] => [
      { name: texts.next[unit], keys: STEP_KEYS[unit], run: () => this.#stepTool(unit, 'next') },
      { name: texts.previous[unit], keys: `Shift ${STEP_KEYS[unit]}`, run: () => this.#stepTool(unit, 'previous') },
    ];
    return [
      { name: this.#playing ? texts.pause : texts.play, keys: 'Ctrl Enter', run: () => this.#togglePlayback() },
      { name: texts.fromHere, keys: 'Ctrl Shift Enter', run: () => this.#playFromHere({}) },
      ...STEP_UNITS.flatMap(stepsBy),
      { name: texts.wholePath, run: () => this.#showWholePath() },
    ];
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#row.setAttribute('aria-label', texts.playback);
    for (const option of this.#stepUnit.options) option.textContent = texts.units[option.value as StepUnit];
    this.#unitCaption.textContent = texts.stepBy;
    this.#options.setAttribute('aria-label', texts.options);
    this.#paceButton.title = texts.options;
    this.#fromCursor.replaceChildren(icon('from-here'), texts.fromHere);
    this.#fromCursor.title = `${texts.fromHere} (Ctrl Shift Enter)`;
    setAccessibleName(this.#optionalStopToggle, `M01: ${texts.optionalStops}`);
    this.#optionalStopToggle.title = texts.optionalStopsHint;
    this.#singleBlockToggle.textContent = texts.single;
    this.#singleBlockToggle.setAttribute('aria-label', `${texts.single}: ${texts.singleName}`);
    this.#singleBlockToggle.title = texts.singleHint;
    setAccessibleName(this.#wholePath, texts.wholePath);
    this.#slider.setAttribute('aria-label', texts.position);
    this.#speed.language = language;
    this.#readout.language = language;
    this.#nameStepButtons();
    this.#showState();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    const { stage, summary, units } = event.report;
    this.#lengthUnit = this.#readout.unit = units.shown;
    // Not for stage `part`: its path was reported before, and the user may be playing it.
    if (stage === 'whole' || stage === 'path') {
      const lineStart = this.#toolPlace === undefined ? undefined : this.#shell.editor.runningLineStart;
      this.#onNewPath(summary.motions, summary.optionalStops);
      void this.#onPathReady(lineStart);
    } else if (stage === 'repeated' && this.#toolPlace !== undefined) {
      void this.#shell.ask('readout', undefined).then((place) => this.#setTool(place));
    }
  }

  onKey({ event }: Key): 'handled' | 'ignored' {
    const control = event.ctrlKey || event.metaKey;
    if (event.key === 'Enter' && control && event.shiftKey) this.#playFromHere({});
    else if (event.key === 'F10' && control) this.#playToCursor();
    else if (event.key === 'F10') this.#playFromHere({ block: true });
    else if (event.key === 'F8' && control) this.#toggleBreakpoint();
    else if (event.key === 'Enter' && control) this.#togglePlayback();
    else if (event.key === 'F9')
      this.#stepTool(control ? 'block' : event.altKey ? 'pass' : 'motion', event.shiftKey ? 'previous' : 'next');
    else return 'ignored';
    return 'handled';
  }

  onInputChanged(): void {
    this.#stop();
    this.#revision++;
  }

  onSpeedChanged(): void {
    this.#speed.changed();
  }

  onWorkerLost(): void {
    this.#stop();
    this.#onNewPath(0, 0);
    this.#renderReadout(undefined);
  }

  onDisconnected(): void {
    this.#stop();
  }

  get #words(): (typeof WORDS)['en'] {
    return WORDS[this.#shell.language];
  }

  /** A new path was drawn: number of its motions and of its optional stops. */
  #onNewPath(motions: number, optionalStops: number): void {
    this.#stopTicking();
    for (const control of [
      ...this.#buttonSets.flatMap((buttons) => buttons.all),
      this.#fromCursor,
      this.#slider,
      this.#singleBlockToggle,
    ])
      control.disabled = motions <= 0;
    this.#optionalStopToggle.hidden = optionalStops <= 0;
  }

  /**
   * After an edit, returns the tool to the block that it was in, even if another edit arrives before the answer: the
   * mark in the editor keeps the position. Then carries out the pending action of the user. `lineStart`: offset in the
   * text.
   */
  async #onPathReady(lineStart: number | undefined): Promise<void> {
    const revision = this.#revision;
    const place = lineStart === undefined ? undefined : await this.#shell.ask('seek-block', { offset: lineStart });
    if (revision !== this.#revision) return;
    this.#setTool(place);
    this.#pathRevision = revision;
    const pendingAction = this.#pendingAction;
    this.#pendingAction = undefined;
    pendingAction?.act();
    this.#showState();
  }

  /** Carries out an action as soon as the path of the current text exists. */
  #whenPathReady(pendingAction: PendingAction): void {
    this.#shell.flush();
    if (this.#pathRevision === this.#revision) return pendingAction.act();
    this.#pendingAction = pendingAction;
    this.#showState();
  }

  /** Shows a readout in this panel. */
  #renderReadout(readout: Readout | undefined, heldBy: HeldBy = 'nothing'): void {
    this.#toolPlace = readout;
    this.#heldBy = heldBy;
    // While the user drags the slider, an answer to an earlier position must not move it.
    if (!this.#slider.matches(':active')) this.#slider.value = String(readout?.share ?? 0);
    this.#readout.shown = readout;
    this.#overPicture.hidden = readout === undefined;
    this.#showStatus();
    // During playback the announcements would never end.
    if (this.#playing) return;
    const stroke = readout?.stroke;
    const spoken =
      stroke === undefined
        ? '–'
        : this.#words.positionText(
            formatCoordinate(stroke.atX, this.#lengthUnit),
            formatCoordinate(stroke.atZ, this.#lengthUnit),
          );
    this.#slider.setAttribute('aria-valuetext', spoken);
  }

  #showPace(): void {
    const { text } = this.#speed;
    setText(this.#paceText, text);
    this.#paceButton.setAttribute('aria-label', `${this.#words.options}: ${text}`);
  }

  get #playing(): boolean {
    return this.#frame !== undefined;
  }

  #togglePlayback(): void {
    if (this.#playing || this.#pendingAction?.startsPlayback === true) this.#stop();
    else this.#startWhenReady({});
  }

  #startWhenReady(extraPause: ExtraPause): void {
    if (!this.#playing) this.#whenPathReady({ startsPlayback: true, act: () => this.#startNow(extraPause) });
  }

  #startNow(extraPause: ExtraPause): void {
    if (this.#playing || this.#play.disabled) return;
    this.#extraPause = extraPause;
    this.#startFrom = this.#toolPlace === undefined || this.#toolPlace.share >= 1 ? 'start' : 'here';
    this.#lastFrame = undefined;
    this.#elapsed = 0;
    this.#isAsking = false;
    this.#playId++;
    this.#frame = requestAnimationFrame(this.#tick);
    this.#shell.notifyPlaying('playing');
    this.#showState();
  }

  /** Plays from the block at the cursor; with `block`, only that block. */
  #playFromHere(extraPause: { readonly block?: true }): void {
    this.#stop();
    const act = async (): Promise<void> => {
      const place = await this.#shell.ask('seek-block', { offset: this.#shell.editor.cursor });
      this.#setTool(place);
      if (place !== undefined) this.#startNow(extraPause);
    };
    this.#whenPathReady({ startsPlayback: true, act: () => void act() });
  }

  /** Plays to the block at the cursor, from the tool position or from the start. */
  #playToCursor(): void {
    this.#stop();
    this.#startWhenReady({ line: this.#shell.editor.lineOf(this.#shell.editor.cursor) });
  }

  #toggleBreakpoint(): void {
    const { editor } = this.#shell;
    const line = editor.lineOf(editor.cursor) + 1;
    editor.announce(editor.toggleBreakpoint() ? this.#words.breakpointSet(line) : this.#words.breakpointRemoved(line));
  }

  #stepTool(unit: StepUnit, direction: StepDirection): void {
    this.#stop();
    const act = (): void => {
      if (this.#play.disabled) return;
      this.#shell.editor.followRunningBlock();
      // Shows the block even if it is the same one as before.
      this.#runningBlock = undefined;
      void this.#shell.ask('step', { unit, direction }).then((place) => this.#setTool(place));
    };
    this.#whenPathReady({ startsPlayback: false, act });
  }

  async #moveTool(answer: Promise<Readout | undefined>): Promise<void> {
    this.#stop();
    this.#shell.editor.followRunningBlock();
    this.#setTool(await answer);
  }

  #showWholePath(): void {
    this.#stop();
    this.#renderReadout(undefined);
    this.#seek.ask({ share: undefined });
    this.#play.focus({ preventScroll: true });
  }

  #tick = (now: number): void => {
    const elapsed = this.#lastFrame === undefined ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    this.#elapsed += Math.min(elapsed, MAX_FRAME_S);
    this.#frame = requestAnimationFrame(this.#tick);
    // One question at a time: if the interpreter is slow, the tool moves in larger steps.
    if (this.#isAsking || this.#elapsed === 0) return;
    this.#isAsking = true;
    const playId = this.#playId;
    const answer = this.#playFor(this.#startFrom, this.#elapsed);
    [this.#startFrom, this.#elapsed] = ['here', 0];
    void answer.then((played) => {
      if (playId !== this.#playId) return;
      this.#isAsking = false;
      const { place, heldBy } = played ?? { place: undefined, heldBy: 'nothing' };
      if (heldBy !== 'nothing' || place === undefined || place.share >= 1) this.#stop();
      this.#renderReadout(place, heldBy);
    });
  };

  /** Plays this many seconds; `start` begins at the start of the program. */
  async #playFor(from: 'here' | 'start', seconds: number): Promise<PlayResult | undefined> {
    const played = await this.#shell.ask('play', {
      from,
      seconds,
      pace: this.#speed.pace,
      pauseConditions: this.#pauseConditions,
    });
    this.#shell.notifyToolMoved(played?.place);
    this.#markRunning(played?.place);
    return played;
  }

  get #pauseConditions(): PauseConditions {
    const { block, line } = this.#extraPause;
    const marked = this.#shell.editor.breakpoints;
    const lines = line === undefined || marked.includes(line) ? marked : [...marked, line].sort((a, b) => a - b);
    return { stops: this.#stops, eachBlock: this.#isSingle || block === true, lines };
  }

  get #isSingle(): boolean {
    return this.#singleBlockToggle.getAttribute('aria-pressed') === 'true';
  }

  /** Shows a readout in this panel, in the other panels and in the text. */
  #setTool(readout: Readout | undefined): void {
    this.#renderReadout(readout);
    this.#shell.notifyToolMoved(readout);
    this.#markRunning(readout);
  }

  /** Marks the block that runs, or that stops the tool. */
  #markRunning(place: Readout | undefined): void {
    const block = place?.stop ?? place?.stroke;
    if (block?.from === this.#runningBlock) return;
    this.#runningBlock = block?.from;
    this.#shell.editor.running = block;
  }

  #scrub(): void {
    this.#stop();
    this.#seek.ask({ share: this.#slider.valueAsNumber });
  }

  /** Stops the tool and drops the pending action. */
  #stop(): void {
    const hadPendingAction = this.#pendingAction !== undefined;
    this.#pendingAction = undefined;
    this.#stopTicking();
    if (hadPendingAction) this.#showState();
  }

  #stopTicking(): void {
    if (this.#frame === undefined) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#playId++;
    this.#shell.notifyPlaying('paused');
    this.#showState();
    this.#renderReadout(this.#toolPlace);
  }

  get #stops(): StopSwitch {
    return this.#optionalStopToggle.getAttribute('aria-pressed') === 'true' ? 'all' : 'not-optional';
  }

  get #chosenUnit(): StepUnit {
    return STEP_UNITS.find((unit) => unit === this.#stepUnit.value) ?? 'motion';
  }

  #listenTo({ play, previous, next }: PlaybackButtons): void {
    play.addEventListener('click', () => this.#togglePlayback());
    previous.addEventListener('click', () => this.#stepTool(this.#chosenUnit, 'previous'));
    next.addEventListener('click', () => this.#stepTool(this.#chosenUnit, 'next'));
  }

  #makeButtons(): HTMLElement {
    const buttons = new PlaybackButtons();
    this.#listenTo(buttons);
    this.#buttonSets.push(buttons);
    for (const button of buttons.all) button.disabled = this.#play.disabled;
    this.#nameStepButtons();
    this.#showState();
    return make('div', { className: 'playback-buttons' }, ...buttons.all);
  }

  #nameStepButtons(): void {
    const key = STEP_KEYS[this.#chosenUnit];
    const texts = this.#words;
    for (const { previous, next } of this.#buttonSets) {
      setAccessibleName(previous, `${texts.previous[this.#chosenUnit]} (Shift ${key})`);
      setAccessibleName(next, `${texts.next[this.#chosenUnit]} (${key})`);
    }
  }

  #showStatus(): void {
    const { stroke, stop } = this.#toolPlace ?? {};
    let text = '';
    const atLine = this.#heldBy === 'line' && stroke !== undefined ? stroke.line : undefined;
    if (atLine !== undefined) text = this.#words.pausedAt(atLine);
    else if (stop !== undefined) text = this.#words.stopped(stop.code, stop.line);
    else if (stroke !== undefined) text = `${COMMON[this.#shell.language].line(stroke.line)}: ${stroke.text}`;
    if (text === this.#shownStatus) return;
    this.#shownStatus = text;
    this.#status.classList.toggle('stopped', stop !== undefined || atLine !== undefined);
    this.#status.replaceChildren(...(text === '' ? [] : renderUnbroken(text)));
  }

  #showState(): void {
    const isActive = this.#playing || this.#pendingAction?.startsPlayback === true;
    const text = isActive ? this.#words.pause : this.#words.play;
    for (const buttons of this.#buttonSets) buttons.showPlay(text, isActive ? 'pause' : 'play');
    this.#status.setAttribute('aria-live', this.#playing ? 'off' : 'polite');
  }
}

const WORDS = words({
  en: {
    playback: 'Playback',
    options: 'Speed and steps',
    play: 'Play',
    pause: 'Pause',
    wholePath: 'Show the whole path',
    position: 'Position along the path',
    positionText: (x: string, z: string) => `X diameter ${x}, Z ${z}`,
    previous: { motion: 'Previous motion', block: 'Previous block', pass: 'Previous pass' },
    next: { motion: 'Next motion', block: 'Next block', pass: 'Next pass' },
    fromHere: 'Start at the block at the cursor',
    stepBy: 'Step by',
    units: { motion: 'motion', block: 'block', pass: 'pass' },
    optionalStops: 'Optional stop',
    optionalStopsHint: 'When on, the playback stops at M01 too',
    stopped: (code: string, line: number) => `${code} in line ${line}: the program stops here. Press Play to continue.`,
    pausedAt: (line: number) => `Paused before line ${line}. Press Play to continue.`,
    single: 'SBK',
    singleName: 'Single block',
    singleHint: 'Single block: when on, the playback stops after each block that moves the tool',
    breakpointSet: (line: number) => `The playback stops before line ${line}.`,
    breakpointRemoved: (line: number) => `The playback no longer stops before line ${line}.`,
  },
  zh: {
    playback: '播放',
    options: '速度与步进',
    play: '播放',
    pause: '暂停',
    wholePath: '显示完整轨迹',
    position: '在轨迹上的位置',
    positionText: (x, z) => `X 直径 ${x}，Z ${z}`,
    previous: { motion: '上一段运动', block: '上一程序段', pass: '上一次走刀' },
    next: { motion: '下一段运动', block: '下一程序段', pass: '下一次走刀' },
    fromHere: '从光标所在程序段开始',
    stepBy: '步进单位',
    units: { motion: '运动', block: '程序段', pass: '走刀' },
    optionalStops: '选择停止',
    optionalStopsHint: '打开后，播放到 M01 时也停下',
    stopped: (code, line) => `第 ${line} 行 ${code}：程序在此停止，按“播放”继续。`,
    pausedAt: (line) => `停在第 ${line} 行之前，按“播放”继续。`,
    single: '单段',
    singleName: '单程序段',
    singleHint: '单程序段：打开后，每执行完一个移动刀具的程序段就停下',
    breakpointSet: (line) => `播放将在第 ${line} 行之前停下。`,
    breakpointRemoved: (line) => `播放不再停在第 ${line} 行之前。`,
  },
  ru: {
    playback: 'Воспроизведение',
    options: 'Скорость и шаг',
    play: 'Пуск',
    pause: 'Пауза',
    wholePath: 'Показать всю траекторию',
    position: 'Положение на траектории',
    positionText: (x, z) => `X диаметр ${x}, Z ${z}`,
    previous: { motion: 'Предыдущее перемещение', block: 'Предыдущий кадр', pass: 'Предыдущий проход' },
    next: { motion: 'Следующее перемещение', block: 'Следующий кадр', pass: 'Следующий проход' },
    fromHere: 'С кадра у курсора',
    stepBy: 'Шаг',
    units: { motion: 'перемещение', block: 'кадр', pass: 'проход' },
    optionalStops: 'Останов по выбору',
    optionalStopsHint: 'Если включено, показ останавливается и на M01',
    stopped: (code, line) => `${code} в строке ${line}: здесь программа останавливается. «Пуск» — дальше.`,
    pausedAt: (line) => `Пауза перед строкой ${line}. «Пуск» — дальше.`,
    single: 'SBK',
    singleName: 'Покадровая отработка',
    singleHint: 'Покадровая отработка: показ останавливается после каждого кадра с перемещением',
    breakpointSet: (line) => `Показ остановится перед строкой ${line}.`,
    breakpointRemoved: (line) => `Показ больше не останавливается перед строкой ${line}.`,
  },
});
