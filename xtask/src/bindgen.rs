//! In: a compiled module. Out: the module with its JavaScript, made by wasm-bindgen. In Cargo.lock
//! `wasm-bindgen-cli-support` has the version of `wasm-bindgen`, because the two share a private format.

use std::path::Path;
use std::time::{Duration, Instant};

use wasm_bindgen_cli_support::Bindgen;

use crate::run::{self, Result};

/// The target environment of the JavaScript.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum For {
    /// The page, with types.
    Page,
    /// The page, whose module loads parts later: they add functions to its table.
    PageWithParts,
    /// Node, without types.
    Node,
}

/// Writes the package of a module into a folder. Returns the time it took.
pub fn package(module: &Path, name: &str, folder: &Path, target: For) -> Result<Duration> {
    let begun = Instant::now();
    let generate = || {
        let mut bindgen = Bindgen::new();
        // As the command of wasm-bindgen does: the script finds the module in its own folder.
        bindgen.input_path(module).out_name(name).omit_default_module_path(false);
        match target {
            For::Page => bindgen.web(true)?.typescript(true),
            For::PageWithParts => bindgen.web(true)?.typescript(true).keep_lld_exports(true),
            For::Node => bindgen.nodejs_module(true)?,
        };
        bindgen.generate(folder)
    };
    generate().map_err(|error| format!("wasm-bindgen cannot read {}: {error:#}", module.display()))?;
    let time = begun.elapsed();
    run::say(format_args!("building the package {name} by wasm-bindgen: done in {}", run::pretty(time)));
    Ok(time)
}
