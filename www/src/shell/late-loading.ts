// Loads what the first picture does not need: panels, the editor, the link to the playground.
//
// In: the view, progress of the first run. Out: the loaded parts; failures as missing parts, which are loaded again on
// request. The editor is loaded after the first picture, the link after the run is settled. Must not know: the contents
// of a part, or which runs there are later.

import { importWithRetry } from '../dom/network';
import type { PanelKind } from '../panels/panel';
import type { CoreEvent } from '../worker/core-client';
import { VIEW_CONTENTS, type View } from './layout';
import type { Missing } from './missing';
import type { LinkHost, OpenLink } from './open-link';
import type { Part, PendingParts } from './pending-parts';

/** The panels of a view that are loaded after the first picture. */
export interface Further {
  readonly FURTHER: readonly PanelKind[];
  readonly SHARED_STYLES: readonly string[];
}

const FURTHER: Readonly<Record<View, (() => Promise<Further>) | undefined>> = {
  all: () => import('../panels/further'),
  picture: undefined,
  playback: () => import('../panels/with-playback'),
  code: () => import('../panels/with-code'),
};

/** Every deployed `element.js` has a page beside it. A bundled element has none: its page must set `playground`. */
const DEFAULT_PLAYGROUND = import.meta.url.endsWith('/element.js')
  ? import.meta.url.replace(/element\.js$/, 'index.html')
  : undefined;

/** How long the editor waits for the first picture after a run has ended. */
const EDITOR_AFTER_MS = 500;

/** The parts that a new element waits for. `playground`: the attribute. */
export function initialParts(view: View, playground: string | null): readonly Part[] {
  return [
    ...(FURTHER[view] === undefined ? [] : (['panels'] as const)),
    ...(VIEW_CONTENTS[view].program ? (['editor'] as const) : []),
    ...(playground === '' ? [] : (['link'] as const)),
  ];
}

interface LateLoadingOptions {
  readonly view: View;
  readonly missing: Missing;
  readonly pending: PendingParts;
  addPanels(further: Further): void;
  /** Replaces the plain text with the editor. */
  loadEditor(): Promise<void>;
}

export class LateLoading {
  readonly #options: LateLoadingOptions;
  /** Resolved when all panels of the view are loaded; rejected if they could not be loaded. */
  #panels: Promise<void> = Promise.resolve();
  /** Whether the editor is loaded or being loaded. */
  #editorRequested = false;
  #linkRequested = false;
  #link: OpenLink | undefined;

  constructor(options: LateLoadingOptions) {
    this.#options = options;
  }

  // ---- panels -------------------------------------------------------------------------------------

  get panels(): Promise<void> {
    return this.#panels;
  }

  /** `onLoaded` is called once, also after a retry. */
  loadPanels(onLoaded: () => void): void {
    const load = FURTHER[this.#options.view];
    if (load === undefined) return;
    this.#panels = this.#addPanels(load, () => this.loadPanels(onLoaded));
    // Callers of `panels` handle a rejection, and the user sees a notice.
    this.#panels.then(onLoaded).catch(() => undefined);
  }

  async #addPanels(load: () => Promise<Further>, retry: () => void): Promise<void> {
    const { missing, pending } = this.#options;
    try {
      const further = await importWithRetry(load);
      missing.markLoaded('panels');
      this.#options.addPanels(further);
    } catch (error) {
      missing.markFailed('panels', error, retry);
      throw error;
    } finally {
      pending.finish('panels');
    }
  }

  // ---- the editor ---------------------------------------------------------------------------------

  /** The interpreter is loaded. */
  onReady(): void {
    // In views with a picture, load the editor later, so that it does not compete for the network.
    if (!VIEW_CONTENTS[this.#options.view].picture) this.loadEditorIfShown();
  }

  onEvent({ kind }: CoreEvent): void {
    // Wait a moment for the first picture, which a short program has soon. In a hidden tab it never comes.
    if (kind === 'path' || kind === 'report') setTimeout(() => this.loadEditorIfShown(), EDITOR_AFTER_MS);
    else if (kind === 'progress' || kind === 'part-failed') this.loadEditorIfShown();
  }

  loadEditorIfShown(): void {
    if (!VIEW_CONTENTS[this.#options.view].program || this.#editorRequested) return;
    this.#editorRequested = true;
    void this.#loadEditor();
  }

  async #loadEditor(): Promise<void> {
    const { missing, pending } = this.#options;
    try {
      await this.#options.loadEditor();
      missing.markLoaded('editor');
    } catch (error) {
      missing.markFailed('editor', error, () => void this.#loadEditor());
    }
    pending.finish('editor');
  }

  // ---- the link -----------------------------------------------------------------------------------

  /** Loads the link to the playground into the frame, except on the playground's own page. */
  async loadLink(host: LinkHost, frame: HTMLElement): Promise<void> {
    const { pending } = this.#options;
    if (this.#linkRequested || !pending.has('link')) return;
    this.#linkRequested = true;
    try {
      const { OpenLink } = await import('./open-link');
      this.#link = new OpenLink(host, DEFAULT_PLAYGROUND);
      frame.append(this.#link.element);
    } catch {
      // Ignored: the picture works without the link.
    }
    pending.finish('link');
  }

  /** An attribute or the language has changed. */
  updateLink(): void {
    this.#link?.changed();
  }
}
