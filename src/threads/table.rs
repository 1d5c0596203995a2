//! The tables of the thread standards, one file for each.
//!
//! In: `*.tsv`; a line that begins with `# ` is a comment, the first one names the standards. Out: a [`Row`]
//! for each thread. Does not know how a name is written.

use crate::units::read_number;

/// Millimetres in an inch.
const INCH: f64 = 25.4;

/// A thread standard, in the order of suggestions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standard {
    /// M: ISO metric threads.
    Metric,
    /// UNC, UNF, UNEF, 8-UN: Unified inch threads.
    Unified,
    /// G: cylindrical pipe threads.
    Pipe,
    /// NPT: American taper pipe threads.
    TaperPipe,
    /// Tr: ISO metric trapezoidal threads.
    Trapezoidal,
}

/// A thread of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Row {
    /// Designation of the thread with one start.
    pub designation: &'static str,
    /// Major diameter, mm. NPT: outside diameter of the pipe.
    pub major: f64,
    /// Pitch, mm.
    pub pitch: f64,
    pub profile: Profile,
}

/// Profile of a thread, with the dimensions that do not follow from diameter and pitch, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Profile {
    Metric,
    Unified,
    Pipe {
        /// Minor diameter.
        minor: f64,
    },
    TaperPipe {
        /// Length of hand-tight engagement, L1.
        engagement: f64,
    },
    Trapezoidal {
        /// Crest clearance, a_c.
        clearance: f64,
    },
}

impl Standard {
    /// All standards.
    pub const ALL: [Self; 5] = [Self::Metric, Self::Unified, Self::Pipe, Self::TaperPipe, Self::Trapezoidal];

    /// The standards that the dimensions are taken from, such as `ISO 228-1`.
    pub fn source(self) -> &'static str {
        self.text().lines().find_map(comment).unwrap_or_default()
    }

    /// The threads of the table.
    pub(super) fn rows(self) -> impl Iterator<Item = Row> {
        self.lines().filter_map(move |line| self.row(line))
    }

    /// The lines that contain a thread.
    pub(super) fn lines(self) -> impl Iterator<Item = &'static str> {
        self.text().lines().filter(|line| comment(line).is_none())
    }

    fn text(self) -> &'static str {
        match self {
            Self::Metric => include_str!("metric.tsv"),
            Self::Unified => include_str!("unified.tsv"),
            Self::Pipe => include_str!("pipe.tsv"),
            Self::TaperPipe => include_str!("taper_pipe.tsv"),
            Self::Trapezoidal => include_str!("trapezoidal.tsv"),
        }
    }

    fn row(self, line: &'static str) -> Option<Row> {
        let mut columns = line.split('\t');
        let designation = columns.next()?;
        let mut number = || columns.next().and_then(read_number);
        let (major, pitch, profile) = match self {
            Self::Metric => (number()?, number()?, Profile::Metric),
            Self::Unified => (INCH * number()?, INCH / number()?, Profile::Unified),
            Self::Pipe => (number()?, INCH / number()?, Profile::Pipe { minor: number()? }),
            Self::TaperPipe => {
                (INCH * number()?, INCH / number()?, Profile::TaperPipe { engagement: INCH * number()? })
            }
            Self::Trapezoidal => (number()?, number()?, Profile::Trapezoidal { clearance: number()? }),
        };
        columns.next().is_none().then_some(Row { designation, major, pitch, profile })
    }
}

/// The text of a comment. `#10-24 UNC` is a thread.
fn comment(line: &str) -> Option<&str> {
    line.strip_prefix("# ")
}
