//! In: this machine. Out: the programs that run the browser tests in Firefox and WebKitGTK, found or
//! installed, each with the environment variable that passes it to the tests. A missing program is an error
//! with instructions; tests are never skipped. `browser` handles Chromium.

use std::path::PathBuf;
use std::{env, fs};

use crate::debian;
use crate::run::{self, Result};

/// A program that the tests start.
struct Program {
    /// The environment variable that names it. It is passed on to the tests.
    variable: &'static str,
    /// Its description for the user.
    what: &'static str,
    /// The Debian package that contains it.
    package: &'static str,
    /// Possible names on PATH.
    names: &'static [&'static str],
    /// Other possible locations, below `/usr`; `*` matches any one folder.
    places: &'static [&'static str],
}

const PROGRAMS: [Program; 5] = [
    Program {
        variable: "PLAYGROUND_FIREFOX",
        what: "Firefox",
        package: "firefox-esr",
        names: &["firefox-esr", "firefox"],
        places: &[],
    },
    Program {
        variable: "PLAYGROUND_WEBKIT_DRIVER",
        what: "WebKitGTK's WebDriver",
        package: "webkit2gtk-driver",
        names: &["WebKitWebDriver"],
        places: &[],
    },
    Program {
        variable: "PLAYGROUND_MINIBROWSER",
        what: "WebKitGTK's MiniBrowser",
        // The driver depends on it. The number differs between Debian versions, and the driver pulls in the
        // right one.
        package: "libwebkit2gtk-4.1-0",
        names: &["MiniBrowser"],
        places: &[
            "lib/*/webkit2gtk-4.1/MiniBrowser",
            "lib/*/webkitgtk-6.0/MiniBrowser",
            "lib/*/webkit2gtk-4.0/MiniBrowser",
            "lib/webkit2gtk-4.1/MiniBrowser",
            "libexec/webkit2gtk-4.1/MiniBrowser",
            "libexec/webkitgtk-6.0/MiniBrowser",
        ],
    },
    Program {
        variable: "PLAYGROUND_XVFB",
        what: "the X server without a screen",
        package: "xvfb",
        names: &["Xvfb"],
        places: &[],
    },
    Program {
        variable: "PLAYGROUND_XWD",
        what: "what takes pictures of its windows",
        package: "x11-apps",
        names: &["xwd"],
        places: &[],
    },
];

/// The Debian packages that contain the programs.
#[cfg(test)]
pub fn packages() -> impl Iterator<Item = &'static str> {
    PROGRAMS.iter().map(|program| program.package)
}

/// Finds or installs the programs. Returns each with its environment variable.
pub fn ensure() -> Result<Vec<(&'static str, PathBuf)>> {
    let missing: Vec<&Program> = PROGRAMS.iter().filter(|program| program.find().is_none()).collect();
    let mut refused = None;
    if !missing.is_empty() && debian::available() {
        let packages: Vec<&str> = missing.iter().map(|program| program.package).collect();
        refused = debian::install("installing Firefox and WebKitGTK for the browser tests", &packages).err();
    }
    let found = |program: &Program| program.find().map(|path| (program.variable, path));
    let all: Vec<_> = PROGRAMS.iter().filter_map(found).collect();
    if all.len() == PROGRAMS.len() { Ok(all) } else { Err(advice(refused.as_deref())) }
}

/// Instructions for the missing programs.
fn advice(refused: Option<&str>) -> String {
    let mut text = refused.map(|reason| format!("{reason}\n\n")).unwrap_or_default();
    text +=
        "The browser tests run in Chromium, Firefox and WebKitGTK, and some of what they need is missing:\n";
    for program in PROGRAMS.iter().filter(|program| program.find().is_none()) {
        let Program { variable, what, package, names, .. } = program;
        text += &format!("  {}: {what} (Debian: {package}; or set {variable} to its path)\n", names[0]);
        if let Some(named) = named(variable) {
            text += &format!("    {variable} is {}, which is no program\n", named.display());
        }
    }
    let packages: Vec<&str> = PROGRAMS.iter().map(|program| program.package).collect();
    text += &format!("On Debian: apt-get install {}\n", packages.join(" "));
    text += if cfg!(target_os = "linux") {
        "On other systems install the same programs, or run the tests in a container of Debian."
    } else {
        "WebKitGTK's driver runs on Linux only: run the tests in a container of Debian."
    };
    text
}

impl Program {
    fn find(&self) -> Option<PathBuf> {
        if let Some(path) = named(self.variable) {
            return Some(path).filter(|path| path.is_file());
        }
        let folders: Vec<PathBuf> =
            env::var_os("PATH").map(|path| env::split_paths(&path).collect()).unwrap_or_default();
        let on_path = self.names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
        let elsewhere = self.places.iter().flat_map(|place| expanded(place));
        on_path.chain(elsewhere).find(|path| path.is_file())
    }
}

fn named(variable: &str) -> Option<PathBuf> {
    env::var_os(variable).filter(|value| !value.is_empty()).map(PathBuf::from)
}

/// The paths that match a location.
fn expanded(place: &str) -> Vec<PathBuf> {
    let usr = PathBuf::from("/usr");
    let Some((before, behind)) = place.split_once("/*/") else { return vec![usr.join(place)] };
    let folders = fs::read_dir(usr.join(before)).into_iter().flatten().flatten();
    folders.map(|folder| folder.path().join(behind)).collect()
}

/// Prints which programs the tests use.
pub fn tell(programs: &[(&str, PathBuf)]) {
    for (variable, path) in programs {
        run::say(format_args!("{variable}: {}", path.display()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_advice_names_every_package() {
        let advice = advice(Some("no right to install"));
        assert!(advice.starts_with("no right to install\n"), "{advice}");
        for program in &PROGRAMS {
            assert!(advice.contains(program.package), "{advice}");
        }
    }

    #[test]
    fn a_star_is_any_folder() {
        assert_eq!(expanded("bin/x"), [PathBuf::from("/usr/bin/x")]);
        assert!(expanded("no-such-folder/*/x").is_empty());
    }
}
