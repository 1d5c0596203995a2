// Decides whether the page keeps the picture of an earlier run while a block is being typed.
//
// A block that is being typed is often incomplete, and a faulty contour is not cut at all. Then the previous picture is
// more useful than an empty one: it stays while the new run has more errors and fewer motions, until the user leaves the
// line or changes the picture.
// In: runs, drawn pictures, commands. Out: whether the old picture is shown. Must not know: how a picture is drawn.

import type { Playground } from '../../pkg/gcode_playground.js';
import type { BeginRun, Command } from '../protocol/protocol';

/** The run of a picture, and its counts. */
interface PictureInfo {
  readonly run: number;
  readonly motions: number;
  readonly errors: number;
}

export class OldPicture {
  readonly #core: Playground;
  /** The last picture of a complete path on the page. */
  #lastPicture: PictureInfo | undefined;
  /** The last one that was drawn; the page drops it if another run has started there. */
  #drawn: PictureInfo | undefined;
  /**
   * The line in which the current run was typed; undefined if its text changed otherwise, the cursor has left the line, or
   * the picture was changed.
   */
  #typedLine: number | undefined;
  /** The page shows the picture of an earlier run, while the cursor stays in this line. */
  #shown: { readonly line: number } | undefined;

  constructor(core: Playground) {
    this.#core = core;
  }

  /** Whether the page shows the picture of an earlier run. */
  get isShown(): boolean {
    return this.#shown !== undefined;
  }

  /** A run starts; the core has its text. */
  onRunStarted(change: BeginRun): void {
    this.#typedLine = this.#findTypedLine(change);
    // The last picture may be of another program, if this run is replaced before it is drawn.
    if (this.#typedLine === undefined) this.#lastPicture = this.#drawn = undefined;
  }

  /** The current run is drawn. */
  onDrawn(run: number): void {
    const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
    this.#drawn = { run, motions, errors };
  }

  /** The page has shown or dropped the last pictures. */
  onReceived(isDropped: boolean): void {
    if (isDropped) this.#drawn = undefined;
    else this.#lastPicture = this.#drawn ?? this.#lastPicture;
  }

  /** The path of the run is complete. Returns the run whose picture stays; undefined if the new run is drawn. */
  choose(): number | undefined {
    this.#shown = undefined;
    if (this.#typedLine === undefined || this.#lastPicture === undefined) return undefined;
    const [motions = 0, errors = 0] = this.#core.motionsAndErrors();
    if (motions >= this.#lastPicture.motions || errors <= this.#lastPicture.errors) return undefined;
    this.#shown = { line: this.#typedLine };
    return this.#lastPicture.run;
  }

  drop(): void {
    this.#shown = undefined;
  }

  /** A command was executed. Returns what becomes of the old picture; undefined if there is none. */
  onCommand(command: Command): 'kept' | 'dropped' | undefined {
    // The last picture does not show this change, and the next run may start before it is drawn again.
    if (this.#changesPicture(command)) this.#lastPicture = this.#drawn = undefined;
    // The user may leave the line or change the picture while its run is in progress.
    if (this.#typedLine !== undefined && !this.#isKept(command, this.#typedLine)) this.#typedLine = undefined;
    if (this.#shown === undefined) return undefined;
    if (this.#isKept(command, this.#shown.line)) return 'kept';
    this.drop();
    return 'dropped';
  }

  #isKept(command: Command, line: number): boolean {
    if (command.kind === 'cursor') return command.offset !== undefined && this.#core.lineAt(command.offset) === line;
    return !this.#changesPicture(command);
  }

  #changesPicture(command: Command): boolean {
    switch (command.kind) {
      case 'picture':
        // A resize is not a move by the user: the messages of a new run can cause it.
        return command.command.kind !== 'resize' && command.command.kind !== 'repaint';
      case 'cursor':
      case 'run':
      case 'shown':
      case 'hover':
      case 'leave-edge':
      case 'load-parts':
      case 'stop':
        return false;
      case 'palette':
      case 'language':
      case 'unit':
      case 'turret':
      case 'annotate':
      case 'measuring':
      case 'mark':
      case 'frame':
      case 'keep-part':
      case 'end-comparison':
        return true;
    }
  }

  /** The line that the user is typing in, if the run has a single typed change in the line of the cursor. */
  #findTypedLine({ setup, text, changeSource, framing, cursor }: BeginRun): number | undefined {
    if (
      setup !== undefined ||
      text?.kind !== 'edit' ||
      text.changes.length !== 1 ||
      changeSource !== 'typed' ||
      framing === 'fit' ||
      cursor === undefined
    )
      return undefined;
    const [change] = text.changes;
    const line = this.#core.lineAt(cursor);
    return change !== undefined && this.#core.lineAt(change.from) === line ? line : undefined;
  }
}
