// Values of variables that the user tries ("what if"), each displayed after its block.
//
// In: values to try, and to remove. Out: the current ones; they move with edits, and are removed with their block. The
// text is not changed. Must not know: the purpose of a variable.

import { MapMode, StateEffect, StateField, type ChangeDesc, type EditorState, type Extension } from '@codemirror/state';
import { Decoration, EditorView, WidgetType, type DecorationSet } from '@codemirror/view';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import type { TriedValue } from '../protocol/protocol';
import { lastOf } from './effects';

/** Maximum number of values at a time. */
const MAX_VALUES = 20;

/** Replaces all tried values. */
const setTried = StateEffect.define<readonly TriedValue[]>();

const tried = StateField.define<readonly TriedValue[]>({
  create: () => [],
  update(before, { changes, docChanged, effects }) {
    const values = lastOf(effects, setTried);
    if (values !== undefined) return values;
    return docChanged && before.length > 0 ? mapValues(before, changes) : before;
  },
});

function mapValues(before: readonly TriedValue[], changes: ChangeDesc): readonly TriedValue[] {
  return before.flatMap((value) => {
    const at = changes.mapPos(value.at, 1, MapMode.TrackDel);
    return at === null ? [] : [{ ...value, at }];
  });
}

/** The widget of a value after its block; a click removes the value. */
class TriedValueWidget extends WidgetType {
  readonly #value: TriedValue;
  readonly #language: Language;

  constructor(value: TriedValue, language: Language) {
    super();
    this.#value = value;
    this.#language = language;
  }

  override eq(other: TriedValueWidget): boolean {
    return other.#value === this.#value && other.#language === this.#language;
  }

  override toDOM(view: EditorView): HTMLElement {
    const texts = WORDS[this.#language];
    const { variable, value, time } = this.#value;
    const button = make(
      'button',
      { type: 'button', className: 'tried-value', title: texts.end },
      texts.tried(variable, value, time),
      make('span', { 'aria-hidden': 'true' }, ' ×'),
    );
    button.addEventListener('click', () => endTrial(view, this.#value));
    return button;
  }

  override ignoreEvent(): boolean {
    return true;
  }
}

/** `language` is called for each note. */
export function triedValues(language: () => Language): Extension {
  const decorations = (state: EditorState): DecorationSet => {
    const shown = state
      .field(tried)
      .map((value) =>
        Decoration.widget({ widget: new TriedValueWidget(value, language()), side: 1 }).range(
          state.doc.lineAt(value.at).to,
        ),
      );
    return Decoration.set(shown, true);
  };
  return [tried, EditorView.decorations.compute([tried, 'doc'], decorations)];
}

/** The tried values, in the order in which they were set. */
export function triedOf(state: EditorState): readonly TriedValue[] {
  return state.field(tried);
}

/** Sets a value; replaces one of the same variable at the same position. */
export function tryValue(view: EditorView, value: TriedValue): void {
  const others = view.state.field(tried).filter((entry) => !isSame(entry, value));
  view.dispatch({ effects: setTried.of([...others, value].slice(-MAX_VALUES)) });
}

/** Removes a value, or all of them. */
export function endTrial(view: EditorView, value?: TriedValue): void {
  const remaining = value === undefined ? [] : view.state.field(tried).filter((entry) => !isSame(entry, value));
  view.dispatch({ effects: setTried.of(remaining) });
}

/** Whether two values are for the same variable, position and repetition. */
function isSame(value: TriedValue, other: TriedValue): boolean {
  return value.at === other.at && value.time === other.time && value.variable === other.variable;
}

const WORDS = words({
  en: {
    tried: (variable: number, value: number, time: number) =>
      `what if #${variable} = ${value}${time > 1 ? ` (time ${time})` : ''}`,
    end: 'Stop trying this value',
  },
  zh: {
    tried: (variable, value, time) => `假如 #${variable} = ${value}${time > 1 ? `（第 ${time} 次）` : ''}`,
    end: '不再试用此值',
  },
  ru: {
    tried: (variable, value, time) => `что если #${variable} = ${value}${time > 1 ? ` (раз ${time})` : ''}`,
    end: 'Больше не пробовать это значение',
  },
});
