// The setting whether completion opens while the user types. It is stored in the browser; a failure to store is
// ignored.

const KEY = 'gcode-playground:completes';
let enabled: boolean | undefined;

export function isCompletionEnabled(): boolean {
  enabled ??= stored() !== 'off';
  return enabled;
}

export function setCompletionEnabled(on: boolean): void {
  enabled = on;
  try {
    localStorage.setItem(KEY, on ? 'on' : 'off');
  } catch {
    // The setting is then valid until the page is closed.
  }
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
