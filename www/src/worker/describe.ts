// The text of an error.
//
// In: anything that was thrown. Out: its text. Must not know: where it is shown.

export function describe(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
