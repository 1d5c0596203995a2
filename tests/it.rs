//! The integration tests, one module per subject: `cargo test --test it`, and `cargo test --test it codes::`
//! for one of them.
//!
//! One binary instead of fifty: it is linked once, and its tests keep all processors busy.
#![cfg(not(target_arch = "wasm32"))]

#[path = "mutations/blocks.rs"]
mod blocks;
#[path = "rooms/circle.rs"]
mod circle;
#[path = "mutations/classes.rs"]
mod classes;
mod fixtures;
#[path = "fixtures/folder.rs"]
mod folder;
#[path = "../src/rules/format/mod.rs"]
mod format;
#[path = "documentation/markdown.rs"]
mod markdown;
#[path = "fixtures/project.rs"]
mod project;
#[path = "fixtures/ran.rs"]
mod ran;
mod random_programs;
#[path = "mutations/text.rs"]
mod text;
#[path = "fixtures/texts.rs"]
mod texts;

mod assist;
mod calculators;
mod check;
mod cli;
mod codes;
mod compare;
mod control;
mod convert;
mod current;
mod cycles;
mod difference;
mod documentation;
mod editors;
mod element;
mod exercise;
mod expand;
mod export;
mod figures;
mod files;
mod fixes;
mod formatting;
mod glossary;
mod golden;
mod grade;
mod ignored;
mod library;
mod line_ends;
mod lints;
mod machine;
mod manual_pages;
mod manuals;
mod messages;
mod mutations;
mod outline;
mod packaging;
#[path = "parts/main.rs"]
mod parts;
mod paste;
mod peers;
mod precision;
mod programs;
mod programs_and_macros;
mod properties;
mod real_programs;
mod reference_pages;
mod renumber;
mod repair;
mod reports;
mod rewrite;
mod rooms;
mod rooms_of_the_page;
mod rule_changes;
mod rule_pages;
mod schemas;
mod seed_statements;
mod server;
mod setup;
mod spelling;
mod style_sheets;
mod teams;
mod timing;
mod uncertain;
mod unread_words;
mod worked_controls;
mod worked_cuts;
mod worked_frames;
mod worked_inference;
mod worked_live_rapids;
mod worked_offsets;
mod worked_pictures;
mod worked_planes;
mod worked_reading;
mod worked_threads;
mod worked_words;
mod worked_y_axis;
