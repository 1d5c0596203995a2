//! Comments that hide messages are read, also after edits, and messages are hidden by line and rule.

use super::*;
use crate::message::said;

/// The line, the word and the rule of each entry.
fn read(text: &str) -> Vec<(&str, &str, Option<&'static str>)> {
    let quoted = |span: Span| &text[span.start as usize..span.end as usize];
    let comments = IgnoreComments::read(text.as_bytes());
    comments.entries.iter().map(|entry| (quoted(entry.line), quoted(entry.word), entry.rule())).collect()
}

#[test]
fn a_comment_names_rules_and_groups() {
    let rule = "RULE=UNKNOWN-M-CODE";
    for line in [
        "M99 (IGNORE RULE=UNKNOWN-M-CODE)",
        "M99 (  IGNORE   RULE=UNKNOWN-M-CODE )",
        "(IGNORE RULE=UNKNOWN-M-CODE",
        "(REMARK) M99 ((IGNORE RULE=UNKNOWN-M-CODE(X)",
    ] {
        for text in [line.to_owned(), format!("O1\r{line}\r\nM30\n")] {
            assert_eq!(read(&text), [(line, rule, Some("unknown-m-code"))], "{text:?}");
        }
    }
    let text = "M99 (ignore rule=no-program-end Rule=Classroom)";
    assert_eq!(
        read(text),
        [(text, "rule=no-program-end", Some("no-program-end")), (text, "Rule=Classroom", Some("classroom"))]
    );
}

#[test]
fn prose_is_prose_and_a_slip_is_told() {
    for prose in [
        "(IGNORE)",
        "(IGNORE THE OFFSET X=5)",
        "(IGNORED RULE=NO-PROGRAM-END)",
        "[IGNORE RULE=NO-PROGRAM-END]",
        "IGNORE RULE=NO-PROGRAM-END",
        "(IGNORE\nRULE=NO-PROGRAM-END)",
        "(NOT: IGNORE RULE=NO-PROGRAM-END)",
    ] {
        assert_eq!(read(prose), [], "{prose}");
    }
    for (text, slip, expected) in [
        ("(IGNORE RULE=NO-PROGRAM-ENDS)", "RULE=NO-PROGRAM-ENDS", "RULE=NO-PROGRAM-END"),
        ("(IGNORE NO-PROGRAM-END)", "NO-PROGRAM-END", "RULE=NO-PROGRAM-END"),
        ("(IGNORE RULES=NO-PROGRAM-END)", "RULES=NO-PROGRAM-END", "RULE=NO-PROGRAM-END"),
        ("(IGNORE RULE=QQQ)", "RULE=QQQ", "RULE=NO-PROGRAM-END"),
    ] {
        let told: Vec<_> = IgnoreComments::read(text.as_bytes())
            .entries
            .iter()
            .filter_map(|entry| entry.unreadable(text.as_bytes()))
            .collect();
        let [told] = &told[..] else { panic!("{text}: {told:?}") };
        assert_eq!(told.span.of(text.as_bytes()), slip.as_bytes());
        let expected = said::NoteWord { word: slip.to_owned(), expected: expected.to_owned() };
        assert_eq!(told.message, expected.into(), "{text}");
        // Without a similar rule nothing can be suggested.
        let fixed: Vec<_> = told.fixes.iter().map(|fix| fix.edits[0].text.as_str()).collect();
        assert_eq!(fixed.is_empty(), slip == "RULE=QQQ", "{text}");
        assert!(fixed.iter().all(|text| *text == "RULE=NO-PROGRAM-END"), "{fixed:?}");
    }
}

#[test]
fn a_line_names_a_limited_number_of_rules() {
    let text = format!("M99 (IGNORE{})", " RULE=NO-PROGRAM-END".repeat(WORDS_PER_BLOCK + 10));
    let entries = IgnoreComments::read(text.as_bytes()).entries;
    assert_eq!(entries.len(), WORDS_PER_BLOCK + 1);
    let told: Vec<_> = entries.iter().filter_map(|entry| entry.unreadable(text.as_bytes())).collect();
    let [told] = &told[..] else { panic!("{told:?}") };
    let expected = "at most 64 rules in a line".to_owned();
    assert_eq!(told.message, said::NoteWord { word: "RULE=NO-PROGRAM-END".into(), expected }.into());
    let many = format!("M99{}", " (IGNORE RULE=NO-PROGRAM-END)".repeat(WORDS_PER_BLOCK + 10));
    assert_eq!(IgnoreComments::read(many.as_bytes()).entries.len(), WORDS_PER_BLOCK + 1);
}

#[test]
fn an_entry_is_deleted_with_its_comment_if_it_is_alone() {
    let removed = |text: &str| -> Vec<String> {
        let entries = IgnoreComments::read(text.as_bytes()).entries;
        entries.iter().map(|entry| entry.removed.quote(text.as_bytes())).collect()
    };
    assert_eq!(removed("M99 \t(IGNORE RULE=CLASSROOM )X1"), [" \t(IGNORE RULE=CLASSROOM )"]);
    assert_eq!(removed("M99 (IGNORE RULE=CLASSROOM"), [" (IGNORE RULE=CLASSROOM"]);
    assert_eq!(removed("(IGNORE RULE=CLASSROOM RULE=COOLANT-OFF)"), [" RULE=CLASSROOM", " RULE=COOLANT-OFF"]);
}

/// The slugs and lines of the messages that remain, of messages at some bytes.
fn left(text: &str, told: &[usize]) -> Vec<usize> {
    let comments = IgnoreComments::read(text.as_bytes());
    let messages = told.iter().map(|&at| Diagnostic::new(said::NoEnd, Span::new(at, at)));
    let mut messages: Vec<_> = messages.collect();
    comments.hide(&mut messages);
    messages.iter().map(|told| told.span.start as usize).collect()
}

#[test]
fn messages_are_hidden_from_the_start_to_the_end_of_a_line() {
    let text = "G0\nG1 (IGNORE RULE=NO-PROGRAM-END)\nG2";
    let end = text.len() - 3;
    assert_eq!(&text[end..], "\nG2");
    assert_eq!(left(text, &[2, 3, 10, end, end + 1]), [2, end + 1]);
    let other = "G1 (IGNORE RULE=UNKNOWN-M-CODE)";
    assert_eq!(left(other, &[0, 5]), [0, 5]);
}

/// After any edit, the comments belong to the new text.
#[test]
fn an_edit_gives_the_comments_of_the_new_text() {
    const PIECES: [&str; 8] =
        ["\n", "\r", "(IGNORE RULE=CLASSROOM)", "IGNORE", "(", ")", " RULE=NO-PROGRAM-END", "M99 "];
    let mut seed = 7u32;
    let mut below = |most: usize| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as usize % most
    };
    for _ in 0..300 {
        let mut text = "O1\nM99 (IGNORE RULE=CLASSROOM)\nM30\n(IGNORE RULE=NO-PROGRAM-END)\n".to_owned();
        let mut comments = IgnoreComments::read(text.as_bytes());
        for _ in 0..40 {
            let start = below(text.len() + 1);
            let end = (start + below(12)).min(text.len());
            let insert = PIECES[below(PIECES.len())];
            text.replace_range(start..end, insert);
            comments.edit(text.as_bytes(), &(start..end), insert.len());
            assert_eq!(comments, IgnoreComments::read(text.as_bytes()), "{text:?}");
        }
    }
}
