//! Options that several commands share: a program, what it is run with, a language, a form
//! of output, a destination.
//!
//! In: what is typed. Out: one group of options for each. Must not know the commands.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use crate::sentences::Language;
use crate::setup::Turret;
use crate::setup::dialect::Control;

/// A program, and what it is run with.
#[derive(clap::Args)]
pub(super) struct Input {
    /// The program; `-` reads standard input.
    pub file: PathBuf,
    #[command(flatten)]
    pub with: With,
}

/// What programs are run with.
#[derive(clap::Args)]
pub(super) struct With {
    /// Setup: control, tools, stock, start point, as JSON. Given more than once (a machine, a table of tools),
    /// of each group the last one holds.
    #[arg(long)]
    pub setup: Vec<PathBuf>,
    /// The control; overrides the one of the setup.
    #[arg(long, value_enum)]
    pub control: Option<ControlName>,
}

/// The language of what is written for people.
#[derive(clap::Args)]
pub(super) struct Texts {
    /// Language of messages and other texts.
    #[arg(long, visible_alias = "language", value_enum, default_value = "en")]
    lang: LanguageName,
}

impl Texts {
    /// The language that is asked for.
    pub fn language(&self) -> Language {
        self.lang.language()
    }
}

/// For people, or for other programs.
#[derive(clap::Args)]
pub(super) struct Form {
    /// Text for people, or one JSON object a line.
    #[arg(long, value_enum, default_value = "text")]
    pub format: Format,
}

/// A file that is written.
#[derive(clap::Args)]
pub(super) struct Destination {
    /// Where to write it; standard output when left out.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Destination {
    /// The file; standard output where there is none.
    pub fn file(&self) -> Option<&Path> {
        self.output.as_deref()
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum ControlName {
    Fanuc,
    Gsk,
    Forum,
}

impl ControlName {
    pub fn control(self) -> Control {
        match self {
            Self::Fanuc => Control::Fanuc,
            Self::Gsk => Control::Gsk,
            Self::Forum => Control::Forum,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum LanguageName {
    En,
    Zh,
    Ru,
}

impl LanguageName {
    pub fn language(self) -> Language {
        match self {
            Self::En => Language::English,
            Self::Zh => Language::Chinese,
            Self::Ru => Language::Russian,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum ViewName {
    Section,
    Face,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum TurretName {
    Rear,
    Front,
}

impl TurretName {
    pub fn turret(self) -> Turret {
        match self {
            Self::Rear => Turret::Rear,
            Self::Front => Turret::Front,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Json,
}
