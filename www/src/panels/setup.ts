// The setup: the button that opens its form, whether tools and stock are inferred, and the form itself.
//
// In: which parts are given and which are inferred; answers to the entries. Out: the setup, stored in the program or in
// the page. Must not know: which fields a setup has, or how anything is inferred.

import { icon, make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type {
  LengthUnit,
  SetupOverview,
  SetupAnswer,
  SetupForm,
  SetupGroup,
  SetupPlace,
  Setting,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { InferredStock } from './inferred-stock';
import { formatLength } from './lengths';
import { loadPart } from './load-part';
import type { Panel, PanelKind, Services, Shell } from './panel';
import setupStyles from './setup.css?inline';
import type { SetupDialog, SetupEntries } from './setup-form';
import type { TurretSide } from './setup-pictures';

export const setup: PanelKind = {
  control: 'setup',
  edits: true,
  styles: setupStyles,
  make: (shell) => new Setup(shell),
};

class Setup implements Panel {
  readonly #shell: Shell;
  readonly #label = make('span');
  readonly #size = make('span', { className: 'blank-size' });
  readonly #inferredTools = make('span', { className: 'assumed' });
  readonly #button = make(
    'button',
    { type: 'button', className: 'chip setup-button', part: 'setup', 'aria-haspopup': 'dialog' },
    this.#label,
    ' ',
    this.#size,
    ' ',
    this.#inferredTools,
    icon('chevron'),
  );
  readonly #inferredStock: InferredStock;
  /** Loaded when it is first opened. */
  #form: SetupDialog | undefined;
  #overview: SetupOverview | undefined;
  #unit: LengthUnit = 'mm';
  #turret: TurretSide = 'rear';
  readonly elements: Panel['elements'];
  readonly services: Partial<Services> = {
    openSetup: (group, key) => void this.#open(group, key),
    applySetting: (setting) => void this.#applySetting(setting),
  };

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#inferredStock = new InferredStock({
      form: () => this.#ask(),
      read: (entries) => this.#read(entries),
      onApplied: (answer, place) => {
        this.#apply(answer, place);
        // The clicked button is removed.
        this.#button.focus();
      },
    });
    this.#button.addEventListener('click', () => void this.#open());
    this.elements = {
      views: [this.#button],
      assumptions: [this.#inferredStock.element],
    };
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.#label.textContent = texts.setup;
    this.#inferredTools.textContent = texts.toolsAssumed;
    this.#inferredStock.setTexts(texts.stockAssumed, texts.useStock);
    if (this.#form !== undefined) this.#form.language = language;
    this.#render();
  }

  get capturesKeys(): boolean {
    return this.#form?.open ?? false;
  }

  onProgramReplaced(): void {
    this.#form?.clearUnapplied();
  }

  onEvent(event: CoreEvent): void {
    const views = event.kind === 'views' ? event.views : event.kind === 'report' ? event.report.views : undefined;
    if (views !== undefined) this.#turret = views.turret;
    if (event.kind !== 'report') return;
    this.#overview = this.#inferredStock.overview = event.report.overview;
    this.#unit = event.report.units.shown;
    this.#render();
  }

  #render(): void {
    const [diameter, length] = this.#overview?.blank ?? [];
    this.#size.textContent =
      diameter === undefined || length === undefined
        ? ''
        : `Ø${formatLength(diameter, this.#unit)}×${formatLength(length, this.#unit)}`;
    this.#inferredTools.hidden = !(this.#overview?.tools.some(({ known }) => known === 'inferred') ?? false);
  }

  async #open(group?: SetupGroup['group'], key?: string): Promise<void> {
    const load = loadPart(
      this.#shell,
      () => import('./setup-form'),
      () => void this.#open(group, key),
    );
    const [form, part] = await Promise.all([this.#ask(), load]);
    if (form === undefined || part === undefined) return;
    if (this.#form === undefined) {
      this.#form = new part.SetupDialog(this.#shell.language, {
        read: (entries) => this.#read(entries),
        toolGroup: (word) => this.#shell.ask('another-tool', { word }),
        onApplied: (answer, place) => this.#apply(answer, place),
      });
      this.#shell.region('dialogs').append(this.#form.element);
    }
    this.#form.show(form, this.#unit, this.#turret, group, key);
  }

  /** Fills in one field as the user would; all other fields keep their values. */
  async #applySetting({ key, value }: Setting): Promise<void> {
    if (value === undefined) return this.#open('control', key);
    const form = await this.#ask();
    if (form === undefined) return;
    const fields = form.groups.flatMap(({ fields }) => fields);
    // A single rule has no field.
    const others = fields.filter((field) => field.key !== key);
    const keys = [...others.map((field) => field.key), key];
    const texts = [...others.map((field) => field.value), value];
    const answer = await this.#read({ keys, texts, keep: form.place });
    if (answer !== undefined) this.#apply(answer, form.place);
  }

  #read(entries: SetupEntries): Promise<SetupAnswer | undefined> {
    return this.#shell.ask('read-setup', { ...entries, json: this.#shell.setup ?? '{}' });
  }

  async #ask(): Promise<SetupForm | undefined> {
    this.#shell.flush();
    return this.#shell.ask('setup-form', undefined);
  }

  #apply({ setup, edits }: SetupAnswer, place: SetupPlace): void {
    const { editor, language } = this.#shell;
    editor.change(edits);
    const texts = WORDS[language].kept;
    this.#shell.changeSetup(setup === '' ? null : setup);
    this.#shell.service('notice')(place === 'program' ? texts.program : texts.page, 'program-setup');
  }
}

const WORDS = words({
  en: {
    setup: 'Setup',
    /** Next to the button of the form, if no tools are given. */
    toolsAssumed: 'Tools assumed',
    /** The line above the drawing if no stock is given, and its button. */
    stockAssumed: 'Stock assumed: collisions not checked',
    useStock: 'use this stock',
    kept: {
      program: 'The setup is in the program now. Ctrl Z removes it.',
      page: 'The setup is kept on this page.',
    },
  },
  zh: {
    setup: '毛坯与刀具',
    toolsAssumed: '刀具为假定',
    stockAssumed: '毛坯为假定：未检查碰撞',
    useStock: '采用此毛坯',
    kept: { program: '设置已写入程序。按 Ctrl Z 可撤销。', page: '设置已保存在本页。' },
  },
  ru: {
    setup: 'Наладка',
    toolsAssumed: 'Инструменты по умолчанию',
    stockAssumed: 'Заготовка по умолчанию: столкновения не проверяются',
    useStock: 'взять её',
    kept: { program: 'Наладка записана в программу. Ctrl Z убирает её.', page: 'Наладка хранится на этой странице.' },
  },
});
