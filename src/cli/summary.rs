//! `summary`: a table of the work of each tool.
//!
//! In: an analysed program. Out: text or JSON: a row for each tool, and one for the whole program.

use std::io::{self, Write};

use super::{Format, write_row};
use crate::api::{Place, Totals};
use crate::playback::totals::totals;
use crate::run::Analysis;

/// Writes the table.
pub(super) fn write(out: &mut dyn Write, analysis: &Analysis, format: Format) -> io::Result<()> {
    let (tools, all) = totals(&analysis.motions, &analysis.setup.machine);
    let rows = tools.iter().map(Totals::new);
    match format {
        Format::Json => rows.chain([Totals::new(&all)]).try_for_each(|row| write_row(out, &row)),
        Format::Text => {
            writeln!(out, "{:<6} {:>10} {:>11} {:>11}  {:<23} Z", "tool", "time", "cut mm", "rapid mm", "X")?;
            for row in rows {
                line(out, row.tool.as_deref().unwrap_or("-"), &row)?;
            }
            let all = Totals::new(&all);
            line(out, "all", &all)?;
            if all.unknown_cuts > 0 {
                writeln!(
                    out,
                    "Not in the time: {} cuts (no feed, or the spindle is stopped).",
                    all.unknown_cuts
                )?;
            }
            if all.unknown_rapids > 0 {
                writeln!(out, "Rapids at 8000 mm/min, assumed: set machine.rapidX and machine.rapidZ.")?;
            }
            Ok(())
        }
    }
}

fn line(out: &mut dyn Write, name: &str, row: &Totals) -> io::Result<()> {
    let time = match (row.seconds + row.assumed_seconds, row.unknown_cuts) {
        (0.0, cuts) if cuts > 0 => "unknown".to_owned(),
        (seconds, _) => clock(seconds),
    };
    let range = |of: fn(&Place) -> f64| match (&row.low, &row.high) {
        (Some(low), Some(high)) => format!("{:.3} … {:.3}", of(low), of(high)),
        _ => "–".to_owned(),
    };
    let (x, z) = (range(|place| place.x.mm()), range(|place| place.z));
    writeln!(out, "{name:<6} {time:>10} {:>11.1} {:>11.1}  {x:<23} {z}", row.cut, row.rapid)
}

/// Formats seconds as minutes and seconds.
fn clock(seconds: f64) -> String {
    let tenths = (10.0 * seconds).round();
    format!("{}:{:04.1}", (tenths / 600.0).floor(), tenths % 600.0 / 10.0)
}
