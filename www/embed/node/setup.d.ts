/**
 * Everything that is not in the program. Every key is optional; an unknown key is an error that names it. Lengths are
 * mm, X values are diameters.
 * Reference: `docs/setup.html` of the site.
 */
export interface Setup {
  /** The control and its switches. */
  readonly dialect?: SetupDialect;
  /** Position of the tool tip before the first block. */
  readonly initial?: SetupPosition;
  /** The tools by their T word with four digits: `T0101`. */
  readonly tools?: { readonly [tool: string]: SetupTool };
  /** The blank. */
  readonly stock?: SetupStock;
  readonly tailstock?: SetupTailstock;
  readonly machine?: SetupMachine;
  /** The levels of block skip that are on: `/` is 1. */
  readonly blockSkip?: readonly number[];
  /** The O number to run; default: the first program of the text. */
  readonly program?: number;
  readonly limits?: SetupLimits;
  /** The severity of rules by slug, or of `classroom`, a group of rules. */
  readonly rules?: { readonly [rule: string]: 'off' | 'info' | 'warning' | 'error' };
  /** Whether lints are reported: messages about blocks that a control runs without an alarm. */
  readonly lints?: 'on' | 'off';
}

/** A point, mm; X is a diameter. */
export interface SetupPosition {
  readonly x: number;
  readonly z: number;
}

/**
 * The blank: a bar or a tube, which needs `diameter` and `length`, or a forging or casting, whose `outline` replaces
 * all sizes except `grip`.
 */
export interface SetupStock {
  readonly diameter?: number;
  /** Diameter of the bore; 0 for a bar. */
  readonly bore?: number;
  /** Z of the front face. */
  readonly face?: number;
  /** Length from the front face towards -Z. */
  readonly length?: number;
  /** Clamping length, from the back end. */
  readonly grip?: number;
  /**
   * Points of the half section, joined by straight lines: X, a diameter, and Z. The outline is closed along the spindle
   * axis, unless its last point repeats the first. 2 to 200 points.
   */
  readonly outline?: readonly (readonly [x: number, z: number])[];
}

export interface SetupTool {
  readonly type?: 'turning' | 'boring' | 'grooving' | 'threading' | 'drill' | 'tap' | 'endmill';
  /** The side of the work that a grooving or threading insert is for. */
  readonly side?: 'outside' | 'inside' | 'face';
  /** The designation of the insert (ISO 1832): `CNMG120408`, `16ER1.5ISO`. */
  readonly insert?: string;
  readonly noseRadius?: number;
  /** Tool-tip direction, 0 to 9. */
  readonly tip?: number;
  /** Angle between the main edge and the feed direction along Z, degrees. */
  readonly enteringAngle?: number;
  /** Angle between the edges, degrees. */
  readonly pointAngle?: number;
  readonly edgeLength?: number;
  /** Width of a grooving insert. */
  readonly width?: number;
  /** Diameter of a drill, tap or milling cutter. */
  readonly diameter?: number;
  /** Overhang beyond the holder. */
  readonly reach?: number;
  /** Diameter of a boring bar. */
  readonly shank?: number;
  /** Angle of the thread, or point angle of a drill, degrees. */
  readonly angle?: number;
  /** Radius of a live milling cutter. */
  readonly toolRadius?: number;
  /** Geometry offset: the length of the tool, X as a diameter. It moves neither path nor part. */
  readonly geometryX?: number;
  readonly geometryZ?: number;
  /** R of the geometry offset, which compensation uses. */
  readonly geometryR?: number;
  /** Wear offset, X as a diameter: it moves the path and the part. */
  readonly wearX?: number;
  readonly wearZ?: number;
  /** R of the wear offset, added to the nose radius that compensation uses. */
  readonly wearR?: number;
}

export interface SetupTailstock {
  /** Z of the tip of the centre. */
  readonly z: number;
  /** Diameter of the quill. */
  readonly diameter: number;
}

export interface SetupMachine {
  /** Rapid traverse rate, mm/min. */
  readonly rapidX?: number;
  readonly rapidZ?: number;
  /** Rpm. */
  readonly maxSpeed?: number;
  /** K of the rule n <= 1200/P - K for threads, rpm. */
  readonly threadSpeedMargin?: number;
  readonly travel?: SetupTravel;
  readonly turret?: 'rear' | 'front';
  readonly yAxis?: boolean;
}

/** Travel limits of the tool tip, mm; X is a diameter. */
export interface SetupTravel {
  readonly xMin?: number;
  readonly xMax?: number;
  readonly zMin?: number;
  readonly zMax?: number;
}

/** The control, and switches for the differences between controls; default: the value of the control. */
export interface SetupDialect {
  readonly control?: 'fanuc' | 'gsk' | 'forum';
  /** The G-code system; default: inferred from the program. */
  readonly gSystem?: 'A' | 'B' | 'C';
  /** The unit until a G20 or G21; default: inferred from the program. */
  readonly unit?: 'mm' | 'inch';
  /** The unit of numbers without a decimal point. */
  readonly decimal?: 'auto' | 'calculator' | 'leastIncrement';
  /** The unit of P and Q in G74, G75 and G76. */
  readonly pqUnit?: 'auto' | 'um' | 'mm';
  /** Same as `feedMode`. */
  readonly powerOnFeed?: 'G99' | 'G98';
  readonly feedMode?: 'G99' | 'G98';
  /** Which word takes effect if a block contains both X and U. */
  readonly xuConflict?: 'last' | 'absolute';
  readonly negativeArcR?: 'over180' | 'alarm';
  readonly g71Retract?: 'rapid' | 'feed';
  readonly g73Intervals?: 'd-1' | 'd';
  readonly g76Clamp?: 'prev' | 'sqrt';
  readonly reliefFirst?: boolean;
  readonly iInG92?: 'taper' | 'tpi';
  /** Thread chamfer in tenths of the lead, 0 to 99. */
  readonly threadChamfer?: number;
  readonly typeII?: boolean;
  readonly strict?: boolean;
  readonly polarX?: 'diameter' | 'radius';
  readonly refPoint?: SetupPosition;
  readonly recognise?: boolean;
}

/** Limits of a run. Reference: `docs/limits.html` of the site. */
export interface SetupLimits {
  readonly text?: number;
  readonly motions?: number;
  readonly movesPerCycle?: number;
  readonly cycleWork?: number;
  readonly repeatedBlocks?: number;
  readonly repeatedText?: number;
  readonly rounds?: number;
  readonly macroSteps?: number;
  readonly callDepth?: number;
  readonly macroDepth?: number;
  readonly messages?: number;
  readonly partMotions?: number;
  readonly partCorners?: number;
  readonly comparedBlocks?: number;
}
