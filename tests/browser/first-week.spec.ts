// Ten questions of a student in the first week, written before the help existed. Each is answered on the page in at
// most two actions: a click on the word and one on "At the cursor".
import { expect, test, nightUnless } from './engines';
import { atCursor, chooseLanguage, open, type } from './page';

const SHAFT = [
  'O0001 (SHAFT)',
  'T0101 (ROUGHING)',
  'G50 S2000',
  'G96 S180 M03',
  'G00 X62 Z2',
  'G71 U2 R1',
  'G71 P10 Q20 U0.4 W0.1 F0.25',
  'N10 G00 X30',
  'G01 Z-20 F0.1',
  'X40 Z-40',
  'N20 X62',
  'T0202 (FINISHING)',
  'G70 P10 Q20',
  'G00 X100 Z100',
  'T0303 (THREAD)',
  'G97 S600 M03',
  'G00 X34 Z4',
  'G76 P021060 Q100 R0.05',
  'G76 X27.4 Z-18 P1299 Q400 F2',
  'G00 X100 Z100',
  'M30',
].join('\n');

/** A question, its line (from 1) and word, and the expected parts of the answer. */
interface Asked {
  readonly question: string;
  readonly line: number;
  readonly word: string;
  readonly answer: Readonly<Record<'en' | 'zh' | 'ru', RegExp>>;
}

const QUESTIONS: readonly Asked[] = [
  {
    question: 'What does U do in the second G71 line?',
    line: 7,
    word: 'U0.4',
    answer: { en: /finishing allowance along X, on the diameter/, zh: /U0\.4.*X.*精加工余量/, ru: /U0\.4.*припуск.*X/ },
  },
  {
    question: 'And in the first?',
    line: 6,
    word: 'U2',
    answer: { en: /depth of cut of each pass, on radius/, zh: /U2.*切深/, ru: /U2.*глубина резания за проход/ },
  },
  {
    question: 'Which feed applies here, where no F stands?',
    line: 10,
    word: 'Z-40',
    answer: { en: /Feed rate\s*0\.1 mm\/rev\s*9/, zh: /0\.1 mm\/r\s*9/, ru: /0\.1 мм\/об\s*9/ },
  },
  {
    question: 'Where is N10 that P10 names?',
    line: 13,
    word: 'P10',
    answer: {
      en: /P10.*first block of the contour.*8\s*N10 G00 X30/s,
      zh: /P10.*8\s*N10 G00 X30/s,
      ru: /P10.*8\s*N10 G00 X30/s,
    },
  },
  {
    question: 'How fast does the spindle turn after this move?',
    line: 8,
    word: 'X30',
    answer: {
      en: /1910 rpm, 180 m\/min/,
      zh: /1910 r\/min，180 m\/min|1910 r\/min, 180 m\/min/,
      ru: /1910 об\/мин, 180 м\/мин/,
    },
  },
  {
    question: 'Is X a radius or a diameter?',
    line: 10,
    word: 'X40',
    answer: { en: /X40.*a diameter/, zh: /X40.*直径/, ru: /X40.*диаметр/ },
  },
  {
    question: 'How many passes does G71 make, and how long does it take?',
    line: 7,
    word: 'G71',
    answer: { en: /\d+ passes.*\d s/, zh: /\d+ 次.*\d s/, ru: /проходов \d+.*\d с/ },
  },
  {
    question: 'How much is Q400?',
    line: 19,
    word: 'Q400',
    answer: { en: /0\.4 mm first depth of cut, on radius/, zh: /Q400.*0\.4 mm/, ru: /Q400.*0\.4 мм/ },
  },
  { question: 'Which tool cuts here?', line: 13, word: 'G70', answer: { en: /Tool.*T0202/, zh: /T0202/, ru: /T0202/ } },
  {
    question: 'What is left out of this G76, and what holds instead?',
    line: 19,
    word: 'G76',
    answer: { en: /R taper of the thread.*Without it: 0\./s, zh: /R .*锥/, ru: /R .*конус/ },
  },
];

for (const locale of ['en', 'zh', 'ru'] as const) {
  test(
    `ten questions of the first week are answered in two actions, ${locale}`,
    nightUnless(locale === 'en'),
    async ({ page }) => {
      await open(page);
      await chooseLanguage(page, locale);
      await type(page, SHAFT);
      for (const { line, word, answer } of QUESTIONS) {
        await page
          .locator('.cm-line')
          .nth(line - 1)
          .getByText(word, { exact: true })
          .click();
        // Close it again for the next question.
        await atCursor(page).locator('.at-cursor-toggle').click();
        await expect(atCursor(page)).toContainText(answer[locale]);
        await atCursor(page).locator('.at-cursor-toggle').click();
      }
    },
  );
}
