// The bar under the drawing: play, step, scrub, speed, stops, and the readout of the tool position.
//
// In: whether there is anything to play and, as answers, where the tool is. Out: where the tool is to be; the block it
// is in is marked in the text. Must not know: how the path is drawn, or the meaning of a stroke.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type {
  HeldBy,
  PauseConditions,
  LengthUnit,
  PlayResult,
  Readout,
  StepDirection,
  StepUnit,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Key, NewestQuestion, Panel, PanelKind, Services, Shell, UserCommand } from './panel';
import { formatCoordinate } from './lengths';
import { PendingAction } from './pending-action';
import playbackStyles from './playback.css?inline';
import { PlaybackButtons, STEP_KEYS, STEP_WORDS } from './playback-buttons';
import { PlaybackOptions, STEP_UNITS } from './playback-options';
import { Player, type StartFrom } from './player';
import { ToolStatus } from './tool-status';

/** Where one run of the playback pauses, besides stops and breakpoints: after its block, or before a line (from 0). */
interface ExtraPause {
  readonly block?: true;
  readonly line?: number;
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
  readonly #buttons = new PlaybackButtons({
    onPlay: () => this.#togglePlayback(),
    onStep: (direction) => this.#stepTool(this.#options.stepUnit, direction),
  });
  readonly #slider = make('input', { type: 'range', min: '0', max: '1', step: 'any', value: '0', className: 'scrub' });
  readonly #options: PlaybackOptions;
  readonly #toolStatus: ToolStatus;
  readonly #player = new Player({
    play: (from, seconds) => this.#playFor(from, seconds),
    onPlayed: (played) => this.#onPlayed(played),
  });
  readonly #pendingAction = new PendingAction();
  /** Start of the block that is marked as running. */
  #runningBlock: number | undefined;
  #toolPlace: Readout | undefined;
  #extraPause: ExtraPause = {};
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
    this.#toolStatus = new ToolStatus(shell.language, () => this.#showWholePath());
    this.#options = new PlaybackOptions(shell, {
      onStepUnitChanged: () => this.#nameStepButtons(),
      onFromCursor: () => this.#playFromHere({}),
    });
    this.#slider.addEventListener('input', () => this.#scrub());
    this.elements = {
      playback: [...this.#buttons.bar, this.#slider, this.#options.button],
      pictures: [this.#toolStatus.element],
      dialogs: [this.#options.popover],
    };
    this.#renderReadout(undefined);
  }

  get commands(): readonly UserCommand[] {
    const texts = this.#words;
    const { next, previous } = STEP_WORDS[this.#shell.language];
    const stepsBy = (unit: StepUnit): readonly UserCommand[] => [
      { name: next[unit], keys: STEP_KEYS[unit], run: () => this.#stepTool(unit, 'next') },
      { name: previous[unit], keys: `Shift ${STEP_KEYS[unit]}`, run: () => this.#stepTool(unit, 'previous') },
    ];
    return [
      {
        name: this.#player.isPlaying ? texts.pause : texts.play,
        keys: 'Ctrl Enter',
        run: () => this.#togglePlayback(),
      },
      { name: this.#options.fromHereText, keys: 'Ctrl Shift Enter', run: () => this.#playFromHere({}) },
      ...STEP_UNITS.flatMap(stepsBy),
      { name: this.#toolStatus.wholePathText, run: () => this.#showWholePath() },
    ];
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#row.setAttribute('aria-label', texts.playback);
    this.#slider.setAttribute('aria-label', texts.position);
    this.#options.language = this.#toolStatus.language = language;
    this.#nameStepButtons();
    this.#showState();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    const { stage, summary, units } = event.report;
    this.#lengthUnit = this.#toolStatus.unit = units.shown;
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
    this.#pendingAction.onInputChanged();
  }

  onSpeedChanged(): void {
    this.#options.onSpeedChanged();
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
    this.#buttons.disabled = this.#slider.disabled = motions <= 0;
    this.#options.onNewPath(motions <= 0, optionalStops > 0);
  }

  /**
   * After an edit, returns the tool to the block that it was in, even if another edit arrives before the answer: the
   * mark in the editor keeps the position. Then carries out the pending action of the user. `lineStart`: offset in the
   * text.
   */
  async #onPathReady(lineStart: number | undefined): Promise<void> {
    const { revision } = this.#pendingAction;
    const place = lineStart === undefined ? undefined : await this.#shell.ask('seek-block', { offset: lineStart });
    if (revision !== this.#pendingAction.revision) return;
    this.#setTool(place);
    this.#pendingAction.onPathReady();
    this.#showState();
  }

  /** Acts as soon as the path of the current text exists. */
  #whenPathReady(act: () => void, startsPlayback: boolean): void {
    this.#shell.flush();
    if (this.#pendingAction.whenPathReady({ act, startsPlayback })) this.#showState();
  }

  /** Shows a readout in this panel. */
  #renderReadout(readout: Readout | undefined, heldBy: HeldBy = 'nothing'): void {
    this.#toolPlace = readout;
    // While the user drags the slider, an answer to an earlier position must not move it.
    if (!this.#slider.matches(':active')) this.#slider.value = String(readout?.share ?? 0);
    this.#toolStatus.show(readout, heldBy);
    // During playback the announcements would never end.
    if (this.#player.isPlaying) return;
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

  #togglePlayback(): void {
    if (this.#isActive) this.#stop();
    else this.#startWhenReady({});
  }

  /** Whether the tool moves, or will as soon as the path exists. */
  get #isActive(): boolean {
    return this.#player.isPlaying || this.#pendingAction.startsPlayback;
  }

  #startWhenReady(extraPause: ExtraPause): void {
    if (!this.#player.isPlaying) this.#whenPathReady(() => this.#startNow(extraPause), true);
  }

  #startNow(extraPause: ExtraPause): void {
    if (this.#player.isPlaying || this.#buttons.disabled) return;
    this.#extraPause = extraPause;
    this.#player.start(this.#toolPlace === undefined || this.#toolPlace.share >= 1 ? 'start' : 'here');
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
    this.#whenPathReady(() => void act(), true);
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
      if (this.#buttons.disabled) return;
      this.#shell.editor.followRunningBlock();
      // Shows the block even if it is the same one as before.
      this.#runningBlock = undefined;
      void this.#shell.ask('step', { unit, direction }).then((place) => this.#setTool(place));
    };
    this.#whenPathReady(act, false);
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
    this.#buttons.focusPlay();
  }

  async #playFor(from: StartFrom, seconds: number): Promise<PlayResult | undefined> {
    const { pace } = this.#options;
    const played = await this.#shell.ask('play', { from, seconds, pace, pauseConditions: this.#pauseConditions });
    this.#shell.notifyToolMoved(played?.place);
    this.#markRunning(played?.place);
    return played;
  }

  #onPlayed(played: PlayResult | undefined): void {
    const { place, heldBy } = played ?? { place: undefined, heldBy: 'nothing' };
    if (heldBy !== 'nothing' || place === undefined || place.share >= 1) this.#stop();
    this.#renderReadout(place, heldBy);
  }

  get #pauseConditions(): PauseConditions {
    const { block, line } = this.#extraPause;
    const { stops, isSingleBlock } = this.#options;
    const marked = this.#shell.editor.breakpoints;
    const lines = line === undefined || marked.includes(line) ? marked : [...marked, line].sort((a, b) => a - b);
    return { stops, eachBlock: isSingleBlock || block === true, lines };
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
    const wasPending = this.#pendingAction.drop();
    this.#stopTicking();
    if (wasPending) this.#showState();
  }

  #stopTicking(): void {
    if (!this.#player.stop()) return;
    this.#shell.notifyPlaying('paused');
    this.#showState();
    this.#renderReadout(this.#toolPlace);
  }

  #makeButtons(): HTMLElement {
    const element = this.#buttons.make();
    this.#nameStepButtons();
    this.#showState();
    return element;
  }

  #nameStepButtons(): void {
    this.#buttons.nameSteps(this.#options.stepUnit, this.#shell.language);
  }

  #showState(): void {
    if (this.#isActive) this.#buttons.showPlay(this.#words.pause, 'pause');
    else this.#buttons.showPlay(this.#words.play, 'play');
    this.#toolStatus.isAnnounced = !this.#player.isPlaying;
  }
}

const WORDS = words({
  en: {
    playback: 'Playback',
    play: 'Play',
    pause: 'Pause',
    position: 'Position along the path',
    positionText: (x: string, z: string) => `X diameter ${x}, Z ${z}`,
    breakpointSet: (line: number) => `The playback stops before line ${line}.`,
    breakpointRemoved: (line: number) => `The playback no longer stops before line ${line}.`,
  },
  zh: {
    playback: '播放',
    play: '播放',
    pause: '暂停',
    position: '在轨迹上的位置',
    positionText: (x, z) => `X 直径 ${x}，Z ${z}`,
    breakpointSet: (line) => `播放将在第 ${line} 行之前停下。`,
    breakpointRemoved: (line) => `播放不再停在第 ${line} 行之前。`,
  },
  ru: {
    playback: 'Воспроизведение',
    play: 'Пуск',
    pause: 'Пауза',
    position: 'Положение на траектории',
    positionText: (x, z) => `X диаметр ${x}, Z ${z}`,
    breakpointSet: (line) => `Показ остановится перед строкой ${line}.`,
    breakpointRemoved: (line) => `Показ больше не останавливается перед строкой ${line}.`,
  },
});
