// The body that is turned from a half-section, as plain numbers for the renderer.
//
// In: the pieces of the section. Out: the turned surface with its normals, and its edges. The quarter between up and
// the viewer is left out. The first axis is the spindle axis, the second points up, the third towards the viewer.
// Threads are rings, as in the section. Must not know: how it is drawn.

import type { SectionPiece } from '../protocol/protocol';

/** A corner of the half-section: position along the spindle, and radius; mm. */
export interface Corner {
  readonly z: number;
  readonly r: number;
}

interface Body {
  /** Three numbers for each point, mm; three indices in `triangles` for each triangle. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly triangles: Uint32Array;
  /** Six numbers for each line, mm. */
  readonly edges: Float32Array;
}

/** Start angle and sweep of the surface, radians: from the viewer, around the back, to up. */
const START_ANGLE = Math.PI / 2;
const SWEEP = (3 * Math.PI) / 2;
/** Flats in the three quarters: enough for a smooth outline, fewer if there are very many corners. */
const SEGMENTS = { min: 24, max: 144, points: 600_000 };
/** A corner closer to the axis than this is on it, mm. */
const ON_AXIS_MM = 1e-4;
/**
 * Arcs arrive as chords: a corner belongs to an arc if it turns by less than this angle, radians, and protrudes from
 * its neighbours by less than this height, mm.
 */
const SMOOTH = { angle: Math.PI / 6, height: 0.006 };

/** The closed outlines of a piece, material on the left. */
export function outlinesOf({ outline, holes }: SectionPiece): Corner[][] {
  return [outline, ...holes].map((points) => points.map(([z, x]) => ({ z, r: Math.max(x / 2, 0) })));
}

export function turnedBody(pieces: readonly SectionPiece[]): Body {
  const outlines = pieces.flatMap(outlinesOf);
  const corners = outlines.reduce((sum, outline) => sum + outline.length, 0);
  const segments = Math.round(
    Math.min(SEGMENTS.max, Math.max(SEGMENTS.min, SEGMENTS.points / (2 * Math.max(corners, 1)))),
  );
  const around = Array.from({ length: segments + 1 }, (_, segment) => {
    const angle = START_ANGLE + (SWEEP * segment) / segments;
    return { up: Math.cos(angle), near: Math.sin(angle) };
  });
  const builder = new Builder(around);
  for (const outline of outlines) addOutline(builder, outline);
  return builder.body();
}

function addOutline(builder: Builder, outline: readonly Corner[]): void {
  const count = outline.length;
  const at = (index: number): Corner => outline[(index + count) % count] ?? { z: 0, r: 0 };
  for (let index = 0; index < count; index += 1) {
    const [from, to] = [at(index), at(index + 1)];
    if (isOnAxis(from) && isOnAxis(to)) continue;
    const joints = [jointOf(at(index - 1), from, to), jointOf(from, to, at(index + 2))] as const;
    builder.addBand(from, to, normalAt(from, to, joints[0]), normalAt(from, to, joints[1]));
    builder.addSectionEdge(from, to);
    if (joints[0].kind === 'sharp' && !isOnAxis(from)) builder.addRing(from);
  }
}

type Joint = { readonly kind: 'sharp' } | { readonly kind: 'smooth'; readonly normal: Direction };

interface Direction {
  readonly z: number;
  readonly r: number;
}

/** How two edges meet at a corner. */
function jointOf(a: Corner, b: Corner, c: Corner): Joint {
  const [before, after] = [normalOf(a, b), normalOf(b, c)];
  const angle = Math.abs(Math.atan2(before.z * after.r - before.r * after.z, before.z * after.z + before.r * after.r));
  const [first, second] = [length(a, b), length(b, c)];
  const height = (Math.min(first, second) * angle) / 8;
  // An edge on the axis belongs to no surface.
  if (angle > SMOOTH.angle || height > SMOOTH.height || (isOnAxis(a) && isOnAxis(b)) || (isOnAxis(b) && isOnAxis(c)))
    return { kind: 'sharp' };
  // A long straight edge that an arc joins is tangent to it.
  if (first > 8 * second) return { kind: 'smooth', normal: before };
  if (second > 8 * first) return { kind: 'smooth', normal: after };
  const sum = { z: before.z + after.z, r: before.r + after.r };
  const size = Math.hypot(sum.z, sum.r) || 1;
  return { kind: 'smooth', normal: { z: sum.z / size, r: sum.r / size } };
}

function normalAt(from: Corner, to: Corner, joint: Joint): Direction {
  return joint.kind === 'smooth' ? joint.normal : normalOf(from, to);
}

/** The normal of an edge, away from the material on its left. */
function normalOf(from: Corner, to: Corner): Direction {
  const size = length(from, to) || 1;
  return { z: (to.r - from.r) / size, r: (from.z - to.z) / size };
}

function length(a: Corner, b: Corner): number {
  return Math.hypot(b.z - a.z, b.r - a.r);
}

function isOnAxis({ r }: Corner): boolean {
  return r < ON_AXIS_MM;
}

/** A direction perpendicular to the axis: its components up and towards the viewer. */
interface RadialDirection {
  readonly up: number;
  readonly near: number;
}

/** Collects the arrays of a body. */
class Builder {
  readonly #around: readonly RadialDirection[];
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #triangles: number[] = [];
  readonly #edges: number[] = [];

  constructor(around: readonly RadialDirection[]) {
    this.#around = around;
  }

  /** Adds the surface that an edge sweeps. */
  addBand(from: Corner, to: Corner, normalFrom: Direction, normalTo: Direction): void {
    const first = this.#positions.length / 3;
    for (const { up, near } of this.#around) {
      this.#positions.push(from.z, from.r * up, from.r * near, to.z, to.r * up, to.r * near);
      this.#normals.push(
        normalFrom.z,
        normalFrom.r * up,
        normalFrom.r * near,
        normalTo.z,
        normalTo.r * up,
        normalTo.r * near,
      );
    }
    for (let segment = 0; segment + 1 < this.#around.length; segment += 1) {
      const [a, b, c, d] = [0, 1, 2, 3].map((step) => first + 2 * segment + step) as [number, number, number, number];
      this.#triangles.push(a, b, c, b, d, c);
    }
  }

  /** Adds the circle that a corner sweeps. */
  addRing({ z, r }: Corner): void {
    for (const [index, next] of this.#around.slice(1).entries()) {
      const before = this.#around[index];
      if (before !== undefined) this.#edges.push(z, r * before.up, r * before.near, z, r * next.up, r * next.near);
    }
  }

  /** Adds an edge to both faces of the cut. */
  addSectionEdge(from: Corner, to: Corner): void {
    this.#edges.push(from.z, from.r, 0, to.z, to.r, 0, from.z, 0, from.r, to.z, 0, to.r);
  }

  body(): Body {
    return {
      positions: new Float32Array(this.#positions),
      normals: new Float32Array(this.#normals),
      triangles: new Uint32Array(this.#triangles),
      edges: new Float32Array(this.#edges),
    };
  }
}
