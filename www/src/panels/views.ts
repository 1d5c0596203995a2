// The row over the pictures: the choice of pictures, the side of the turret, and the part to compare with.
//
// In: the pictures that exist, and the available width. Must not know: how anything is drawn or compared.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import {
  PICTURES,
  type Comparison,
  type LengthUnit,
  type PictureChoice,
  type PictureName,
  type ViewsState,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { formatLength, unitSymbol } from './lengths';
import type { Panel, PanelKind, Services, Shell } from './panel';
import viewsStyles from './views.css?inline';

/** Below this width, CSS pixels, only one picture is shown. */
const MIN_WIDTH_FOR_ALL_PX = 620;

const CHOICES = [...PICTURES, 'all'] as const;

export const views: PanelKind = { control: 'views', styles: viewsStyles, make: (shell) => new Views(shell) };

class Views implements Panel {
  readonly #shell: Shell;
  readonly #row: HTMLElement;
  readonly #choice = make('div', { className: 'choice', role: 'radiogroup', hidden: true });
  readonly #buttons: Readonly<Record<PictureChoice, HTMLButtonElement>>;
  readonly #turret = menuItem({ role: 'menuitemcheckbox' });
  readonly #keepButton = menuItem();
  readonly #endButton = make('button', { type: 'button', className: 'small framed', hidden: true });
  readonly #differences = make('div', { className: 'differences', 'aria-live': 'polite', hidden: true });
  #state: ViewsState = { pictures: ['section'], work: [], turret: 'rear', comparison: undefined };
  /** Who began the comparison: the host page must not end one that the user began. */
  #startedBy: 'user' | 'page' = 'user';
  #preferred: PictureChoice = 'all';
  #current: PictureChoice = 'section';
  #shownPictures = '';
  #unit: LengthUnit = 'mm';
  /** Width of the row, CSS pixels. */
  #width = 0;

  readonly services: Partial<Services> = {
    keepPart: () => this.#keepPart('page'),
    endComparison: () => {
      if (this.#startedBy === 'page') this.#shell.send({ kind: 'end-comparison' });
    },
  };
  readonly elements = {
    views: [this.#choice, this.#differences, this.#endButton],
    'more-menu': [this.#turret, this.#keepButton],
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#row = shell.region('views');
    const makeButton = (pictures: PictureChoice): HTMLButtonElement => {
      const button = make('button', { type: 'button', className: 'framed', role: 'radio' });
      button.addEventListener('click', () => this.#choose(pictures));
      button.addEventListener('keydown', (event) => this.#handleKey(event));
      return button;
    };
    this.#buttons = {
      section: makeButton('section'),
      face: makeButton('face'),
      side: makeButton('side'),
      all: makeButton('all'),
    };
    this.#choice.append(...CHOICES.map((choice) => this.#buttons[choice]));
    this.#turret.addEventListener('click', () =>
      shell.send({ kind: 'turret', side: this.#state.turret === 'front' ? 'rear' : 'front' }),
    );
    this.#keepButton.addEventListener('click', () => this.#keepPart('user'));
    this.#endButton.addEventListener('click', () => {
      this.#startedBy = 'user';
      shell.send({ kind: 'end-comparison' });
      shell.editor.focus();
    });
    new ResizeObserver(() => {
      // Elements that float over the pictures are placed below this row.
      this.#width = this.#row.getBoundingClientRect().width;
      this.#row.parentElement?.style.setProperty('--views-size', `${this.#row.offsetHeight}px`);
      this.#show();
    }).observe(this.#row);
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#row.setAttribute('aria-label', texts.views);
    this.#choice.setAttribute('aria-label', texts.view);
    for (const picture of PICTURES) this.#buttons[picture].textContent = texts[picture];
    this.#buttons.side.title = texts.sideHint;
    this.#turret.textContent = texts.frontTurret;
    this.#turret.title = texts.frontTurretHint;
    this.#keepButton.textContent = texts.keep;
    this.#keepButton.title = texts.keepHint;
    this.#endButton.textContent = texts.endComparison;
    this.#show();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report') this.#unit = event.report.units.shown;
    const state = event.kind === 'views' ? event.views : event.kind === 'report' ? event.report.views : undefined;
    if (state === undefined) return;
    this.#state = state;
    this.#show();
  }

  #keepPart(by: 'user' | 'page'): void {
    this.#startedBy = by;
    this.#shell.send({ kind: 'keep-part' });
  }

  #choose(pictures: PictureChoice): void {
    this.#preferred = pictures;
    this.#show();
  }

  #handleKey(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    const order = CHOICES.filter((choice) => !this.#buttons[choice].hidden);
    const next = order[(order.indexOf(this.#current) + step + order.length) % order.length];
    if (next === undefined) return;
    this.#choose(next);
    this.#buttons[next].focus();
    event.preventDefault();
  }

  #show(): void {
    const { pictures, turret, comparison } = this.#state;
    const texts = WORDS[this.#shell.language];
    const wide = this.#width >= MIN_WIDTH_FOR_ALL_PX;
    this.#current = this.#choiceOf(pictures, wide);
    this.#choice.hidden = pictures.length < 2;
    this.#buttons.all.textContent = pictures.length > 2 ? texts.all : texts.both;
    for (const choice of CHOICES) {
      const button = this.#buttons[choice];
      button.hidden = choice === 'all' ? !wide : !pictures.includes(choice);
      button.setAttribute('aria-checked', String(choice === this.#current));
      button.tabIndex = choice === this.#current ? 0 : -1;
    }
    this.#turret.setAttribute('aria-checked', String(turret === 'front'));
    this.#keepButton.hidden = comparison !== undefined;
    this.#endButton.hidden = this.#differences.hidden = comparison === undefined;
    if (comparison !== undefined) this.#differences.replaceChildren(...this.#describe(comparison));
    const current = this.#current;
    const shown = current === 'all' ? pictures : [current];
    if (shown.join() === this.#shownPictures) return;
    this.#shownPictures = shown.join();
    this.#shell.service('showOnly')(shown);
  }

  /**
   * The picture to show: the user's choice, if it exists and there is room; otherwise all pictures or,
   * without room for them, the one that is not the section.
   */
  #choiceOf(pictures: readonly PictureName[], wide: boolean): PictureChoice {
    if (pictures.length < 2) return 'section';
    const preferred = this.#preferred;
    if (preferred === 'all' ? wide : pictures.includes(preferred)) return preferred;
    return wide ? 'all' : (pictures.find((picture) => picture !== 'section') ?? 'section');
  }

  #describe({ differences, radial, axial }: Comparison): (Node | string)[] {
    const texts = WORDS[this.#shell.language];
    if (radial === undefined || axial === undefined) return [texts.same];
    const key = (side: 'first' | 'second', text: string): Node[] =>
      differences.some(({ only }) => only === side)
        ? [make('span', { className: 'only' }, make('span', { className: `patch ${side}` }), text)]
        : [];
    const shown = (mm: number): string => formatLength(mm, this.#unit);
    const measure = (mm: number): string => `${shown(mm)} ${unitSymbol(this.#unit, this.#shell.language)}`;
    const largest = texts.largest(
      measure(radial.length),
      shown(radial.from.z),
      measure(axial.length),
      shown(axial.from.x),
    );
    return [...key('first', texts.onlyKept), ...key('second', texts.onlyNow), make('span', {}, largest)];
  }
}

const WORDS = words({
  en: {
    views: 'Views',
    view: 'View',
    section: 'Section',
    face: 'Face',
    side: 'Side',
    sideHint: 'The side, unrolled where C turns',
    both: 'Both',
    all: 'All',
    frontTurret: 'Front turret',
    frontTurretHint: 'The turret is in front of the spindle: X+ is drawn downwards',
    keep: 'Keep this part to compare',
    keepHint: 'Keep this part, then change the program or open another one: the difference is marked and measured',
    endComparison: 'End comparison',
    same: 'Same as the reference',
    onlyKept: 'only in the reference',
    onlyNow: 'only in this part',
    largest: (radial: string, z: string, axial: string, x: string) =>
      `Largest: ${radial} in radius at Z${z}; ${axial} along Z at X${x}`,
  },
  zh: {
    views: '视图',
    view: '视图',
    section: '剖面',
    face: '端面',
    side: '圆柱面',
    sideHint: '圆柱面；C 轴转动时为展开图',
    both: '两者',
    all: '全部',
    frontTurret: '前置刀架',
    frontTurretHint: '刀架在主轴前方：X+ 向下画',
    keep: '保留此零件用于比较',
    keepHint: '保留此零件，然后修改程序或打开另一个程序：差异会标出并测量',
    endComparison: '结束比较',
    same: '与参照零件相同',
    onlyKept: '仅参照零件有',
    onlyNow: '仅当前零件有',
    largest: (radial, z, axial, x) => `最大差异：Z${z} 处半径 ${radial}；X${x} 处沿 Z ${axial}`,
  },
  ru: {
    views: 'Виды',
    view: 'Вид',
    section: 'Разрез',
    face: 'Торец',
    side: 'Развёртка',
    sideHint: 'Боковая поверхность: развёртка, а без поворотов C — вид сверху',
    both: 'Оба',
    all: 'Все',
    frontTurret: 'Передняя револьверная головка',
    frontTurretHint: 'Револьверная головка находится перед осью шпинделя: X+ направлен вниз',
    keep: 'Запомнить деталь для сравнения',
    keepHint: 'Запомните деталь, затем измените программу или откройте другую: различие будет отмечено и измерено',
    endComparison: 'Закончить сравнение',
    same: 'Совпадает с образцом',
    onlyKept: 'только в образце',
    onlyNow: 'только в этой детали',
    largest: (radial, z, axial, x) => `Наибольшее: ${radial} по радиусу при Z${z}; ${axial} вдоль Z при X${x}`,
  },
});
