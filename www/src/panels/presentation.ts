// Full screen for the drawing, and the presentation mode: large type, only program and drawing, and keys for a
// presenter in front of a class.
//
// In: buttons and keys. Out: commands to the playback; `data-presenting` of the frame, the attribute `presenting` of
// the element. Must not know: how anything is drawn or played.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import type { Key, Panel, PanelKind, Shell } from './panel';
import presentationStyles from './presentation.css?inline';

/** Scale of everything that is measured by the font size of the page. */
const FONT_SCALE = '150%';

export const presentation: PanelKind = {
  control: 'tools',
  styles: presentationStyles,
  make: (shell) => new Presentation(shell),
};

class Presentation implements Panel {
  readonly #shell: Shell;
  readonly #host: HTMLElement;
  readonly #picturePart: HTMLElement;
  readonly #fullScreen = make('button', { type: 'button', className: 'whole-screen' }, icon('screen'));
  readonly #presentButton = menuItem();
  /** Font size of the page before the presentation; undefined if there is none now. */
  #fontSizeBefore: string | undefined;
  /** Visible while presenting. */
  readonly #endButton = make('button', { type: 'button', className: 'end-presentation', hidden: true }, icon('whole'));
  readonly elements = { views: [this.#fullScreen], playback: [this.#endButton], 'more-menu': [this.#presentButton] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#host = shell.root.host as HTMLElement;
    const shown = shell.frame.querySelector<HTMLElement>('#shown');
    if (shown === null) throw new Error('the frame has no #shown');
    this.#picturePart = shown;
    // Without full-screen support, the button would do nothing.
    this.#fullScreen.hidden = !document.fullscreenEnabled;
    this.#fullScreen.addEventListener('click', () => void this.#toggleFullScreen());
    this.#presentButton.addEventListener('click', () => this.#begin());
    this.#endButton.addEventListener('click', () => this.#end());
    document.addEventListener('fullscreenchange', this.#onFullScreenChanged);
  }

  set language(_: Language) {
    this.#updateNames();
  }

  onDisconnected(): void {
    if (this.#isPresenting) this.#end();
  }

  onKey({ event, inside }: Key): 'handled' | 'ignored' {
    if (!this.#isPresenting || event.ctrlKey || event.metaKey || event.altKey) return 'ignored';
    const step = this.#shell.service('step');
    // A presenter remote sends these two keys, regardless of the focus.
    if (event.key === 'PageDown') step('block', 'next');
    else if (event.key === 'PageUp') step('block', 'previous');
    else if (event.key === 'Escape') this.#end();
    else if (inside === 'text') return 'ignored';
    else if (event.key === 'ArrowRight') step('motion', 'next');
    else if (event.key === 'ArrowLeft') step('motion', 'previous');
    else if (event.key === ' ') this.#shell.service('playOrPause')();
    else return 'ignored';
    return 'handled';
  }

  get #isPresenting(): boolean {
    return this.#fontSizeBefore !== undefined;
  }

  #begin(): void {
    if (this.#isPresenting) return;
    const { style } = document.documentElement;
    this.#fontSizeBefore = style.fontSize;
    style.fontSize = FONT_SCALE;
    this.#host.toggleAttribute('presenting', true);
    this.#shell.frame.dataset['presenting'] = '';
    // If full screen is refused, the element fills the window.
    this.#host.requestFullscreen?.().catch(() => undefined);
    this.#updateNames();
    this.#endButton.focus();
  }

  #end(): void {
    document.documentElement.style.fontSize = this.#fontSizeBefore ?? '';
    this.#fontSizeBefore = undefined;
    this.#host.removeAttribute('presenting');
    delete this.#shell.frame.dataset['presenting'];
    if (document.fullscreenElement === this.#host) void document.exitFullscreen();
    this.#updateNames();
  }

  readonly #onFullScreenChanged = (): void => {
    // In full screen, the browser handles Escape.
    if (this.#isPresenting && document.fullscreenElement === null) this.#end();
    this.#updateNames();
  };

  async #toggleFullScreen(): Promise<void> {
    if (document.fullscreenElement === null) await this.#picturePart.requestFullscreen().catch(() => undefined);
    else await document.exitFullscreen();
  }

  #updateNames(): void {
    const texts = WORDS[this.#shell.language];
    this.#presentButton.textContent = texts.present;
    this.#endButton.hidden = !this.#isPresenting;
    setAccessibleName(this.#endButton, texts.end);
    this.#presentButton.title = texts.presentHint;
    setAccessibleName(this.#fullScreen, document.fullscreenElement === null ? texts.whole : texts.window);
  }
}

const WORDS = words({
  en: {
    present: 'Present',
    presentHint:
      'Large type; Page Down and Page Up go block by block, arrows motion by motion, Space plays, Escape ends',
    end: 'End presentation',
    whole: 'Drawing on the whole screen',
    window: 'Back to the window',
  },
  zh: {
    present: '演示',
    presentHint: '大字显示；Page Down 和 Page Up 逐程序段，方向键逐段运动，空格播放，Escape 结束',
    end: '结束演示',
    whole: '图形全屏显示',
    window: '退出全屏',
  },
  ru: {
    present: 'Показ',
    presentHint:
      'Крупный шрифт; Page Down и Page Up — по кадрам, стрелки — по перемещениям, пробел — пуск, Escape — конец',
    end: 'Закончить показ',
    whole: 'Чертёж на весь экран',
    window: 'Вернуться в окно',
  },
});
