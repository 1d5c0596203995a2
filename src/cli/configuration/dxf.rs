//! Reads the outline of a blank from a DXF drawing.
//!
//! In: the text of a DXF file, in which X is Z of the lathe and Y the radius, as in the exported profile. Out: a
//! setup as JSON with the outline. The lines, arcs and polylines above the spindle axis must form one chain; if there
//! is a layer `PROFILE`, only its entities count. Arcs become chords.

use serde_json::json;

use crate::geometry::Point;
use crate::limits::OUTLINE_POINTS;
use crate::units::Diameter;

/// Ends that are at most this far apart, mm, are connected; nearer to the axis, a point is on it.
const CONNECTED: f64 = 1e-3;

/// Greatest distance of a chord from its arc, mm.
const CHORD: f64 = 0.01;

/// Most lines and chords of a drawing.
const MOST_PIECES: usize = 4 * OUTLINE_POINTS;

/// Millimetres for each unit of a drawing in inches, `$INSUNITS` 1.
const INCH: f64 = 25.4;

/// An entity of a drawing: its type, its layer, its numbers with their group codes.
#[derive(Debug, Default)]
struct Entity {
    kind: String,
    layer: String,
    numbers: Vec<(u16, f64)>,
}

/// A straight piece of the outline.
type Piece = [Point; 2];

/// The setup with the outline of a drawing.
pub(super) fn setup(text: &str) -> Result<String, String> {
    let (entities, scale) = entities(text)?;
    let has_profile = entities.iter().any(|own| own.layer.eq_ignore_ascii_case("PROFILE"));
    let counts = |own: &&Entity| !has_profile || own.layer.eq_ignore_ascii_case("PROFILE");
    let mut pieces = Vec::new();
    for entity in entities.iter().filter(counts) {
        pieces.extend(entity.pieces(scale).into_iter().filter_map(above_axis));
        if pieces.len() > MOST_PIECES {
            return Err(format!("the outline has more than {MOST_PIECES} lines"));
        }
    }
    let point = |at: Point| {
        let micrometres = |mm: f64| (mm * 1e3).round() / 1e3 + 0.0;
        [Diameter::from_radius(at.x).mm(), at.z].map(micrometres)
    };
    let points: Vec<_> = chain(pieces)?.into_iter().map(point).collect();
    Ok(json!({"stock": {"outline": points}}).to_string())
}

/// The entities of a drawing, and the millimetres of its unit.
fn entities(text: &str) -> Result<(Vec<Entity>, f64), String> {
    let mut lines = text.lines().map(str::trim);
    let mut all: Vec<Entity> = Vec::new();
    let (mut section, mut variable, mut scale) = (String::new(), String::new(), 1.0);
    let mut line = 0;
    while let (Some(code), Some(value)) = (lines.next(), lines.next()) {
        line += 2;
        let code: u16 = match code.parse::<i32>() {
            Ok(code) => u16::try_from(code).unwrap_or(u16::MAX),
            Err(_) => {
                return Err(format!("line {} is not a group code of a DXF file in text form", line - 1));
            }
        };
        match (code, &*section) {
            (0, _) if value == "SECTION" => section.clear(),
            (0, "ENTITIES") => all.push(Entity { kind: value.to_owned(), ..Entity::default() }),
            (2, "") => section = value.to_owned(),
            (9, "HEADER") => variable = value.to_owned(),
            (70, "HEADER") if variable == "$INSUNITS" && value == "1" => scale = INCH,
            (8, "ENTITIES") => {
                if let Some(last) = all.last_mut() {
                    last.layer = value.to_owned();
                }
            }
            (10..=59 | 70, "ENTITIES") => {
                let number = value.parse().ok().filter(|number: &f64| number.is_finite());
                let number = number.ok_or_else(|| format!("line {line} is not a number"))?;
                if let Some(last) = all.last_mut() {
                    last.numbers.push((code, number));
                }
            }
            _ => {}
        }
    }
    Ok((with_vertices(all), scale))
}

/// Polylines of AutoCAD release 12 with the coordinates of their vertices, which are separate entities.
fn with_vertices(all: Vec<Entity>) -> Vec<Entity> {
    let mut joined: Vec<Entity> = Vec::new();
    let mut is_open = false;
    for mut entity in all {
        match &*entity.kind {
            "POLYLINE" => {
                // Its own point is a dummy.
                entity.numbers.retain(|number| number.0 == 70);
                is_open = true;
            }
            "VERTEX" if is_open => {
                if let Some(last) = joined.last_mut() {
                    last.numbers.extend(entity.numbers.into_iter().filter(|number| number.0 != 70));
                }
                continue;
            }
            _ => is_open = false,
        }
        joined.push(entity);
    }
    joined
}

impl Entity {
    /// The last number with a group code; 0 without one.
    fn number(&self, code: u16) -> f64 {
        self.numbers.iter().rfind(|number| number.0 == code).map_or(0.0, |number| number.1)
    }

    /// Its straight pieces and chords, mm. Other entities, such as texts, have none.
    fn pieces(&self, scale: f64) -> Vec<Piece> {
        let at = |z: f64, x: f64| Point::new(scale * x, scale * z);
        match &*self.kind {
            "LINE" => vec![[at(self.number(10), self.number(20)), at(self.number(11), self.number(21))]],
            "ARC" => {
                let center = at(self.number(10), self.number(20));
                let [from, to] = [self.number(50), self.number(51)].map(f64::to_radians);
                let sweep = (to - from).rem_euclid(std::f64::consts::TAU);
                chords(center, scale * self.number(40), from, sweep)
            }
            "LWPOLYLINE" | "POLYLINE" => self.polyline(at),
            _ => Vec::new(),
        }
    }

    /// The pieces of a polyline. The bulge of a vertex is the tangent of a quarter of the angle of the arc to the next
    /// vertex, positive if that is counter-clockwise.
    fn polyline(&self, at: impl Fn(f64, f64) -> Point) -> Vec<Piece> {
        let mut vertices: Vec<(Point, f64)> = Vec::new();
        let mut z = 0.0;
        for &(code, number) in &self.numbers {
            match (code, vertices.last_mut()) {
                (10, _) => z = number,
                (20, _) => vertices.push((at(z, number), 0.0)),
                (42, Some(last)) => last.1 = number,
                _ => {}
            }
        }
        let is_closed = self.number(70) as i64 & 1 == 1;
        let count = if is_closed { vertices.len() } else { vertices.len().saturating_sub(1) };
        let next = vertices.iter().cycle().skip(1);
        vertices.iter().zip(next).take(count).flat_map(|(from, to)| bulged(from.0, to.0, from.1)).collect()
    }
}

/// The line or arc between two vertices of a polyline.
fn bulged(from: Point, to: Point, bulge: f64) -> Vec<Piece> {
    let chord = from.distance(to);
    if bulge == 0.0 || chord <= CONNECTED {
        return vec![[from, to]];
    }
    let sweep = 4.0 * bulge.atan();
    // Distance of the centre to the left of the chord, as a share of the chord.
    let aside = (1.0 - bulge * bulge) / (4.0 * bulge);
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let center = Point::new(from.x + dx / 2.0 + aside * dz, from.z + dz / 2.0 - aside * dx);
    let start = (from.x - center.x).atan2(from.z - center.z);
    chords(center, center.distance(from), start, sweep)
}

/// The chords of an arc: from an angle, over an angle, radians, counter-clockwise.
fn chords(center: Point, radius: f64, from: f64, sweep: f64) -> Vec<Piece> {
    let step = 2.0 * (1.0 - (CHORD / radius.max(CHORD)).min(1.0)).acos();
    let count = (sweep.abs() / step).ceil().clamp(1.0, MOST_PIECES as f64 + 1.0) as usize;
    let at = |index: usize| {
        let angle = from + sweep * index as f64 / count as f64;
        Point::new(center.x + radius * angle.sin(), center.z + radius * angle.cos())
    };
    (0..count).map(|index| [at(index), at(index + 1)]).collect()
}

/// The part of a piece above the spindle axis. The axis itself is no part of the outline.
fn above_axis([from, to]: Piece) -> Option<Piece> {
    let on_axis = |at: Point, other: Point| match at.x < 0.0 {
        true => Point::new(0.0, at.z + at.x / (at.x - other.x) * (other.z - at.z)),
        false => at,
    };
    if from.x.max(to.x) <= CONNECTED || from.distance(to) <= CONNECTED {
        return None;
    }
    Some([on_axis(from, to), on_axis(to, from)])
}

/// The points of the only chain of pieces. If it is closed, its last point repeats the first.
fn chain(mut pieces: Vec<Piece>) -> Result<Vec<Point>, String> {
    let connects = |a: Point, b: Point| a.distance(b) <= CONNECTED;
    let is_loose = |at: Point| pieces.iter().flatten().filter(|own| connects(at, **own)).count() == 1;
    // An open chain is followed from its loose end.
    let first = pieces.iter().position(|piece| is_loose(piece[0]) || is_loose(piece[1])).unwrap_or(0);
    if pieces.is_empty() {
        return Err("there are no lines or arcs above the spindle axis, which is Y0".into());
    }
    let [from, to] = pieces[first];
    let begin = if is_loose(to) && !is_loose(from) { [to, from] } else { [from, to] };
    pieces.swap_remove(first);
    let mut points = begin.to_vec();
    while let Some(&end) = points.last() {
        let next = pieces.iter().position(|piece| connects(piece[0], end) || connects(piece[1], end));
        let Some(next) = next else { break };
        let [from, to] = pieces.swap_remove(next);
        points.push(if connects(from, end) { to } else { from });
    }
    if let Some(left) = pieces.first() {
        let at = left[0];
        return Err(format!("the line at X{:.3} Y{:.3} is not connected to the outline", at.z, at.x));
    }
    match points.last() {
        Some(&last) if connects(last, points[0]) => {
            points.pop();
            points.push(points[0]);
        }
        _ => {}
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Group codes and values, separated by blanks.
    fn drawing(head: &str, entities: &str) -> String {
        let pairs =
            format!("0 SECTION 2 HEADER {head} 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF");
        pairs.split_whitespace().map(|word| format!("{word}\r\n")).collect()
    }

    fn line(layer: &str, [z1, x1, z2, x2]: [f64; 4]) -> String {
        format!("0 LINE 8 {layer} 10 {z1} 20 {x1} 30 0 11 {z2} 21 {x2} 31 0 ")
    }

    #[track_caller]
    fn check(drawing: &str, expected: &[[f64; 2]]) {
        let found: serde_json::Value =
            serde_json::from_str(&setup(drawing).expect("an outline")).expect("JSON");
        let expected = json!({"stock": {"outline": expected}});
        assert_eq!(found, expected);
    }

    /// A forging of ⌀30 and ⌀50 with a cone: Y is the radius. The lines are in any order and direction.
    #[test]
    fn lines_are_chained() {
        let lines = [
            line("0", [-20.0, 15.0, -30.0, 25.0]),
            line("0", [2.0, 0.0, 2.0, 15.0]),
            line("0", [-60.0, 25.0, -30.0, 25.0]),
            line("0", [-20.0, 15.0, 2.0, 15.0]),
            line("0", [-60.0, 0.0, -60.0, 25.0]),
            line("0", [-65.0, 0.0, 5.0, 0.0]),
        ];
        let points = [[0.0, 2.0], [30.0, 2.0], [30.0, -20.0], [50.0, -30.0], [50.0, -60.0], [0.0, -60.0]];
        check(&drawing("", &lines.concat()), &points);
        // In inches.
        let inch = line("0", [0.0, 1.0, -2.0, 1.0]);
        check(&drawing("9 $INSUNITS 70 1", &inch), &[[50.8, 0.0], [50.8, -50.8]]);
        // Another layer does not count if there is a profile.
        let dimension = line("DIMENSIONS", [0.0, 40.0, -50.0, 40.0]);
        let profile = line("PROFILE", [0.0, 15.0, -40.0, 15.0]);
        check(&drawing("", &[dimension, profile].concat()), &[[30.0, 0.0], [30.0, -40.0]]);
        // A face drawn on both sides of the axis is cut at the axis.
        let whole = [line("0", [0.0, -15.0, 0.0, 15.0]), line("0", [0.0, 15.0, -40.0, 15.0])];
        check(&drawing("", &whole.concat()), &[[0.0, 0.0], [30.0, 0.0], [30.0, -40.0]]);
    }

    /// A ring as a closed polyline; a quarter circle of 10 mm about Z-10 X0, from its top to Z0 on the axis.
    #[test]
    fn polylines_and_arcs() {
        let ring = "0 LWPOLYLINE 8 0 70 1 10 0 20 10 10 0 20 30 10 -40 20 30 10 -40 20 10";
        let closed = [[20.0, 0.0], [60.0, 0.0], [60.0, -40.0], [20.0, -40.0], [20.0, 0.0]];
        check(&drawing("", ring), &closed);
        let old = "0 POLYLINE 8 0 66 1 70 1 10 0 20 0 0 VERTEX 10 0 20 10 0 VERTEX 10 0 20 30 \
            0 VERTEX 10 -40 20 30 0 VERTEX 10 -40 20 10 0 SEQEND";
        check(&drawing("", old), &closed);
        // Counter-clockwise from Z0 on the axis to the top: the tangent of 22.5°, and as an ARC from 0° to 90°.
        for round in [
            "0 LWPOLYLINE 8 0 70 0 10 0 20 0 42 0.41421356 10 -10 20 10",
            "0 ARC 8 0 10 -10 20 0 40 10 50 0 51 90",
        ] {
            let setup = setup(&drawing("", round)).expect("an outline");
            let setup: serde_json::Value = serde_json::from_str(&setup).expect("JSON");
            let points = setup["stock"]["outline"].as_array().expect("points");
            assert!((10..=30).contains(&points.len()), "{points:?}");
            for point in points {
                let (radius, z) = (point[0].as_f64().expect("X") / 2.0, point[1].as_f64().expect("Z"));
                assert!(((z + 10.0).hypot(radius) - 10.0).abs() < 2e-3, "{point}");
            }
        }
    }

    #[test]
    fn a_drawing_without_one_outline_is_refused() {
        let refused = |text: &str, words: &str| {
            let problem = setup(text).expect_err("a problem");
            assert!(problem.contains(words), "{problem}");
        };
        refused("AutoCAD Binary DXF\r\n\u{1a}", "group code");
        refused(&drawing("", ""), "no lines or arcs");
        refused(&drawing("", "0 LINE 8 0 10 x 20 1"), "not a number");
        let apart = [line("0", [0.0, 15.0, -40.0, 15.0]), line("0", [0.0, 30.0, -40.0, 30.0])];
        refused(&drawing("", &apart.concat()), "X0.000 Y30.000 is not connected");
        let long: String =
            (0..900).map(|at| line("0", [f64::from(-at), 9.0, f64::from(-at - 1), 9.0])).collect();
        refused(&drawing("", &long), "more than 800 lines");
    }
}
