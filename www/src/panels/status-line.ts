// The status line at the bottom: "42 motions · 14 lines · no problems", and how numbers without a decimal point are
// read.
//
// In: the summary of the newest run, or the progress of a long one. Out: requests to stop that run, or to read numbers
// without a point differently. Must not know: how a program is run.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { counter } from '../dom/plural';
import { words } from '../dom/words';
import type { Summary, Work } from '../protocol/protocol';
import type { Heard } from '../worker/core-client';
import type { Panel, PanelKind, Shell } from './panel';
import statusLineStyles from './status-line.css?inline';

export const statusLine: PanelKind = {
  control: 'status',
  styles: statusLineStyles,
  make: (shell) => new StatusLine(shell),
};

type Shown =
  | { readonly kind: 'loading' }
  | { readonly kind: 'running'; readonly work: Work; readonly done: number }
  | { readonly kind: 'failed' }
  /** The path is complete; messages and part are pending, or could not be loaded. */
  | { readonly kind: 'path'; readonly summary: Summary; readonly rest: 'coming' | 'failed' }
  | { readonly kind: 'summary'; readonly summary: Summary; readonly decimal: string | undefined };

class StatusLine implements Panel {
  readonly #shell: Shell;
  readonly #element = make('p', { className: 'status', part: 'status', role: 'status' });
  /** Visible while a run takes a noticeable time. */
  readonly #stop = make('button', { type: 'button', className: 'framed', hidden: true });
  readonly #change = make('button', { type: 'button', className: 'change quiet' });
  #shown: Shown = { kind: 'loading' };
  /** The content belongs to an earlier run. */
  #isOld = false;
  #said = '';
  readonly places = { foot: [this.#element, this.#stop] };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#stop.addEventListener('click', () => {
      shell.send({ kind: 'stop' });
      shell.editor.focus();
    });
    this.#change.addEventListener('click', () => shell.service('openSetup')('control', 'dialect.decimal'));
  }

  set language(_: Language) {
    this.#render();
  }

  heard(event: Heard): void {
    if (event.kind === 'report' || event.kind === 'path') this.#isOld = false;
    if (event.kind === 'report')
      this.#show({ kind: 'summary', summary: event.report.summary, decimal: event.report.decimal });
    else if (event.kind === 'path') this.#show({ kind: 'path', summary: event.summary, rest: 'coming' });
    else if (event.kind === 'progress') this.#show({ kind: 'running', work: event.work, done: event.done });
  }

  outdated(): void {
    this.#isOld = true;
  }

  begun(): void {
    if (this.#shown.kind === 'failed') this.#show({ kind: 'loading' });
  }

  /** The notice says why. */
  unreported(): void {
    this.#show(this.#shown.kind === 'path' && !this.#isOld ? { ...this.#shown, rest: 'failed' } : { kind: 'failed' });
  }

  lost(): void {
    this.#show({ kind: 'failed' });
  }

  #show(shown: Shown): void {
    this.#shown = shown;
    this.#render();
  }

  #render(): void {
    const texts = WORDS[this.#shell.language];
    this.#stop.textContent = texts.stopRun;
    this.#stop.hidden = this.#shown.kind !== 'running';
    // On a narrow page, lines break between facts, not inside them.
    const written = this.#facts();
    const decimal = this.#shown.kind === 'summary' ? this.#shown.decimal : undefined;
    const said = JSON.stringify([this.#shell.language, ...written, decimal]);
    if (said === this.#said) return;
    this.#said = said;
    this.#element.replaceChildren(...written.flatMap((fact, i) => [i > 0 ? ' · ' : '', make('span', {}, fact)]));
    if (decimal === undefined) return;
    this.#change.textContent = texts.change;
    this.#change.setAttribute('aria-label', texts.changeDecimal);
    this.#element.append(' · ', make('span', { className: 'decimal' }, decimal), ' · ', this.#change);
  }

  #facts(): readonly string[] {
    const strings = WORDS[this.#shell.language];
    switch (this.#shown.kind) {
      case 'loading':
        return [strings.loading];
      case 'running': {
        const percent = Math.floor(this.#shown.done * 100);
        return [this.#shown.work === 'part' ? strings.part(percent) : strings.running(percent)];
      }
      case 'failed':
        return ['—'];
      case 'path': {
        const { motions, lines } = this.#shown.summary;
        return [
          strings.motions(motions),
          strings.lines(lines),
          this.#shown.rest === 'coming' ? strings.coming : strings.notComing,
        ];
      }
      case 'summary': {
        const { motions, lines, errors, warnings, infos } = this.#shown.summary;
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
    coming: 'part and messages are loading …',
    notComing: 'part and messages could not be loaded',
    stopRun: 'Stop',
    change: 'change',
    changeDecimal: 'Change how numbers without a point are read',
    loading: 'Loading …',
  },
  zh: {
    motions: counter('zh', { other: '段运动' }),
    lines: counter('zh', { other: '行' }),
    noProblems: '没有问题',
    problemCount: counter('zh', { other: '个问题' }),
    running: (percent) => `正在运行…… ${percent} %`,
    part: (percent) => `零件 … ${percent} %`,
    coming: '正在加载零件和信息……',
    notComing: '零件和信息加载失败',
    stopRun: '停止',
    change: '更改',
    changeDecimal: '更改无小数点的数的读法',
    loading: '正在加载……',
  },
  ru: {
    motions: counter('ru', { one: 'перемещение', few: 'перемещения', other: 'перемещений' }),
    lines: counter('ru', { one: 'строка', few: 'строки', other: 'строк' }),
    noProblems: 'замечаний нет',
    problemCount: counter('ru', { one: 'замечание', few: 'замечания', other: 'замечаний' }),
    running: (percent) => `Выполняется … ${percent} %`,
    part: (percent) => `Деталь … ${percent} %`,
    coming: 'деталь и сообщения загружаются …',
    notComing: 'деталь и сообщения не загружены',
    stopRun: 'Остановить',
    change: 'изменить',
    changeDecimal: 'Изменить чтение чисел без точки',
    loading: 'Загрузка …',
  },
});
