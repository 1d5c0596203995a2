//! Programs to measure with: the same bytes on every machine, from a small seeded generator in whole
//! micrometres.

use std::fmt::Write;

/// A Weyl sequence with an integer mix.
struct Random(u32);

impl Random {
    /// A number in `0..below`.
    fn next(&mut self, below: u32) -> i64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9);
        let mut mixed = (self.0 ^ self.0 >> 16).wrapping_mul(0x21F0_AAAD);
        mixed = (mixed ^ mixed >> 15).wrapping_mul(0x735A_2D97);
        mixed ^= mixed >> 15;
        ((u64::from(mixed) * u64::from(below)) >> 32) as i64
    }
}

/// A walk of `lines` lines of G0, G1, G2 and G3 as a turning program has them: one move in ten modal, an F word
/// on three in a hundred, arcs by R.
pub fn plain(lines: usize) -> String {
    let mut random = Random(1);
    let mut text =
        String::from("G18 G21 G40 G98\nG97 S1000 M3\nG0 X100.000 Z-99.000\nG1 X100.000 Z-100.000 F200\n");
    let (mut x, mut z) = (100_000i64, -100_000i64);
    let mut modal_line = true;
    let mut written = 6;
    while written < lines {
        let kind = random.next(1000);
        let span = if kind < 40 { 5_000 } else { 500 };
        let (dx, dz) =
            (random.next(2 * span + 1) - i64::from(span), random.next(2 * span + 1) - i64::from(span));
        let (next_x, next_z) = ((x + dx).clamp(10_000, 200_000), (z + dz).clamp(-600_000, -10_000));
        let place = format!("X{} Z{}", mm(next_x), mm(next_z));
        match kind {
            0..40 => {
                let _ = writeln!(text, "G0 {place}");
                modal_line = false;
            }
            40..120 => {
                let chord = ((next_x - x) as f64).hypot((next_z - z) as f64);
                if chord < 50.0 {
                    continue;
                }
                let radius = (chord * 0.6) as i64 + 50 + random.next(5_000);
                let _ = writeln!(text, "{} {place} R{}", if kind < 80 { "G2" } else { "G3" }, mm(radius));
                modal_line = false;
            }
            _ => {
                let code = if modal_line && random.next(10) == 0 { "" } else { "G1 " };
                let feed = if random.next(100) < 3 {
                    format!(" F{}", 100 + 10 * random.next(30))
                } else {
                    String::new()
                };
                let _ = writeln!(text, "{code}{place}{feed}");
                modal_line = true;
            }
        }
        (x, z) = (next_x, next_z);
        written += 1;
    }
    text.push_str("M5\nM30\n");
    text
}

/// A shaft of 60 lines with facing, roughing passes by G90, a taper, an arc and a thread, as a class writes it.
pub fn shaft() -> String {
    let mut text = String::from(
        "%\nO0301 (SHAFT)\nG21 G40 G97 G99\nG28 U0 W0\nT0101\nG50 S2500\nG96 S180 M3\nG0 X64.0 Z5.0 M8\n\
         G94 X-1.6 Z1.0 F0.2\nZ0.5\nZ0\nG0 X62.0 Z2.0\nG90 X58.0 Z-80.0 F0.25\n",
    );
    for step in 1..18 {
        let _ = writeln!(text, "X{}.0 Z-{}.5", 58 - 2 * step, 80 - 3 * step);
    }
    text.push_str(
        "G0 X62.0 Z2.0\nG90 X30.0 Z-20.0 R-5.0\nX26.0\nX22.0\nG0 X150.0 Z100.0 M9\nT0202\nG96 S220 M3\nG0 X18.0 Z2.0\n\
         G1 Z0.0 F0.12\nX20.0 Z-1.0\nZ-20.0\nX24.0\nG3 X28.0 Z-22.0 R2.0\nG1 Z-35.0\nX36.0 Z-45.0\nZ-60.0\n\
         G2 X44.0 Z-64.0 R4.0\nG1 X50.0\nX54.0 Z-66.0\nG0 X150.0 Z100.0\nT0505\nG97 S700 M3\nG0 X24.0 Z4.0\n\
         G92 X19.2 Z-15.0 F2.0\nX18.6\nX18.2\nX17.9\nX17.6\nG0 X150.0 Z100.0\nM5\nM30\n%\n",
    );
    text
}

/// Micrometres as a number with three decimals.
fn mm(micrometres: i64) -> String {
    let sign = if micrometres < 0 { "-" } else { "" };
    format!("{sign}{}.{:03}", micrometres.abs() / 1000, micrometres.abs() % 1000)
}
