//! One native run: `native NAME FILE` prints milliseconds and rows as JSON.

use std::time::Instant;
use std::{env, fs};

fn main() -> Result<(), String> {
    let [name, file] = [1, 2].map(|index| env::args().nth(index).unwrap_or_default());
    let text = fs::read(&file).map_err(|error| format!("{file}: {error}"))?;
    let begun = Instant::now();
    let outcome = bench_peers::run(&name, text).ok_or_else(|| format!("{name} is not known here"))?;
    println!("{{\"ms\": {}, \"rows\": {}}}", begun.elapsed().as_secs_f64() * 1e3, outcome.rows);
    Ok(())
}
