// The dots beside lines with problems, and their tooltips.
//
// In: the diagnostics in the editor, moved by edits. Out: a dot for each line with one: CodeMirror's own gutter would
// keep its dots until the next diagnostics, even if their text was removed. The tooltip opens above the line, so that
// the following lines stay visible. Must not know: the meaning of a diagnostic.

import { forEachDiagnostic, setDiagnosticsEffect } from '@codemirror/lint';
import { RangeSet, StateEffect, StateField, type EditorState, type Extension, type Range } from '@codemirror/state';
import { type EditorView, gutter, GutterMarker, showTooltip, type Tooltip } from '@codemirror/view';
import { make } from '../dom/dom';
import type { ShownDiagnostic } from './lint';

const HOVER_DELAY_MS = 300;

const RANK = { hint: 0, info: 0, warning: 1, error: 2 } as const;

class Dot extends GutterMarker {
  readonly severity: ShownDiagnostic['severity'];

  constructor(severity: ShownDiagnostic['severity']) {
    super();
    this.severity = severity;
  }

  override eq(other: GutterMarker): boolean {
    return other instanceof Dot && other.severity === this.severity;
  }

  override toDOM(): HTMLElement {
    return make('div', { className: `cm-lint-marker cm-lint-marker-${this.severity}` });
  }
}

/** Incremented whenever the dots may have moved. */
const version = StateField.define<number>({
  create: () => 0,
  update: (value, { docChanged, effects }) =>
    value + Number(docChanged || effects.some((effect) => effect.is(setDiagnosticsEffect))),
});

function dotsOf(state: EditorState): RangeSet<GutterMarker> {
  const worst = new Map<number, ShownDiagnostic['severity']>();
  forEachDiagnostic(state, ({ severity }, from) => {
    const line = state.doc.lineAt(from).from;
    const before = worst.get(line);
    if (before === undefined || RANK[severity] > RANK[before]) worst.set(line, severity);
  });
  return RangeSet.of(
    [...worst].map(([line, severity]): Range<GutterMarker> => new Dot(severity).range(line)),
    true,
  );
}

const showPopUp = StateEffect.define<Tooltip | null>();

const popUp = StateField.define<Tooltip | null>({
  create: () => null,
  update(shown, { docChanged, effects }) {
    let next = docChanged ? null : shown;
    for (const effect of effects) {
      if (effect.is(showPopUp)) next = effect.value;
      else if (effect.is(setDiagnosticsEffect)) next = null;
    }
    return next;
  },
  provide: (field) => showTooltip.from(field),
});

/** All problems of a line, each with its fixes. */
function tooltipContent(
  view: EditorView,
  problems: readonly { readonly problem: ShownDiagnostic; readonly from: number; readonly to: number }[],
): HTMLElement {
  const rows = problems.map(({ problem, from, to }) => {
    const fixButtons = (problem.actions ?? []).map(({ name, apply }) => {
      const button = make('button', { type: 'button', className: 'cm-diagnosticAction' }, name);
      button.addEventListener('click', () => apply(view, from, to));
      return button;
    });
    const message = problem.renderMessage?.(view) ?? problem.message;
    return make('li', { className: `cm-diagnostic cm-diagnostic-${problem.severity}` }, message, ...fixButtons);
  });
  return make('ul', { className: 'cm-tooltip-lint' }, ...rows);
}

export function problemGutter(): Extension {
  let cached: { readonly version: number; readonly dots: RangeSet<GutterMarker> } | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const schedule = (act: () => void): void => {
    clearTimeout(timer);
    timer = setTimeout(act, HOVER_DELAY_MS);
  };
  const hide = (view: EditorView): void => {
    if (view.state.field(popUp) !== null) view.dispatch({ effects: showPopUp.of(null) });
  };
  const show = (view: EditorView, from: number, to: number): void => {
    const problems: { problem: ShownDiagnostic; from: number; to: number }[] = [];
    forEachDiagnostic(view.state, (problem, start, end) => {
      if (from <= start && start <= to) problems.push({ problem: problem as ShownDiagnostic, from: start, to: end });
    });
    if (problems.length === 0) return;
    const create: Tooltip['create'] = () => {
      const dom = tooltipContent(view, problems);
      dom.addEventListener('mouseenter', () => clearTimeout(timer));
      dom.addEventListener('mouseleave', () => schedule(() => hide(view)));
      return { dom };
    };
    view.dispatch({ effects: showPopUp.of({ pos: from, above: true, create }) });
  };
  return [
    version,
    popUp,
    gutter({
      class: 'cm-gutter-lint',
      markers: ({ state }) => {
        const now = state.field(version);
        if (cached?.version !== now) cached = { version: now, dots: dotsOf(state) };
        return cached.dots;
      },
      domEventHandlers: {
        mouseover(view, line, event) {
          if ((event.target as Element).classList.contains('cm-lint-marker'))
            schedule(() => show(view, line.from, line.to));
          return false;
        },
        mouseout(view) {
          schedule(() => hide(view));
          return false;
        },
      },
    }),
  ];
}
