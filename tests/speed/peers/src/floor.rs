//! The floor: the minimum work of a program that converts text to motions. It parses the decimals and stores
//! a row for each line that moves. No messages, no cycles, no checks.

/// A straight move or an arc.
pub struct Segment {
    /// 0 to 3, for G0 to G3.
    pub motion: u8,
    /// Line of the text, from 0.
    pub line: u32,
    /// X as written.
    pub x: f64,
    /// Z as written.
    pub z: f64,
    /// R as written; 0 if absent.
    pub radius: f64,
    /// F in force.
    pub feed: f64,
}

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 16] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// The segments of a plain program.
pub fn segments(text: &[u8]) -> Vec<Segment> {
    let mut found = Vec::new();
    let (mut motion, mut line, mut moved) = (0, 0, false);
    let (mut x, mut z, mut radius, mut feed) = (0.0, 0.0, 0.0, 0.0);
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        at += 1;
        match byte {
            b'\n' => {
                if std::mem::take(&mut moved) {
                    found.push(Segment { motion, line, x, z, radius: std::mem::take(&mut radius), feed });
                }
                line += 1;
            }
            b'(' => at += text[at..].iter().take_while(|&&byte| byte != b')' && byte != b'\n').count(),
            b'A'..=b'Z' => {
                let value = decimal(text, &mut at);
                match byte {
                    b'X' => (x, moved) = (value, true),
                    b'Z' => (z, moved) = (value, true),
                    b'R' => radius = value,
                    b'F' => feed = value,
                    b'G' if value < 4.0 => motion = value as u8,
                    _ => {}
                }
            }
            _ => {}
        }
    }
    found
}

/// Parses the number at `at`, correctly rounded: one division of two exact numbers.
#[inline]
fn decimal(text: &[u8], at: &mut usize) -> f64 {
    let negative = text.get(*at) == Some(&b'-');
    *at += usize::from(negative);
    let mut digits = 0u64;
    let mut whole = |at: &mut usize| {
        let first = *at;
        while let Some(digit) = text.get(*at).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10)
        {
            digits = digits * 10 + u64::from(digit);
            *at += 1;
        }
        *at - first
    };
    whole(at);
    let mut decimals = 0;
    if text.get(*at) == Some(&b'.') {
        *at += 1;
        decimals = whole(at);
    }
    let value = digits as f64 / POWERS[decimals.min(15)];
    if negative { -value } else { value }
}
