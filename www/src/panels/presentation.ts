// Full screen for the drawing, and the presentation mode: large type, only program and drawing, and keys for a
// presenter in front of a class.
//
// In: buttons and keys, the block that the tool is in or, before the tool has moved, the block at the cursor. Out:
// commands to the playback; `data-presenting` of the frame, the attribute `presenting` of the element; the block in
// words. Must not know: drawing, playing, and the meaning of a block.

import { icon, make, renderUnbroken, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { words } from '../dom/words';
import type { Help, HelpRequest, Readout } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Key, NewestQuestion, Panel, PanelKind, Shell } from './panel';
import presentationStyles from './presentation.css?inline';

/** Least scale of the text; in a large window the text is larger (`presentation.css`). */
const LEAST_TEXT_SCALE = 1.25;

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
  #isPresenting = false;
  /** Visible while presenting. */
  readonly #endButton = make('button', { type: 'button', className: 'end-presentation', hidden: true }, icon('whole'));
  /** What the current block does, over the picture. */
  readonly #blockWords = make('p', { className: 'block-words', hidden: true });
  readonly #question: NewestQuestion<'help'>;
  /** The question whose answer is shown, as text: during the playback of a block it stays the same. */
  #askedKey = '';
  #place: Readout | undefined;
  readonly elements = {
    views: [this.#fullScreen],
    pictures: [this.#blockWords],
    playback: [this.#endButton],
    'more-menu': [this.#presentButton],
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#question = shell.newest('help', (help) => this.#showBlock(help));
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
    if (this.#isPresenting && this.#askedKey === '') this.#showKeys();
    else this.#askAgain();
  }

  onToolMoved(place: Readout | undefined): void {
    this.#place = place;
    this.#ask();
  }

  onCursorMoved(): void {
    this.#ask();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report' || event.kind === 'parts-loaded') this.#askAgain();
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

  #begin(): void {
    if (this.#isPresenting) return;
    this.#isPresenting = true;
    const textSize = Number.parseFloat(getComputedStyle(this.#host).fontSize);
    this.#host.style.setProperty('--presentation-least-text', `${textSize * LEAST_TEXT_SCALE}px`);
    this.#host.toggleAttribute('presenting', true);
    this.#shell.frame.dataset['presenting'] = '';
    this.#shell.refit();
    // If full screen is refused, the element fills the window.
    this.#host.requestFullscreen?.().catch(() => undefined);
    this.#updateNames();
    if (this.#place === undefined) this.#showKeys();
    else this.#ask();
    this.#endButton.focus();
  }

  #end(): void {
    this.#isPresenting = false;
    this.#host.removeAttribute('presenting');
    this.#host.style.removeProperty('--presentation-least-text');
    delete this.#shell.frame.dataset['presenting'];
    this.#shell.refit();
    if (document.fullscreenElement === this.#host) void document.exitFullscreen();
    this.#question.cancel();
    this.#askedKey = '';
    this.#showWords('');
    this.#updateNames();
  }

  /** The answer of another run or in another language replaces the shown one. */
  #askAgain(): void {
    if (this.#askedKey === '') return;
    this.#askedKey = '';
    this.#ask();
  }

  /** Until the tool or the cursor is moved. */
  #showKeys(): void {
    this.#showWords(WORDS[this.#shell.language].keys);
  }

  /** Asks what the block does that the tool is in, that stops it, or that the cursor is in. */
  #ask(): void {
    if (!this.#isPresenting) return;
    const { stroke, stop } = this.#place ?? {};
    const offset = stop?.from ?? (stroke === undefined ? this.#shell.editor.cursor : undefined);
    const request: HelpRequest =
      offset === undefined && stroke !== undefined
        ? { by: 'presentation', about: 'motion', motion: stroke.motion }
        : { by: 'presentation', about: 'block', offset: offset ?? 0, time: undefined };
    const key = JSON.stringify(request);
    if (key === this.#askedKey) return;
    this.#askedKey = key;
    this.#question.ask(request);
  }

  #showBlock(help: Help | undefined): void {
    if (help === undefined || !this.#isPresenting) return;
    const explanation = help.explanation ?? help.state?.explanation ?? '';
    this.#showWords(explanation || (this.#place?.stroke.text ?? ''));
  }

  #showWords(text: string): void {
    this.#blockWords.hidden = text === '';
    if (this.#blockWords.textContent !== text) this.#blockWords.replaceChildren(...renderUnbroken(text));
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
    this.#presentButton.title = texts.keys;
    setAccessibleName(this.#fullScreen, document.fullscreenElement === null ? texts.whole : texts.window);
  }
}

const WORDS = words({
  en: {
    present: 'Present',
    keys: 'Page Down and Page Up go block by block, arrows motion by motion; Space plays, Escape ends.',
    end: 'End presentation',
    whole: 'Drawing on the whole screen',
    window: 'Back to the window',
  },
  zh: {
    present: '演示',
    keys: 'Page Down 和 Page Up 逐程序段，方向键逐段运动，空格播放，Escape 结束。',
    end: '结束演示',
    whole: '图形全屏显示',
    window: '退出全屏',
  },
  ru: {
    present: 'Показ',
    keys: 'Page Down и Page Up — по кадрам, стрелки — по перемещениям; пробел — пуск, Escape — конец.',
    end: 'Закончить показ',
    whole: 'Чертёж на весь экран',
    window: 'Вернуться в окно',
  },
});
