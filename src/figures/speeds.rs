//! The chart of the spindle speed over the diameter, with the limits of G50.
//!
//! In: a finished run. Out: the chart and its annotations; `None` if the program sets no cutting speed.

use super::replay;
use crate::control::modal::Spindle;
use crate::motion::Process;
use crate::run::Run;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::scene::speed_chart::{Curve, SpeedChart};
use crate::source::{LineIndex, Span};

/// Maximum number of lines that are looked at.
const MAX_LINES: u32 = 200;
/// Largest diameter without a blank, mm.
const LARGEST: f64 = 100.0;
/// The diameter of the chart as a share of that of the blank.
const BEYOND: f64 = 1.2;

/// The chart of all cutting speeds of the program.
pub fn of_speeds(run: &mut Run) -> Option<(SpeedChart, Vec<Annotation>)> {
    let mut curves: Vec<Curve> = Vec::new();
    let lines = LineIndex::new(run.text());
    for line in 0..lines.len().min(MAX_LINES) {
        let span = lines.line(run.text(), line);
        let sets_speed = |byte: &u8| matches!(byte.to_ascii_uppercase(), b'S' | b'Q');
        if !span.of(run.text()).iter().any(sets_speed) {
            continue;
        }
        let Some(visit) = replay(run, &lines, span.start).and_then(|found| found.visit) else { continue };
        let state = &visit.after.state;
        let spindle = state.spindle;
        if !spindle.surface || spindle.cutting_speed <= 0.0 {
            continue;
        }
        let process = Process { uncertain: false, ..state.process() };
        let block = (Span::new(span.start as usize, span.end as usize), line);
        // A later block may set the limits.
        curves.pop_if(|last| last.spindle.cutting_speed == spindle.cutting_speed);
        let values = |own: &Spindle| (own.cutting_speed, own.highest, own.lowest);
        if !curves.iter().any(|other| values(&other.spindle) == values(&spindle)) {
            curves.push(Curve { spindle, process, block });
        }
    }
    let blank = run.setup_at_machine().extents().map(|stock| stock.diameter.mm());
    let diameter = blank.map_or(LARGEST, |blank| BEYOND * blank);
    let chart = SpeedChart::of(&curves, diameter)?;
    let mut annotations = Vec::new();
    let note = |diameter: f64, speed: f64, name: &'static str, value: Measure| {
        Annotation::dimension(Shape::Note(chart.place(diameter, speed)), name, value)
    };
    for curve in &curves {
        let at = blank.unwrap_or(0.8 * diameter);
        annotations.push(note(at, curve.speed(at), "n", Measure::Count(curve.speed(at).round())));
        annotations.push(note(
            0.9 * at,
            curve.speed(0.9 * at),
            "v",
            Measure::Count(curve.spindle.cutting_speed),
        ));
        for limit in curve.limits_until(diameter) {
            let rounded = (10.0 * limit).round() / 10.0;
            annotations.push(note(limit, curve.speed(limit), "", Measure::Diameter(rounded)));
        }
    }
    let mut limits: Vec<(f64, &'static str)> = Vec::new();
    for curve in &curves {
        let Spindle { highest, lowest, .. } = curve.spindle;
        for limit in [highest.map(|speed| (speed, "S")), lowest.map(|speed| (speed, "Q"))] {
            limits.extend(limit.filter(|limit| !limits.contains(limit)));
        }
    }
    for (speed, name) in limits {
        let at = if name == "S" { 0.0 } else { diameter };
        annotations.push(note(at, speed, name, Measure::Count(speed)));
    }
    Some((chart, annotations))
}
