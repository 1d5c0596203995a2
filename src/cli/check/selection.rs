//! Which findings count, and their severity.
//!
//! In: names of rules, by slug or by code. Out: the setup with levels, and the findings that are left.

use super::super::configuration::Settings;
use super::super::rules::{level, named};
use crate::message::{Diagnostic, Severity};
use crate::setup::Setup;

/// Which rules.
#[derive(clap::Args)]
pub(super) struct Choice {
    /// Report these rules alone, by slug or code (`rapid-through-stock`, `PS0010`).
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    select: Vec<String>,
    /// Do not report these rules.
    #[arg(long, value_name = "RULE", value_delimiter = ',')]
    ignore: Vec<String>,
    /// The severity of a rule: `off`, `info`, `warning` or `error`; overrides setup and program.
    #[arg(long, value_name = "RULE=LEVEL", value_delimiter = ',')]
    severity: Vec<String>,
    /// Fail when there are more warnings than this.
    #[arg(long, value_name = "N")]
    pub(super) max_warnings: Option<usize>,
}

/// Names that have been found among the rules.
pub(super) struct Selection {
    select: Vec<&'static str>,
    levels: Vec<(&'static str, Severity)>,
}

impl Selection {
    /// Reads the names; the error says which is none, and the nearest that is one.
    pub(super) fn new(options: &Choice) -> Result<Self, String> {
        let mut select = Vec::new();
        for name in &options.select {
            select.extend(named(name)?);
        }
        let mut levels = Vec::new();
        for setting in &options.severity {
            let (name, written) = setting
                .split_once('=')
                .ok_or_else(|| format!("--severity {setting}: write it as RULE=LEVEL"))?;
            let level = level(written)?;
            levels.extend(named(name)?.into_iter().map(|slug| (slug, level)));
        }
        for name in &options.ignore {
            levels.extend(named(name)?.into_iter().map(|slug| (slug, Severity::Off)));
        }
        Ok(Self { select, levels })
    }

    /// The setup of some programs, with the levels that are asked for.
    pub(super) fn setup(&self, settings: &Settings) -> Setup {
        self.levelled(settings, settings.setup.clone())
    }

    /// A setup with them, whatever comments in the programs say.
    pub(super) fn levelled(&self, settings: &Settings, mut setup: Setup) -> Setup {
        let ignored = settings.ignore.iter().map(|slug| (*slug, Severity::Off));
        for (slug, level) in ignored.chain(self.levels.iter().copied()) {
            setup.rules.set(slug, level);
            setup.forced_rules.set(slug, level);
        }
        setup
    }

    /// Removes what is not among the rules that are reported alone.
    pub(super) fn keep(&self, settings: &Settings, found: &mut Vec<Diagnostic>) {
        found.retain(|one| self.takes(settings, one));
    }

    /// Whether a message is of the rules that are reported alone; where none are named, all are.
    pub(super) fn takes(&self, settings: &Settings, found: &Diagnostic) -> bool {
        let select = if self.select.is_empty() { &settings.select } else { &self.select };
        select.is_empty() || select.contains(&found.message.slug())
    }
}
