//! The documents of the project. Tests compare their commands, files, names and figures with the code.
//!
//! `tests/documentation.rs` and the tests of `xtask` share this list.

/// The documents. The changelog describes the past, so only its commands and files are checked.
pub const DOCUMENTS: [&str; 32] = [
    "README.md",
    "CONTRIBUTING.md",
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "tests/speed/README.md",
    "tests/browser/README.md",
    "tests/programs/README.md",
    "src/rules/README.md",
    "www/docs/README.md",
    "www/docs/codes.md",
    "www/docs/command-line.md",
    "www/docs/dev/interpreter.md",
    "www/docs/dev/offline.md",
    "www/docs/dev/page.md",
    "www/docs/dev/tests.md",
    "www/docs/dev/wasm.md",
    "www/docs/dev/worker.md",
    "www/docs/editors.md",
    "www/docs/element.md",
    "www/docs/exercises.md",
    "www/docs/glossary.md",
    "www/docs/library.md",
    "www/docs/limits.md",
    "www/docs/manuals.md",
    "www/docs/offline.md",
    "www/docs/own-programs.md",
    "www/docs/rule-changes.md",
    "www/docs/rules.md",
    "www/docs/setup.md",
    "www/docs/sharing.md",
    "www/docs/teams.md",
    "www/embed/README.md",
];
