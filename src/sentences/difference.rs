//! Describes the difference between two versions of a program.
//!
//! In: changes, totals, readings. Out: [`Told`]: name of a difference and its values in both versions;
//! headings and remarks.

use super::language::Language;
use super::{describe_motion, descriptions, labels};
use crate::difference::{Change, Reading};
use crate::motion::{Feed, SpindleSpeed, SpindleTurn};
use crate::setup::dialect::FeedMode;
use crate::setup::{fields, tool_word};
use crate::units::{Unit, number};

/// A difference: its name, and its values in the first and the second version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Told {
    /// Name of the difference.
    pub what: String,
    /// The values; empty if the name is sufficient.
    pub values: [String; 2],
}

/// A heading or a remark of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// Neither text nor motions differ.
    Same,
    /// The text differs, the motions do not.
    TextAlone,
    /// The motions of a hunk are unchanged.
    NoMotion,
    /// Unchanged blocks with different motions; `{}` is their number.
    Later,
    /// The same, without an earlier change of the text.
    Unexplained,
    /// Reading rules of the versions.
    ReadAs,
    /// Totals.
    Totals,
    /// The totals are the same.
    SameTotals,
    /// Time.
    Time,
    /// Number of motions of unknown time.
    WithoutTime,
    /// Number of motions.
    Motions,
    /// Number of passes of cycles.
    Passes,
    /// Path length at feed.
    Cut,
    /// Path length at rapid.
    Rapid,
    /// Tools.
    Tools,
    /// The finished part.
    Part,
    /// The parts are the same.
    SamePart,
    /// A part is not available.
    NoPart,
    /// Areas that only one part has; `{}` is the name of its program.
    OnlyIn,
    /// Messages that disappeared.
    Gone,
    /// New messages.
    New,
    /// A line of a program; `{}` is its number.
    Line,
    /// There are more changed blocks than are shown; `{}` is their number.
    More,
    /// A stroke of the drawing that both versions have.
    InBoth,
}

/// A heading or a remark.
pub fn said(said: Said, language: Language) -> &'static str {
    language.among(match said {
        Said::Same => ["No difference.", "没有差异。", "Различий нет."],
        Said::TextAlone => [
            "Only the text differs: the motions are the same.",
            "仅文字不同：刀具运动相同。",
            "Отличается только текст: перемещения одинаковы.",
        ],
        Said::NoMotion => {
            ["these blocks move as before", "这些程序段的运动不变", "перемещения этих кадров прежние"]
        }
        Said::Later => [
            "Unchanged blocks whose motion differs from here on: {}",
            "此后文字未变但运动不同的程序段：{}",
            "Далее кадров с прежним текстом, но другими перемещениями: {}",
        ],
        Said::Unexplained => [
            "Unchanged blocks whose motion differs: {}",
            "文字未变但运动不同的程序段：{}",
            "Кадров с прежним текстом, но другими перемещениями: {}",
        ],
        Said::ReadAs => ["Read as", "读取方式", "Прочитано как"],
        Said::Totals => ["Totals", "合计", "Итого"],
        Said::SameTotals => ["no difference", "无差异", "различий нет"],
        Said::Time => ["time", "时间", "время"],
        Said::WithoutTime => {
            ["motions not in the time", "未计入时间的运动", "перемещений, не вошедших во время"]
        }
        Said::Motions => ["motions", "运动数", "перемещений"],
        Said::Passes => ["passes", "走刀次数", "проходов"],
        Said::Cut => ["cutting length, mm", "切削长度，mm", "длина резания, мм"],
        Said::Rapid => ["rapid traverse, mm", "快速移动长度，mm", "ускоренные перемещения, мм"],
        Said::Tools => ["tools", "刀具", "инструменты"],
        Said::Part => ["Part", "零件", "Деталь"],
        Said::SamePart => ["no difference", "无差异", "различий нет"],
        Said::NoPart => [
            "not compared: no part can be shown",
            "未比较：无法显示零件",
            "не сравнивалась: деталь показать нельзя",
        ],
        Said::OnlyIn => ["only in {}", "仅在 {} 中", "только в {}"],
        Said::Gone => ["Messages that are gone", "消失的消息", "Исчезнувшие сообщения"],
        Said::New => ["New messages", "新消息", "Новые сообщения"],
        Said::Line => ["line {}", "第 {} 行", "строка {}"],
        Said::More => [
            "{} more changed blocks are not shown.",
            "另有 {} 个更改的程序段未显示。",
            "Ещё изменённых кадров (не показаны): {}.",
        ],
        Said::InBoth => ["in both", "两者共有", "в обеих"],
    })
}

/// A heading with `{}` replaced by a count or a name.
pub fn said_with(heading: Said, value: &str, language: Language) -> String {
    said(heading, language).replace("{}", value)
}

/// Describes a change in a language, with lengths in a unit.
pub fn describe_change(change: &Change, unit: Unit, language: Language) -> Told {
    let name = |texts: [&'static str; 3]| language.among(texts).to_owned();
    let of = |what: [&'static str; 3], values: [String; 2]| Told { what: name(what), values };
    let length = |mm: f64| format!("{} {}", number(mm / unit.millimetres()), labels::length(unit, language));
    let none = || "–".to_owned();
    match change {
        Change::Moves(both) => of(
            ["motion", "运动", "перемещение"],
            both.each_ref().map(|own| match own {
                None => none(),
                Some((count, motion)) => {
                    let told = describe_motion(motion, None, unit, language);
                    match count {
                        1 => told,
                        count => format!("{told} ({}: {count})", said(Said::Motions, language)),
                    }
                }
            }),
        ),
        Change::Cycle(both) => of(
            ["cycle", "循环", "цикл"],
            both.map(|own| own.map_or_else(none, |cycle| cycle.code().to_owned())),
        ),
        Change::Passes(cycle, both) => Told {
            what: format!("{} {}", cycle.code(), said(Said::Passes, language)),
            values: both.map(|count| count.to_string()),
        },
        Change::Motions(both) => Told {
            what: said(Said::Motions, language).to_owned(),
            values: both.map(|count| count.to_string()),
        },
        Change::Kind(both) => of(
            ["kind of motion", "运动方式", "вид перемещения"],
            both.each_ref().map(|motion| describe_motion(motion, None, unit, language)),
        ),
        Change::End(both) => of(
            ["end point", "终点", "конечная точка"],
            both.each_ref().map(|motion| descriptions::end_of(motion, unit)),
        ),
        Change::Radius(both) => of(["arc radius", "圆弧半径", "радиус дуги"], both.map(length)),
        Change::Way => of(
            [
                "another path between the same points",
                "同样两点之间路径不同",
                "другая траектория между теми же точками",
            ],
            [String::new(), String::new()],
        ),
        Change::Feed(both) => of(
            ["feed rate", "进给速度", "подача"],
            both.map(|feed| {
                let told = |mm: f64, mode: FeedMode| {
                    let value = number(mm / unit.millimetres());
                    format!("{value} {}", labels::feed_unit(mode, unit, language))
                };
                match feed {
                    Feed::Unset => none(),
                    Feed::PerMinute(feed) => told(feed, FeedMode::PerMinute),
                    Feed::PerTurn(feed) => told(feed, FeedMode::PerTurn),
                }
            }),
        ),
        Change::Lead(both) => of(["lead", "导程", "ход резьбы"], both.map(length)),
        Change::Speed(both) => of(
            match both {
                [SpindleSpeed::Surface { .. }, SpindleSpeed::Surface { .. }] => {
                    ["cutting speed", "切削速度", "скорость резания"]
                }
                _ => ["spindle speed", "主轴转速", "частота вращения шпинделя"],
            },
            both.map(|speed| match speed {
                SpindleSpeed::Constant(speed) => turns(speed, language),
                SpindleSpeed::Surface { speed } => {
                    let value = number(speed / unit.surface_metres());
                    format!("{value} {} (G96)", labels::surface_speed(unit, language))
                }
            }),
        ),
        Change::Highest(both) => of(
            ["maximum spindle speed", "主轴最高转速", "наибольшая частота вращения шпинделя"],
            both.map(|own| own.map_or_else(none, |speed| turns(speed, language))),
        ),
        Change::Turn(both) => of(
            ["spindle", "主轴", "шпиндель"],
            both.map(|turn| {
                let code = match turn {
                    SpindleTurn::Stopped => "M05",
                    SpindleTurn::Forward => "M03",
                    SpindleTurn::Reverse => "M04",
                };
                code.to_owned()
            }),
        ),
        Change::Tool(both) => of(
            ["tool", "刀具", "инструмент"],
            both.map(|(station, offset)| match (station, offset) {
                (0, 0) => none(),
                _ => tool_word((station, offset)),
            }),
        ),
        Change::Dwell(both) => of(
            ["dwell", "暂停", "выдержка"],
            both.map(|seconds| format!("{} {}", number(seconds), labels::seconds(language))),
        ),
    }
}

/// Describes a reading rule in both versions.
pub fn describe_reading(reading: Reading, language: Language) -> [String; 2] {
    match reading {
        Reading::Codes(both) => both.map(|codes| codes.name().to_owned()),
        Reading::Decimal(both) => both.map(|rule| labels::without_point(rule, Unit::Millimetre, language)),
        Reading::Unit(both) => both.map(|unit| labels::unit_of_program(unit, language).to_owned()),
    }
}

fn turns(speed: f64, language: Language) -> String {
    format!("{} {}", number(speed), labels::unit(fields::Unit::TurnsPerMinute, language))
}

/// Formats seconds as minutes and seconds.
pub fn clock(seconds: f64) -> String {
    let tenths = (10.0 * seconds).round();
    format!("{}:{:04.1}", (tenths / 600.0).floor(), tenths % 600.0 / 10.0)
}
