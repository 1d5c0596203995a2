// Full screen for the drawing, and the presentation mode: large type, only program and drawing, and keys for a
// presenter in front of a class.
//
// In: buttons and keys. Out: commands to the playback; `data-presenting` of the frame, the attribute `presenting` of
// the element. Must not know: how anything is drawn or played.

import { icon, make, name } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { Key, Panel, PanelKind, Shell } from './panel';
import presentationStyles from './presentation.css?inline';

/** Scale of everything that is measured by the font size of the page. */
const LARGER = '150%';

export const presentation: PanelKind = {
  control: 'tools',
  styles: presentationStyles,
  make: (shell) => new Presentation(shell),
};

class Presentation implements Panel {
  readonly #shell: Shell;
  readonly #host: HTMLElement;
  readonly #shown: HTMLElement;
  readonly #whole = make('button', { type: 'button', className: 'level whole-screen' }, icon('screen'));
  readonly #present = make('button', {
    type: 'button',
    className: 'quiet outlined present-button',
    'aria-pressed': 'false',
  });
  /** Font size of the page before the presentation; undefined if there is none now. */
  #typeBefore: string | undefined;
  readonly places = { views: [this.#whole], foot: [this.#present] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#host = shell.root.host as HTMLElement;
    const shown = shell.frame.querySelector<HTMLElement>('#shown');
    if (shown === null) throw new Error('the frame has no #shown');
    this.#shown = shown;
    // Without full-screen support, the button would do nothing.
    this.#whole.hidden = !document.fullscreenEnabled;
    this.#whole.addEventListener('click', () => void this.#toggleWhole());
    this.#present.addEventListener('click', () => this.#toggle());
    document.addEventListener('fullscreenchange', this.#fullscreenChanged);
  }

  set language(_: Language) {
    this.#name();
  }

  left(): void {
    if (this.#isPresenting) this.#end();
  }

  pressed({ event, inside }: Key): 'own' | 'not-own' {
    if (!this.#isPresenting || event.ctrlKey || event.metaKey || event.altKey) return 'not-own';
    const step = this.#shell.service('step');
    // A presenter remote sends these two keys, regardless of the focus.
    if (event.key === 'PageDown') step('block', 'next');
    else if (event.key === 'PageUp') step('block', 'previous');
    else if (event.key === 'Escape') this.#end();
    else if (inside === 'text') return 'not-own';
    else if (event.key === 'ArrowRight') step('motion', 'next');
    else if (event.key === 'ArrowLeft') step('motion', 'previous');
    else if (event.key === ' ') this.#shell.service('playOrPause')();
    else return 'not-own';
    return 'own';
  }

  get #isPresenting(): boolean {
    return this.#typeBefore !== undefined;
  }

  #toggle(): void {
    if (this.#isPresenting) this.#end();
    else this.#begin();
  }

  #begin(): void {
    const { style } = document.documentElement;
    this.#typeBefore = style.fontSize;
    style.fontSize = LARGER;
    this.#host.toggleAttribute('presenting', true);
    this.#shell.frame.dataset['presenting'] = '';
    // If full screen is refused, the element fills the window.
    this.#host.requestFullscreen?.().catch(() => undefined);
    this.#name();
    this.#present.focus();
  }

  #end(): void {
    document.documentElement.style.fontSize = this.#typeBefore ?? '';
    this.#typeBefore = undefined;
    this.#host.removeAttribute('presenting');
    delete this.#shell.frame.dataset['presenting'];
    if (document.fullscreenElement === this.#host) void document.exitFullscreen();
    this.#name();
  }

  readonly #fullscreenChanged = (): void => {
    // In full screen, the browser handles Escape.
    if (this.#isPresenting && document.fullscreenElement === null) this.#end();
    this.#name();
  };

  async #toggleWhole(): Promise<void> {
    if (document.fullscreenElement === null) await this.#shown.requestFullscreen().catch(() => undefined);
    else await document.exitFullscreen();
  }

  #name(): void {
    const texts = WORDS[this.#shell.language];
    this.#present.setAttribute('aria-pressed', String(this.#isPresenting));
    this.#present.textContent = this.#isPresenting ? texts.end : texts.present;
    this.#present.title = texts.presentHint;
    name(this.#whole, document.fullscreenElement === null ? texts.whole : texts.window);
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
