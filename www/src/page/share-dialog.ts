// The dialog "Share": a link that contains the program and its options, in several forms.
//
// In: the `PageHost`. Out: texts to copy, a QR code, a picture. Nothing is sent without an action of the user. Must not
// know: the format of a link.

import { Dialog } from '../dom/dialog';
import { make, setText } from '../dom/dom';
import { importWithRetry } from '../dom/network';
import { COMMON } from '../dom/words';
import { download, fileStem } from '../editor/program-files';
import { foldLineEnds } from '../files/line-ends';
import { makeLink, type Shared } from '../files/shared-link';
import { elementText, frameText, markdownText } from './embed-text';
import { checkbox, copyField, field } from './fields';
import { pageAddress } from './linked';
import type { PageHost } from './page-host';
import { publishedFile } from './published';
import { FORMS, SHARE_WORDS, VIEWS, type Form, type SharedView, type ShareWords } from './share-words';
import { toShared } from './shared-program';
import { PAGE_WORDS } from './words';
import '../dom/dialog.css';
import './share.css';

/** Some messaging programs are known to truncate links longer than this. */
const LONG_LINK = 2000;
/** The forms that contain a full link to the page, and so can contain a task. */
const TASK_FORMS: readonly Form[] = ['link', 'markdown', 'qr'];

let dialog: ShareDialog | undefined;

/** Opens the dialog for the current program. */
export function share(host: PageHost): void {
  if (dialog === undefined) {
    dialog = new ShareDialog();
    document.body.append(dialog.element);
  }
  dialog.open(host);
}

class ShareDialog {
  readonly #form = make('select', { id: 'share-form' });
  readonly #view = make('select', { id: 'share-view' });
  readonly #language = make('input', { type: 'checkbox', id: 'share-language' });
  readonly #step = make('input', { type: 'checkbox', id: 'share-step' });
  readonly #readonly = make('input', { type: 'checkbox', id: 'share-readonly' });
  readonly #task = make('input', { type: 'checkbox', id: 'share-task', 'aria-controls': 'share-task-fields' });
  readonly #sentence = make('textarea', { id: 'share-sentence', autocomplete: 'off', rows: 2, maxLength: 1000 });
  readonly #start = make('textarea', {
    id: 'share-start',
    rows: 6,
    spellcheck: false,
    dir: 'ltr',
    'aria-describedby': 'share-start-news',
  });
  readonly #startNews = make('p', { id: 'share-start-news', className: 'start-news', role: 'status' });
  readonly #solution = make('input', { type: 'checkbox', id: 'share-solution', checked: true });
  readonly #solutionAbout = make('p', { className: 'about' });
  readonly #output = make('textarea', { id: 'share-output', readOnly: true, rows: 5, spellcheck: false, dir: 'ltr' });
  readonly #drawing = make('div', { className: 'drawn' });
  readonly #length = make('p', { className: 'length' });
  readonly #status = make('p', { className: 'said', role: 'status' });
  readonly #copy = make('button', { type: 'button', className: 'primary' });
  readonly #send = make('button', { type: 'button', className: 'framed' });
  readonly #saveSvg = make('button', { type: 'button', className: 'framed' });
  readonly #savePng = make('button', { type: 'button', className: 'primary' });
  readonly #fields = {
    form: field(this.#form),
    view: field(this.#view),
    language: checkbox(this.#language),
    step: checkbox(this.#step),
    readonly: checkbox(this.#readonly),
    task: checkbox(this.#task),
    sentence: field(this.#sentence),
    start: field(this.#start),
    solution: checkbox(this.#solution),
    output: field(this.#output),
  };
  readonly #taskFields = make(
    'div',
    { id: 'share-task-fields' },
    this.#fields.sentence.label,
    this.#fields.start.label,
    this.#startNews,
    this.#fields.solution.label,
    this.#solutionAbout,
  );
  readonly #dialog = new Dialog(
    'share',
    [
      make(
        'div',
        { className: 'choices' },
        this.#fields.form.label,
        this.#fields.view.label,
        this.#fields.language.label,
        this.#fields.step.label,
        this.#fields.readonly.label,
        this.#fields.task.label,
        this.#taskFields,
      ),
      this.#fields.output.label,
      this.#drawing,
      this.#length,
    ],
    [this.#status, this.#send, this.#saveSvg, this.#savePng, this.#copy],
  );
  #host: PageHost | undefined;
  #toolStep: string | null = null;
  /** The solution that the task was written for. */
  #taskSolution: string | undefined;
  #wasTask = false;
  /** Number of requests; a late result of an earlier one is dropped. */
  #requestCount = 0;

  constructor() {
    this.#form.append(...FORMS.map((value) => make('option', { value })));
    this.#view.append(...VIEWS.map((value) => make('option', { value })));
    this.#dialog.element.addEventListener('input', ({ target }) => {
      this.#followTask();
      void this.#show().then(() => {
        if (target === this.#form) this.#scrollToDrawing();
      });
    });
    this.#copy.addEventListener('click', () => void this.#copyOutput());
    this.#send.addEventListener(
      'click',
      () => void navigator.share({ url: this.#output.value }).catch(() => undefined),
    );
    this.#saveSvg.addEventListener('click', () => void this.#save('svg'));
    this.#savePng.addEventListener('click', () => void this.#save('png'));
  }

  get element(): HTMLElement {
    return this.#dialog.element;
  }

  open(host: PageHost): void {
    this.#host = host;
    const texts = SHARE_WORDS[host.language];
    this.#dialog.setTexts(texts.title, COMMON[host.language].close);
    this.#dialog.about = texts.about;
    for (const option of this.#form.options) option.textContent = texts.forms[option.value as Form];
    for (const option of this.#view.options) option.textContent = texts.views[option.value as SharedView];
    const { form, view, language, readonly, task, sentence, start, solution, output } = this.#fields;
    for (const [field, text] of [
      [form, texts.as],
      [view, texts.view],
      [language, texts.language],
      [readonly, texts.readonly],
      [task, texts.task],
      [sentence, texts.sentence],
      [start, texts.start],
      [solution, texts.solution],
      [output, texts.output],
    ] as const)
      field.caption.textContent = text;
    this.#solutionAbout.textContent = texts.solutionAbout;
    for (const [button, text] of [
      [this.#copy, texts.copy],
      [this.#send, texts.send],
      [this.#saveSvg, texts.saveSvg],
      [this.#savePng, texts.savePng],
    ] as const)
      button.textContent = text;
    this.#form.value = 'link';
    this.#view.value = 'all';
    this.#step.checked = this.#readonly.checked = false;
    const { text } = host.program;
    // Keep the entered task, unless the program has changed.
    if (this.#taskSolution !== text) {
      this.#taskSolution = text;
      this.#task.checked = false;
      this.#sentence.value = '';
      this.#start.value = host.example?.program ?? text;
      this.#solution.checked = text.trim() !== '';
      this.#solution.disabled = text.trim() === '';
    }
    if (!this.#task.checked) this.#language.checked = true;
    this.#followTask();
    this.#toolStep = null;
    this.#fields.step.label.hidden = true;
    void this.#show();
    this.#dialog.show();
    this.#form.focus();
    void host.playground.currentStep().then(
      (step) => {
        if (step === null) return;
        this.#toolStep = step;
        this.#fields.step.caption.textContent = texts.step(step);
        this.#fields.step.label.hidden = false;
      },
      () => undefined,
    );
  }

  get #isTask(): boolean {
    return this.#task.checked && TASK_FORMS.includes(this.#form.value as Form);
  }

  /** By default a task has no language, so that each pupil reads it in their own. */
  #followTask(): void {
    const isTask = this.#isTask;
    if (isTask !== this.#wasTask) this.#language.checked = !isTask;
    this.#wasTask = isTask;
  }

  /** Scrolls to the drawing, which on a phone is below a screen of options. */
  #scrollToDrawing(): void {
    const { body } = this.#dialog;
    if (this.#drawing.childElementCount > 0) body.scrollTop = body.scrollHeight;
  }

  /** What to share, according to the options. */
  #sharedContent(host: PageHost): Shared {
    const program = toShared(host.program);
    const view = this.#view.value === 'all' ? null : this.#view.value;
    const isTask = this.#isTask;
    return {
      ...program,
      text: isTask ? this.#start.value : program.text,
      language: this.#language.checked ? host.language : null,
      view,
      step: this.#step.checked ? this.#toolStep : null,
      readonly: this.#readonly.checked && !isTask,
      task: isTask
        ? { sentence: this.#sentence.value.trim(), solution: this.#solution.checked ? program.text : null }
        : null,
    };
  }

  async #show(): Promise<void> {
    const host = this.#host;
    if (host === undefined) return;
    const request = ++this.#requestCount;
    const texts = SHARE_WORDS[host.language];
    const form = this.#form.value as Form;
    const isPicture = form === 'picture';
    const { view, language, readonly, task, output } = this.#fields;
    for (const { label } of [view, language]) label.hidden = isPicture;
    task.label.hidden = !TASK_FORMS.includes(form);
    readonly.label.hidden = isPicture || (this.#task.checked && !task.label.hidden);
    this.#fields.step.label.hidden = isPicture || this.#toolStep === null;
    this.#taskFields.hidden = task.label.hidden || !this.#task.checked;
    this.#solutionAbout.hidden = !this.#solution.checked;
    setText(this.#startNews, this.#taskFields.hidden ? '' : this.#taskNews(host, texts));
    output.label.hidden = form === 'qr' || isPicture;
    this.#copy.hidden = output.label.hidden;
    this.#send.hidden = form !== 'link' || !('share' in navigator);
    this.#saveSvg.hidden = this.#savePng.hidden = !isPicture;
    this.#status.textContent = '';
    this.#dialog.element.dataset['form'] = form;
    // Clear the output, so that a result of earlier options cannot be copied.
    this.#output.value = '';
    this.#copy.disabled = this.#send.disabled = true;
    const made: ShareOutput = this.#isEmptyTask
      ? { text: '', length: '' }
      : isPicture
        ? { text: '', length: '', drawn: await this.#picture(host) }
        : await this.#makeOutput(form, this.#sharedContent(host), host, texts).catch(() => ({
            text: '',
            length: texts.notMade,
          }));
    if (request !== this.#requestCount) return;
    this.#output.value = made.text;
    this.#copy.disabled = this.#send.disabled = made.text === '';
    this.#length.textContent = made.length;
    this.#drawing.replaceChildren(...(made.drawn === undefined ? [] : [made.drawn]));
  }

  #taskNews(host: PageHost, texts: ShareWords): string {
    if (this.#isEmptyTask) return texts.emptyTask;
    if (this.#solution.disabled) return texts.noSolution;
    const isSolution = asFieldText(this.#start.value) === asFieldText(host.program.text);
    return isSolution && this.#solution.checked ? texts.startIsSolution : '';
  }

  get #isEmptyTask(): boolean {
    return this.#isTask && this.#sentence.value.trim() === '' && this.#start.value.trim() === '';
  }

  async #makeOutput(form: Form, shared: Shared, host: PageHost, texts: ShareWords): Promise<ShareOutput> {
    const title = host.example?.title[host.language] ?? host.program.file?.name ?? PAGE_WORDS[host.language].title;
    if (form === 'element' || form === 'frame') {
      const text =
        form === 'element'
          ? elementText(shared, publishedFile('element.js'))
          : frameText(shared, publishedFile('index.html'), title);
      return { text, length: texts.length(text.length) };
    }
    const made = await makeLink(shared);
    if (made.kind === 'too-long') return { text: '', length: texts.tooLong(made.length, made.limit) };
    const link = `${pageAddress()}${made.link}`;
    if (form === 'qr') {
      const { qrCode, QR_LIMIT } = await importWithRetry(() => import('./qr'));
      const drawn = qrCode(link);
      if (drawn === undefined) return { text: '', length: texts.qrTooLong(link.length, QR_LIMIT) };
      drawn.setAttribute('role', 'img');
      drawn.setAttribute('aria-label', texts.qrName);
      return { text: '', length: texts.length(link.length), drawn };
    }
    const text = form === 'markdown' ? markdownText(title, link) : link;
    return { text, length: `${texts.length(text.length)}${text.length > LONG_LINK ? ` · ${texts.longer}` : ''}` };
  }

  async #picture(host: PageHost): Promise<Element> {
    const texts = SHARE_WORDS[host.language];
    const file = await host.playground.pictureFile('png').catch(() => undefined);
    if (file === undefined) return make('p', {}, texts.noPicture);
    const address = URL.createObjectURL(file);
    const image = make('img', { src: address, alt: texts.forms.picture });
    image.addEventListener('load', () => URL.revokeObjectURL(address), { once: true });
    return image;
  }

  async #save(format: 'svg' | 'png'): Promise<void> {
    const host = this.#host;
    const file = await host?.playground.pictureFile(format).catch(() => undefined);
    if (host === undefined) return;
    if (file === undefined) this.#status.textContent = SHARE_WORDS[host.language].noPicture;
    else
      download(
        `${fileStem(host.program.text, host.playground.file)}.${format}`,
        new Uint8Array(await file.arrayBuffer()),
      );
  }

  async #copyOutput(): Promise<void> {
    const texts = SHARE_WORDS[this.#host?.language ?? 'en'];
    this.#status.textContent = (await copyField(this.#output)) === 'copied' ? texts.copied : texts.notCopied;
  }
}

/** The result: a text to copy, the line under it, and a drawing that is shown instead of the text. */
interface ShareOutput {
  readonly text: string;
  readonly length: string;
  readonly drawn?: Element;
}

/** Normalises the text as a text field does: each line end is one character; trailing blank lines are removed. */
function asFieldText(text: string): string {
  return foldLineEnds(text).trimEnd();
}
