// Where the regions of the panels stand around the editor.
//
// In: the editor. Out: the frame, and for each region what its panels stand in. Must not
// know: which panels there are.

import { make } from '../dom/dom';
import type { Region } from '../panels/panel';

export interface Layout {
  readonly frame: HTMLElement;
  readonly regions: Readonly<Record<Region, HTMLElement>>;
}

export function layout(editor: HTMLElement): Layout {
  const bare = (): HTMLElement => make('div', { className: 'region' });
  const regions = {
    notices: bare(),
    bar: make('div', { className: 'bar', part: 'bar' }),
    problems: bare(),
    views: make('div', { className: 'views', part: 'views', role: 'group' }),
    assumptions: make('div', { className: 'assumptions', part: 'assumptions' }),
    pictures: make('div', { className: 'pictures' }),
    playback: make('div', { className: 'playback', part: 'playback', role: 'group' }),
    foot: make('div', { className: 'foot' }),
    dialogs: bare(),
  };
  const frame = make(
    'div', { className: 'frame', part: 'frame' },
    make('div', { className: 'written' }, make('slot', { name: 'intro' }), regions.notices, regions.bar, editor, regions.problems),
    make('div', { className: 'shown' }, regions.views, regions.assumptions, regions.pictures, regions.playback),
    regions.foot,
    regions.dialogs,
  );
  return { frame, regions };
}
