//! In: the rule files and `src/sentences`. Out: what is said in English only, since a language has no text for it.

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

/// `cargo xtask translations`: an error where a text is missing.
pub fn main() -> Result {
    let (rules, texts) = read()?;
    let missing = texts::missing(&rules, &texts);
    if missing.is_empty() {
        run::say("every text is there in every language");
        return Ok(());
    }
    Err(format!("{} texts are missing; English is shown instead:\n{}", missing.len(), missing.join("\n")))
}
