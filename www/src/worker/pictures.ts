// The worker's half of the views beside the section.
//
// In: the commands and questions of protocol-views.ts. Out: their answers, and what there is to see.
// Must not know: when things are drawn.

import { Drawn, type Playground } from '../../pkg/gcode_playground.js';
import type { Pictures, CanvasCommand, ViewCommand, ViewQuestions, ViewsState } from '../protocol/protocol';

/** Carries out a command; true where what there is to see may have changed. */
export function doView(core: Playground, command: ViewCommand): boolean {
  switch (command.kind) {
    case 'on-face':
      doOnFace(core, command.what);
      return false;
    case 'turret':
      core.setTurret(command.side);
      return true;
    case 'keep':
      core.keep();
      return true;
    case 'end-comparison':
      core.endComparison();
      return true;
    case 'leave-edge':
      core.leaveEdge();
      return false;
  }
}

function doOnFace(core: Playground, command: CanvasCommand): void {
  switch (command.kind) {
    case 'canvas':
      core.attachFaceCanvas(new OffscreenCanvas(1, 1));
      core.resizeFace(command.size.width, command.size.height, command.size.pixelRatio);
      break;
    case 'resize':
      core.resizeFace(command.size.width, command.size.height, command.size.pixelRatio);
      break;
    case 'fit':
      core.fitFace();
      break;
    case 'pan':
      core.panFace(command.dx, command.dy);
      break;
    case 'zoom':
      core.zoomFace(command.factor, command.x, command.y);
      break;
  }
}

export function answerView<K extends keyof ViewQuestions>(
  core: Playground,
  about: K,
  ask: ViewQuestions[keyof ViewQuestions]['ask'],
): ViewQuestions[keyof ViewQuestions]['answer'] {
  switch (about) {
    case 'pickOnFace': {
      const { x, y } = ask as ViewQuestions['pickOnFace']['ask'];
      return core.pickOnFace(x, y);
    }
    case 'dimension': {
      const { x, y } = ask as ViewQuestions['dimension']['ask'];
      return core.dimension(x, y);
    }
    default: {
      const { x, c } = ask as ViewQuestions['locateOnFace']['ask'];
      const [px = 0, py = 0] = core.screenOfFace(x, c);
      return { x: px, y: py };
    }
  }
}

export function viewsState(core: Playground): ViewsState {
  return { face: core.hasFace(), turret: core.turret(), comparison: core.comparison() };
}

/** Paints both pictures of the run that is current; the one that is not done says what is still to be done. */
export function drawAll(core: Playground): Drawn {
  const [section, face] = [core.draw(), core.drawFace()];
  return section === Drawn.All ? face : section;
}

/** Takes what was painted since the last time. */
export function takePictures(core: Playground): Pictures | undefined {
  const pictures = { section: core.takeImage(), face: core.takeFaceImage() };
  return pictures.section === undefined && pictures.face === undefined ? undefined : pictures;
}
