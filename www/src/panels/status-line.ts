// The state of the run: progress while it takes long, then "42 motions · 14 lines · no problems" and how numbers without
// a decimal point are read, which only screen readers show.
//
// In: the summary of the newest run, or the progress of a long one. Out: requests to stop that run. Must not know: how a
// program is run.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words } from '../dom/words';
import type { Summary, Work } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import statusLineStyles from './status-line.css?inline';

export const statusLine: PanelKind = {
  control: 'status',
  styles: statusLineStyles,
  make: (shell) => new StatusLine(shell),
};

type Content =
  | { readonly kind: 'loading' }
  | { readonly kind: 'running'; readonly work: Work; readonly done: number }
  | { readonly kind: 'failed' }
  /** The path is complete; messages and part are pending, or could not be loaded. */
  | { readonly kind: 'path'; readonly summary: Summary; readonly rest: 'pending' | 'failed' }
  | { readonly kind: 'summary'; readonly summary: Summary; readonly decimal: string | undefined };

class StatusLine implements Panel {
  readonly #shell: Shell;
  readonly #element = make('p', { className: 'status', part: 'status', role: 'status' });
  /** Visible while a run takes a noticeable time. */
  readonly #stop = make('button', { type: 'button', className: 'framed', hidden: true });
  #content: Content = { kind: 'loading' };
  /** The content belongs to an earlier run. */
  #isOutdated = false;
  #renderedKey = '';
  readonly elements = { head: [this.#element, this.#stop] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#stop.addEventListener('click', () => {
      shell.send({ kind: 'stop' });
      shell.editor.focus();
    });
  }

  set language(_: Language) {
    this.#render();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report' || event.kind === 'path') this.#isOutdated = false;
    if (event.kind === 'report')
      this.#show({ kind: 'summary', summary: event.report.summary, decimal: event.report.decimal });
    else if (event.kind === 'path') this.#show({ kind: 'path', summary: event.summary, rest: 'pending' });
    else if (event.kind === 'progress') this.#show({ kind: 'running', work: event.work, done: event.done });
  }

  onInputChanged(): void {
    this.#isOutdated = true;
  }

  onRunStarted(): void {
    if (this.#content.kind === 'failed') this.#show({ kind: 'loading' });
  }

  /** The notice says why. */
  onRunFailed(): void {
    this.#show(
      this.#content.kind === 'path' && !this.#isOutdated ? { ...this.#content, rest: 'failed' } : { kind: 'failed' },
    );
  }

  onWorkerLost(): void {
    this.#show({ kind: 'failed' });
  }

  #show(content: Content): void {
    this.#content = content;
    this.#render();
  }

  #render(): void {
    const texts = WORDS[this.#shell.language];
    this.#stop.textContent = texts.stopRun;
    this.#stop.hidden = this.#content.kind !== 'running';
    // The counts of a finished run are for screen readers; the picture and the list of problems show them.
    this.#element.classList.toggle('unseen', this.#content.kind === 'summary');
    // On a narrow page, lines break between facts, not inside them.
    const facts = this.#facts();
    const decimal = this.#content.kind === 'summary' ? this.#content.decimal : undefined;
    const renderedKey = JSON.stringify([this.#shell.language, ...facts, decimal]);
    if (renderedKey === this.#renderedKey) return;
    this.#renderedKey = renderedKey;
    this.#element.replaceChildren(...facts.flatMap((fact, i) => [i > 0 ? ' · ' : '', make('span', {}, fact)]));
    if (decimal === undefined) return;
    this.#element.append(' · ', make('span', { className: 'decimal' }, decimal));
  }

  #facts(): readonly string[] {
    const strings = WORDS[this.#shell.language];
    switch (this.#content.kind) {
      case 'loading':
        return [strings.loading];
      case 'running': {
        const percent = Math.floor(this.#content.done * 100);
        return [this.#content.work === 'part' ? strings.part(percent) : strings.running(percent)];
      }
      case 'failed':
        return ['—'];
      case 'path': {
        const { motions, lines } = this.#content.summary;
        return [
          strings.motions(motions),
          strings.lines(lines),
          this.#content.rest === 'pending' ? strings.pending : strings.incomplete,
        ];
      }
      case 'summary': {
        const { motions, lines, errors, warnings, infos } = this.#content.summary;
        const problems = errors + warnings + infos;
        const found = problems === 0 ? strings.noProblems : strings.problemCount(problems);
        return [strings.motions(motions), strings.lines(lines), found];
      }
    }
  }
}

const WORDS = words({
  en: {
    motions: counter('en', { one: 'motion', other: 'motions' }),
    lines: counter('en', { one: 'line', other: 'lines' }),
    noProblems: 'no problems',
    problemCount: counter('en', { one: 'problem', other: 'problems' }),
    running: (percent: number) => `Running … ${percent} %`,
    /** Material removal is being computed. */
    part: (percent: number) => `Part … ${percent} %`,
    pending: 'part and messages are loading …',
    incomplete: 'part and messages could not be loaded',
    stopRun: 'Stop',
    loading: 'Loading …',
  },
  zh: {
    motions: counter('zh', { other: '段运动' }),
    lines: counter('zh', { other: '行' }),
    noProblems: '没有问题',
    problemCount: counter('zh', { other: '个问题' }),
    running: (percent) => `正在运行…… ${percent} %`,
    part: (percent) => `零件 … ${percent} %`,
    pending: '正在加载零件和信息……',
    incomplete: '零件和信息加载失败',
    stopRun: '停止',
    loading: '正在加载……',
  },
  ru: {
    motions: counter('ru', { one: 'перемещение', few: 'перемещения', other: 'перемещений' }),
    lines: counter('ru', { one: 'строка', few: 'строки', other: 'строк' }),
    noProblems: 'замечаний нет',
    problemCount: counter('ru', { one: 'замечание', few: 'замечания', other: 'замечаний' }),
    running: (percent) => `Выполняется … ${percent} %`,
    part: (percent) => `Деталь … ${percent} %`,
    pending: 'деталь и сообщения загружаются …',
    incomplete: 'деталь и сообщения не загружены',
    stopRun: 'Остановить',
    loading: 'Загрузка …',
  },
});
