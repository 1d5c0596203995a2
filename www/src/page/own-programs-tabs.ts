// Messages between the tabs of this page about saved programs.
//
// In and out: which program was changed or deleted, by which tab; unknown messages are ignored. Without
// `BroadcastChannel` there are no messages; even so, nothing is overwritten, since the store compares revisions. Must
// not know: how a tab reacts.

import { isCount, isId, TAB_ID } from './storage';

export type TabNews =
  | { readonly kind: 'changed'; readonly id: string; readonly revision: number }
  | { readonly kind: 'deleted'; readonly id: string }
  /** Several programs have changed, or their names. */
  | { readonly kind: 'list' };

const NAME = `gcode-playground:programs:${location.pathname}`;

export class Tabs {
  readonly #channel = typeof BroadcastChannel === 'undefined' ? undefined : new BroadcastChannel(NAME);

  constructor(onNews: (news: TabNews) => void) {
    this.#channel?.addEventListener('message', ({ data }: MessageEvent<unknown>) => {
      const news = parseNews(data);
      if (news !== undefined) onNews(news);
    });
  }

  post(news: TabNews): void {
    this.#channel?.postMessage({ ...news, tab: TAB_ID });
  }
}

function parseNews(data: unknown): TabNews | undefined {
  const { kind, id, revision } = Object(data) as Partial<Record<'kind' | 'id' | 'revision', unknown>>;
  if (kind === 'list') return { kind };
  if (!isId(id)) return undefined;
  if (kind === 'deleted') return { kind, id };
  return kind === 'changed' && isCount(revision) ? { kind, id, revision } : undefined;
}
