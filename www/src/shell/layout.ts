// The layout of the element: the regions of the panels around the editor or, in smaller views, around the picture.
//
// In: the view, the editor. Out: the frame, and an element for each region; the content of each view, and the methods
// it offers. Must not know: which panels exist.

import { make } from '../dom/dom';
import { CONTROLS, type Control, type Region, type Services } from '../panels/panel';

/** Everything; the picture only; the picture with the playback bar; or the program with its messages. */
export const VIEWS = ['all', 'picture', 'playback', 'code'] as const;
export type View = (typeof VIEWS)[number];

export function parseView(attribute: string | null): View {
  return VIEWS.find((view) => view === attribute) ?? 'all';
}

/** The methods of the element that are missing in some views. */
export type OptionalMethod =
  | Extract<
      keyof Services,
      'play' | 'pause' | 'openFile' | 'saveFile' | 'exported' | 'keepPart' | 'endComparison' | 'checkExercise'
    >
  | 'seek';

interface ViewContents {
  readonly program: boolean;
  readonly picture: boolean;
  readonly controls: readonly Control[];
  readonly offers: readonly OptionalMethod[];
}

export const VIEW_CONTENTS: Readonly<Record<View, ViewContents>> = {
  all: {
    program: true,
    picture: true,
    controls: CONTROLS,
    offers: ['play', 'pause', 'seek', 'openFile', 'saveFile', 'exported', 'keepPart', 'endComparison', 'checkExercise'],
  },
  picture: { program: false, picture: true, controls: [], offers: ['seek'] },
  playback: { program: false, picture: true, controls: ['playback'], offers: ['play', 'pause', 'seek'] },
  code: { program: true, picture: false, controls: ['problems'], offers: [] },
};

/** The groups of panels that are shown in a view, filtered by the attribute `controls`. */
export function shownControls(view: View, attribute: string | null): readonly Control[] {
  const { controls } = VIEW_CONTENTS[view];
  if (attribute === null) return controls;
  const names = attribute.split(/[\s,]+/);
  return controls.filter((control) => names.includes(control));
}

export interface Layout {
  readonly frame: HTMLElement;
  readonly regions: Readonly<Record<Region, HTMLElement>>;
  /** Hidden once there is a picture. */
  readonly fallback: HTMLElement;
  /** Under the frame. */
  readonly caption: HTMLElement;
  /** Frame and caption. */
  readonly container: HTMLElement;
}

export function createLayout(view: View, editor: HTMLElement): Layout {
  const plainRegion = (): HTMLElement => make('div', { className: 'region' });
  const regions = {
    head: make('div', { className: 'head', part: 'head' }),
    tabs: make('div', { className: 'tabs' }),
    notices: make('div', { className: 'notices' }),
    bar: make('div', { className: 'bar', part: 'bar' }),
    problems: plainRegion(),
    divider: plainRegion(),
    views: make('div', { className: 'views', part: 'views', role: 'group' }),
    assumptions: make('div', { className: 'assumptions', part: 'assumptions' }),
    pictures: make('div', { className: 'pictures' }),
    playback: make('div', { className: 'playback', part: 'playback', role: 'group' }),
    dialogs: plainRegion(),
    'program-menu': plainRegion(),
    'share-menu': plainRegion(),
    'help-menu': plainRegion(),
    'more-menu': plainRegion(),
    reading: plainRegion(),
    pace: plainRegion(),
  };
  // The content for users without scripts is shown here until there is a picture.
  const fallback = make('div', { className: 'fallback', part: 'fallback' }, make('slot', { name: 'fallback' }));
  // Panels are inserted before it.
  regions.pictures.append(fallback);
  const frame = make('div', { className: 'frame', part: 'frame', 'data-view': view });
  // Regions that a view does not show are not inserted.
  switch (view) {
    case 'all':
      // In a narrow element, `data-tab` is the selected tab.
      frame.dataset['tab'] = 'program';
      frame.append(
        regions.head,
        make(
          'div',
          { className: 'written', id: 'written' },
          regions.bar,
          editor,
          make('slot', { name: 'intro' }),
          regions.notices,
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
        regions.tabs,
      );
      break;
    case 'picture':
      frame.append(make('div', { className: 'shown' }, regions.notices, regions.pictures));
      break;
    case 'playback':
      frame.append(make('div', { className: 'shown' }, regions.notices, regions.pictures, regions.playback));
      break;
    case 'code':
      frame.append(make('div', { className: 'written' }, regions.notices, regions.bar, editor, regions.problems));
      break;
  }
  frame.append(regions.dialogs);
  const caption = make('p', { className: 'caption', part: 'caption', id: 'caption', dir: 'auto', hidden: true });
  const container = make('div', { className: 'own whole', role: 'group' }, frame, caption);
  return { container, frame, regions, fallback, caption };
}
