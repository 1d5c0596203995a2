//! Texts of the language server: titles of actions, and the reasons why a number cannot be renamed.
//!
//! In: a refusal, a line. Out: a short sentence in a language.

use super::difference::clock;
use super::language::Language;
use crate::assist::rename::Refusal;

/// The title of the action that applies all safe fixes.
pub fn fix_all(language: Language) -> &'static str {
    language.among([
        "Fix all safe problems",
        "修复所有可安全修复的问题",
        "Исправить всё, что можно исправить безопасно",
    ])
}

/// The title of the action that expands the program.
pub fn expand(language: Language) -> &'static str {
    language.among([
        "Expand the program to plain moves",
        "将程序展开为普通移动指令",
        "Развернуть программу в простые перемещения",
    ])
}

/// The reason why a program has no expansion.
pub fn not_expanded(language: Language) -> &'static str {
    language.among([
        "not expanded: the motions would not stay the same",
        "未展开：展开后的运动轨迹会改变",
        "не развёрнуто: перемещения изменились бы",
    ])
}

/// The reason why a program is not formatted, with its line, from 1.
pub fn not_formatted(line: Option<u32>, reason: &str, language: Language) -> String {
    let place = line.map(|number| self::line(number, language));
    let separator = language.among([": ", "：", ": "]);
    let head = language.among(["not formatted", "未整理格式", "не отформатировано"]);
    let parts = [Some(head.to_owned()), place, Some(reason.to_owned())];
    parts.into_iter().flatten().collect::<Vec<_>>().join(separator)
}

/// The passes of a cycle, and the time of a cycle or a tool, in seconds; `None` if neither is known.
pub fn work(passes: Option<u32>, seconds: Option<f64>, language: Language) -> Option<String> {
    let passes = passes.map(|passes| self::passes(passes, language));
    let parts: Vec<String> = passes.into_iter().chain(seconds.map(clock)).collect();
    (!parts.is_empty()).then(|| parts.join(language.among([", ", "，", ", "])))
}

/// A number of passes.
pub fn passes(passes: u32, language: Language) -> String {
    match (passes, language) {
        (1, Language::English) => "1 pass".to_owned(),
        _ => with(
            language,
            ["{passes} passes", "走刀 {passes} 次", "проходов: {passes}"],
            &[("{passes}", passes)],
        ),
    }
}

/// A line of the program, from 1, that belongs to a message.
pub fn line(line: u32, language: Language) -> String {
    with(language, ["line {line}", "第 {line} 行", "строка {line}"], &[("{line}", line)])
}

/// The reason why a number cannot be renamed. `line_of`: the line of a byte, from 1.
pub fn refusal(refusal: &Refusal, line_of: impl Fn(u32) -> u32, language: Language) -> String {
    let at = |texts: [&'static str; 3], byte: u32| with(language, texts, &[("{line}", line_of(byte))]);
    match *refusal {
        Refusal::NothingHere => language
            .among([
                "there is no number here that can be renamed",
                "此处没有可以重命名的编号",
                "здесь нет номера, который можно заменить",
            ])
            .to_owned(),
        Refusal::ProgramName => language
            .among([
                "a program with a name instead of a number is not renamed",
                "以名称代替编号的程序不能重命名",
                "программа с именем вместо номера не переименовывается",
            ])
            .to_owned(),
        Refusal::SystemVariable => language
            .among([
                "the number of this variable has a fixed meaning",
                "此变量的编号有固定含义",
                "номер этой переменной имеет постоянное значение",
            ])
            .to_owned(),
        Refusal::NotANumber(example) => language
            .among(["enter a number: {example}", "请输入编号：{example}", "введите номер: {example}"])
            .replace("{example}", example),
        Refusal::OutOfRange(least, most) => with(
            language,
            [
                "the number must be between {least} and {most}",
                "编号必须在 {least} 与 {most} 之间",
                "номер должен быть от {least} до {most}",
            ],
            &[("{least}", least), ("{most}", most)],
        ),
        Refusal::Taken(byte) => at(
            [
                "line {line} uses this number already",
                "第 {line} 行已使用此编号",
                "этот номер уже есть в строке {line}",
            ],
            byte,
        ),
        Refusal::Computed(byte) => at(
            [
                "line {line} computes a number that may be this one",
                "第 {line} 行计算出的编号可能就是它",
                "строка {line} вычисляет номер, который может быть этим",
            ],
            byte,
        ),
        Refusal::NotDefined => language
            .among([
                "the program does not define this number",
                "程序中没有定义此编号",
                "в программе этот номер не определён",
            ])
            .to_owned(),
        Refusal::SeveralPrograms(byte) => at(
            [
                "M99 P returns to this number in several programs; line {line} has it, too",
                "M99 P 会返回到几个程序中的此编号；第 {line} 行也有",
                "M99 P возвращает к этому номеру в нескольких программах; он есть и в строке {line}",
            ],
            byte,
        ),
        Refusal::Unclear(byte) => at(
            [
                "the number in line {line} is not written in plain digits",
                "第 {line} 行的编号不是用普通数字写的",
                "номер в строке {line} записан не обычными цифрами",
            ],
            byte,
        ),
    }
}

/// The reason why a number is not renamed although all its places are known.
pub fn motions_would_change(language: Language) -> &'static str {
    language.among([
        "the motions of the program would change",
        "程序的运动会改变",
        "движения программы изменились бы",
    ])
}

/// The text of a language with numbers in place of their names.
fn with(language: Language, texts: [&'static str; 3], numbers: &[(&str, u32)]) -> String {
    let text = language.among(texts).to_owned();
    numbers.iter().fold(text, |text, (name, number)| text.replace(name, &number.to_string()))
}
