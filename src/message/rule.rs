//! Rules: what all messages of one fault have in common.
//!
//! In: nothing. Out: the types of the table [`RULES`](super::RULES), which is made
//! from `src/rules/<slug>.md`.

/// The severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Reported only where somebody asks for it (`levels`).
    Off,
    /// Good to know.
    Info,
    /// The program runs, but perhaps not as meant.
    Warning,
    /// The block is not carried out.
    Error,
}

impl Severity {
    /// All of them, the lowest first.
    pub const ALL: [Self; 4] = [Self::Off, Self::Info, Self::Warning, Self::Error];

    /// The one of a name, written in any case.
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

/// Its category.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The program is wrong, or likely so.
    Wrong,
    /// The program may be right; the playground does not do this.
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

/// Rules that are set by one name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// What a teacher looks for and a control does not mind.
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

/// A rule: what all messages of one slug have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    /// Stable name of the fault.
    pub slug: &'static str,
    /// The codes of its messages; mostly one.
    pub codes: &'static [&'static str],
    /// How severe it usually is.
    pub severity: Severity,
    /// Its category.
    pub kind: Kind,
    /// The alarms a control raises for it; mostly one or none.
    pub alarms: &'static [&'static str],
    /// The group it belongs to.
    pub group: Option<Group>,
}
