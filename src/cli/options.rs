//! Options that several commands share: program, setup, language, output format, destination.
//!
//! In: arguments. Out: one group of options for each. Must not know the commands.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use crate::sentences::Language;
use crate::setup::Turret;
use crate::setup::dialect::Control;

/// A program and its setup.
#[derive(clap::Args)]
pub(super) struct Input {
    /// The program; `-` reads standard input.
    pub file: PathBuf,
    #[command(flatten)]
    pub with: ProgramOptions,
}

/// Setup options of programs.
#[derive(clap::Args, Default)]
pub(super) struct ProgramOptions {
    /// Setup: control, tools, stock, start point, as JSON or TOML, or the outline of the blank as DXF. Given more than
    /// once (a machine, a table of tools), of each group the last one holds.
    #[arg(long)]
    pub setup: Vec<PathBuf>,
    /// The configuration, instead of the `gcode-playground.toml` that is in the folder of the program or above it.
    #[arg(long, value_name = "FILE", conflicts_with = "no_config")]
    pub config: Option<PathBuf>,
    /// Heed no `gcode-playground.toml`.
    #[arg(long)]
    pub no_config: bool,
    /// The control; overrides the one of the setup.
    #[arg(long, value_enum)]
    pub control: Option<ControlName>,
    /// A folder with subprograms, such as `O2000.nc` for `M98 P2000`; may be given more than once. The folder of the program is
    /// always one.
    #[arg(long, value_name = "FOLDER")]
    pub library: Vec<PathBuf>,
}

/// Language of the output.
#[derive(clap::Args)]
pub(super) struct LanguageOptions {
    /// Language of messages and other texts, English by default.
    #[arg(long, visible_alias = "language", value_enum)]
    lang: Option<LanguageName>,
}

impl LanguageOptions {
    /// The requested language, by default English.
    pub fn language(&self) -> Language {
        self.given().unwrap_or(Language::English)
    }

    /// The requested language, if any.
    pub fn given(&self) -> Option<Language> {
        self.lang.map(LanguageName::language)
    }
}

/// Format of the output.
#[derive(clap::Args)]
pub(super) struct OutputFormat {
    /// Text for people, or one JSON object per line.
    #[arg(long, value_enum, default_value = "text")]
    pub format: Format,
}

/// Destination of the output.
#[derive(clap::Args)]
pub(super) struct Destination {
    /// Where to write it; standard output by default.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Destination {
    /// The file; `None` for standard output.
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
    Side,
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

/// Format of a text that a page or a comment can contain.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum PageFormat {
    Text,
    Json,
    Markdown,
}
