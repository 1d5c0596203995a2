// What the page and the worker say to each other about the views beside the section: part of protocol.ts.

import type { Comparison, Dimension, Stroke } from '../pkg/gcode_playground.js';
import type { Size } from './protocol';

export type { Comparison, Dimension };

/** On which side of the spindle the turret is drawn. */
export type TurretSide = 'front' | 'rear';

/** What happens to a canvas; pan in CSS pixels. */
export type CanvasCommand =
  /** Pictures of this size are wanted from now on. */
  | { readonly kind: 'canvas'; readonly size: Size }
  | { readonly kind: 'resize'; readonly size: Size }
  | { readonly kind: 'fit' }
  | { readonly kind: 'pan'; readonly dx: number; readonly dy: number }
  | { readonly kind: 'zoom'; readonly factor: number; readonly x: number; readonly y: number };

export type ViewCommand =
  | { readonly kind: 'on-face'; readonly what: CanvasCommand }
  | { readonly kind: 'turret'; readonly side: TurretSide }
  /** Keeps the part, to lay later ones over it. */
  | { readonly kind: 'keep' }
  | { readonly kind: 'end-comparison' }
  /** The pointer has left the edge that is marked. */
  | { readonly kind: 'leave-edge' };

export interface ViewQuestions {
  pickOnFace: { ask: { readonly x: number; readonly y: number }; answer: Stroke | undefined };
  dimension: { ask: { readonly x: number; readonly y: number }; answer: Dimension | undefined };
  /** X a diameter, C in mm; CSS pixels from the top left corner of the face's canvas. */
  locateOnFace: { ask: { readonly x: number; readonly c: number }; answer: { readonly x: number; readonly y: number } };
}

/** What there is to see beside the section. */
export interface ViewsState {
  /** Something moves on the end face. */
  readonly face: boolean;
  readonly turret: TurretSide;
  /** While a part is kept. */
  readonly comparison: Comparison | undefined;
}
