// The holes of live tools in the turned body, as plain numbers for the renderer.
//
// In: holes with mouth and bottom. Out: for each hole, both ends in space, its radius, and its intersections with the
// faces of the cut. The axes are as in `solid-shape`: the first is the spindle axis, the second points up, the third
// towards the viewer; C 0 is up, and C turns towards the viewer. Must not know: how it is drawn.

import type { DrilledHole } from '../protocol/protocol';

type Point3 = readonly [z: number, up: number, near: number];

export interface Bore {
  readonly mouth: Point3;
  readonly bottom: Point3;
  /** mm. */
  readonly radius: number;
  /** Rectangles in the faces of the cut: four corners each, in order around it. */
  readonly cuts: readonly (readonly [Point3, Point3, Point3, Point3])[];
}

/** Extension of a hole beyond the surface, so that it is visible, mm. */
const OVERHANG_MM = 0.05;
/** An axis whose angle to a face of the cut is smaller than this lies in the face; sine of the angle. */
const IN_PLANE_SINE = 1e-6;

export function boreOf({ mouth, bottom, diameter }: DrilledHole): Bore {
  const angle = ((mouth.c ?? 0) * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const at = (z: number, r: number): Point3 => [z, r * cos, r * sin];
  const radius = diameter / 2;
  const [inner, outer] = [bottom.x / 2, mouth.x / 2];
  // A hole into the face has a constant radius; a hole into the side has a constant Z.
  const intoFace = Math.abs(mouth.x - bottom.x) < Math.abs(mouth.z - bottom.z);
  const first = intoFace ? at(mouth.z + OVERHANG_MM, outer) : at(mouth.z, outer + OVERHANG_MM);
  const cuts: [Point3, Point3, Point3, Point3][] = [];
  for (const [along, across, corner] of [
    [cos, sin, (z: number, r: number): Point3 => [z, r, OVERHANG_MM]],
    [sin, cos, (z: number, r: number): Point3 => [z, OVERHANG_MM, r]],
  ] as const) {
    if (along <= 0) continue;
    const [low, high, left, right] = intoFace
      ? rectangle(outer * along, halfChord(radius, outer * across), bottom.z, mouth.z)
      : [
          inner,
          outer,
          ...(Math.abs(across) < IN_PLANE_SINE ? ([mouth.z - radius, mouth.z + radius] as const) : ([0, 0] as const)),
        ];
    if (high > low && right > left)
      cuts.push([corner(left, low), corner(right, low), corner(right, high), corner(left, high)]);
  }
  return { mouth: first, bottom: at(bottom.z, inner), radius, cuts };
}

function rectangle(middle: number, half: number, left: number, right: number): [number, number, number, number] {
  return [middle - half, middle + half, left, right];
}

/** Half of the chord in which a plane at this distance from the axis cuts a round hole. */
function halfChord(radius: number, distance: number): number {
  return Math.sqrt(Math.max(radius * radius - distance * distance, 0));
}
