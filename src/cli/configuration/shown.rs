//! `config`: prints the settings of a program, each with its source.
//!
//! In: the name of a program, options. Out: text, or JSON with one row for each key.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::super::options::{Form, Format, With};
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
    with: With,
    #[command(flatten)]
    form: Form,
}

/// Runs `config`.
pub(in crate::cli) fn run(asked: &Config) -> Result<Status, String> {
    let file = asked.file.as_deref().unwrap_or(Path::new("program"));
    let settings = Configurations::new(&asked.with)?.settings(file)?;
    let rows = rows(&settings, &asked.with);
    print(|out| write(out, &settings, &rows, asked.form.format))?;
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

/// The settings, one row for each key.
fn rows(settings: &Settings, with: &With) -> Vec<Row> {
    let mut rows =
        Rows { list: Vec::new(), file: settings.configuration.as_deref().map(|one| one.name.clone()) };
    let said = |name: fn(&Values) -> Option<&Located<Control>>| settings.values().filter_map(name).last();
    match (&with.control, said(|values| values.control.as_ref())) {
        (Some(name), _) => rows.by("control", name.control().name(), "--control"),
        (None, Some(said)) => rows.said("control", said.value.name(), said),
        (None, None) => match control_of_setups(settings) {
            Some((name, file)) => rows.by("control", &name, &file),
            None => rows.usual("control", "fanuc, if the program says nothing else"),
        },
    }
    for said in settings.values().flat_map(|values| &values.setup) {
        rows.said("setup", &said.value, said);
    }
    for path in &with.setup {
        rows.by("setup", &shown(path), "--setup");
    }
    if settings.setups.is_empty() {
        rows.usual("setup", "none");
    }
    for said in settings.values().flat_map(|values| &values.rules) {
        let (name, level): (&str, Severity) = said.value;
        rows.said(&format!("rules.{name}"), level.name(), said);
    }
    let select = settings.values().filter(|values| !values.select.is_empty()).last();
    for said in select.into_iter().flat_map(|values| &values.select) {
        rows.said("select", said.value, said);
    }
    if select.is_none() {
        rows.usual("select", "all rules");
    }
    for said in settings.values().flat_map(|values| &values.ignore) {
        rows.said("ignore", said.value, said);
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

/// Rows for the settings of a whole check started in the folder.
fn whole_check(rows: &mut Rows, configuration: Option<&Configuration>) {
    let keys = configuration.map(|one| &one.keys);
    match keys.and_then(|keys| keys.language.as_ref()) {
        Some(said) => rows.said("language", said.value.tag(), said),
        None => rows.usual("language", "en"),
    }
    let lists = [
        ("extension", keys.map(|keys| &keys.extension)),
        ("exclude", keys.map(|keys| &keys.exclude)),
        ("library", keys.map(|keys| &keys.library)),
    ];
    for (key, list) in lists {
        list.into_iter().flatten().for_each(|said| rows.said(key, &said.value, said));
    }
    if let Some(said) = keys.and_then(|keys| keys.baseline.as_ref()) {
        rows.said("baseline", &said.value, said);
    }
    if let Some(said) = keys.and_then(|keys| keys.max_warnings.as_ref()) {
        rows.said("max-warnings", &said.value.to_string(), said);
    }
}

/// The rows, and the file that their line numbers refer to.
struct Rows {
    list: Vec<Row>,
    file: Option<String>,
}

impl Rows {
    fn said<T>(&mut self, key: &str, value: &str, said: &Located<T>) {
        let file = self.file.clone().unwrap_or_default();
        self.by(key, value, &format!("{file}:{}", said.line));
    }

    fn by(&mut self, key: &str, value: &str, from: &str) {
        self.list.push(Row { key: key.to_owned(), value: value.to_owned(), from: Some(from.to_owned()) });
    }

    fn usual(&mut self, key: &str, value: &str) {
        self.list.push(Row { key: key.to_owned(), value: value.to_owned(), from: None });
    }
}
