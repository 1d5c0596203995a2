// Where the programs of an engine are: what the environment names (`cargo xtask test` does),
// else Debian's usual places.
import { existsSync, readdirSync } from 'node:fs';

const PLACES = {
  PLAYGROUND_FIREFOX: () => ['/usr/bin/firefox-esr', '/usr/bin/firefox'],
  PLAYGROUND_WEBKIT_DRIVER: () => ['/usr/bin/WebKitWebDriver'],
  PLAYGROUND_MINIBROWSER: () =>
    ['4.1', '6.0', '4.0'].flatMap((version) =>
      readdirSync('/usr/lib').flatMap((folder) => [
        `/usr/lib/${folder}/webkit2gtk-${version}/MiniBrowser`,
        `/usr/lib/${folder}/webkitgtk-${version}/MiniBrowser`,
      ]),
    ),
  PLAYGROUND_XVFB: () => ['/usr/bin/Xvfb'],
  PLAYGROUND_XWD: () => ['/usr/bin/xwd'],
};

/** The path of a program; when it is missing, an error that says what to do. */
export function program(variable: keyof typeof PLACES): string {
  const named = process.env[variable];
  if (named !== undefined && named !== '') return named;
  const found = PLACES[variable]().find((path) => existsSync(path));
  if (found === undefined)
    throw new Error(
      `${variable} is not set, and its program is in no usual place: \`cargo xtask setup\` installs it on Debian`,
    );
  return found;
}
