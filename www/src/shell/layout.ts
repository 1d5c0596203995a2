// Where the regions of the panels stand around the editor, or around the picture alone.
//
// In: the view, the editor. Out: the frame, and for each region what its panels stand in. Must not
// know: which panels there are.

import { make } from '../dom/dom';
import type { Region } from '../panels/panel';

/** What the element shows: all there is, or the picture alone. */
export const VIEWS = ['all', 'picture'] as const;
export type View = (typeof VIEWS)[number];

export function viewOf(attribute: string | null): View {
  return VIEWS.find((view) => view === attribute) ?? 'all';
}

export interface Layout {
  readonly frame: HTMLElement;
  readonly regions: Readonly<Record<Region, HTMLElement>>;
}

export function layout(view: View, editor: HTMLElement): Layout {
  const bare = (): HTMLElement => make('div', { className: 'region' });
  const regions = {
    tabs: make('div', { className: 'tabs' }),
    notices: make('div', { className: 'notices' }),
    bar: make('div', { className: 'bar', part: 'bar' }),
    problems: bare(),
    divider: bare(),
    views: make('div', { className: 'views', part: 'views', role: 'group' }),
    assumptions: make('div', { className: 'assumptions', part: 'assumptions' }),
    // What the page has for readers without scripts stands here until there is a picture.
    pictures: make('div', { className: 'pictures' }, make('slot', { name: 'fallback' })),
    playback: make('div', { className: 'playback', part: 'playback', role: 'group' }),
    foot: make('div', { className: 'foot' }),
    dialogs: bare(),
  };
  if (view === 'picture') {
    // The other regions stand nowhere.
    const frame = make('div', { className: 'frame picture-only', part: 'frame' }, make('div', { className: 'shown' }, regions.notices, regions.pictures));
    return { frame, regions };
  }
  // Where room is short, `data-tab` says which of the tabs is shown.
  const frame = make(
    'div', { className: 'frame', part: 'frame', 'data-tab': 'program' },
    regions.tabs,
    make('div', { className: 'written', id: 'written' }, make('slot', { name: 'intro' }), regions.notices, regions.bar, editor, regions.problems),
    regions.divider,
    make('div', { className: 'shown', id: 'shown' }, regions.views, regions.assumptions, regions.pictures, regions.playback),
    regions.foot,
    regions.dialogs,
  );
  return { frame, regions };
}
