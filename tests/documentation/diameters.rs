//! Diameters and radii: according to ARCHITECTURE, "What must stay true", only `units::Diameter` converts
//! between them.
//!
//! In: the source. Out: the lines that double or halve an X by hand.

use super::project;

/// Files that may convert by hand: the definition, and the reader of programmed values.
const RIGHT: [&str; 1] = ["src/units.rs"];

/// Whether a path is an X or a diameter, judged by its last name.
fn is_across(path: &str) -> bool {
    matches!(path.rsplit('.').next(), Some("x" | "diameter" | "bore" | "x_min" | "x_max"))
}

fn is_of_path(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || matches!(sign, '_' | '.')
}

/// The number of values across the axis that a line doubles or halves.
fn conversions(line: &str) -> usize {
    let code = line.split("//").next().unwrap_or_default();
    let doubled = code.match_indices("2.0 * ").filter(|&(at, factor)| {
        let rest = code[at + factor.len()..].trim_start_matches('(');
        let path = rest.split(|sign| !is_of_path(sign)).next().unwrap_or_default();
        is_across(path.trim_end_matches(".abs"))
    });
    let after = [" / 2.0", " * 2.0"].into_iter().flat_map(|factor| code.match_indices(factor));
    let after = after.filter(|&(at, _)| {
        let head = code[..at].trim_end_matches(".abs()");
        is_across(head.rsplit(|sign| !is_of_path(sign)).next().unwrap_or_default())
    });
    doubled.count() + after.count()
}

#[test]
fn radii_become_diameters_by_name_alone() {
    let is_source =
        |file: &String| file.starts_with("src/") && file.ends_with(".rs") && !file.contains("/tests");
    let mut wrong = Vec::new();
    for file in project::files().into_iter().filter(is_source) {
        if RIGHT.contains(&file.as_str()) {
            continue;
        }
        for (number, line) in project::source(&file).lines().enumerate() {
            let place = format!("{file}:{}: {}", number + 1, line.trim());
            wrong.extend(std::iter::repeat_n(place, conversions(line)));
        }
    }
    assert!(wrong.is_empty(), "use `units::Diameter`:\n{}", wrong.join("\n"));
}

#[test]
fn a_conversion_by_hand_would_be_found() {
    for (line, count) in [
        ("let x = 2.0 * at.x;", 1),
        ("let x = 2.0 * (end.x + taper);", 1),
        ("near(at.x.abs() * 2.0, 3.0)", 1),
        ("let radius = stock.diameter / 2.0;", 1),
        ("x.map_or(at, |x| x / 2.0)", 1),
        ("Point::new(start.x / 2.0, 2.0 * end.x)", 2),
        ("2.0 * start.x.abs()", 1),
        ("let length = 2.0 * way; // 2.0 * at.x", 0),
        ("Point::new((from.z + to.z) / 2.0, angle / 2.0)", 0),
        ("Diameter::from_radius(at.x).mm()", 0),
    ] {
        assert_eq!(conversions(line), count, "{line}");
    }
}
