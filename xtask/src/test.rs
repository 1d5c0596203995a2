//! In: the whole working tree. Out: whether it is in order: format, lints, fuzz targets, native tests, wasm
//! tests under Node, hostile programs in release builds, the packages for other projects, the page's types, recipes for manuals, checks in a repository,
//! and the page in three browser engines. It stops at the first step that fails.

use std::time::Instant;

use crate::run::{self, Result, command, pretty, step};
use crate::setup::Setup;
use crate::{browser, engines, hostile, library, manuals, native, npx, package, spelling, teams};

/// `cargo xtask test`.
pub fn main() -> Result {
    let start = Instant::now();
    let mut times = Vec::new();
    let mut done = |name: &'static str, time| times.push((name, time));

    // What needs no set-up comes first: a slip in the format is reported in a second.
    done("format", step("checking the format", command("cargo").args(["fmt", "--all", "--check"]))?);
    let mut clippy = command("cargo");
    clippy.args(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]);
    done("lints", step("lints, native", &mut clippy)?);

    let mut fuzz = command("cargo");
    fuzz.args(["check", "--locked", "--manifest-path", "tests/fuzz/Cargo.toml", "--no-default-features"]);
    fuzz.args(["--target-dir", "target/fuzz"]);
    done("fuzz targets", step("checking the fuzz targets", &mut fuzz)?);

    let setting_up = Instant::now();
    spelling::ensure()?;
    let setup = Setup::for_testing()?;
    let browser = browser::for_tests()?;
    let engines = engines::ensure()?;
    done("set-up", setting_up.elapsed());

    let mut clippy = setup.command("cargo");
    clippy.args(["clippy", "--target", "wasm32-unknown-unknown", "--lib", "--test", "wasm"]);
    clippy.args(["--", "-D", "warnings"]);
    done("wasm lints", step("lints, wasm32", &mut clippy)?);
    done("native tests", step("native tests", command("cargo").args(["test", "--workspace"]))?);
    let mut under_node = setup.command("cargo");
    under_node.args(["test", "--target", "wasm32-unknown-unknown", "--test", "wasm"]);
    under_node.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", "wasm-bindgen-test-runner");
    under_node.env("WASM_BINDGEN_TEST_ONLY_NODE", "1");
    done("wasm tests", step("wasm tests under Node", &mut under_node)?);
    // A module that is optimised as a whole keeps one processor busy.
    let (wasm, packages) = run::both(|| package::wasm(&setup), || library::packages(&setup))?;
    done("wasm package", wasm);
    done("packages", packages);
    done("wasm size", package::size()?);
    let (node, hostile) = run::both(|| npx::module(&setup), || hostile::main(None))?;
    done("hostile programs", hostile);
    done("module for Node", node);
    done("crate", library::crate_file()?);
    done("page types", step("checking the page's types", &mut setup.npm(&["run", "typecheck"]))?);
    done("workflows", step("checking the workflows", command("node").arg("tests/package/workflows.mjs"))?);
    done("page", package::page(&setup, native::Beside::Tests)?);
    npx::put_into_package()?;
    // Each of the two starts one program after the other.
    let (teams, (node, manuals)) =
        run::both(teams::ways, || Ok((npx::compare(&setup)?, manuals::recipes()?)))?;
    done("command line for Node", node);
    done("manuals", manuals);
    done("teams", teams);
    let mut playwright = setup.npm(&["run", "test:browser"]);
    playwright.env(browser::VARIABLE, browser).envs(engines);
    done("browser tests", step("browser tests", &mut playwright)?);

    let list: Vec<_> = times.iter().map(|(name, time)| format!("{name} {}", pretty(*time))).collect();
    run::say(format_args!("times: {}", list.join(", ")));
    run::say(format_args!("all {} steps passed in {}", times.len(), pretty(start.elapsed())));
    Ok(())
}
