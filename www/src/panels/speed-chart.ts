// The chart of a program that only sets speeds, in place of the empty picture: spindle speed over diameter.
//
// In: the motions of the newest run, the chart as SVG. Out: the image. Must not know: how the chart is drawn.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { CoreEvent } from '../worker/core-client';
import type { NewestQuestion, Panel, PanelKind, Shell } from './panel';
import chartStyles from './speed-chart.css?inline';

export const speedChart: PanelKind = { styles: chartStyles, make: (shell) => new SpeedChartPanel(shell) };

class SpeedChartPanel implements Panel {
  readonly #image = make('img', { className: 'speed-chart', draggable: false, hidden: true });
  readonly #chart: NewestQuestion<'speed-chart'>;
  readonly elements = { pictures: [this.#image] };

  constructor(shell: Shell) {
    this.#chart = shell.newest('speed-chart', (svg) => this.#show(svg));
  }

  set language(language: Language) {
    this.#image.alt = WORDS[language].chart;
  }

  onEvent(event: CoreEvent): void {
    if (event.kind !== 'report') return;
    if (event.report.summary.motions === 0) return this.#chart.ask(undefined);
    this.#chart.cancel();
    this.#show(undefined);
  }

  onWorkerLost(): void {
    this.#show(undefined);
  }

  #show(svg: string | undefined): void {
    URL.revokeObjectURL(this.#image.src);
    this.#image.hidden = svg === undefined;
    if (svg === undefined) return this.#image.removeAttribute('src');
    this.#image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  }
}

const WORDS = words({
  en: { chart: 'Spindle speed over the diameter, with its limits' },
  zh: { chart: '主轴转速随直径的变化，以及转速限制' },
  ru: { chart: 'Частота вращения шпинделя в зависимости от диаметра, с ограничениями' },
});
