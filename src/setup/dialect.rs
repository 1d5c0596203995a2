//! The differences between controls: the presets and their switches.
//!
//! In: the choices of a setup. Out: a [`Dialect`] with a value for every switch. Each switch documents how
//! controls differ; the default is the first in its list. Must not know blocks.

use crate::units::{Diameter, Unit};
use serde::Deserialize;

/// A family of controls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum Control {
    /// FANUC 0i-T and related controls, G-code system A.
    #[default]
    Fanuc,
    /// GSK 980TD.
    Gsk,
    // Seed 003.
    /// A teaching dialect: FANUC with P and Q in millimetres.
    Forum,
}

impl Control {
    /// All presets, in menu order.
    pub const ALL: [Control; 3] = [Self::Fanuc, Self::Gsk, Self::Forum];

    /// Name in a setup and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fanuc => "fanuc",
            Self::Gsk => "gsk",
            Self::Forum => "forum",
        }
    }

    /// The largest sequence number: five digits, on GSK 980TD four.
    pub fn largest_sequence(self) -> u32 {
        match self {
            Self::Gsk => 9_999,
            Self::Fanuc | Self::Forum => 99_999,
        }
    }
}

/// Unit of the feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub enum FeedMode {
    /// Millimetres (inches) per minute.
    #[serde(rename = "G98")]
    PerMinute,
    /// Millimetres (inches) per revolution.
    #[serde(rename = "G99")]
    PerTurn,
}

impl FeedMode {
    /// Both units, in menu order.
    pub const ALL: [FeedMode; 2] = [Self::PerTurn, Self::PerMinute];

    /// Name in a setup: the code of system A.
    pub fn name(self) -> &'static str {
        match self {
            Self::PerMinute => "G98",
            Self::PerTurn => "G99",
        }
    }
}

/// G-code system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub enum GSystem {
    /// The single cycles are G90 G92 G94.
    #[default]
    A,
    /// The single cycles are G77 G78 G79.
    B,
    /// The single cycles are G20 G21 G24.
    C,
}

impl GSystem {
    /// All systems, in menu order.
    pub const ALL: [GSystem; 3] = [Self::A, Self::B, Self::C];

    /// Its letter.
    pub fn name(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
        }
    }
}

/// A list of G codes with their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CodeList {
    /// FANUC, G-code system A.
    #[default]
    A,
    /// FANUC, system B.
    B,
    /// FANUC, system C.
    C,
    /// GSK 980TD: like system A, with G33.
    Gsk,
}

impl CodeList {
    /// All lists, in the order of the table of supported codes.
    pub const ALL: [CodeList; 4] = [Self::A, Self::B, Self::C, Self::Gsk];

    /// The list of a control that is set to a G-code system.
    #[inline]
    pub fn new(control: Control, system: GSystem) -> Self {
        match (system, control) {
            (GSystem::A, Control::Gsk) => Self::Gsk,
            (GSystem::A, Control::Fanuc | Control::Forum) => Self::A,
            (GSystem::B, _) => Self::B,
            (GSystem::C, _) => Self::C,
        }
    }

    /// Its name, the same in all languages.
    pub fn name(self) -> &'static str {
        match self {
            Self::A => "FANUC A",
            Self::B => "FANUC B",
            Self::C => "FANUC C",
            Self::Gsk => "GSK",
        }
    }
}

/// How a setup interprets numbers without a decimal point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum DecimalChoice {
    /// Decided by the program.
    #[default]
    Auto,
    /// As whole units.
    Calculator,
    /// As least input increments.
    LeastIncrement,
}

impl DecimalChoice {
    /// All choices, in menu order.
    pub const ALL: [DecimalChoice; 3] = [Self::Auto, Self::Calculator, Self::LeastIncrement];

    /// Name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Calculator => "calculator",
            Self::LeastIncrement => "leastIncrement",
        }
    }

    /// The chosen rule; `None` for `Auto`.
    pub fn rule(self) -> Option<DecimalRule> {
        match self {
            Self::Auto => None,
            Self::Calculator => Some(DecimalRule::Calculator),
            Self::LeastIncrement => Some(DecimalRule::LeastIncrement),
        }
    }
}

/// The unit of a number without a decimal point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecimalRule {
    /// `X10` is 10 mm (FANUC parameter 3401#0 set).
    #[default]
    Calculator,
    /// `X10` is 0.010 mm (0.0010 inch).
    LeastIncrement,
}

impl From<DecimalRule> for DecimalChoice {
    fn from(rule: DecimalRule) -> Self {
        match rule {
            DecimalRule::Calculator => Self::Calculator,
            DecimalRule::LeastIncrement => Self::LeastIncrement,
        }
    }
}

/// Unit of P and Q in G74, G75 and G76.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum PqUnit {
    /// Micrometres, unless the numbers only make sense as millimetres.
    Auto,
    /// Micrometres.
    Um,
    /// Millimetres.
    Mm,
}

impl PqUnit {
    /// All choices, in menu order.
    pub const ALL: [PqUnit; 3] = [Self::Auto, Self::Um, Self::Mm];

    /// Name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Um => "um",
            Self::Mm => "mm",
        }
    }
}

/// Which of X and U is used if one block contains both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum XuConflict {
    /// The last one in the block (FANUC).
    Last,
    /// The absolute one (GSK).
    Absolute,
}

/// Effect of a negative R on an arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum NegativeArcR {
    /// The arc of more than 180°.
    Over180,
    /// An alarm (16/18-T).
    Alarm,
}

impl NegativeArcR {
    /// Both effects, in menu order.
    pub const ALL: [NegativeArcR; 2] = [Self::Over180, Self::Alarm];

    /// Name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Over180 => "over180",
            Self::Alarm => "alarm",
        }
    }
}

/// Motion of the 45° retract of G71.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum G71Retract {
    /// Rapid (FANUC).
    Rapid,
    /// At feed (GSK).
    Feed,
}

/// Number of steps into which G73 divides its total relief.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub enum G73Intervals {
    /// One less than the number of passes.
    #[serde(rename = "d-1")]
    OneFewer,
    /// The number of passes.
    #[serde(rename = "d")]
    Same,
}

/// How G76 applies its minimum depth of cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum G76Clamp {
    /// To the difference from the previous depth.
    Prev,
    /// To the square root formula.
    Sqrt,
}

/// Meaning of the letter I in G92.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum IInG92 {
    /// The taper, an older spelling of R (FANUC).
    Taper,
    /// Threads per inch (GSK).
    Tpi,
}

/// Whether X in polar interpolation is a diameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "camelCase")]
pub enum PolarX {
    /// A diameter (0i-T).
    Diameter,
    /// A radius (15i).
    Radius,
}

/// Default first reference point, machine coordinates.
pub const USUAL_REF_POINT: super::Position = super::Position { x: Diameter::new(300.0), z: 300.0 };

/// The switches of a setup; a missing one has the default of the control.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(rename = "Dialect"))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct DialectChoice {
    /// Preset of all other switches; FANUC by default.
    pub control: Option<Control>,
    /// G-code system.
    pub g_system: Option<GSystem>,
    /// Unit until a G20 or G21.
    pub unit: Option<Unit>,
    /// Numbers without a decimal point.
    pub decimal: Option<DecimalChoice>,
    /// Unit of P and Q.
    pub pq_unit: Option<PqUnit>,
    /// Feed unit after power-on.
    pub power_on_feed: Option<FeedMode>,
    /// Feed unit at the start of this program; overrides `powerOnFeed`.
    pub feed_mode: Option<FeedMode>,
    /// X with U, Z with W.
    pub xu_conflict: Option<XuConflict>,
    /// Negative arc R.
    pub negative_arc_r: Option<NegativeArcR>,
    /// Retract of G71.
    pub g71_retract: Option<G71Retract>,
    /// Steps of G73.
    pub g73_intervals: Option<G73Intervals>,
    /// Minimum depth of G76.
    pub g76_clamp: Option<G76Clamp>,
    /// Relief of G74 and G75 in the first column too.
    pub relief_first: Option<bool>,
    /// I in G92.
    #[serde(rename = "iInG92")]
    pub i_in_g92: Option<IInG92>,
    /// Thread pull-out at the start, tenths of a lead, 0 to 99.
    pub thread_chamfer: Option<u8>,
    /// Pockets in G71 and G72.
    #[serde(rename = "typeII")]
    pub type_ii: Option<bool>,
    /// Real alarms instead of warnings.
    pub strict: Option<bool>,
    /// X in polar interpolation.
    pub polar_x: Option<PolarX>,
    /// First reference point, machine coordinates.
    pub ref_point: Option<super::Position>,
    /// Whether programs for other controls and machines are recognised, and then not run; true by default.
    pub recognise: Option<bool>,
}

/// The switches with a value for each.
#[derive(Clone, Debug, PartialEq)]
pub struct Dialect {
    /// The preset.
    pub control: Control,
    /// G-code system.
    pub g_system: GSystem,
    /// Unit until a G20 or G21.
    pub unit: Unit,
    /// Numbers without a decimal point.
    pub decimal: DecimalRule,
    /// Unit of P and Q.
    pub pq_unit: PqUnit,
    /// Feed unit at the start.
    pub feed_mode: FeedMode,
    /// X with U, Z with W.
    pub xu_conflict: XuConflict,
    /// Negative arc R.
    pub negative_arc_r: NegativeArcR,
    /// Retract of G71.
    pub g71_retract: G71Retract,
    /// Steps of G73.
    pub g73_intervals: G73Intervals,
    /// Minimum depth of G76.
    pub g76_clamp: G76Clamp,
    /// Relief of G74 and G75 in the first column too.
    pub relief_first: bool,
    /// I in G92.
    pub i_in_g92: IInG92,
    /// Thread pull-out at the start, tenths of a lead.
    pub thread_chamfer: u8,
    /// Pockets in G71 and G72.
    pub type_ii: bool,
    /// Real alarms instead of warnings.
    pub strict: bool,
    /// X in polar interpolation.
    pub polar_x: PolarX,
    /// First reference point, machine coordinates; X is a diameter.
    pub ref_point: super::Position,
    /// Whether the setup gives the reference point.
    pub ref_point_given: bool,
}

impl Dialect {
    /// The list of its G codes.
    #[inline]
    pub fn code_list(&self) -> CodeList {
        CodeList::new(self.control, self.g_system)
    }

    /// Fills in missing switches with the defaults of the control. `DecimalChoice::Auto` becomes whole units:
    /// a run replaces it by its decision beforehand.
    pub fn new(choice: &DialectChoice) -> Self {
        let control = choice.control.unwrap_or_default();
        let gsk = control == Control::Gsk;
        let power_on = match control {
            Control::Fanuc => FeedMode::PerTurn,
            Control::Gsk | Control::Forum => FeedMode::PerMinute,
        };
        Self {
            control,
            g_system: choice.g_system.unwrap_or(GSystem::A),
            unit: choice.unit.unwrap_or_default(),
            decimal: choice.decimal.unwrap_or_default().rule().unwrap_or_default(),
            pq_unit: choice.pq_unit.unwrap_or(PqUnit::Auto),
            feed_mode: choice.feed_mode.or(choice.power_on_feed).unwrap_or(power_on),
            xu_conflict: choice.xu_conflict.unwrap_or(if gsk {
                XuConflict::Absolute
            } else {
                XuConflict::Last
            }),
            negative_arc_r: choice.negative_arc_r.unwrap_or(NegativeArcR::Over180),
            g71_retract: choice.g71_retract.unwrap_or(if gsk { G71Retract::Feed } else { G71Retract::Rapid }),
            g73_intervals: choice.g73_intervals.unwrap_or(G73Intervals::OneFewer),
            g76_clamp: choice.g76_clamp.unwrap_or(G76Clamp::Prev),
            relief_first: choice.relief_first.unwrap_or(true),
            i_in_g92: choice.i_in_g92.unwrap_or(if gsk { IInG92::Tpi } else { IInG92::Taper }),
            thread_chamfer: choice.thread_chamfer.unwrap_or(0).min(99),
            type_ii: choice.type_ii.unwrap_or(true),
            strict: choice.strict.unwrap_or(false),
            polar_x: choice.polar_x.unwrap_or(PolarX::Diameter),
            ref_point_given: choice.ref_point.is_some(),
            ref_point: choice.ref_point.unwrap_or(USUAL_REF_POINT),
        }
    }
}
