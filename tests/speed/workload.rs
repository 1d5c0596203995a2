//! Programs for measurements: the same bytes on every machine, from a small seeded generator in whole
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

/// A random path of `lines` lines of G0, G1, G2 and G3, as in a turning program: one move in ten is modal,
/// three in a hundred have an F word, arcs use R.
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

/// A shaft of some sixty lines as written in a class: facing, G71 and G70, a groove by G75, a bore by G74, a
/// thread by G76.
pub fn shaft() -> String {
    String::from(include_str!("shaft.nc"))
}

/// `count` G90 cycles; each is one modal line.
pub fn boxes(count: u32) -> String {
    let mut text = String::from("G21 G40 G97 G99\nS900 M3\nG0 X102. Z2. M8\nG90 X100. Z-50. F.2\n");
    for index in 1..count {
        let _ = writeln!(
            text,
            "X{}.{} Z-{}.{}",
            99 - index / 10 % 80,
            index % 10,
            10 + index % 90,
            index / 90 % 10
        );
    }
    text.push_str("G0 X150. Z100. M9\nM5\nM30\n");
    text
}

/// `lines` lines; all but some of them are in a loop of twenty rounds that calls, five times per round, a
/// program as long as its body.
pub fn rounds(lines: u32) -> String {
    let moves = |text: &mut String, first: u32| {
        for index in first..first + lines / 2 {
            let _ = writeln!(text, "G1 X[{}+#1] Z-{}", 20 + index % 70, index % 90);
        }
    };
    let mut text =
        String::from("O1\nG21 G40 G97 G99\nS900 M3\nG0 X102. Z2.\nG1 F.2\n#1=0\nWHILE[#1LT20]DO1\n");
    moves(&mut text, 0);
    text.push_str("M98 P50002\n#1=#1+1\nEND1\nG0 X150. Z100.\nM30\nO2\n");
    moves(&mut text, 1);
    text.push_str("M99\n");
    text
}

/// Contour sizes to measure.
pub const POINTS: [u32; 6] = [100, 300, 1_000, 2_000, 3_000, 10_000];

/// G71 by 0.1 mm and G70 along a contour of `points` points, which rises from a diameter of 20 to 60 mm in
/// waves: G71 cuts their hollows too.
pub fn contour(points: u32) -> String {
    let mut text = String::from(
        "G21 G40 G97 G99\nS900 M3\nG0 X70. Z2. M8\nG71 U.1 R.1\nG71 P10 Q20 U.2 W.05 F.2\nN10 G0 X20. Z1.\n",
    );
    for index in 1..=points {
        let share = f64::from(index) / f64::from(points);
        let wave = 0.4 * (f64::from(index) * 0.2).sin();
        let x = (20_000.0 + 40_000.0 * share + 1_000.0 * wave) as i64;
        let _ = writeln!(text, "G1 X{} Z{}", mm(x), mm(-20 * i64::from(index)));
    }
    text.push_str("N20 X70.\nG70 P10 Q20\nG0 X150. Z100. M9\nM5\nM30\n");
    text
}

/// Numbers of roughing passes for which the part is measured.
pub const PASSES: [u32; 5] = [10, 20, 40, 80, 160];

/// G71 in `count` passes and G70, from a bar of 60 mm to a contour with a taper and two fillets.
pub fn passes(count: u32) -> String {
    let depth = mm(20_000 / i64::from(count));
    format!(
        "(STOCK D=60 LENGTH=100)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\nT0101\nG21 G40 G97 G99\nS900 M3\nG0 X62. Z2. M8\n\
         G71 U{depth} R.1\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X20.\nG1 Z-20. F.1\nG2 X30. Z-25. R5.\nG1 X40. Z-50.\nZ-60.\n\
         G2 X50. Z-65. R5.\nG1 Z-80.\nN20 X62.\nG70 P10 Q20\nG0 X150. Z100. M9\nM5\nM30\n"
    )
}

/// Micrometres as a number with three decimals.
fn mm(micrometres: i64) -> String {
    let sign = if micrometres < 0 { "-" } else { "" };
    format!("{sign}{}.{:03}", micrometres.abs() / 1000, micrometres.abs() % 1000)
}
