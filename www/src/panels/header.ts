// The row at the top: the menus "Program", "Share", "Help" and "More", undo and redo.
//
// In: the items of the menus, which other panels and the host page (slots) provide. Out: undo and redo of the editor.
// Must not know: the effect of an item.

import { icon, make, setAccessibleName } from '../dom/dom';
import type { Language } from '../dom/language';
import { Menu, menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import type { CoreEvent } from '../worker/core-client';
import headerStyles from './header.css?inline';
import type { Panel, PanelKind, Shell, UserCommand } from './panel';

export const header: PanelKind = { styles: headerStyles, make: (shell) => new Header(shell) };

/** Below this width the row is narrow; the style sheet has the same. */
const NARROW_REM = 30;

const MENUS = ['program', 'share', 'help', 'more'] as const;
type MenuName = (typeof MENUS)[number];

class Header implements Panel {
  readonly #shell: Shell;
  readonly #title = make('span', { className: 'label' });
  readonly #labels = { share: make('span', { className: 'label' }), help: make('span', { className: 'label' }) };
  readonly #menus: Readonly<Record<MenuName, Menu>>;
  readonly #undo = make('button', { type: 'button', className: 'undo', disabled: true }, icon('undo'));
  readonly #redo = make('button', { type: 'button', className: 'redo', disabled: true }, icon('redo'));
  readonly #redoItem = menuItem({ className: 'redo-item', hidden: true });
  readonly #helpItem = menuItem({ className: 'help-item', 'aria-haspopup': 'menu', hidden: true });
  #isNarrow = false;
  readonly elements: Panel['elements'];

  constructor(shell: Shell) {
    this.#shell = shell;
    const menu = (name: MenuName, button: readonly Node[]): Menu =>
      new Menu(name, button, [make('slot', { name: `${name}-menu` }), shell.region(`${name}-menu`)]);
    this.#menus = {
      program: menu('program', [make('slot', { name: 'title' }, this.#title), icon('chevron')]),
      share: menu('share', [icon('share'), this.#labels.share]),
      help: menu('help', [icon('help'), this.#labels.help]),
      more: menu('more', [icon('more')]),
    };
    const { program, share, help, more } = this.#menus;
    this.#undo.addEventListener('click', () => this.#travel('undo'));
    this.#redo.addEventListener('click', () => this.#travel('redo'));
    this.#undo.hidden = this.#redo.hidden = shell.readonly;
    // A narrow row has no button for help and redo: they are in the menu "More".
    this.#redoItem.addEventListener('click', () => this.#travel('redo'));
    this.#helpItem.addEventListener('click', () => help.openAt(more.button));
    more.element.prepend(this.#helpItem, this.#redoItem);
    new ResizeObserver(([entry]) => {
      // Without a row there is no width.
      if (entry === undefined || entry.contentRect.width === 0) return;
      this.#isNarrow = entry.contentRect.width < NARROW_REM * remOf(this.#undo);
      this.#redoItem.hidden = !this.#isNarrow || shell.readonly;
      this.#hideEmptyMenus();
    }).observe(shell.region('head'));
    this.elements = {
      bar: [make('slot', { name: 'about' })],
      head: [
        program.button,
        this.#undo,
        this.#redo,
        make('span', { className: 'space' }),
        share.button,
        help.button,
        more.button,
      ],
      dialogs: MENUS.map((name) => this.#menus[name].element),
    };
  }

  get commands(): readonly UserCommand[] {
    const texts = WORDS[this.#shell.language];
    // An item that opens another menu is not an action.
    const items = MENUS.flatMap((name) => this.#menus[name].choices).filter(
      (item) => item !== this.#redoItem && item.getAttribute('aria-haspopup') !== 'menu',
    );
    return [
      { name: texts.undo, keys: 'Ctrl Z', run: () => this.#travel('undo') },
      { name: texts.redo, keys: 'Ctrl Y', run: () => this.#travel('redo') },
      ...items.map((item) => ({ name: nameOf(item), run: () => item.click() })),
    ];
  }

  set language(language: Language) {
    const texts = WORDS[language];
    this.onFileChanged();
    for (const name of MENUS) this.#menus[name].label = name === 'program' ? COMMON[language].program : texts[name];
    this.#labels.share.textContent = texts.share;
    this.#labels.help.textContent = texts.help;
    this.#redoItem.textContent = texts.redo;
    this.#helpItem.textContent = texts.help;
    for (const name of ['share', 'help', 'more'] as const) setAccessibleName(this.#menus[name].button, texts[name]);
    setAccessibleName(this.#undo, `${texts.undo} (Ctrl Z)`);
    setAccessibleName(this.#redo, `${texts.redo} (Ctrl Y)`);
    this.#hideEmptyMenus();
  }

  /** A menu without an item besides redo has no button. Other panels, whose items are in the menus, must exist. */
  #hideEmptyMenus(): void {
    for (const { button, element } of Object.values(this.#menus)) {
      const item = element.querySelector('[role^=menuitem]:not([hidden], .redo-item)');
      button.hidden = item === null && !hasSlotted(element);
      // The menu "More" is the last one.
      if (element === this.#menus.help.element) this.#helpItem.hidden = !this.#isNarrow || button.hidden;
    }
  }

  onFileChanged(): void {
    this.#title.textContent = this.#shell.editor.file?.name ?? COMMON[this.#shell.language].program;
  }

  onInputChanged(): void {
    this.#showHistory();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'report') this.#showHistory();
  }

  onProgramReplaced(): void {
    this.#showHistory();
  }

  #travel(direction: 'undo' | 'redo'): void {
    this.#shell.editor.travel(direction);
    this.#showHistory();
  }

  #showHistory(): void {
    const { canUndo, canRedo } = this.#shell.editor.history;
    this.#undo.disabled = !canUndo;
    this.#redo.disabled = this.#redoItem.disabled = !canRedo;
  }
}

/** The name of an item outside of its menu: "Theme: Dark". */
function nameOf(item: HTMLElement): string {
  const group = item.parentElement?.matches('[role=group]') === true ? item.parentElement.ariaLabel : null;
  const text = item.textContent?.trim() ?? '';
  return group === null ? text : `${group}: ${text}`;
}

function remOf(element: HTMLElement): number {
  return Number.parseFloat(getComputedStyle(element).fontSize) / 0.9375;
}

function hasSlotted(element: HTMLElement): boolean {
  return [...element.querySelectorAll('slot')].some((slot) => slot.assignedElements().length > 0);
}

const WORDS = words({
  en: { share: 'Share', help: 'Help', more: 'More', undo: 'Undo', redo: 'Redo' },
  zh: { share: '分享', help: '帮助', more: '更多', undo: '撤销', redo: '重做' },
  ru: { share: 'Поделиться', help: 'Справка', more: 'Ещё', undo: 'Отменить', redo: 'Вернуть' },
});
