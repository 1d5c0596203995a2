//! `gcode-playground diff`: cases calculated by hand.
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Turned in four moves at 0.2 mm/rev and 800 rpm, 160 mm/min.
const BASE: &str = "O0001 (STOCK D=60 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X62 Z2\nG00 X50\nG01 Z-20 F0.2\nX56 Z-30\nG00 X100 Z100\nM30\n";

/// A shaft with a diameter of 40 mm, roughed from 60 mm.
const ROUGHED: &str = "O0002 (STOCK D=60 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X60 Z2\nG71 U5 R1\nG71 P10 Q20 U0 W0 F0.2\nN10 G00 X40\nN20 G01 Z-30\nG00 X100 Z100\nM30\n";

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("difference").join(name);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Runs `diff` on two texts, in files of a folder with this name.
fn run(name: &str, first: &str, second: &str, options: &[&str]) -> Output {
    let folder = folder(name);
    let [a, b] = [("a.nc", first), ("b.nc", second)].map(|(file, text)| {
        let path = folder.join(file);
        fs::write(&path, text).expect("a file");
        path
    });
    let command = env!("CARGO_BIN_EXE_gcode-playground");
    Command::new(command).arg("diff").args([a, b]).args(options).output().expect("output")
}

/// The difference as JSON, and the exit status.
fn diff(name: &str, first: &str, second: &str) -> (Value, i32) {
    let output = run(name, first, second, &["--format", "json"]);
    let found = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    (found, output.status.code().expect("a status"))
}

/// The changes of a row as `what: first → second`.
fn changes(row: &Value) -> Vec<String> {
    let text = |value: &Value| value.as_str().expect("text").to_owned();
    let rows = row["changes"].as_array().expect("changes");
    let told =
        |own: &Value| format!("{}: {} → {}", text(&own["what"]), text(&own["first"]), text(&own["second"]));
    rows.iter().map(told).collect()
}

fn total(found: &Value, what: &str) -> [String; 2] {
    let rows = found["totals"].as_array().expect("totals");
    let row = rows.iter().find(|row| row["what"] == what).expect(what);
    [&row["first"], &row["second"]].map(|value| value.as_str().expect("text").to_owned())
}

/// The line numbers of a hunk in the first and in the second version.
fn lines(hunk: &Value) -> [Vec<u64>; 2] {
    let rows = hunk["rows"].as_array().expect("rows");
    ["first", "second"].map(|side| rows.iter().filter_map(|row| row[side]["line"].as_u64()).collect())
}

#[test]
fn a_diameter_is_changed() {
    let (found, status) = diff("diameter", BASE, &BASE.replace("G00 X50\n", "G00 X49.96\n"));
    assert_eq!(status, 1);
    assert_eq!((&found["sameText"], &found["sameMotions"]), (&json!(false), &json!(false)));
    assert_eq!(found["hunks"].as_array().expect("hunks").len(), 1);
    let hunk = &found["hunks"][0];
    assert_eq!(lines(hunk), [vec![5], vec![5]]);
    assert_eq!(changes(&hunk["rows"][0]), ["end: X50 Z2 → X49.96 Z2"]);
    // X stays in force in the next block; the one after it names both axes.
    assert_eq!(hunk["later"]["blocks"], 1);
    assert_eq!(hunk["later"]["rows"][0]["second"]["line"], 6);
    assert_eq!(changes(&hunk["later"]["rows"][0]), ["end: X50 Z-20 → X49.96 Z-20"]);
    // The step is 0.04 mm smaller in diameter.
    assert_eq!(found["part"]["differences"][0]["only"], "first");
    assert!((found["part"]["radial"]["length"].as_f64().expect("a length") - 0.02).abs() < 1e-3, "{found}");
    assert_eq!(total(&found, "tools"), ["T0101", "T0101"]);
    assert_eq!((&found["gone"], &found["new"]), (&json!([]), &json!([])));
}

/// From X60 to X40 the depth is 10 mm: two passes of 5 mm, four of 2.5 mm; the last of them lies on the
/// contour.
#[test]
fn a_cycle_takes_more_passes() {
    let (found, status) = diff("passes", ROUGHED, &ROUGHED.replace("G71 U5", "G71 U2.5"));
    assert_eq!(status, 1);
    let hunk = &found["hunks"][0];
    assert_eq!(lines(hunk), [vec![5], vec![5]]);
    assert_eq!(changes(&hunk["rows"][0]), Vec::<String>::new());
    assert_eq!(hunk["later"]["rows"][0]["second"]["line"], 6);
    let own = changes(&hunk["later"]["rows"][0]);
    let [few, many] = total(&found, "passes").map(|count| count.parse::<u32>().expect("a count"));
    assert_eq!(many - few, 2, "{own:?}");
    assert_eq!(own[0], format!("passes: {few} → {many}"));
    assert_eq!(found["part"]["differences"], json!([]));
}

#[test]
fn a_cycle_follows_a_change_of_its_contour_that_stands_below_it() {
    let changed =
        ROUGHED.replace("O0002 (STOCK", "O0002 (SHAFT) (STOCK").replace("N10 G00 X40", "N10 G00 X42");
    let (found, _) = diff("contour", ROUGHED, &changed);
    let hunks = found["hunks"].as_array().expect("hunks");
    assert_eq!(hunks.len(), 2);
    assert_eq!(hunks[0]["later"]["blocks"], 0);
    assert!(
        hunks[1]["later"]["rows"].as_array().expect("rows").iter().any(|row| row["second"]["line"] == 6),
        "{found}"
    );
}

#[test]
fn n_numbers_blanks_case_zeros_and_line_ends_are_no_difference() {
    let numbered: String =
        BASE.lines().enumerate().map(|(index, line)| format!("N{} {line}\n", 10 * index + 5)).collect();
    let macros = "O1\nN5 #1=50\n/N6 G00 X#1\nN7 IF [#1 GT 5] GOTO 9\nN9 M30\n";
    let (found, status) = diff(
        "macros",
        macros,
        &macros.replace("N5", "N50").replace("N6 ", "N 60").replace("N7 IF [#1 GT 5]", "if[#1 gt5]"),
    );
    assert_eq!(status, 0, "{found}");
    let blanks = BASE.replace("G00 X62 Z2", "  G00X62   Z2 ").replace("G01 Z-20", "\n\nG1 Z-20.00");
    let lower = BASE.replace("G00", "g0").replace("X56", "x056.");
    for (name, other) in [
        ("numbers", numbered),
        ("blanks", blanks),
        ("case", lower),
        ("crlf", BASE.replace('\n', "\r\n")),
        ("same", BASE.to_owned()),
    ] {
        let (found, status) = diff(name, BASE, &other);
        assert_eq!(status, 0, "{name}: {found}");
        assert_eq!((&found["sameText"], &found["sameMotions"]), (&json!(true), &json!(true)), "{name}");
    }
}

#[test]
fn a_renumbered_contour_is_a_change_of_text_alone() {
    let other = ROUGHED.replace("P10 Q20", "P100 Q200").replace("N10", "N100").replace("N20", "N200");
    let (found, status) = diff("renumbered", ROUGHED, &other);
    assert_eq!(status, 1);
    assert_eq!((&found["sameText"], &found["sameMotions"]), (&json!(false), &json!(true)));
    assert_eq!(lines(&found["hunks"][0]), [vec![6], vec![6]]);
    let text = run("renumbered", ROUGHED, &other, &[]);
    let text = String::from_utf8_lossy(&text.stdout).into_owned();
    assert!(text.contains("Only the text differs: the motions are the same."), "{text}");
    assert_eq!(run("renumbered", ROUGHED, &other, &["--motions-only"]).status.code(), Some(0));
    let moved = run("renumbered", ROUGHED, &ROUGHED.replace("X40", "X41"), &["--motions-only"]);
    assert_eq!(moved.status.code(), Some(1));
}

#[test]
fn a_block_is_lost() {
    let (found, status) = diff("lost", BASE, &BASE.replace("X56 Z-30\n", ""));
    assert_eq!(status, 1);
    assert_eq!(lines(&found["hunks"][0]), [vec![7], vec![]]);
    let own = changes(&found["hunks"][0]["rows"][0]);
    assert_eq!(own[0], "moves: feed to X56 Z-30 → –");
    // √(3² + 10²) = 10.44 mm at 160 mm/min take 3.9 s.
    assert_eq!(own[1], "time: 0:03.9 → 0:00.0");
    assert_eq!(found["hunks"][0]["later"]["blocks"], 0);
}

#[test]
fn a_block_is_moved() {
    let first = BASE.replace("G01 Z-20 F0.2\n", "G04 P500\nG01 Z-20 F0.2\n");
    let second = BASE.replace("G01 Z-20 F0.2\n", "G01 Z-20 F0.2\nG04 P500\n");
    let (found, _) = diff("moved", &first, &second);
    let hunks = found["hunks"].as_array().expect("hunks");
    assert_eq!(hunks.len(), 2, "{found}");
    let own: Vec<_> = hunks.iter().map(lines).collect();
    assert!(
        own == [[vec![6], vec![]], [vec![], vec![7]]] || own == [[vec![], vec![6]], [vec![7], vec![]]],
        "{own:?}"
    );
    assert_eq!(total(&found, "time")[0], total(&found, "time")[1]);
    assert_eq!(found["sameMotions"], false);
}

#[test]
fn another_offset_is_a_change_of_all_blocks_that_move() {
    let (found, _) = diff("offset", BASE, &BASE.replace("T0101", "T0102"));
    let later = &found["hunks"][0]["later"];
    assert_eq!(later["blocks"], 5);
    assert_eq!(later["rows"][0]["second"]["line"], 4);
    assert_eq!(changes(&later["rows"][0]), ["tool: T0101 → T0102"]);
    assert_eq!(total(&found, "tools"), ["T0101", "T0102"]);
}

#[test]
fn constant_surface_speed_is_a_change_of_the_cuts() {
    let (found, _) = diff("speed", BASE, &BASE.replace("G97 S800", "G96 S150"));
    let later = &found["hunks"][0]["later"];
    assert_eq!(later["blocks"], 2);
    assert_eq!(later["rows"][0]["second"]["line"], 6);
    assert_eq!(changes(&later["rows"][0]), ["speed: 800 rpm → 150 m/min (G96)"]);
    // The first cut at X50: 150 000 / (50 π) = 955 rpm, 191 mm/min, 22 mm in 6.9 s instead of 8.3 s.
    let [first, second] = total(&found, "time");
    assert!(second < first, "{first} {second}");
}

#[test]
fn a_feed_that_stays_in_force_is_followed() {
    // 22 mm take 8.25 s at 160 mm/min, and 6.6 s at 200 mm/min.
    let (found, _) = diff("feed", BASE, &BASE.replace("F0.2", "F0.25"));
    let hunk = &found["hunks"][0];
    assert_eq!(changes(&hunk["rows"][0]), ["feed: 0.2 mm/rev → 0.25 mm/rev", "time: 0:08.3 → 0:06.6"]);
    assert_eq!(hunk["later"]["blocks"], 1);
    assert_eq!(changes(&hunk["later"]["rows"][0]), ["feed: 0.2 mm/rev → 0.25 mm/rev"]);
}

/// Two modal changes: each later change is attributed to the one that writes its address.
#[test]
fn later_blocks_are_attributed_to_the_change_that_writes_their_address() {
    let other = BASE.replace("S800", "S900").replace("G00 X50\n", "G00 X48\n");
    let (found, _) = diff("causes", BASE, &other);
    let [speed, place] = [0, 1].map(|index| &found["hunks"][index]["later"]);
    assert_eq!(changes(&speed["rows"][0]), ["speed: 800 rpm → 900 rpm"]);
    assert_eq!((&speed["blocks"], &place["blocks"]), (&json!(2), &json!(1)));
    assert_eq!(changes(&place["rows"][0]), ["end: X50 Z-20 → X48 Z-20"]);
}

#[test]
fn the_same_text_read_otherwise_is_a_difference_of_motion() {
    let text = "G00 X62 Z2\nG00 X50\nG01 Z-20 F0.2\nM30\n";
    let folders = [("calculator", "calculator"), ("least", "leastIncrement")].map(|(name, rule)| {
        let folder = folder(name);
        fs::write(folder.join("a.nc"), text).expect("a file");
        fs::write(folder.join("setup.json"), format!(r#"{{"dialect": {{"decimal": "{rule}"}}}}"#))
            .expect("a file");
        fs::write(folder.join("gcode-playground.toml"), "setup = \"setup.json\"\n").expect("a file");
        folder.join("a.nc")
    });
    let command = env!("CARGO_BIN_EXE_gcode-playground");
    let output =
        Command::new(command).arg("diff").args(folders).args(["--format", "json"]).output().expect("output");
    assert_eq!(output.status.code(), Some(1));
    let found: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((&found["sameText"], &found["sameMotions"]), (&json!(true), &json!(false)));
    assert_eq!(found["readAs"][0]["what"], "decimal");
    assert_eq!(found["unexplained"]["blocks"], 3);
    assert_eq!(changes(&found["unexplained"]["rows"][0]), ["end: X62 Z2 → X0.062 Z0.002"]);
    // A decimal point matters if a number without one counts thousandths.
    let setup = folder("least").join("setup.json");
    let points =
        run("points", text, &text.replace("Z-20", "Z-20."), &["--setup", setup.to_str().expect("a path")]);
    assert_eq!(points.status.code(), Some(1));
}

#[test]
fn an_error_of_the_second_version_is_new() {
    let (found, status) = diff("error", BASE, &BASE.replace("X56 Z-30", "X Z-30"));
    assert_eq!(status, 1);
    assert_eq!(found["gone"], json!([]));
    assert_eq!(found["new"][0]["slug"], "number-missing");
    assert_eq!(found["new"][0]["line"], 7);
    // A message that moves with its block is the same, and errors in both versions are no difference.
    let faulty = BASE.replace("X56 Z-30", "X Z-30");
    let (found, status) = diff("moved-error", &faulty, &format!("(MORE)\n{faulty}"));
    assert_eq!((&found["gone"], &found["new"], status), (&json!([]), &json!([]), 1));
    assert_eq!(diff("same-error", &faulty, &faulty).1, 0);
}

#[test]
fn empty_files_are_compared_too() {
    let (found, status) = diff("empty", "", "\n\n");
    assert_eq!((status, &found["hunks"]), (0, &json!([])));
    let (found, status) = diff("from-nothing", "", BASE);
    assert_eq!((status, lines(&found["hunks"][0])), (1, [vec![], (1..=9).collect()]));
    let bytes = run("bytes", "\u{0}\u{1b}[31m(\u{fffd}\n\n%%;;", BASE, &[]);
    assert_eq!(bytes.status.code(), Some(1));
    assert!(!bytes.stdout.contains(&0x1b));
}

#[test]
fn blocks_of_a_hunk_are_paired_by_their_words() {
    let second = BASE.replace("G00 X50\n", "M08\nG00 X49\n");
    let (found, _) = diff("paired", BASE, &second);
    let rows = found["hunks"][0]["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 2);
    assert_eq!((&rows[0]["first"], &rows[0]["second"]["text"]), (&Value::Null, &json!("M08")));
    assert_eq!(changes(&rows[1]), ["end: X50 Z2 → X49 Z2"]);
}

#[test]
fn a_subprogram_is_compared_in_all_its_calls() {
    let main = "O0001\nG97 S800 M03\nG00 X50 Z2\nM98 P30002\nM30\nO0002\nG01 W-2 F0.2\nM99\n";
    let (found, _) = diff("subprogram", main, &main.replace("W-2", "W-3"));
    assert_eq!(changes(&found["hunks"][0]["rows"][0])[0], "end: X50 Z-4 → X50 Z-7");
}

#[test]
fn the_text_reads_well_in_three_languages() {
    let other = BASE.replace("G00 X50\n", "G00 X49.96\n");
    for (language, end, only) in [
        ("en", "end point: X50 Z2 → X49.96 Z2", "only in a.nc"),
        ("zh", "终点: X50 Z2 → X49.96 Z2", "仅在 a.nc 中"),
        ("ru", "конечная точка: X50 Z2 → X49.96 Z2", "только в a.nc"),
    ] {
        let output = run("languages", BASE, &other, &["--lang", language]);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.starts_with("--- a.nc\n+++ b.nc\n"), "{text}");
        assert!(
            text.contains("- G00 X50\n+ G00 X49.96\n") && text.contains(end) && text.contains(only),
            "{text}"
        );
    }
}

#[test]
fn markdown_cannot_be_broken_by_a_program() {
    let other = BASE.replace("G00 X50\n", "G00 X49.96 (``` | <b>)\n");
    let output = run("markdown", BASE, &other, &["--format", "markdown"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(text.starts_with("### `a.nc` → `b.nc`\n") && text.contains("\n````diff\n"), "{text}");
    assert!(text.contains("| Totals | `a.nc` | `b.nc` |\n|---|---|---|\n| time | 0:14.7 |"), "{text}");
}

#[test]
fn the_drawing_has_the_strokes_of_both() {
    let path = folder("drawing").join("both.svg");
    let other = BASE.replace("G00 X50\n", "G00 X40\n");
    run("drawing", BASE, &other, &["-o", path.to_str().expect("a path")]);
    let svg = fs::read_to_string(path).expect("a drawing");
    for class in ["owned both rapid", "owned first", "owned second"] {
        assert!(svg.contains(&format!(r#"<path class="{class}" d="M"#)), "{class}: {svg}");
    }
    assert!(svg.contains(">only in a.nc<") && svg.contains(">in both<"), "{svg}");
}

#[test]
fn bad_usage_and_missing_files_are_told_apart_from_differences() {
    let command = env!("CARGO_BIN_EXE_gcode-playground");
    for arguments in [["diff", "-", "-"], ["diff", "there/is/no/a.nc", "there/is/no/b.nc"]] {
        let output = Command::new(command).args(arguments).output().expect("output");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
}

/// A program with this number of lines, all of them different.
fn long(lines: usize) -> String {
    let mut text = "O0001\nG97 S800 M03\nG00 X50 Z2\nF0.2\n".to_owned();
    (0..lines).for_each(|line| {
        writeln!(text, "N{line} G01 X{}.{:03} Z-{}.5", 10 + line % 40, line % 1000, line % 70).expect("text")
    });
    text + "M30\n"
}

#[test]
fn one_change_in_a_long_program_is_found_soon() {
    let text = long(100_000);
    let started = Instant::now();
    let (found, _) = diff("long", &text, &text.replacen("N50000 G01", "N50000 G00", 1));
    assert!(started.elapsed() < Duration::from_secs(60), "{:?}", started.elapsed());
    assert_eq!(found["hunks"].as_array().expect("hunks").len(), 1);
    assert_eq!(lines(&found["hunks"][0]), [vec![50_005], vec![50_005]]);
}

/// Nothing in common, the same lines in another order, and two kinds of line in random order: no program
/// makes the search slow, and a truncated list ends with a remark.
#[test]
fn hostile_programs_are_compared_in_bounded_time() {
    let lines = 20_000u64;
    let mut random = 7u64;
    let mut next = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        random >> 33
    };
    let mut coins = |_| if next() % 2 == 0 { "G4P1\n" } else { "G4P2\n" };
    let [first, second]: [String; 2] = [0, 1].map(|_| (0..lines).map(&mut coins).collect());
    let different: String = (0..lines).map(|line| format!("(A{line})\n")).collect();
    let backwards: String = (0..lines).rev().map(|line| format!("(A{line})\n")).collect();
    for (name, a, b) in
        [("coins", &first, &second), ("order", &different, &backwards), ("nothing", &different, &first)]
    {
        let started = Instant::now();
        let output = run(name, a, b, &[]);
        assert_eq!(output.status.code(), Some(1), "{name}");
        assert!(started.elapsed() < Duration::from_secs(60), "{name}: {:?}", started.elapsed());
        assert!(
            String::from_utf8_lossy(&output.stdout).contains("more changed blocks are not shown"),
            "{name}"
        );
    }
}

/// The cuts after a shift are at another place of the workpiece, although their words are the same.
#[test]
fn another_shift_of_the_work_zero_is_another_motion() {
    let version = |shift: &str| {
        format!(
            "O1 (STOCK D=50 LENGTH=100)\nT0303\nG97 S500 M03\nG00 X52 Z-13\nG01 X30 F0.1\nG00 X52\nG52 Z{shift}\nG00 X52 Z-13\nG01 X30\nG00 X60\nM30\n"
        )
    };
    let (found, status) = diff("shift", &version("-30"), &version("-40"));
    assert_eq!((&found["sameMotions"], status), (&json!(false), 1));
    let (found, status) = diff("no-shift", &version("-30"), &version("-30"));
    assert_eq!((&found["sameMotions"], status), (&json!(true), 0));
}
