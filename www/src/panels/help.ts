// The menu "Help": the pages of the manual, the dialog with keys and gestures, the table of codes, the pages of the rules and the
// reference.
//
// Must not know: which part handles a key.

import { Dialog } from '../dom/dialog';
import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { menuItem } from '../dom/menu';
import { COMMON, words } from '../dom/words';
import { allRulesLink, manualLink, referenceLink } from '../editor/rule-link';
import type { Key, Panel, PanelKind, Shell } from './panel';
import helpStyles from './help.css?inline';

export const help: PanelKind = { control: 'help', styles: helpStyles, make: (shell) => new Help(shell) };

class Help implements Panel {
  readonly #keys = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #codes = menuItem({ 'aria-haspopup': 'dialog' });
  readonly #manual = make('div', { className: 'region' });
  /** The pages of the rules and of the reference. */
  readonly #links = make('div', { className: 'region' });
  readonly #list = make('dl');
  readonly #dialog = new Dialog('help', [this.#list]);
  readonly elements = {
    'help-menu': [this.#manual, this.#keys, this.#codes, this.#links],
    dialogs: [this.#dialog.element],
  };

  constructor(shell: Shell) {
    // Its list may scroll, and contains nothing else to focus.
    this.#dialog.body.tabIndex = 0;
    this.#keys.addEventListener('click', () => this.#dialog.show());
    this.#dialog.element.addEventListener('keydown', (event) => {
      if (event.key === '?') this.#dialog.close();
    });
    this.#codes.addEventListener('click', () => shell.service('openCodes')());
  }

  set language(language: Language) {
    const strings = WORDS[language];
    this.#keys.textContent = strings.helpTitle;
    this.#codes.textContent = strings.codes;
    const manual = manualLink(language);
    const links = [allRulesLink(language), referenceLink(language)];
    for (const link of [manual, ...links]) {
      link.setAttribute('role', 'menuitem');
      link.tabIndex = -1;
    }
    this.#manual.replaceChildren(manual);
    this.#links.replaceChildren(...links);
    this.#dialog.setTexts(strings.helpTitle, COMMON[language].close);
    this.#list.replaceChildren();
    for (const [combinations, action] of strings.shortcuts) {
      const term = make('dt');
      for (const [i, key] of combinations.split('  ').entries()) term.append(i > 0 ? ' ' : '', make('kbd', {}, key));
      this.#list.append(term, make('dd', {}, action));
    }
  }

  get capturesKeys(): boolean {
    return this.#dialog.open;
  }

  onKey({ event, inside }: Key): 'handled' | 'ignored' {
    if (event.key !== '?' || inside !== 'elsewhere') return 'ignored';
    this.#dialog.show();
    return 'handled';
  }
}

const WORDS = words({
  en: {
    helpTitle: 'Keys and gestures',
    codes: 'Supported codes',
    shortcuts: [
      ['Ctrl Enter', 'play or pause'],
      ['Ctrl Shift Enter', 'start at the block at the cursor'],
      ['F10  Ctrl F10', 'play the block at the cursor; play on to it'],
      ['Ctrl F8', 'stop before the line of the cursor, or no longer (a click on its number)'],
      ['F9  Shift F9', 'next or previous motion'],
      ['Ctrl F9  Ctrl Shift F9', 'next or previous block'],
      ['Alt F9  Alt Shift F9', 'next or previous pass of a cycle'],
      ['F1', 'meaning of the word at the cursor, and the codes in force there'],
      ['Ctrl Space', 'what can be written at the cursor; Tab takes the first'],
      ['F12  Shift F12', 'from P10 to N10, to a program, to the next place of a variable; and back'],
      ['Ctrl Shift O', 'outline of the program'],
      ['Ctrl Shift [  Ctrl Shift ]', 'fold or unfold the program, tool, contour or loop'],
      ['F8  Shift F8', 'next or previous problem'],
      ['Ctrl F', 'search in the program'],
      ['Alt Enter', 'write the moves at the cursor as a cycle'],
      ['Ctrl S', 'save the program as a file'],
      ['Ctrl Z  Ctrl Y', 'undo, redo'],
      ['Tab', 'leave the editor'],
      ['Arrow keys', 'move the drawing (when it has the focus)'],
      ['+  −  F', 'zoom in, zoom out, show all'],
      ['Drag, wheel, pinch', 'move and zoom the drawing'],
      ['Click on a stroke', 'select the block that made it'],
    ] satisfies readonly (readonly [keys: string, what: string])[],
  },
  zh: {
    helpTitle: '按键与手势',
    codes: '支持的代码',
    shortcuts: [
      ['Ctrl Enter', '播放或暂停'],
      ['Ctrl Shift Enter', '从光标所在程序段开始'],
      ['F10  Ctrl F10', '播放光标处的程序段；播放到该段'],
      ['Ctrl F8', '在光标所在行之前停下，或取消（也可单击行号）'],
      ['F9  Shift F9', '下一段或上一段运动'],
      ['Ctrl F9  Ctrl Shift F9', '下一或上一程序段'],
      ['Alt F9  Alt Shift F9', '循环的下一次或上一次走刀'],
      ['F1', '光标处的字的含义，以及此处有效的指令'],
      ['Ctrl 空格', '光标处可以写什么；Tab 取第一个'],
      ['F12  Shift F12', '从 P10 转到 N10、转到程序、转到变量的下一处；以及返回'],
      ['Ctrl Shift O', '程序大纲'],
      ['Ctrl Shift [  Ctrl Shift ]', '折叠或展开程序、刀具、轮廓或循环'],
      ['F8  Shift F8', '下一个或上一个问题'],
      ['Ctrl F', '在程序中查找'],
      ['Alt Enter', '将光标处的移动写成循环'],
      ['Ctrl S', '将程序保存为文件'],
      ['Ctrl Z  Ctrl Y', '撤销、重做'],
      ['Tab', '离开编辑器'],
      ['方向键', '移动图形（图形获得焦点时）'],
      ['+  −  F', '放大、缩小、显示全图'],
      ['拖动、滚轮、双指', '移动和缩放图形'],
      ['单击线条', '选中生成它的程序段'],
    ],
  },
  ru: {
    helpTitle: 'Клавиши и жесты',
    codes: 'Поддерживаемые коды',
    shortcuts: [
      ['Ctrl Enter', 'пуск или пауза'],
      ['Ctrl Shift Enter', 'начать с кадра у курсора'],
      ['F10  Ctrl F10', 'показать кадр у курсора; показ до него'],
      ['Ctrl F8', 'пауза перед строкой курсора или её отмена (щелчок по номеру строки)'],
      ['F9  Shift F9', 'следующее или предыдущее перемещение'],
      ['Ctrl F9  Ctrl Shift F9', 'следующий или предыдущий кадр'],
      ['Alt F9  Alt Shift F9', 'следующий или предыдущий проход цикла'],
      ['F1', 'значение слова у курсора и действующие здесь коды'],
      ['Ctrl Пробел', 'что можно написать у курсора; Tab берёт первое'],
      ['F12  Shift F12', 'от P10 к N10, к программе, к следующему месту переменной; и обратно'],
      ['Ctrl Shift O', 'структура программы'],
      ['Ctrl Shift [  Ctrl Shift ]', 'свернуть или развернуть программу, инструмент, контур или цикл'],
      ['F8  Shift F8', 'следующее или предыдущее замечание'],
      ['Ctrl F', 'поиск в программе'],
      ['Alt Enter', 'записать перемещения у курсора циклом'],
      ['Ctrl S', 'сохранить программу в файл'],
      ['Ctrl Z  Ctrl Y', 'отменить, вернуть'],
      ['Tab', 'выйти из редактора'],
      ['Стрелки', 'сдвинуть чертёж (когда он в фокусе)'],
      ['+  −  F', 'крупнее, мельче, показать всё'],
      ['Мышь, колесо, два пальца', 'сдвиг и масштаб чертежа'],
      ['Щелчок по линии', 'выделить её кадр'],
    ],
  },
});
