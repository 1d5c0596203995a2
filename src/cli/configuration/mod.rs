//! The setup and check options of programs: from `gcode-playground.toml`, searched for in the folder of the
//! program and its parents, and from the command-line options, which override it.
//!
//! In: options, a file name. Out: the settings of the file, each with its source (`shown`). `file` parses the
//! configuration. Setups are JSON, TOML with the same keys, or a DXF drawing of the blank. Must not know: the commands.

mod dxf;
mod file;
pub(super) mod keys;
pub(super) mod shown;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ignore::gitignore::{Gitignore, GitignoreBuilder};

use super::options::ProgramOptions;
use super::system;
use crate::message::Severity;
use crate::setup::dialect::Control;
use crate::setup::{Setup, profile};
pub(super) use file::web_address;
use file::{Keys, Located, Values};

/// Name of the configuration file.
pub(super) const NAME: &str = "gcode-playground.toml";

/// A parsed configuration file.
#[derive(Debug)]
pub(super) struct Configuration {
    /// Its name for messages.
    pub name: String,
    /// The absolute path of its folder; paths in the file are relative to it.
    pub folder: PathBuf,
    /// Its contents.
    pub keys: Keys,
    /// The patterns of its overrides, in the same order.
    overrides: Vec<Gitignore>,
    /// The patterns of excluded files.
    pub exclude: Gitignore,
}

impl Configuration {
    fn read(path: &Path) -> Result<Self, String> {
        let name = shown(path);
        let at = |problem: String| format!("{name}:{problem}");
        let text = system::read_text(path)?;
        let keys = file::read(&text).map_err(at)?;
        let mut folder =
            system::absolute(path).map_err(|error| format!("{name}: {}", system::reason(&error)))?;
        folder.pop();
        let patterns = |said: &[Located<String>]| {
            let lines = said.iter().map(|one| one.value.as_str());
            patterns(&folder, lines).map_err(|problem| at(format!("{}: {problem}", said[0].line)))
        };
        let overrides = keys.overrides.iter().map(|one| patterns(&one.files)).collect::<Result<_, _>>()?;
        let exclude = patterns(&keys.exclude)?;
        Ok(Self { name, overrides, exclude, folder, keys })
    }

    /// Indices of the overrides that apply to a file, in order.
    fn overrides_for(&self, file: &Path) -> Vec<usize> {
        let is_inside = file.starts_with(&self.folder);
        let holds =
            |patterns: &Gitignore| is_inside && patterns.matched_path_or_any_parents(file, false).is_ignore();
        let holding = self.overrides.iter().enumerate().filter(|(_, patterns)| holds(patterns));
        holding.map(|(at, _)| at).collect()
    }

    /// Its values with these overrides, in increasing order of precedence.
    fn values<'a>(&'a self, overrides: &'a [usize]) -> impl Iterator<Item = &'a Values> {
        let overriding = overrides.iter().filter_map(|at| self.keys.overrides.get(*at));
        std::iter::once(&self.keys.usual).chain(overriding.map(|one| &one.values))
    }

    /// The path of a file that the configuration names.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}

/// Compiles patterns in the syntax of `.gitignore`, relative to `folder`. The error names an invalid pattern.
pub(super) fn patterns<'a>(folder: &Path, lines: impl Iterator<Item = &'a str>) -> Result<Gitignore, String> {
    let mut builder = GitignoreBuilder::new(folder);
    builder.allow_unclosed_class(false);
    for line in lines {
        builder.add_line(None, line).map_err(|error| format!("{line}: {error}"))?;
    }
    builder.build().map_err(|error| error.to_string())
}

/// The settings of a program, with their sources.
#[derive(Debug)]
pub(super) struct Settings {
    /// The configuration, if any.
    pub configuration: Option<Arc<Configuration>>,
    /// Indices of the overrides that apply.
    overrides: Vec<usize>,
    /// The setups as JSON, in order, each with its file.
    pub setups: Vec<(PathBuf, String)>,
    /// The control from the options or the configuration.
    pub control: Option<Control>,
    /// Severities of rules and groups from the configuration.
    pub rules: Vec<(&'static str, Severity)>,
    /// Rules to report; all if empty.
    pub select: Vec<&'static str>,
    /// Rules that are not reported.
    pub ignore: Vec<&'static str>,
    /// The setup that results from all of these.
    pub setup: Setup,
}

impl Settings {
    /// Parses and merges the setups.
    fn joined(&self) -> Result<Setup, String> {
        let texts: Vec<String> = self.setups.iter().map(|(_, json)| json.clone()).collect();
        let mut setup = profile::joined(&texts)?;
        if self.control.is_some() {
            setup.dialect.control = self.control;
        }
        for (name, level) in &self.rules {
            setup.rules.set(name, *level);
        }
        Ok(setup)
    }

    /// Values from the configuration, in increasing order of precedence.
    fn values(&self) -> impl Iterator<Item = &Values> {
        self.configuration.iter().flat_map(|one| one.values(&self.overrides))
    }
}

/// Finds and reads configurations and setups, each once.
pub(super) struct Configurations<'a> {
    with: &'a ProgramOptions,
    /// The configuration given by `--config`.
    given: Option<Arc<Configuration>>,
    /// The setups given by `--setup`, as JSON.
    setups: Vec<(PathBuf, String)>,
    found: Mutex<Found>,
}

/// Caches: configurations by folder, setups by file.
#[derive(Default)]
struct Found {
    folders: HashMap<PathBuf, Result<Option<Arc<Configuration>>, String>>,
    setups: HashMap<PathBuf, Result<String, String>>,
    settings: HashMap<Applying, Result<Arc<Settings>, String>>,
}

/// Cache key of settings: the folder of the configuration, and the overrides that apply.
type Applying = (Option<PathBuf>, Vec<usize>);

impl<'a> Configurations<'a> {
    /// Reads the files given by the options.
    pub(super) fn new(with: &'a ProgramOptions) -> Result<Self, String> {
        let given = with.config.as_deref().map(Configuration::read).transpose()?.map(Arc::new);
        let setups = with.setup.iter().map(|path| Ok((path.clone(), setup_text(path)?)));
        Ok(Self { with, given, setups: setups.collect::<Result<_, String>>()?, found: Mutex::default() })
    }

    /// The setups given by the options, as JSON.
    pub(super) fn setups(&self) -> Vec<String> {
        self.setups.iter().map(|(_, json)| json.clone()).collect()
    }

    /// The configuration for a file, which need not exist. `None` if there is no configuration.
    pub(super) fn of(&self, file: &Path) -> Result<Option<Arc<Configuration>>, String> {
        if self.with.no_config {
            return Ok(None);
        }
        if self.given.is_some() {
            return Ok(self.given.clone());
        }
        let Some(folder) = absolute(file).parent().map(Path::to_owned) else { return Ok(None) };
        let mut found = self.found();
        if let Some(known) = found.folders.get(&folder) {
            return known.clone();
        }
        let read = folder.ancestors().find_map(|folder| {
            let path = folder.join(NAME);
            system::kind(&path).is_ok().then_some(path)
        });
        let read = match read {
            None => Ok(None),
            Some(path) => {
                // It may be cached for another folder.
                let holder = path.parent().unwrap_or(Path::new("")).to_owned();
                let known = found.folders.get(&holder).cloned();
                let read = known.unwrap_or_else(|| Configuration::read(&path).map(|one| Some(Arc::new(one))));
                found.folders.insert(holder, read.clone());
                read
            }
        };
        found.folders.insert(folder, read.clone());
        read
    }

    /// Folders to search for subprograms: the folder of the program, then `--library`, then the key
    /// `library`.
    pub(super) fn libraries(&self, file: &Path) -> Result<Vec<PathBuf>, String> {
        let own = if file == Path::new("-") { None } else { absolute(file).parent().map(Path::to_owned) };
        let mut folders: Vec<_> = own.into_iter().chain(self.with.library.iter().cloned()).collect();
        if let Some(configuration) = self.of(file)? {
            folders.extend(configuration.keys.library.iter().map(|said| configuration.file(&said.value)));
        }
        Ok(folders)
    }

    /// The settings of a program.
    pub(super) fn settings(&self, file: &Path) -> Result<Arc<Settings>, String> {
        let configuration = self.of(file)?;
        let path = absolute(file);
        let overrides = configuration.as_ref().map_or_else(Vec::new, |one| one.overrides_for(&path));
        let key = (configuration.as_ref().map(|one| one.folder.clone()), overrides.clone());
        if let Some(known) = self.found().settings.get(&key) {
            return known.clone();
        }
        let settings = self.read(configuration, overrides).map(Arc::new);
        self.found().settings.insert(key, settings.clone());
        settings
    }

    fn read(
        &self,
        configuration: Option<Arc<Configuration>>,
        overrides: Vec<usize>,
    ) -> Result<Settings, String> {
        let mut settings = Settings {
            configuration: configuration.clone(),
            overrides: overrides.clone(),
            setups: Vec::new(),
            control: None,
            rules: Vec::new(),
            select: Vec::new(),
            ignore: Vec::new(),
            setup: Setup::default(),
        };
        for (configuration, values) in
            configuration.iter().flat_map(|one| one.values(&overrides).map(move |values| (one, values)))
        {
            for said in &values.setup {
                let path = configuration.file(&said.value);
                let json = self
                    .setup_of(&path)
                    .map_err(|problem| format!("{}:{}: {problem}", configuration.name, said.line))?;
                settings.setups.push((path, json));
            }
            settings.control = values.control.as_ref().map(|said| said.value).or(settings.control);
            settings.rules.extend(values.rules.iter().map(|said| said.value));
            if !values.select.is_empty() {
                settings.select = values.select.iter().map(|said| said.value).collect();
            }
            settings.ignore.extend(values.ignore.iter().map(|said| said.value));
        }
        settings.setups.extend(self.setups.iter().cloned());
        settings.control = self.with.control.map(|name| name.control()).or(settings.control);
        // Each setup is valid, but the merged one may exceed a limit.
        settings.setup = settings.joined()?;
        Ok(settings)
    }

    fn setup_of(&self, path: &Path) -> Result<String, String> {
        if let Some(known) = self.found().setups.get(path) {
            return known.clone();
        }
        let text = setup_text(path);
        self.found().setups.insert(path.to_owned(), text.clone());
        text
    }

    fn found(&self) -> std::sync::MutexGuard<'_, Found> {
        self.found.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Reads a setup file and converts it to JSON. The error names the file and, if known, the position.
fn setup_text(path: &Path) -> Result<String, String> {
    let name = shown(path);
    let text = system::read_text(path)?;
    let ends_in = |wanted: &str| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted));
    if ends_in("dxf") {
        let json = dxf::setup(&text).map_err(|problem| format!("{name}: {problem}"))?;
        return Setup::from_json(&json).map(|_| json).map_err(|problem| format!("{name}: {problem}"));
    }
    if !ends_in("toml") {
        let value = serde_json::from_str::<serde_json::Value>(&text);
        if value.is_ok_and(|value| !value.is_object()) {
            return Err(format!("{name}: a setup is an object: {{\"stock\": {{…}}, \"tools\": {{…}}}}"));
        }
        Setup::from_json(&text).map_err(|problem| format!("{name}: {problem}"))?;
        return Ok(text);
    }
    // Parsed as a TOML setup first, for errors with positions; then converted to JSON, like all other setups.
    let placed = |error: toml::de::Error| {
        let at = error.span().map_or(0, |span| span.start);
        let before = text.get(..at).unwrap_or_default();
        let column = before.len() - before.rfind('\n').map_or(0, |end| end + 1) + 1;
        format!("{name}:{}:{column}: {}", before.matches('\n').count() + 1, error.message())
    };
    toml::from_str::<Setup>(&text).map_err(placed)?;
    let value: serde_json::Value = toml::from_str(&text).map_err(placed)?;
    let json = value.to_string();
    Setup::from_json(&json).map_err(|problem| format!("{name}: {problem}"))?;
    Ok(json)
}

/// The absolute path; unchanged on error.
fn absolute(path: &Path) -> PathBuf {
    system::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// A path for messages: relative to the working directory if it is inside.
pub(super) fn shown(path: &Path) -> String {
    let here = absolute(Path::new("."));
    let short = absolute(path).strip_prefix(&here).map(Path::to_owned).unwrap_or_else(|_| path.to_owned());
    super::terminal::printable_name(&short)
}
