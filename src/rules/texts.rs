//! The texts other than messages, from `src/sentences/<language>.txt`.
//!
//! In: the files of all languages. Out: each text with its enum and variant, or all errors with file and
//! line. A line is `Enum.Variant: text`; `#` begins a comment. Shared by the build script and `cargo xtask`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::format::{LANGUAGES, RuleFile};

/// A text in all languages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// The name of the enum in Rust.
    pub kind: String,
    /// The name of the variant in Rust.
    pub variant: String,
    /// The text in the order of `LANGUAGES`; English if a language has none.
    pub said: [String; 3],
}

/// The texts, in the order of the English file.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    /// All texts.
    pub list: Vec<Text>,
    /// Texts that are missing in a language.
    pub missing: Vec<String>,
    /// Errors, each with its file and line.
    pub mistakes: Vec<String>,
}

impl Texts {
    /// Reads the text files of a project.
    pub fn read(project: &str) -> Self {
        let file = |tag: &str| {
            let path = Path::new(project).join("src/sentences").join(format!("{tag}.txt"));
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        };
        Self::of(&LANGUAGES.map(file))
    }

    /// Parses the texts of all languages, in the order of `LANGUAGES`.
    pub fn of(files: &[String; 3]) -> Self {
        let mut texts = Self::default();
        let mut places = BTreeMap::new();
        for (language, file) in files.iter().enumerate() {
            let name = format!("src/sentences/{}.txt", LANGUAGES[language]);
            let mut seen = vec![false; texts.list.len()];
            for (index, line) in file.lines().enumerate() {
                if line.is_empty() || line.starts_with('#') {
                    continue;
                }
                let mut wrong = |what: &str| texts.mistakes.push(format!("{name}:{}: {what}", index + 1));
                let Some((key, said)) = line.split_once(':') else {
                    wrong("this is no `Enum.Variant: text`");
                    continue;
                };
                let said = said.strip_prefix(' ').unwrap_or(said).to_owned();
                match places.get(key).copied() {
                    None if language == 0 => {
                        let Some((kind, variant)) = key.split_once('.') else {
                            wrong("this is no `Enum.Variant: text`");
                            continue;
                        };
                        places.insert(key.to_owned(), texts.list.len());
                        let (kind, variant) = (kind.to_owned(), variant.to_owned());
                        texts.list.push(Text { kind, variant, said: [said.clone(), said.clone(), said] });
                    }
                    None => wrong("not in the English file"),
                    Some(_) if language == 0 => wrong("a second text"),
                    Some(place) if seen[place] => wrong("a second text"),
                    Some(place) => {
                        seen[place] = true;
                        texts.list[place].said[language] = said;
                    }
                }
            }
            if language > 0 {
                let missing = texts.list.iter().zip(seen).filter(|(_, seen)| !seen);
                texts
                    .missing
                    .extend(missing.map(|(text, _)| format!("{name}: {}.{}", text.kind, text.variant)));
            }
        }
        texts
    }
}

/// A hash of all messages, their arguments and the variants, in order. Two lists fit the same module if it is
/// equal.
pub fn order(rules: &[RuleFile], texts: &Texts) -> String {
    let messages = rules.iter().flat_map(|rule| &rule.messages);
    let messages = messages.flat_map(|message| {
        let arguments = message.arguments.iter().map(|argument| argument.name.as_str());
        std::iter::once(message.name.as_str()).chain(arguments)
    });
    let keys = texts.list.iter().flat_map(|text| [text.kind.as_str(), text.variant.as_str()]);
    // FNV-1a: the build script and xtask may be built by different compilers.
    let bytes = messages.chain(keys).flat_map(|name| name.bytes().chain(*b"\n"));
    let hash = bytes
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    format!("{hash:016x}")
}

/// All texts of a language, one per line: the hash of their order; then each message with its help after a
/// tab; then the other texts.
pub fn list(language: usize, rules: &[RuleFile], texts: &Texts) -> String {
    let mut out = order(rules, texts) + "\n";
    for message in rules.iter().flat_map(|rule| &rule.messages) {
        let said = &message.sentences[language];
        out += &said.message;
        if let Some(help) = &said.help {
            out.push('\t');
            out += help;
        }
        out.push('\n');
    }
    for text in &texts.list {
        out += &text.said[language];
        out.push('\n');
    }
    out
}

/// Warnings for missing translations, each with its file; the English text is used instead.
pub fn missing(rules: &[RuleFile], texts: &Texts) -> Vec<String> {
    let of_rules = rules.iter().flat_map(|rule| {
        rule.missing
            .iter()
            .map(|missing| format!("src/rules/{}.md:{}: {}", rule.slug, missing.line, missing.what))
    });
    of_rules.chain(texts.missing.iter().cloned()).collect()
}
