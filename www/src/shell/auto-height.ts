// The attribute `height`: `auto` makes the element as high as its contents.
//
// In: the attributes `height`, `rows-min` and `rows-max`, changes of the contents. Out: `content-height`, which is loaded
// only for such an element. Must not know: how the height is found.

import { importWithRetry } from '../dom/network';
import type { Program } from '../editor/program';
import { parseRows } from './author';
import type { ContentHeight } from './content-height';
import type { Layout } from './layout';
import type { PendingParts } from './pending-parts';

interface HeightHost {
  readonly height: string | null;
  readonly rowsMin: string | null;
  readonly rowsMax: string | null;
}

interface AutoHeightOptions {
  readonly root: ShadowRoot;
  readonly host: HeightHost;
  readonly layout: Layout;
  readonly editor: Program;
  readonly pending: PendingParts;
}

export class AutoHeight {
  readonly #options: AutoHeightOptions;
  #isConnected = false;
  #fitted: ContentHeight | undefined;

  constructor(options: AutoHeightOptions) {
    this.#options = options;
  }

  connect(): void {
    this.#isConnected = true;
    this.changed();
  }

  disconnect(): void {
    this.#isConnected = false;
    this.#end();
  }

  /** An attribute has changed. */
  changed(): void {
    if (this.#isAuto) void this.#begin();
    else this.#end();
  }

  /** The program or its results have changed. */
  update(): void {
    this.#fitted?.update();
  }

  get #isAuto(): boolean {
    return this.#isConnected && this.#options.host.height === 'auto';
  }

  /** The element settles when it has its height. If the part cannot be loaded, it keeps its current height. */
  async #begin(): Promise<void> {
    const { host, pending } = this.#options;
    pending.add('height');
    const part = await importWithRetry(() => import('./content-height')).catch(() => undefined);
    if (part === undefined || !this.#isAuto) return pending.finish('height');
    this.#fitted ??= new part.ContentHeight(this.#options);
    this.#fitted.rows = parseRows(host.rowsMin, host.rowsMax);
  }

  #end(): void {
    this.#fitted?.end();
    this.#fitted = undefined;
  }
}
