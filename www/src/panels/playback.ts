// The bar under the drawing: play, step, scrub, speed, stops, and the readout of the tool position.
//
// In: whether there is anything to play and, as answers, where the tool is. Out: where the tool is to be; the block it
// is in is marked in the text. While it plays, each painted frame asks how far the tool has moved; while it is paused,
// nothing runs. Must not know: how the path is drawn, or the meaning of a stroke.

import { icon, make, name, unbroken } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type {
  HeldBy,
  Holds,
  LengthUnit,
  Pace,
  Played,
  Readout,
  StepDirection,
  StepUnit,
  StopSwitch,
} from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { Key, NewestQuestion, Panel, PanelKind, Services, Shell } from './panel';
import { place as shownPlace } from './lengths';
import playbackStyles from './playback.css?inline';
import { ReadoutBoard } from './readout';

/** Durations in which the whole program can be played, s; the first is the default. */
const WHOLE: readonly number[] = [20, 60];
/** Multiples of the machine's speed. */
const SPEEDS: readonly number[] = [0.5, 1, 2, 5, 10, 50];
const UNITS: readonly StepUnit[] = ['motion', 'block', 'pass'];
/** A longer interval between two frames, s, is limited to this: the page was hidden, or the computer slept. */
const LONGEST_FRAME = 0.5;

/** Where one take stops, in addition to stops and breakpoints: at the end of its block, or before a line (from 0). */
interface Until {
  readonly block?: true;
  readonly line?: number;
}

/** An action of the user that waits for the path of the current text. */
interface Wish {
  readonly act: () => void;
  /** Whether the action starts the playback. */
  readonly plays: boolean;
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
  readonly #play = make('button', { type: 'button', className: 'play', part: 'play' });
  readonly #playIcon = make('span', { className: 'play-icon' });
  readonly #playText = make('span', { className: 'play-text' });
  readonly #back = make('button', { type: 'button', className: 'quiet' }, icon('previous'));
  readonly #forward = make('button', { type: 'button', className: 'quiet' }, icon('next'));
  readonly #here = make('button', { type: 'button' }, icon('from-here'));
  readonly #unit = make('select', { className: 'speed unit' });
  readonly #whole = make('button', { type: 'button', className: 'quiet' }, icon('whole'));
  readonly #slider = make('input', { type: 'range', min: '0', max: '1', step: 'any', value: '0', className: 'scrub' });
  readonly #speed = make('select', { className: 'speed' });
  readonly #optional = make(
    'button',
    { type: 'button', className: 'level optional', 'aria-pressed': 'true', hidden: true },
    'M01',
  );
  readonly #single = make('button', { type: 'button', className: 'level single', 'aria-pressed': 'false' });
  readonly #doing = make('p', { className: 'doing', part: 'doing', 'aria-live': 'polite' });
  readonly #board: ReadoutBoard;
  readonly #wholeOptions = WHOLE.map((seconds) => make('option', { value: `whole ${seconds}` }));
  /** Start of the block that is marked as running. */
  #running: number | undefined;
  #place: Readout | undefined;
  /** `#frame`: the next animation frame; `#asking`: an answer about the tool is pending. */
  #frame: number | undefined;
  #asking = false;
  #lastFrame: number | undefined;
  /** Seconds since the last question. */
  #elapsed = 0;
  #from: 'here' | 'start' = 'here';
  /** Number of the take: an answer to an earlier take is ignored. */
  #take = 0;
  #until: Until = {};
  /** Number of changes of text and setup; `#pathOf` is the change that the current path belongs to. */
  #changes = 0;
  #pathOf = -1;
  #wish: Wish | undefined;
  #held: HeldBy = 'nothing';
  #doingShown = '';
  #lengths: LengthUnit = 'mm';
  readonly places: Panel['places'];
  readonly services: Partial<Services> = {
    play: () => this.#start({}),
    pause: () => this.#stop(),
    playOrPause: () => this.#toggle(),
    step: (unit, direction) => this.#step(unit, direction),
    goTo: (motion) => this.#put(this.#shell.ask('go-to', { motion })),
    goToBlock: (offset) => this.#put(this.#shell.ask('seek-block', { offset })),
    playBlock: () => this.#playFromHere({ block: true }),
    playToCursor: () => this.#playToCursor(),
    toggleBreakpoint: () => this.#toggleBreakpoint(),
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#row = shell.region('playback');
    this.#seek = shell.newest('seek', (place) => this.#showTool(place));
    this.#board = new ReadoutBoard(shell.language);
    this.#play.append(this.#playIcon, this.#playText);
    this.#speed.append(
      ...this.#wholeOptions,
      ...SPEEDS.map((speed) => make('option', { value: `times ${speed}` }, `${speed}×`)),
    );
    this.#unit.append(...UNITS.map((unit) => make('option', { value: unit })));
    this.places = {
      playback: [
        make('div', { className: 'buttons' }, this.#back, this.#play, this.#forward, this.#here),
        this.#unit,
        this.#slider,
        make('div', { className: 'place' }, this.#single, this.#optional, this.#speed, this.#whole),
        this.#board.element,
        this.#doing,
      ],
    };
    this.#play.addEventListener('click', () => this.#toggle());
    this.#here.hidden = !shell.showsProgram;
    this.#here.addEventListener('click', () => this.#playFromHere({}));
    this.#back.addEventListener('click', () => this.#step(this.#chosenUnit, 'previous'));
    this.#forward.addEventListener('click', () => this.#step(this.#chosenUnit, 'next'));
    this.#unit.addEventListener('change', () => this.#nameSteps());
    this.#whole.addEventListener('click', () => this.#showWholePath());
    this.#slider.addEventListener('input', () => this.#scrub());
    this.#optional.addEventListener('click', () => {
      this.#optional.setAttribute('aria-pressed', String(this.#stops === 'not-optional'));
    });
    this.#single.addEventListener('click', () => {
      this.#single.setAttribute('aria-pressed', String(!this.#isSingle));
    });
    this.#show(undefined);
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#row.setAttribute('aria-label', texts.playback);
    for (const [i, option] of this.#wholeOptions.entries()) option.textContent = texts.wholeIn(WHOLE[i] ?? 0);
    for (const option of this.#unit.options) option.textContent = texts.units[option.value as StepUnit];
    this.#unit.setAttribute('aria-label', texts.stepBy);
    this.#unit.title = texts.stepBy;
    name(this.#here, `${texts.fromHere} (Ctrl Shift Enter)`);
    name(this.#optional, `M01: ${texts.optionalStops}`);
    this.#optional.title = texts.optionalStopsHint;
    this.#single.textContent = texts.single;
    this.#single.setAttribute('aria-label', `${texts.single}: ${texts.singleName}`);
    this.#single.title = texts.singleHint;
    name(this.#whole, texts.wholePath);
    this.#slider.setAttribute('aria-label', texts.position);
    this.#speed.setAttribute('aria-label', texts.speed);
    this.#speed.title = texts.speed;
    this.#board.language = language;
    this.#nameSteps();
    this.#showPlaying();
  }

  heard(event: Heard): void {
    if (event.kind !== 'report') return;
    const { stage, summary, units } = event.report;
    this.#lengths = this.#board.unit = units.shown;
    // The path was shown before, and the user may be playing it.
    if (stage === 'whole' || stage === 'path') {
      const line = this.#place === undefined ? undefined : this.#shell.editor.runningLine;
      this.#program(summary.motions, summary.optionalStops);
      void this.#pathCame(line);
    } else if (stage === 'again' && this.#place !== undefined) {
      void this.#shell.ask('readout', undefined).then((place) => this.#showTool(place));
    }
  }

  pressed({ event }: Key): 'own' | 'not-own' {
    const control = event.ctrlKey || event.metaKey;
    if (event.key === 'Enter' && control && event.shiftKey) this.#playFromHere({});
    else if (event.key === 'F10' && control) this.#playToCursor();
    else if (event.key === 'F10') this.#playFromHere({ block: true });
    else if (event.key === 'F8' && control) this.#toggleBreakpoint();
    else if (event.key === 'Enter' && control) this.#toggle();
    else if (event.key === 'F9')
      this.#step(control ? 'block' : event.altKey ? 'pass' : 'motion', event.shiftKey ? 'previous' : 'next');
    else return 'not-own';
    return 'own';
  }

  outdated(): void {
    this.#stop();
    this.#changes++;
  }

  lost(): void {
    this.#stop();
    this.#program(0, 0);
    this.#show(undefined);
  }

  left(): void {
    this.#stop();
  }

  get #words(): (typeof WORDS)['en'] {
    return WORDS[this.#shell.language];
  }

  /** A new path was drawn: number of its motions and of its optional stops. */
  #program(motions: number, optionalStops: number): void {
    this.#halt();
    for (const control of [this.#play, this.#back, this.#forward, this.#here, this.#slider, this.#single])
      control.disabled = motions <= 0;
    this.#optional.hidden = optionalStops <= 0;
  }

  /**
   * After an edit, returns the tool to the block that it was in, also if the next edit comes before the answer. Then
   * carries out the pending action of the user.
   */
  async #pathCame(line: number | undefined): Promise<void> {
    const changes = this.#changes;
    const place = line === undefined ? undefined : await this.#shell.ask('seek-block', { offset: line });
    if (changes !== this.#changes) return;
    this.#showTool(place);
    this.#pathOf = changes;
    const wish = this.#wish;
    this.#wish = undefined;
    wish?.act();
    this.#showPlaying();
  }

  /** Carries out an action as soon as the path of the current text exists. */
  #onceThere(wish: Wish): void {
    this.#shell.flush();
    if (this.#pathOf === this.#changes) return wish.act();
    this.#wish = wish;
    this.#showPlaying();
  }

  /** Shows the tool position. */
  #show(place: Readout | undefined, held: HeldBy = 'nothing'): void {
    this.#place = place;
    this.#held = held;
    // While the user drags the slider, an answer to an earlier position must not move it.
    if (!this.#slider.matches(':active')) this.#slider.value = String(place?.share ?? 0);
    this.#board.shown = place;
    // Hidden but not removed: otherwise the drawing would jump with the first step.
    this.#whole.classList.toggle('not-yet', place === undefined);
    this.#showDoing();
    // During playback the announcements would never end.
    if (this.#playing) return;
    const stroke = place?.stroke;
    const spoken =
      stroke === undefined
        ? '–'
        : this.#words.positionText(shownPlace(stroke.atX, this.#lengths), shownPlace(stroke.atZ, this.#lengths));
    this.#slider.setAttribute('aria-valuetext', spoken);
  }

  get #playing(): boolean {
    return this.#frame !== undefined;
  }

  #toggle(): void {
    if (this.#playing || this.#wish?.plays === true) this.#stop();
    else this.#start({});
  }

  #start(until: Until): void {
    if (!this.#playing) this.#onceThere({ plays: true, act: () => this.#startNow(until) });
  }

  #startNow(until: Until): void {
    if (this.#playing || this.#play.disabled) return;
    this.#until = until;
    this.#from = this.#place === undefined || this.#place.share >= 1 ? 'start' : 'here';
    this.#lastFrame = undefined;
    this.#elapsed = 0;
    this.#asking = false;
    this.#take++;
    this.#frame = requestAnimationFrame(this.#tick);
    this.#showPlaying();
  }

  /** Plays from the block at the cursor; with `block`, only that block. */
  #playFromHere(until: { readonly block?: true }): void {
    this.#stop();
    const act = async (): Promise<void> => {
      const place = await this.#shell.ask('seek-block', { offset: this.#shell.editor.cursor });
      this.#showTool(place);
      if (place !== undefined) this.#startNow(until);
    };
    this.#onceThere({ plays: true, act: () => void act() });
  }

  /** Plays to the block at the cursor, from the tool position or from the start. */
  #playToCursor(): void {
    this.#stop();
    this.#start({ line: this.#shell.editor.lineOf(this.#shell.editor.cursor) });
  }

  #toggleBreakpoint(): void {
    const { editor } = this.#shell;
    const line = editor.lineOf(editor.cursor) + 1;
    editor.announce(editor.toggleBreakpoint() ? this.#words.breakpointSet(line) : this.#words.breakpointGone(line));
  }

  #step(unit: StepUnit, direction: StepDirection): void {
    this.#stop();
    const act = (): void => {
      if (this.#play.disabled) return;
      this.#shell.editor.follow();
      // Shows the block even if it is the same one as before.
      this.#running = undefined;
      void this.#shell.ask('step', { unit, direction }).then((place) => this.#showTool(place));
    };
    this.#onceThere({ plays: false, act });
  }

  async #put(asked: Promise<Readout | undefined>): Promise<void> {
    this.#stop();
    this.#shell.editor.follow();
    this.#showTool(await asked);
  }

  #showWholePath(): void {
    this.#stop();
    this.#show(undefined);
    this.#seek.ask({ share: undefined });
    this.#play.focus({ preventScroll: true });
  }

  #tick = (now: number): void => {
    const elapsed = this.#lastFrame === undefined ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    this.#elapsed += Math.min(elapsed, LONGEST_FRAME);
    this.#frame = requestAnimationFrame(this.#tick);
    // One question at a time: if the interpreter is slow, the tool moves in larger steps.
    if (this.#asking || this.#elapsed === 0) return;
    this.#asking = true;
    const take = this.#take;
    const asked = this.#ask(this.#from, this.#elapsed);
    [this.#from, this.#elapsed] = ['here', 0];
    void asked.then((played) => {
      if (take !== this.#take) return;
      this.#asking = false;
      const { place, held } = played ?? { place: undefined, held: 'nothing' };
      if (held !== 'nothing' || place === undefined || place.share >= 1) this.#stop();
      this.#show(place, held);
    });
  };

  /** Plays this many seconds; `start` begins at the start of the program. */
  async #ask(from: 'here' | 'start', seconds: number): Promise<Played | undefined> {
    const played = await this.#shell.ask('play', { from, seconds, pace: this.#pace, holds: this.#holds });
    this.#shell.toolMoved(played?.place);
    this.#markRunning(played?.place);
    return played;
  }

  get #holds(): Holds {
    const { block, line } = this.#until;
    const marked = this.#shell.editor.breakpoints;
    const lines = line === undefined || marked.includes(line) ? marked : [...marked, line].sort((a, b) => a - b);
    return { stops: this.#stops, eachBlock: this.#isSingle || block === true, lines };
  }

  get #isSingle(): boolean {
    return this.#single.getAttribute('aria-pressed') === 'true';
  }

  #showTool(place: Readout | undefined): void {
    this.#show(place);
    this.#shell.toolMoved(place);
    this.#markRunning(place);
  }

  /** Marks the block that runs, or that stops the tool. */
  #markRunning(place: Readout | undefined): void {
    const block = place?.stop ?? place?.stroke;
    if (block?.from === this.#running) return;
    this.#running = block?.from;
    this.#shell.editor.running = block;
  }

  #scrub(): void {
    this.#stop();
    this.#seek.ask({ share: this.#slider.valueAsNumber });
  }

  /** Stops the tool and drops the pending action. */
  #stop(): void {
    const waited = this.#wish !== undefined;
    this.#wish = undefined;
    this.#halt();
    if (waited) this.#showPlaying();
  }

  #halt(): void {
    if (this.#frame === undefined) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#take++;
    this.#showPlaying();
    this.#show(this.#place);
  }

  get #pace(): Pace {
    const [kind, number] = this.#speed.value.split(' ');
    return kind === 'times' ? { kind, factor: Number(number) } : { kind: 'whole', seconds: Number(number) };
  }

  get #stops(): StopSwitch {
    return this.#optional.getAttribute('aria-pressed') === 'true' ? 'all' : 'not-optional';
  }

  get #chosenUnit(): StepUnit {
    return UNITS.find((unit) => unit === this.#unit.value) ?? 'motion';
  }

  #nameSteps(): void {
    const key = { motion: 'F9', block: 'Ctrl F9', pass: 'Alt F9' }[this.#chosenUnit];
    const texts = this.#words;
    name(this.#back, `${texts.previous[this.#chosenUnit]} (Shift ${key})`);
    name(this.#forward, `${texts.next[this.#chosenUnit]} (${key})`);
  }

  #showDoing(): void {
    const { stroke, stop } = this.#place ?? {};
    let text = '';
    const atLine = this.#held === 'line' && stroke !== undefined ? stroke.line : undefined;
    if (atLine !== undefined) text = this.#words.heldAt(atLine);
    else if (stop !== undefined) text = this.#words.stopped(stop.code, stop.line);
    else if (stroke !== undefined) text = `${COMMON[this.#shell.language].line(stroke.line)}: ${stroke.text}`;
    if (text === this.#doingShown) return;
    this.#doingShown = text;
    this.#doing.classList.toggle('stopped', stop !== undefined || atLine !== undefined);
    this.#doing.replaceChildren(...(text === '' ? [] : unbroken(text)));
  }

  #showPlaying(): void {
    const isUnderWay = this.#playing || this.#wish?.plays === true;
    const text = isUnderWay ? this.#words.pause : this.#words.play;
    this.#playIcon.replaceChildren(icon(isUnderWay ? 'pause' : 'play'));
    this.#playText.textContent = text;
    this.#play.title = `${text} (Ctrl Enter)`;
    this.#doing.setAttribute('aria-live', this.#playing ? 'off' : 'polite');
  }
}

const WORDS = words({
  en: {
    playback: 'Playback',
    play: 'Play',
    pause: 'Pause',
    wholePath: 'Show the whole path',
    position: 'Position along the path',
    positionText: (x: string, z: string) => `X diameter ${x}, Z ${z}`,
    speed: 'Speed',
    previous: { motion: 'Previous motion', block: 'Previous block', pass: 'Previous pass' },
    next: { motion: 'Next motion', block: 'Next block', pass: 'Next pass' },
    fromHere: 'Start at the block of the cursor',
    stepBy: 'Step by',
    units: { motion: 'motion', block: 'block', pass: 'pass' },
    wholeIn: (seconds: number) => `all in ${seconds} s`,
    optionalStops: 'Optional stop',
    optionalStopsHint: 'When on, the playback stops at M01 too',
    stopped: (code: string, line: number) => `${code} in line ${line}: the program stops here. Play goes on.`,
    heldAt: (line: number) => `Held before line ${line}. Play goes on.`,
    single: 'SBK',
    singleName: 'Single block',
    singleHint: 'Single block: when on, the playback stops after each block that moves the tool',
    breakpointSet: (line: number) => `The playback stops before line ${line}.`,
    breakpointGone: (line: number) => `The playback no longer stops before line ${line}.`,
  },
  zh: {
    playback: '播放',
    play: '播放',
    pause: '暂停',
    wholePath: '显示完整轨迹',
    position: '在轨迹上的位置',
    positionText: (x, z) => `X 直径 ${x}，Z ${z}`,
    speed: '速度',
    previous: { motion: '上一段运动', block: '上一程序段', pass: '上一次走刀' },
    next: { motion: '下一段运动', block: '下一程序段', pass: '下一次走刀' },
    fromHere: '从光标所在程序段开始',
    stepBy: '步进单位',
    units: { motion: '运动', block: '程序段', pass: '走刀' },
    wholeIn: (seconds) => `全程 ${seconds} 秒`,
    optionalStops: '选择停止',
    optionalStopsHint: '打开后，播放到 M01 时也停下',
    stopped: (code, line) => `第 ${line} 行 ${code}：程序在此停止，按“播放”继续。`,
    heldAt: (line) => `停在第 ${line} 行之前，按“播放”继续。`,
    single: '单段',
    singleName: '单程序段',
    singleHint: '单程序段：打开后，每执行完一个移动刀具的程序段就停下',
    breakpointSet: (line) => `播放将在第 ${line} 行之前停下。`,
    breakpointGone: (line) => `播放不再停在第 ${line} 行之前。`,
  },
  ru: {
    playback: 'Воспроизведение',
    play: 'Пуск',
    pause: 'Пауза',
    wholePath: 'Показать всю траекторию',
    position: 'Положение на траектории',
    positionText: (x, z) => `X диаметр ${x}, Z ${z}`,
    speed: 'Скорость',
    previous: { motion: 'Предыдущее перемещение', block: 'Предыдущий кадр', pass: 'Предыдущий проход' },
    next: { motion: 'Следующее перемещение', block: 'Следующий кадр', pass: 'Следующий проход' },
    fromHere: 'С кадра у курсора',
    stepBy: 'Шаг',
    units: { motion: 'перемещение', block: 'кадр', pass: 'проход' },
    wholeIn: (seconds) => `всё за ${seconds} с`,
    optionalStops: 'Останов по выбору',
    optionalStopsHint: 'Если включено, показ останавливается и на M01',
    stopped: (code, line) => `${code} в строке ${line}: здесь программа останавливается. «Пуск» — дальше.`,
    heldAt: (line) => `Пауза перед строкой ${line}. «Пуск» — дальше.`,
    single: 'SBK',
    singleName: 'Покадровая отработка',
    singleHint: 'Покадровая отработка: показ останавливается после каждого кадра с перемещением',
    breakpointSet: (line) => `Показ остановится перед строкой ${line}.`,
    breakpointGone: (line) => `Показ больше не останавливается перед строкой ${line}.`,
  },
});
