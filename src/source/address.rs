//! Texts in the addresses of the playground.
//!
//! In: a text. Out: the text as a value in the fragment of a URL.

/// Percent-encodes a text: only letters, digits, `-`, `.`, `_` and `~` stay as they are.
pub fn percent_encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(2 * text.len());
    for byte in text.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' => encoded.push(byte.into()),
            _ => encoded += &format!("%{byte:02X}"),
        }
    }
    encoded
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_program_is_encoded() {
        assert_eq!(super::percent_encoded("G1 X-5.\n(Ø)"), "G1%20X-5.%0A%28%C3%98%29");
    }
}
