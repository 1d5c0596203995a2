//! `gcode-playground check` as a team uses it on its programs: paths, formats, selection, baseline, exit
//! status.
use std::fs;
use std::process::{Command, Output};

use serde_json::{Value, json};

use crate::folder::{FAULTY, Folder, err, out, rows};

const RIGHT: &str = "O2\nM3 S500\nG0 X50 Z2\nM30\n";

/// The files that a check has read, in order.
fn files(folder: &Folder, arguments: &[&str]) -> Vec<String> {
    let arguments = [&["--format", "junit"], arguments].concat();
    let text = out(&folder.check(&arguments)).replace('\\', "/");
    let names = text.split("<testsuite name=\"").skip(1);
    names.map(|rest| rest.split('"').next().expect("a name").trim_start_matches("./").to_owned()).collect()
}

fn many(name: &str) -> Folder {
    Folder::new(name)
        .with("a.nc", FAULTY)
        .with("sub/b.TAP", RIGHT)
        .with("sub/O0003", RIGHT)
        .with("sub/notes.txt", "nothing")
        .with("old/c.nc", FAULTY)
        .with("kept/old/d.nc", RIGHT)
        .with(".hidden/e.nc", RIGHT)
        .with(".gitignore", "/old\n")
}

#[test]
fn a_folder_stands_for_the_programs_in_it() {
    let folder = many("found");
    assert_eq!(files(&folder, &["."]), ["a.nc", "kept/old/d.nc", "sub/O0003", "sub/b.TAP"]);
    assert_eq!(files(&folder, &["sub", "sub/b.TAP", "a.nc"]), ["sub/O0003", "sub/b.TAP", "a.nc"]);
    // Files named explicitly are checked, whatever their extension and the ignore patterns.
    assert_eq!(files(&folder, &["old/c.nc", "sub/notes.txt"]), ["old/c.nc", "sub/notes.txt"]);
}

/// Extensions of 106 public programs: more than half were not among the usual ones.
#[test]
fn a_folder_is_searched_for_programs_by_ending_and_by_text() {
    let mut folder =
        Folder::new("endings").with("README.txt", "Programs for the small lathe.\nSee the sheet.\n");
    folder = folder
        .with("part.h", "#ifndef PART_H\n#define PART_H\nint x;\n#endif\n")
        .with("LICENSE", "MIT License\n")
        .with("p.pdf", "%PDF-1.4");
    let programs = ["a.gc", "b.pgm", "c.dnc", "d.ncc", "e.PIM", "f.txt", "g.g", "h.h", "part"];
    for name in programs {
        folder = folder.with(name, RIGHT);
    }
    assert_eq!(files(&folder, &["."]), programs);
    let told = err(&folder.check(&["."]));
    assert!(told.contains("4 files left out because of their ending or content"), "{told}");
    assert!(!err(&folder.check(&[".", "--quiet"])).contains("not checked"));
    assert!(!err(&folder.check(&["a.gc"])).contains("not checked"));
    assert!(err(&folder.check(&[".", "--extension", "gc"])).contains("12 files left out"));
}

/// The beginning of a file decides whether it is a program. It may end within a line or a character.
#[test]
fn of_a_long_file_only_the_beginning_shows_what_it_is() {
    let program =
        |line: &str| format!("O1\nG21 G99 G97 S500 M03 T0101\n{}M30\n", line.repeat(200_000 / line.len()));
    let text = program("G01 X50. Z-1. F.2 (精车)\n");
    let folder = Folder::new("long")
        .with("a.txt", &text)
        .with("b.txt", text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>())
        .with("c.txt", program("G01 X50.\r"))
        .with("d.txt", format!("{}G01 X50.\n", "These are words.\n".repeat(10_000)));
    assert_eq!(files(&folder, &["."]), ["a.txt", "b.txt", "c.txt"]);
}

/// A control has all programs in its memory; here each is a separate file.
#[test]
fn subprograms_are_found_in_files_of_their_own() {
    let main = |call: &str| {
        format!("%\nO0001\nG21 G99 G97 S500 M03 T0101\nG00 X42. Z2.\n{call}\nG00 X100. Z100.\nM30\n%\n")
    };
    let pass = |head: &str| format!("%\n{head}G01 W-5. F.2\nM99\n%\n");
    let folder = Folder::new("subprograms")
        .with("number.nc", main("M98 P2000"))
        .with("O2000.nc", pass("O2000\n"))
        .with("other.nc", main("M98 P32001"))
        .with("2001.txt", "G01 W-5. F.2\nM99\n")
        .with("bare.nc", main("G65 P2002"))
        .with("O2002", pass("O1\nM99\nO2002\n"))
        .with("name.nc", main("M98 <pass>"))
        .with("PASS.NC", pass("<PASS>\n"))
        .with("nested.nc", main("M98 P3000"))
        .with("O3000.nc", "O3000\nM98 P2000\nM99\n")
        .with("shelf.nc", main("M98 P4000"))
        .with("shelf/O4000.nc", pass("O4000\n"))
        .with("wrong.nc", main("M98 P5000"))
        .with("O5000.nc", pass("O5001\n"))
        .with("faulty.nc", main("M98 P6000"))
        .with("O6000.nc", "O6000\nG7.7\nG7.8\nM99\n")
        .with("deep.nc", main("M98 P6001"))
        .with("O6001.nc", "O6001\nM98 P6000\nM99\n")
        .with("sign.nc", "O0001\n%\nG21 G99 G97 S500 M03 T0101\nG00 X42. Z2.\nM98 P2000\nG01 W-5. F.2\nM30\n")
        .with("head.nc", main("M98 P7000"))
        .with("O7000.nc", "O7000\n%\nG01 W-5. F.2\nM99\n%\n");
    let run = |command: &str, arguments: &[&str]| {
        let mut gcode = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
        gcode.current_dir(&folder.0).arg(command).args(arguments).output().expect("it runs")
    };
    let cuts = |arguments: &[&str]| out(&run("motions", arguments)).matches("\"kind\":\"feed\"").count();
    for (file, count) in [("number.nc", 1), ("other.nc", 3), ("bare.nc", 1), ("name.nc", 1), ("nested.nc", 1)]
    {
        assert_eq!(cuts(&[file]), count, "{file}");
        let told = out(&folder.check(&[file, "--format", "json"]));
        assert!(!told.contains("\"slug\""), "{file}: {told}");
    }
    // A header before the `%` sign, in the program and in the subprogram.
    assert_eq!((cuts(&["sign.nc"]), cuts(&["head.nc"])), (2, 1));
    for file in ["shelf.nc", "wrong.nc"] {
        assert_eq!(cuts(&[file]), 0, "{file}");
        assert!(out(&folder.check(&[file])).contains("is not in this file"), "{file}");
    }
    assert_eq!(cuts(&["shelf.nc", "--library", "shelf"]), 1);
    assert!(!out(&folder.check(&["shelf.nc", "--library", "shelf"])).contains("is not in this file"));
    // Errors in a subprogram are reported for its own file. The first error, which ends the collision check,
    // is reported at the call as well.
    assert!(out(&folder.check(&["O6000.nc"])).contains("G7.7"));
    for (file, call) in [("faulty.nc", "P6000"), ("deep.nc", "P6001")] {
        let told = out(&folder.check(&[file]));
        assert!(told.contains(&format!("{file}:5:5\n")) && told.contains(call), "{told}");
        assert_eq!((told.matches("error[").count(), told.contains("G7.8")), (1, false), "{told}");
    }
    // Fixes do not write it into the program.
    let before = fs::read(folder.0.join("number.nc")).expect("a program");
    folder.check(&["number.nc", "--fix"]);
    assert_eq!(fs::read(folder.0.join("number.nc")).expect("a program"), before);
    let configured = folder.with("gcode-playground.toml", "library = \"shelf\"\n");
    let mut gcode = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    let motions = gcode.current_dir(&configured.0).args(["motions", "shelf.nc"]).output().expect("it runs");
    assert_eq!(out(&motions).matches("\"kind\":\"feed\"").count(), 1);
}

/// Collisions of a subprogram depend on the blank and the tool of the calling program.
#[test]
fn dangers_in_a_subprogram_are_reported_at_the_call() {
    let main = "O0001 (STOCK D=50 LENGTH=80)\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nM98 P2001\nG00 X100. Z100.\nM30\n";
    let subprogram = "O2001\nG00 X40.\nG00 Z-20.\nG00 X60.\nM99\n";
    let folder = Folder::new("dangers")
        .with("main.nc", main)
        .with("O2001.nc", subprogram)
        .with("one/main.nc", [main, subprogram].concat());
    let places = |file: &str| -> Vec<(u64, u64)> {
        let told = out(&folder.check(&[file, "--format", "json"]));
        let rows = told.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
        let dangers = rows.filter(|row| row["slug"] == "rapid-through-stock");
        dangers
            .map(|row| (row["line"].as_u64().expect("a line"), row["column"].as_u64().expect("a column")))
            .collect()
    };
    assert_eq!(places("one/main.nc").first(), Some(&(9, 1)));
    assert_eq!(places("main.nc"), [(4, 5)]);
}

#[test]
fn patterns_and_endings_choose() {
    let folder = many("chosen");
    assert_eq!(files(&folder, &[".", "--exclude", "sub/**", "--exclude", "d.nc"]), ["a.nc"]);
    assert_eq!(files(&folder, &[".", "--extension", "txt,TAP"]), ["sub/O0003", "sub/b.TAP", "sub/notes.txt"]);
    let none = folder.check(&["kept", "--extension", "xyz"]);
    assert_eq!(none.status.code(), Some(2));
    assert!(err(&none).contains("no file with the ending xyz"), "{}", err(&none));
    let bad = folder.check(&[".", "--exclude", "a[b"]);
    assert_eq!(bad.status.code(), Some(2));
    assert!(err(&bad).contains("a[b"), "{}", err(&bad));
}

#[test]
fn a_file_that_cannot_be_read_hides_nothing() {
    let folder = many("unreadable");
    let output = folder.check(&["gone.nc", "a.nc", "also/gone.nc"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(out(&output).contains("a.nc:3"), "{}", out(&output));
    assert!(err(&output).contains("gone.nc") && err(&output).contains("also/gone.nc"), "{}", err(&output));
}

#[test]
fn a_file_beyond_the_limit_is_refused_before_it_is_read() {
    let folder =
        Folder::new("large").with("setup.json", r#"{"limits": {"text": 1048576}}"#).with("a.nc", FAULTY);
    // A sparse file: three gigabytes that take no disk space, and no memory unless they are read.
    fs::File::create(folder.0.join("large.nc")).and_then(|file| file.set_len(3 << 30)).expect("a file");
    let output = folder.check(&["large.nc", "a.nc", "--setup", "setup.json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("large.nc: more than 1 MB"), "{}", err(&output));
    assert!(out(&output).contains("a.nc:3"));
    // Endless standard input is read only up to the limit.
    let input = vec![b' '; 3 << 20];
    let output = folder.piped(&["-", "--setup", "setup.json"], &input);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("standard input: more than 1 MB"), "{}", err(&output));
}

#[test]
fn standard_input_has_the_name_it_is_given() {
    let folder = Folder::new("stdin");
    let output = folder.piped(&["-", "--stdin-filename", "part 1.nc", "--format", "json"], FAULTY.as_bytes());
    assert_eq!(rows(&output)[0]["file"], "part 1.nc");
    assert_eq!(output.status.code(), Some(1));
    let empty = folder.piped(&["-"], b"");
    assert!(out(&empty).contains("no program"), "{}", out(&empty));
}

#[test]
fn names_and_texts_of_any_kind_are_reported_as_they_are() {
    let chinese = b"O1(\xcd\xe2\xd4\xb2\xb3\xb5\xcf\xf7)\r\nM3 S500\r\nG0 X\r\nM30\r\n";
    let folder = Folder::new("names").with("ü ß 外圆.nc", FAULTY).with("gbk.nc", chinese);
    let output = folder.check(&[".", "--format", "json"]);
    let rows = rows(&output);
    let at: Vec<_> = rows
        .iter()
        .filter(|row| row["slug"].is_string())
        .map(|row| (row["file"].as_str().unwrap().trim_start_matches("./"), row["line"].clone()))
        .collect();
    assert_eq!(at, [("gbk.nc", json!(3)), ("ü ß 外圆.nc", json!(3))]);
}

#[test]
fn control_characters_of_a_file_never_reach_the_terminal() {
    let folder = Folder::new("control").with("a.nc", "O1\nG0 X (\u{1b}[31mRED\u{7})\nM30\n");
    for format in ["text", "concise", "json", "sarif", "github", "gitlab", "rdjson", "junit", "markdown"] {
        let output = folder.check(&["a.nc", "--format", format, "--color", "never"]);
        let found = out(&output).bytes().find(|byte| *byte < b' ' && *byte != b'\n');
        assert_eq!(found, None, "{format}: {}", out(&output));
    }
}

#[test]
fn the_last_line_sums_up() {
    let folder = Folder::new("summary").with("a.nc", FAULTY).with("b.nc", "O2\nM3 S500\nGO0 X5\nM30\n");
    let last = |arguments: &[&str]| {
        let text = out(&folder.check(&[&["."], arguments].concat()));
        text.lines().last().unwrap_or_default().to_owned()
    };
    assert_eq!(last(&[]), "2 errors in 2 files, 1 fixable with --fix");
    assert_eq!(last(&["--lang", "zh"]), "2 个错误，共 2 个文件，其中 1 处可用 --fix 修复");
    assert_eq!(last(&["--lang", "ru"]), "ошибок: 2; файлов: 2; исправит --fix: 1");
    assert!(!last(&["--quiet"]).contains("2 files"));
    assert_eq!(last(&["--select", "thread-angle"]), "nothing found in 2 files");
}

#[test]
fn colours_are_for_terminals_unless_they_are_asked_for() {
    let folder = Folder::new("colours").with("a.nc", FAULTY);
    let has = |output: &Output| output.stdout.contains(&0x1b);
    assert!(!has(&folder.check(&["a.nc"])));
    assert!(has(&folder.check(&["a.nc", "--color", "always"])));
    assert!(!has(&folder.check(&["a.nc", "--color", "never"])));
    let asked =
        folder.command(&["a.nc", "--color", "always"]).env("NO_COLOR", "1").output().expect("it runs");
    assert!(has(&asked), "what is asked for by the option holds");
}

#[test]
fn statistics_count_the_rules() {
    let folder = Folder::new("statistics").with("a.nc", "O1\nM3 S500\nG0 X\nG0 Z\nG0 X5 X6\nM30\n");
    let text = out(&folder.check(&["a.nc", "--statistics"]));
    assert_eq!(text, "     2  number-missing\n     1  duplicate-word\n");
    let json = rows(&folder.check(&["a.nc", "--statistics", "--format", "json"]));
    assert_eq!(json[0], json!({"slug": "number-missing", "count": 2}));
}

#[test]
fn a_report_may_go_into_a_file() {
    let folder = Folder::new("file").with("a.nc", FAULTY);
    let output = folder.check(&["a.nc", "--format", "sarif", "--output-file", "out.sarif"]);
    assert!(output.stdout.is_empty());
    let text = fs::read_to_string(folder.0.join("out.sarif")).expect("a file");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(report["runs"][0]["results"][0]["ruleId"], "number-missing");
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn github_has_a_line_for_each_finding() {
    let folder = Folder::new("github").with("a,b.nc", FAULTY);
    let text = out(&folder.check(&["a,b.nc", "--format", "github"]));
    assert!(text.starts_with("::error file=a%2Cb.nc,line=3,endLine=3,col=4,endColumn=5,title="), "{text}");
    assert_eq!(text.lines().count(), 1);
}

#[test]
fn junit_is_well_formed_and_counts_what_fails() {
    let folder = Folder::new("junit").with("a&b.nc", FAULTY).with("right.nc", RIGHT);
    let text = out(&folder.check(&[".", "--format", "junit"]));
    assert!(text.contains("a&amp;b.nc\" tests=\"1\" failures=\"1\""), "{text}");
    assert!(text.contains("right.nc\" tests=\"1\" failures=\"0\""), "{text}");
    assert_eq!(text.matches("<testsuite ").count(), text.matches("</testsuite>").count());
}

#[test]
fn markdown_is_a_table() {
    let folder = Folder::new("markdown").with("a_b|c.nc", FAULTY);
    let text = out(&folder.check(&["a_b|c.nc", "--format", "markdown"]));
    let row = text.lines().nth(2).expect("a row");
    assert!(row.starts_with("| a\\_b\\|c.nc | 3 | Error | "), "{text}");
}

#[test]
fn sarif_has_places_rules_and_repairs() {
    let folder = Folder::new("sarif").with("a b.nc", "O1\nM3 S500\n(😀) GO0 X5\nM30\n").with("c.nc", FAULTY);
    let report: Value = serde_json::from_str(&out(&folder.check(&[".", "--format", "sarif"]))).expect("JSON");
    let results = report["runs"][0]["results"].as_array().expect("results");
    assert_eq!(results.len(), 2);
    let place = &results[0]["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "a%20b.nc");
    // The emoji counts as two UTF-16 units, the unit that the report declares for its columns.
    assert_eq!(place["region"], json!({"startLine": 3, "startColumn": 6, "endLine": 3, "endColumn": 9}));
    assert_eq!(report["runs"][0]["columnKind"], "utf16CodeUnits");
    let repair = &results[0]["fixes"][0]["artifactChanges"][0]["replacements"][0];
    assert_eq!(repair["insertedContent"]["text"], "G00");
    let rules = report["runs"][0]["tool"]["driver"]["rules"].as_array().expect("rules");
    let mut found: Vec<_> = results.iter().map(|result| result["ruleId"].as_str().unwrap()).collect();
    found.sort_unstable();
    assert_eq!(rules.iter().map(|rule| rule["id"].as_str().unwrap()).collect::<Vec<_>>(), found);
    // Without findings the report is still complete.
    let none = Folder::new("sarif-none").with("a.nc", RIGHT).check(&["a.nc", "--format", "sarif"]);
    let none: Value = serde_json::from_str(&out(&none)).expect("JSON");
    assert_eq!(none["runs"][0]["results"], json!([]));
}

#[test]
fn sarif_has_an_address_for_a_file_that_is_named_from_the_root() {
    let folder = Folder::new("sarif-anywhere").with("a b.nc", FAULTY);
    let file = folder.0.join("a b.nc");
    let output = folder.check(&[file.to_str().expect("UTF-8"), "--format", "sarif"]);
    let report: Value = serde_json::from_str(&out(&output)).expect("JSON");
    let place = &report["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
    let address = place["artifactLocation"]["uri"].as_str().expect("an address");
    assert!(address.starts_with("file:///") && address.ends_with("/a%20b.nc"), "{address}");
}

#[test]
fn rules_are_selected_ignored_and_graded() {
    let folder = Folder::new("selection").with("a.nc", "O1\nM3 S500\nG0 X\nG7.7\nM30\n");
    let found = |arguments: &[&str]| {
        let output = folder.check(&[&["a.nc", "--format", "json", "-q"], arguments].concat());
        let slugs: Vec<String> = rows(&output)
            .iter()
            .map(|row| format!("{} {}", row["slug"], row["severity"]).replace('"', ""))
            .collect();
        (slugs, output.status.code())
    };
    let owned = |slugs: &[&str]| slugs.iter().map(|slug| (*slug).to_owned()).collect::<Vec<_>>();
    let both = owned(&["number-missing error", "unknown-g-code error"]);
    assert_eq!(found(&[]), (both, Some(1)));
    assert_eq!(found(&["--select", "unknown-g-code"]), (owned(&["unknown-g-code error"]), Some(1)));
    assert_eq!(found(&["--ignore", "unknown-g-code,NUMBER-MISSING"]), (owned(&[]), Some(0)));
    let graded = owned(&["number-missing warning", "unknown-g-code info"]);
    let levels = ["--severity", "number-missing=warning,unknown-g-code=info"];
    assert_eq!(found(&levels), (graded.clone(), Some(0)));
    assert_eq!(found(&[&levels[..], &["--max-warnings", "0"]].concat()), (graded.clone(), Some(1)));
    assert_eq!(found(&[&levels[..], &["--max-warnings", "1"]].concat()), (graded, Some(0)));
    for wrong in [["--select", "unknown-g-cdoe"], ["--severity", "x"], ["--severity", "unknown-g-code=bad"]] {
        let output = folder.check(&[&["a.nc"], &wrong[..]].concat());
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
    }
    assert!(err(&folder.check(&["a.nc", "--ignore", "unknown-g-cdoe"])).contains("`unknown-g-code`"));
}

#[test]
fn what_is_known_does_not_fail() {
    let folder = Folder::new("baseline").with("a.nc", FAULTY);
    let written = folder.check(&["a.nc", "--write-baseline", "known.json"]);
    assert_eq!(written.status.code(), Some(1), "what is found is reported all the same");
    let known = |text: &str| {
        fs::write(folder.0.join("a.nc"), text).expect("a file");
        let output = folder.check(&["a.nc", "--baseline", "known.json", "--format", "json", "-q"]);
        (rows(&output).len(), output.status.code())
    };
    assert_eq!(known(FAULTY), (0, Some(0)));
    // Blocks may move and be renumbered.
    assert_eq!(known("O1\n(REMARK)\nM3 S500\nN30 G0  X\nM30\n"), (0, Some(0)));
    // One more occurrence than the baseline contains is new.
    assert_eq!(known("O1\nM3 S500\nG0 X\nG0 X\nM30\n"), (1, Some(1)));
    assert_eq!(known("O1\nM3 S500\nG0 Z\nM30\n"), (1, Some(1)));
    fs::write(folder.0.join("known.json"), "{}").expect("a file");
    assert_eq!(folder.check(&["a.nc", "--baseline", "known.json"]).status.code(), Some(2));
}

#[test]
fn many_files_are_reported_in_their_order() {
    let mut folder = Folder::new("order");
    for number in 0..400 {
        folder = folder.with(&format!("{number:03}.nc"), if number % 7 == 0 { FAULTY } else { RIGHT });
    }
    let output = folder.check(&[".", "--format", "json", "-q"]);
    let files: Vec<String> =
        rows(&output).iter().map(|row| row["file"].as_str().unwrap().to_owned()).collect();
    assert_eq!(files.len(), 58);
    assert!(files.is_sorted(), "{files:?}");
}

/// `--select` and the `select` key of the configuration apply to messages and fixes.
#[test]
fn fixes_are_those_of_the_selected_rules() {
    let before = "O1\nGO1 X50 F0.1 M3 S500 (FACE\nM30\n";
    let with_comment = "O1\nGO1 X50 F0.1 M3 S500 (FACE)\nM30\n";
    let folder = Folder::new("selected").with("a.nc", before);
    let fixed =
        |arguments: &[&str]| out(&folder.check(&[&["--fix", "--dry-run", "a.nc"], arguments].concat()));
    assert_eq!(fixed(&["--select", "comment-not-closed"]), with_comment);
    assert_eq!(fixed(&["--select", "no-program-end"]), before);
    assert_eq!(fixed(&[]), "O1\nG01 X50 F0.1 M3 S500 (FACE)\nM30\n");
    let folder = folder.with("gcode-playground.toml", "select = [\"comment-not-closed\"]\n");
    assert_eq!(out(&folder.check(&["--fix", "--dry-run", "a.nc"])), with_comment);
}

/// Offsets count in the decoded text: applying the edits of a fix by offset fixes it and changes nothing
/// else.
#[test]
fn offsets_are_those_of_the_text_as_it_is_written() {
    let program = "O0001 (外圆 😀)\nT0101 (ROUGH\nGO1 X5 F0.1 M3 S500";
    let texts = [
        program.to_owned(),
        program.replace('\n', "\r\n"),
        program.replace('\n', "\r"),
        program.replacen('\n', "\r\n", 2),
    ];
    for text in texts {
        let folder = Folder::new("offsets").with("a.nc", &text);
        let mut units: Vec<u16> = text.encode_utf16().collect();
        let mut edits: Vec<(usize, usize, String)> = Vec::new();
        for row in rows(&folder.check(&["a.nc", "--format", "json"])) {
            let Some(fixes) = row["fixes"].as_array() else { continue };
            let at = |value: &Value, key: &str| value[key].as_u64().unwrap() as usize;
            if row["slug"] == "letter-for-digit" {
                let quoted = String::from_utf16(&units[at(&row, "from")..at(&row, "to")]).unwrap();
                assert_eq!(quoted, "GO1", "{text:?}");
            }
            for edit in fixes
                .iter()
                .filter(|fix| fix["safe"] == true)
                .flat_map(|fix| fix["edits"].as_array().unwrap())
            {
                edits.push((at(edit, "from"), at(edit, "to"), edit["text"].as_str().unwrap().to_owned()));
            }
        }
        edits.sort();
        for (from, to, new) in edits.into_iter().rev() {
            units.splice(from..to, new.encode_utf16());
        }
        let repaired = String::from_utf16(&units).unwrap();
        assert!(repaired.contains("G01 X5") && repaired.contains("(ROUGH)"), "{repaired:?}");
        assert_eq!(repaired, out(&folder.check(&["a.nc", "--fix", "--dry-run"])), "as --fix writes it");
    }
    // GBK: each decoded character of the comment is one unit.
    let folder = Folder::new("offsets-gbk").with("a.nc", "");
    std::fs::write(folder.0.join("a.nc"), b"O0001 (\xb4\xd6\xb3\xb5)\r\nGO1 X5 F0.1 M3 S500\r\nM30\r\n")
        .expect("a file");
    let rows = rows(&folder.check(&["a.nc", "--format", "json"]));
    let found = rows.iter().find(|row| row["slug"] == "letter-for-digit").expect("a message");
    assert_eq!((found["from"].as_u64(), found["to"].as_u64()), (Some(12), Some(15)));
}

#[test]
fn a_repaired_program_is_reported_as_any_other() {
    let folder = Folder::new("repaired").with("a.nc", "O1\nGO1 X5O F0.1 M3 S500\nG7.7\nM30\n");
    let slugs = |arguments: &[&str]| {
        let output = folder.check(&[&["--fix", "--dry-run", "a.nc", "--format", "json"], arguments].concat());
        assert_eq!(out(&output), "O1\nG01 X50 F0.1 M3 S500\nG7.7\nM30\n");
        let said = err(&output);
        let rows = said.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let slugs = rows.filter_map(|row| row["slug"].as_str().map(str::to_owned));
        (slugs.collect::<Vec<_>>(), output.status.code())
    };
    assert_eq!(slugs(&[]), (vec!["unknown-g-code".to_owned()], Some(1)));
    assert_eq!(slugs(&["--severity", "unknown-g-code=info"]).1, Some(0));
    assert_eq!(slugs(&["--ignore", "unknown-g-code"]), (vec![], Some(0)));
    folder.check(&["a.nc", "--fix", "--write-baseline", "known.json"]);
    assert_eq!(slugs_of(&folder.check(&["a.nc", "--fix", "--baseline", "known.json"])), [""; 0]);
    let report = folder.check(&["a.nc", "--fix", "--format", "sarif", "--output-file", "out.sarif"]);
    assert_eq!((out(&report).as_str(), report.status.code()), ("", Some(1)));
    let sarif: Value =
        serde_json::from_str(&fs::read_to_string(folder.0.join("out.sarif")).expect("a report"))
            .expect("JSON");
    assert_eq!(sarif["runs"][0]["results"][0]["ruleId"], "unknown-g-code");
    assert!(out(&folder.check(&["a.nc", "--fix"])).ends_with("1 error in 1 file\n"));
    let quiet = out(&folder.check(&["a.nc", "--fix", "--quiet"]));
    assert!(quiet.contains("G7.7") && !quiet.contains("1 error in"), "{quiet}");
    let named = folder.piped(&["-", "--fix", "--stdin-filename", "b c.nc"], FAULTY.as_bytes());
    assert!(err(&named).contains("b c.nc:3"), "{}", err(&named));
}

fn slugs_of(output: &Output) -> Vec<String> {
    let text = out(output);
    let rows = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    rows.filter_map(|row| row["slug"].as_str().map(str::to_owned)).collect()
}

const PAGE: &str = "# Turning\n\n```gcode\nO1\nM3 S500\nG0 X\nM30\n```\n\n<gcode-playground vew=\"all\"><pre>O2\nM30\n</pre></gcode-playground>\n";

#[test]
fn pages_of_a_manual_are_reported_as_any_other_file() {
    let folder = Folder::new("pages").with("page.md", PAGE);
    let pages = |arguments: &[&str]| folder.check(&[&["--markdown", "."], arguments].concat());
    let sarif: Value = serde_json::from_str(&out(&pages(&["--format", "sarif"]))).expect("JSON");
    let results = sarif["runs"][0]["results"].as_array().expect("results");
    let found: Vec<_> = results
        .iter()
        .map(|one| {
            let line = &one["locations"][0]["physicalLocation"]["region"]["startLine"];
            (one["ruleId"].as_str().unwrap(), line.as_u64().unwrap(), one["level"].as_str().unwrap())
        })
        .collect();
    assert_eq!(found, [("number-missing", 6, "error"), ("attribute-wrong", 10, "error")]);
    assert!(out(&pages(&["--format", "github"])).contains("::error file=page.md,line=10"));
    assert!(out(&pages(&["--format", "junit"])).contains("failures=\"2\""));
    assert!(out(&pages(&["--format", "markdown"])).contains("| page.md | 6 |"));
    assert!(out(&pages(&["--statistics"])).contains("1  attribute-wrong"));
    let ignored = pages(&["--ignore", "number-missing"]);
    assert!(!out(&ignored).contains(":6:") && out(&ignored).contains("page.md:10:"), "{}", out(&ignored));
    assert!(err(&ignored).contains("2 programs; 1 with errors"), "{}", err(&ignored));
    assert_eq!(err(&pages(&["--quiet"])), "");
    pages(&["--write-baseline", "known.json"]);
    let known = pages(&["--baseline", "known.json"]);
    assert_eq!((out(&known).as_str(), known.status.code()), ("", Some(0)));
    let piped = folder.piped(&["--markdown", "-", "--stdin-filename", "other.md"], PAGE.as_bytes());
    assert!(out(&piped).contains("other.md:6:"), "{}", out(&piped));
    pages(&["--format", "json", "--output-file", "out.json"]);
    assert!(fs::read_to_string(folder.0.join("out.json")).expect("a report").contains("attribute-wrong"));
}

#[test]
fn a_configuration_says_how_programs_are_checked() {
    let folder = Folder::new("configured")
        .with("gcode-playground.toml", "control = \"fanuc\"\nignore = [\"no-program-end\"]\nmax-warnings = 0\nexclude = [\"old/**\"]\nextension = [\"nc\", \"txt\"]\n\n[rules]\nunknown-g-code = \"warning\"\n\n[[override]]\nfiles = [\"gsk/**\"]\ncontrol = \"gsk\"\nselect = \"number-missing\"\n")
        .with("a.txt", "O1\nG7.7\n")
        .with("old/b.nc", FAULTY)
        .with("gsk/c.nc", "O1\nG7.7\nG0 X\n")
        .with("gsk/own/gcode-playground.toml", "language = \"ru\"\n")
        .with("gsk/own/d.nc", "O1\nG7.7\nM30\n");
    let found = |arguments: &[&str]| {
        let output = folder.check(&[&["--format", "json"], arguments].concat());
        let rows = rows(&output).into_iter().filter(|row| row["slug"].is_string());
        let found = rows.map(|row| {
            [&row["file"], &row["slug"], &row["severity"]]
                .map(|value| value.as_str().unwrap().to_owned())
                .join(" ")
        });
        (found.collect::<Vec<_>>(), output.status.code())
    };
    let all = [
        "a.txt unknown-g-code warning",
        "gsk/c.nc number-missing error",
        "gsk/own/d.nc unknown-g-code error",
    ];
    assert_eq!(found(&["."]), (all.map(str::to_owned).to_vec(), Some(1)));
    // Warnings fail the check if none is allowed.
    assert_eq!(found(&["a.txt"]).1, Some(1));
    assert_eq!(found(&["a.txt", "--max-warnings", "1"]).1, Some(0));
    // Options override the configuration.
    assert_eq!(found(&["a.txt", "--severity", "unknown-g-code=info"]).1, Some(0));
    let plain = found(&["a.txt", "--no-config"]).0;
    assert_eq!(plain, ["a.txt unknown-g-code error", "a.txt no-program-end warning"]);
    assert_eq!(found(&["a.txt", "--config", "gsk/own/gcode-playground.toml"]).0, plain);
    // The configuration is searched upward from the program, whatever the working directory.
    let output = Command::new(env!("CARGO_BIN_EXE_gcode-playground"))
        .args(["check", "--format", "json"])
        .arg(folder.0.join("gsk/c.nc"))
        .output()
        .expect("it runs");
    assert_eq!(slugs_of(&output), ["number-missing"]);
}

#[test]
fn what_is_wrong_in_a_configuration_is_said_with_its_place() {
    let folder = Folder::new("misconfigured").with("a.nc", RIGHT).with("sub/b.nc", RIGHT);
    let said = |text: &str| {
        fs::write(folder.0.join("gcode-playground.toml"), text).expect("a file");
        let output = folder.check(&["a.nc"]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        err(&output)
    };
    let wrong = said("[rules]\nrapid-trough-stock = \"error\"\n");
    assert!(wrong.contains("gcode-playground.toml:2:1: there is no rule `rapid-trough-stock`; the nearest is `rapid-through-stock`"), "{wrong}");
    let wrong = said("controls = \"gsk\"\n");
    assert!(
        wrong.contains("gcode-playground.toml:1:1: there is no key `controls`; the nearest is `control`"),
        "{wrong}"
    );
    let wrong = said("setup = \"gone.json\"\n");
    assert!(wrong.contains("gcode-playground.toml:1: ") && wrong.contains("no such file"), "{wrong}");
    fs::write(folder.0.join("machine.toml"), "[machine]\nrapidX = 8000\nrapdZ = 3\n").expect("a file");
    let wrong = said("setup = \"machine.toml\"\n");
    assert!(wrong.contains("machine.toml:3:1: ") && wrong.contains("rapdZ"), "{wrong}");
    let wrong = said("exclude = [\"{a\"]\n");
    assert!(wrong.contains("gcode-playground.toml:1: {a: "), "{wrong}");
}

#[test]
fn setups_are_json_or_toml() {
    let folder = Folder::new("toml")
        .with("a.nc", "O1\nT0101\nG0 X100 Z5\nM30\n")
        .with(
            "tools.toml",
            "# The turret.\n[tools.T0101]\ntip = 3\nnoseRadius = 0.8\n[stock]\ndiameter = 50\nlength = 100\n",
        )
        .with("machine.json", r#"{"machine": {"rapidX": 8000, "rapidZ": 10000}}"#);
    let seconds = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
        command.current_dir(&folder.0).args(["motions", "a.nc"]).args(arguments);
        rows(&command.output().expect("it runs"))[0]["seconds"].clone()
    };
    assert!(seconds(&["--setup", "tools.toml"]).is_null());
    assert!(seconds(&["--setup", "tools.toml", "--setup", "machine.json"]).is_number());
    // A machine in the configuration applies to every command.
    fs::write(folder.0.join("gcode-playground.toml"), "setup = [\"machine.json\"]\n").expect("a file");
    assert!(seconds(&["--setup", "tools.toml"]).is_number());
    assert!(seconds(&["--no-config"]).is_null());
}

#[test]
fn config_shows_what_holds_and_who_says_so() {
    let folder = Folder::new("shown")
        .with("gcode-playground.toml", "control = \"fanuc\"\nsetup = \"machine.json\"\n[rules]\nunknown-g-code = \"warning\"\n[[override]]\nfiles = \"gsk\"\ncontrol = \"gsk\"\n")
        .with("machine.json", "{}");
    let config = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
        command.current_dir(&folder.0).arg("config").args(arguments);
        command.output().expect("it runs")
    };
    let rows = |arguments: &[&str]| {
        let rows = rows(&config(&[&["--format", "json"], arguments].concat()));
        let text = |value: &Value| value.as_str().unwrap_or("-").to_owned();
        rows.iter()
            .map(|row| [&row["key"], &row["value"], &row["from"]].map(text).join(" "))
            .collect::<Vec<_>>()
    };
    let usual = rows(&["a.nc"]);
    assert_eq!(
        usual[..3],
        [
            "control fanuc gcode-playground.toml:1",
            "setup machine.json gcode-playground.toml:2",
            "rules.unknown-g-code warning gcode-playground.toml:4"
        ]
    );
    assert_eq!(rows(&["gsk/a.nc"])[0], "control gsk gcode-playground.toml:7");
    assert_eq!(rows(&["gsk/a.nc", "--control", "forum"])[0], "control forum --control");
    let text = out(&config(&[]));
    assert!(text.starts_with("gcode-playground.toml\n  control"), "{text}");
    assert!(out(&config(&["--no-config"])).starts_with("no gcode-playground.toml\n"));
}

/// Reads the output of a watching check line by line.
struct Watching {
    child: std::process::Child,
    lines: std::sync::mpsc::Receiver<String>,
}

impl Watching {
    fn new(folder: &Folder, arguments: &[&str]) -> Self {
        let mut child = folder.command(arguments).spawn().expect("it starts");
        let (send, lines) = std::sync::mpsc::channel();
        let out = child.stdout.take().expect("stdout");
        std::thread::spawn(move || {
            let lines = std::io::BufRead::lines(std::io::BufReader::new(out));
            lines.map_while(Result::ok).try_for_each(|line| send.send(line))
        });
        Self { child, lines }
    }

    fn until(&self, part: &str) {
        let wait = std::time::Duration::from_secs(30);
        while !self
            .lines
            .recv_timeout(wait)
            .unwrap_or_else(|_| panic!("no line with `{part}`"))
            .contains(part)
        {}
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_watching_check_reports_after_each_change() {
    let folder = Folder::new("watched").with("a.nc", RIGHT);
    let watching = Watching::new(&folder, &[".", "--watch"]);
    watching.until("nothing found in 1 file");
    let write = |name: &str, text: &str| fs::write(folder.0.join(name), text).expect(name);
    write("a.nc", FAULTY);
    watching.until("1 error");
    // A new file, a new configuration, an invalid one, and a valid one.
    write("b.nc", FAULTY);
    watching.until("2 errors");
    write("gcode-playground.toml", "ignore = [\"number-missing\"]\n");
    watching.until("nothing found in 2 files");
    write("gcode-playground.toml", "ignore = [\"no-such\"]\n");
    write("gcode-playground.toml", "[rules]\nnumber-missing = \"warning\"\n");
    watching.until("2 warnings");
    assert_eq!(folder.check(&["-", "--watch"]).status.code(), Some(2));
}

#[test]
fn a_report_never_takes_the_place_of_a_program() {
    let folder = Folder::new("kept").with("a.nc", RIGHT);
    for arguments in
        [["a.nc", "--output-file", "a.nc"], [".", "-o", "./a.nc"], ["a.nc", "--write-baseline", "a.nc"]]
    {
        let output = folder.check(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(err(&output).contains("nothing else is written into it"), "{}", err(&output));
        assert_eq!(fs::read_to_string(folder.0.join("a.nc")).expect("a.nc"), RIGHT);
    }
    assert_eq!(folder.check(&["a.nc", "--statistics", "--format", "junit"]).status.code(), Some(2));
}

#[test]
fn repairs_keep_the_line_ends_of_windows() {
    let folder = Folder::new("windows").with("a.nc", "O1\r\nM03 S500\r\nG00 X1\r\n%\r\n");
    folder.check(&["a.nc", "--fix"]);
    assert_eq!(
        fs::read_to_string(folder.0.join("a.nc")).expect("a.nc"),
        "O1\r\nM03 S500\r\nG00 X1\r\nM30\r\n%\r\n"
    );
}

#[test]
fn a_repair_is_shown_on_its_own_line() {
    // The fix of a contour is at its first block, the finding at the block that turns back.
    let pocket = "O1 (STOCK D=60 LENGTH=80)\nT0101\nG97 S500 M03\nG00 X62 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.2\n\
                  N10 G00 X20\nG01 Z-10\nX40\nX30 Z-20\nX50\nN20 X62\nG00 X100 Z100\nM30\n";
    let folder = Folder::new("shown-line").with("a.nc", pocket);
    let rows = rows(&folder.check(&["a.nc", "--format", "json"]));
    let edits = rows.iter().flat_map(|row| row["fixes"].as_array().cloned().unwrap_or_default());
    let edits: Vec<Value> =
        edits.flat_map(|fix| fix["edits"].as_array().cloned().unwrap_or_default()).collect();
    assert!(
        rows.iter().any(|row| row["fixes"][0]["edits"][0]["line"].as_u64() < row["line"].as_u64()),
        "{rows:?}"
    );
    let text = out(&folder.check(&["a.nc"]));
    for edit in edits {
        let line = edit["line"].as_u64().expect("a line");
        let own = pocket.lines().nth(line as usize - 1).expect("a line").split(' ').next().expect("a word");
        let shown = text.lines().any(|shown| {
            let shown = shown.trim_start();
            shown.starts_with(&format!("{line} ")) && shown.contains(own)
        });
        assert!(shown, "{line}: {own}\n{text}");
    }
}

#[test]
fn options_have_the_last_word() {
    let folder = Folder::new("last-word")
        .with("a.nc", "(RULES NO-PROGRAM-END=OFF)\nG00 X1\n")
        .with("setup.json", "\u{feff}{\"dialect\": {\"control\": \"gsk\"}}")
        .with("list.json", "[]");
    assert_eq!(folder.check(&["a.nc"]).status.code(), Some(0));
    assert_eq!(folder.check(&["a.nc", "--severity", "no-program-end=error"]).status.code(), Some(1));
    // A group name selects all of its rules.
    for option in [["--select", "classroom"], ["--ignore", "classroom"], ["--severity", "classroom=info"]] {
        assert_eq!(folder.check(&[&["a.nc"], &option[..]].concat()).status.code(), Some(0), "{option:?}");
    }
    // A byte order mark at the start of the file is ignored; a JSON list is not a setup.
    assert_eq!(folder.check(&["a.nc", "--setup", "setup.json"]).status.code(), Some(0));
    let list = folder.check(&["a.nc", "--setup", "list.json"]);
    assert!(err(&list).contains("a setup is an object"), "{}", err(&list));
    let mut config = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    let config = config.current_dir(&folder.0).args(["config", "a.nc", "--setup", "setup.json"]).output();
    let config = out(&config.expect("it runs"));
    assert!(
        config.contains("control") && config.contains("gsk") && config.contains("setup.json"),
        "{config}"
    );
}

#[test]
fn what_is_left_out_may_be_left_out_by_name() {
    let folder = Folder::new("by-name")
        .with(
            "gcode-playground.toml",
            "exclude = \"old/**\"\nextension = \"nc, txt\"\nbaseline = \"known.json\"\n",
        )
        .with("old/a.nc", FAULTY)
        .with("b.txt", FAULTY)
        .with("O0003", RIGHT);
    // The baseline named in the configuration is created by the first check.
    assert_eq!(folder.check(&["."]).status.code(), Some(2));
    assert_eq!(folder.check(&[".", "--write-baseline", "known.json"]).status.code(), Some(1));
    assert_eq!(folder.check(&["."]).status.code(), Some(0));
    assert_eq!(files(&folder, &["."]), ["O0003", "b.txt"]);
    assert_eq!(files(&folder, &["old/a.nc", "b.txt"]), ["old/a.nc", "b.txt"]);
    assert_eq!(files(&folder, &["old/a.nc", "b.txt", "--force-exclude"]), ["b.txt"]);
    assert_eq!(files(&folder, &["old/a.nc", "b.txt", "--force-exclude", "--exclude", "b.*"]), [""; 0]);
    // A missing file is only reported as missing.
    let gone = folder.check(&["gone.nc"]);
    assert_eq!((out(&gone).as_str(), gone.status.code()), ("", Some(2)));
}
