// The button "3D" and its dialog: the part as a turned body with a quarter cut away.
//
// In: the half-section at the moment that is shown, again when that moves on.
// What draws it is loaded when it is first opened, and let go of when it is closed.
// Must not know: how the part came about, or how a body is drawn.

import { Dialog } from '../dom/dialog';
import { make, name } from '../dom/dom';
import type { Language } from '../dom/language';
import { COMMON, words } from '../dom/words';
import type { SectionPiece } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { NewestQuestion, Panel, PanelKind, Shell } from './panel';
import type { SolidView } from './solid-view';
import solidStyles from './solid.css?inline';

type Missing = 'loading' | 'no-part' | 'no-webgl';

export const solid: PanelKind = { control: 'views', styles: solidStyles, make: (shell) => new Solid(shell) };

class Solid implements Panel {
  readonly #shell: Shell;
  readonly #pieces: NewestQuestion<'section'>;
  readonly #button = make('button', { type: 'button', className: 'solid-button quiet outlined', 'aria-haspopup': 'dialog' });
  readonly #holder = make('div', { className: 'text solid-holder' });
  readonly #message = make('p', { className: 'empty', role: 'status' });
  readonly #reset = make('button', { type: 'button', className: 'framed' });
  readonly #dialog = new Dialog('solid', [this.#holder], [this.#reset]);
  #section: readonly SectionPiece[] | undefined;
  #view: SolidView | undefined;
  #missing: Missing | undefined;

  readonly places = { foot: [this.#button], dialogs: [this.#dialog.element] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#pieces = shell.newest('section', (pieces) => {
      if (pieces === undefined || !this.#dialog.open) return;
      this.#section = pieces;
      this.#showSection();
    });
    this.#holder.append(this.#message);
    this.#button.addEventListener('click', () => void this.#show());
    this.#reset.addEventListener('click', () => this.#view?.reset());
    this.#dialog.element.addEventListener('close', () => this.#free());
    this.available = false;
  }

  set language(language: Language) {
    const strings = WORDS[language];
    this.#button.textContent = strings.solid;
    name(this.#button, `${strings.solid}: ${strings.solidHint}`);
    this.#dialog.name(strings.solidTitle, COMMON[language].close);
    this.#dialog.about = strings.solidAbout;
    this.#reset.textContent = strings.solidReset;
    this.#view?.canvas.setAttribute('aria-label', strings.solidView);
    this.#tell(this.#missing);
  }

  /** Whether there is a finished run that may have left a part. */
  set available(available: boolean) {
    this.#button.disabled = !available;
  }

  heard(event: Heard): void {
    if (event.kind === 'report') this.#ask();
  }

  toolMoved(): void {
    this.#ask();
  }

  left(): void {
    this.#dialog.close();
  }

  /** Only while it is looked at. */
  #ask(): void {
    if (this.#dialog.open) this.#pieces.ask(undefined);
  }

  async #show(): Promise<void> {
    if (!this.#dialog.show()) return;
    this.#tell('loading');
    const canvas = make('canvas', { tabIndex: 0, role: 'img', 'aria-label': WORDS[this.#shell.language].solidView });
    const context = canvas.getContext('webgl2', { antialias: true });
    if (context === null) {
      this.#tell('no-webgl');
      return;
    }
    this.#ask();
    // Half a megabyte that most readers never need.
    const { SolidView } = await import('./solid-view');
    // Closed meanwhile, or closed and opened again.
    if (!this.#dialog.open || this.#view !== undefined) return;
    this.#holder.prepend(canvas);
    this.#view = new SolidView(canvas, context);
    this.#showSection();
    canvas.focus();
  }

  #showSection(): void {
    const section = this.#section;
    if (this.#view === undefined || section === undefined) return;
    this.#view.section = section;
    this.#tell(section.length === 0 ? 'no-part' : undefined);
  }

  /** What is to be said in place of a picture. */
  #tell(missing: Missing | undefined): void {
    this.#missing = missing;
    const { solidLoading, solidNoPart, solidNoWebGl } = WORDS[this.#shell.language];
    const texts = { loading: solidLoading, 'no-part': solidNoPart, 'no-webgl': solidNoWebGl };
    this.#message.textContent = missing === undefined ? '' : texts[missing];
    this.#reset.disabled = missing !== undefined;
  }

  #free(): void {
    this.#view?.free();
    this.#view = undefined;
    this.#section = undefined;
  }
}

const WORDS = words({
  en: {
    solid: '3D',
    solidHint: 'Show the part as a solid, a quarter cut away',
    solidTitle: 'The part, a quarter cut away',
    solidAbout: 'Drag or arrow keys turn it, wheel or + and − zoom, Home resets the view. Ctrl Enter plays the program, F9 steps.',
    /** For who does not see it. */
    solidView: 'The turned part in three dimensions. Arrow keys turn it, plus and minus zoom, Home resets the view.',
    solidLoading: 'Loading …',
    solidNoPart: 'There is no part to show: nothing is left of the blank, or it is not known.',
    solidNoWebGl: 'This browser does not draw in three dimensions (WebGL is missing or switched off). The drawing shows the same part in section.',
    solidReset: 'Reset view',
  },
  zh: {
    solid: '三维',
    solidHint: '以剖去四分之一的实体显示零件',
    solidTitle: '零件（剖去四分之一）',
    solidAbout: '拖动或方向键旋转，滚轮或 + − 缩放，Home 键恢复初始视角。Ctrl Enter 播放程序，F9 单步。',
    solidView: '车削零件的三维视图。方向键旋转，加号和减号缩放，Home 键恢复初始视角。',
    solidLoading: '正在加载……',
    solidNoPart: '没有可显示的零件：毛坯已无剩余，或毛坯未知。',
    solidNoWebGl: '此浏览器无法显示三维图形（缺少 WebGL 或已关闭）。平面图中可看到同一零件的剖面。',
    solidReset: '初始视角',
  },
  ru: {
    solid: '3D',
    solidHint: 'Показать деталь как тело с вырезанной четвертью',
    solidTitle: 'Деталь с вырезом четверти',
    solidAbout: 'Перетаскивание и стрелки поворачивают, колесо или + и − меняют масштаб, Home сбрасывает вид. Ctrl Enter запускает программу, F9 — один шаг.',
    solidView: 'Точёная деталь в трёх измерениях. Стрелки поворачивают её, плюс и минус меняют масштаб, Home сбрасывает вид.',
    solidLoading: 'Загрузка …',
    solidNoPart: 'Нечего показать: от заготовки ничего не осталось, или она неизвестна.',
    solidNoWebGl: 'Этот браузер не показывает трёхмерную графику (WebGL отсутствует или выключен). На чертеже та же деталь видна в разрезе.',
    solidReset: 'Сбросить вид',
  },
});
