//! `gcode-playground check --diff` and `--exit-zero`.
use std::fs;
use std::process::Command;

use crate::folder::{FAULTY, Folder, err, out};

const MISREAD: &str = "O1\nT0101\nM3 S500\nGO0 X50 Z2\nG01 Z-5 F0.1\nG00 X100 Z100\nM30\n";

const DIFF: &str = "--- a.nc\n+++ a.nc\n@@ -1,7 +1,7 @@\n O1\n T0101\n M3 S500\n-GO0 X50 Z2\n+G00 X50 Z2\n G01 Z-5 F0.1\n G00 X100 Z100\n M30\n";

#[test]
fn a_diff_shows_the_fixes_and_writes_nothing() {
    let folder = Folder::new("diff").with("a.nc", MISREAD).with("b.nc", FAULTY);
    let output = folder.check(&[".", "--diff"]);
    assert_eq!((out(&output).as_str(), output.status.code()), (DIFF, Some(1)));
    assert_eq!(err(&output), "gcode-playground: 1 repair in 1 file; `--fix` makes them\n");
    assert_eq!(fs::read_to_string(folder.0.join("a.nc")).expect("a.nc"), MISREAD);
    assert_eq!(err(&folder.check(&[".", "--diff", "--quiet"])), "");
    // Errors without a safe fix are no repairs. Neither are errors of rules that are not selected.
    for arguments in [&["b.nc", "--diff"][..], &["a.nc", "--diff", "--select", "number-missing"]] {
        let none = folder.check(arguments);
        assert_eq!((out(&none).as_str(), none.status.code()), ("", Some(0)), "{arguments:?}");
    }
    let piped = folder.piped(&["-", "--diff", "--stdin-filename", "a.nc"], MISREAD.as_bytes());
    assert_eq!(out(&piped), DIFF);
    let written = folder.check(&["a.nc", "--diff", "--output-file", "a.patch"]);
    assert_eq!((out(&written).as_str(), written.status.code()), ("", Some(1)));
    assert_eq!(fs::read_to_string(folder.0.join("a.patch")).expect("a.patch"), DIFF);
    for wrong in ["--fix", "--markdown", "--statistics", "--format=json", "--max-warnings=1"] {
        assert_eq!(folder.check(&["a.nc", "--diff", wrong]).status.code(), Some(2), "{wrong}");
    }
}

#[test]
fn a_diff_counts_files_that_cannot_be_read() {
    let folder = Folder::new("diff-unreadable").with("a.nc", MISREAD);
    let output = folder.check(&["gone.nc", "a.nc", "--diff", "--exit-zero"]);
    assert_eq!((out(&output).as_str(), output.status.code()), (DIFF, Some(2)));
    assert!(err(&output).contains("gone.nc"), "{}", err(&output));
}

/// Applying the diff changes a program as `check --fix` does, with Windows line ends and Chinese comments.
#[test]
fn a_diff_can_be_applied() {
    let program = b"O1 (\xcd\xe2\xd4\xb2\xb3\xb5\xcf\xf7)\r\nM3 S500\r\nGO0 X50 Z2 (\xb4\xd6\xb3\xb5)\r\nG00 X1\r\nM30\r\n";
    let folder = Folder::new("patch").with("a.nc", program).with("b.nc", program);
    let diff = folder.check(&["a.nc", "--diff"]).stdout;
    fs::write(folder.0.join("a.patch"), &diff).expect("a patch");
    folder.check(&["b.nc", "--fix"]);
    let mut git = Command::new("git");
    // No repository: the folder is in an ignored one.
    git.current_dir(&folder.0).env("GIT_CEILING_DIRECTORIES", folder.0.parent().expect("a folder"));
    let applied = git.args(["apply", "-p0", "a.patch"]).output().expect("git");
    assert!(applied.status.success(), "{}", String::from_utf8_lossy(&applied.stderr));
    let [a, b] = ["a.nc", "b.nc"].map(|name| fs::read(folder.0.join(name)).expect("a program"));
    assert!(a == b && a != program, "{}", String::from_utf8_lossy(&a));
}

#[test]
fn findings_can_be_reported_without_failing() {
    let folder = Folder::new("exit-zero").with("a.nc", FAULTY).with("b.nc", MISREAD);
    let reported = out(&folder.check(&["a.nc"]));
    let output = folder.check(&["a.nc", "--exit-zero"]);
    assert_eq!((out(&output), output.status.code()), (reported, Some(0)));
    let warned = ["b.nc", "--severity", "letter-for-digit=warning", "--max-warnings", "0"];
    assert_eq!(folder.check(&warned).status.code(), Some(1));
    assert_eq!(folder.check(&[&warned[..], &["--exit-zero"]].concat()).status.code(), Some(0));
    assert_eq!(folder.check(&["b.nc", "--diff", "--exit-zero"]).status.code(), Some(0));
    assert_eq!(folder.check(&["gone.nc", "--exit-zero"]).status.code(), Some(2));
    assert_eq!(folder.check(&["a.nc", "--exit-zero", "--select", "nothing"]).status.code(), Some(2));
}
