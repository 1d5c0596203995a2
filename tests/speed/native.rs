//! One native run of the playground: `native FILE` prints milliseconds and motions as JSON. Part of
//! `cargo xtask bench`.

use std::time::Instant;
use std::{env, fs};

use gcode_playground::run::Run;
use gcode_playground::setup::Setup;

fn main() -> Result<(), String> {
    let file = env::args().nth(1).unwrap_or_default();
    let text = fs::read(&file).map_err(|error| format!("{file}: {error}"))?;
    let begun = Instant::now();
    let mut run = Run::new(text, Setup::default());
    while !run.advance(usize::MAX) {}
    let ms = begun.elapsed().as_secs_f64() * 1e3;
    println!("{{\"ms\": {ms}, \"rows\": {}}}", run.motions().len());
    Ok(())
}
