//! What programs are run with and how they are checked: `gcode-playground.toml`, which is looked for in the folder of a program and
//! upward, and the options, which override it.
//!
//! In: options, the name of a file. Out: its setup and what else is said about it, each with the place that says it (`shown`). `file`
//! reads the configuration. Setups are JSON, or TOML with the same keys. Must not know: what is done with programs.

mod file;
pub(super) mod shown;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ignore::gitignore::{Gitignore, GitignoreBuilder};

use super::options::With;
use super::system;
use crate::message::Severity;
use crate::setup::dialect::Control;
use crate::setup::{Setup, profile};
use file::{Keys, Said, Values};

/// The name of the file.
pub(super) const NAME: &str = "gcode-playground.toml";

/// A file that was found and read.
#[derive(Debug)]
pub(super) struct Configuration {
    /// Its name, as it is shown.
    pub name: String,
    /// The folder it is in, from the root of the disk: names in the file start there.
    pub folder: PathBuf,
    /// What it says.
    pub keys: Keys,
    /// The patterns of its overrides.
    overrides: Vec<Gitignore>,
    /// The patterns of what is left out in folders.
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
        let patterns = |said: &[Said<String>]| {
            let lines = said.iter().map(|one| one.value.as_str());
            patterns(&folder, lines).map_err(|problem| at(format!("{}: {problem}", said[0].line)))
        };
        let overrides = keys.overrides.iter().map(|one| patterns(&one.files)).collect::<Result<_, _>>()?;
        let exclude = patterns(&keys.exclude)?;
        Ok(Self { name, overrides, exclude, folder, keys })
    }

    /// The overrides that hold for a file, by their numbers, in their order.
    fn overrides_for(&self, file: &Path) -> Vec<usize> {
        let is_inside = file.starts_with(&self.folder);
        let holds =
            |patterns: &Gitignore| is_inside && patterns.matched_path_or_any_parents(file, false).is_ignore();
        let holding = self.overrides.iter().enumerate().filter(|(_, patterns)| holds(patterns));
        holding.map(|(at, _)| at).collect()
    }

    /// What it says of programs for which some overrides hold, the last word last.
    fn values<'a>(&'a self, overrides: &'a [usize]) -> impl Iterator<Item = &'a Values> {
        let overriding = overrides.iter().filter_map(|at| self.keys.overrides.get(*at));
        std::iter::once(&self.keys.usual).chain(overriding.map(|one| &one.values))
    }

    /// A file that the configuration names, as it can be opened.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}

/// Patterns as lines of a `.gitignore` in a folder. The error names the one that is none.
pub(super) fn patterns<'a>(folder: &Path, lines: impl Iterator<Item = &'a str>) -> Result<Gitignore, String> {
    let mut builder = GitignoreBuilder::new(folder);
    builder.allow_unclosed_class(false);
    for line in lines {
        builder.add_line(None, line).map_err(|error| format!("{line}: {error}"))?;
    }
    builder.build().map_err(|error| error.to_string())
}

/// What is said about a program, and by whom.
#[derive(Debug)]
pub(super) struct Settings {
    /// The configuration, if there is one.
    pub configuration: Option<Arc<Configuration>>,
    /// The overrides of it that hold.
    overrides: Vec<usize>,
    /// What the setups say, as JSON, one after the other, each with its file.
    pub setups: Vec<(PathBuf, String)>,
    /// The control of the options or the configuration.
    pub control: Option<Control>,
    /// Severities of rules and groups in the configuration.
    pub rules: Vec<(&'static str, Severity)>,
    /// Rules that are reported alone; none: all.
    pub select: Vec<&'static str>,
    /// Rules that are not reported.
    pub ignore: Vec<&'static str>,
    /// The setup of all that.
    pub setup: Setup,
}

impl Settings {
    /// The setup of all that, read anew.
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

    /// What the configuration says of programs, the last word last.
    fn values(&self) -> impl Iterator<Item = &Values> {
        self.configuration.iter().flat_map(|one| one.values(&self.overrides))
    }
}

/// Finds and reads configurations and setups, each once.
pub(super) struct Configurations<'a> {
    with: &'a With,
    /// The one that `--config` names.
    given: Option<Arc<Configuration>>,
    /// What the options name, as JSON.
    setups: Vec<(PathBuf, String)>,
    found: Mutex<Found>,
}

/// By folder, by file.
#[derive(Default)]
struct Found {
    folders: HashMap<PathBuf, Result<Option<Arc<Configuration>>, String>>,
    setups: HashMap<PathBuf, Result<String, String>>,
    settings: HashMap<Applying, Result<Arc<Settings>, String>>,
}

/// What applies to a program: the folder of its configuration, and the overrides that hold.
type Applying = (Option<PathBuf>, Vec<usize>);

impl<'a> Configurations<'a> {
    /// Reads what the options name.
    pub(super) fn new(with: &'a With) -> Result<Self, String> {
        let given = with.config.as_deref().map(Configuration::read).transpose()?.map(Arc::new);
        let setups = with.setup.iter().map(|path| Ok((path.clone(), setup_text(path)?)));
        Ok(Self { with, given, setups: setups.collect::<Result<_, String>>()?, found: Mutex::default() })
    }

    /// What the options name, as JSON.
    pub(super) fn setups(&self) -> Vec<String> {
        self.setups.iter().map(|(_, json)| json.clone()).collect()
    }

    /// The configuration of a file, or of a folder with a file that is not there; nothing where there is none.
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
                // Another folder may have found it.
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

    /// The folders in which subprograms are searched for: the folder of the program, then `--library`, then the key `library`.
    pub(super) fn libraries(&self, file: &Path) -> Result<Vec<PathBuf>, String> {
        let own = if file == Path::new("-") { None } else { absolute(file).parent().map(Path::to_owned) };
        let mut folders: Vec<_> = own.into_iter().chain(self.with.library.iter().cloned()).collect();
        if let Some(configuration) = self.of(file)? {
            folders.extend(configuration.keys.library.iter().map(|said| configuration.file(&said.value)));
        }
        Ok(folders)
    }

    /// What is said about a program.
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
        // Each is right; together they may be too much.
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

/// A setup file as JSON. The error names the file and, where it can be said, the place.
fn setup_text(path: &Path) -> Result<String, String> {
    let name = shown(path);
    let text = system::read_text(path)?;
    if !path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
        let value = serde_json::from_str::<serde_json::Value>(&text);
        if value.is_ok_and(|value| !value.is_object()) {
            return Err(format!("{name}: a setup is an object: {{\"stock\": {{…}}, \"tools\": {{…}}}}"));
        }
        Setup::from_json(&text).map_err(|problem| format!("{name}: {problem}"))?;
        return Ok(text);
    }
    // By its own reader, which knows the places, and then as JSON, as all other setups are.
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

/// A path from the root of the disk; as it is where there is no such thing.
fn absolute(path: &Path) -> PathBuf {
    system::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// A path as it is shown: from the folder the process works in, where it is in it.
pub(super) fn shown(path: &Path) -> String {
    let here = absolute(Path::new("."));
    let short = absolute(path).strip_prefix(&here).map(Path::to_owned).unwrap_or_else(|_| path.to_owned());
    super::terminal::printable_name(&short)
}
