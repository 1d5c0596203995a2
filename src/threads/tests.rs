//! Published dimensions, the tables, and names as they are written.

use super::table::Row;
use super::{Hand, Name, Standard, Thread, find, suggest};

fn named(name: &str) -> Thread {
    find(name).unwrap_or_else(|| panic!("{name} is not found"))
}

/// Whether a length is the printed one with three decimals.
#[track_caller]
fn is_printed(value: f64, printed: f64) {
    assert!((value - printed).abs() < 0.00051, "{value} for {printed}");
}

/// Whether a length is the printed one, in inches with four decimals. Some are rounded twice.
#[track_caller]
fn is_printed_in_inches(value: f64, printed: f64) {
    assert!((value / 25.4 - printed).abs() < 0.000_1, "{} for {printed}", value / 25.4);
}

/// All rows with their standards.
fn rows() -> Vec<(Standard, Row)> {
    Standard::ALL.into_iter().flat_map(|standard| standard.rows().map(move |row| (standard, row))).collect()
}

#[test]
fn every_line_of_a_table_is_read() {
    for standard in Standard::ALL {
        assert_eq!(standard.rows().count(), standard.lines().count(), "{standard:?}");
        assert!(standard.rows().count() > 18, "{standard:?}");
        assert!(standard.source().starts_with(['I', 'A']), "{standard:?}: {}", standard.source());
    }
}

#[test]
fn every_thread_is_found_by_its_designation() {
    for (standard, row) in rows() {
        let thread = named(row.designation);
        assert_eq!((thread.standard, &*thread.designation), (standard, row.designation));
        assert_eq!((thread.major.mm(), thread.pitch, thread.lead), (row.major, row.pitch, row.pitch));
        assert_eq!((thread.starts, thread.hand), (1, Hand::Right));
        let plain = row.designation.replace('×', " X ").to_lowercase();
        assert_eq!(find(&plain), Some(thread), "{plain}");
    }
}

#[test]
fn designations_agree_with_their_columns() {
    for (standard, row) in rows() {
        let name = Name::read(row.designation).expect(row.designation);
        assert_eq!(name.standard, standard);
        let number = |text: &str| text.parse::<f64>().expect(row.designation);
        let near = |one: f64, other: f64| assert!((one - other).abs() < 1e-9, "{}", row.designation);
        match standard {
            Standard::Metric | Standard::Trapezoidal => {
                let text = row.designation.trim_start_matches(['M', 'T', 'r']);
                let (major, pitch) = text.split_once('×').unwrap_or((text, ""));
                near(number(major), row.major);
                if !pitch.is_empty() {
                    near(number(pitch), row.pitch);
                }
            }
            Standard::Unified => {
                let (size, rest) = row.designation.split_once('-').expect(row.designation);
                let fraction = |text: &str| match text.split_once('/') {
                    Some((above, below)) => number(above) / number(below),
                    None => number(text),
                };
                let inches = match size.strip_prefix('#') {
                    // ASME B1.1: size 0 is 0.06 inch, each number adds 0.013 inch.
                    Some(size) => 0.06 + 0.013 * number(size),
                    None => size.split(' ').map(fraction).sum(),
                };
                near(25.4 * inches, row.major);
                near(25.4 / number(rest.split(' ').next().unwrap()), row.pitch);
            }
            Standard::TaperPipe => {
                let rest = row.designation.split_once('-').expect(row.designation).1;
                near(25.4 / number(rest.trim_end_matches(" NPT")), row.pitch);
            }
            Standard::Pipe => {}
        }
    }
}

#[test]
fn no_thread_is_there_twice() {
    let rows = rows();
    for (at, (standard, row)) in rows.iter().enumerate() {
        for (other, earlier) in &rows[..at] {
            assert_ne!(row.designation, earlier.designation);
            let same = standard == other && row.major == earlier.major && row.pitch == earlier.pitch;
            assert!(!same, "{} and {}", row.designation, earlier.designation);
        }
    }
}

#[test]
fn dimensions_are_plausible() {
    for (_, row) in rows() {
        let Thread { major, pitch, outside, inside, taper, .. } = named(row.designation);
        assert!(pitch > 0.0 && pitch < 0.4 * major.mm(), "{}", row.designation);
        assert!(outside.core.mm() > 0.5 * major.mm() && outside.core < major, "{}", row.designation);
        assert!(inside.hole >= outside.core && inside.hole < inside.root, "{}", row.designation);
        assert!(inside.root >= major || taper.is_some(), "{}", row.designation);
        let share = 0.5 * pitch..0.9 * pitch;
        assert!(share.contains(&outside.height) && share.contains(&inside.height), "{}", row.designation);
    }
}

/// ISO 724: D1. DIN 13: d3.
#[test]
fn metric_threads_have_the_printed_dimensions() {
    for (name, pitch, hole, core) in [
        ("M1", 0.25, 0.729, 0.693),
        ("M3", 0.5, 2.459, 2.387),
        ("M6", 1.0, 4.917, 4.773),
        ("M8", 1.25, 6.647, 6.466),
        ("M10", 1.5, 8.376, 8.160),
        ("M12", 1.75, 10.106, 9.853),
        ("M20", 2.5, 17.294, 16.933),
        ("M30", 3.5, 26.211, 25.706),
        ("M30×2", 2.0, 27.835, 27.546),
        ("M64", 6.0, 57.505, 56.639),
    ] {
        let thread = named(name);
        assert_eq!((thread.pitch, thread.angle, thread.taper), (pitch, 60.0, None), "{name}");
        is_printed(thread.inside.hole.mm(), hole);
        is_printed(thread.outside.core.mm(), core);
        assert_eq!(thread.inside.root, thread.major);
    }
    // h3 = 17/24 H = 0.613434 P, H1 = 5/8 H = 0.541266 P.
    is_printed(named("M10").outside.height, 0.920);
    is_printed(named("M10").inside.height, 0.812);
    assert_eq!(named("M10").source(), "ISO 261, ISO 68-1, ISO 724");
}

/// Machinery's Handbook, 31st edition, tables 4a to 4c and 5c after ASME B1.1: minor diameters in inches,
/// inside and outside.
#[test]
fn unified_threads_have_the_printed_dimensions() {
    for (name, major, hole, core) in [
        ("#1-64 UNC", 0.0730, 0.0561, 0.0544),
        ("1/4-20 UNC", 0.2500, 0.1959, 0.1905),
        ("1/2-13 UNC", 0.5000, 0.4167, 0.4084),
        ("1-8 UNC", 1.0000, 0.8647, 0.8512),
        ("2-4.5 UNC", 2.0000, 1.7594, 1.7353),
        ("4-4 UNC", 4.0000, 3.7294, 3.7023),
        ("#0-80 UNF", 0.0600, 0.0465, 0.0451),
        ("#10-32 UNF", 0.1900, 0.1562, 0.1528),
        ("1 1/2-12 UNF", 1.5000, 1.4098, 1.4008),
        ("#12-32 UNEF", 0.2160, 0.1822, 0.1788),
        ("1 3/16-18 UNEF", 1.1875, 1.1274, 1.1214),
        ("2 1/2-8 UN", 2.5000, 2.3647, 2.3512),
    ] {
        let thread = named(name);
        is_printed_in_inches(thread.major.mm(), major);
        is_printed_in_inches(thread.inside.hole.mm(), hole);
        is_printed_in_inches(thread.outside.core.mm(), core);
        assert_eq!((thread.angle, thread.inside.root), (60.0, thread.major), "{name}");
    }
    let quarter = named("1/4-20 UNC");
    is_printed(quarter.major.mm(), 6.35);
    is_printed(quarter.pitch, 1.27);
    assert_eq!(quarter.source(), "ASME B1.1");
}

/// ISO 228-1, table 1. The minor diameters of the table are rounded twice, from h = 0.640327 P.
#[test]
fn pipe_threads_have_the_printed_dimensions() {
    for (name, major, per_inch, minor, height) in [
        ("G1/8", 9.728, 28.0, 8.566, 0.581),
        ("G1/4", 13.157, 19.0, 11.445, 0.856),
        ("G1/2", 20.955, 14.0, 18.631, 1.162),
        ("G1", 33.249, 11.0, 30.291, 1.479),
        ("G1 3/4", 53.746, 11.0, 50.788, 1.479),
        ("G6", 163.830, 11.0, 160.872, 1.479),
    ] {
        let thread = named(name);
        is_printed(thread.major.mm(), major);
        assert!((25.4 / thread.pitch - per_inch).abs() < 1e-9, "{name}");
        is_printed(thread.outside.core.mm(), minor);
        is_printed(thread.inside.hole.mm(), minor);
        is_printed(thread.outside.height, height);
        assert_eq!((thread.angle, thread.outside.height), (55.0, thread.inside.height), "{name}");
    }
    for row in Standard::Pipe.rows() {
        let thread = named(row.designation);
        let minor = row.major - 1.280_654 * row.pitch;
        assert!((thread.outside.core.mm() - minor).abs() < 0.0015, "{}: {minor}", row.designation);
    }
    assert_eq!(named("G1/2").source(), "ISO 228-1");
}

/// ASME B1.20.1, table 2, in inches: E0, E1, L2 of every size.
#[test]
fn taper_pipe_threads_have_the_printed_dimensions() {
    let printed = [
        (0.27118, 0.28118, 0.2611),
        (0.36351, 0.37360, 0.2639),
        (0.47739, 0.49163, 0.4018),
        (0.61201, 0.62701, 0.4078),
        (0.75843, 0.77843, 0.5337),
        (0.96768, 0.98887, 0.5457),
        (1.21363, 1.23863, 0.6828),
        (1.55713, 1.58338, 0.7068),
        (1.79609, 1.82234, 0.7235),
        (2.26902, 2.29627, 0.7565),
        (2.71953, 2.76216, 1.1375),
        (3.34062, 3.38850, 1.2000),
        (3.83750, 3.88881, 1.2500),
        (4.33438, 4.38712, 1.3000),
        (5.39073, 5.44929, 1.4063),
        (6.44609, 6.50597, 1.5125),
        (8.43359, 8.50003, 1.7125),
        (10.54531, 10.62094, 1.9250),
        (12.53281, 12.61781, 2.1250),
    ];
    assert_eq!(Standard::TaperPipe.rows().count(), printed.len());
    for (row, (at_end, at_engagement, effective)) in Standard::TaperPipe.rows().zip(printed) {
        let taper = named(row.designation).taper.expect(row.designation);
        assert_eq!(taper.ratio, 0.0625);
        for (value, printed) in
            [(taper.pitch_at_end.mm(), at_end), (taper.pitch_at_engagement.mm(), at_engagement)]
        {
            assert!((value / 25.4 - printed).abs() < 0.000_011, "{}: {printed}", row.designation);
        }
        is_printed_in_inches(taper.effective, effective);
    }
    let half = named("1/2-14 NPT");
    is_printed(half.major.mm(), 21.336);
    assert_eq!((half.angle, half.source()), (60.0, "ASME B1.20.1"));
    let taper = half.taper.expect("NPT has a taper");
    is_printed_in_inches(taper.engagement, 0.32);
    is_printed_in_inches(taper.overall, 0.7815);
    // Height of 14 threads per inch, and K0, the minor diameter at the end of the pipe.
    is_printed_in_inches(half.outside.height, 0.05714);
    is_printed_in_inches(half.outside.core.mm(), 0.7013);
    // At E1: 0.77843 ± 0.05714.
    is_printed_in_inches(half.inside.hole.mm(), 0.72129);
    is_printed_in_inches(half.inside.root.mm(), 0.83557);
}

/// ISO 2904, table 1.
#[test]
fn trapezoidal_threads_have_the_printed_dimensions() {
    for (name, core, hole, root) in [
        ("Tr8×1.5", 6.2, 6.5, 8.3),
        ("Tr10×2", 7.5, 8.0, 10.5),
        ("Tr16×4", 11.5, 12.0, 16.5),
        ("Tr20×4", 15.5, 16.0, 20.5),
        ("Tr40×7", 32.0, 33.0, 41.0),
        ("Tr44×12", 31.0, 32.0, 45.0),
        ("Tr60×9", 50.0, 51.0, 61.0),
        ("Tr120×14", 104.0, 106.0, 122.0),
    ] {
        let thread = named(name);
        is_printed(thread.outside.core.mm(), core);
        is_printed(thread.inside.hole.mm(), hole);
        is_printed(thread.inside.root.mm(), root);
        assert_eq!(thread.angle, 30.0, "{name}");
    }
    // h3 = 0.5·7 + 0.5.
    is_printed(named("Tr40×7").outside.height, 4.0);
}

/// ISO 2901: the clearance follows from the pitch.
#[test]
fn the_crest_clearance_follows_from_the_pitch() {
    for row in Standard::Trapezoidal.rows() {
        let thread = named(row.designation);
        let clearance = match row.pitch {
            ..2.0 => 0.15,
            2.0..6.0 => 0.25,
            6.0..14.0 => 0.5,
            _ => 1.0,
        };
        is_printed(thread.inside.root.mm() - thread.major.mm(), 2.0 * clearance);
    }
}

#[test]
fn a_name_is_read_as_it_is_written() {
    for (name, designation) in [
        ("m10", "M10"),
        ("M 10", "M10"),
        ("M10x1.5", "M10"),
        ("M10×1,25", "M10×1.25"),
        ("M10 x 1", "M10×1"),
        ("M10*1.0", "M10×1"),
        ("\u{41c}10\u{445}1", "M10×1"),
        ("M10-6g", "M10"),
        ("M10x1-5g6g-LH", "M10×1"),
        ("1/4-20 UNC", "1/4-20 UNC"),
        ("1/4-20", "1/4-20 UNC"),
        ("1/4\"-20 UNC-2A", "1/4-20 UNC"),
        ("UNC 1/4", "1/4-20 UNC"),
        ("unc1/4-20", "1/4-20 UNC"),
        (".250-20 UNC", "1/4-20 UNC"),
        (".438-20 UNF", "7/16-20 UNF"),
        ("#10-32 UNF", "#10-32 UNF"),
        ("10-32", "#10-32 UNF"),
        ("UNF 10", "#10-32 UNF"),
        ("0-80", "#0-80 UNF"),
        ("1-8", "1-8 UNC"),
        ("1-64", "#1-64 UNC"),
        ("UNC 1", "1-8 UNC"),
        ("1-1/8-7 UNC", "1 1/8-7 UNC"),
        ("1 1/8 - 8UN", "1 1/8-8 UN"),
        ("1/4-28 UN", "1/4-28 UNF"),
        ("G1/2", "G1/2"),
        ("G 1/2 A", "G1/2"),
        ("g 1 1/4 B", "G1 1/4"),
        ("G1-1/4", "G1 1/4"),
        ("1/2-14 NPT", "1/2-14 NPT"),
        ("NPT 1/2", "1/2-14 NPT"),
        ("1/2 NPT", "1/2-14 NPT"),
        ("1 1/4-11 1/2 NPT", "1 1/4-11.5 NPT"),
        ("1-11,5 NPT", "1-11.5 NPT"),
        ("Tr40x7", "Tr40×7"),
        ("TR 40 X 7 - 7e", "Tr40×7"),
        ("Tr40x7P7", "Tr40×7"),
    ] {
        assert_eq!(named(name).designation, designation, "{name}");
    }
}

#[test]
fn a_thread_has_its_starts_and_its_hand() {
    for name in ["TR 40×14 P7", "Tr40x14(P7)", "Tr 40 x 14 (P 7)"] {
        let thread = named(name);
        assert_eq!(thread.designation, "Tr40×14 P7");
        assert_eq!((thread.lead, thread.pitch, thread.starts), (14.0, 7.0, 2), "{name}");
        // The profile is that of Tr40×7.
        is_printed(thread.outside.core.mm(), 32.0);
    }
    let thread = named("M16×Ph3P1.5-6H");
    assert_eq!((&*thread.designation, thread.starts), ("M16×Ph3P1.5", 2));
    assert_eq!(find(&thread.designation).as_ref(), Some(&thread));
    for name in ["M10 LH", "Tr40×7 LH", "1/4-20 UNC-2A-LH", "G 1/2 LH", "G 1/2 A LH", "1/2-14 NPT-LH"] {
        assert_eq!(named(name).hand, Hand::Left, "{name}");
    }
    assert_eq!(named("M10-RH").hand, Hand::Right);
}

#[test]
fn other_names_are_not_found() {
    for name in [
        "",
        " ",
        "M",
        "M0",
        "M10x",
        "M10x1.3",
        "M10x1x30",
        "M10.1.1",
        "M72",
        "M35x2",
        "10",
        "1/4",
        "UN 1 1/8",
        "1/4-21",
        "1/4-20 NPT",
        "#1/2-14 NPT",
        "1/0-20",
        "0/0-20",
        "UNC",
        "G",
        "G1/3",
        "G1/2 C",
        "NPT",
        "NPT 7",
        "Tr40",
        "Tr40×14",
        "Tr40×15 P7",
        "Tr40×0 P7",
        "Tr40×700 P7",
        "Tr40×14(P7",
        "Tr40×Ph14",
        "R1/2",
        "W1/4",
        "M10 1",
        "M10-",
        "M10 sharp",
        "M10 ß",
        "M-10",
    ] {
        assert_eq!(find(name), None, "{name}");
    }
}

#[test]
fn hostile_names_are_not_found() {
    for part in ["M", "1/", "9", ".", "-", " ", "(", "M10×1", "×", "\u{0}", "é", "1 1/", "6g"] {
        let long = part.repeat(1_000_000 / part.len());
        assert_eq!((find(&long), suggest(&long)), (None, Vec::new()), "{part}");
        let short = part.repeat(64 / part.len());
        let (_, suggestions) = (find(&short), suggest(&short));
        assert!(suggestions.len() <= 12, "{part}");
    }
    // Beginnings of names, and names without one character.
    for (_, row) in rows().into_iter().step_by(9) {
        for (at, letter) in row.designation.char_indices() {
            let (before, after) = (&row.designation[..at], &row.designation[at + letter.len_utf8()..]);
            find(before);
            find(&format!("{before}{after}"));
        }
    }
}

#[test]
fn suggestions_complete_a_name() {
    for (prefix, designations) in [
        ("M10x1", "M10×1.25, M10×1"),
        ("m 30", "M30, M30×3, M30×2, M30×1.5, M30×1, M300×8, M300×6, M300×4"),
        ("M3", "M3, M3.5, M30, M33, M36, M39, M3×0.35, M3.5×0.35, M30×3, M30×2, M30×1.5, M30×1"),
        ("1/2", "1/2-13 UNC, 1/2-20 UNF, 1/2-28 UNEF, 1/2-14 NPT"),
        ("UNF 1/4", "1/4-28 UNF"),
        ("10-", "#10-24 UNC, #10-32 UNF, 10-8 NPT"),
        ("NPT 3/", "3/8-18 NPT, 3/4-14 NPT"),
        ("g 1 1", "G1 1/8, G1 1/4, G1 1/2"),
        ("tr40", "Tr40×10, Tr40×7, Tr40×3"),
        ("Tr40×7", "Tr40×7"),
        ("", ""),
        (" ", ""),
        ("\"", ""),
        ("Q", ""),
        ("M10×2", ""),
        ("é", ""),
    ] {
        assert_eq!(suggest(prefix).join(", "), designations, "{prefix}");
    }
    assert_eq!(suggest("M").len(), 12);
    for (_, row) in rows().into_iter().step_by(9) {
        assert!(suggest(row.designation).contains(&row.designation), "{}", row.designation);
    }
}
