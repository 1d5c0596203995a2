//! Names of programs: `<SHAFT-1>` (FANUC 30i, 0i-F).
//!
//! In: text. Out: the name that begins at a byte, and its number. The number is above all O numbers, so that
//! names are looked up and called like numbers. Must not know calls.

/// Most characters of a name (B-64484EN, program name).
const LENGTH: usize = 32;

/// The least number of a name; O numbers have at most eight digits.
const FIRST: u32 = 1 << 30;

/// Whether a program number belongs to a name.
pub fn is_name(number: u32) -> bool {
    number >= FIRST
}

/// The number of the name whose `<` is at byte `at`, and the end of its `>`; `None` if there is no name.
pub fn read(text: &[u8], at: usize) -> Option<(u32, usize)> {
    let rest = text.get(at..)?.strip_prefix(b"<")?;
    let length = rest.iter().take(LENGTH + 1).position(|&byte| byte == b'>')?;
    let may_be = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'+' | b'-' | b'_' | b'.' | b' ');
    let name = Some(&rest[..length]).filter(|name| name.iter().all(may_be))?.trim_ascii();
    (!name.is_empty()).then(|| (number(name), at + length + 2))
}

/// FNV-1a hash of the name in capitals, in 30 bits.
fn number(name: &[u8]) -> u32 {
    let hash = name.iter().fold(0x811C_9DC5_u32, |hash, byte| {
        (hash ^ u32::from(byte.to_ascii_uppercase())).wrapping_mul(0x0100_0193)
    });
    FIRST | (hash ^ hash >> 30) & (FIRST - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_in_angle_brackets() {
        let read = |text: &str| read(text.as_bytes(), 0).map(|(number, end)| (is_name(number), end));
        assert_eq!(read("<SHAFT-1>"), Some((true, 9)));
        assert_eq!(read("<finishing pass> L2"), Some((true, 16)));
        for other in ["<>", "< >", "<A", "<A\n>", "<A*B>", "A", "", &format!("<{}>", "A".repeat(33))] {
            assert_eq!(read(other), None, "{other}");
        }
        assert_eq!(super::read(b"<sub_1>", 0), super::read(b"<SUB_1>", 0));
        assert_ne!(super::read(b"<SUB1>", 0), super::read(b"<SUB2>", 0));
        // The page computes the same number (`switches-in-text.ts`).
        assert_eq!(super::read(b"<SHAFT-1>", 0), Some((1_254_805_063, 9)));
    }
}
