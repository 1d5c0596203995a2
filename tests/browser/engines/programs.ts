// Paths of an engine's programs: from environment variables (`cargo xtask test` sets them), otherwise Debian's usual
// paths.
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

/** Path of a program. If it is missing, throws an error that explains what to install. */
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
