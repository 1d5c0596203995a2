//! What the server needs from its surroundings: the settings of a program, and the files with subprograms.
//!
//! In: the address (URI) of a document. Out: settings, texts. The command line implements it with files.

use crate::message::Diagnostic;
use crate::run::subprograms::Joined;
use crate::sentences::Language;
use crate::setup::Setup;

/// How a program is run and checked.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The setup, with the severities of rules.
    pub setup: Setup,
    /// The rules to report, by slug; all if empty.
    pub select: Vec<&'static str>,
    /// The language of the messages, if it is set.
    pub language: Option<Language>,
    /// The address of the folder with the rule pages, if it is set.
    pub rules_url: Option<String>,
}

impl Settings {
    /// Whether a message is reported.
    pub fn takes(&self, found: &Diagnostic) -> bool {
        self.select.is_empty() || self.select.contains(&found.message.slug())
    }
}

/// The surroundings of a server.
pub trait Host {
    /// The settings of the program at an address. The error is a sentence for the user.
    fn settings(&self, address: &str) -> Result<Settings, String>;

    /// The program with the subprograms that it calls and does not contain, at most `most` bytes in all;
    /// `None` if there are none.
    fn with_subprograms(&self, address: &str, text: &[u8], most: usize) -> Option<Joined>;

    /// Forgets everything that was read, because files have changed.
    fn forget(&mut self);
}

/// Surroundings without files: every program has the same settings.
#[derive(Debug, Default)]
pub struct NoFiles {
    /// The settings.
    pub settings: Settings,
}

impl Host for NoFiles {
    fn settings(&self, _: &str) -> Result<Settings, String> {
        Ok(self.settings.clone())
    }

    fn with_subprograms(&self, _: &str, _: &[u8], _: usize) -> Option<Joined> {
        None
    }

    fn forget(&mut self) {}
}
