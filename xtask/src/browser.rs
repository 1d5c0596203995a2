//! In: this machine. Out: the path of a Chromium, Chrome or Edge for the browser tests, found or installed. A
//! missing browser is an error with instructions; tests are never skipped.

use std::env;
use std::path::PathBuf;

use crate::debian;
use crate::run::{self, Result};

/// The environment variable that names the browser. It is passed on to the browser tests.
pub const VARIABLE: &str = "PLAYGROUND_CHROMIUM";

/// Headless Chromium, as packaged by Debian: it starts a page in half the time.
pub const HEADLESS_SHELL: &str = "chromium-headless-shell";

/// Finds or installs the browser of the tests: the named one, or the headless shell, or the result of
/// [`ensure`].
pub fn for_tests() -> Result<PathBuf> {
    let is_named = env::var_os(VARIABLE).is_some_and(|value| !value.is_empty());
    let shell = || on_path(&[HEADLESS_SHELL]).find(is_there);
    if is_named {
        return ensure();
    }
    // Debian has it since version 12. If it is unavailable, any other Chromium works.
    if shell().is_none() && installed().is_none() && debian::available() {
        let _ = debian::install("installing the Chromium browser without windows", &[HEADLESS_SHELL]);
    }
    shell().map_or_else(ensure, Ok)
}

/// Finds or installs a browser. Requires the npm packages of the page, because the browser of Playwright is
/// the last resort.
pub fn ensure() -> Result<PathBuf> {
    if let Some(path) = env::var_os(VARIABLE).filter(|value| !value.is_empty()).map(PathBuf::from) {
        return if works(&path) {
            Ok(path)
        } else {
            Err(format!("{VARIABLE} is {}, which is no browser that starts", path.display()))
        };
    }
    if let Some(path) = installed() {
        return Ok(path);
    }
    let mut refused = String::new();
    if debian::available() {
        match debian::install("installing the Chromium browser", &["chromium"]) {
            Ok(()) => refused = "Debian's package `chromium` is installed, but does not start".to_owned(),
            Err(error) => refused = error,
        }
        if let Some(path) = installed() {
            return Ok(path);
        }
    }
    if let Some(path) = playwrights().filter(works) {
        return Ok(path);
    }
    let mut install = run::command("node");
    install.current_dir(run::www()).args(["node_modules/@playwright/test/cli.js", "install", "chromium"]);
    if let Err(error) = run::quiet("installing Playwright's Chromium browser", &mut install) {
        refused = [refused, error].join("\n");
    }
    playwrights().filter(works).ok_or_else(|| {
        format!(
            "{}\n\nThe browser tests need Chromium, Chrome or Edge, and none could be found or installed.\n\
             Install one, or set {VARIABLE} to the path of one, then start this command again.",
            refused.trim()
        )
    })
}

/// A browser in one of the usual locations.
fn installed() -> Option<PathBuf> {
    const NAMES: [&str; 6] = [
        "chromium",
        "chromium-browser",
        "google-chrome-stable",
        "google-chrome",
        "chrome",
        "microsoft-edge-stable",
    ];
    on_path(&NAMES).chain(usual_places()).find(is_there)
}

fn is_there(path: &PathBuf) -> bool {
    path.is_file() && works(path)
}

/// Possible paths of programs with these names.
fn on_path<'a>(names: &'a [&str]) -> impl Iterator<Item = PathBuf> + 'a {
    let folders: Vec<PathBuf> =
        env::var_os("PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
    names.iter().flat_map(move |name| {
        let file = format!("{name}{}", env::consts::EXE_SUFFIX);
        folders.iter().map(|folder| folder.join(&file)).collect::<Vec<_>>()
    })
}

fn usual_places() -> Vec<PathBuf> {
    let (roots, places): (Vec<PathBuf>, &[&str]) = if cfg!(windows) {
        let roots = ["ProgramFiles", "ProgramFiles(x86)", "LOCALAPPDATA"];
        (
            roots.iter().filter_map(env::var_os).map(PathBuf::from).collect(),
            &[
                r"Google\Chrome\Application\chrome.exe",
                r"Chromium\Application\chrome.exe",
                r"Microsoft\Edge\Application\msedge.exe",
            ],
        )
    } else if cfg!(target_os = "macos") {
        let home = env::var_os("HOME").map(|home| PathBuf::from(home).join("Applications"));
        (
            [Some(PathBuf::from("/Applications")), home].into_iter().flatten().collect(),
            &[
                "Google Chrome.app/Contents/MacOS/Google Chrome",
                "Chromium.app/Contents/MacOS/Chromium",
                "Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
            ],
        )
    } else {
        (vec![PathBuf::from("/opt")], &["google/chrome/chrome", "microsoft/msedge/msedge"])
    };
    roots.iter().flat_map(|root| places.iter().map(|place| root.join(place))).collect()
}

/// Path of the browser of the installed Playwright version; it may not exist.
fn playwrights() -> Option<PathBuf> {
    let mut node = run::command("node");
    node.current_dir(run::www());
    let path = run::ask(node.args(["-p", "require('@playwright/test').chromium.executablePath()"]))?;
    Some(PathBuf::from(path))
}

/// Whether it starts: on some systems `chromium` only prints where to get it. That does not happen on Windows
/// and macOS, where asking for the version may open a window.
fn works(path: &PathBuf) -> bool {
    if cfg!(any(windows, target_os = "macos")) {
        path.is_file()
    } else {
        run::succeeds(run::command(path).arg("--version"))
    }
}
