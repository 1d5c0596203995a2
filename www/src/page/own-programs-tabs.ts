// What the tabs of this page say to each other about the reader's own programs.
//
// In and out: which program was changed or deleted, by which tab. Whatever else arrives is no news. A browser without
// channels says nothing: nothing is overwritten all the same, since the store compares revisions.
// Must not know: what a tab does about it.

import { isCount, isId, TAB } from './storage';

export type TabNews =
  | { readonly kind: 'changed'; readonly id: string; readonly revision: number }
  | { readonly kind: 'deleted'; readonly id: string }
  /** Many at once, or how they are listed. */
  | { readonly kind: 'list' };

const NAME = `gcode-playground:programs:${location.pathname}`;

export class Tabs {
  readonly #channel = typeof BroadcastChannel === 'undefined' ? undefined : new BroadcastChannel(NAME);

  constructor(heard: (news: TabNews) => void) {
    this.#channel?.addEventListener('message', ({ data }: MessageEvent<unknown>) => {
      const news = newsIn(data);
      if (news !== undefined) heard(news);
    });
  }

  tell(news: TabNews): void {
    this.#channel?.postMessage({ ...news, tab: TAB });
  }
}

function newsIn(data: unknown): TabNews | undefined {
  const { kind, id, revision } = Object(data) as Partial<Record<'kind' | 'id' | 'revision', unknown>>;
  if (kind === 'list') return { kind };
  if (!isId(id)) return undefined;
  if (kind === 'deleted') return { kind, id };
  return kind === 'changed' && isCount(revision) ? { kind, id, revision } : undefined;
}
