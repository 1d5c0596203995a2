// The page "Parts" of the reference: buttons, fields, icons, a menu, a dialog, and the panels of the element, in each
// language, light and dark.
//
// In: the builders and style sheets of the page and of the element. Out: one sample for each language and theme. Must
// not know: the program.

import { Dialog } from '../dom/dialog';
import { icon, iconNames, make } from '../dom/dom';
import { LANGUAGES, type Language } from '../dom/language';
import { Menu, menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import '../shell/element';
import type { GcodePlayground } from '../shell/element';
import styles from './parts.css?inline';

const THEMES = ['light', 'dark'] as const;
type Theme = (typeof THEMES)[number];

/** A program with an error and a warning. */
const PROGRAM = 'O0001\nG99 S800 M03\nT0101\nG00 X42 Z2\nG01 Z-2O F0.2\nG90 X38 Z-20\nG00 X60 Z20\n';

/** The key row is shown while a phone's keyboard is open; here it is always shown. */
const WITH_KEYS = '.frame .keys.keys { display: flex; }';

function renderSample(language: Language, theme: Theme): HTMLElement {
  const texts = WORDS[language];
  const sample = make(
    'section',
    { className: 'sample', lang: language, 'data-theme': theme, 'aria-label': texts[theme] },
    make('h2', {}, texts[theme]),
    renderButtons(language),
    renderFields(language),
    make('div', { className: 'row icons' }, ...iconNames().map((name) => icon(name))),
    make(
      'div',
      { className: 'row' },
      renderMenu(language, `${language}-${theme}`),
      renderDialog(language, `${language}-${theme}`),
    ),
  );
  const wide = renderElement(language, theme, 'wide');
  const narrow = renderElement(language, theme, 'narrow');
  sample.append(make('div', { className: 'elements' }, wide, narrow));
  return sample;
}

function renderButtons(language: Language): HTMLElement {
  const texts = WORDS[language];
  const kinds = [
    { className: 'primary' },
    { className: 'framed' },
    {},
    { className: 'primary', disabled: true },
    { className: 'framed', 'aria-pressed': 'true' },
  ];
  const buttons = (size: string): HTMLElement[] =>
    kinds.map((kind) => {
      const className = `${size} ${kind.className ?? ''}`.trim();
      return make('button', { type: 'button', ...kind, className }, icon('play'), texts.action);
    });
  const close = make('button', { type: 'button', className: 'close', 'aria-label': COMMON[language].close });
  close.append(icon('whole'));
  const link = make('button', { type: 'button', className: 'link' }, texts.action);
  const row = (...parts: Node[]): HTMLElement => make('div', { className: 'row' }, ...parts);
  return make('div', {}, row(...buttons('')), row(...buttons('small'), close, link, make('kbd', {}, 'Ctrl Enter')));
}

function renderFields(language: Language): HTMLElement {
  const texts = WORDS[language];
  const labelled = (input: HTMLElement): HTMLElement => make('label', { className: 'field' }, texts.field, input);
  return make(
    'div',
    { className: 'row' },
    labelled(make('input', { type: 'text', value: 'X60' })),
    labelled(make('select', {}, make('option', {}, 'FANUC'), make('option', {}, 'GSK'))),
    make('label', { className: 'row' }, make('input', { type: 'checkbox', checked: true }), texts.field),
  );
}

/** The menu is open, and in the flow of the page. */
function renderMenu(language: Language, name: string): HTMLElement {
  const texts = WORDS[language];
  const items = [1, 2].map((n) => menuItem({ textContent: `${texts.action} ${n}` }));
  const { element } = new Menu(name, [], items);
  element.removeAttribute('popover');
  element.setAttribute('aria-label', texts.menu);
  return element;
}

/** The dialog is open, and in the flow of the page. */
function renderDialog(language: Language, name: string): HTMLElement {
  const texts = WORDS[language];
  const dialog = new Dialog(
    `sample-${name}`,
    [make('label', { className: 'field' }, texts.field, make('input', { type: 'text' }))],
    [
      make('button', { type: 'button', className: 'framed' }, texts.other),
      make('button', { type: 'button', className: 'primary' }, texts.action),
    ],
  );
  dialog.setTexts(texts.dialog, COMMON[language].close);
  dialog.about = texts.about;
  dialog.element.setAttribute('open', '');
  return dialog.element;
}

/** The element with its list of problems: beside the picture, or under it in a tab. */
function renderElement(language: Language, theme: Theme, size: 'wide' | 'narrow'): GcodePlayground {
  const element = document.createElement('gcode-playground') as GcodePlayground;
  element.className = size;
  for (const [name, value] of Object.entries({ loading: 'lazy', language, theme })) element.setAttribute(name, value);
  element.append(make('pre', {}, PROGRAM));
  element.addEventListener('gcode-settled', () => showProblems(element), { once: true });
  return element;
}

function showProblems({ shadowRoot }: GcodePlayground): void {
  if (shadowRoot === null) return;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(WITH_KEYS);
  shadowRoot.adoptedStyleSheets = [...shadowRoot.adoptedStyleSheets, sheet];
  shadowRoot.querySelector<HTMLElement>('.problems-toggle')?.click();
  shadowRoot.querySelector<HTMLElement>('#tab-problems')?.click();
}

const WORDS = words({
  en: {
    light: 'English, light',
    dark: 'English, dark',
    action: 'Create',
    other: 'Open file',
    field: 'Diameter of the blank',
    menu: 'Menu',
    dialog: 'New program',
    about: 'The program in the editor is saved.',
  },
  zh: {
    light: '中文，浅色',
    dark: '中文，深色',
    action: '新建',
    other: '打开文件',
    field: '毛坯直径',
    menu: '菜单',
    dialog: '新建程序',
    about: '编辑器中的程序会保存。',
  },
  ru: {
    light: 'Русский, светлая',
    dark: 'Русский, тёмная',
    action: 'Создать',
    other: 'Открыть файл',
    field: 'Диаметр заготовки',
    menu: 'Меню',
    dialog: 'Новая программа',
    about: 'Программа из редактора сохранится.',
  },
});

const sheet = new CSSStyleSheet();
sheet.replaceSync(styles);
document.adoptedStyleSheets.push(sheet);
for (const language of LANGUAGES)
  for (const theme of THEMES) document.querySelector('#main')?.append(renderSample(language, theme));
