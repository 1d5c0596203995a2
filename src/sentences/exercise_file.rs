//! Describes the faults of an exercise file, and why a part has no target.
//!
//! In: faults. Out: text in a language, without the line.

use super::exercise::among;
use super::language::Language;
use crate::exercise::{NoTarget, Part, Problem, ReadError, TargetFault};

/// Why a part has no target.
pub fn describe_no_target(why: NoTarget, language: Language) -> &'static str {
    language.among(match why {
        NoTarget::NoPart => [
            "the program makes no part: name a blank and the tools",
            "程序没有加工出零件：请给出毛坯和刀具",
            "программа не делает детали: укажите заготовку и инструменты",
        ],
        NoTarget::TooManyLines => [
            "the outline of the part has too many lines for a target",
            "零件轮廓的线段太多，不能作为目标",
            "в контуре детали слишком много линий для образца",
        ],
        NoTarget::NoOutline => [
            "the outline of the part cannot be written as a target",
            "零件轮廓不能写成目标",
            "контур детали нельзя записать как образец",
        ],
    })
}

/// The fault of an exercise file, without its line.
pub fn describe_fault(error: &ReadError, language: Language) -> String {
    let text = |texts: [&'static str; 3]| language.among(texts).to_owned();
    let with = |texts: [&'static str; 3], value: &str| language.among(texts).replace("{}", value);
    match &error.problem {
        Problem::TooMany { part, count, most } => too_many(*part, *count, *most, language),
        Problem::NoHead => {
            text(["the file does not begin with ---", "文件不是以 --- 开头", "файл не начинается с ---"])
        }
        Problem::HeadOpen => {
            text(["the head has no closing ---", "文件头没有结束的 ---", "шапка не закрыта ---"])
        }
        Problem::HeadLine => text([
            "a line of the head is `key: value`",
            "文件头的每行为 `键: 值`",
            "строка шапки – `ключ: значение`",
        ]),
        Problem::UnknownKey { key, nearest } => {
            let told = with(["unknown key `{}`", "未知的键 `{}`", "неизвестный ключ `{}`"], key);
            let near = |near: &&str| with(["; is it `{}`?", "；是 `{}` 吗？", "; может быть, `{}`?"], near);
            told + &nearest.as_ref().map(near).unwrap_or_default()
        }
        Problem::Twice { name } => with(["`{}` appears twice", "`{}` 出现两次", "`{}` повторяется"], name),
        Problem::Missing { name } => with(["`{}` is missing", "缺少 `{}`", "нет `{}`"], name),
        Problem::Value { key, expected } => {
            with(["`{}` expects ", "`{}` 应为 ", "для `{}` ожидается "], key) + expected
        }
        Problem::BlockOpen => {
            text(["a block of code is not closed", "代码块没有结束", "блок кода не закрыт"])
        }
        Problem::UnknownBlock { name } => with(
            [
                "a block of code is `setup`, `gcode` or `target`, not `{}`",
                "代码块应为 `setup`、`gcode` 或 `target`，而不是 `{}`",
                "блок кода – `setup`, `gcode` или `target`, а не `{}`",
            ],
            name,
        ),
        Problem::StrayText => {
            text(["text before the first language", "第一种语言之前有文字", "текст перед первым языком"])
        }
        Problem::Heading => text([
            "a heading is `# en: Title`, `# zh: …` or `# ru: …`",
            "标题应为 `# en: …`、`# zh: …` 或 `# ru: …`",
            "заголовок – `# en: …`, `# zh: …` или `# ru: …`",
        ]),
        Problem::NoText => text(["title or task is missing", "缺少标题或任务", "нет заголовка или задания"]),
        Problem::Html => {
            text(["a text may not contain HTML", "文字中不能有 HTML", "в тексте не может быть HTML"])
        }
        Problem::Link => text([
            "a link may only be relative or begin with https:",
            "链接只能是相对地址或以 https: 开头",
            "ссылка может быть только относительной или с https:",
        ]),
        Problem::ControlCharacter => text(["a control character", "有控制字符", "управляющий символ"]),
        Problem::Setup { reason } => {
            with(["the setup cannot be read: {}", "无法读取设置：{}", "настройки не читаются: {}"], reason)
        }
        Problem::SetupValue(message) => message.sentence(language).message,
        Problem::NoBlank => text(["the setup has no blank", "设置中没有毛坯", "в настройках нет заготовки"]),
        Problem::Target(fault) => target_fault(fault, language),
    }
}

fn too_many(part: Part, count: usize, most: usize, language: Language) -> String {
    let what = language.among(match part {
        Part::File => ["bytes of the file", "文件字节数", "байт в файле"],
        Part::Head => ["lines of the head", "文件头行数", "строк в шапке"],
        Part::Codes => ["codes of a check", "一项检查的代码数", "кодов в проверке"],
        Part::Program => ["bytes of the program", "程序字节数", "байт в программе"],
        Part::Setup => ["bytes of the setup", "设置字节数", "байт в настройках"],
        Part::Title => ["characters of a title", "标题字符数", "знаков в заголовке"],
        Part::Task => ["characters of a task", "任务字符数", "знаков в задании"],
        Part::Hints => ["hints", "提示数", "подсказок"],
        Part::Hint => ["characters of a hint", "提示字符数", "знаков в подсказке"],
    });
    among(
        language,
        [
            format!("{what}: {count}, at most {most}"),
            format!("{what}：{count}，最多 {most}"),
            format!("{what}: {count}, не более {most}"),
        ],
    )
}

fn target_fault(fault: &TargetFault, language: Language) -> String {
    let text = |texts: [&'static str; 3]| language.among(texts).to_owned();
    let with = |texts: [&'static str; 3], value: &str| language.among(texts).replace("{}", value);
    match fault {
        TargetFault::First => text([
            "the target begins with a point, X and Z",
            "目标以一个点开始：X 和 Z",
            "образец начинается с точки: X и Z",
        ]),
        TargetFault::Word { word } => {
            with(["`{}` is not understood here", "`{}` 在此处无法识别", "`{}` здесь не читается"], word)
        }
        TargetFault::NoMove => text(["the line does not move", "该行没有移动", "строка никуда не ведёт"]),
        TargetFault::TooFew => text(["the target has no edges", "目标没有边", "в образце нет линий"]),
        TargetFault::TooMany { lines } => among(
            language,
            [
                format!("the target has {lines} lines, at most {}", TargetFault::MOST_LINES),
                format!("目标有 {lines} 行，最多 {}", TargetFault::MOST_LINES),
                format!("в образце строк: {lines}, не более {}", TargetFault::MOST_LINES),
            ],
        ),
        TargetFault::Range { word } => with(
            [
                "`{}`: X is not negative, and no value is above 5000",
                "`{}`：X 不能为负，数值不能超过 5000",
                "`{}`: X не бывает отрицательным, значения не больше 5000",
            ],
            word,
        ),
        TargetFault::Radius => text([
            "an arc is G02 or G03 with R of at least half the distance of its ends",
            "圆弧为 G02 或 G03，R 至少为两端距离的一半",
            "дуга – G02 или G03 с R не меньше половины расстояния между концами",
        ]),
        TargetFault::Crosses => text([
            "the outline crosses itself or has no area",
            "轮廓自相交或没有面积",
            "контур пересекает себя или не имеет площади",
        ]),
        TargetFault::End => text([
            "the outline ends on the axis, at its first point or at its left end",
            "轮廓应在轴线、起点或左端结束",
            "контур кончается на оси, в первой точке или на левом конце",
        ]),
        TargetFault::NotFor { word } => with(
            ["`{}` does not belong to this edge", "`{}` 不能用于这条边", "`{}` не относится к этой линии"],
            word,
        ),
    }
}
