// A read-only program with the colours of the editor, for reading and copying.
//
// In: a text and its tokens. Out: an element. Must not know: the source of the text.

import { defaultKeymap } from '@codemirror/commands';
import { EditorState } from '@codemirror/state';
import { drawSelection, EditorView, keymap, lineNumbers } from '@codemirror/view';
import { marks, showTokens } from './marks';
import { editorTheme } from './theme';

export class CodeView {
  readonly #view: EditorView;

  /** `tokens`: triples `from, to, class`, sorted. `name`: the accessible name. */
  constructor(parent: HTMLElement, root: ShadowRoot, text: string, tokens: Uint32Array, name: string) {
    this.#view = new EditorView({
      parent,
      root,
      state: EditorState.create({
        doc: text,
        extensions: [
          EditorState.readOnly.of(true),
          EditorView.editable.of(false),
          lineNumbers(),
          drawSelection(),
          marks,
          editorTheme,
          keymap.of(defaultKeymap),
          EditorView.contentAttributes.of({ tabindex: '0', lang: 'en', 'aria-label': name, 'aria-readonly': 'true' }),
        ],
      }),
    });
    this.#view.dispatch({ effects: showTokens.of(tokens) });
  }

  get text(): string {
    return this.#view.state.doc.toString();
  }

  /** Call when the container has become visible. */
  onVisible(): void {
    this.#view.requestMeasure();
    this.#view.focus();
  }

  selectAll(): void {
    this.#view.dispatch({ selection: { anchor: 0, head: this.#view.state.doc.length } });
    this.#view.focus();
  }

  destroy(): void {
    this.#view.destroy();
  }
}
