//! `schema`: prints the JSON Schema of a setup or of a configuration, for editors and for other programs.
//!
//! In: the kind of file. Out: its schema (draft 2020-12), made from the types and the table that read such a
//! file. Names of rules and severities have one spelling in the schema, and any case in a file.

use clap::ValueEnum;
use serde_json::Value;

use super::configuration::keys;
use crate::setup::Setup;

/// A kind of file with a schema.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum SchemaOf {
    /// A setup: blank, tools, machine, control.
    Setup,
    /// A configuration, `gcode-playground.toml`.
    Config,
}

/// The JSON Schema of a kind of file.
pub(super) fn schema(of: SchemaOf) -> Value {
    match of {
        SchemaOf::Setup => schemars::schema_for!(Setup).to_value(),
        SchemaOf::Config => keys::schema(),
    }
}
