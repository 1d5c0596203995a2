// The texts of the extension, in three languages. The texts of `package.json` are in `package.nls.json` and beside it.

import { language } from './settings';

interface Words {
  readonly fixAll: string;
  /** The checker without the native program. */
  readonly ownChecker: string;
  readonly notServer: (program: string) => string;
  readonly pictureOf: (file: string) => string;
}

const WORDS: Readonly<Record<ReturnType<typeof language>, Words>> = {
  en: {
    fixAll: 'Fix all safe problems',
    ownChecker: 'Checked by the extension',
    notServer: (program) => `${program} does not start as a language server. The extension checks programs itself.`,
    pictureOf: (file) => `Picture of ${file}`,
  },
  zh: {
    fixAll: '修复所有可安全修复的问题',
    ownChecker: '由扩展检查',
    notServer: (program) => `${program} 无法作为语言服务器启动。由扩展自己检查程序。`,
    pictureOf: (file) => `${file} 的图形`,
  },
  ru: {
    fixAll: 'Исправить всё, что можно исправить безопасно',
    ownChecker: 'Проверяет расширение',
    notServer: (program) => `${program} не запускается как языковой сервер. Расширение проверяет программы само.`,
    pictureOf: (file) => `Чертёж: ${file}`,
  },
};

export function words(): Words {
  return WORDS[language()];
}
