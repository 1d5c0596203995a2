//! The roles of words in their blocks: data that the specifications of cycles and the help share.

/// Lists the roles once, for the enum and for tests of all roles.
macro_rules! roles {
    ($($name:ident)+) => {
        /// The role of a word in its block, or the meaning of a code whose row in the table describes several
        /// codes.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "sentences::assist says what each is")]
        pub enum Role { $($name),+ }

        impl Role {
            /// All roles.
            pub const ALL: &[Self] = &[$(Self::$name),+];
        }
    };
}

roles! {
    // Numbers and marks
    ProgramNumber SequenceNumber BlockSkip Percent Comment SetupNote MacroStatement Variable
    // Codes whose row in the table describes several codes
    InchInput MetricInput FeedPerMinute FeedPerTurn SpindleForward SpindleReverse SpindleStop PlaneXy PlaneZx
    PlaneYz Absolute Incremental InitialLevel RPointLevel ProgramStop OptionalStop CAxisOn CAxisOff PullOutOn PullOutOff
    DataInput DataEnd MacroOnce MacroModal MacroOff WorkFrame UnknownCode
    ToolChange CoolantOn CoolantOff ChuckClamp ChuckUnclamp LiveTool LiveToolForward LiveToolReverse FirstOrientation SecondOrientation
    TailstockForward TailstockBack SynchronousOn SynchronousOff ConveyorForward ConveyorStop InterlockOff InterlockOn
    // Absolute and incremental coordinates
    EndX EndZ EndC EndY WayX WayZ WayC WayY ViaX ViaZ ViaC ViaWayX ViaWayZ MachineX MachineZ OriginX OriginZ ShiftX ShiftZ LocalX LocalZ
    // Corners and arcs
    Chamfer Rounding LineAngle ArcRadius ArcCenterX ArcCenterZ ArcCenterC ArcCenterY CornerX CornerZ
    // Feed, speed, tool
    Feed Lead LeadChange ThreadsPerInch StartAngle SpindleSpeed CuttingSpeed HighestSpeed LowestSpeed ToolAndOffset
    DwellSeconds DwellMilliseconds
    // Single cycles
    CycleEndX CycleEndZ CycleWayX CycleWayZ TaperX TaperZ Starts PullOutAcross PullOutAlong
    // Cycles along a contour
    ContourFirst ContourLast PassDepth PassDepthZ Escape AllowanceX AllowanceZ ReliefX ReliefZ PatternPasses FinishAfter
    // Pecking
    PeckRetract PeckEndX PeckEndZ PeckWayX PeckWayZ Peck StepOver BottomRelief
    // Threading
    ThreadPacked LeastDepth ThreadAllowance ThreadEndX ThreadEndZ ThreadWayX ThreadWayZ ThreadTaper ThreadHeight
    FirstDepth InfeedMethod ThreadAngle
    // Holes
    HoleEndX HoleEndZ HoleWayX HoleWayZ HolePlaceX HolePlaceZ HoleAngle RPoint HolePeck HoleDwell Repeats
    // Data, frames, references
    DataNumber DataKind DataValue DataRadius DataTip ReferencePoint FrameNumber CylinderRadius
    // Calls
    CalledProgram CalledSequence CallRepeats BeginsAt ReturnsTo Argument
    // The rest
    Ignored
}
