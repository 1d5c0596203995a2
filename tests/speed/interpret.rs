//! Benchmarks text to motions and messages, natively: `cargo bench`. The same programs in wasm:
//! `cargo xtask bench`.

mod workload;

use divan::Bencher;
use divan::counter::BytesCount;
use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::setup::Setup;

fn main() {
    divan::main();
}

fn run(bencher: Bencher, text: String) {
    let setup = Setup::default();
    bencher.counter(BytesCount::new(text.len())).bench(|| analyze(text.as_bytes(), &setup).motions.len());
}

#[divan::bench(sample_count = 10)]
fn a_million_plain_lines(bencher: Bencher) {
    run(bencher, workload::plain(1_000_000));
}

#[divan::bench]
fn a_shaft_of_sixty_lines(bencher: Bencher) {
    run(bencher, workload::shaft());
}

#[divan::bench]
fn ten_thousand_box_cycles(bencher: Bencher) {
    run(bencher, workload::boxes(10_000));
}

#[divan::bench]
fn loops_and_calls(bencher: Bencher) {
    run(bencher, workload::rounds(3_000));
}

#[divan::bench(args = workload::PASSES)]
fn part_of_roughing_passes(bencher: Bencher, passes: u32) {
    let analysis = analyze(workload::passes(passes).as_bytes(), &Setup::default());
    bencher.bench(|| SimulationResult::of(&analysis.motions, &analysis.setup).finished());
}

#[divan::bench(args = workload::POINTS)]
fn roughing_along_points(bencher: Bencher, points: u32) {
    run(bencher, workload::contour(points));
}
