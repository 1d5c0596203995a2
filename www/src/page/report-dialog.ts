// The dialog to report a difference from a real machine: program, setup, block, and the drawn motions of the block.
//
// In: the `PageHost`, and the user's description. Out: a text to copy, and a zip with a folder for `tests/programs`.
// Must not know: the meaning of a motion.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import { withTimeout } from '../dom/timeout';
import type { Language } from '../dom/language';
import { importWithRetry } from '../dom/network';
import { COMMON } from '../dom/words';
import { download } from '../editor/program-files';
import { makeLink } from '../files/shared-link';
import { copyField, field } from './fields';
import { pageAddress } from './linked';
import { MAX_LENGTH_FOR_TABLE, motionRows, type MotionRow } from './motion-table';
import type { PageHost } from './page-host';
import { blockAt, makeFixture, reportText, type ReportData } from './report';
import { REPORT_WORDS } from './report-words';
import { toShared } from './shared-program';
import '../dom/dialog.css';
import './share.css';

/** Defined by the build. */
declare const PLAYGROUND_VERSION: string;

/** Timeout for the motions; they never arrive if the interpreter has failed. */
const MOTIONS_TIMEOUT_MS = 8000;

let dialog: ReportDialog | undefined;

/** Opens the dialog for the current program, at the block of the cursor. */
export function report(host: PageHost): void {
  dialog ??= new ReportDialog();
  dialog.open(host);
}

class ReportDialog {
  readonly #machine = make('input', { type: 'text', id: 'report-machine', maxLength: 200 });
  readonly #line = make('input', { type: 'number', id: 'report-line', min: '1', step: '1' });
  readonly #block = make('code', { className: 'block', lang: 'en' });
  readonly #did = make('textarea', { id: 'report-did', rows: 3, maxLength: 5000 });
  readonly #output = make('textarea', { id: 'report-output', readOnly: true, rows: 7, spellcheck: false });
  readonly #status = make('p', { className: 'said', role: 'status' });
  readonly #copy = make('button', { type: 'button', className: 'primary' });
  readonly #save = make('button', { type: 'button', className: 'framed' });
  readonly #fields = {
    machine: field(this.#machine),
    line: field(this.#line),
    did: field(this.#did),
    output: field(this.#output),
  };
  readonly #dialog = new Dialog(
    'report',
    [
      make(
        'div',
        { id: 'report-fields' },
        this.#fields.machine.label,
        this.#fields.line.label,
        this.#block,
        this.#fields.did.label,
      ),
      this.#fields.output.label,
    ],
    [this.#status, this.#save, this.#copy],
  );
  #host: PageHost | undefined;
  #motions: readonly MotionRow[] | undefined;
  #link: string | undefined;
  /** Motions and link are still being computed: the report is incomplete. */
  #isPending = false;
  /** Number of times it was opened: late answers for an earlier one are dropped. */
  #openCount = 0;

  constructor() {
    document.body.append(this.#dialog.element);
    for (const input of [this.#machine, this.#line, this.#did]) input.addEventListener('input', () => this.#show());
    this.#copy.addEventListener('click', () => void this.#copyReport());
    this.#save.addEventListener('click', () => void this.#saveFolder());
  }

  get #language(): Language {
    return this.#host?.language ?? 'en';
  }

  open(host: PageHost): void {
    const opening = ++this.#openCount;
    this.#host = host;
    const texts = REPORT_WORDS[host.language];
    this.#dialog.setTexts(texts.title, COMMON[host.language].close);
    this.#dialog.about = texts.about;
    const { machine, line, did, output } = this.#fields;
    for (const [{ caption }, text] of [
      [machine, texts.machine],
      [line, texts.lineLabel],
      [did, texts.did],
      [output, texts.output],
    ] as const)
      caption.textContent = text;
    this.#machine.placeholder = texts.machineHint;
    this.#did.placeholder = texts.didHint;
    this.#copy.textContent = texts.copy;
    this.#save.textContent = texts.saveFolder;
    this.#line.value = String(host.playground.cursorLine);
    [this.#motions, this.#link, this.#isPending] = [undefined, undefined, true];
    this.#show();
    this.#dialog.show();
    this.#machine.focus();
    void this.#collect(host).then(() => {
      if (opening !== this.#openCount) return;
      this.#isPending = false;
      this.#show();
    });
  }

  /** Requests the drawn motions and the link to the program. */
  async #collect(host: PageHost): Promise<void> {
    const { playground } = host;
    const [table, made] = await Promise.all([
      playground.length > MAX_LENGTH_FOR_TABLE
        ? undefined
        : withTimeout(
            playground.exported('csv').catch(() => undefined),
            MOTIONS_TIMEOUT_MS,
          ),
      makeLink(toShared(host.program)).catch(() => undefined),
    ]);
    this.#motions = table === 'timeout' ? undefined : table && motionRows(table);
    this.#link = made?.kind === 'link' ? `${pageAddress()}${made.link}` : undefined;
  }

  #reportData(host: PageHost, setup: string): ReportData {
    return {
      text: host.program.text,
      setup,
      line: Number(this.#line.value),
      motions: this.#motions,
      machine: this.#machine.value,
      did: this.#did.value,
      versions: `G-code playground ${PLAYGROUND_VERSION}, ${navigator.userAgent}`,
      link: this.#link,
    };
  }

  #show(): void {
    const host = this.#host;
    if (host === undefined) return;
    const texts = REPORT_WORDS[host.language];
    const setup = host.playground.wholeSetup;
    this.#block.textContent = blockAt(host.program.text, Number(this.#line.value));
    const isReady = setup !== undefined && !this.#isPending;
    this.#status.textContent = setup === undefined ? texts.unreadableSetup : this.#isPending ? texts.inProgress : '';
    this.#output.value = isReady ? reportText(this.#reportData(host, setup), texts) : '';
    this.#copy.disabled = !isReady;
    this.#save.disabled = !isReady || this.#motions === undefined;
  }

  async #copyReport(): Promise<void> {
    const texts = REPORT_WORDS[this.#language];
    this.#status.textContent = (await copyField(this.#output)) === 'copied' ? texts.copied : texts.notCopied;
  }

  async #saveFolder(): Promise<void> {
    const host = this.#host;
    const setup = host?.playground.wholeSetup;
    if (host === undefined || setup === undefined) return;
    const texts = REPORT_WORDS[host.language];
    const fflate = await importWithRetry(() => import('fflate')).catch(() => undefined);
    if (fflate === undefined) {
      this.#status.textContent = texts.notLoaded;
      return;
    }
    const { name, files } = makeFixture(this.#reportData(host, setup));
    const packed = Object.fromEntries(Object.entries(files).map(([file, text]) => [file, fflate.strToU8(text)]));
    download(`${name}.zip`, new Uint8Array(fflate.zipSync({ [name]: packed })));
    this.#status.textContent = texts.saved(`${name}.zip`);
  }
}
