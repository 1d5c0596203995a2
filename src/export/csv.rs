//! All motions as a table for spreadsheets: comma-separated values (RFC 4180).
//!
//! In: the rows of `motions`. Out: a header line with the names of the columns, and one line per row. Missing
//! values are empty.

use std::fmt::Write;

use crate::api;
use crate::motion::Motions;
use crate::setup::Machine;

/// The columns, named as in the rows of `motions`; names of nested properties are prefixed with the name of
/// the outer one.
pub const COLUMNS: [&str; 26] = [
    "line",
    "kind",
    "tool",
    "x",
    "z",
    "c",
    "center_x",
    "center_z",
    "center_c",
    "r",
    "dir",
    "lead",
    "start_angle",
    "seconds",
    "feed",
    "rpm",
    "cycle",
    "pass",
    "step",
    "frame",
    "offset_x",
    "offset_z",
    "mode",
    "machine_x",
    "machine_c",
    "uncertain",
];

/// Writes the table: X as a diameter, lengths in mm, angles in degrees, feed in mm/min. `x`, `z` and the
/// centre are workpiece coordinates: the programmed ones plus the offset of the row.
pub fn csv(motions: &Motions, machine: &Machine) -> String {
    let mut text = COLUMNS.join(",");
    text.push_str("\r\n");
    let rows = api::motions(motions, machine).zip(motions.on_workpiece());
    for (row, on_workpiece) in rows {
        let placed = api::motion(&on_workpiece, row.line, machine);
        write_row(
            &mut text,
            &api::Motion { to: placed.to, center: placed.center, machine: placed.machine, ..row },
        );
    }
    text
}

fn write_row(text: &mut String, row: &api::Motion) {
    let number = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    let word = |value: Option<&str>| value.unwrap_or_default().to_owned();
    let center = row.center.as_ref();
    let cells: [String; COLUMNS.len()] = [
        row.line.to_string(),
        row.kind.to_owned(),
        word(row.tool.as_deref()),
        row.to.x.mm().to_string(),
        row.to.z.to_string(),
        number(row.to.c),
        number(center.map(|center| center.x.mm())),
        number(center.map(|center| center.z)),
        number(center.and_then(|center| center.c)),
        number(row.r),
        word(row.dir),
        number(row.lead),
        number(row.start_angle),
        number(row.seconds),
        number(row.feed),
        number(row.rpm),
        word(row.cycle),
        row.pass.map(|pass| pass.to_string()).unwrap_or_default(),
        word(row.step),
        word(row.frame.as_deref()),
        number(row.offset.map(|offset| offset.x.mm())),
        number(row.offset.map(|offset| offset.z)),
        word(row.mode),
        number(row.machine.map(|place| place.x.mm())),
        number(row.machine.map(|place| place.c)),
        word(row.uncertain.then_some("uncertain")),
    ];
    // No cell contains a comma, a quote or a line end, so nothing is quoted.
    let _ = write!(text, "{}\r\n", cells.join(","));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::setup::Setup;

    #[test]
    fn a_line_for_each_motion() {
        let analysis = analyze(b"G0 X20 Z2 T0101\nG1 Z-5 F0.2 M3 S1000\nG2 X30 Z-10 R5", &Setup::default());
        let text = csv(&analysis.motions, &analysis.setup.machine);
        let lines: Vec<&str> = text.split_terminator("\r\n").collect();
        assert_eq!(lines.len(), 4);
        assert_eq!(lines[0], COLUMNS.join(","));
        assert!(lines.iter().all(|line| line.split(',').count() == COLUMNS.len()), "{text}");
        assert_eq!(lines[2], "2,feed,T0101,20,-5,,,,,,,,,2.1,200,1000,,,,,,,,,,");
        assert!(lines[3].starts_with("3,arc,T0101,30,-10,,30,-5,,5,cw,"), "{text}");
    }
}
