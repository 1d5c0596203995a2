//! Which findings count, and their severity.
//!
//! In: rules, by slug or by code. Out: the setup with severities, and the findings that remain.

use super::super::configuration::Settings;
use super::super::rules::{level, named};
use crate::message::{Diagnostic, Severity};
use crate::setup::Setup;

/// Options that select rules and set severities.
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

/// The selected rules, and the severities that are set.
#[derive(Default)]
pub(in crate::cli) struct Selection {
    select: Vec<&'static str>,
    levels: Vec<(&'static str, Severity)>,
}

impl Selection {
    /// Looks up the rules; the error names an unknown rule and the most similar known one.
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

    /// The setup of a program with the requested severities.
    pub(in crate::cli) fn setup(&self, settings: &Settings) -> Setup {
        self.levelled(settings, settings.setup.clone())
    }

    /// `setup` with the requested severities, which override comments in programs.
    pub(super) fn levelled(&self, settings: &Settings, mut setup: Setup) -> Setup {
        let ignored = settings.ignore.iter().map(|slug| (*slug, Severity::Off));
        for (slug, level) in ignored.chain(self.levels.iter().copied()) {
            setup.rules.set(slug, level);
            setup.forced_rules.set(slug, level);
        }
        setup
    }

    /// Removes findings of rules that are not selected.
    pub(super) fn keep(&self, settings: &Settings, found: &mut Vec<Diagnostic>) {
        found.retain(|one| self.takes(settings, one));
    }

    /// Whether the rule of a finding is selected. All rules are selected if none is named.
    pub(super) fn takes(&self, settings: &Settings, found: &Diagnostic) -> bool {
        let select = if self.select.is_empty() { &settings.select } else { &self.select };
        select.is_empty() || select.contains(&found.message.slug())
    }
}
