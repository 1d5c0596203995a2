//! The part that a program makes.

use gcode_playground::analyze;
use gcode_playground::control::setup::Setup;
use gcode_playground::shop::Shop;
use gcode_playground::shop::region::Region;

fn shop(program: &str, setup: &str) -> Shop {
    let setup = Setup::from_json(setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    let mut shop = Shop::new(&analysis.motions, &setup);
    while !shop.advance(&analysis.motions, 1000) {}
    shop
}

fn part(program: &str, setup: &str) -> Region {
    shop(program, setup).finished().expect("a blank")
}

fn folder(name: &str) -> (String, String) {
    let read = |file: &str| std::fs::read_to_string(format!("tests/programs/{name}/{file}")).expect("a file");
    (read("program.nc"), read("setup.json"))
}

fn check_diameters(part: &Region, z: f64, expected: &[(f64, f64)]) {
    let found: Vec<_> = part.radii(z).into_iter().map(|(low, high)| (2.0 * low, 2.0 * high)).collect();
    let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 0.005 && (a.1 - b.1).abs() < 0.005;
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(near), "Z{z}: {found:?}, not {expected:?}");
}

/// Seed 001, case 6.3, with sharp tools. Outside, N240 goes from X45.4 Z3 to X50 Z-20: at Z-10 it is at
/// 45.4 + 4.6 × 13 / 23 = 48. Inside, N320 goes from X31 Z3 to X20 Z-30: at Z-10 it is at 31 − 11 × 13 / 33 = 26.667.
#[test]
fn o6003_has_the_diameters_of_its_drawing() {
    let (program, setup) = folder("s001-o6003");
    let part = part(&program, &setup);
    check_diameters(&part, -10.0, &[(26.667, 48.0)]);
    check_diameters(&part, -25.0, &[(31.0 - 11.0 * 28.0 / 33.0, 60.0)]);
    check_diameters(&part, -35.0, &[(20.0, 60.0)]);
}
