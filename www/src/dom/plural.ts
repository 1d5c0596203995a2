// Numbers with the plural form of a noun.
//
// In: a language and the forms of a noun. Out: a function from a number to its text.

type Forms = Partial<Record<Intl.LDMLPluralRule, string>> & { readonly other: string };

interface Formatters {
  readonly rules: Intl.PluralRules;
  readonly numbers: Intl.NumberFormat;
}

/**
 * Formatters by language. Each takes some milliseconds to create, and most users see one language, so they are created
 * on first use.
 */
const formatters = new Map<string, Formatters>();

function formattersOf(language: string): Formatters {
  const cached = formatters.get(language);
  if (cached !== undefined) return cached;
  const created = { rules: new Intl.PluralRules(language), numbers: new Intl.NumberFormat(language) };
  formatters.set(language, created);
  return created;
}

/** "42 motions": the number in the format of the language, then the plural form. */
export function counter(language: string, forms: Forms): (n: number) => string {
  return (n) => {
    const { rules, numbers } = formattersOf(language);
    return `${numbers.format(n)} ${forms[rules.select(n)] ?? forms.other}`;
  };
}
