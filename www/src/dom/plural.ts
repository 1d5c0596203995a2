// Numbers with the form of the word that they ask for.
//
// In: a language and the forms of a word. Out: a function from a number to its text.

type Forms = Partial<Record<Intl.LDMLPluralRule, string>> & { readonly other: string };

interface Writing {
  readonly rules: Intl.PluralRules;
  readonly numbers: Intl.NumberFormat;
}

/** By language. They take browsers some milliseconds each, and most readers see one language: made when a number is written. */
const writings = new Map<string, Writing>();

function writingOf(language: string): Writing {
  const known = writings.get(language);
  if (known !== undefined) return known;
  const made = { rules: new Intl.PluralRules(language), numbers: new Intl.NumberFormat(language) };
  writings.set(language, made);
  return made;
}

/** "42 motions": the number in the language's own writing, then the form that number asks for. */
export function counter(language: string, forms: Forms): (n: number) => string {
  return (n) => {
    const { rules, numbers } = writingOf(language);
    return `${numbers.format(n)} ${forms[rules.select(n)] ?? forms.other}`;
  };
}
