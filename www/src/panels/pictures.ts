// The pictures: the section and, beside it, the end face and the side. The buttons to fit and zoom are in the row over
// the drawing or, in an element without the program, in the playback row.
//
// In: images, strokes and dimensions, as the worker answers. Out: the view of each picture, and the stroke that the
// user chooses. Must not know: how a stroke is found, or its meaning.

import { make } from '../dom/dom';
import type { Language } from '../dom/language';
import { words } from '../dom/words';
import {
  PICTURES,
  type CanvasCommand,
  type Command,
  type Help,
  type LengthUnit,
  type PictureName,
  type Pictures as Images,
  type Report,
  type SectionScale,
  type Stroke,
} from '../protocol/protocol';
import type { CoreEvent } from '../worker/core-client';
import { dimensionText } from './dimension';
import { Drawing, type DrawingEvents } from './drawing';
import { formatLength } from './lengths';
import { PointerPlace } from './pointer-place';
import type { ClientPoint, NewestQuestion, Panel, PanelKind, Services, Shell } from './panel';
import picturesStyles from './pictures.css?inline';

/** The pointer must rest for this time, ms, before the page asks what its block does. */
const EXPLAIN_AFTER_MS = 150;

export const pictures: PanelKind = { styles: picturesStyles, make: (shell) => new Pictures(shell) };

class Pictures implements Panel {
  readonly #shell: Shell;
  readonly #drawings: Readonly<Record<PictureName, Drawing>>;
  readonly elements: Panel['elements'];
  readonly services: Partial<Services> = {
    showOnly: (pictures) => {
      for (const picture of PICTURES) this.#drawings[picture].element.hidden = !pictures.includes(picture);
      this.#shell.region('pictures').classList.toggle('three', pictures.length === 3);
    },
    locate: (picture, ...place) => this.#locate(picture, place),
  };
  /** A note over a picture of an earlier run. */
  readonly #oldNote = make('p', { className: 'old-picture', part: 'old-picture', hidden: true });
  readonly #place = new PointerPlace();
  /** The report of the newest run, until its picture arrives. */
  #pendingReport: Report | undefined;
  /** The run of the old picture. */
  #oldRun: number | undefined;
  /** How the picture relates to the newest run; `old`: that run has failed. */
  #pictureState: 'none' | 'current' | 'outdated' | 'old' = 'none';
  #unit: LengthUnit = 'mm';
  /** The palette that the worker paints with, as text. */
  #sentPalette = '';
  /** The motion under the pointer. */
  #hovered: number | undefined;
  /** Asks what the block of that motion does, once the pointer rests on it. */
  readonly #explanation: NewestQuestion<'help'>;
  #explainTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(shell: Shell) {
    this.#shell = shell;
    this.#explanation = shell.newest('help', (help) => this.#showExplanation(help));
    const edge = shell.newest('dimension', (edge) =>
      section.showEdge(edge === undefined ? undefined : dimensionText(shell.language, edge, this.#unit)),
    );
    const onSection = this.#events('section');
    const section = new Drawing(shell.language, {
      ...onSection,
      onPoint(x, y) {
        onSection.onPoint(x, y);
        edge.ask({ x, y });
      },
      onMouse: (x, y) => {
        this.#place.pointer = [x, y];
      },
      onLeave: () => {
        this.#place.pointer = undefined;
        edge.cancel();
        shell.send({ kind: 'leave-edge' });
        section.showEdge(undefined);
        onSection.onLeave();
      },
      companions: () => [face, side],
      onColoursChanged: () => this.onColoursChanged(),
    });
    const face = new Drawing(shell.language, this.#events('face'));
    const side = new Drawing(shell.language, this.#events('side'));
    this.#drawings = { section, face, side };
    face.element.hidden = side.element.hidden = true;
    for (const picture of PICTURES) this.#drawings[picture].element.style.setProperty('--picture', picture);
    section.element.append(this.#oldNote, this.#place.element);
    this.elements = {
      [shell.showsProgram ? 'views' : 'playback']: [section.viewButtons],
      pictures: [section.element, face.element, side.element, section.legend],
    };
  }

  set language(language: Language) {
    const texts = WORDS[language];
    for (const picture of PICTURES) this.#drawings[picture].setLanguage(language, texts[picture]);
    this.#place.setUnit(this.#unit, language);
    this.#showOldNote();
  }

  onEvent(event: CoreEvent): void {
    if (event.kind === 'old-picture') this.#setOldRun(event.of);
    // The text beside a picture belongs to the run of that picture.
    if (this.#oldRun !== undefined) {
      if (event.kind === 'report') this.#pendingReport = event.report;
      return;
    }
    if (event.kind === 'path') this.#drawings.section.summary = event.summary;
    if (event.kind === 'report') this.#showReport(event.report);
  }

  /** Shows the texts of a run beside its picture. */
  #showReport({ summary, views, units, overview }: Report): void {
    if (views !== undefined) this.#drawings.section.work = views.work;
    this.#drawings.section.summary = summary;
    this.#unit = units.shown;
    this.#place.setUnit(this.#unit, this.#shell.language);
    const [x, z] = overview.start ?? [];
    this.#drawings.section.start =
      x === undefined || z === undefined ? '' : `X${formatLength(x, this.#unit)} Z${formatLength(z, this.#unit)}`;
    for (const drawing of Object.values(this.#drawings)) drawing.repeatHitTest();
  }

  onPictures(images: Images, scale: SectionScale): void {
    if (this.#oldRun !== undefined) {
      const report = this.#pendingReport;
      this.#setOldRun(undefined);
      if (report !== undefined) this.#showReport(report);
    }
    this.#pictureState = 'current';
    this.#showOldNote();
    this.#place.scale = scale;
    for (const picture of PICTURES) {
      const image = images[picture];
      if (image !== undefined) this.#drawings[picture].show(image);
    }
  }

  #setOldRun(run: number | undefined): void {
    this.#oldRun = run;
    this.#pendingReport = undefined;
    this.#showOldNote();
  }

  #showOldNote(): void {
    const run = this.#oldRun;
    const texts = WORDS[this.#shell.language];
    const text = run !== undefined ? texts.old(run) : this.#pictureState === 'old' ? texts.notRun : '';
    this.#oldNote.hidden = text === '';
    this.#oldNote.textContent = text;
    // An old picture may be stretched.
    if (text !== '') this.#place.scale = undefined;
    for (const { element } of Object.values(this.#drawings)) element.classList.toggle('is-old', text !== '');
  }

  onColoursChanged(): void {
    // A print has light colours immediately, and a newly painted picture would come too late: the style sheet inverts
    // the current one.
    if (matchMedia('print').matches) return;
    const { palette } = this.#drawings.section;
    const colours = JSON.stringify(palette);
    if (colours === this.#sentPalette) return;
    this.#sentPalette = colours;
    this.#shell.send({ kind: 'palette', palette });
  }

  /** A run of another program fits the pictures. */
  onProgramReplaced(): void {
    for (const picture of PICTURES) this.#setMoved(picture, false);
  }

  onWorkerConnected(send: (command: Command) => void): void {
    this.onProgramReplaced();
    for (const picture of PICTURES) {
      send({ kind: 'picture', picture, command: { kind: 'canvas', size: this.#drawings[picture].size } });
    }
    const { palette } = this.#drawings.section;
    this.#sentPalette = JSON.stringify(palette);
    send({ kind: 'palette', palette });
  }

  onInputChanged(): void {
    for (const drawing of Object.values(this.#drawings)) {
      drawing.showTip(undefined);
      drawing.showEdge(undefined);
    }
    clearTimeout(this.#explainTimer);
    this.#explanation.cancel();
    if (this.#pictureState === 'current') this.#pictureState = 'outdated';
    if (this.#hovered === undefined) return;
    this.#hovered = undefined;
    this.#shell.editor.hovered = undefined;
  }

  onRunFailed(): void {
    if (this.#pictureState === 'outdated') this.#pictureState = 'old';
    this.#showOldNote();
  }

  onWorkerLost(): void {
    this.#setOldRun(undefined);
    this.#drawings.section.summary = undefined;
    this.#drawings.section.showTip(undefined);
  }

  /** The events of each picture; all pictures use the same functions. */
  #events(picture: PictureName): DrawingEvents {
    const shell = this.#shell;
    const stroke = shell.newest('pick', (stroke) => this.#showHovered(picture, stroke));
    const sendView = (command: CanvasCommand): void => shell.send({ kind: 'picture', picture, command });
    return {
      onResize: (size) => sendView({ kind: 'resize', size }),
      requestPicture: () => sendView({ kind: 'repaint' }),
      fit: () => {
        this.#setMoved(picture, false);
        sendView({ kind: 'fit' });
      },
      pan: (dx, dy) => {
        this.#setMoved(picture, true);
        sendView({ kind: 'pan', dx, dy });
      },
      zoom: (factor, x, y) => {
        this.#setMoved(picture, true);
        sendView({ kind: 'zoom', factor, x, y });
      },
      onPoint: (x, y) => stroke.ask({ picture, x, y }),
      onLeave: () => {
        stroke.cancel();
        this.#showHovered(picture, undefined);
      },
      onClick: async (x, y, keepFocus) => {
        if (picture === 'section' && this.#isTaken(x, y)) {
          // The tooltip would cover the next place.
          stroke.cancel();
          this.#showHovered(picture, undefined);
          return;
        }
        const chosen = await shell.ask('pick', { picture, x, y });
        if (chosen !== undefined) shell.chooseStroke(chosen, keepFocus ? 'keep-focus' : 'focus');
      },
    };
  }

  /** Whether a click in the section measures, or answers an exercise. */
  #isTaken(x: number, y: number): boolean {
    const shell = this.#shell;
    if (shell.hasService('measureAt') && shell.service('measureAt')(x, y)) return true;
    const place = this.#place.roundedAt(x, y);
    return place !== undefined && shell.hasService('answerAt') && shell.service('answerAt')(place);
  }

  /** Whether the user has moved or zoomed a picture since it was fitted. */
  #setMoved(picture: PictureName, isMoved: boolean): void {
    this.#drawings[picture].element.classList.toggle('is-moved', isMoved);
  }

  #showHovered(picture: PictureName, stroke: Stroke | undefined): void {
    this.#drawings[picture].showTip(stroke);
    if (stroke?.motion === this.#hovered) return;
    this.#hovered = stroke?.motion;
    this.#shell.send({ kind: 'hover', motion: stroke?.motion });
    this.#shell.editor.hovered = stroke;
    clearTimeout(this.#explainTimer);
    if (stroke !== undefined)
      this.#explainTimer = setTimeout(
        () => this.#explanation.ask({ by: 'drawing', about: 'motion', motion: stroke.motion }),
        EXPLAIN_AFTER_MS,
      );
  }

  #showExplanation(help: Help | undefined): void {
    if (help?.request.about !== 'motion' || help.request.motion !== this.#hovered) return;
    for (const drawing of Object.values(this.#drawings)) drawing.explain(help.request.motion, help.explanation ?? '');
  }

  /** Converts a place of a picture to CSS pixels of the window. */
  async #locate(picture: PictureName, of: readonly [number, number]): Promise<ClientPoint> {
    const place = await this.#shell.ask('locate', { picture, place: of });
    if (place === undefined) throw new Error('the playground is not in a document');
    const { origin, scale } = this.#drawings[picture];
    return { clientX: origin.x + place.x * scale, clientY: origin.y + place.y * scale };
  }
}

const WORDS = words({
  en: {
    section: (n: number) =>
      `Drawing of the tool path, ${n} motions. Arrow keys move it, plus and minus zoom, F shows all of it.`,
    old: (run: number) => `Old picture (run ${run}), from before the block that is being typed`,
    notRun: 'Old picture: the current program could not be run',
    face: () =>
      'Drawing of the end face, seen from the tailstock: X to the right, C or Y up. Arrow keys move it, plus and minus zoom, F shows all of it.',
    side: () =>
      'Drawing of the side, seen from outside, unrolled where C turns: Z to the right, C or Y down. Arrow keys move it, plus and minus zoom, F shows all of it.',
  },
  zh: {
    section: (n) => `刀具轨迹图，共 ${n} 段运动。方向键移动，加号和减号缩放，F 键显示全图。`,
    old: (run) => `旧图（第 ${run} 次运行），正在输入的程序段之前的结果`,
    notRun: '旧图：当前程序未能运行',
    face: () => '端面图，从尾座方向看：X 向右，C 或 Y 向上。方向键移动，加减号缩放，F 显示全部。',
    side: () => '圆柱面图，从外侧看，C 轴转动时为展开图：Z 向右，C 或 Y 向下。方向键移动，加减号缩放，F 显示全部。',
  },
  ru: {
    section: (n) =>
      `Чертёж траектории, перемещений: ${n}. Стрелки сдвигают его, плюс и минус меняют масштаб, F показывает всё.`,
    old: (run) => `Прежний чертёж (прогон ${run}): до кадра, который сейчас набирается`,
    notRun: 'Прежний чертёж: текущую программу выполнить не удалось',
    face: () =>
      'Чертёж торца, вид со стороны задней бабки: X вправо, C или Y вверх. Стрелки двигают его, плюс и минус меняют масштаб, F показывает всё.',
    side: () =>
      'Чертёж боковой поверхности, вид снаружи, с поворотами C — развёртка: Z вправо, C или Y вниз. Стрелки двигают его, плюс и минус меняют масштаб, F показывает всё.',
  },
});
