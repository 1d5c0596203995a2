//! The command line as the build script of a manual calls it: output, exit status, wrong usage.
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};

pub fn run(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_gcode-playground"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command line starts");
    // A command that fails early does not read its input.
    let _ = child.stdin.take().expect("stdin").write_all(input);
    child.wait_with_output().expect("output")
}

fn rows(output: &Output) -> Vec<Value> {
    let text = std::str::from_utf8(&output.stdout).expect("UTF-8");
    text.lines().map(|line| serde_json::from_str(line).expect("one object a line")).collect()
}

pub fn file(name: &str, content: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, content).expect(name);
    path
}

#[test]
fn exit_status_tells_errors_from_bad_usage() {
    assert_eq!(run(&["check", "-"], b"G0 X1\nM30").status.code(), Some(0));
    assert_eq!(run(&["check", "-"], b"G0 X\nM30").status.code(), Some(1));
    assert_eq!(run(&["motions", "-"], b"G7.7").status.code(), Some(1));
    assert_eq!(run(&["check", "there/is/no/such.nc"], b"").status.code(), Some(2));
    assert_eq!(run(&["draw"], b"").status.code(), Some(2));
    assert_eq!(run(&["check"], b"").status.code(), Some(2));
    assert_eq!(run(&["check", "-", "--control", "heidenhain"], b"").status.code(), Some(2));
}

#[test]
fn an_unknown_key_of_a_setup_is_named() {
    for (json, key) in [
        (r#"{"stok": {}}"#, "stok"),
        (r#"{"dialect": {"feedmode": "G98"}}"#, "feedmode"),
        (r#"{"tools": {"T0101": {"radius": 1}}}"#, "radius"),
        (r#"{"stock": {"diameter": 1, "length": 2, "width": 3}}"#, "width"),
    ] {
        let setup = file("unknown-key.json", json);
        let output = run(&["check", "-", "--setup", setup.to_str().unwrap()], b"G0 X1");
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains(key), "{key}");
    }
}

#[test]
fn every_switch_of_a_setup_is_read() {
    let setup = file(
        "all-keys.json",
        r#"{"dialect": {"control": "gsk", "gSystem": "A", "unit": "mm", "decimal": "calculator", "pqUnit": "mm", "powerOnFeed": "G99",
            "feedMode": "G98", "xuConflict": "last", "negativeArcR": "over180", "g71Retract": "feed",
            "g73Intervals": "d-1", "g76Clamp": "prev", "reliefFirst": true, "iInG92": "tpi", "threadChamfer": 10,
            "typeII": true, "strict": false, "polarX": "diameter", "refPoint": {"x": 300, "z": 300}},
            "initial": {"x": 200, "z": 200},
            "tools": {"T0101": {"noseRadius": 0.8, "tip": 3, "toolRadius": 10, "type": "endmill", "geometryR": 10}},
            "stock": {"diameter": 65, "bore": 18, "face": 0, "length": 60}}"#,
    );
    let output = run(&["check", "-", "--setup", setup.to_str().unwrap()], b"G0 X1\nM30");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn check_prints_one_object_a_line() {
    let output = run(&["check", "--format", "json", "-"], "(外圆)\n(😀) GO0 X5\nM30".as_bytes());
    let rows = rows(&output);
    assert_eq!(rows.len(), 1);
    let row = &rows[0];
    assert_eq!((&row["file"], &row["line"], &row["endLine"]), (&json!("<stdin>"), &json!(2), &json!(2)));
    // The emoji counts as two UTF-16 units.
    assert_eq!((&row["column"], &row["endColumn"]), (&json!(6), &json!(9)));
    assert_eq!(
        (&row["severity"], &row["code"], &row["alarm"]),
        (&json!("error"), &json!("E-OCR"), &json!("PS0005"))
    );
    assert!(row["slug"].is_string() && row["message"].is_string() && row["help"].is_string());
    let edit = &row["fixes"][0]["edits"][0];
    assert_eq!((&edit["column"], &edit["endColumn"], &edit["text"]), (&json!(6), &json!(9), &json!("G00")));
    assert_eq!(row["fixes"][0]["safe"], json!(true));
}

#[test]
fn check_shows_carets_in_three_languages() {
    for (language, word) in [("en", "no number"), ("zh", "地址"), ("ru", "адрес")] {
        let output = run(&["check", "--lang", language, "-"], b"G0 X5\nG1 Z\nM30");
        let text = String::from_utf8_lossy(&output.stdout).to_lowercase();
        assert!(
            text.contains("2 | g1 z") && text.contains("|    ^") && text.contains("<stdin>:2:4"),
            "{text}"
        );
        assert!(text.contains(word) || language != "en", "{text}");
    }
}

#[test]
fn rules_are_listed_as_text_and_json() {
    let rows = rows(&run(&["rules", "--format", "json"], b""));
    let row = rows.iter().find(|row| row["slug"] == "dogleg-rapid-through-stock").expect("a rule");
    assert_eq!(
        row,
        &json!({"slug": "dogleg-rapid-through-stock", "codes": ["W-START-IN-STOCK"], "severity": "warning",
                "kind": "machine", "alarms": []})
    );
    let turned = rows.iter().find(|row| row["slug"] == "contour-turns-back").expect("a rule of two alarms");
    assert_eq!(turned["alarms"], json!(["PS0329", "PS0064"]));
    for (language, words) in
        [("en", "depends on the machine"), ("zh", "取决于机床"), ("ru", "зависит от станка")]
    {
        let output = run(&["rules", "--language", language], b"");
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(text.lines().count() == rows.len() && text.contains(words), "{text}");
    }
}

#[test]
fn motions_have_the_documented_keys() {
    let output = run(
        &["motions", "--control", "gsk", "-"],
        b"M3 S1 F100\nG0 X20 Z0\nG3 X40 Z-10 R10\nG92 X18 Z-20 F2\nG4 X1\nM30",
    );
    let rows = rows(&output);
    assert_eq!(rows[0], json!({"kind": "rapid", "to": {"x": 20.0, "z": 0.0}, "line": 2, "rpm": 1.0}));
    assert_eq!(
        rows[1],
        json!({"kind": "arc", "to": {"x": 40.0, "z": -10.0}, "line": 3, "center": {"x": 20.0, "z": -10.0},
               "r": 10.0, "dir": "ccw", "feed": 100.0, "rpm": 1.0, "seconds": 9.424778})
    );
    let thread = rows.iter().find(|row| row["kind"] == "thread").expect("a thread");
    assert_eq!(
        (&thread["lead"], &thread["cycle"], &thread["pass"], &thread["step"]),
        (&json!(2.0), &json!("G92"), &json!(1), &json!("cut"))
    );
    assert_eq!(rows.last().expect("a dwell")["kind"], "dwell");
}

#[test]
fn codes_are_listed_for_all_controls_or_one() {
    let text = |arguments: &[&str]| String::from_utf8(run(arguments, b"").stdout).expect("UTF-8");
    let line = |text: &str, code: &str| {
        let found = text.lines().find(|line| line.trim_start().starts_with(code)).map(|line| {
            let words: Vec<_> = line.split_whitespace().collect();
            words.join(" ")
        });
        found.unwrap_or_default()
    };
    let all = text(&["codes"]);
    assert_eq!(line(&all, "FANUC"), "FANUC A FANUC B FANUC C GSK");
    assert_eq!(line(&all, "G90"), "G90 G77 G20 = turning cycle, straight or taper");
    assert_eq!(line(&all, "G31"), "G31 G31.1 G31.2 G31.3 G31.4 G31.8 = = = skip; not supported here");
    assert_eq!(line(&text(&["codes", "--control", "fanuc"]), "G33"), "");
    assert!(text(&["codes", "--control", "gsk"]).starts_with("  GSK\nMoves and corners\n"));
    assert!(line(&text(&["codes", "--control", "gsk", "--lang", "ru"]), "G33").contains("метчиком"));
    let rows = rows(&run(&["codes", "--format", "json"], b""));
    let turning = rows.iter().find(|row| row["a"] == "G90").expect("G90");
    assert_eq!(
        (&turning["b"], &turning["c"], &turning["gsk"], &turning["group"], &turning["effect"]),
        (&json!("G77"), &json!("G20"), &json!("G90"), &json!(1), &json!("done"))
    );
}

#[test]
fn clean_lists_the_programs_of_a_text_and_writes_one() {
    let text =
        "Example 1: O0007; G00 X32 Z2; G01 Z–30 F0.1; M30;\nand so on\nO8\nG00 X1 Z?2\nM30\n".as_bytes();
    let list = run(&["clean", "-", "--list"], text);
    let listed = String::from_utf8_lossy(&list.stdout).into_owned();
    assert_eq!(listed.lines().count(), 2, "{listed}");
    assert!(listed.starts_with("1\tlines 1-1\t4 changes\t0 questions\tO0007\n"), "{listed}");
    assert!(listed.ends_with("1 questions\tO0008\n"), "{listed}");
    let first = run(&["clean", "-"], text);
    assert_eq!(String::from_utf8_lossy(&first.stdout), "O0007;\nG00 X32 Z2;\nG01 Z-30 F0.1;\nM30;\n");
    assert!(String::from_utf8_lossy(&first.stderr).contains("<stdin>:1:35: A printed dash became a minus"));
    let second = run(&["clean", "-", "--program", "2", "--lang", "ru"], text);
    assert_eq!(String::from_utf8_lossy(&second.stdout), "O8\nG00 X1 Z?2\nM30\n");
    assert!(String::from_utf8_lossy(&second.stderr).contains("Z?2 / Z-2 / Z2"));
    assert_eq!(run(&["clean", "-", "--program", "3"], text).status.code(), Some(2));
    assert_eq!(run(&["clean", "-"], b"no program").status.code(), Some(2));
}

#[test]
fn svg_goes_to_a_file_or_to_standard_output() {
    let program = b"M3 S1\nG0 X20 Z2\nG1 Z-10 F0.2\nM30";
    let output = run(&["svg", "-"], program);
    assert!(output.stdout.starts_with(b"<svg") || output.stdout.starts_with(b"<?xml"));
    let path = file("out.svg", "");
    let output = run(&["svg", "-", "-o", path.to_str().unwrap()], program);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
    assert!(std::fs::read_to_string(path).expect("out.svg").contains("</svg>"));
}

/// A program of `tests/encodings.json`. The page is tested with the same ones.
struct Encoded {
    encoding: String,
    text: String,
    bytes: Vec<u8>,
}

fn encoded() -> Vec<Encoded> {
    let cases: Vec<Value> = serde_json::from_str(include_str!("encodings.json")).expect("encodings.json");
    let text = |case: &Value, key: &str| case[key].as_str().expect("a text").to_owned();
    let byte = |hex: &[u8]| u8::from_str_radix(std::str::from_utf8(hex).unwrap(), 16).expect("hex");
    cases
        .iter()
        .map(|case| Encoded {
            encoding: text(case, "encoding"),
            text: text(case, "text"),
            bytes: text(case, "bytes").as_bytes().chunks(2).map(byte).collect(),
        })
        .collect()
}

#[test]
fn messages_quote_a_program_in_any_encoding() {
    for (input, shown, column) in [
        (&b"(\xb4\xd6\xb3\xb5) G7.7"[..], "(粗车) G7.7", 6),
        (b"(\xd0\xe5\xe7\xe5\xf6) G7.7", "(Резец) G7.7", 9),
        (b"(Gr\xf6\xdfe) G7.7", "(Größe) G7.7", 9),
        (b"\xff\xfe(\0\xd6\0)\0 \0G\x007\x00.\x007\0", "(Ö) G7.7", 5),
    ] {
        let text = run(&["check", "-"], input).stdout;
        let text = std::str::from_utf8(&text).expect("UTF-8");
        assert!(text.contains(shown), "{shown}: {text}");
        let rows = rows(&run(&["check", "--format", "json", "-"], input));
        assert_eq!(rows[0]["column"], json!(column), "{shown}");
    }
}

#[test]
fn rewrite_tells_what_it_wrote_as_a_cycle() {
    let cut = |x: u32| format!("G00 X{x}\nG01 Z-30 F0.1\nX62\nG00 Z2\n");
    let facing = "Z-2\nG01 X20\nZ2\nG00 X62\n";
    let program = format!("G00 X62 Z2\n{}{}{facing}T0202\n{}M30\n", cut(56), cut(50), cut(40));
    let output = run(&["rewrite", "-", "--lang", "ru"], program.as_bytes());
    assert_eq!(output.status.code(), Some(0));
    let written = "G00 X62 Z2\nG90 X56 Z-30 F0.1\nX50\nG94 X20 Z-2\nT0202\nG90 X40 Z-30 F0.1\nM30\n";
    assert_eq!(String::from_utf8_lossy(&output.stdout), written);
    // The line numbers are those of the file, whatever was changed before them.
    let told = [
        "<stdin>:2-9: Записать эти проходы (2) циклом G90",
        "<stdin>:10-13: Записать эти четыре перемещения циклом G94",
        "<stdin>:15-18: Записать эти четыре перемещения циклом G90",
    ];
    assert_eq!(String::from_utf8_lossy(&output.stderr).lines().collect::<Vec<_>>(), told);
}

#[test]
fn fix_writes_the_files_back() {
    // (粗车) in GB18030, and Windows line ends: only the faults change.
    let path = file("fix.nc", "");
    let before = b"O0001 (\xb4\xd6\xb3\xb5)\r\nGO1 X5O F0.1 M3 S500\r\nG00 X60 Z2 T1\r\nG7.7\r\nM30\r\n";
    let after = b"O0001 (\xb4\xd6\xb3\xb5)\r\nG01 X50 F0.1 M3 S500\r\nG00 X60 Z2 T1\r\nG7.7\r\nM30\r\n";
    std::fs::write(&path, before).expect("fix.nc");
    let name = path.to_str().unwrap();
    let dry = run(&["check", "--fix", "--dry-run", name], b"");
    assert_eq!((dry.stdout.as_slice(), dry.status.code()), (&after[..], Some(1)));
    assert!(String::from_utf8_lossy(&dry.stderr).contains("G7.7"));
    assert_eq!(std::fs::read(&path).expect("fix.nc"), before);
    let output = run(&["check", "--fix", "--format", "json", name], b"");
    assert_eq!(std::fs::read(&path).expect("fix.nc"), after);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.lines().count() == 2 && told.starts_with(&format!("{name}:2: ")), "{told}");
    // Faults without a safe fix remain, and are reported.
    let left = rows(&output);
    let left: Vec<_> = left.iter().filter_map(|row| row["slug"].as_str()).collect();
    assert_eq!(left, ["short-tool-word", "unknown-g-code"]);
    assert_eq!(output.status.code(), Some(1));
    // Nothing is left to fix, and the file is not written again.
    let written = std::fs::metadata(&path).and_then(|facts| facts.modified()).expect("a time");
    let again = run(&["check", "--fix", name], b"");
    assert_eq!((again.stderr.len(), again.status.code()), (0, Some(1)));
    assert_eq!(std::fs::metadata(&path).and_then(|facts| facts.modified()).expect("a time"), written);
    // With standard input, the result goes to standard output.
    assert_eq!(run(&["check", "--fix", "-"], before).stdout, after);
    assert_eq!(run(&["check", "--dry-run", "-"], before).status.code(), Some(2));
}

#[test]
fn levels_of_rules_decide_the_exit_status() {
    let setup = file("levels.json", r#"{"rules": {"unknown-g-code": "warning", "no-program-end": "error"}}"#);
    let with = |command: &[&str], input: &[u8]| {
        run(&[command, &["--setup", setup.to_str().unwrap()]].concat(), input)
    };
    assert_eq!(with(&["check", "-"], b"G7.7\nM30").status.code(), Some(0));
    assert_eq!(with(&["check", "-"], b"G00 X1").status.code(), Some(1));
    assert_eq!(with(&["motions", "-"], b"(RULES NO-PROGRAM-END=OFF)\nG00 X1").status.code(), Some(0));
    let rules = rows(&with(&["rules", "--format", "json"], b""));
    let rule = rules.iter().find(|row| row["slug"] == "unknown-g-code").expect("a rule");
    assert_eq!(rule["severity"], json!("warning"));
}

#[test]
fn expand_keeps_the_encoding_and_every_comment() {
    for Encoded { encoding, text, bytes } in encoded() {
        let output = run(&["expand", "-"], &bytes);
        assert_eq!(output.stdout, bytes, "{encoding} {text}");
        assert!(output.stderr.is_empty());
    }
    // A cycle is expanded; the comment of its block is unchanged. (粗车) in GB18030.
    let cycle = b"M3 S1\r\nG0 X50 Z2 (\xb4\xd6\xb3\xb5)\r\nG90 X40 Z-9 F0.2 (\xb4\xd6\xb3\xb5)\r\nM30\r\n";
    let expanded = run(&["expand", "-"], cycle).stdout;
    let comments = expanded.windows(6).filter(|six| six == b"(\xb4\xd6\xb3\xb5)").count();
    assert_eq!((comments, String::from_utf8_lossy(&expanded).contains("G01")), (2, true));
}

#[test]
fn expand_keeps_bytes_that_are_no_text() {
    let all: Vec<u8> = (0..=255).collect();
    for input in
        [all, b"(\xb4\xd6\xb3".to_vec(), b"\xff\xfeG\x00\x00\xd8".to_vec(), b"(\x80 \xff)\n".to_vec()]
    {
        let output = run(&["expand", "-"], &input);
        assert!(matches!(output.status.code(), Some(0 | 1)));
        assert_eq!(output.stdout, input);
    }
}

#[test]
fn bytes_of_any_kind_are_read() {
    for input in [&b""[..], b"\xff\xfe\x00G0 X1", b"((((", b"G0 X1 (\xd0\xcf)\nM30"] {
        let output = run(&["check", "-"], input);
        assert!(matches!(output.status.code(), Some(0 | 1)));
        assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"));
    }
}

/// All corners of a part in rows of [z, x], rounded to a hundredth of a millimetre and sorted.
fn corners(output: &Output) -> Vec<[i64; 2]> {
    fn collect(value: &Value, all: &mut Vec<[i64; 2]>) {
        match value {
            Value::Array(pair) if pair.len() == 2 && pair.iter().all(Value::is_number) => {
                all.push([0, 1].map(|at| (100.0 * pair[at].as_f64().expect("a number")).round() as i64));
            }
            Value::Array(list) => list.iter().for_each(|value| collect(value, all)),
            Value::Object(map) => map.values().for_each(|value| collect(value, all)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    rows(output).iter().for_each(|row| collect(row, &mut all));
    all.sort_unstable();
    all
}

/// A pin of ⌀20 to Z-20 and ⌀30 to Z-40: the part of one program, written as DXF, is the blank of the next one.
#[test]
fn a_drawing_is_the_blank_of_the_next_program() {
    let first = b"(STOCK D=30 LENGTH=40)\nT0101 M3 S800\nG0 X20 Z1\nG1 Z-20 F0.2\nX31\nG0 Z50\nM30";
    let drawing = String::from_utf8(run(&["export", "dxf", "-"], first).stdout).expect("UTF-8");
    let drawing = file("blank.dxf", &drawing);
    let pin = [[-4000, 0], [-4000, 3000], [-2000, 2000], [-2000, 3000], [0, 0], [0, 2000]];
    assert_eq!(corners(&run(&["part", "-"], first)), pin);
    let next = run(&["part", "-", "--setup", drawing.to_str().unwrap()], b"T0101 M3 S800\nG0 X60 Z5\nM30");
    assert_eq!(corners(&next), pin, "{}", String::from_utf8_lossy(&next.stderr));
    let empty = file("empty.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n");
    let refused = run(&["check", "-", "--setup", empty.to_str().unwrap()], b"M30");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("no lines or arcs above the spindle axis"));
}

#[test]
fn export_writes_files_for_other_programs() {
    let program = b"O0007 (PIN)\n(STOCK D=30 LENGTH=40)\nG0 X31 Z0 T0101 M3 S800\nG1 X-1 F0.2\nG0 X20 Z1\nG1 Z-20\nX31\nM30";
    let export = |format: &str, more: &[&str]| {
        let output = run(&[&["export", format, "-"], more].concat(), program);
        assert_eq!(output.status.code(), Some(0), "{format}");
        output.stdout
    };
    let text = |format: &str, more: &[&str]| String::from_utf8(export(format, more)).expect("UTF-8");
    assert!(text("svg", &[]).starts_with("<svg "));
    assert_eq!(text("svg", &[]), String::from_utf8(run(&["svg", "-"], program).stdout).unwrap());
    assert_eq!(text("csv", &[]).lines().count(), 1 + rows(&run(&["motions", "-"], program)).len());
    assert!(text("svg", &["--lang", "ru"]).contains(">X Ø мм<"));
    assert!(text("card", &["--lang", "ru"]).contains(">Z мм<"));
    assert!(text("card", &["--lang", "ru"]).contains("<h1>Карта наладки <b>O0007</b></h1>"));
    assert!(text("card", &[]).contains("Ø30, length 40 mm"));
    assert!(
        text("card", &[]).contains("content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<title>")
    );
    assert!(text("dxf", &[]).starts_with("  0\r\nSECTION\r\n  2\r\nHEADER\r\n"));
    assert!(export("stl", &[]).len() > 84 + 50 * 100);
    assert_eq!(export("program", &[]), run(&["expand", "-"], program).stdout);
    assert_eq!(run(&["export", "png", "-"], program).status.code(), Some(2));
    // These files contain no translated text; `expand` has no `--lang` either.
    for format in ["csv", "dxf", "stl", "program"] {
        let refused = run(&["export", format, "-", "--language", "ru"], program);
        assert_eq!(refused.status.code(), Some(2), "{format}");
        let said = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(said.contains(&format!("no effect on `export {format}`")), "{said}");
        assert!(refused.stdout.is_empty(), "{format}");
    }
    let nothing = run(&["export", "stl", "-"], b"M30");
    assert_eq!(nothing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nothing.stderr).contains("no blank"));
}

#[test]
fn compare_tells_where_two_parts_differ() {
    let [first, second] = [("wide", "X50"), ("narrow", "X48")]
        .map(|(name, x)| file(&format!("{name}.nc"), &format!("T0101\nG00 X62 Z2\nG90 {x} Z-30 F0.2\n")));
    let setup = file("compare.json", r#"{"stock": {"diameter": 60, "length": 60}}"#);
    let picture = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("compare.svg");
    let paths = [&first, &second, &setup, &picture].map(|path| path.to_str().expect("a path"));
    let [first, second, setup, picture] = paths;
    let output = run(&["compare", first, second, "--setup", setup, "--format", "json", "-o", picture], b"");
    assert_eq!(output.status.code(), Some(0));
    let row = &rows(&output)[0];
    assert_eq!(row["radial"]["length"], json!(1.0));
    assert_eq!(row["differences"][0]["only"], json!("first"));
    assert_eq!(row["differences"][0]["x"], json!([48.0, 50.0]));
    let svg = std::fs::read_to_string(picture).expect("a picture");
    assert!(svg.contains(">only in wide.nc<") && svg.contains(r#"class="only first hatch""#));
    let output = run(&["compare", first, second, "--setup", setup], b"");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.starts_with("Only in wide.nc: 30 mm²") && text.contains("radially 1 mm at Z"), "{text}");
    let same = run(&["compare", first, first, "--setup", setup], b"");
    assert_eq!(String::from_utf8_lossy(&same.stdout), "The parts are the same.\n");
}

#[test]
fn the_face_and_the_front_turret_are_drawn() {
    let polar = file("polar.nc", "T0101\nG00 X80 Z2\nG98 G01 Z-5 F100\nG12.1\nG01 X40\nC20\nX-40\nG13.1\n");
    let face = run(&["svg", polar.to_str().unwrap(), "--view", "face"], b"");
    let svg = String::from_utf8_lossy(&face.stdout).into_owned();
    assert!(svg.contains(">C mm<") && svg.contains(r#"data-line="7""#), "{svg}");
    assert_eq!(run(&["svg", "-", "--view", "face"], b"G00 X50 Z2").status.code(), Some(2));
    let drilled = b"(STOCK D=60 LENGTH=60)\n(TOOL T0303 TYPE=DRILL D=8)\nM45\nT0303\nG97 S900 M13\nG00 X66 Z-30 C0\nG98 G87 Z-30 C0 X30 R-1 F80\nC90\nG80\n";
    let side = String::from_utf8(run(&["svg", "-", "--view", "side"], drilled).stdout).expect("UTF-8");
    // The ruler shows the degrees of the program.
    assert!(side.contains(">C °<") && side.contains(">90<") && side.contains(r#"data-line="8""#), "{side}");
    assert_eq!(run(&["svg", "-", "--view", "side"], b"G00 X50 Z2").status.code(), Some(2));
    let turned = |turret: &str| run(&["svg", "-", "--turret", turret], b"G00 X50 Z2\nG01 Z-30 F0.2").stdout;
    assert_ne!(turned("rear"), turned("front"));
    let by_note = run(&["svg", "-"], b"(MACHINE TURRET=FRONT)\nG00 X50 Z2\nG01 Z-30 F0.2").stdout;
    let by_option =
        run(&["svg", "-", "--turret", "front"], b"(              ...     )\nG00 X50 Z2\nG01 Z-30 F0.2")
            .stdout;
    assert_eq!(by_note, by_option);
}

#[test]
fn an_assumed_stock_is_told_and_that_collisions_were_not_checked() {
    let program = b"O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX44\nG0 X100 Z100\nM30\n";
    // The last line of `check` is a summary.
    for (command, last) in [("check", "nothing found in 1 file\n"), ("summary", "")] {
        let text = String::from_utf8(run(&[command, "-"], program).stdout).expect("UTF-8");
        let note = "<stdin>: stock assumed, collisions not checked; to check them, add this comment to the program: (STOCK D=44 LENGTH=25)\n";
        assert!(text.ends_with(&format!("{note}{last}")), "{text}");
        let rows = rows(&run(&[command, "--format", "json", "-"], program));
        let told = rows.last().expect("a row");
        assert_eq!(
            *told,
            json!({
                "file": "<stdin>", "note": "stock-assumed", "notChecked": ["collisions"], "message": told["message"],
                "stock": {"diameter": 44.0, "bore": 0.0, "face": 0.0, "length": 25.0},
            })
        );
    }
    let said = |language: &str| {
        String::from_utf8(run(&["check", "--lang", language, "-"], program).stdout).expect("UTF-8")
    };
    assert!(said("zh").contains("毛坯为假定，未检查碰撞"), "{}", said("zh"));
    assert!(said("ru").contains("заготовка по умолчанию, столкновения не проверялись"), "{}", said("ru"));
    // With the comment, collisions are checked: nothing remains to report.
    let named = String::from_utf8_lossy(program).replace("T0101", "(STOCK D=44 LENGTH=25)\nT0101");
    assert_eq!(run(&["check", "-", "--quiet"], named.as_bytes()).stdout, b"");
    assert_eq!(run(&["check", "-"], named.as_bytes()).stdout, b"nothing found in 1 file\n");
    let crash = named.replace("G0 X100 Z100", "G0 Z-22 X30\nG0 X100 Z100");
    let rows = rows(&run(&["check", "--format", "json", "-"], crash.as_bytes()));
    // Into the stock, and out again.
    let slugs: Vec<_> = rows.iter().map(|row| &row["slug"]).collect();
    assert_eq!(slugs, ["rapid-through-stock", "rapid-through-stock"]);
    // Nothing is cut, so nothing is assumed.
    assert_eq!(run(&["check", "--quiet", "-"], b"G0 X1\nM30").stdout, b"");
}

/// All control characters except line ends and tabs, and those that change the text direction.
fn control_characters() -> String {
    let controls = (1..=0x9fu32).filter_map(char::from_u32).filter(|letter| letter.is_control());
    let controls = controls.filter(|letter| !matches!(letter, '\t' | '\n' | '\r'));
    controls
        .chain("\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}".chars())
        .collect()
}

/// Output about a program contains none of its control characters, on both streams. `with_cr`: a table whose
/// lines end with CR LF.
#[track_caller]
fn has_no_commands(arguments: &[&str], input: &[u8], with_cr: bool) -> usize {
    let output = run(arguments, input);
    for (stream, bytes) in [("output", &output.stdout), ("error", &output.stderr)] {
        let text = std::str::from_utf8(bytes).expect("UTF-8");
        let is_command = |letter: &char| {
            letter.is_control() && !matches!(letter, '\n' | '\t') && !(with_cr && *letter == '\r')
                || "\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}"
                    .contains(*letter)
        };
        let found: Vec<char> = text.chars().filter(is_command).collect();
        assert!(found.is_empty(), "{arguments:?}: {found:?} on standard {stream}\n{text}");
    }
    output.stdout.len() + output.stderr.len()
}

#[test]
fn no_output_has_a_control_character_of_a_program() {
    let controls = control_characters();
    let program = |depth: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=60 GRIP=20)\nT0101 (TURNING {controls} R0.8)\n({controls})\nG97 S800 M03\n\
             G00 X46 Z2 retract{controls} now\nG01 Z{depth} F0.2; turn {controls} x\nX{controls}52\nG7.7 {controls}X60\n\
             G00 X200 \x1b]0;title\x07 Z200\n\x1b[31mX1\nN10 #3000=1 (STOP {controls})\nM30\n"
        )
    };
    // The title of a program in Markdown text.
    let text =
        format!("The {controls} part\nG00 X46 Z2\nG01 Z-5 F0.2 {controls} and \x1b[31mwords\nX50\nG00 X60\n");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("controls");
    std::fs::create_dir_all(&folder).expect("a folder");
    let write = |name: &str, content: &str| -> String {
        let path = folder.join(name);
        std::fs::write(&path, content).expect("a file");
        path.to_str().expect("UTF-8").to_owned()
    };
    // Files whose names contain control characters, if the system allows such names.
    let names = if cfg!(windows) {
        ["one.nc", "other.nc"]
    } else {
        ["one\x1b]0;x\x07\u{9b}\u{202e}.nc", "other\x1b.nc"]
    };
    let files = [write(names[0], &program("-30")), write(names[1], &program("-20"))];
    let [one, other] = [files[0].as_str(), files[1].as_str()];
    let missing = folder.join("no\x1b[31m.nc");
    let missing = missing.to_str().expect("UTF-8");
    for format in ["text", "concise", "json", "sarif", "github", "gitlab", "rdjson", "junit", "markdown"] {
        for language in ["en", "zh", "ru"] {
            let check = ["check", one, other, "--format", format, "--lang", language];
            assert!(has_no_commands(&check, b"", false) > 1000, "{format}");
        }
        has_no_commands(&["check", "-", "--format", format], program("-9").as_bytes(), false);
        let report = folder.join("report");
        let report = report.to_str().expect("UTF-8");
        has_no_commands(&["check", one, "--format", format, "--output-file", report], b"", false);
        let written = std::fs::read_to_string(report).expect("a report");
        assert!(
            !written.contains(|letter: char| letter.is_control() && letter != '\n'),
            "{format}\n{written}"
        );
    }
    for form in ["text", "json"] {
        has_no_commands(&["summary", one, "--format", form], b"", false);
        has_no_commands(&["compare", one, other, "--format", form], b"", false);
    }
    for form in ["text", "json", "markdown"] {
        has_no_commands(&["diff", one, other, "--format", form], b"", false);
    }
    for format in ["svg", "csv", "card", "dxf"] {
        has_no_commands(&["export", format, one], b"", matches!(format, "csv" | "dxf"));
    }
    for arguments in [
        &["motions", one][..],
        &["part", one],
        &["svg", one],
        &["check", one, "--statistics"],
        &["check", missing],
        &["diff", one, missing],
        &["config", one],
        &["explain", "no\x1b[31m-rule"],
        &["check", "--\x1b[31m"],
        &["check", one, "--control", "\x1b[31m"],
    ] {
        has_no_commands(arguments, b"", false);
    }
    assert!(has_no_commands(&["clean", "-", "--list"], text.as_bytes(), false) > 0);
    // A written program is not a report: its bytes stay.
    let kept = run(&["expand", "-"], b"(A\x07)\nG00 X1\nM30\n");
    assert_eq!(kept.stdout, b"(A\x07)\nG00 X1\nM30\n");
}

/// The only escape sequences in a coloured report are its own colours.
#[test]
fn a_coloured_report_has_no_command_of_a_program() {
    let program = "O1\nG00 X1 Z2 \x1b[31mred\x07 text\nM30\n";
    let output = run(&["check", "-", "--color", "always"], program.as_bytes());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.contains("\x1b["), "{text}");
    // Sequences that set a colour, each ended by `m`, and none from the program.
    let rest = text.split('\x1b').skip(1).all(|part| part.starts_with('[') && part.contains('m'));
    assert!(rest && !text.contains('\x07') && !text.contains("\x1b[31mred"), "{text:?}");
}

#[test]
fn fix_keeps_line_ends_that_are_cr_alone() {
    let path = file("carriage-returns.nc", "O1\rG00 X50 Z2\rGO1 Z-5 F0.1\r");
    run(&["check", "--fix", path.to_str().expect("UTF-8")], b"");
    let fixed = std::fs::read_to_string(path).expect("a program");
    assert!(fixed.contains("\rG01 Z-5 F0.1\rM30") && !fixed.contains('\n'), "{fixed:?}");
}
