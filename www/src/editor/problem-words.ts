// Labels of a problem, in the editor and in the list below it.

import { words } from '../dom/words';

export const PROBLEM_WORDS = words({
  en: {
    severity: { error: 'Error', warning: 'Warning', info: 'Note' },
    kind: { wrong: '', unsupported: 'not supported here', machine: 'depends on the machine' },
    alarm: (number: string) => `alarm ${number}`,
  },
  zh: {
    severity: { error: '错误', warning: '警告', info: '提示' },
    kind: { wrong: '', unsupported: '此处不支持', machine: '取决于机床' },
    alarm: (number) => `报警 ${number}`,
  },
  ru: {
    severity: { error: 'Ошибка', warning: 'Предупреждение', info: 'Примечание' },
    kind: { wrong: '', unsupported: 'здесь не поддерживается', machine: 'зависит от станка' },
    alarm: (number) => `сигнал ${number}`,
  },
});
