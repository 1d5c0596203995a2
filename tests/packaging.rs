//! The published crate: the dependencies of the library, and the files of the package.
use std::collections::BTreeSet;
use std::process::Command;

/// The output lines of a cargo command.
fn cargo(arguments: &[&str]) -> Vec<String> {
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(arguments)
        .output()
        .expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8").lines().map(str::to_owned).collect()
}

/// The names of the crates that are compiled with a package.
fn dependencies(package: &str, edges: &str, features: &[&str]) -> BTreeSet<String> {
    let mut arguments = vec!["tree", "--package", package, "--edges", edges, "--prefix", "none"];
    arguments.extend(["--format", "{p}", "--locked"]);
    arguments.extend(features);
    let name = |line: &String| line.split(' ').next().map(str::to_owned);
    cargo(&arguments).iter().filter_map(name).collect()
}

/// Dependencies of the command line only.
const OF_THE_COMMAND_LINE: [&str; 5] =
    ["annotate-snippets", "clap", "encoding_rs", "pulldown-cmark", "schemars"];

#[test]
fn a_library_brings_nothing_of_the_command_line() {
    let of = |features| dependencies("gcode-playground", "normal", features);
    let (library, command_line) = (of(&["--no-default-features"]), of(&[]));
    for name in OF_THE_COMMAND_LINE {
        assert!(!library.contains(name), "{library:?}");
        assert!(command_line.contains(name), "{command_line:?}");
    }
    assert!(library.len() < command_line.len() && library.contains("i_overlay"), "{library:?}");
}

/// Building the site compiles no dependency of the tests or of the command line.
#[test]
fn the_writers_of_pages_bring_nothing_of_the_tests() {
    for package in ["gcode-playground-rule-pages", "gcode-playground-reference"] {
        let needed = dependencies(package, "all", &[]);
        assert!(needed.contains(package), "{needed:?}");
        for name in ["clap", "divan", "proptest"] {
            assert!(!needed.contains(name), "{package} needs {name}: {needed:?}");
        }
    }
}

/// The package contains the sources, the rules for the build script, the reference and the licences.
#[test]
fn the_package_has_what_a_user_needs_and_no_more() {
    let files = cargo(&["package", "--package", "gcode-playground", "--list", "--allow-dirty"]);
    let has = |name: &str| files.iter().any(|file| file == name);
    for name in [
        "Cargo.toml",
        "CHANGELOG.md",
        "LICENSE-APACHE",
        "LICENSE-MIT",
        "README.md",
        "src/cli/plausible.json",
        "src/export/card/card.css",
        "src/lib.rs",
        "src/main.rs",
        "src/rules/build.rs",
        "src/rules/rapid-through-stock.md",
        "src/sentences/en.txt",
        "src/threads/metric.tsv",
        "src/wasm/mod.rs",
        "www/docs/library.md",
        "www/docs/setup.md",
    ] {
        assert!(has(name), "{name} is missing");
    }
    let generated = [".cargo_vcs_info.json", "Cargo.lock", "Cargo.toml.orig"];
    let is_needed = |file: &str| match file.split_once('/') {
        None => ["Cargo.toml", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "README.md"].contains(&file),
        Some(("src", rest)) => {
            let is_test =
                rest.ends_with("/tests.rs") || rest.contains("/tests/") || rest.ends_with("README.md");
            let is_source =
                [".rs", ".css", ".json", ".md", ".tsv", ".txt"].iter().any(|ending| rest.ends_with(ending));
            !is_test && (is_source || rest == "cli/system/node.js")
        }
        Some(("www", rest)) => rest.starts_with("docs/") && rest.ends_with(".md"),
        Some(_) => false,
    };
    let more: Vec<_> =
        files.iter().filter(|file| !generated.contains(&file.as_str()) && !is_needed(file)).collect();
    assert!(more.is_empty(), "{more:?}");
    let rules = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/rules")).expect("src/rules");
    let rules =
        rules.flatten().filter(|entry| entry.path().extension().is_some_and(|kind| kind == "md")).count();
    let packed = files.iter().filter(|file| file.starts_with("src/rules/") && file.ends_with(".md")).count();
    // All except the description of their format.
    assert_eq!(packed, rules - 1);
}
