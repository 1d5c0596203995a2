// The styles of the editor: all colours and fonts are CSS custom properties of the element.
//
// In: nothing. Out: CodeMirror extensions. Must not know: the edited language.

import type { Extension } from '@codemirror/state';
import { EditorView } from '@codemirror/view';

const LINT = { error: '--playground-error', warning: '--playground-warning', info: '--playground-info' };

const squiggles = Object.fromEntries(
  Object.entries(LINT).map(([severity, colour]) => [
    `.cm-lintRange-${severity}`,
    {
      backgroundImage: 'none',
      textDecoration: `underline wavy var(${colour}) 1.2px`,
      textDecorationSkipInk: 'none',
      textUnderlineOffset: '3px',
      paddingBottom: '0',
    },
  ]),
);

/** A multiple of the element's text size, as `rem` in its style sheets. */
export function rem(times: number): string {
  return `calc(${times} * var(--playground-rem))`;
}

export const editorTheme: Extension = EditorView.theme({
  '&': { height: '100%', color: 'var(--playground-ink)', backgroundColor: 'var(--playground-surface)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': {
    fontFamily: 'var(--playground-code-font)',
    fontSize: 'var(--playground-code-size)',
    lineHeight: '1.6',
    overscrollBehavior: 'contain',
  },
  '.cm-content': {
    padding: 'var(--playground-space-2) 0 var(--playground-space-6)',
    caretColor: 'var(--playground-ink)',
  },
  '.cm-line': { padding: '0 var(--playground-space-4) 0 var(--playground-space-2)' },
  '.cm-cursor': { borderLeftColor: 'var(--playground-ink)', borderLeftWidth: '2px' },
  '.cm-gutters': {
    backgroundColor: 'var(--playground-surface)',
    color: 'var(--playground-muted)',
    border: 'none',
    fontVariantNumeric: 'tabular-nums',
  },
  '.cm-lineNumbers .cm-gutterElement': { padding: '0 var(--playground-space-1)', minWidth: '2.4em', cursor: 'pointer' },
  '.cm-lineNumbers .cm-breakpoint': {
    backgroundColor: 'var(--playground-error)',
    color: 'var(--playground-surface)',
    borderRadius: 'var(--playground-radius-small)',
    fontWeight: '700',
  },
  '.cm-gutter-lint': { width: '1.1em' },
  '.cm-gutter-lint .cm-gutterElement': {
    padding: '0 0 0 var(--playground-space-half)',
    display: 'flex',
    alignItems: 'center',
  },
  '.cm-lint-marker': {
    width: '0.75em',
    height: '0.75em',
    borderRadius: '50%',
    content: 'none !important',
    forcedColorAdjust: 'none',
  },
  '.cm-lint-marker-error': { background: 'var(--playground-error)' },
  '.cm-lint-marker-warning': {
    background: 'var(--playground-warning)',
    borderRadius: 'var(--playground-radius-small)',
  },
  '.cm-lint-marker-info': { background: 'var(--playground-info)' },
  '.cm-activeLine': { backgroundColor: 'transparent' },
  '&.cm-focused .cm-activeLine, &.cm-chosen .cm-activeLine': { backgroundColor: 'var(--playground-active-line)' },
  '.cm-activeLineGutter': { backgroundColor: 'transparent', color: 'var(--playground-ink)' },
  '.cm-selectionBackground': { backgroundColor: 'var(--playground-selection) !important' },
  '&.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--playground-selection)' },
  '&.cm-focused .cm-nonmatchingBracket': { backgroundColor: 'transparent' },
  '.cm-hovered-block': {
    backgroundColor: 'var(--playground-hovered-block)',
    borderRadius: 'var(--playground-radius-small)',
  },
  '.tried-value': {
    minBlockSize: '0',
    minInlineSize: '0',
    marginInlineStart: '1.2em',
    padding: '0 0.5em',
    border: '1px solid var(--playground-accent)',
    borderRadius: 'var(--playground-radius-round)',
    backgroundColor: 'var(--playground-accent-soft)',
    color: 'var(--playground-ink)',
    fontFamily: 'var(--playground-font)',
    fontSize: '0.8em',
  },
  '.cm-used-number': { backgroundColor: 'var(--playground-selection)', borderRadius: 'var(--playground-radius-small)' },
  '.cm-marked-line': {
    backgroundColor: 'var(--playground-marked-line)',
    boxShadow: 'inset 3px 0 0 var(--playground-highlight)',
  },
  '.folded-lines': {
    minBlockSize: '0',
    padding: '0 var(--playground-space-1)',
    border: '1px solid var(--playground-line-strong)',
    borderRadius: 'var(--playground-radius-small)',
    color: 'var(--playground-muted)',
    fontFamily: 'var(--playground-font)',
    fontSize: 'var(--playground-type-note)',
    lineHeight: '1.4',
  },
  '.cm-running-line': {
    backgroundColor: 'var(--playground-running-line) !important',
    boxShadow: 'inset 3px 0 0 var(--playground-accent)',
  },
  ...squiggles,
  '.cm-lintRange-active': { backgroundColor: 'var(--playground-selection)' },
  '.cm-tooltip': {
    backgroundColor: 'var(--playground-raised)',
    color: 'var(--playground-ink)',
    border: '1px solid var(--playground-line)',
    borderRadius: 'var(--playground-radius)',
    boxShadow: 'var(--playground-shadow)',
    // The size must not depend on the position, which CodeMirror computes from it.
    width: 'max-content',
    maxWidth: `min(${rem(44)}, 92vw)`,
    overflow: 'hidden',
    fontFamily: 'var(--playground-font)',
    fontSize: 'var(--playground-type-text)',
  },
  // Low, so that it also fits above the first lines: below, it would cover the following lines.
  '.cm-diagnostic': {
    display: 'flex',
    flexWrap: 'wrap',
    alignItems: 'flex-end',
    gap: 'var(--playground-space-1) var(--playground-space-2)',
    padding: 'var(--playground-space-2) var(--playground-space-4)',
    border: 'none',
    whiteSpace: 'normal',
    marginLeft: '0',
  },
  '.cm-diagnostic > :first-child': { flex: `1 1 ${rem(16)}` },
  '.cm-diagnostic + .cm-diagnostic': { borderTop: '1px solid var(--playground-line)' },
  '.cm-diagnostic p': { margin: '0' },
  '.cm-diagnostic p + p': { marginTop: 'var(--playground-space-1)' },
  '.cm-diagnostic .help-text, .cm-diagnostic .facts': { color: 'var(--playground-muted)' },
  '.cm-diagnostic .facts': { fontSize: 'var(--playground-type-note)' },
  '.cm-diagnosticAction': {
    font: 'inherit',
    fontSize: 'var(--playground-type-note)',
    margin: '0',
    padding: 'var(--playground-space-1) var(--playground-space-2)',
    minBlockSize: 'var(--playground-control-small)',
    borderRadius: 'var(--playground-radius-small)',
    color: 'var(--playground-on-accent)',
    backgroundColor: 'var(--playground-accent)',
  },
  '.cm-panels': {
    backgroundColor: 'var(--playground-panel)',
    color: 'var(--playground-ink)',
    fontFamily: 'var(--playground-font)',
  },
  '.cm-panels.cm-panels-bottom': { borderTop: '1px solid var(--playground-line)' },
  '.cm-panel.cm-search': {
    '--button': 'var(--playground-control-small)',
    padding: 'var(--playground-space-2) var(--playground-space-8) var(--playground-space-2) var(--playground-space-2)',
  },
  '.cm-panel.cm-search label': { fontSize: 'var(--playground-type-note)' },
  '.cm-panel.cm-search [name=close]': {
    fontSize: 'var(--playground-type-title)',
    right: 'var(--playground-space-1)',
    color: 'inherit',
  },
  '.cm-textfield': {
    font: 'inherit',
    color: 'inherit',
    backgroundColor: 'var(--playground-surface)',
    border: '1px solid var(--playground-line-strong)',
    borderRadius: 'var(--playground-radius-small)',
    padding: '0 var(--playground-space-2)',
  },
  '.cm-button': {
    font: 'inherit',
    fontSize: 'var(--playground-type-note)',
    color: 'inherit',
    backgroundImage: 'none',
    backgroundColor: 'var(--playground-surface)',
    border: '1px solid var(--playground-line-strong)',
    borderRadius: 'var(--playground-radius-small)',
  },
  '.cm-searchMatch': { backgroundColor: 'var(--playground-selection)', outline: '1px solid var(--playground-accent)' },
});
