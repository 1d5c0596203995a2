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
    pub with: With,
}

/// Setup options of programs.
#[derive(clap::Args, Default)]
pub(super) struct With {
    /// Setup: control, tools, stock, start point, as JSON or TOML. Given more than once (a machine, a table of tools),
    /// of each group the last one holds.
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
pub(super) struct Texts {
    /// Language of messages and other texts, English when left out.
    #[arg(long, visible_alias = "language", value_enum)]
    lang: Option<LanguageName>,
}

impl Texts {
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
pub(super) struct Form {
    /// Text for people, or one JSON object a line.
    #[arg(long, value_enum, default_value = "text")]
    pub format: Format,
}

/// Destination of the output.
#[derive(clap::Args)]
pub(super) struct Destination {
    /// Where to write it; standard output when left out.
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

/// The annotations of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FigureName {
    /// The letters and dimensions of a cycle: the one in a line, from 1, or the first.
    Cycle { line: Option<u32> },
    /// The dimensions of the finished part.
    Part,
    /// The dimension of the word at a place: line and column, from 1.
    Word { line: u32, column: u32 },
}

impl FigureName {
    /// Parses `cycle`, `cycle:LINE`, `part` or `word:LINE:COLUMN`.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse().ok().filter(|number| *number > 0);
        let mut parts = text.split(':');
        let figure = match (parts.next(), parts.next(), parts.next(), parts.next()) {
            (Some("cycle"), None, None, None) => Some(Self::Cycle { line: None }),
            (Some("cycle"), Some(line), None, None) => {
                number(line).map(|line| Self::Cycle { line: Some(line) })
            }
            (Some("part"), None, None, None) => Some(Self::Part),
            (Some("word"), Some(line), Some(column), None) => {
                number(line).zip(number(column)).map(|(line, column)| Self::Word { line, column })
            }
            _ => None,
        };
        figure.ok_or_else(|| "expected cycle, cycle:LINE, part or word:LINE:COLUMN".to_owned())
    }
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
