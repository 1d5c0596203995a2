// Made from the types that read a setup: `UPDATE_EXPECT=1 cargo test --test it schemas::` writes this file.
// Reference: `docs/setup.html` of the site.

/** A setup as written. Every key is optional; an unknown key is an error that names it. */
export interface Setup {
  /** Levels of block skip (`/` and `/1` to `/9`) that are switched on: such blocks are ignored. */
  readonly blockSkip?: readonly number[];
  /** The control and its switches. */
  readonly dialect?: SetupDialect;
  /** Position of the tool tip before the first block. */
  readonly initial?: SetupPosition;
  /** The limits of a run. */
  readonly limits?: SetupLimits;
  /** Whether lints observe the run. */
  readonly lints?: 'on' | 'off';
  /** The machine. */
  readonly machine?: SetupMachine;
  /** Number of the O program to run; by default the first program of the text. */
  readonly program?: number;
  /** The severity of a rule, or of a group of rules. */
  readonly rules?: { readonly [name: string]: 'off' | 'info' | 'warning' | 'error' };
  /** The blank. */
  readonly stock?: SetupStock;
  /** The centre of the tailstock, if it supports the workpiece. */
  readonly tailstock?: SetupTailstock;
  /** Tools by their T word in four digits (`T0101`). */
  readonly tools?: { readonly [name: string]: SetupTool };
}

/** The switches of a setup; a missing one has the default of the control. */
export interface SetupDialect {
  /** Preset of all other switches; FANUC by default. */
  readonly control?: 'fanuc' | 'gsk' | 'forum';
  /** Numbers without a decimal point. */
  readonly decimal?: 'auto' | 'calculator' | 'leastIncrement';
  /** Feed unit at the start of this program; overrides `powerOnFeed`. */
  readonly feedMode?: 'G98' | 'G99';
  /** Retract of G71. */
  readonly g71Retract?: 'rapid' | 'feed';
  /** Steps of G73. */
  readonly g73Intervals?: 'd-1' | 'd';
  /** Minimum depth of G76. */
  readonly g76Clamp?: 'prev' | 'sqrt';
  /** G-code system. */
  readonly gSystem?: 'A' | 'B' | 'C';
  /** I in G92. */
  readonly iInG92?: 'taper' | 'tpi';
  /** Negative arc R. */
  readonly negativeArcR?: 'over180' | 'alarm';
  /** X in polar interpolation. */
  readonly polarX?: 'diameter' | 'radius';
  /** Feed unit after power-on. */
  readonly powerOnFeed?: 'G98' | 'G99';
  /** Unit of P and Q. */
  readonly pqUnit?: 'auto' | 'um' | 'mm';
  /** Whether programs for other controls and machines are recognised, and then not run; true by default. */
  readonly recognise?: boolean;
  /** First reference point, machine coordinates. */
  readonly refPoint?: SetupPosition;
  /** Relief of G74 and G75 in the first column too. */
  readonly reliefFirst?: boolean;
  /** Real alarms instead of warnings. */
  readonly strict?: boolean;
  /** Thread pull-out at the start, tenths of a lead, 0 to 99. */
  readonly threadChamfer?: number;
  /** Pockets in G71 and G72. */
  readonly typeII?: boolean;
  /** Unit until a G20 or G21. */
  readonly unit?: 'mm' | 'inch';
  /** X with U, Z with W. */
  readonly xuConflict?: 'last' | 'absolute';
}

/** The resources that a run may use. */
export interface SetupLimits {
  /** Maximum nesting of subprograms (0i-D and later). */
  readonly callDepth?: number;
  /**
   * Maximum blocks of a program for the lints that compare its numbers with each other; the maximum number of motions
   * is ten times this.
   */
  readonly comparedBlocks?: number;
  /**
   * Maximum steps for work that produces no motion: each block of a contour that is read again (a long one takes
   * several steps), and each move of a cycle that is refused or has no effect. Keeps many calls of an expensive cycle
   * from adding up.
   */
  readonly cycleWork?: number;
  /** Maximum nesting of macros (G65, G66), which count as subprograms too. */
  readonly macroDepth?: number;
  /** Maximum macro statements, and words with an expression, evaluated through jumps, loops and calls. */
  readonly macroSteps?: number;
  /** Maximum number of messages. */
  readonly messages?: number;
  /** Maximum number of motions. */
  readonly motions?: number;
  /**
   * Maximum moves of one cycle call, and of the contour it reads. Roughing a bar of 1 m diameter in steps of 0.02 mm
   * takes half of the default; more are probably a misplaced decimal point, and the call is refused.
   */
  readonly movesPerCycle?: number;
  /** Maximum corners of the part. */
  readonly partCorners?: number;
  /**
   * Maximum motions of a program whose material is removed from the blank; for a longer program only the path is
   * shown.
   */
  readonly partMotions?: number;
  /** Maximum blocks executed through jumps, loops and calls; blocks in sequence do not count. */
  readonly repeatedBlocks?: number;
  /** Maximum bytes of such blocks, because a block can be as long as the text. */
  readonly repeatedText?: number;
  /** Maximum iterations of loops (`END` back to `WHILE` or `DO`) and calls (L), in total. */
  readonly rounds?: number;
  /** Maximum length of the text, bytes. */
  readonly text?: number;
}

/** The machine. A missing value is unknown and has no default. */
export interface SetupMachine {
  /** Highest spindle speed, rpm. */
  readonly maxSpeed?: number;
  /** Rapid rate of the slide along X, mm/min. */
  readonly rapidX?: number;
  /** Rapid rate along Z, mm/min. */
  readonly rapidZ?: number;
  /** K of the rule of thumb for threads, n ≤ 1200/P − K, rpm. A slide that accelerates slowly needs more. */
  readonly threadSpeedMargin?: number;
  /** Travel of the tip. */
  readonly travel?: SetupTravel;
  /** Side of the spindle that the turret is on. */
  readonly turret?: 'rear' | 'front';
  /** Whether it has a Y axis; false by default. */
  readonly yAxis?: boolean;
}

/** A position in the notation of users. */
export interface SetupPosition {
  /** Diameter, mm. */
  readonly x: number;
  /** Z, mm. */
  readonly z: number;
}

/**
 * The blank: a bar or a tube, which needs `diameter` and `length`; or a forging or casting, whose `outline` replaces
 * all sizes except `grip`.
 */
export interface SetupStock {
  /** Diameter of the bore, mm; 0 for a bar. */
  readonly bore?: number;
  /** Outside diameter, mm. */
  readonly diameter?: number;
  /** Z of the front face, mm. */
  readonly face?: number;
  /** Clamping length from the back end, mm. */
  readonly grip?: number;
  /** Length from the front face towards −Z, mm. */
  readonly length?: number;
  /**
   * Points of the half section, joined by straight lines: X, a diameter, and Z, mm. The outline is closed along the
   * spindle axis, unless its last point repeats the first.
   */
  readonly outline?: readonly (readonly [number, number])[];
}

/** The centre of the tailstock: a cone of 60° in front of a quill. */
export interface SetupTailstock {
  /** Diameter of the quill, mm. */
  readonly diameter: number;
  /** Z of its point, mm. */
  readonly z: number;
}

/** A tool as on a setup sheet. Missing values have the default of its kind. */
export interface SetupTool {
  /** Angle of a thread or of the point of a drill, degrees. */
  readonly angle?: number;
  /** Diameter of a drill, a tap or a cutter, mm. */
  readonly diameter?: number;
  /** Length of the cutting edge, mm; for a threading tool the length of each flank of its point. */
  readonly edgeLength?: number;
  /** Angle of the main edge to the direction of feed along Z, degrees (κr, 95 for a common turning tool). */
  readonly enteringAngle?: number;
  /** The R entry of the geometry offset, mm. */
  readonly geometryR?: number;
  /** X of the geometry offset: the length of the tool, mm. */
  readonly geometryX?: number;
  /** Z of the geometry offset: the length of the tool, mm. */
  readonly geometryZ?: number;
  /**
   * ISO 1832 designation of the insert: the first letter is its shape, and `CNMG120408` also gives edge length and
   * nose radius. For a threading tool the designation of a lay-down insert: `16ER AG60`.
   */
  readonly insert?: string;
  /** Nose radius, mm; for a grooving insert the radius of its corners. */
  readonly noseRadius?: number;
  /** Angle between the two edges of a turning insert, degrees; by default that of its shape. */
  readonly pointAngle?: number;
  /**
   * Length of a grooving insert, a threading point or a drill from its holder, or of a boring bar into the workpiece,
   * mm.
   */
  readonly reach?: number;
  /** Diameter of a boring bar, mm. */
  readonly shank?: number;
  /** Side of the workpiece that a grooving insert or a threading tool is for. */
  readonly side?: 'outside' | 'inside' | 'face';
  /** Tip direction, 0 to 9 (FANUC 16/18-T B-62754EN p. 224). */
  readonly tip?: number;
  /** Radius of a live cutter, mm. */
  readonly toolRadius?: number;
  /** Kind of the tool. */
  readonly type?: 'turning' | 'boring' | 'grooving' | 'threading' | 'drill' | 'tap' | 'endmill';
  /** R of the wear offset, mm: added to the nose radius that compensation uses. */
  readonly wearR?: number;
  /** X of the wear offset, mm. */
  readonly wearX?: number;
  /** Z of the wear offset, mm. */
  readonly wearZ?: number;
  /** Width of a grooving insert, mm. */
  readonly width?: number;
}

/** Travel of the tip in program coordinates: X a diameter, mm. */
export interface SetupTravel {
  /** Maximum X, a diameter. */
  readonly xMax?: number;
  /** Minimum X, a diameter. */
  readonly xMin?: number;
  /** Maximum Z. */
  readonly zMax?: number;
  /** Minimum Z. */
  readonly zMin?: number;
}
