// Lists the texts that are missing in Chinese or Russian, one per line; `words` shows them in English. In: the tables
// of texts in `src`. Run by `cargo xtask translations`.
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { parseAst } from 'rollup/parseAst';
import { transformWithEsbuild } from 'vite';

const LANGUAGES = ['zh', 'ru'];
/** Exit code if texts are missing; an error exits with 1. */
const MISSING = 3;
const ROOT = import.meta.dirname;

/** The properties of an object literal, by name. */
function properties(node) {
  const named = node.properties.filter(({ type }) => type === 'Property');
  return new Map(named.map(({ key, value }) => [key.name ?? key.value, value]));
}

/** Paths of the properties that only the English object has. */
export function missing(english, other, path = []) {
  if (other === undefined) return [path.join('.')];
  if (english.type !== 'ObjectExpression' || other.type !== 'ObjectExpression') return [];
  const others = properties(other);
  return [...properties(english)].flatMap(([name, value]) => missing(value, others.get(name), [...path, name]));
}

/** The tables in a script: the arguments of `words({ … })`. */
export function tables(code) {
  const found = [];
  const walk = (node) => {
    if (node === null || typeof node !== 'object') return;
    if (
      node.type === 'CallExpression' &&
      node.callee.name === 'words' &&
      node.arguments[0]?.type === 'ObjectExpression'
    )
      found.push(properties(node.arguments[0]));
    for (const value of Object.values(node)) walk(value);
  };
  walk(parseAst(code));
  return found;
}

let count = 0;
let missingCount = 0;
for (const entry of readdirSync(join(ROOT, 'src'), { recursive: true, withFileTypes: true })) {
  if (!entry.isFile() || !entry.name.endsWith('.ts')) continue;
  const file = join(entry.parentPath, entry.name);
  const { code } = await transformWithEsbuild(readFileSync(file, 'utf8'), file, { sourcemap: false });
  for (const table of tables(code)) {
    const english = table.get('en');
    if (english === undefined) throw new Error(`${file}: a table without English`);
    count++;
    for (const language of LANGUAGES) {
      for (const name of missing(english, table.get(language))) {
        missingCount++;
        console.log(`www/${relative(ROOT, file)}: ${[language, name].filter((part) => part !== '').join('.')}`);
      }
    }
  }
}
// Guards against a parser that finds no tables.
if (count < 40) throw new Error(`only ${count} tables of words were found`);
process.exitCode = missingCount > 0 ? MISSING : 0;
