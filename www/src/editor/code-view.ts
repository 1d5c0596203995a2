// A program to read and to copy from, with the colours of the editor.
//
// In: a text and its tokens. Out: an element in its place. Must not know: where the text is from.

import { defaultKeymap } from '@codemirror/commands';
import { EditorState } from '@codemirror/state';
import { drawSelection, EditorView, keymap, lineNumbers } from '@codemirror/view';
import { marks, showTokens } from './marks';
import { editorTheme } from './theme';

export class CodeView {
  readonly #view: EditorView;

  /** `tokens`: triples `from, to, class`, in order. `name` is for screen readers. */
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

  /** What it stands in has just come into sight. */
  opened(): void {
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
