// Whether words are proposed while the reader types. The reader's choice is kept in the browser; one that refuses to store
// is no error.

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
    // It holds until the page is left.
  }
}

function kept(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
