// The panels of one element.
//
// In: kinds of panels, events of the element. Out: the panels' elements in the regions, their services, keys and
// commands; the events for each panel. Panels that are loaded later receive the events of the newest run that they have
// missed. Must not know: the purpose of a panel, the cause of an event, or how panels are loaded.

import type { Language } from '../dom/language';
import type { ProgramFile } from '../editor/program-text';
import {
  REGIONS,
  type Control,
  type Panel,
  type PanelKind,
  type Region,
  type Services,
  type Shell,
  type SwitchState,
  type UserCommand,
} from '../panels/panel';
import type { Report } from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { shownControls, type View } from './layout';
import { adoptStyles } from './style-sheets';

interface PanelSetOptions {
  readonly root: ShadowRoot;
  readonly regions: Readonly<Record<Region, HTMLElement>>;
  readonly view: View;
  /** The attribute `controls`. */
  readonly controls: string | null;
  readonly readonly: boolean;
  readonly language: Language;
}

/** The events that panels loaded later have missed. */
interface MissedEvents {
  readonly events: Map<CoreEvent['kind'], CoreEvent>;
  switches?: SwitchState;
  isLost?: boolean;
}

export class PanelSet {
  readonly regions: Readonly<Record<Region, HTMLElement>>;
  readonly #root: ShadowRoot;
  readonly #view: View;
  /** The groups of panels that are shown. */
  readonly #controls: readonly Control[];
  readonly #readonly: boolean;
  readonly #panels: Panel[] = [];
  /** Panels that are not displayed and exist only for their services. */
  readonly #hiddenPanels = new Set<Panel>();
  readonly #services: Partial<Services> = {};
  #language: Language;
  /** Events of the newest run for panels that are loaded later; undefined once all are loaded. */
  #missed: MissedEvents | undefined = { events: new Map() };

  constructor({ root, regions, view, controls, readonly, language }: PanelSetOptions) {
    this.regions = regions;
    this.#root = root;
    this.#view = view;
    this.#controls = shownControls(view, controls);
    this.#readonly = readonly;
    this.#language = language;
  }

  // ---- panels -------------------------------------------------------------------------------------

  /** Makes panels and adds them before the existing ones. */
  add(kinds: readonly PanelKind[], shell: Shell): readonly Panel[] {
    adoptStyles(
      this.#root,
      kinds.map(({ styles }) => styles ?? ''),
    );
    const added = kinds.map(({ make }) => make(shell));
    for (const [at, kind] of kinds.entries()) {
      const panel = added[at];
      if (panel !== undefined && !this.#isShown(kind)) this.#hiddenPanels.add(panel);
    }
    for (const region of REGIONS) {
      const visible = added.filter((panel) => region === 'dialogs' || !this.#hiddenPanels.has(panel));
      this.regions[region].prepend(...visible.flatMap(({ elements }) => elements[region] ?? []));
    }
    for (const panel of added) Object.assign(this.#services, panel.services);
    this.#panels.unshift(...added);
    for (const panel of added) panel.language = this.#language;
    return added;
  }

  /** Adds the last panels, and replays the missed events to them. `hasFailed`: there will be no report of the run. */
  addLast(kinds: readonly PanelKind[], shell: Shell, file: ProgramFile | undefined, hasFailed: boolean): void {
    const missed = this.#missed;
    this.#missed = undefined;
    for (const panel of this.add(kinds, shell)) {
      panel.onFileChanged?.(file);
      if (missed?.switches !== undefined) panel.onSwitchesChanged?.(missed.switches);
      if (missed?.isLost === true) panel.onWorkerLost?.();
      for (const event of missed?.events.values() ?? []) panel.onEvent?.(event);
      if (hasFailed) panel.onRunFailed?.();
      const report = missed?.events.get('report');
      if (report?.kind === 'report' && 'available' in panel) panel.available = hasMotions(report.report);
    }
  }

  #isShown({ control, edits }: PanelKind): boolean {
    return (control === undefined || this.#controls.includes(control)) && !(edits === true && this.#readonly);
  }

  set language(language: Language) {
    this.#language = language;
    for (const panel of this.#panels) panel.language = language;
  }

  /** Whether there is a finished run with motions. */
  set available(available: boolean) {
    for (const panel of this.#panels) if ('available' in panel) panel.available = available;
  }

  /** A service that the view offers. */
  service<S extends keyof Services>(name: S): Services[S] {
    const service = this.#services[name];
    if (service === undefined) throw new Error(`view="${this.#view}" does not offer ${name}`);
    return service;
  }

  /** A service, if a panel offers it. */
  findService<S extends keyof Services>(name: S): Services[S] | undefined {
    return this.#services[name];
  }

  /** What the user can do, for the command palette of the page. */
  get commands(): readonly UserCommand[] {
    const buttons = [...this.regions.views.querySelectorAll('button')].filter(
      (button) => button.checkVisibility() && !button.disabled,
    );
    return [
      ...this.#panels.flatMap((panel) => panel.commands ?? []),
      ...buttons.map((button) => ({
        name: button.getAttribute('aria-label') ?? button.textContent ?? '',
        run: () => button.click(),
      })),
    ];
  }

  handleKey(event: KeyboardEvent): void {
    if (this.#panels.some(({ capturesKeys }) => capturesKeys === true)) return;
    const target = event.composedPath()[0];
    const typing =
      target instanceof HTMLElement &&
      (target.isContentEditable || target.matches('input:not([type=range]), textarea'));
    const key = { event, inside: typing ? 'text' : 'elsewhere' } as const;
    if (!this.#panels.some((panel) => !this.#hiddenPanels.has(panel) && panel.onKey?.(key) === 'handled')) return;
    event.preventDefault();
    event.stopPropagation();
  }

  // ---- events -------------------------------------------------------------------------------------

  notify(notify: (panel: Panel) => void): void {
    for (const panel of this.#panels) notify(panel);
  }

  /** An event of the newest run. */
  onEvent(event: CoreEvent): void {
    this.#missed?.events.set(event.kind, event);
    this.notify((panel) => panel.onEvent?.(event));
  }

  onSwitchesChanged(switches: SwitchState): void {
    if (this.#missed !== undefined) this.#missed.switches = switches;
    this.notify((panel) => panel.onSwitchesChanged?.(switches));
  }

  onInputChanged(): void {
    this.#missed?.events.clear();
    this.notify((panel) => panel.onInputChanged?.());
  }

  onRunStarted(): void {
    if (this.#missed !== undefined) this.#missed.isLost = false;
    this.notify((panel) => panel.onRunStarted?.());
  }

  onWorkerLost(): void {
    if (this.#missed !== undefined) this.#missed.isLost = true;
    this.notify((panel) => panel.onWorkerLost?.());
  }
}

/** Whether the run is finished and has motions. */
export function hasMotions({ summary }: Report): boolean {
  return summary.finished && summary.motions > 0;
}
