// The popover of the playback: speed, unit of a step, stops, and the start at the cursor.
//
// In: whether there is a path, and optional stops. Out: the chosen values. Must not know: how the tool moves.

import { icon, make, setAccessibleName, setText } from '../dom/dom';
import type { Language } from '../dom/language';
import { placePopover, returnFocus } from '../dom/popover';
import { words } from '../dom/words';
import type { Pace, StepUnit, StopSwitch } from '../protocol/protocol';
import type { Shell } from './panel';
import { SpeedChoice } from './speed-choice';

export const STEP_UNITS: readonly StepUnit[] = ['motion', 'block', 'pass'];

interface OptionEvents {
  onStepUnitChanged(): void;
  /** Start at the block at the cursor. */
  onFromCursor(): void;
}

export class PlaybackOptions {
  readonly #speed: SpeedChoice;
  readonly #stepUnit = make('select', { className: 'speed unit' });
  readonly #unitCaption = make('span');
  readonly #optionalStopToggle = make(
    'button',
    { type: 'button', className: 'framed optional', 'aria-pressed': 'true', hidden: true },
    'M01',
  );
  readonly #singleBlockToggle = make('button', { type: 'button', className: 'framed single', 'aria-pressed': 'false' });
  readonly #fromCursor = make('button', { type: 'button' }, icon('from-here'));
  readonly #buttonText = make('span');
  /** Opens the popover and shows the speed. */
  readonly button = make(
    'button',
    { type: 'button', className: 'pace-button', 'aria-haspopup': 'dialog', 'aria-expanded': 'false' },
    this.#buttonText,
    icon('chevron'),
  );
  readonly popover: HTMLElement;
  #language: Language;

  constructor(shell: Shell, { onStepUnitChanged, onFromCursor }: OptionEvents) {
    this.#language = shell.language;
    this.#speed = new SpeedChoice(shell, () => this.#showSpeed());
    this.#stepUnit.append(...STEP_UNITS.map((unit) => make('option', { value: unit })));
    this.popover = make(
      'div',
      { className: 'popover pace', part: 'pace', role: 'dialog', popover: 'auto' },
      make('label', { className: 'choice-line' }, this.#speed.caption, this.#speed.element),
      make('label', { className: 'choice-line' }, this.#unitCaption, this.#stepUnit),
      make('div', { className: 'choice-line' }, this.#singleBlockToggle, this.#optionalStopToggle),
      make('div', { className: 'choice-line' }, this.#fromCursor),
    );
    this.button.popoverTargetElement = this.popover;
    returnFocus(this.button, this.popover);
    this.popover.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.button.setAttribute('aria-expanded', String(open));
      if (open) placePopover(this.button, this.popover);
    });
    this.#stepUnit.addEventListener('change', onStepUnitChanged);
    this.#fromCursor.hidden = !shell.showsProgram;
    this.#fromCursor.addEventListener('click', () => {
      this.popover.hidePopover();
      onFromCursor();
    });
    this.#optionalStopToggle.addEventListener('click', () => {
      this.#optionalStopToggle.setAttribute('aria-pressed', String(this.stops === 'not-optional'));
    });
    this.#singleBlockToggle.addEventListener('click', () => {
      this.#singleBlockToggle.setAttribute('aria-pressed', String(!this.isSingleBlock));
    });
  }

  set language(language: Language) {
    this.#language = language;
    const texts = WORDS[language];
    for (const option of this.#stepUnit.options) option.textContent = texts.units[option.value as StepUnit];
    this.#unitCaption.textContent = texts.stepBy;
    this.popover.setAttribute('aria-label', texts.options);
    this.button.title = texts.options;
    this.#fromCursor.replaceChildren(icon('from-here'), texts.fromHere);
    this.#fromCursor.title = `${texts.fromHere} (Ctrl Shift Enter)`;
    setAccessibleName(this.#optionalStopToggle, `M01: ${texts.optionalStops}`);
    this.#optionalStopToggle.title = texts.optionalStopsHint;
    this.#singleBlockToggle.textContent = texts.single;
    this.#singleBlockToggle.setAttribute('aria-label', `${texts.single}: ${texts.singleName}`);
    this.#singleBlockToggle.title = texts.singleHint;
    this.#speed.language = language;
  }

  /** The name of the start at the cursor. */
  get fromHereText(): string {
    return WORDS[this.#language].fromHere;
  }

  get stepUnit(): StepUnit {
    return STEP_UNITS.find((unit) => unit === this.#stepUnit.value) ?? 'motion';
  }

  get pace(): Pace {
    return this.#speed.pace;
  }

  get stops(): StopSwitch {
    return this.#optionalStopToggle.getAttribute('aria-pressed') === 'true' ? 'all' : 'not-optional';
  }

  get isSingleBlock(): boolean {
    return this.#singleBlockToggle.getAttribute('aria-pressed') === 'true';
  }

  /** The attribute `speed` has changed. */
  onSpeedChanged(): void {
    this.#speed.changed();
  }

  onNewPath(isEmpty: boolean, hasOptionalStops: boolean): void {
    this.#fromCursor.disabled = this.#singleBlockToggle.disabled = isEmpty;
    this.#optionalStopToggle.hidden = !hasOptionalStops;
  }

  #showSpeed(): void {
    const { text } = this.#speed;
    setText(this.#buttonText, text);
    this.button.setAttribute('aria-label', `${WORDS[this.#language].options}: ${text}`);
  }
}

const WORDS = words({
  en: {
    options: 'Speed and steps',
    fromHere: 'Start at the block at the cursor',
    stepBy: 'Step by',
    units: { motion: 'motion', block: 'block', pass: 'pass' },
    optionalStops: 'Optional stop',
    optionalStopsHint: 'When on, the playback stops at M01 too',
    single: 'SBK',
    singleName: 'Single block',
    singleHint: 'Single block: when on, the playback stops after each block that moves the tool',
  },
  zh: {
    options: '速度与步进',
    fromHere: '从光标所在程序段开始',
    stepBy: '步进单位',
    units: { motion: '运动', block: '程序段', pass: '走刀' },
    optionalStops: '选择停止',
    optionalStopsHint: '打开后，播放到 M01 时也停下',
    single: '单段',
    singleName: '单程序段',
    singleHint: '单程序段：打开后，每执行完一个移动刀具的程序段就停下',
  },
  ru: {
    options: 'Скорость и шаг',
    fromHere: 'С кадра у курсора',
    stepBy: 'Шаг',
    units: { motion: 'перемещение', block: 'кадр', pass: 'проход' },
    optionalStops: 'Останов по выбору',
    optionalStopsHint: 'Если включено, показ останавливается и на M01',
    single: 'SBK',
    singleName: 'Покадровая отработка',
    singleHint: 'Покадровая отработка: показ останавливается после каждого кадра с перемещением',
  },
});
