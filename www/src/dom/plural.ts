// Numbers with the form of the word that they ask for.
//
// In: a language and the forms of a word. Out: a function from a number to its text.

type Forms = Partial<Record<Intl.LDMLPluralRule, string>> & { readonly other: string };

/** "42 motions": the number in the language's own writing, then the form that number asks for. */
export function counter(language: string, forms: Forms): (n: number) => string {
  const rules = new Intl.PluralRules(language);
  const numbers = new Intl.NumberFormat(language);
  return (n) => `${numbers.format(n)} ${forms[rules.select(n)] ?? forms.other}`;
}
