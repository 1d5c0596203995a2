// The button "3D" and its dialog: the part as a turned body with a quarter cut away.
//
// In: the half-section at the moment that is shown, again when that moves on. Out: `wanted` (it is opened, and needs one).
// What draws it is loaded when it is first opened, and let go of when it is closed.
// Must not know: how the part came about, or how a body is drawn.

import { Dialog } from '../dom/dialog';
import { make, name } from '../dom/dom';
import type { Strings } from '../dom/i18n';
import type { SectionPiece } from '../protocol/protocol';
import type { SolidView } from './solid-view';

export interface SolidEvents {
  wanted(): void;
}

type Missing = 'loading' | 'no-part' | 'no-webgl';

export class SolidDialog {
  readonly button = make('button', { type: 'button', className: 'solid-button quiet', 'aria-haspopup': 'dialog' });
  readonly #events: SolidEvents;
  readonly #holder = make('div', { className: 'text solid-holder' });
  readonly #message = make('p', { className: 'empty', role: 'status' });
  readonly #reset = make('button', { type: 'button', className: 'framed' });
  readonly #dialog = new Dialog('solid', [this.#holder], [this.#reset]);
  #strings: Strings;
  #section: readonly SectionPiece[] | undefined;
  #view: SolidView | undefined;
  #missing: Missing | undefined;

  constructor(strings: Strings, events: SolidEvents) {
    this.#strings = strings;
    this.#events = events;
    this.#holder.append(this.#message);
    this.button.addEventListener('click', () => void this.#show());
    this.#reset.addEventListener('click', () => this.#view?.reset());
    this.element.addEventListener('close', () => this.#free());
    this.available = false;
    this.strings = strings;
  }

  set strings(strings: Strings) {
    this.#strings = strings;
    this.button.textContent = strings.solid;
    name(this.button, strings.solidHint);
    this.#dialog.name(strings.solidTitle, strings.close);
    this.#dialog.about = strings.solidAbout;
    this.#reset.textContent = strings.solidReset;
    this.#view?.canvas.setAttribute('aria-label', strings.solidView);
    this.#tell(this.#missing);
  }

  /** Whether there is a finished run that may have left a part. */
  set available(available: boolean) {
    this.button.disabled = !available;
  }

  set section(section: readonly SectionPiece[]) {
    if (!this.open) return;
    this.#section = section;
    this.#showSection();
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  get open(): boolean {
    return this.#dialog.open;
  }

  close(): void {
    this.#dialog.close();
  }

  async #show(): Promise<void> {
    if (!this.#dialog.show()) return;
    this.#tell('loading');
    const canvas = make('canvas', { tabIndex: 0, role: 'img', 'aria-label': this.#strings.solidView });
    const context = canvas.getContext('webgl2', { antialias: true });
    if (context === null) {
      this.#tell('no-webgl');
      return;
    }
    this.#events.wanted();
    // Half a megabyte that most readers never need.
    const { SolidView } = await import('./solid-view');
    // Closed meanwhile, or closed and opened again.
    if (!this.open || this.#view !== undefined) return;
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
    const { solidLoading, solidNoPart, solidNoWebGl } = this.#strings;
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
