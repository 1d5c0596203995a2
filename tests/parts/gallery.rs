//! Compares the part of every turning program of the gallery with radius intervals that this test calculates
//! independently, motion by motion.

use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::resolved_setup::{Basis, ResolvedSetup};
use gcode_playground::motion::{Motion, MotionKind, Motions};
use gcode_playground::setup::{Setup, Side, Stock, Tool, ToolKind};
use gcode_playground::units::Diameter;

use super::reach::{Interval, Reach, common, left, moved, turns, union, within, without_dust};
use crate::fixtures::{Program, all};

/// Largest allowed difference, mm.
const TOLERANCE: f64 = 0.005;

/// Largest distance between chords and arcs, of the path and of the nose together, mm.
const CHORDS: f64 = 0.004;

/// Number of values of Z at which a part is compared.
const SECTIONS: u32 = 20;

/// The turning programs of the gallery, without tapping: the outline of a tap is not modelled here.
/// The programs `s002-…` do not turn: they mill, or only set speeds.
fn gallery() -> Vec<Program> {
    let list = crate::fixtures::gallery();
    all()
        .into_iter()
        .filter(|program| list.contains(&program.id) && !program.id.starts_with("s002"))
        .filter(|program| !["syn-g32-tap", "syn-g84-tap"].contains(&program.id.as_str()))
        .collect()
}

/// The reach of a resolved tool; the angles of inserts are from a tool maker's table.
fn as_resolved(tool: &Tool, basis: Basis, pitch: f64) -> Reach {
    let up = if tool.side == Some(Side::Inside) { -1.0 } else { 1.0 };
    match tool.kind.expect("a kind") {
        ToolKind::Turning | ToolKind::Boring => {
            let entering = tool.entering_angle.expect("an entering angle");
            let point = tool.point_angle.unwrap_or_else(|| match tool.insert.as_deref() {
                Some("C") => 80.0,
                Some("D") => 55.0,
                Some("V") => 35.0,
                other => panic!("{other:?}"),
            });
            let flip = match tool.tip_direction() {
                1 => (-1.0, -1.0),
                2 => (1.0, -1.0),
                3 => (1.0, 1.0),
                4 => (-1.0, 1.0),
                tip => panic!("tip {tip}"),
            };
            let edge = tool.edge_length.unwrap_or(12.0);
            Reach::rhombus(180.0 - entering - point, point, edge, 0.0, flip, basis == Basis::Inferred)
        }
        ToolKind::Grooving if tool.side == Some(Side::Face) => Reach::face_blade(3.0),
        ToolKind::Grooving => Reach::blade(tool.width.unwrap_or(3.0), up),
        ToolKind::Threading => Reach::thread(up, pitch),
        ToolKind::Drill => Reach::drill(tool.diameter.map_or(10.0, Diameter::mm)),
        kind => panic!("{kind:?}"),
    }
}

fn intervals(motions: &[(Motion, Reach)], stock: &Stock, z: f64) -> Vec<Interval> {
    let mut turned = 0.0;
    let mut before: Option<(Motion, &Reach)> = None;
    let mut taken = Vec::new();
    for (motion, reach) in motions {
        // At the end of a thread after a fraction of a turn, the insert stays for one more turn (see
        // `Reach::groove`).
        let ended = before.filter(|_| motion.kind != MotionKind::Thread);
        if let Some((thread, insert)) = ended.filter(|(_, insert)| insert.threads) {
            taken.extend(insert.groove(&thread, turned, z));
        }
        // A thread that follows another one continues with the same spindle revolution.
        let goes_on = before.is_some_and(|before| before.0.kind == MotionKind::Thread);
        let lead = motion.lead.filter(|_| motion.kind == MotionKind::Thread);
        // The other starts of a multi-start thread begin a fraction of a turn later.
        let start = motion.start_angle / 360.0;
        turned = if goes_on && lead.is_some() { turned } else { start };
        taken.extend(reach.taken(motion, turned, z));
        turned += lead.map_or(0.0, |lead| turns(motion, lead));
        before = Some((*motion, reach));
    }
    without_dust(&left(stock, &taken, z))
}

/// Compares the part at [`SECTIONS`] values of Z. Returns the number of those with material.
pub fn compare(
    id: &str,
    motions: &Motions,
    setup: &Setup,
    stock: &Stock,
    reach: impl Fn(&ResolvedSetup, &Motion) -> Reach,
) -> u32 {
    let simulation = SimulationResult::of(motions, setup);
    let part = simulation.finished().unwrap_or_else(|| panic!("{id}: no blank"));
    let all: Vec<_> =
        motions.iter().map(|motion| (motion, reach(simulation.resolved_setup(), &motion))).collect();
    let total = |rest: &[Interval]| rest.iter().map(|(low, high)| high - low).sum::<f64>();
    let mut with_material = 0;
    for section in 0..SECTIONS {
        // An odd fraction, so that few sections meet a shoulder.
        let mut z = stock.face - stock.length * (f64::from(section) + 0.437) / f64::from(SECTIONS);
        // Near a step the result is ambiguous; then a section further on is used.
        let is_unambiguous = |z: f64| {
            let near = [z - 0.02, z, z + 0.02].map(|z| intervals(&all, stock, z));
            near.iter().all(|rest| rest.len() == near[1].len() && (total(rest) - total(&near[1])).abs() < 0.5)
        };
        let places = (0..20).map(|index| z - 0.05 * f64::from(index));
        z = places
            .into_iter()
            .find(|&z| is_unambiguous(z))
            .unwrap_or_else(|| panic!("{id}: steps only at Z{z}"));
        // On a steep slope, a deviation perpendicular to the surface is larger in the radius.
        let expected = [z - CHORDS, z, z + CHORDS].map(|z| intervals(&all, stock, z));
        let found = part.radii(z);
        // Intervals thinner than the tolerances of both ends vanish.
        let opened = |rest: &[Interval]| moved(&moved(rest, -TOLERANCE), TOLERANCE);
        let most = moved(&union(&expected.concat()), TOLERANCE);
        let least = expected.iter().map(|rest| opened(rest));
        let least = least.reduce(|all, next| common(&all, &next)).expect("three places");
        let same = within(&opened(&found), &most) && within(&least, &moved(&found, TOLERANCE));
        assert!(same, "{id}: Z{z}: {found:.4?}, expected {:.4?}", expected[1]);
        with_material += u32::from(!found.is_empty());
    }
    with_material
}

/// Runs a program with `tool` at each station that it uses; `None` uses the inferred tools. The blank is that
/// of the program, or the inferred one, or a bar ⌀60 × 60 if none can be inferred; tools of the setup are
/// ignored.
fn check(program: &Program, tool: Option<fn(ToolKind) -> (Tool, Reach)>) {
    let mut setup = Setup::from_json(&program.setup).expect(&program.id);
    setup.tools.clear();
    let plain = analyze(program.text.as_bytes(), &setup);
    let resolved = ResolvedSetup::new(&plain.motions, &setup);
    let stock = resolved.stock().map_or(
        Stock {
            diameter: Diameter::new(60.0),
            bore: Diameter::new(0.0),
            face: 0.0,
            length: 60.0,
            grip: None,
        },
        |(stock, _)| stock,
    );
    setup.stock = Some(stock.into());
    let mut given: Vec<(u16, Reach)> = Vec::new();
    for resolved_tool in resolved.tools() {
        if let Some((tool, reach)) = tool.map(|tool| tool(resolved_tool.tool.kind.expect("a kind"))) {
            let name = format!("T{:02}{:02}", resolved_tool.station, resolved_tool.station);
            if setup.tools.insert(name, tool).is_none() {
                given.push((resolved_tool.station, reach));
            }
        }
    }
    let analysis = analyze(program.text.as_bytes(), &setup);
    let pitch = analysis.motions.iter().filter_map(|motion| motion.lead).fold(0.0, f64::max);
    let with_material = compare(&program.id, &analysis.motions, &setup, &stock, |resolved, motion| {
        let given = given.iter().find(|given| given.0 == motion.process.tool.0);
        let resolved_tool = resolved.tool(motion);
        match given {
            Some((_, reach)) if !reach.threads => reach.clone(),
            _ => as_resolved(&resolved_tool.tool, resolved_tool.basis, pitch),
        }
    });
    assert!(with_material > 0, "{}: no section has material", program.id);
}

#[test]
fn parts_with_inferred_sharp_tools() {
    let programs = gallery();
    // So that no program drops out unnoticed; adjust it with the gallery.
    assert_eq!(programs.len(), 39);
    for program in &programs {
        check(program, None);
    }
}

/// A threading tool. Its reach is only a marker: `check` uses the one for the pitch of the program.
fn threading() -> (Tool, Reach) {
    (Tool { kind: Some(ToolKind::Threading), ..Tool::default() }, Reach::thread(1.0, 0.0))
}

#[test]
fn parts_with_nose_radius_0_8() {
    for program in gallery() {
        check(
            &program,
            Some(|kind| {
                let flip = (1.0, if kind == ToolKind::Boring { -1.0 } else { 1.0 });
                match kind {
                    ToolKind::Turning | ToolKind::Boring => {
                        let tool = Tool {
                            kind: Some(kind),
                            nose_radius: Some(0.8),
                            point_angle: Some(55.0),
                            entering_angle: Some(93.0),
                            edge_length: Some(60.0),
                            ..Tool::default()
                        };
                        (tool, Reach::rhombus(32.0, 55.0, 60.0, 0.8, flip, false))
                    }
                    ToolKind::Threading => threading(),
                    ToolKind::Drill => (
                        Tool { kind: Some(kind), diameter: Some(Diameter::new(12.0)), ..Tool::default() },
                        Reach::drill(12.0),
                    ),
                    _ => (
                        Tool { kind: Some(ToolKind::Grooving), width: Some(4.0), ..Tool::default() },
                        Reach::blade(4.0, 1.0),
                    ),
                }
            }),
        );
    }
}

#[test]
fn parts_with_3_mm_blades() {
    for program in gallery() {
        check(
            &program,
            Some(|kind| match kind {
                ToolKind::Threading => threading(),
                ToolKind::Boring => (
                    Tool {
                        kind: Some(ToolKind::Grooving),
                        width: Some(3.0),
                        side: Some(Side::Inside),
                        ..Tool::default()
                    },
                    Reach::blade(3.0, -1.0),
                ),
                _ => (
                    Tool { kind: Some(ToolKind::Grooving), width: Some(3.0), ..Tool::default() },
                    Reach::blade(3.0, 1.0),
                ),
            }),
        );
    }
}
