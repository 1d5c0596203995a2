//! Manuals: `embed`, `embed --check` and `check --markdown`, as the build of a manual uses them.
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs};

use expect_test::expect_file;
use serde_json::Value;

const PROGRAM: &str = "O0001 (STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X42 Z2\n\nG90 X36 Z-20 F0.2\nX32 (A<B & C)\nG00 X100 Z100\nM30\n";

fn run(arguments: &[&str], input: &[u8]) -> Output {
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

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn rows(output: &Output) -> Vec<Value> {
    text(&output.stdout).lines().map(|line| serde_json::from_str(line).expect("one object a line")).collect()
}

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/manuals").join(name)
}

/// Writes a file for a test.
fn scratch(name: &str, content: &[u8]) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("manuals");
    fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(name);
    fs::write(&path, content).expect(name);
    path.to_string_lossy().into_owned()
}

/// Line, column and slug, or the note, of all messages.
fn told(file: &str) -> Vec<String> {
    let output = run(&["check", "--markdown", "--format", "json", file], b"");
    let name = |row: &Value| row.get("slug").or(row.get("note")).and_then(Value::as_str).map(str::to_owned);
    let rows = rows(&output);
    assert!(rows.iter().all(|row| row["file"] == file), "{rows:?}");
    let rows =
        rows.iter().map(|row| format!("{}:{} {}", row["line"], row["column"], name(row).expect("a name")));
    rows.filter(|row| !row.ends_with("stock-assumed")).collect()
}

const OF_THE_PAGE: [&str; 9] = [
    "14:5 letter-for-digit",
    "15:10 number-missing",
    "23:12 no-program-end",
    "33:1 program-not-run",
    "39:5 number-missing",
    "39:6 character-not-understood",
    "43:1 setup-unreadable",
    "47:1 element-not-closed",
    "48:9 no-program-end",
];

#[test]
fn every_program_of_a_page_is_checked_in_its_place() {
    let page = fs::read_to_string(fixture("turning.md")).expect("turning.md");
    for (name, page) in [("turning.md", page.clone()), ("windows.markdown", page.replace('\n', "\r\n"))] {
        let file = scratch(name, page.as_bytes());
        assert_eq!(told(&file), OF_THE_PAGE, "{name}");
        let output = run(&["check", "--markdown", &file], b"");
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stdout);
        for place in ["md:14:5", "14 | G01 XO Z-20 F0.2\n", "23 | > G00 X42 Z2\n", "39 | G01 X&lt;\n"] {
            assert!(said.replace("windows.markdown", "turning.md").contains(place), "{place}: {said}");
        }
        assert!(text(&output.stderr).contains("5 programs; 4 with errors"), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains("1 not checked"), "{}", text(&output.stderr));
    }
}

#[test]
fn pages_are_read_by_their_endings() {
    assert_eq!(told(&fixture("turning.html").to_string_lossy()), ["9:9 letter-for-digit"]);
    assert_eq!(told(&fixture("turning.mdx").to_string_lossy()), ["8:5 letter-for-digit"]);
    assert_eq!(
        told(&fixture("turning.rst").to_string_lossy()),
        ["9:8 letter-for-digit", "20:11 number-missing"]
    );
    let output = run(&["check", "--markdown", "-"], b"```nc\nM30\n```\n");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(run(&["check", "--markdown", "no/such.md"], b"").status.code(), Some(2));
    assert_eq!(run(&["check", "--markdown", "--fix", "-"], b"").status.code(), Some(2));
}

/// The edits of a fix apply to the page: with the margin of a quotation, and with the escapes of HTML.
#[test]
fn fixes_are_edits_of_the_page() {
    let page =
        "é\n> ```gcode\n> G00 XO\n> ```\n\n<pre data-gcode-playground>\n  G01 X&lt;\n  Z–5 F0.1\n</pre>\n";
    let file = scratch("fixes.md", page.as_bytes());
    let output = run(&["check", "--markdown", "--format", "json", &file], b"");
    let units: Vec<u16> = page.encode_utf16().collect();
    let mut results = Vec::new();
    for row in rows(&output) {
        for edit in
            row["fixes"].as_array().into_iter().flatten().flat_map(|fix| fix["edits"].as_array()).flatten()
        {
            let at = |key: &str| usize::try_from(edit[key].as_u64().expect("an offset")).expect("a size");
            let [before, after] = [&units[..at("from")], &units[at("to")..]].map(String::from_utf16_lossy);
            results.push(before + edit["text"].as_str().expect("a text") + &after);
        }
    }
    for (from, to) in [("XO", "X0"), ("> G00 XO\n", "> G00 XO\n> M30\n"), ("Z–5", "Z-5")] {
        let wanted = page.replace(from, to);
        assert!(results.contains(&wanted), "{wanted}\n{results:#?}");
    }
}

#[test]
fn lines_in_sentences_are_lines_of_the_page() {
    let program = "T0101\nG97 S800 M03\nG00 X52 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\n\
                   N10 G00 X30\nG01 Z-20 F0.15\nZ-10\nN20 X52\nG00 X200 Z200\nM30\n";
    let page = format!("one\n\ntwo\n\n```gcode\n{program}```\n");
    let file = scratch("lines.md", page.as_bytes());
    let output = run(&["check", "--markdown", "--format", "json", &file], b"");
    let rows = rows(&output);
    let row = rows.iter().find(|row| row["slug"] == "contour-turns-back").expect("a message with a line");
    let line = 1 + page.lines().position(|line| line == "Z-10").expect("its line");
    assert!(row["message"].as_str().is_some_and(|said| said.contains(&format!("line {line}"))), "{row}");
}

#[test]
fn options_hold_where_an_example_says_nothing_else() {
    let page = "```gcode\nG21\nM30\n```\n\n```gcode control=fanuc\nG21\nM30\n```\n";
    let file = scratch("control.md", page.as_bytes());
    assert_eq!(told(&file), [""; 0]);
    let setup = scratch(
        "rules.json",
        br#"{"rules": {"no-program-end": "error"}, "stock": {"diameter": 40, "length": 60}}"#,
    );
    let page = "```gcode\nG00 X1 Z1\n```\n\n```gcode setup='{\"rules\": {}}'\nG00 X1 Z1\n```\n";
    let file = scratch("rules.md", page.as_bytes());
    let output = run(&["check", "--markdown", "--format", "json", "--setup", &setup, &file], b"");
    let severities: Vec<String> = rows(&output).iter().map(|row| row["severity"].to_string()).collect();
    assert_eq!(severities, ["\"error\"", "\"warning\""]);
}

/// Input that would make a careless parser slow is parsed quickly.
#[test]
fn pages_of_any_kind_are_read_in_time() {
    let many = |text: &str| text.repeat(40_000);
    let start = Instant::now();
    for (name, page) in [
        ("fences.md", many("```gcode\n")),
        ("quotations.md", format!("{}```gcode\nG00", "> ".repeat(40_000))),
        ("open.html", many("<gcode-playground>")),
        ("open.md", many("<gcode-playground>\n\n")),
        ("comments.html", format!("<gcode-playground>{}", many("<!-"))),
        ("scripts.html", many("<script></scrip>")),
        (
            "attributes.html",
            format!("<gcode-playground {}>", (0..40_000).map(|n| format!(" a{n}=b")).collect::<String>()),
        ),
        ("slots.html", format!("<gcode-playground>{}", many("<b slot=a>"))),
        ("references.html", format!("<gcode-playground>{}", many("&minus;&"))),
        ("braces.mdx", format!("<gcode-playground>{}", many("{`"))),
        ("tags.mdx", many("<a b={")),
        ("elements.mdx", many("<gcode-playground b={\n")),
        ("fallbacks.mdx", many("<gcode-playground><a slot='' dangerouslySetInnerHTML={{__html:\n")),
        ("directives.rst", many(".. raw:: html\n\n")),
        ("notes.rst", many(".. note::\n")),
        ("empty.md", many("```gcode\nM30\n```\n")),
    ] {
        let file = scratch(name, page.as_bytes());
        let output = run(&["check", "--markdown", "--format", "json", &file], b"");
        assert!(matches!(output.status.code(), Some(0 | 1)), "{name}: {}", text(&output.stderr));
        eprintln!("{name}: {:?}", start.elapsed());
    }
    assert!(start.elapsed() < Duration::from_secs(300), "{:?}", start.elapsed());
}

#[test]
fn embed_writes_an_element_with_its_program_and_its_picture() {
    let setup = scratch("embed.json", br#"{"tools": {"T0101": {"noseRadius": 0.8}}}"#);
    let options = [
        "--view",
        "picture",
        "--control",
        "gsk",
        "--setup",
        &setup,
        "--lang",
        "ru",
        "--caption",
        "a \"b\" <c>",
    ];
    let more = [
        "--program",
        "1",
        "--block-skip",
        "1,2",
        "--turret",
        "front",
        "--attribute",
        "step=4",
        "--attribute",
        "readonly",
    ];
    let all: Vec<&str> = ["embed", "-"].into_iter().chain(options).chain(more).collect();
    let output = run(&all, PROGRAM.replace('\n', "\r\n").as_bytes());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let page = text(&output.stdout);
    let tag = "<gcode-playground view=\"picture\" control=\"gsk\" setup=\"{&quot;tools&quot;:{&quot;T0101&quot;:{&quot;noseRadius&quot;:0.8}}}\" \
               block-skip=\"1,2\" program=\"1\" language=\"ru\" turret=\"front\" caption=\"a &quot;b&quot; &lt;c&gt;\" step=\"4\" readonly>\n<svg slot=\"fallback\" ";
    assert!(page.starts_with(tag), "{page}");
    assert!(
        page.contains("мм") && page.contains("data-line=\"6\"") && page.contains("a \"b\" &lt;c&gt;</text>"),
        "{page}"
    );
    let end = format!(
        "</svg>\n<pre>\n{}</pre>\n</gcode-playground>\n",
        PROGRAM.replace("A<B & C", "A&lt;B &amp; C")
    );
    assert!(page.ends_with(&end), "{page}");

    let output = run(&["embed", "-", "--format", "markdown", "--view", "playback"], PROGRAM.as_bytes());
    let block = text(&output.stdout);
    assert!(block.starts_with("<pre data-gcode-playground data-view=\"playback\">\nO0001 "), "{block}");
    assert!(block.ends_with("</svg></pre>\n") && block.contains("M30\n<svg slot=\"fallback\" "), "{block}");
    let code = run(&["embed", "-", "--view", "code"], PROGRAM.as_bytes());
    assert!(!text(&code.stdout).contains("<svg"));
}

#[test]
fn the_picture_of_an_element_has_its_annotations() {
    let program = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X52 Z2\nG90 X46 Z-25 F0.2\nG00 X100 Z50\nM30\n";
    let page = |choice: &str| {
        let annotate = format!("annotate={choice}");
        let output = run(&["embed", "-", "--attribute", &annotate], program.as_bytes());
        text(&output.stdout).to_owned()
    };
    let has = |page: &str, label: &str| page.contains(&format!(">{label}</text>"));
    // From A (X52) to C (X46): 3 mm on the radius, and 27 mm along Z.
    let cycle = page("cycle");
    assert!(["A", "B", "C", "D", "U/2 = −3", "W = −27"].iter().all(|label| has(&cycle, label)), "{cycle}");
    let part = page("part");
    assert!(["Ø46", "25"].iter().all(|label| has(&part, label)) && !has(&part, "A"), "{part}");
    assert!(!page("word").contains("annotations"));
}

/// The pages shown by `tests/browser/manuals.spec.ts` are the output of `embed`; `UPDATE_EXPECT=1` writes
/// them.
#[test]
fn the_pages_of_the_browser_tests_are_those_of_embed() {
    for (name, format) in [("hard.html", "html"), ("hard.markdown", "markdown")] {
        let program = fixture("hard.nc").to_string_lossy().into_owned();
        let output = run(
            &["embed", &program, "--view", "picture", "--caption", "a \"b\" <c>", "--format", format],
            b"",
        );
        // The hard page contains some blocks that are not programs.
        assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
        expect_file![fixture(name)].assert_eq(text(&output.stdout));
    }
}

#[test]
fn embed_refuses_what_it_cannot_write() {
    for arguments in [
        &["embed"][..],
        &["embed", "a.nc", "b.nc"],
        &["embed", "-", "--attribute", "on click=1"],
        &["embed", "-", "--attribute", "veiw=playback"],
        &["embed", "-", "--attribute", "onload=alert(1)"],
        &["embed", "-", "--attribute", "OnClick"],
        &["embed", "-", "--format", "markdown", "--attribute", "onload=alert(1)"],
        &["embed", "-", "--format", "mdx", "--attribute", "onmouseover={alert(1)}"],
        &["embed", "-", "--format", "frame", "--attribute", "onload=alert(1)"],
        &["embed", "-", "--format", "frame", "--attribute", "class=wide"],
        &["embed", "-", "--attribute", "srcdoc=<p>"],
        &["embed", "-", "--attribute", "highlight=40-x"],
        &["embed", "-", "--view", "picture", "--attribute", "view=all"],
        &["embed", "-", "--block-skip", "0"],
        &["embed", "--check", "--view", "all", "-"],
        &["embed", "--check", "--fix", "-"],
        &["embed", "--check", "no/such.md"],
    ] {
        assert_eq!(run(arguments, PROGRAM.as_bytes()).status.code(), Some(2), "{arguments:?}");
    }
    assert_eq!(run(&["embed", "-"], b"G00 X1\0\nM30\n").status.code(), Some(2));
    assert_eq!(run(&["embed", "-"], b"G7.7\nM30\n").status.code(), Some(1));
}

#[test]
fn a_picture_that_its_program_does_not_draw_is_told_and_drawn_anew() {
    let of = |format: &str, program: &str| {
        let output =
            run(&["embed", "-", "--format", format, "--lang", "zh", "--control", "gsk"], program.as_bytes());
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let html = format!("<!doctype html>\r\n<p>é\r\n{}<p>end", of("html", PROGRAM).replace('\n', "\r\n"));
    let quoted = of("markdown", PROGRAM).trim_end().replace('\n', "\n   ");
    let markdown = format!("# A\n\n{}\n1. {quoted}\n\n[end](x)", of("markdown", PROGRAM));
    let mdx = format!("# A\n\n{}\n[end](x)", of("mdx", PROGRAM));
    let pages = [("pictures.html", html, 1), ("pictures.md", markdown, 2), ("pictures.mdx", mdx, 1)];
    for (name, page, count) in pages {
        let file = scratch(name, page.as_bytes());
        let fresh = run(&["embed", "--check", &file], b"");
        assert_eq!(fresh.status.code(), Some(0), "{}{}", text(&fresh.stdout), text(&fresh.stderr));
        assert!(text(&fresh.stderr).contains(", 0 out of date"), "{}", text(&fresh.stderr));

        // The program has changed, but the picture is the old one.
        let changed = page.replace("X32 (A", "X30 (A");
        assert_ne!(changed, page);
        fs::write(&file, &changed).expect("a page");
        let output = run(&["embed", "--check", &file], b"");
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stdout);
        assert_eq!(said.matches(&format!("gcode-playground embed --fix {file}")).count(), count, "{said}");
        assert!(said.contains(&format!("{file}:3:1: ")), "{said}");
        assert_eq!(fs::read_to_string(&file).expect("a page"), changed, "checking changes nothing");

        let output = run(&["embed", "--fix", &file], b"");
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let fixed = fs::read_to_string(&file).expect("a page");
        // The text around the pictures is unchanged.
        let around = |page: &str| -> String {
            let parts = page.split("<svg slot=").enumerate();
            parts
                .map(|(at, part)| if at == 0 { part } else { part.rsplit_once("</svg>").expect("its end").1 })
                .collect()
        };
        assert_eq!(around(&fixed), around(&changed));
        assert_ne!(fixed, changed);
        assert_eq!(run(&["embed", "--check", &file], b"").status.code(), Some(0));
        // The same as for a page that is written now.
        assert_eq!(fixed, page.replace("X32 (A", "X30 (A").replace(&picture(&page), &picture(&fixed)));
    }
}

fn picture(page: &str) -> String {
    let start = page.find("<svg slot=").expect("a picture");
    let after = ["</svg></pre>", "</svg>\r\n<pre>", "</svg>`}}"];
    let end = after.iter().find_map(|after| page[start..].find(after)).expect("its end");
    page[start..start + end + "</svg>".len()].to_owned()
}

#[test]
fn elements_that_cannot_be_drawn_are_told() {
    for (page, code) in [
        ("<gcode-playground>\nG00\n\nM30\n</gcode-playground>\n", 1),
        ("<pre data-gcode-playground data-setup=\"{\">\nG00 X1 Z1\n<svg slot=\"fallback\"></svg></pre>\n", 1),
        ("<pre data-gcode-playground>\nG00 X1 Z1\n<svg slot=\"fallback\"></svg></pre>\n", 1),
        ("<pre data-gcode-playground>\nG00 X1 Z1\n</pre>\n", 0),
        ("<gcode-playground src=\"a.nc\"><svg slot=\"fallback\"></svg></gcode-playground>\n", 0),
        ("```gcode\nG7.7\n```\n", 0),
    ] {
        let output = run(&["embed", "--check", "-"], page.as_bytes());
        assert_eq!(output.status.code(), Some(code), "{page}{}", text(&output.stdout));
        assert_eq!(text(&output.stdout).starts_with("<stdin>:1:1: "), code == 1, "{page}");
    }
}
