//! Checks the documents: every command is run, every snippet parsed, and every file, key, attribute and
//! figure compared with the sources. [`NOT_RUN`] lists what no test can run, with the reason.
#[path = "documentation/arguments.rs"]
mod arguments;
#[path = "documentation/calls.rs"]
mod calls;
#[path = "documentation/command_line.rs"]
mod command_line;
#[path = "documentation/diameters.rs"]
mod diameters;
#[path = "documentation/documents.rs"]
mod documents;
#[path = "documentation/figures.rs"]
mod figures;
#[path = "documentation/usage.rs"]
mod usage;

use crate::markdown;
use crate::project;
use std::collections::{BTreeSet, HashSet};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use calls::PROGRAM;
use documents::DOCUMENTS;
use figures::{FIGURES, Held};
use gcode_playground::analyze;
use gcode_playground::exercise::Exercise;
use gcode_playground::setup::Setup;
use markdown::Document;
use project::{ROOT, files, source};
use serde_json::Value;

/// Commands and snippets that no test runs, and the reason. `cargo xtask …` is checked by a test of xtask,
/// which reads the same documents.
const NOT_RUN: [(&str, &str); 24] = [
    ("python3 -m zipfile", "`tests/browser/stored.spec.ts` runs it, and unpacks it elsewhere"),
    ("python3 -m http.server", "the same test serves the page with it"),
    ("index.html#share=1.<count>", "the form of links; `tests/browser/links.spec.ts` makes and opens them"),
    ("default-src 'none'", "`tests/browser/policy.spec.ts` serves pages with it"),
    ("git commit", "`tests/teams/hooks.py` commits, with the hooks in place"),
    ("<style>", "`tests/browser/many.spec.ts` has it in a page, and looks for it here"),
    ("import { check, motions, svg }", "`tests/browser/package.spec.ts` runs it under Node"),
    ("npx create-docusaurus@3 site classic", "`tests/manuals/recipes.py` needs the packages of such a site"),
    ("<script setup>", "`tests/browser/frameworks.spec.ts` builds it"),
    ("<script>", "the same"),
    ("<iframe id=\"example\"", "`tests/browser/height.spec.ts` has it in a page"),
    ("<link rel=\"preload\"", "`tests/browser/many.spec.ts` has it in a page, and looks for it here"),
    (
        "cargo install --path .",
        "an optimised build of minutes; that the program builds is shown by every test of it",
    ),
    ("cargo bench", "it takes minutes and measures the machine; `cargo clippy --all-targets` compiles it"),
    (
        "cargo +nightly fuzz run --fuzz-dir tests/fuzz program",
        "it never ends, and needs another toolchain; xtask compiles the target",
    ),
    (
        "cargo rustc --crate-type cdylib",
        "part of every `cargo xtask test`, which builds the module of the page",
    ),
    ("cargo doc --open", "it opens a browser; the examples of the documentation are tests of the crate"),
    ("gzip -9", "how sizes are counted; xtask weighs the module in this way"),
    ("# rapid-through-stock", "a sketch of a rule file; the build reads all of them"),
    ("vim.filetype.add(", "the configuration of another program, which no test has"),
    ("(define-derived-mode gcode-mode", "the same"),
    ("[language-server.gcode-playground]", "the same"),
    ("text ──►", "a drawing"),
    ("geometry  ", "the order of the rooms, which `tests/rooms.rs` reads"),
];

/// Files that the documents name and that only a build creates.
const BUILT: [(&str, &str); 13] = [
    ("languages.toml", "the configuration of an editor, Helix"),
    (
        "service-worker.js",
        "`cargo xtask site`; `tests/browser/offline.spec.ts` has it answer without a network",
    ),
    ("target/vscode/gcode-playground.vsix", "`cargo xtask vscode`; `tests/browser/vscode.spec.ts` runs it"),
    ("gcode-playground.toml", "the reader writes it; `tests/check.rs` has some"),
    ("element.js", "`cargo xtask site`; `tests/browser/picture-only.spec.ts` puts it into a page"),
    ("www/dist/embed", "the same command; `tests/browser/embedding.spec.ts` puts its files into pages"),
    ("dist/embed", "the same"),
    ("embed/0.1.0", "the same command makes it, named after the version in Cargo.toml"),
    ("www/dist", "the same command makes it"),
    ("dist/rules", "the same command; `tests/browser/rules.spec.ts` opens its pages"),
    ("rules/en/index.html", "the same"),
    ("gcode-playground/browser", "an entry of the npm package; `tests/browser/package.spec.ts` imports it"),
    ("rules/<language>/messages.json", "the same command; the tests of `sentences` fill its templates"),
];

fn root() -> PathBuf {
    PathBuf::from(ROOT)
}

fn analyze_codes(program: &str) -> Vec<&'static str> {
    let analysis = analyze(program.as_bytes(), &Setup::default());
    analysis.diagnostics.iter().map(|found| found.message.code()).collect()
}

fn documents() -> Vec<(&'static str, Document)> {
    DOCUMENTS.iter().map(|&name| (name, Document::read(&source(name)))).collect()
}

fn not_run(text: &str) -> bool {
    NOT_RUN.iter().any(|(start, _)| text.starts_with(start))
}

// ---- files ----------------------------------------------------------------------------------------

/// Whether a name such as `sentences/labels.rs`, `interpreter/path`, `src/cycles/` or `pages/<slug>.md` is
/// that of a file or a folder. A name may begin at any folder, and omit the extension of a module.
fn is_there(name: &str, files: &[String]) -> bool {
    let name = name.split('#').next().unwrap_or_default().trim_end_matches('/');
    let wanted: Vec<&str> = name.split('/').collect();
    let stem = |part: &str| part.split('.').next().unwrap_or_default().to_owned();
    files.iter().any(|file| {
        let parts: Vec<&str> = file.split('/').collect();
        parts.windows(wanted.len()).any(|run| {
            run.iter().zip(&wanted).all(|(part, wanted)| fits(part, wanted) || stem(part) == *wanted)
        })
    })
}

/// Whether a part of a path matches a pattern, in which `<slug>` matches any characters.
fn fits(part: &str, wanted: &str) -> bool {
    match (wanted.find('<'), wanted.find('>')) {
        (Some(open), Some(close)) if open < close => {
            part.starts_with(&wanted[..open]) && part.ends_with(&wanted[close + 1..])
        }
        _ => part == wanted,
    }
}

/// Whether a span names a file or a folder.
fn is_path(span: &str) -> bool {
    const ENDINGS: [&str; 10] =
        [".rs", ".md", ".ts", ".js", ".mjs", ".json", ".jsonl", ".toml", ".html", ".css"];
    let plain = span.split('#').next().unwrap_or_default();
    let one_word = !plain.contains(char::is_whitespace) && plain.chars().any(char::is_alphabetic);
    let slashes = plain.contains('/') && !plain.starts_with(['/', '<', '(']);
    one_word && (slashes || ENDINGS.iter().any(|ending| plain.ends_with(ending)))
}

#[test]
fn every_file_that_is_named_exists() {
    let files = files();
    let mut missing = Vec::new();
    for (document, parts) in documents() {
        for span in parts.spans.iter().filter(|span| is_path(span)) {
            // Files of the manual of the reader.
            let of_the_reader = document == RECIPES && !span.starts_with("www/");
            if !is_there(span, &files) && !of_the_reader && !BUILT.iter().any(|(built, _)| built == span) {
                missing.push(format!("{document}: `{span}`"));
            }
        }
        for line in source(document).lines() {
            for link in line.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
                // A page of the site beside the reference.
                let is_there = is_there(link, &files) || files.contains(&link.replace("../", "www/"));
                if !link.starts_with("https://") && !is_there {
                    missing.push(format!("{document}: ({link})"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "no such file:\n{}", missing.join("\n"));
}

#[test]
fn every_document_is_in_the_list() {
    let files = files();
    let is_document = |file: &&String| {
        let reference = file.starts_with("www/docs/");
        file.ends_with(".md") && (!file.contains('/') || file.ends_with("/README.md") || reference)
    };
    let found: BTreeSet<&str> = files.iter().filter(is_document).map(String::as_str).collect();
    assert_eq!(found, DOCUMENTS.into_iter().collect());
}

/// Tables and details belong to the reference, which the README links to. Pages for contributors are linked
/// from ARCHITECTURE.
#[test]
fn readme_is_a_front_page() {
    let readme = source("README.md");
    let lines = readme.lines().count();
    assert!(lines <= 150, "README.md has {lines} lines; details belong into www/docs");
    let architecture = source("ARCHITECTURE.md");
    for document in DOCUMENTS.iter().filter(|name| name.starts_with("www/docs/")) {
        let for_contributors = document.starts_with("www/docs/dev/");
        let (front, text) =
            if for_contributors { ("ARCHITECTURE.md", &architecture) } else { ("README.md", &readme) };
        let linked = document.ends_with("README.md") || text.contains(&format!("]({document})"));
        assert!(linked, "{front} has no link to {document}");
    }
}

/// One change, one line.
#[test]
fn the_change_log_has_short_lines() {
    let text = source("CHANGELOG.md");
    let long: Vec<_> = text.lines().filter(|line| line.chars().count() > 120).collect();
    assert!(long.is_empty(), "more than 120 characters in CHANGELOG.md:\n{}", long.join("\n"));
}

#[test]
fn a_missing_file_would_be_found() {
    let files = files();
    assert!(is_path("element.js") && !is_there("element.js", &files));
    assert!(is_path("sentences/labels.ts") && !is_there("sentences/labels.ts", &files));
    assert!(is_there("sentences/codes", &files) && is_there("tests/programs/<id>/motions.jsonl", &files));
}

// ---- commands -------------------------------------------------------------------------------------

/// A command as written in the documents, without environment variables (`RULE_PAGES=slug,slug cargo …`).
fn command(text: &str) -> Option<&str> {
    let text = text.trim().trim_start_matches("$ ");
    let mut rest = text;
    while let Some((word, after)) = rest.split_once(' ').filter(|(word, _)| is_assignment(word)) {
        let _ = word;
        rest = after.trim_start();
    }
    let program = rest.split_whitespace().next()?;
    ["cargo", "gcode-playground", "npm", "npx", "node", "gzip", "git", "wasm-pack"]
        .contains(&program)
        .then_some(rest)
}

fn is_assignment(word: &str) -> bool {
    let capital = |letter: char| letter.is_ascii_uppercase() || letter == '_';
    word.split_once('=').is_some_and(|(name, _)| !name.is_empty() && name.chars().all(capital))
}

/// The blocks of this document are files and commands that `tests/manuals/recipes.py` runs with the tools
/// they are for.
const RECIPES: &str = "www/docs/manuals.md";

/// The blocks of this document are files and commands of `tests/example-repository`, checked by
/// `tests/teams.rs`.
const TEAMS: &str = "www/docs/teams.md";

/// Names of other tools in these two documents.
const OF_OTHER_TOOLS: [&str; 7] = [
    "add_header",
    "additional-js",
    "conf",
    "docusaurus",
    // A setting of the Sphinx extension.
    "gcode_playground_command",
    "hbs",
    "python3",
];

/// The commands of all documents: code spans, and lines of blocks without the explanations beside them.
fn commands() -> BTreeSet<(&'static str, String)> {
    let mut found = BTreeSet::new();
    for (document, parts) in documents() {
        let blocks = parts.blocks.iter().filter(|_| ![RECIPES, TEAMS].contains(&document));
        let lines = blocks.flat_map(|block| block.lines());
        let lines = lines.map(|line| line.split("  ").next().unwrap_or_default());
        for text in parts.spans.iter().map(String::as_str).chain(lines) {
            found.extend(command(text).map(|command| (document, command.trim_end().to_owned())));
        }
    }
    found
}

/// Whether a call of Playwright names a browser and a file of browser tests, which `cargo xtask test` runs.
fn names_browser_tests(words: &[&str]) -> bool {
    let config = source("www/playwright.config.ts");
    let is_engine = |word: &&str| {
        word.strip_prefix("--project=").is_some_and(|name| config.contains(&format!("name: '{name}'")))
    };
    let is_file = |word: &&str| root().join(format!("tests/browser/{word}.spec.ts")).is_file();
    words.iter().any(is_engine) && words.iter().any(is_file)
}

#[test]
fn every_command_is_held_by_something() {
    let mut unknown = Vec::new();
    for (document, command) in commands() {
        let words: Vec<&str> = command.split_whitespace().collect();
        let held = match words.as_slice() {
            // xtask reads the same documents, and runs their wasm-pack commands.
            ["gcode-playground", ..] | ["cargo", "xtask", ..] | ["wasm-pack", "build", ..] => true,
            ["cargo", "test", "--test", name, subject, ..] => {
                let is_subject = |subject: &str| root().join(format!("tests/{subject}.rs")).is_file();
                is_subject(name) && subject.strip_suffix("::").is_some_and(is_subject)
            }
            ["cargo", "test", "--test", name] => root().join(format!("tests/{name}.rs")).is_file(),
            // Run as the native command below, and under Node by `tests/npx/compare.rs`.
            ["npx", "gcode-playground", ..] => true,
            ["npx", "playwright", "test", rest @ ..] => names_browser_tests(rest),
            // `cargo xtask test` includes both.
            ["cargo", "fmt", "--all"] | ["cargo", "test", "--lib"] => true,
            ["npm", "run", script] => source("www/package.json").contains(&format!("\"{script}\": ")),
            _ => not_run(&command),
        };
        if !held {
            unknown.push(format!("{document}: `{command}`"));
        }
    }
    assert!(unknown.is_empty(), "neither run nor listed as not run:\n{}", unknown.join("\n"));
}

#[test]
fn what_is_not_run_is_still_in_the_documents() {
    let all: String = DOCUMENTS.iter().map(|name| source(name)).collect();
    for (start, reason) in NOT_RUN {
        assert!(all.contains(start), "`{start}` is listed ({reason}), and no document names it");
    }
}

/// A command line with real files in place of `FILE` and similar placeholders.
fn call(words: &[String], folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    command.args(calls::arguments(words, folder));
    command
}

/// Checks that a long-running command prints that it waits.
fn waits(command: &mut Command) {
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts");
    let said = BufReader::new(child.stderr.take().expect("standard error"));
    let waits = said.lines().map_while(Result::ok).any(|line| line.contains("waiting for a change"));
    child.kill().and_then(|()| child.wait()).expect("it ends");
    assert!(waits, "it ended");
}

#[test]
fn every_call_of_the_command_line_works() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("documentation");
    fs::create_dir_all(&folder).expect("a folder");
    let mut failed = Vec::new();
    let usage: BTreeSet<String> = commands()
        .iter()
        .filter_map(|(_, line)| line.strip_prefix("gcode-playground ")?.split_once(' '))
        .map(|(name, _)| name.to_owned())
        .collect();
    for (document, line) in commands() {
        let line = line.strip_prefix("npx ").unwrap_or(&line);
        let Some(line) = line.strip_prefix("gcode-playground ") else { continue };
        // A command that is only mentioned, or one of its options.
        let mut words = line.split(' ');
        let named =
            words.next().is_some_and(|name| usage.contains(name)) && words.all(|word| word.starts_with('-'));
        let line = if named { format!("{line} --help") } else { line.to_owned() };
        for words in usage::calls(&line) {
            let mut command = call(&words, &folder);
            if words.iter().any(|word| word == "--watch") {
                waits(&mut command);
                continue;
            }
            let output = command.output().expect("the command line starts");
            // Status 1 means errors in a program, and these have none, or differences between the two
            // programs of `diff`.
            let differ = words[0] == "diff" && !words.iter().any(|word| word == "--help");
            if output.status.code() != Some(i32::from(differ)) {
                let said = String::from_utf8_lossy(&output.stderr);
                failed.push(format!("{document}: {} ({}): {said}", words.join(" "), output.status));
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

// ---- snippets -------------------------------------------------------------------------------------

/// The script that loads the element.
const SCRIPT: &str = "<script type=\"module\" src=\"embed/element.js\"></script>";

/// Removes the script. Its address in the README is that of an example host.
fn without_script(block: &str) -> &str {
    let rest = block.strip_prefix(SCRIPT.trim_end_matches("embed/element.js\"></script>"));
    let loads = rest.and_then(|rest| rest.split_once("element.js\"></script>"));
    loads.map_or(block, |(_, rest)| rest)
}

#[test]
fn every_snippet_is_what_it_seems() {
    let mut unknown = Vec::new();
    for (document, parts) in
        documents().into_iter().filter(|(document, _)| ![RECIPES, TEAMS].contains(document))
    {
        for block in parts.blocks {
            let is_commands = block.lines().all(|line| line.is_empty() || command(line).is_some());
            // xtask runs it with its package.
            let is_script = block.starts_with("import ");
            // An example of the crate documentation, which is a doc test.
            let is_example = block.starts_with("use ") && is_example_of_the_crate(&block);
            if is_commands || is_script || is_example || not_run(&block) {
            } else if block.starts_with('{') {
                Setup::from_json(&block).unwrap_or_else(|error| panic!("{document}: {error}\n{block}"));
            } else if block.starts_with("control = ") {
                configures(document, &block);
            } else if block.starts_with("---\nid: ") {
                Exercise::read(&block).unwrap_or_else(|error| panic!("{document}: {error:?}\n{block}"));
            } else if block.starts_with('(') {
                let analysis = analyze(format!("{block}\nM30\n").as_bytes(), &Setup::default());
                assert!(analysis.diagnostics.is_empty(), "{document}: {:?}\n{block}", analysis.diagnostics);
            } else if let Some(element) = without_script(&block).trim_start().strip_prefix('<')
                && ["gcode-playground", "script type=\"text/x-gcode\"", "pre "]
                    .iter()
                    .any(|tag| element.starts_with(tag))
            {
                // `tests/browser/sources.spec.ts` tests it.
                holds_element(element);
            } else {
                unknown.push(format!("{document}:\n{block}"));
            }
        }
    }
    assert!(unknown.is_empty(), "neither run nor listed as not run:\n{}", unknown.join("\n\n"));
}

fn is_example_of_the_crate(block: &str) -> bool {
    let library = source("src/lib.rs");
    let documentation = library.lines().filter_map(|line| line.strip_prefix("//!"));
    let documentation: Vec<&str> = documentation.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    documentation.join("\n").contains(&format!("\n```\n{block}\n```\n"))
}

/// Reads a configuration beside the files that it names.
fn configures(document: &str, text: &str) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("configured");
    fs::create_dir_all(&folder).expect("a folder");
    let files =
        [("machine.toml", ""), ("tools.json", "{}"), ("known.json", "[]"), ("gcode-playground.toml", text)];
    for (name, content) in files {
        fs::write(folder.join(name), content).expect(name);
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    let output = command.current_dir(&folder).args(["config", "gsk/part.nc"]).output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{document}: {said}\n{text}");
}

/// The attributes that the element observes.
fn observed() -> Vec<String> {
    let element = source("www/src/shell/element-attributes.ts");
    let list = element.split("observedAttributes = [").nth(1).and_then(|rest| rest.split(']').next());
    list.expect("the element's attributes")
        .split(',')
        .map(|name| name.trim().trim_matches('\'').to_owned())
        .filter(|name| !name.is_empty())
        .collect()
}

fn holds_element(snippet: &str) {
    let tag = snippet.split('>').next().unwrap_or_default();
    let is_element = tag.starts_with("gcode-playground");
    let words = tag.split_whitespace().skip(1).filter(|word| word.contains('=') || *word == "readonly");
    for name in words.filter_map(|word| word.split('=').next()) {
        // On other tags, the attributes of the element have the prefix `data-`.
        let attribute = if is_element { Some(name) } else { name.strip_prefix("data-") };
        let Some(attribute) = attribute.filter(|name| *name != "gcode-playground") else { continue };
        assert!(observed().iter().any(|known| known == attribute), "no attribute `{attribute}`");
    }
}

/// The first cells of the table whose header begins with `head`, as their code spans.
fn first_cells(document: &str, head: &str) -> Vec<Vec<String>> {
    let text = source(document);
    let rows = text.lines().skip_while(|line| !line.starts_with(head)).skip(2);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.map(|row| row.split('|').map(|cell| cell.trim().replace('`', "")).collect()).collect()
}

#[test]
fn the_reference_lists_the_attributes_of_the_element() {
    let listed: BTreeSet<String> =
        first_cells("www/docs/element.md", "| attribute |").iter().map(|cells| cells[1].clone()).collect();
    assert_eq!(listed, observed().into_iter().collect());
}

#[test]
fn every_value_of_every_switch_is_taken() {
    let rows = first_cells("www/docs/setup.md", "| switch |");
    assert!(rows.len() > 10);
    for row in rows {
        let (name, values) = (&row[1], &row[2]);
        let values: Vec<String> = if values.starts_with('{') {
            vec![values.clone()]
        } else if let Some((from, to)) = values.split_once(" … ") {
            vec![from.to_owned(), to.to_owned()]
        } else {
            values
                .split_whitespace()
                .filter(|word| !word.starts_with('(') && !word.ends_with(')'))
                .map(str::to_owned)
                .collect()
        };
        assert!(!values.is_empty(), "{name}");
        for value in values {
            let json = serde_json::from_str::<Value>(&value).unwrap_or(Value::String(value));
            let setup = serde_json::json!({"dialect": {name: json}}).to_string();
            Setup::from_json(&setup).unwrap_or_else(|error| panic!("{setup}: {error}"));
        }
    }
}

// ---- words and figures ----------------------------------------------------------------------------

/// A word in the form that is common to Rust, TypeScript and JSON.
fn folded(word: &str) -> String {
    word.chars().filter(|letter| letter.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// All words of the sources: names, keys, values.
fn words_of_the_sources() -> HashSet<String> {
    let sources = ["editors/", "src/", "www/", "xtask/", "tests/"];
    let mut words = HashSet::new();
    for file in files() {
        let code = [".rs", ".ts", ".toml", ".json", ".mjs", ".html", ".yml", ".yaml"]
            .iter()
            .any(|ending| file.ends_with(ending));
        let named = Path::new(&file).iter().map(|part| part.to_string_lossy());
        words.extend(named.map(|part| folded(part.split('.').next().unwrap_or_default())));
        let inside = sources.iter().any(|folder| file.starts_with(folder)) || !file.contains('/');
        // The tests of the documents contain the words that they look for.
        if !code || !inside || file.contains("documentation") {
            continue;
        }
        let text = source(&file);
        let part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '-';
        words.extend(text.split(|letter| !part(letter)).map(folded));
        words.extend(text.split(|letter: char| !letter.is_alphanumeric() && letter != '_').map(folded));
    }
    words
}

#[test]
fn every_name_in_the_documents_is_one_of_the_sources() {
    let known = words_of_the_sources();
    let files = files();
    let mut unknown = BTreeSet::new();
    for (document, parts) in documents() {
        for span in &parts.spans {
            if command(span).is_some() || is_path(span) && is_there(span, &files) || not_run(span) {
                continue;
            }
            let part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '-';
            for word in
                span.split(|letter| !part(letter)).filter(|word| word.chars().any(char::is_alphabetic))
            {
                let of_others = [RECIPES, TEAMS].contains(&document) && OF_OTHER_TOOLS.contains(&word);
                if !known.contains(&folded(word)) && !of_others {
                    unknown.insert(format!("{document}: `{word}` in `{span}`"));
                }
            }
        }
    }
    assert!(
        unknown.is_empty(),
        "no such name in the sources:\n{}",
        unknown.into_iter().collect::<Vec<_>>().join("\n")
    );
}

/// The figures of a line of prose: separate numbers, not those within names (G12.1, UTF-16, GSK 980TD).
fn figures_of(line: &str) -> Vec<&str> {
    let line = line.trim_start();
    // Skip the number of a list item.
    let line = line
        .split_once(". ")
        .filter(|(number, _)| number.parse::<u32>().is_ok())
        .map_or(line, |(_, rest)| rest);
    let names = ["GSK", "GB", "seed", "Seed", "FANUC", "level", "are", "others"];
    let mut before = "";
    let mut found = Vec::new();
    for word in line.split_whitespace() {
        let bare = word.trim_start_matches(['(', '±', '⌀']).trim_end_matches([',', '.', ';', ':', ')']);
        if bare.starts_with(|first: char| first.is_ascii_digit()) && !names.contains(&before) {
            let number =
                bare.chars().all(|letter| letter.is_ascii_digit() || ".,⁰¹²³⁴⁵⁶⁷⁸⁹×".contains(letter));
            found.extend(number.then_some(bare));
        }
        before = word.trim_end_matches(',');
    }
    found
}

/// The prose without tables and headings.
fn prose(document: &Document) -> String {
    let lines = document.prose.iter().map(|line| line.trim_start());
    lines.filter(|line| !line.starts_with(['|', '#'])).collect::<Vec<_>>().join("\n")
}

/// Words as they may appear in a text: on one line, or with one line break between them.
fn in_lines(words: &str) -> Vec<String> {
    let blanks = words.match_indices(' ').map(|(at, _)| format!("{}\n{}", &words[..at], &words[at + 1..]));
    std::iter::once(words.to_owned()).chain(blanks).collect()
}

#[test]
fn every_figure_is_held_by_something() {
    let mut unheld = Vec::new();
    for (document, parts) in documents() {
        // These describe the past, measurements whose table is generated in the same run, and sources that
        // are not in this repository.
        if ["CHANGELOG.md", "tests/programs/README.md", "tests/speed/README.md"].contains(&document) {
            continue;
        }
        let mut rest = prose(&parts);
        for figure in FIGURES.iter().filter(|figure| figure.document == document) {
            for words in in_lines(figure.words) {
                rest = rest.replace(&words, "");
            }
        }
        let left = rest.lines().filter(|line| !figures_of(line).is_empty());
        unheld.extend(left.map(|line| format!("{document}: {line}")));
    }
    assert!(unheld.is_empty(), "figures that nothing holds:\n{}", unheld.join("\n"));
}

#[test]
fn every_held_figure_is_stated_and_true() {
    for figure in FIGURES {
        let prose = prose(&Document::read(&source(figure.document)));
        let stated = in_lines(figure.words).iter().any(|words| prose.contains(words));
        assert!(stated, "{} does not state `{}`", figure.document, figure.words);
        match figure.held {
            Held::By(file, test) => {
                assert!(source(file).contains(&format!("fn {test}(")), "{file} has no test `{test}`");
            }
            Held::Stated(file, text) => assert!(source(file).contains(text), "{file} does not say `{text}`"),
            Held::Shown(show) => show(),
            Held::NotRun(reason) => assert!(!reason.is_empty()),
        }
    }
}
