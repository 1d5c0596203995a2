//! `config`: prints the settings of a program, each with its source.
//!
//! In: the name of a program, options. Out: text, or JSON with one row for each value.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::super::options::{Format, OutputFormat, ProgramOptions};
use super::super::{Status, print, write_row};
use super::{Configuration, Configurations, Located, Settings, Values, shown};
use crate::api::Configured as Row;
use crate::message::Severity;
use crate::setup::dialect::Control;

/// The arguments of `config`.
#[derive(clap::Args)]
pub(in crate::cli) struct Config {
    /// The program, which need not be there; without it, what holds in this folder.
    file: Option<PathBuf>,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    form: OutputFormat,
}

/// Runs `config`.
pub(in crate::cli) fn run(arguments: &Config) -> Result<Status, String> {
    let file = arguments.file.as_deref().unwrap_or(Path::new("program"));
    let settings = Configurations::new(&arguments.with)?.settings(file)?;
    let rows = rows(&settings, &arguments.with);
    print(|out| write(out, &settings, &rows, arguments.form.format))?;
    Ok(Status::Right)
}

fn write(out: &mut dyn Write, settings: &Settings, rows: &[Row], format: Format) -> io::Result<()> {
    if format == Format::Json {
        return rows.iter().try_for_each(|row| write_row(out, row));
    }
    match &settings.configuration {
        Some(configuration) => writeln!(out, "{}", configuration.name)?,
        None => writeln!(out, "no {}", super::NAME)?,
    }
    let width = |of: fn(&Row) -> &String| rows.iter().map(|row| of(row).chars().count()).max().unwrap_or(0);
    let (keys, values) = (width(|row| &row.key), width(|row| &row.value));
    for Row { key, value, from } in rows {
        let from = from.as_deref().unwrap_or("usual");
        writeln!(out, "  {key:keys$}  {value:values$}  {from}")?;
    }
    Ok(())
}

/// The settings, one row for each value.
fn rows(settings: &Settings, with: &ProgramOptions) -> Vec<Row> {
    let file = settings.configuration.as_deref().map(|configuration| configuration.name.clone());
    let mut rows = Rows { list: Vec::new(), file };
    let located = |name: fn(&Values) -> Option<&Located<Control>>| settings.values().filter_map(name).last();
    match (&with.control, located(|values| values.control.as_ref())) {
        (Some(name), _) => rows.add("control", name.control().name(), "--control"),
        (None, Some(located)) => rows.add_located("control", located.value.name(), located),
        (None, None) => match control_of_setups(settings) {
            Some((name, file)) => rows.add("control", &name, &file),
            None => rows.add_default("control", "fanuc, if the program says nothing else"),
        },
    }
    for located in settings.values().flat_map(|values| &values.setup) {
        rows.add_located("setup", &located.value, located);
    }
    for path in &with.setup {
        rows.add("setup", &shown(path), "--setup");
    }
    if settings.setups.is_empty() {
        rows.add_default("setup", "none");
    }
    for located in settings.values().flat_map(|values| &values.rules) {
        let (name, level): (&str, Severity) = located.value;
        rows.add_located(&format!("rules.{name}"), level.name(), located);
    }
    let select = settings.values().filter(|values| !values.select.is_empty()).last();
    for located in select.into_iter().flat_map(|values| &values.select) {
        rows.add_located("select", located.value, located);
    }
    if select.is_none() {
        rows.add_default("select", "all rules");
    }
    for located in settings.values().flat_map(|values| &values.ignore) {
        rows.add_located("ignore", located.value, located);
    }
    whole_check(&mut rows, settings.configuration.as_deref());
    rows.list
}

/// The control from the last setup that names one, and its file.
fn control_of_setups(settings: &Settings) -> Option<(String, String)> {
    settings.setups.iter().rev().find_map(|(file, json)| {
        let setup: serde_json::Value = serde_json::from_str(json).ok()?;
        Some((setup["dialect"]["control"].as_str()?.to_owned(), shown(file)))
    })
}

/// Adds the settings of a check as a whole, as they apply if it is started in the folder of the program.
fn whole_check(rows: &mut Rows, configuration: Option<&Configuration>) {
    let keys = configuration.map(|configuration| &configuration.keys);
    match keys.and_then(|keys| keys.language.as_ref()) {
        Some(located) => rows.add_located("language", located.value.tag(), located),
        None => rows.add_default("language", "en"),
    }
    let lists = [
        ("extension", keys.map(|keys| &keys.extension)),
        ("exclude", keys.map(|keys| &keys.exclude)),
        ("library", keys.map(|keys| &keys.library)),
    ];
    for (key, list) in lists {
        list.into_iter().flatten().for_each(|located| rows.add_located(key, &located.value, located));
    }
    if let Some(located) = keys.and_then(|keys| keys.baseline.as_ref()) {
        rows.add_located("baseline", &located.value, located);
    }
    if let Some(located) = keys.and_then(|keys| keys.max_warnings.as_ref()) {
        rows.add_located("max-warnings", &located.value.to_string(), located);
    }
    if let Some(located) = keys.and_then(|keys| keys.rules_url.as_ref()) {
        rows.add_located("rules-url", &located.value, located);
    }
}

/// The rows, and the file that their line numbers refer to.
struct Rows {
    list: Vec<Row>,
    file: Option<String>,
}

impl Rows {
    fn add_located<T>(&mut self, key: &str, value: &str, located: &Located<T>) {
        let file = self.file.clone().unwrap_or_default();
        self.add(key, value, &format!("{file}:{}", located.line));
    }

    fn add(&mut self, key: &str, value: &str, from: &str) {
        self.list.push(Row { key: key.to_owned(), value: value.to_owned(), from: Some(from.to_owned()) });
    }

    fn add_default(&mut self, key: &str, value: &str) {
        self.list.push(Row { key: key.to_owned(), value: value.to_owned(), from: None });
    }
}
