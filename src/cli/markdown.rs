//! Text for Markdown that this program writes.
//!
//! In: plain text, or text with program code in backticks. Out: the same text in Markdown.

/// Escapes a text of one line, so that Markdown shows it as it is.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '|' | '\\' | '*' | '_' | '[' | ']' | '`' | '#' => {
                escaped.push('\\');
                escaped.push(letter);
            }
            '<' => escaped.push_str("&lt;"),
            '&' => escaped.push_str("&amp;"),
            letter if letter.is_control() => escaped.push(' '),
            letter => escaped.push(letter),
        }
    }
    escaped
}

/// Escapes a text in which backticks enclose program code; the code stays as it is.
pub(super) fn with_code(text: &str) -> String {
    let pieces = text.split('`').enumerate();
    pieces.map(|(at, piece)| if at % 2 == 0 { escaped(piece) } else { format!("`{piece}`") }).collect()
}

/// A block of code in a language; the code contains no fence.
pub(super) fn block(language: &str, code: &str) -> String {
    format!("```{language}\n{}\n```\n", code.trim_end())
}

#[cfg(test)]
mod tests {
    use super::{escaped, with_code};

    #[test]
    fn signs_of_markdown_are_shown() {
        assert_eq!(escaped("#1=[2*3] <a> a_b|c&`\t"), "\\#1=\\[2\\*3\\] &lt;a> a\\_b\\|c&amp;\\` ");
        assert_eq!(with_code("#1 or `#1*2` or *"), "\\#1 or `#1*2` or \\*");
    }
}
