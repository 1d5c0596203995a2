//! In: the wasm package. Out: a table of times, wasm under Node next to a floor measured in the same run.

use std::fs;

use crate::package;
use crate::run::{self, Result, command, step};
use crate::setup::Setup;

#[path = "../../benches/workload.rs"]
mod workload;

/// `cargo xtask bench`.
pub fn main() -> Result {
    let setup = Setup::for_building()?;
    package::wasm(&setup)?;
    let folder = run::root().join("target/bench");
    let write = |name: &str, text: String| {
        fs::write(folder.join(name), text).map_err(|error| format!("cannot write {name}: {error}"))
    };
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    write("plain.nc", workload::plain(1_000_000))?;
    write("shaft.nc", workload::shaft())?;
    let mut node = command("node");
    node.arg("benches/wasm.mjs").arg(&folder);
    step("measuring in wasm under Node", &mut node)?;
    Ok(())
}
