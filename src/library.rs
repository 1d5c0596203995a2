//! The three main functions of the library: check a program, list its motions, and apply all safe fixes.
//!
//! In: a text and a setup. Out: rows as in the command line and the package for Node, with X as a diameter; a
//! text. Must not know: how the results are computed.

use crate::api::{self, Diagnostic, Motion, Places};
use crate::repair::{Repaired, repaired};
use crate::run::analyze;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::source::LineIndex;

/// Checks a program, and returns the same findings as `gcode-playground check`, in text order. They include
/// collisions if the setup or the program defines a blank or a machine.
///
/// Never fails: faults in the program are findings.
///
/// ```
/// use gcode_playground::{check, sentences::Language, setup::Setup};
///
/// let found = check(b"M03 S500\nG00 X50 Z2\nG01 Z-30 F0.1\nG01 X\nM30\n", &Setup::default(), Language::English);
/// assert_eq!((found[0].line, found[0].column, &*found[0].slug, &*found[0].severity), (4, 5, "number-missing", "error"));
///
/// let rapid = b"(STOCK D=50 LENGTH=80)\nT0101\nM03 S500\nG00 X46 Z2\nG00 Z-30\nG00 X100 Z100\nM30\n";
/// assert!(check(rapid, &Setup::default(), Language::English).iter().any(|found| found.slug == "rapid-through-stock"));
/// ```
pub fn check(text: &[u8], setup: &Setup, language: Language) -> Vec<Diagnostic> {
    let mut analysis = analyze(text, setup);
    analysis.check_at_machine();
    let places = Places { text, lines: &LineIndex::as_written(text) };
    analysis.diagnostics.iter().map(|found| places.diagnostic(found, language)).collect()
}

/// All motions of a program, in order. Lengths are in mm, X is a diameter.
///
/// ```
/// use gcode_playground::{motions, setup::Setup};
///
/// let setup = Setup::from_json(r#"{"initial": {"x": 52, "z": 2}}"#).expect("a setup");
/// let made = motions(b"G90 X40 Z-20 F0.2\nM30\n", &setup);
/// assert!(made.iter().map(|motion| motion.kind).eq(["rapid", "feed", "feed", "rapid"]));
/// assert_eq!((made[1].to.x.mm(), made[1].to.z, made[1].line), (40.0, -20.0, 1));
/// ```
pub fn motions(text: &[u8], setup: &Setup) -> Vec<Motion> {
    let analysis = analyze(text, setup);
    api::motions(&analysis.motions, &analysis.setup.machine).collect()
}

/// Applies all safe fixes, which do not change what the program does, like `gcode-playground check --fix`.
/// Returns the new text and the applied fixes. All other bytes are unchanged.
///
/// ```
/// use gcode_playground::{repair, setup::Setup};
///
/// let repaired = repair(b"GO1 X50 Z-2 F0.1 (FACE\nM30\n", &Setup::default());
/// assert_eq!(repaired.text, b"G01 X50 Z-2 F0.1 (FACE)\nM30\n");
/// assert_eq!(repaired.taken.len(), 2);
/// ```
pub fn repair(text: &[u8], setup: &Setup) -> Repaired {
    repaired(text, setup)
}
