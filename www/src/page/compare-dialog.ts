// The dialog that compares the program with another version: differing blocks, changes of the motion, both tool paths.
//
// In: the host, and a text that the user pastes, opens, links to or selects from saved programs (`compare-own`).
// Callers that already have the other program use `compareWith`. Out: a dialog, in which the other version is the first
// program and the one on the page the second. Must not know: how programs are compared.

import '../dom/dialog.css';
import './compare.css';
import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import { acceptFiles } from '../dom/drop';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import { COMMON } from '../dom/words';
import { fillOwnPrograms, type OtherProgram } from './compare-own';
import { renderResult } from './compare-result';
import { COMPARE_WORDS } from './compare-words';
import { parseAddress } from './linked';
import type { PageHost } from './page-host';
import { FAULTS } from './share-words';

let dialog: CompareDialog | undefined;

/** Opens the dialog and asks for the other version. */
export function compare(host: PageHost): void {
  dialog ??= new CompareDialog();
  dialog.open(host);
}

/** Compares with a given program. */
export function compareWith(host: PageHost, other: OtherProgram): void {
  compare(host);
  void dialog?.show(other);
}

class CompareDialog {
  readonly #caption = make('span');
  readonly #text = make('textarea', { rows: 6, spellcheck: false, autocomplete: 'off' });
  readonly #file = make('input', { type: 'file', hidden: true });
  readonly #openButton = make('button', { type: 'button', className: 'framed' });
  readonly #compareButton = make('button', { type: 'button', className: 'primary' });
  readonly #savedPrograms = make('select', { hidden: true });
  readonly #status = make('p', { role: 'status', className: 'compared' });
  readonly #result = make('div', { className: 'result', tabIndex: 0, role: 'region' });
  readonly #dialog = new Dialog(
    'compare',
    [make('label', { className: 'other' }, this.#caption, this.#text), this.#file, this.#status, this.#result],
    [this.#savedPrograms, this.#openButton, this.#compareButton],
  );
  #host: PageHost | undefined;
  /** Number of requests (reading a link or a file, comparing); a late answer to an earlier one is dropped. */
  #requestCount = 0;

  constructor() {
    document.body.append(this.#dialog.element);
    this.#openButton.addEventListener('click', () => this.#file.click());
    this.#file.addEventListener('change', () => {
      const [file] = this.#file.files ?? [];
      this.#file.value = '';
      if (file !== undefined) void this.#readFile(file);
    });
    acceptFiles(this.#dialog.element, {
      hint: () => COMMON[this.#language].dropHere,
      onDrop: (file) => void this.#readFile(file),
    });
    this.#compareButton.addEventListener('click', () => void this.#compareInput());
    this.#dialog.element.addEventListener('close', () => this.#requestCount++);
  }

  get #language(): Language {
    return this.#host?.language ?? 'en';
  }

  open(host: PageHost): void {
    this.#host = host;
    const texts = COMPARE_WORDS[host.language];
    this.#dialog.setTexts(texts.title, COMMON[host.language].close);
    this.#dialog.about = texts.about;
    this.#caption.textContent = texts.other;
    this.#text.placeholder = texts.hint;
    this.#compareButton.textContent = texts.compare;
    this.#openButton.textContent = texts.openFile;
    this.#result.setAttribute('aria-label', texts.result);
    this.#savedPrograms.setAttribute('aria-label', texts.own);
    void fillOwnPrograms(this.#savedPrograms, host, host.language, (other) => void this.show(other));
    this.#showOutcome('', undefined);
    this.#dialog.show();
    this.#text.focus();
  }

  /** Compares with `other` and shows the differences. */
  async show(other: OtherProgram): Promise<void> {
    const host = this.#host;
    if (host === undefined) return;
    const texts = COMPARE_WORDS[host.language];
    const request = ++this.#requestCount;
    if (other.text.trim() === '') {
      this.#showOutcome(texts.nothing, undefined);
      return;
    }
    this.#showOutcome(texts.comparing, undefined);
    const names = [
      other.name,
      host.program.file?.name ?? host.example?.title[host.language] ?? texts.thisProgram,
    ] as const;
    const found = await host.playground.differenceFrom({ text: other.text, names }).catch(() => undefined);
    if (request !== this.#requestCount) return;
    if (found === undefined) {
      this.#showOutcome(texts.failed, undefined);
      return;
    }
    const { sameText, sameMotions, hunks } = found.rows;
    const differ = sameMotions ? texts.textAlone : texts.differ(hunks.length);
    this.#showOutcome(
      sameText && sameMotions ? texts.same : differ,
      renderResult(found, { names, language: host.language, goTo: (line) => this.#goTo(line) }),
    );
  }

  /** Compares with the content of the text field: a program, or a link that contains one. */
  async #compareInput(): Promise<void> {
    const request = ++this.#requestCount;
    const text = this.#text.value;
    const texts = COMPARE_WORDS[this.#language];
    const address = text.trim();
    if (!/^https?:\/\/\S+$/.test(address) || !URL.canParse(address)) {
      await this.show({ name: texts.otherVersion, text });
      return;
    }
    const found = await parseAddress(new URL(address).hash);
    if (request !== this.#requestCount) return;
    if (found.kind === 'fault') this.#showOutcome(FAULTS[this.#language](found.fault), undefined);
    else await this.show({ name: texts.otherVersion, text: found.kind === 'linked' ? found.linked.text : '' });
  }

  async #readFile(file: File): Promise<void> {
    const request = ++this.#requestCount;
    const texts = COMPARE_WORDS[this.#language];
    this.#showOutcome(texts.comparing, undefined);
    const module = await importWithRetry(() => import('../editor/read-program')).catch(() => undefined);
    const opened = await module?.readProgram(file);
    if (request !== this.#requestCount) return;
    if (opened === undefined) {
      this.#showOutcome(texts.failed, undefined);
      return;
    }
    if (opened.kind !== 'text') {
      this.#showOutcome(
        opened.kind === 'too-large' ? texts.tooLarge(opened.name) : texts.unreadable(opened.name),
        undefined,
      );
      return;
    }
    await this.show({ name: file.name, text: opened.program.pieces.join('') });
  }

  /** Closes the dialog and goes to this line of the program on the page. */
  #goTo(line: number): void {
    this.#dialog.close();
    this.#host?.playground.goToLine(line);
  }

  #showOutcome(status: string, outcome: HTMLElement | undefined): void {
    this.#status.textContent = status;
    this.#result.replaceChildren(...(outcome === undefined ? [] : [outcome]));
    this.#result.hidden = outcome === undefined;
  }
}
