//! The values of a setup: their keys in JSON and in setup comments, their units and positions.
//!
//! One list for everything that reads and writes setups: the comments (`notes`, `as_comments`), the form
//! (`draft`), the table of the reference. Must not know which values are valid: that is `invalid`.

use super::{Machine, Position, Side, Stock, Tailstock, Tool, ToolKind, Turret};
use crate::message::{Group, Levels, Severity};
use crate::setup::dialect::{
    Control, DecimalChoice, DialectChoice, FeedMode, GSystem, NegativeArcR, PqUnit, USUAL_REF_POINT,
};
use crate::units::{self, Diameter};
use Entry::{Choice, Number, Switch, Text, Whole};

/// The value of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A measure in the unit of its field, or a whole number.
    Number(f64),
    /// A designation, or one of the choices.
    Text(String),
    /// Whether a switch is on.
    Switch(bool),
}

/// The kind of value that a field accepts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// A measure.
    Number(Unit),
    /// A whole number from 0 to 255.
    Whole,
    /// A designation: letters, digits, points and dashes.
    Text,
    /// One of these choices.
    Choice(&'static [&'static str]),
    /// `true` or `false`.
    Switch,
}

/// The values of a switch.
pub const SWITCH: &[&str] = &["true", "false"];

/// The unit of a measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    Millimetre,
    /// Degrees.
    Degree,
    /// Millimetres per minute.
    MillimetrePerMinute,
    /// Spindle speed, rpm.
    TurnsPerMinute,
}

/// The meaning of a field; `sentences::labels` has its name in each language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the labels say it")]
pub enum Name {
    StockDiameter,
    Bore,
    Length,
    Face,
    Grip,
    Outline,
    Kind,
    Side,
    Insert,
    NoseRadius,
    Tip,
    EnteringAngle,
    PointAngle,
    EdgeLength,
    Width,
    ToolDiameter,
    Reach,
    Shank,
    Angle,
    ToolRadius,
    GeometryX,
    GeometryZ,
    GeometryR,
    WearX,
    WearZ,
    WearR,
    StartX,
    StartZ,
    CenterZ,
    QuillDiameter,
    RapidX,
    RapidZ,
    MaxSpeed,
    ThreadSpeedMargin,
    LeastX,
    GreatestX,
    LeastZ,
    GreatestZ,
    Turret,
    YAxis,
    Classroom,
    Control,
    GSystem,
    Unit,
    FeedMode,
    Decimal,
    PqUnit,
    RefPointX,
    RefPointZ,
    Recognise,
    Strict,
    Pockets,
    NegativeArcR,
}

/// Why an entry cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// Not a number.
    NotANumber,
    /// Not a whole number from 0 to 255.
    NotWhole,
    /// Not one of the accepted words.
    NotKnown,
    /// Not the points of an outline.
    NotAnOutline,
}

/// A field of a `T`.
pub struct Field<T: 'static> {
    /// Its meaning.
    pub name: Name,
    /// Its key in JSON; `travel.xMin` is in an object `travel`.
    pub key: &'static str,
    /// Its word in a setup comment.
    pub word: &'static str,
    /// The values that it accepts.
    pub entry: Entry,
    /// For a tool: the kinds that use the field; empty for all kinds.
    pub kinds: &'static [ToolKind],
    /// Returns the value, or `None` if it is the default.
    pub get: fn(&T) -> Option<Value>,
    /// Sets the value. A value that does not fit the entry is ignored.
    pub set: fn(&mut T, &Value),
}

/// The functions `get` and `set` of a field.
type Access<T> = (fn(&T) -> Option<Value>, fn(&mut T, &Value));

const fn field<T>(
    name: Name,
    key: &'static str,
    word: &'static str,
    entry: Entry,
    access: Access<T>,
) -> Field<T> {
    Field { name, key, word, entry, kinds: &[], get: access.0, set: access.1 }
}

/// A field of a tool.
const fn tool(
    name: Name,
    key: &'static str,
    word: &'static str,
    entry: Entry,
    access: Access<Tool>,
) -> Field<Tool> {
    field(name, key, word, entry, access)
}

impl<T> Field<T> {
    const fn of(mut self, kinds: &'static [ToolKind]) -> Self {
        self.kinds = kinds;
        self
    }

    /// Whether a kind of tool uses the field.
    pub fn is_for(&self, kind: ToolKind) -> bool {
        self.kinds.is_empty() || self.kinds.contains(&kind)
    }
}

/// A value that is written as one number.
trait Measured {
    fn number(self) -> f64;
    fn from_number(number: f64) -> Self;
}

impl Measured for f64 {
    fn number(self) -> f64 {
        self
    }

    fn from_number(number: f64) -> Self {
        number
    }
}

impl Measured for Diameter {
    fn number(self) -> f64 {
        self.mm()
    }

    fn from_number(number: f64) -> Self {
        Self::new(number)
    }
}

/// An optional measure.
macro_rules! measure {
    ($($path:ident).+) => {
        (|own| own.$($path).+.map(|own| Value::Number(own.number())), |own, value| {
            if let Value::Number(number) = value {
                own.$($path).+ = Some(Measured::from_number(*number));
            }
        })
    };
}

/// A measure that is always present, and not written if it has its default.
macro_rules! always {
    ($path:ident unless $usual:expr) => {
        (
            |own| Some(own.$path.number()).filter(|own| *own != $usual).map(Value::Number),
            |own, value| {
                if let Value::Number(number) = value {
                    own.$path = Measured::from_number(*number);
                }
            },
        )
    };
}

/// A value with a name.
macro_rules! named {
    ($path:ident among $type:ty) => {
        (
            |own| own.$path.map(|value| Value::Text(value.name().into())),
            |own, value| {
                if let Value::Text(text) = value {
                    own.$path = <$type>::ALL.into_iter().find(|value| value.name() == text).or(own.$path);
                }
            },
        )
    };
}

/// An optional switch.
macro_rules! switch {
    ($path:ident) => {
        (
            |own| own.$path.map(Value::Switch),
            |own, value| {
                if let Value::Switch(is_on) = value {
                    own.$path = Some(*is_on);
                }
            },
        )
    };
}

/// An axis of the reference point; the other axis has its default if it is missing.
macro_rules! reference {
    ($axis:ident) => {
        (
            |own| own.ref_point.map(|point| Value::Number(point.$axis.number())),
            |own, value| {
                if let Value::Number(number) = value {
                    own.ref_point.get_or_insert(USUAL_REF_POINT).$axis = Measured::from_number(*number);
                }
            },
        )
    };
}

const MM: Entry = Number(Unit::Millimetre);
const DEGREES: Entry = Number(Unit::Degree);
const MM_A_MINUTE: Entry = Number(Unit::MillimetrePerMinute);

const ANGLED: &[ToolKind] = &[ToolKind::Turning, ToolKind::Boring];
const INSERTS: &[ToolKind] = &[ToolKind::Turning, ToolKind::Boring, ToolKind::Threading];
const SIDED: &[ToolKind] = &[ToolKind::Grooving, ToolKind::Threading];
const RADIUSED: &[ToolKind] =
    &[ToolKind::Turning, ToolKind::Boring, ToolKind::Grooving, ToolKind::Threading, ToolKind::Endmill];
const POINTED: &[ToolKind] = &[ToolKind::Turning, ToolKind::Boring, ToolKind::Grooving, ToolKind::Threading];

const GRIP: Field<Stock> = field(Name::Grip, "grip", "GRIP", MM, measure!(grip));

/// A bar or a tube: `(STOCK D=65 LENGTH=80)`.
pub const STOCK: &[Field<Stock>] = &[
    // Always written: a missing size is 0 and reported as invalid.
    field(Name::StockDiameter, "diameter", "D", MM, always!(diameter unless f64::INFINITY)),
    field(Name::Bore, "bore", "BORE", MM, always!(bore unless 0.0)),
    field(Name::Length, "length", "LENGTH", MM, always!(length unless f64::INFINITY)),
    field(Name::Face, "face", "FACE", MM, always!(face unless 0.0)),
    GRIP,
];

/// The other fields of a blank with an outline, whose sizes follow from its points.
pub const OUTLINED: &[Field<Stock>] = &[GRIP];

/// Key of the outline in a stock. It has no field, because its value is a list.
pub const OUTLINE: &str = "outline";

/// A tool: `(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)`.
pub const TOOL: &[Field<Tool>] = &[
    tool(
        Name::Kind,
        "type",
        "TYPE",
        Choice(&["turning", "boring", "grooving", "threading", "drill", "tap", "endmill"]),
        named!(kind among ToolKind),
    ),
    tool(Name::Side, "side", "SIDE", Choice(&["outside", "inside", "face"]), named!(side among Side))
        .of(SIDED),
    tool(
        Name::Insert,
        "insert",
        "INSERT",
        Text,
        (
            |own: &Tool| own.insert.clone().map(Value::Text),
            |own, value| {
                if let Value::Text(text) = value {
                    own.insert = Some(text.clone());
                }
            },
        ),
    )
    .of(INSERTS),
    tool(Name::NoseRadius, "noseRadius", "R", MM, measure!(nose_radius)).of(POINTED),
    tool(
        Name::Tip,
        "tip",
        "TIP",
        Whole,
        (
            |own: &Tool| own.tip.map(|tip| Value::Number(f64::from(tip))),
            |own, value| {
                if let Value::Number(number) = value {
                    own.tip = Some(*number as u8);
                }
            },
        ),
    )
    .of(POINTED),
    tool(Name::EnteringAngle, "enteringAngle", "KR", DEGREES, measure!(entering_angle)).of(ANGLED),
    tool(Name::PointAngle, "pointAngle", "POINT", DEGREES, measure!(point_angle)).of(ANGLED),
    tool(Name::EdgeLength, "edgeLength", "EDGE", MM, measure!(edge_length)).of(INSERTS),
    tool(Name::Width, "width", "WIDTH", MM, measure!(width)).of(&[ToolKind::Grooving]),
    tool(Name::ToolDiameter, "diameter", "D", MM, measure!(diameter)).of(&[
        ToolKind::Drill,
        ToolKind::Tap,
        ToolKind::Endmill,
    ]),
    tool(Name::Reach, "reach", "REACH", MM, measure!(reach)).of(&[
        ToolKind::Boring,
        ToolKind::Grooving,
        ToolKind::Threading,
        ToolKind::Drill,
        ToolKind::Tap,
    ]),
    tool(Name::Shank, "shank", "SHANK", MM, measure!(shank)).of(&[ToolKind::Boring]),
    tool(Name::Angle, "angle", "ANGLE", DEGREES, measure!(angle)).of(&[ToolKind::Threading, ToolKind::Drill]),
    tool(Name::ToolRadius, "toolRadius", "CUTTER", MM, measure!(tool_radius)).of(&[ToolKind::Endmill]),
    tool(Name::GeometryX, "geometryX", "OFFSETX", MM, measure!(geometry_x)),
    tool(Name::GeometryZ, "geometryZ", "OFFSETZ", MM, measure!(geometry_z)),
    tool(Name::GeometryR, "geometryR", "OFFSETR", MM, measure!(geometry_r)).of(RADIUSED),
    tool(Name::WearX, "wearX", "WEARX", MM, measure!(wear_x)),
    tool(Name::WearZ, "wearZ", "WEARZ", MM, measure!(wear_z)),
    tool(Name::WearR, "wearR", "WEARR", MM, measure!(wear_r)).of(RADIUSED),
];

/// Position of the tip before the first block: `(START X=200 Z=200)`.
pub const START: &[Field<Position>] = &[
    field(Name::StartX, "x", "X", MM, always!(x unless f64::INFINITY)),
    field(Name::StartZ, "z", "Z", MM, always!(z unless f64::INFINITY)),
];

/// The tailstock: `(TAILSTOCK Z=2 D=20)`.
pub const TAILSTOCK: &[Field<Tailstock>] = &[
    field(Name::CenterZ, "z", "Z", MM, always!(z unless f64::INFINITY)),
    field(Name::QuillDiameter, "diameter", "D", MM, always!(diameter unless f64::INFINITY)),
];

/// The machine: `(MACHINE RAPIDX=8000 TURRET=FRONT)`.
pub const MACHINE: &[Field<Machine>] = &[
    field(Name::RapidX, "rapidX", "RAPIDX", MM_A_MINUTE, measure!(rapid_x)),
    field(Name::RapidZ, "rapidZ", "RAPIDZ", MM_A_MINUTE, measure!(rapid_z)),
    field(Name::MaxSpeed, "maxSpeed", "MAXSPEED", Number(Unit::TurnsPerMinute), measure!(max_speed)),
    field(
        Name::ThreadSpeedMargin,
        "threadSpeedMargin",
        "THREADK",
        Number(Unit::TurnsPerMinute),
        measure!(thread_speed_margin),
    ),
    field(Name::LeastX, "travel.xMin", "XMIN", MM, measure!(travel.x_min)),
    field(Name::GreatestX, "travel.xMax", "XMAX", MM, measure!(travel.x_max)),
    field(Name::LeastZ, "travel.zMin", "ZMIN", MM, measure!(travel.z_min)),
    field(Name::GreatestZ, "travel.zMax", "ZMAX", MM, measure!(travel.z_max)),
    field(
        Name::Turret,
        "turret",
        "TURRET",
        Choice(&["rear", "front"]),
        (
            |own: &Machine| (own.turret == Turret::Front).then(|| Value::Text("front".into())),
            |own, value| {
                if let Value::Text(text) = value {
                    own.turret = if text == "front" { Turret::Front } else { Turret::Rear };
                }
            },
        ),
    ),
    field(Name::YAxis, "yAxis", "YAXIS", Switch, switch!(y_axis)),
];

/// Groups of rules: `(RULES CLASSROOM=WARNING)`. Single rules have no fields: there are too many.
pub const RULES: &[Field<Levels>] = &[field(
    Name::Classroom,
    Group::Classroom.name(),
    "CLASSROOM",
    Choice(&["off", "info", "warning", "error"]),
    (
        |own: &Levels| own.get(Group::Classroom.name()).map(|level| Value::Text(level.name().into())),
        |own, value| {
            if let Value::Text(text) = value
                && let Some(level) = Severity::named(text)
            {
                own.set(Group::Classroom.name(), level);
            }
        },
    ),
)];

/// The control, and the switches that a message or the page refers to: `(DIALECT DECIMAL=LEASTINCREMENT)`.
/// The other switches have no fields.
pub const DIALECT: &[Field<DialectChoice>] = &[
    field(
        Name::Control,
        "control",
        "CONTROL",
        Choice(&["fanuc", "gsk", "forum"]),
        named!(control among Control),
    ),
    field(Name::GSystem, "gSystem", "GSYSTEM", Choice(&["A", "B", "C"]), named!(g_system among GSystem)),
    field(Name::Unit, "unit", "UNIT", Choice(&["mm", "inch"]), named!(unit among units::Unit)),
    field(Name::FeedMode, "feedMode", "FEEDMODE", Choice(&["G99", "G98"]), named!(feed_mode among FeedMode)),
    field(
        Name::Decimal,
        "decimal",
        "DECIMAL",
        Choice(&["auto", "calculator", "leastIncrement"]),
        named!(decimal among DecimalChoice),
    ),
    field(Name::PqUnit, "pqUnit", "PQUNIT", Choice(&["auto", "um", "mm"]), named!(pq_unit among PqUnit)),
    field(Name::RefPointX, "refPoint.x", "REFX", MM, reference!(x)),
    field(Name::RefPointZ, "refPoint.z", "REFZ", MM, reference!(z)),
    field(Name::Recognise, "recognise", "RECOGNISE", Switch, switch!(recognise)),
    field(Name::Strict, "strict", "STRICT", Switch, switch!(strict)),
    field(Name::Pockets, "typeII", "TYPEII", Switch, switch!(type_ii)),
    field(
        Name::NegativeArcR,
        "negativeArcR",
        "NEGATIVEARCR",
        Choice(&["over180", "alarm"]),
        named!(negative_arc_r among NegativeArcR),
    ),
];

impl Entry {
    /// Parses a value; not case-sensitive.
    pub fn read(self, text: &str) -> Result<Value, ReadError> {
        let text = text.trim();
        match self {
            Number(_) => {
                // Many languages use a decimal comma.
                let number = crate::units::read_number(&text.replace(',', ".").replace('−', "-"));
                let number = number.filter(|number| number.is_finite());
                number.map(Value::Number).ok_or(ReadError::NotANumber)
            }
            Whole => text.parse::<u8>().map(|whole| Value::Number(whole.into())).or(Err(ReadError::NotWhole)),
            Text => {
                let designation: String = text.chars().filter(|c| !c.is_whitespace()).collect();
                let is_one = designation
                    .bytes()
                    .all(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'.'));
                if is_one && !designation.is_empty() {
                    Ok(Value::Text(designation))
                } else {
                    Err(ReadError::NotKnown)
                }
            }
            Switch => {
                let found = SWITCH.iter().find(|choice| choice.eq_ignore_ascii_case(text));
                found.map(|choice| Value::Switch(*choice == "true")).ok_or(ReadError::NotKnown)
            }
            Choice(choices) => {
                let found = choices.iter().find(|choice| choice.eq_ignore_ascii_case(text));
                found.map(|choice| Value::Text((*choice).into())).ok_or(ReadError::NotKnown)
            }
        }
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => f.write_str(text),
            Self::Switch(is_on) => write!(f, "{is_on}"),
        }
    }
}

/// The values of a `T` that are set, each with its field.
pub fn values<'a, T>(
    fields: &'a [Field<T>],
    own: &'a T,
) -> impl Iterator<Item = (&'a Field<T>, Value)> + use<'a, T> {
    fields.iter().filter_map(move |field| Some((field, (field.get)(own)?)))
}

/// Overwrites the values of `own` by those set in `other`.
pub fn over<T>(fields: &[Field<T>], mut own: T, other: &T) -> T {
    for (field, value) in values(fields, other) {
        (field.set)(&mut own, &value);
    }
    own
}

/// The values of a page that are overridden by those in `written`.
pub fn covered<T: Default>(fields: &[Field<T>], written: &T, page: &T) -> T {
    let mut own = T::default();
    for field in fields.iter().filter(|field| (field.get)(written).is_some()) {
        if let Some(value) = (field.get)(page) {
            (field.set)(&mut own, &value);
        }
    }
    own
}
