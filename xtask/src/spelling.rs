//! In: this machine. Out: hunspell with the dictionaries that the spelling test needs, found or installed. If
//! something is missing and cannot be installed, the error says what to do.

use crate::debian;
use crate::run::{self, Result};

/// hunspell and its dictionaries.
pub const PACKAGES: [&str; 3] = ["hunspell", "hunspell-en-gb", "hunspell-ru"];

/// The names of these dictionaries in hunspell.
const DICTIONARIES: [&str; 2] = ["en_GB", "ru_RU"];

/// Finds hunspell and its dictionaries, or installs them.
pub fn ensure() -> Result {
    if is_there() {
        return Ok(());
    }
    let refused = if debian::available() {
        debian::install("installing hunspell for the spelling test", &PACKAGES).err()
    } else {
        None
    };
    if is_there() { Ok(()) } else { Err(advice(refused.as_deref())) }
}

/// Whether hunspell runs with all dictionaries.
fn is_there() -> bool {
    DICTIONARIES.iter().all(|dictionary| {
        let mut hunspell = run::command("hunspell");
        run::succeeds(hunspell.args(["-l", "-d", dictionary]))
    })
}

/// Instructions if it cannot be installed.
fn advice(refused: Option<&str>) -> String {
    let reason = refused.map(|reason| format!("{reason}\n\n")).unwrap_or_default();
    let (packages, dictionaries) = (PACKAGES.join(" "), DICTIONARIES.join(" and "));
    format!(
        "{reason}The spelling test needs hunspell with the dictionaries {dictionaries}.\n\
         On Debian: apt-get install {packages}\n\
         On other systems install hunspell, and put the dictionaries where `hunspell -D` looks for them."
    )
}

#[test]
fn the_advice_names_every_package() {
    let advice = advice(Some("no right to install"));
    assert!(advice.starts_with("no right to install\n"), "{advice}");
    assert!(PACKAGES.iter().all(|package| advice.contains(package)), "{advice}");
}
