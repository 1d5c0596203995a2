// The button "3D" and its dialog: the part as a turned body with a quarter cut away, the tool, and buttons to play.
//
// In: the half-section, the holes of live tools and the position of the tool, updated as the tool moves.
// The view is loaded when the dialog is first opened, and freed when it is closed.
// Must not know: how the part was computed, or how a body is drawn.

import { Dialog } from '../dom/dialog';
import { make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { importWithRetry, whenOnline } from '../dom/network';
import { COMMON, words } from '../dom/words';
import type { DrilledHole, Readout, SectionPiece } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { NewestQuestion, Panel, PanelKind, Shell } from './panel';
import type { SolidView } from './solid-view';
import solidStyles from './solid.css?inline';

type Message = 'loading' | 'no-network' | 'no-part' | 'no-webgl';

export const solid: PanelKind = { control: 'views', styles: solidStyles, make: (shell) => new Solid(shell) };

class Solid implements Panel {
  readonly #shell: Shell;
  readonly #sectionQuestion: NewestQuestion<'section'>;
  readonly #holesQuestion: NewestQuestion<'holes'>;
  readonly #button = make('button', {
    type: 'button',
    className: 'solid-button',
    'aria-haspopup': 'dialog',
  });
  readonly #container = make('div', { className: 'text solid-holder' });
  readonly #message = make('p', { className: 'empty', role: 'status' });
  readonly #reset = make('button', { type: 'button', className: 'framed' });
  readonly #retry = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #playback = make('div');
  readonly #dialog = new Dialog('solid', [this.#container], [this.#playback, this.#reset]);
  #section: readonly SectionPiece[] | undefined;
  #holes: readonly DrilledHole[] = [];
  #place: Readout | undefined;
  #view: SolidView | undefined;
  #shownMessage: Message | undefined;
  #cancelRetry: (() => void) | undefined;

  readonly elements = { views: [this.#button], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#sectionQuestion = shell.newest('section', (pieces) => {
      if (pieces === undefined || !this.#dialog.open) return;
      this.#section = pieces;
      this.#showSection();
    });
    this.#holesQuestion = shell.newest('holes', (holes) => {
      if (holes === undefined || !this.#dialog.open) return;
      this.#holes = holes;
      if (this.#view !== undefined) this.#view.holes = holes;
    });
    this.#container.append(this.#message, this.#retry);
    this.#retry.addEventListener('click', () => void this.#draw());
    this.#button.addEventListener('click', () => void this.#show());
    this.#reset.addEventListener('click', () => this.#view?.reset());
    this.#dialog.element.addEventListener('close', () => this.#disposeView());
    this.available = false;
  }

  set language(language: Language) {
    const strings = WORDS[language];
    this.#button.textContent = strings.solid;
    setAccessibleName(this.#button, `${strings.solid}: ${strings.solidHint}`);
    this.#dialog.setTexts(strings.solidTitle, COMMON[language].close);
    this.#dialog.about = matchMedia('(pointer: coarse)').matches ? strings.solidAboutTouch : strings.solidAbout;
    this.#reset.textContent = strings.solidReset;
    this.#retry.textContent = strings.solidRetry;
    this.#view?.canvas.setAttribute('aria-label', strings.solidView);
    this.#showMessage(this.#shownMessage);
    // The language is first set after all panels are made, so the services of other panels exist.
    if (this.#playback.childElementCount === 0 && this.#shell.hasService('playbackButtons'))
      this.#playback.append(this.#shell.service('playbackButtons')());
  }

  /** Whether there is a finished run that may have produced a part. */
  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report') this.#ask();
  }

  onToolMoved(place: Readout | undefined): void {
    this.#place = place;
    this.#showTool();
    this.#ask();
  }

  onDisconnected(): void {
    this.#dialog.close();
  }

  /** Asks only while the dialog is open. */
  #ask(): void {
    if (!this.#dialog.open) return;
    this.#sectionQuestion.ask(undefined);
    this.#holesQuestion.ask(undefined);
  }

  async #show(): Promise<void> {
    if (!this.#dialog.show()) return;
    this.#ask();
    await this.#draw();
  }

  /** Draws the part. If the view could not be loaded, tries again when the network returns. */
  async #draw(): Promise<void> {
    this.#cancelRetry?.();
    this.#showMessage('loading');
    const canvas = make('canvas', { tabIndex: 0, role: 'img', 'aria-label': WORDS[this.#shell.language].solidView });
    const context = canvas.getContext('webgl2', { antialias: true });
    if (context === null) {
      this.#showMessage('no-webgl');
      return;
    }
    // Half a megabyte that most users never need.
    const part = await importWithRetry(() => import('./solid-view')).catch(() => undefined);
    // Closed meanwhile, or closed and opened again.
    if (!this.#dialog.open || this.#view !== undefined) return;
    if (part === undefined) {
      this.#cancelRetry = whenOnline(() => void this.#draw());
      this.#showMessage('no-network');
      return;
    }
    this.#container.prepend(canvas);
    this.#view = new part.SolidView(canvas, context);
    this.#showTool();
    this.#showSection();
    canvas.focus();
  }

  #showTool(): void {
    const stroke = this.#place?.stroke;
    if (this.#view !== undefined)
      this.#view.tool = stroke === undefined ? undefined : { z: stroke.atZ, r: stroke.atX / 2 };
  }

  #showSection(): void {
    const section = this.#section;
    if (this.#view === undefined || section === undefined) return;
    this.#view.section = section;
    this.#view.holes = section.length === 0 ? [] : this.#holes;
    this.#showMessage(section.length === 0 ? 'no-part' : undefined);
  }

  /** Shows a message in place of the picture, or the picture. */
  #showMessage(message: Message | undefined): void {
    this.#shownMessage = message;
    const { solidLoading, solidNoNetwork, solidNoPart, solidNoWebGl } = WORDS[this.#shell.language];
    const texts = {
      loading: solidLoading,
      'no-network': solidNoNetwork,
      'no-part': solidNoPart,
      'no-webgl': solidNoWebGl,
    };
    this.#message.textContent = message === undefined ? '' : texts[message];
    this.#retry.hidden = message !== 'no-network';
    this.#reset.disabled = message !== undefined;
  }

  #disposeView(): void {
    this.#cancelRetry?.();
    this.#view?.dispose();
    this.#view = undefined;
    this.#section = undefined;
    this.#holes = [];
  }
}

const WORDS = words({
  en: {
    solid: '3D',
    solidHint: 'Show the part as a solid, a quarter cut away',
    solidTitle: 'The part, a quarter cut away',
    solidAbout:
      'Drag or arrow keys turn it, wheel or + and − zoom, Home resets the view. Ctrl Enter plays the program, F9 steps.',
    solidAboutTouch: 'Drag with one finger to turn the part, and spread two fingers to zoom.',
    /** For screen readers. */
    solidView: 'The turned part in three dimensions. Arrow keys turn it, plus and minus zoom, Home resets the view.',
    solidLoading: 'Loading …',
    solidNoNetwork: 'The view could not be loaded: no network connection. Will retry when you are back online.',
    solidRetry: 'Try again',
    solidNoPart: 'There is no part to show: nothing is left of the blank, or it is not known.',
    solidNoWebGl:
      'This browser does not draw in three dimensions (WebGL is missing or switched off). The drawing shows the same part in section.',
    solidReset: 'Reset view',
  },
  zh: {
    solid: '三维',
    solidHint: '以剖去四分之一的实体显示零件',
    solidTitle: '零件（剖去四分之一）',
    solidAbout: '拖动或方向键旋转，滚轮或 + − 缩放，Home 键恢复初始视角。Ctrl Enter 播放程序，F9 单步。',
    solidAboutTouch: '单指拖动旋转零件，双指张合缩放。',
    solidView: '车削零件的三维视图。方向键旋转，加号和减号缩放，Home 键恢复初始视角。',
    solidLoading: '正在加载……',
    solidNoNetwork: '三维视图无法加载：没有网络。网络恢复后会自动加载。',
    solidRetry: '重试',
    solidNoPart: '没有可显示的零件：毛坯已无剩余，或毛坯未知。',
    solidNoWebGl: '此浏览器无法显示三维图形（缺少 WebGL 或已关闭）。平面图中可看到同一零件的剖面。',
    solidReset: '重置视图',
  },
  ru: {
    solid: '3D',
    solidHint: 'Показать деталь как тело с вырезанной четвертью',
    solidTitle: 'Деталь с вырезом четверти',
    solidAbout:
      'Перетаскивание и стрелки поворачивают, колесо или + и − меняют масштаб, Home сбрасывает вид. Ctrl Enter запускает программу, F9 — один шаг.',
    solidAboutTouch: 'Одним пальцем деталь поворачивают, двумя меняют масштаб.',
    solidView:
      'Точёная деталь в трёх измерениях. Стрелки поворачивают её, плюс и минус меняют масштаб, Home сбрасывает вид.',
    solidLoading: 'Загрузка …',
    solidNoNetwork: 'Вид загрузить не удалось: нет сети. Загрузка повторится, когда сеть появится.',
    solidRetry: 'Повторить',
    solidNoPart: 'Нечего показать: от заготовки ничего не осталось, или она неизвестна.',
    solidNoWebGl:
      'Этот браузер не показывает трёхмерную графику (WebGL отсутствует или выключен). На чертеже та же деталь видна в разрезе.',
    solidReset: 'Сбросить вид',
  },
});
