// CodeMirror's texts (search, messages for screen readers) in Chinese and Russian.
//
// In: a language. Out: CodeMirror's table of phrases; English is its default. `Phrase` lists all of them, so a missing
// translation is a type error.

import { EditorState, type Extension } from '@codemirror/state';
import type { Language } from '../dom/language';

type Phrase =
  | 'Find'
  | 'Replace'
  | 'next'
  | 'previous'
  | 'all'
  | 'match case'
  | 'regexp'
  | 'by word'
  | 'replace'
  | 'replace all'
  | 'close'
  | 'current match'
  | 'replaced $ matches'
  | 'replaced match on line $'
  | 'on line'
  | 'Go to line'
  | 'go'
  | 'No diagnostics'
  | 'Diagnostics'
  | 'Control character';

const PHRASES: Readonly<Record<Exclude<Language, 'en'>, Readonly<Record<Phrase, string>>>> = {
  zh: {
    Find: '查找',
    Replace: '替换为',
    next: '下一个',
    previous: '上一个',
    all: '全部',
    'match case': '区分大小写',
    regexp: '正则表达式',
    'by word': '整词',
    replace: '替换',
    'replace all': '全部替换',
    close: '关闭',
    'current match': '当前匹配',
    'replaced $ matches': '已替换 $ 处',
    'replaced match on line $': '已替换第 $ 行的匹配',
    'on line': '在行',
    'Go to line': '转到行',
    go: '转到',
    'No diagnostics': '没有问题',
    Diagnostics: '问题',
    'Control character': '控制字符',
  },
  ru: {
    Find: 'Найти',
    Replace: 'Заменить на',
    next: 'дальше',
    previous: 'назад',
    all: 'все',
    'match case': 'учитывать регистр',
    regexp: 'регулярное выражение',
    'by word': 'слово целиком',
    replace: 'заменить',
    'replace all': 'заменить все',
    close: 'закрыть',
    'current match': 'текущее совпадение',
    'replaced $ matches': 'заменено: $',
    'replaced match on line $': 'заменено в строке $',
    'on line': 'в строке',
    'Go to line': 'Перейти к строке',
    go: 'перейти',
    'No diagnostics': 'Замечаний нет',
    Diagnostics: 'Замечания',
    'Control character': 'Управляющий символ',
  },
};

export function editorPhrases(language: Language): Extension {
  return language === 'en' ? [] : EditorState.phrases.of(PHRASES[language]);
}
