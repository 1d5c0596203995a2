//! Rules: the common properties of all messages about one fault.
//!
//! In: nothing. Out: the types of the table [`RULES`](super::RULES), which the build script generates from
//! `src/rules/<slug>.md`.

/// The severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Reported only if requested (`levels`).
    Off,
    /// Information.
    Info,
    /// The program runs, but perhaps not as intended.
    Warning,
    /// The block is not executed.
    Error,
}

impl Severity {
    /// All severities, the lowest first.
    pub const ALL: [Self; 4] = [Self::Off, Self::Info, Self::Warning, Self::Error];

    /// Finds a severity by name; case-insensitive.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|severity| severity.name().eq_ignore_ascii_case(name))
    }

    /// Name in the output of the command line and in the wasm interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// Category of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The program is wrong, or probably wrong.
    Wrong,
    /// The program may be correct, but the playground does not support it.
    Unsupported,
    /// It depends on the machine.
    Machine,
}

impl Kind {
    /// Name in the wasm interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wrong => "wrong",
            Self::Unsupported => "unsupported",
            Self::Machine => "machine",
        }
    }
}

/// A group of rules that can be set by one name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Rules for teaching; a control ignores these problems.
    Classroom,
}

impl Group {
    /// All groups.
    pub const ALL: [Self; 1] = [Self::Classroom];

    /// Its name in a setup.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Classroom => "classroom",
        }
    }
}

/// A rule: the common properties of all messages with one slug.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    /// Stable name of the fault.
    pub slug: &'static str,
    /// The codes of its messages; usually one.
    pub codes: &'static [&'static str],
    /// Default severity.
    pub severity: Severity,
    /// Category.
    pub kind: Kind,
    /// The alarms that a control raises; usually one or none.
    pub alarms: &'static [&'static str],
    /// The group of the rule, if any.
    pub group: Option<Group>,
}
