//! In: the rule files, `src/sentences` and the texts of the page. Out: the texts that are missing in Chinese
//! or Russian; English is shown in their place.

use crate::format::{self, RuleFile};
use crate::run::{self, Result};
use crate::texts::{self, Texts};

/// The rule files and the other texts.
pub fn read() -> Result<(Vec<RuleFile>, Texts)> {
    let project = run::root();
    let project = project.to_string_lossy();
    let mut rules = Vec::new();
    for (name, rule) in format::all(&project) {
        rules.push(rule.map_err(|mistakes| format!("src/rules/{name}.md: {}", mistakes[0]))?);
    }
    Ok((rules, Texts::read(&project)))
}

/// The exit code of the script if texts are missing.
const MISSING: i32 = 3;

/// The missing texts, one per line.
pub fn missing() -> Result<Vec<String>> {
    let (rules, texts) = read()?;
    let mut missing = texts::missing(&rules, &texts);
    let mut node = run::command("node");
    let page =
        node.arg("www/translations.mjs").output().map_err(|error| format!("cannot start node: {error}"))?;
    if !matches!(page.status.code(), Some(0 | MISSING)) {
        return Err(format!("www/translations.mjs: {}", String::from_utf8_lossy(&page.stderr)));
    }
    missing.extend(String::from_utf8_lossy(&page.stdout).lines().map(str::to_owned));
    Ok(missing)
}

/// The list of missing texts as a message.
pub fn message(missing: &[String]) -> String {
    format!("{} texts are missing; English is shown instead:\n{}", missing.len(), missing.join("\n"))
}

/// `cargo xtask translations`: fails if a text is missing.
pub fn main() -> Result {
    let missing = missing()?;
    if missing.is_empty() {
        run::say("every text is there in every language");
        return Ok(());
    }
    Err(message(&missing))
}
