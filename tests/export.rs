//! Exported files, read back: every part of the gallery as a drawing and as a solid.
use crate::fixtures;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;

use gcode_playground::analyze;
use gcode_playground::export::file::caption;
use gcode_playground::export::{dxf, stl};
use gcode_playground::figures;
use gcode_playground::geometry::Point;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::scene::palette::Palette;
use gcode_playground::scene::svg::{Passes, SvgOptions, section};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

/// The finished part of each program, and solid parts that end on the spindle axis.
static PARTS: LazyLock<Vec<(String, Region)>> = LazyLock::new(parts);

fn parts() -> Vec<(String, Region)> {
    let programs = fixtures::all().into_iter().map(|program| (program.id, program.text, program.setup));
    let parts = programs.chain(at_the_axis()).filter_map(|(id, text, setup)| {
        let setup = Setup::from_json(&setup).expect("setup");
        let analysis = analyze(text.as_bytes(), &setup);
        let part = SimulationResult::of(&analysis.motions, &analysis.setup).finished()?;
        (!part.is_empty()).then_some((id, part))
    });
    let parts: Vec<_> = parts.collect();
    assert!(parts.len() > 50, "{}", parts.len());
    parts
}

/// Parting with round-cornered grooving inserts, ball ends and points: each part ends on the axis or close to
/// it.
fn at_the_axis() -> Vec<(String, String, String)> {
    let tool = |tool: &str| {
        format!(r#"{{"stock": {{"diameter": 30, "length": 60}}, "tools": {{"T0101": {{{tool}}}}}}}"#)
    };
    let mut programs = Vec::new();
    // 0.397 and 0.794 are 1/64 and 1/32 of an inch.
    for nose in [0.0, 0.1, 0.2, 0.397, 0.4, 0.794, 0.8] {
        for end in ["-1", "-0.4", "-0.2", "0", "0.001", "0.3"] {
            programs.push((
                format!("part-off R{nose} X{end}"),
                format!("T0101\nG97 S500 M03\nG00 X34 Z-40\nG01 X{end} F0.05\nG00 X34\nM30\n"),
                tool(&format!(r#""type": "grooving", "width": 3, "noseRadius": {nose}"#)),
            ));
        }
        programs.push((
            format!("ball end R{nose}"),
            "T0101\nG97 S500 M03\nG00 X0 Z2\nG01 Z0 F0.1\nG03 X20 Z-10 R10\nG01 Z-30\nX34\nM30\n".into(),
            tool(&format!(r#""type": "turning", "noseRadius": {nose}"#)),
        ));
        programs.push((
            format!("point R{nose}"),
            "T0101\nG97 S500 M03\nG00 X-1.6 Z1\nG01 Z0 F0.1\nX28 Z-30\nX34\nM30\n".into(),
            tool(&format!(r#""type": "turning", "noseRadius": {nose}"#)),
        ));
    }
    programs
}

/// An entity of a DXF file: its kind, its layer, its text, and its numbers by group code.
struct Entity {
    kind: String,
    layer: String,
    text: String,
    numbers: HashMap<i32, f64>,
}

impl Entity {
    fn at(&self, code: i32) -> Point {
        assert_eq!(self.numbers[&(code + 20)], 0.0, "a flat drawing");
        Point::new(self.numbers[&(code + 10)], self.numbers[&code])
    }

    /// The two ends of an arc or a line.
    fn ends(&self) -> [Point; 2] {
        if self.kind == "LINE" {
            return [self.at(10), self.at(11)];
        }
        let (center, radius) = (self.at(10), self.numbers[&40]);
        [50, 51].map(|code| {
            let (sin, cos) = self.numbers[&code].to_radians().sin_cos();
            Point::new(center.x + radius * sin, center.z + radius * cos)
        })
    }

    /// Area between an arc and its chord, mm².
    fn bulge(&self) -> f64 {
        if self.kind == "LINE" {
            return 0.0;
        }
        let sweep = (self.numbers[&51] - self.numbers[&50]).rem_euclid(360.0).to_radians();
        self.numbers[&40].powi(2) * (sweep - sweep.sin()) / 2.0
    }
}

/// Parses the entities of a DXF file: pairs of lines, a group code and a value.
fn read(text: &str) -> Vec<Entity> {
    let lines: Vec<&str> = text.split_terminator("\r\n").collect();
    assert_eq!(lines.len() % 2, 0);
    let pairs =
        lines.chunks_exact(2).map(|pair| (pair[0].trim().parse::<i32>().expect("group code"), pair[1]));
    let mut section = String::new();
    let mut entities: Vec<Entity> = Vec::new();
    let mut layers = Vec::new();
    let mut before = (0, "");
    for (code, value) in pairs {
        match (code, before) {
            (2, (0, "SECTION")) => section = value.to_owned(),
            (2, (0, "LAYER")) => layers.push(value.to_owned()),
            (0, _) if section == "ENTITIES" && !matches!(value, "ENDSEC" | "EOF") => {
                entities.push(Entity {
                    kind: value.into(),
                    layer: String::new(),
                    text: String::new(),
                    numbers: HashMap::new(),
                });
            }
            (1, _) if section == "ENTITIES" => entities.last_mut().expect("entity").text = value.into(),
            (8, _) => entities.last_mut().expect("entity").layer = value.into(),
            (10..=59, _) if section == "ENTITIES" => {
                entities.last_mut().expect("entity").numbers.insert(code, value.parse().expect("number"));
            }
            _ => {}
        }
        before = (code, value);
    }
    assert_eq!(before, (0, "EOF"));
    assert!(entities.iter().all(|entity| layers.contains(&entity.layer)));
    entities
}

#[test]
fn a_drawing_has_the_area_of_the_part_and_closes() {
    for (id, part) in PARTS.iter() {
        let entities = read(&dxf::dxf(part, &[]).expect(id));
        let profile: Vec<&Entity> = entities.iter().filter(|entity| entity.layer == "PROFILE").collect();
        assert_eq!(entities.iter().filter(|entity| entity.layer == "CENTER").count(), 1, "{id}");
        // Every end point belongs to two entities: the outline of a solid part runs along the axis.
        let mut ends: HashMap<(i64, i64), u32> = HashMap::new();
        let key = |at: Point| ((at.x * 1e3).round() as i64, (at.z * 1e3).round() as i64);
        for at in profile.iter().flat_map(|entity| entity.ends()) {
            assert!(at.x >= -2e-6, "{id}: an end at radius {}", at.x);
            *ends.entry(key(at)).or_default() += 1;
        }
        let near = |at: &(i64, i64)| -> u32 {
            let around = (-1..=1).flat_map(|x| (-1..=1).map(move |z| (x, z)));
            around.filter_map(|(x, z)| ends.get(&(at.0 + x, at.1 + z))).sum()
        };
        assert!(ends.keys().all(|at| near(at) % 2 == 0), "{id}: an end hangs loose");
        // Signed area above the axis: positive below chains towards -Z, negative below those that return. The
        // arc direction in the file does not show it, but the side of the material does.
        let length: f64 = part.edges().map(|(a, b)| a.distance(b)).sum();
        let mut area = 0.0;
        for entity in &profile {
            let [a, b] = entity.ends();
            // In the file all arcs are counter-clockwise; a clockwise one has the material on the other side.
            let middle = Point::new((a.x + b.x) / 2.0, (a.z + b.z) / 2.0);
            let (dx, dz) = ((b.x - a.x) / a.distance(b), (b.z - a.z) / a.distance(b));
            let on_arc = match entity.kind.as_str() {
                "LINE" => middle,
                _ => {
                    let sweep = (entity.numbers[&51] - entity.numbers[&50]).rem_euclid(360.0);
                    let (sin, cos) = (entity.numbers[&50] + sweep / 2.0).to_radians().sin_cos();
                    let (center, radius) = (entity.at(10), entity.numbers[&40]);
                    Point::new(center.x + radius * sin, center.z + radius * cos)
                }
            };
            let left = if entity.kind == "LINE" {
                (dz, -dx)
            } else {
                let center = entity.at(10);
                let inwards = on_arc.distance(center);
                ((center.x - on_arc.x) / inwards, (center.z - on_arc.z) / inwards)
            };
            let beside = |side: f64| Point::new(on_arc.x + side * left.0, on_arc.z + side * left.1);
            let direction = match (part.contains(beside(0.006)), part.contains(beside(-0.006))) {
                (true, false) => 1.0,
                (false, true) => -1.0,
                // A sliver with almost no area.
                _ => 0.0,
            };
            let under = (a.z * b.x - b.z * a.x) / 2.0 + entity.bulge();
            area += direction * under;
        }
        assert!((area - part.area()).abs() <= 0.005 * length, "{id}: {area} for {}", part.area());
    }
}

/// Ø30 to Z-20 with C2 at its end, a cone to Ø40 at Z-40, Ø40 to Z-60, blank Ø50, 80 long.
#[test]
fn the_dimensions_of_a_drawing_have_a_layer() {
    let program = "(STOCK D=50 LENGTH=80)\n(TOOL T0101 TYPE=TURNING NOSE=0)\nT0101 M03 S500\nG00 X22 Z2\n\
        G01 X26 Z0 F0.2\nX30 Z-2\nZ-20\nX40 Z-40\nZ-60\nX52\nG00 Z5\nM30\n";
    let analysis = analyze(program.as_bytes(), &Setup::default());
    let part = SimulationResult::of(&analysis.motions, &analysis.setup).finished().expect("a part");
    let entities =
        read(&dxf::dxf(&part, &figures::of_part(&part, &[], &analysis.motions)).expect("a drawing"));
    let is_dimension = |entity: &&Entity| entity.layer == "DIMENSIONS";
    let mut texts: Vec<&str> =
        entities.iter().filter(|entity| entity.kind == "TEXT").map(|entity| &entity.text[..]).collect();
    texts.sort_unstable();
    assert_eq!(texts, ["%%c30", "%%c40", "%%c50", "1:2", "20", "40", "60", "80", "C2"]);
    let with_texts =
        |kind: &str| entities.iter().filter(|entity| entity.kind == kind).all(|own| is_dimension(&own));
    assert!(with_texts("TEXT") && with_texts("SOLID"));
    // Ø30 is a line across the axis, with an arrow head at each end.
    let is_across = |entity: &Entity| {
        let [from, to] = entity.ends();
        (from.x + to.x).abs() < 1e-6 && (from.x.abs() - 15.0).abs() < 1e-6 && (from.z - to.z).abs() < 1e-6
    };
    let lines = || entities.iter().filter(is_dimension).filter(|entity| entity.kind == "LINE");
    assert!(lines().any(is_across));
    let heads = entities.iter().filter(|entity| entity.kind == "SOLID");
    let tips: Vec<Point> = heads.map(|head| head.at(10)).collect();
    let across = lines().find(|line| is_across(line)).expect("a dimension line").ends();
    assert!(across.iter().all(|end| tips.iter().any(|tip| tip.distance(*end) < 1e-6)), "{tips:?}");
}

#[test]
fn a_drawing_has_nothing_below_the_spindle_axis() {
    for (id, part) in PARTS.iter() {
        for arc in read(&dxf::dxf(part, &[]).expect(id)).iter().filter(|entity| entity.kind == "ARC") {
            let (from, to) = (arc.numbers[&50], arc.numbers[&51]);
            let downwards = (270.0 - from).rem_euclid(360.0) < (to - from).rem_euclid(360.0);
            let lowest = arc.at(10).x - arc.numbers[&40];
            assert!(!downwards || lowest >= -2e-6, "{id}: an arc down to radius {lowest}");
        }
    }
}

#[test]
fn arcs_of_the_programs_are_true_arcs_again() {
    for (program, radii) in [
        ("hand-01-g71-taper-arc-chamfer", &[6.0][..]),
        // A nose of 0.4 mm leaves its own radius in a corner.
        ("hand-11-g42-profile", &[0.4, 5.0]),
        ("s003-g71", &[5.5, 7.5]),
    ] {
        let (_, part) = PARTS.iter().find(|(id, _)| id == program).expect("program");
        let entities = read(&dxf::dxf(part, &[]).expect("part"));
        let arcs = entities.iter().filter(|entity| entity.kind == "ARC");
        let mut found: Vec<f64> = arcs.map(|entity| (entity.numbers[&40] * 1e4).round() / 1e4).collect();
        found.sort_by(f64::total_cmp);
        assert_eq!(found, radii, "{program}");
        assert!(entities.len() < 20, "{program}: {}", entities.len());
    }
}

#[test]
fn a_solid_is_closed_and_has_the_volume_of_pappus() {
    for (id, part) in PARTS.iter() {
        let file = stl::stl(part).expect(id);
        let count = u32::from_le_bytes(file[80..84].try_into().unwrap()) as usize;
        assert_eq!(file.len(), 84 + 50 * count, "{id}");
        assert!(!file.starts_with(b"solid"));
        let place = |at: usize| -> [f32; 3] {
            std::array::from_fn(|axis| {
                f32::from_le_bytes(file[at + 4 * axis..at + 4 * axis + 4].try_into().unwrap())
            })
        };
        // Each edge is used once in each direction, and no two corners of a triangle coincide.
        let mut edges: HashMap<[[u32; 3]; 2], i32> = HashMap::new();
        let mut volume = 0.0;
        for triangle in 0..count {
            let corners = [1, 2, 3].map(|corner| place(84 + 50 * triangle + 12 * corner));
            let bits = corners.map(|corner| corner.map(|value| (value + 0.0).to_bits()));
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                assert_ne!(bits[from], bits[to], "{id}: a triangle without area");
                *edges.entry([bits[from], bits[to]]).or_default() += 1;
            }
            let [a, b, c] = corners.map(|corner| corner.map(f64::from));
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
                / 6.0;
        }
        for ([from, to], times) in &edges {
            assert_eq!((*times, edges.get(&[*to, *from])), (1, Some(&1)), "{id}");
        }
        // Pappus: the area times the path of its centroid.
        let moment: f64 = part.edges().map(|(a, b)| (a.z * b.x - b.z * a.x) * (a.x + b.x) / 6.0).sum();
        let round = TAU * moment;
        assert!((volume - round).abs() < 1e-4 * round, "{id}: {volume} for {round}");
    }
}

#[test]
fn flats_follow_the_size_of_the_part() {
    let ring = |radius: f64| {
        Region::inside(&[
            Point::new(radius - 0.5, 0.0),
            Point::new(radius, 0.0),
            Point::new(radius, 1.0),
            Point::new(radius - 0.5, 1.0),
        ])
    };
    let flats = |radius: f64| stl::triangles(&ring(radius)).len() / 8;
    assert_eq!(flats(2.0), (PI / (1.0 - stl::FLATNESS / 2.0).acos()).ceil() as usize);
    assert_eq!((flats(1.0), flats(1000.0)), (24, 360));
}

/// A file has the colours of the page, except for its white background.
#[test]
fn the_colours_of_files_are_those_of_the_page() {
    let sheet = std::fs::read_to_string("www/src/tokens.css").expect("the style sheet");
    let (mut light, mut dark) = (Palette::light(), Palette::dark());
    for ((name, on_paper), (_, on_dark)) in light.by_name().zip(dark.by_name()) {
        let dashed: String = name.chars().fold(String::new(), |dashed, c| match c.is_uppercase() {
            true => dashed + "-" + &c.to_lowercase().to_string(),
            false => dashed + &c.to_string(),
        });
        let paper = if name == "background" { "#fcfcfa" } else { on_paper.as_ref() };
        let row = format!("--playground-{dashed}: light-dark({paper}, {on_dark});");
        assert!(sheet.contains(&row), "{row}");
    }
}

/// A drawing as the page and the command line export it.
fn drawing(id: &str, language: Language) -> String {
    let read =
        |file: &str| std::fs::read_to_string(format!("tests/programs/{id}/{file}")).expect("a fixture");
    let analysis =
        analyze(read("program.nc").as_bytes(), &Setup::from_json(&read("setup.json")).expect("setup"));
    let options = SvgOptions {
        caption: Some(caption("O0001 <PIN & CAP>".into(), language)),
        passes: Passes::Apart,
        ..SvgOptions::default()
    };
    section(&analysis.motions, Some(&analysis.simulate()), &options)
}

#[test]
fn a_drawing_has_its_title_and_a_legend_of_what_is_in_it() {
    let turned = drawing("s001-o6003", Language::English);
    assert!(turned.contains("<title>O0001 &lt;PIN &amp; CAP&gt;</title>"), "{turned}");
    assert!(turned.contains(">O0001 &lt;PIN &amp; CAP&gt;</text>"));
    for (text, is_there) in [
        ("rapid", true),
        ("cut", true),
        ("thread", false),
        ("blank", true),
        ("part", true),
        ("milled, see the end face", false),
    ] {
        assert_eq!(turned.contains(&format!(">{text}</text>")), is_there, "{text} in {turned}");
    }
    assert!(drawing("s001-o6003", Language::Chinese).contains(">快速移动</text>"));
    assert!(drawing("s001-o6003", Language::Russian).contains(">ускоренный ход</text>"));
    assert!(drawing("s002-g121-square", Language::English).contains(">milled, see the end face</text>"));
}

/// Every thread pass and every peck is drawn as a separate line, at least 2 pixels from the next one.
#[test]
fn passes_that_lie_on_one_another_are_drawn_apart() {
    for (id, class) in [("s003-g76", "thread"), ("s003-g74", "feed")] {
        let file = drawing(id, Language::English);
        assert!(file.contains(">passes drawn apart</text>"), "{file}");
        let path = file
            .lines()
            .find(|line| line.contains(&format!(r#"class="{class}" d="#)) && line.contains("data-line"));
        let d = path.and_then(|path| path.split(" d=\"").nth(1)).expect("the passes");
        // The levels at which the passes begin; each peck continues where the one before ends.
        let begins: &[char] = if class == "thread" { &['M'] } else { &['M', 'L'] };
        let places = d.split(begins).filter_map(|place| place.split([' ', '"', 'L']).nth(1)?.parse().ok());
        let heights: Vec<f64> = places.collect();
        let mut levels = heights;
        levels.sort_by(f64::total_cmp);
        levels.dedup_by(|a, b| (*a - *b).abs() < 0.02);
        assert!(levels.len() >= 3, "{id}: {levels:?}");
        assert!(levels.windows(2).all(|pair| pair[1] - pair[0] > 2.0), "{id}: {levels:?} {d}");
    }
    let plain = drawing("s001-frag-g90-cyl", Language::English);
    assert!(!plain.contains("passes drawn apart"), "{plain}");
}
