//! The texts beside those of the messages, as they are written: `src/sentences/<language>.txt`.
//!
//! In: the files of all languages. Out: each text by the enum and the variant it belongs to, or every mistake
//! with its file and line. A line is `Enum.Variant: text`; `#` begins a comment. Shared by the build script and
//! `cargo xtask`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::format::{LANGUAGES, RuleFile};

/// A text in all languages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text {
    /// The enum, as in Rust.
    pub kind: String,
    /// Its variant.
    pub variant: String,
    /// What it says, in the order of `LANGUAGES`; in English where a language has no text.
    pub said: [String; 3],
}

/// The texts, in the order of the English file.
#[derive(Clone, Debug, Default)]
pub struct Texts {
    /// Each text.
    pub list: Vec<Text>,
    /// What a language has no text for.
    pub missing: Vec<String>,
    /// The mistakes.
    pub mistakes: Vec<String>,
}

impl Texts {
    /// Reads the files of a project.
    pub fn read(project: &str) -> Self {
        let file = |tag: &str| {
            let path = Path::new(project).join("src/sentences").join(format!("{tag}.txt"));
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        };
        Self::of(&LANGUAGES.map(file))
    }

    /// Reads the texts of all languages, in the order of `LANGUAGES`.
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

/// Of which messages, with which arguments, and of which variants a list has texts, in which order: equal where the
/// lists fit the same module.
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

/// All texts of a language, a line each: their order, the sentence of each message, after a tab its help, then the
/// other texts.
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

/// What languages lack, each with its file; English is in its place.
pub fn missing(rules: &[RuleFile], texts: &Texts) -> Vec<String> {
    let of_rules = rules.iter().flat_map(|rule| {
        rule.missing
            .iter()
            .map(|missing| format!("src/rules/{}.md:{}: {}", rule.slug, missing.line, missing.what))
    });
    of_rules.chain(texts.missing.iter().cloned()).collect()
}
