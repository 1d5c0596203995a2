// Where the regions of the panels stand around the editor, or around the picture where less is shown.
//
// In: the view, the editor. Out: the frame, and for each region what its panels stand in; what each view shows, and
// what a page can ask of it. Must not know: which panels there are.

import { make } from '../dom/dom';
import { CONTROLS, type Control, type Region, type Services } from '../panels/panel';

/** What the element shows: all there is, the picture alone, the picture that is played, or the program and its problems. */
export const VIEWS = ['all', 'picture', 'playback', 'code'] as const;
export type View = (typeof VIEWS)[number];

export function viewOf(attribute: string | null): View {
  return VIEWS.find((view) => view === attribute) ?? 'all';
}

/** The methods of the element that not every view offers. */
export type Offered = Extract<
  keyof Services,
  'play' | 'pause' | 'openFile' | 'saveFile' | 'exported' | 'keepPart' | 'endComparison'
>;

interface Shown {
  readonly program: boolean;
  readonly picture: boolean;
  readonly controls: readonly Control[];
  readonly offers: readonly Offered[];
}

export const SHOWN: Readonly<Record<View, Shown>> = {
  all: {
    program: true,
    picture: true,
    controls: CONTROLS,
    offers: ['play', 'pause', 'openFile', 'saveFile', 'exported', 'keepPart', 'endComparison'],
  },
  picture: { program: false, picture: true, controls: [], offers: [] },
  playback: { program: false, picture: true, controls: ['playback'], offers: ['play', 'pause'] },
  code: { program: true, picture: false, controls: ['problems'], offers: [] },
};

/** What of the panels is shown in a view where the attribute `controls` is so. */
export function controlsOf(view: View, attribute: string | null): readonly Control[] {
  const { controls } = SHOWN[view];
  if (attribute === null) return controls;
  const wanted = attribute.split(/[\s,]+/);
  return controls.filter((control) => wanted.includes(control));
}

export interface Layout {
  readonly frame: HTMLElement;
  readonly regions: Readonly<Record<Region, HTMLElement>>;
  /** Gone with the first picture. */
  readonly fallback: HTMLElement;
  /** Under the frame. */
  readonly caption: HTMLElement;
  /** Frame and caption. */
  readonly whole: HTMLElement;
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
    pictures: make('div', { className: 'pictures' }),
    playback: make('div', { className: 'playback', part: 'playback', role: 'group' }),
    foot: make('div', { className: 'foot' }),
    dialogs: bare(),
  };
  // What the page has for readers without scripts stands here until there is a picture.
  const fallback = make('div', { className: 'fallback', part: 'fallback' }, make('slot', { name: 'fallback' }));
  // What comes into it stands before this.
  regions.pictures.append(fallback);
  const frame = make('div', { className: 'frame', part: 'frame', 'data-view': view });
  // Regions that a view does not show stand nowhere.
  switch (view) {
    case 'all':
      // Where room is short, `data-tab` says which of the tabs is shown.
      frame.dataset['tab'] = 'program';
      frame.append(
        regions.tabs,
        make(
          'div',
          { className: 'written', id: 'written' },
          make('slot', { name: 'intro' }),
          regions.notices,
          regions.bar,
          editor,
          regions.problems,
        ),
        regions.divider,
        make(
          'div',
          { className: 'shown', id: 'shown' },
          regions.views,
          regions.assumptions,
          regions.pictures,
          regions.playback,
        ),
        regions.foot,
      );
      break;
    case 'picture':
      frame.append(make('div', { className: 'shown' }, regions.notices, regions.pictures));
      break;
    case 'playback':
      frame.append(make('div', { className: 'shown' }, regions.notices, regions.pictures, regions.playback));
      break;
    case 'code':
      frame.append(make('div', { className: 'written' }, regions.notices, editor, regions.problems));
      break;
  }
  frame.append(regions.dialogs);
  const caption = make('p', { className: 'caption', part: 'caption', id: 'caption', dir: 'auto', hidden: true });
  const whole = make('div', { className: 'own whole', role: 'group' }, frame, caption);
  return { whole, frame, regions, fallback, caption };
}
