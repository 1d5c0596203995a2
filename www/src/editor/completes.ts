// The setting whether completion opens while the user types. It is stored in the browser; a failure to store is
// ignored.

const KEY = 'gcode-playground:completes';
let chosen: boolean | undefined;

export function completes(): boolean {
  chosen ??= kept() !== 'off';
  return chosen;
}

export function setCompletes(on: boolean): void {
  chosen = on;
  try {
    localStorage.setItem(KEY, on ? 'on' : 'off');
  } catch {
    // The setting is then valid until the page is closed.
  }
}

function kept(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
