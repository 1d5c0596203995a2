// Numbers with the plural form of a noun.
//
// In: a language and the forms of a noun. Out: a function from a number to its text.

type Forms = Partial<Record<Intl.LDMLPluralRule, string>> & { readonly other: string };

interface Writing {
  readonly rules: Intl.PluralRules;
  readonly numbers: Intl.NumberFormat;
}

/**
 * Formatters by language. Each takes some milliseconds to create, and most users see one language, so they are created
 * on first use.
 */
const writings = new Map<string, Writing>();

function writingOf(language: string): Writing {
  const known = writings.get(language);
  if (known !== undefined) return known;
  const made = { rules: new Intl.PluralRules(language), numbers: new Intl.NumberFormat(language) };
  writings.set(language, made);
  return made;
}

/** "42 motions": the number in the format of the language, then the plural form. */
export function counter(language: string, forms: Forms): (n: number) => string {
  return (n) => {
    const { rules, numbers } = writingOf(language);
    return `${numbers.format(n)} ${forms[rules.select(n)] ?? forms.other}`;
  };
}
