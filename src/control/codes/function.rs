//! The rows of the table of supported codes, under their headings.

/// Defines the functions under their headings, in the order of the table.
macro_rules! functions {
    ($($section:ident { $($function:ident)+ })+) => {
        /// A heading of the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "sentences::codes says what each is")]
        pub enum Section { $($section),+ }

        /// The function of a code: a row of the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "sentences::codes says what each is")]
        pub enum Function { $($($function),+),+ }

        impl Function {
            /// All of them, in the order of the table.
            pub const ALL: &[Function] = &[$($(Self::$function),+),+];

            /// The heading of this function.
            pub fn section(self) -> Section {
                match self { $($(Self::$function)|+ => Section::$section),+ }
            }
        }
    };
}

functions! {
    Moves { Rapid Line ArcClockwise ArcCounterclockwise Dwell Chamfer Rounding GskCorner Angle }
    Threads { Thread Tapping VariableThread }
    SingleCycles { TurningCycle ThreadingCycle FacingCycle }
    MultipleCycles { Finishing RoughTurning RoughFacing Pattern FacePecking Grooving MultiThreading }
    HoleCycles { NoHole Drilling CounterBoring FaceDrilling FaceTapping FaceBoring BoringStop SideDrilling SideTapping
        SideBoring HoleReturn }
    Compensation { CompensationOff CompensationLeft CompensationRight }
    MilledFaces { PolarOn PolarOff Cylinder }
    Coordinates { Setting LocalFrame Machine Frame ExtendedFrame Distance CheckHome Home FromHome OtherHome Data }
    Modes { Plane Unit Feed SurfaceSpeed ConstantSpeed Spindle Tool }
    Flow { Pause End Call LocalCall CardCall Return MacroCall ModalMacro Variables If Goto While Output BlockSkip }
    MachineFunctions { ToolChange Coolant Chuck LiveTool Orientation ThreadPullOut Tailstock RigidTapping Gear CAxis Synchronous
        Conveyor Interlock OtherMachine }
    OffStates { StrokeCheck ExactStop SpindleCheck Off }
    NotYet { HighSpeed Skip AutomaticOffset Polygon Mirror OtherInterpolation OtherFeedControl OtherCompensation OtherCoordinates
        OtherSynchronization OtherCycles OtherMacroCall }
}
