//! The signs of other controls and machines, and their weights.
//!
//! In: a [`Sign`]. Out: the target that it suggests. Must not know how a sign is found.

use super::Target;

/// The target that a sign suggests or excludes, and its weight. The weights for one target add up; each sign
/// counts once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// For a target.
    For(Target, u8),
    /// For a lathe with FANUC's words: not a mill or a printer.
    Lathe(u8),
    /// For FANUC's own cycles: not another lathe control, unless its language has names.
    Fanuc(u8),
    /// For both.
    FanucLathe(u8),
}

macro_rules! signs {
    ($($(#[$doc:meta])* $sign:ident = $weight:expr,)*) => {
        /// A construct that not every control has.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Sign { $($(#[$doc])* $sign,)* }

        impl Sign {
            /// Its weight.
            pub fn weight(self) -> Weight {
                use Target::*;
                use Weight::*;
                match self { $(Self::$sign => $weight,)* }
            }
        }
    };
}

signs! {
    /// `%1234`: a program number (also on NUM).
    PercentNumber = For(Hnc, 3),
    /// `G71 U R P Q X Z`: both blocks of a cycle in one.
    OneLineRoughing = For(Hnc, 4),
    /// `G71 U R P Q E`: the same for a contour with a recess.
    OneLineRecess = For(Hnc, 4),
    /// `G71 U R P Q`: the same without allowances.
    OneLineShort = For(Hnc, 1),
    /// `G80 X Z F`: turning.
    TurningG80 = For(Hnc, 2),
    /// `G81 X Z`: facing.
    FacingG81 = For(Hnc, 2),
    /// `G82 X Z`: threading.
    ThreadingG82 = For(Hnc, 2),
    /// `G76 C A X Z … K`: threading in one block.
    OneLineThread = For(Hnc, 3),
    /// `G36` without a word: diameters.
    DiametersG36 = For(Hnc, 2),
    /// `G37` without a word: radii.
    RadiiG37 = For(Hnc, 2),
    /// `ENDW`.
    EndWhile = For(Hnc, 3),

    /// `CYCLE95(`.
    CycleCall = For(Siemens, 4),
    /// `CYCLE95` without a bracket; `LCYC95`.
    CycleName = For(Siemens, 3),
    /// `DIAMON`, `DIAMOF`, `DIAM90`.
    DiameterMode = For(Siemens, 4),
    /// `%_N_SHAFT_MPF`, `%MPF1005`, `%SPF20`.
    TransferHead = For(Siemens, 4),
    /// `R1=`.
    RParameter = For(Siemens, 2),
    /// `X=R1`.
    AxisFromR = For(Siemens, 2),
    /// `LIMS=`.
    SpeedLimit = For(Siemens, 3),
    /// `MSG(`.
    MessageCall = For(Siemens, 2),
    /// `X=IC(`, `Z=AC(`.
    IncrementCall = For(Siemens, 3),
    /// `T="…"`.
    ToolByName = For(Siemens, 3),
    /// `CR=`, `RND=`, `CHF=`, `SPOS=` and similar.
    NamedAddress = For(Siemens, 3),
    /// `TRANS Z`, `ATRANS Z`.
    FrameShift = For(Siemens, 3),
    /// `WAITM(`: waits for another channel.
    WaitMark = For(Siemens, 4),
    /// `GOTOF`, `MCALL`, `STOPRE` and similar.
    SiemensWord = For(Siemens, 3),
    /// `M17` alone: end of a subprogram.
    M17Alone = For(Siemens, 1),
    /// `G290`, `G291`: switches the language.
    LanguageSwitch = For(Siemens, 1),

    /// `O100 SUB`, `O100 IF`, `O<name> CALL`.
    OWord = For(LinuxCnc, 4),
    /// `#<name>`.
    NamedVariable = For(LinuxCnc, 3),
    /// `G7`: diameters.
    DiametersG7 = For(LinuxCnc, 2),
    /// `G8`: radii.
    RadiiG8 = For(LinuxCnc, 4),
    /// `G64 P`: path tolerance.
    PathTolerance = For(LinuxCnc, 2),
    /// `G33.1`: rigid tapping.
    RigidTap = For(LinuxCnc, 3),
    /// `G33 Z K` without F.
    ThreadByK = For(LinuxCnc, 2),
    /// `G96 D S`: speed limit in D.
    SpeedLimitD = For(LinuxCnc, 4),
    /// `G76 P Z I J K`.
    ThreadIjk = For(LinuxCnc, 4),
    /// `G92.1`, `G92.2`, `G92.3`.
    OffsetCancel = For(LinuxCnc, 2),
    /// `G43` without H: tool length from the tool table.
    ToolTable = For(LinuxCnc, 2),
    /// `G91.1`: incremental centres of arcs.
    IncrementalCentres = For(LinuxCnc, 4),
    /// `G93`: inverse time.
    InverseTime = For(LinuxCnc, 2),
    /// `(DEBUG,`, `(PRINT,`, `(LOG,`.
    ActiveRemark = For(LinuxCnc, 3),
    /// `(MSG,`.
    MessageRemark = For(LinuxCnc, 1),

    /// `(RPT N10,N20)`.
    RepeatBlocks = For(Fagor, 4),
    /// `(GOTO N10)`.
    JumpInBrackets = For(Fagor, 3),
    /// `(IF P1 …`.
    IfInBrackets = For(Fagor, 3),
    /// `(P1=20)`.
    ParameterInBrackets = For(Fagor, 3),
    /// `(CALL 1)`, `(PCALL 1…`.
    CallInBrackets = For(Fagor, 2),
    /// `(SUB 1)`.
    SubInBrackets = For(Fagor, 2),
    /// `(RET)`.
    ReturnInBrackets = For(Fagor, 3),
    /// `P1=K20`.
    ParameterK = For(Fagor, 4),
    /// `%SHAFT,MX,`.
    FagorHead = For(Fagor, 4),
    /// `G68 X Z C … S E`: roughing of the contour between two blocks (Fagor 8055 T, G66, G68, G69).
    ContourSe = For(Fagor, 8),
    /// `G81 X Z Q R C L`: turning of a straight section (G81, G82).
    SectionQrcl = For(Fagor, 6),
    /// `G36 R X Z`: rounding of a corner.
    RoundingG36 = For(Fagor, 2),

    /// `BEGIN PGM`, `END PGM`.
    ProgramFrame = For(Heidenhain, 4),
    /// `BLK FORM`, `CYCL DEF`.
    Definition = For(Heidenhain, 4),
    /// `TOOL CALL`.
    ToolCall = For(Heidenhain, 2),
    /// `FMAX`.
    FeedMax = For(Heidenhain, 3),
    /// `L X+10`.
    LineMove = For(Heidenhain, 2),
    /// `LBL 1`.
    LabelWord = For(Heidenhain, 2),

    /// `$SHAFT.MIN%`.
    OkumaHead = For(Okuma, 4),
    /// `NAT01`.
    NamedSequence = For(Okuma, 4),
    /// `G71 X Z B D H F`: threading.
    ThreadByBdh = For(Okuma, 3),
    /// `T010101`: radius offset, station and offset.
    SixDigitTool = For(Okuma, 1),
    /// `G85 NLAP1`.
    LapCall = For(Okuma, 4),
    /// `VZSHZ=`, `VZOFZ=`.
    ZeroVariable = For(Okuma, 4),
    /// `V1=`, `VC1=`.
    VVariable = For(Okuma, 2),
    /// `NOEX`, `MODIN`, `VLMON`.
    OkumaWord = For(Okuma, 3),
    /// `SB=`: speed of a live tool.
    LiveToolSpeed = For(Okuma, 3),

    /// `$1`: the program of a path.
    PathHead = For(Channels, 5),
    /// `!L1`, `!2L1`: waits for another path.
    PathWait = For(Channels, 3),
    /// `S1=500`: speed of a spindle.
    SpindleSpeed = For(Channels, 2),

    /// `G109 L1`: turret.
    Turret = For(Mazak, 4),

    /// `$AddRegPart`, `$Message`.
    SimulatorCommand = For(CncSimulator, 4),

    /// `%PM`, `%TM` alone: program and tool memory. These programs contain `G96 D S`, too.
    PhilipsHead = For(Philips, 5),

    /// `G81 X Z I K`.
    CycleIk = For(Gsk928, 3),
    /// The same with L or A.
    CycleIkl = For(Gsk928, 1),
    /// `G71 X I K L` without a contour.
    RoughingIkl = For(Gsk928, 3),

    /// `G43 H`.
    ToolLength = For(Mill, 3),
    /// `T1 M6`, without an offset.
    ToolChange = For(Mill, 2),
    /// `Y5`.
    MoveY = For(Mill, 1),
    /// Many moves in X and Y.
    ManyY = For(Mill, 2),
    /// `G2 X Y I J`.
    ArcXy = For(Mill, 1),
    /// `G81 X Y Z`.
    HoleXy = For(Mill, 1),
    /// `G41 D`.
    RadiusOffset = For(Mill, 2),
    /// `G17`.
    PlaneXy = For(Mill, 1),
    /// `G49`.
    LengthCancel = For(Mill, 1),
    /// `G91 G28 Z`.
    HomeZ = For(Mill, 1),

    /// `M104 S`.
    HeatNozzle = For(Printer, 2),
    /// `M109 S`.
    AwaitNozzle = For(Printer, 2),
    /// `M140 S`.
    HeatBed = For(Printer, 2),
    /// `M190 S`.
    AwaitBed = For(Printer, 2),
    /// `G1 X Y E`.
    Extrusion = For(Printer, 2),
    /// `G92 E`.
    ExtruderZero = For(Printer, 3),
    /// `M82`, `M83` alone.
    ExtruderMode = For(Printer, 1),
    /// `G29` alone.
    BedLevel = For(Printer, 1),
    /// `;LAYER`, `;FLAVOR`.
    Layer = For(Printer, 3),

    /// `T0101`.
    ToolWithOffset = Lathe(3),
    /// `G96`.
    SurfaceSpeed = Lathe(3),
    /// `G28 U`, `G28 W`.
    HomeUw = Lathe(3),
    /// `G1 U`, `X W`.
    Incremental = Lathe(3),
    /// `G12.1`, `G112`.
    Polar = Lathe(3),
    /// `G50 S`.
    SpeedClamp = FanucLathe(3),
    /// `G70 P Q`.
    Finishing = FanucLathe(3),
    /// `G71 P Q U W`, without X or Z.
    Roughing = FanucLathe(3),
    /// `G76 P010060`.
    ThreadData = FanucLathe(3),
    /// `G92 X Z F`, `G94 X Z F`, `G90 X Z R`.
    SingleCycle = FanucLathe(2),
    /// `G65 P`, `G66 P`.
    MacroCall = Fanuc(2),
}

impl Sign {
    /// The bit of the sign, to count each sign once.
    pub fn bit(self) -> u128 {
        const { assert!((Sign::MacroCall as u8) < 128) };
        1 << (self as u8)
    }
}
