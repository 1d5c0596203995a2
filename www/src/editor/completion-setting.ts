// Whether completion opens while the user types, stored in the browser.

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
    // It then holds until the page is closed.
  }
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
