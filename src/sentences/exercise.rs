//! Describes the report on an answer to an exercise.
//!
//! In: verdicts, sizes, causes, checks. Out: text in a language. Lengths are in millimetres.

use super::labels;
use super::language::Language;
use crate::exercise::{
    Cause, Check, Checked, Finding, Measured, Place, Quantity, Range, Slip, Tolerance, Verdict,
};
use crate::setup::dialect::FeedMode;
use crate::setup::fields;
use crate::units::{Unit, number};

/// A heading or a remark of a table of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Label {
    /// The file.
    File,
    /// The part.
    Part,
    /// Failed checks.
    Failed,
    /// Numbers of errors and warnings.
    Problems,
    /// Time.
    Time,
    /// Codes.
    Codes,
    /// Points.
    Points,
    /// The same text as another answer.
    SameText,
    /// A size.
    Size,
    /// A place.
    Place,
    /// The nominal size.
    Nominal,
    /// The actual size.
    Actual,
    /// The deviation.
    Deviation,
    /// The tolerance.
    Tolerance,
    /// Within the tolerance.
    In,
    /// Outside of the tolerance.
    Out,
    /// The checks.
    Checks,
    /// A passed check.
    Passed,
    /// A failed check.
    NotPassed,
    /// An unknown value.
    Unknown,
}

/// A heading or a remark.
pub fn label(label: Label, language: Language) -> &'static str {
    language.among(match label {
        Label::File => ["file", "文件", "файл"],
        Label::Part => ["part", "零件", "деталь"],
        Label::Failed => ["failed checks", "未通过的检查", "непройденные проверки"],
        Label::Problems => ["errors, warnings", "错误、警告", "ошибки, предупреждения"],
        Label::Time => ["time", "时间", "время"],
        Label::Codes => ["codes", "代码", "коды"],
        Label::Points => ["points", "得分", "баллы"],
        Label::SameText => ["same text as", "文字相同：", "тот же текст, что в"],
        Label::Size => ["size", "尺寸", "размер"],
        Label::Place => ["place", "位置", "место"],
        Label::Nominal => ["nominal", "公称值", "номинал"],
        Label::Actual => ["actual", "实际值", "факт"],
        Label::Deviation => ["deviation", "偏差", "отклонение"],
        Label::Tolerance => ["tolerance", "公差", "допуск"],
        Label::In => ["in", "合格", "в допуске"],
        Label::Out => ["OUT", "超差", "ВНЕ ДОПУСКА"],
        Label::Checks => ["checks", "检查", "проверки"],
        Label::Passed => ["passed", "通过", "выполнено"],
        Label::NotPassed => ["FAILED", "未通过", "НЕ ВЫПОЛНЕНО"],
        Label::Unknown => ["unknown", "未知", "неизвестно"],
    })
}

/// Whether the part is the wanted one, and where it differs: `Z-20: Ø26.4, wanted Ø26 ±0.05`.
pub fn describe_verdict(verdict: &Verdict, language: Language) -> String {
    match verdict {
        Verdict::Same => language.among(["Same part", "零件相同", "Деталь та же"]).to_owned(),
        Verdict::Differs(place) => describe_place(place, language),
        Verdict::NoPart => {
            language.among(["No part is made", "没有加工出零件", "Деталь не получается"]).to_owned()
        }
    }
}

/// The tolerance of sizes without their own, below a drawing.
pub fn general_tolerance(tolerance: Tolerance, language: Language) -> String {
    match language {
        Language::English => format!("General tolerance {tolerance} mm"),
        Language::Chinese => format!("未注线性尺寸公差 {tolerance} mm"),
        Language::Russian => format!("Неуказанные предельные отклонения линейных размеров {tolerance} мм"),
    }
}

/// The accuracy of a verdict, mm or degrees, unless the deviation is smaller.
const HUNDREDTH: f64 = 0.01;

fn describe_place(place: &Place, language: Language) -> String {
    let size = &place.size;
    let (at, tolerance) = (place_of(size), size.tolerance);
    let is_small = size.deviation().is_some_and(|deviation| deviation.abs() < HUNDREDTH);
    let rounded = |value: f64| if is_small { value } else { (value / HUNDREDTH).round() * HUNDREDTH };
    let wanted = with_sign(size.quantity, rounded(size.nominal));
    let name = match size.quantity {
        Quantity::Diameter | Quantity::Radius => String::new(),
        other => format!("{} ", quantity(other, language)),
    };
    let actual = size.actual.map(|actual| with_sign(size.quantity, rounded(actual)));
    let actual = actual.unwrap_or_else(|| no_surface(language).to_owned());
    match language {
        Language::English => format!("{at}: {name}{actual}, wanted {wanted} {tolerance}"),
        Language::Chinese => format!("{at}：{name}{actual}，应为 {wanted} {tolerance}"),
        Language::Russian => format!("{at}: {name}{actual}, нужно {wanted} {tolerance}"),
    }
}

/// There is no surface to measure.
pub fn no_surface(language: Language) -> &'static str {
    language.among(["no such surface", "没有该表面", "поверхности нет"])
}

/// The name of a measured quantity.
pub fn quantity(quantity: Quantity, language: Language) -> &'static str {
    language.among(match quantity {
        Quantity::Diameter => ["diameter", "直径", "диаметр"],
        Quantity::Length => ["length", "长度", "длина"],
        Quantity::Face => ["right end", "右端面", "правый торец"],
        Quantity::Angle => ["angle", "角度", "угол"],
        Quantity::Radius => ["radius", "半径", "радиус"],
        Quantity::Width => ["groove width", "槽宽", "ширина канавки"],
        Quantity::Lead => ["lead", "导程", "ход резьбы"],
        Quantity::Root => ["root diameter", "螺纹牙底直径", "диаметр впадин резьбы"],
        Quantity::Crest => ["crest diameter", "螺纹牙顶直径", "диаметр вершин резьбы"],
        Quantity::ThreadLength => ["thread length", "螺纹长度", "длина резьбы"],
        Quantity::Flats => ["width across flats", "对边宽度", "размер под ключ"],
    })
}

/// Where a size is measured.
pub fn place_of(size: &Measured) -> String {
    format!("Z{}", short(size.at.z))
}

/// A size with its sign: `Ø26`, `R5`, `Z0`, `5.71°`.
pub fn with_sign(quantity: Quantity, value: f64) -> String {
    let value = short(value);
    match quantity {
        Quantity::Diameter | Quantity::Root | Quantity::Crest => format!("Ø{value}"),
        Quantity::Radius => format!("R{value}"),
        Quantity::Face => format!("Z{value}"),
        Quantity::Angle => format!("{value}°"),
        Quantity::Length | Quantity::Width | Quantity::Lead | Quantity::ThreadLength | Quantity::Flats => {
            value
        }
    }
}

/// A number with at most three decimals.
pub fn short(value: f64) -> String {
    number((value * 1000.0).round() / 1000.0)
}

/// Why the part differs.
pub fn describe_cause(cause: &Cause, language: Language) -> String {
    let told = match &cause.slip {
        Slip::TaperFromDrawing { written, right, axis, from, start } => {
            let [from, start] = [from, start].map(|place| format!("{axis}{}", short(*place)));
            match language {
                Language::English => {
                    format!("{written} was calculated from {from}; the cut starts at {start}: {right}")
                }
                Language::Chinese => {
                    format!("{written} 是从 {from} 算的，而切削从 {start} 开始：应为 {right}")
                }
                Language::Russian => {
                    format!("{written} рассчитано от {from}, а проход начинается в {start}: нужно {right}")
                }
            }
        }
        Slip::TaperSign { written, right } => among(
            language,
            [
                format!("The sign of {written} is wrong: {right}"),
                format!("{written} 的正负号错误：应为 {right}"),
                format!("Неверный знак в {written}: нужно {right}"),
            ],
        ),
        Slip::RadiusForDiameter { written, right } => among(
            language,
            [
                format!("{written} is a radius, and X is a diameter: {right}"),
                format!("{written} 写成了半径，而 X 是直径：应为 {right}"),
                format!("{written} – радиус, а X задают диаметром: нужно {right}"),
            ],
        ),
        Slip::SignOfX { written, right } => among(
            language,
            [
                format!("{written} is on the other side of the axis: {right}"),
                format!("{written} 在轴线的另一侧：应为 {right}"),
                format!("{written} – по другую сторону оси: нужно {right}"),
            ],
        ),
        Slip::MissingMinus { written, right } => among(
            language,
            [
                format!("A minus sign is missing: {written} instead of {right}"),
                format!("缺少负号：{written} 应为 {right}"),
                format!("Нет знака минус: {written} вместо {right}"),
            ],
        ),
        Slip::Reported(found) => found.sentence(language).message.trim_end_matches(['.', '。']).to_owned(),
    };
    told + &more_words(cause.words, language)
}

/// The number of words with the same slip.
fn more_words(words: usize, language: Language) -> String {
    match (words, language) {
        (..2, _) => String::new(),
        (_, Language::English) => format!(" ({words} words)"),
        (_, Language::Chinese) => format!("（共 {words} 处）"),
        (_, Language::Russian) => format!(" (всего слов: {words})"),
    }
}

/// One of three texts.
pub(super) fn among(language: Language, [english, chinese, russian]: [String; 3]) -> String {
    match language {
        Language::English => english,
        Language::Chinese => chinese,
        Language::Russian => russian,
    }
}

/// A check.
pub fn describe_check(check: &Check, language: Language) -> String {
    let with = |texts: [&'static str; 3], value: String| language.among(texts).replace("{}", &value);
    match check {
        Check::Alarms => language
            .among(["runs without an alarm", "运行无报警", "выполняется без аварийных сигналов"])
            .to_owned(),
        Check::Collisions => language
            .among(["runs without a collision", "运行无碰撞", "выполняется без столкновений"])
            .to_owned(),
        Check::Required(code) => with(["uses {}", "使用 {}", "используется {}"], code.clone()),
        Check::Forbidden(code) => with(["does not use {}", "不使用 {}", "не используется {}"], code.clone()),
        Check::Depth(own) => {
            with(["depth of cut {}", "切深 {}", "глубина резания {}"], in_unit(*own, &mm(language)))
        }
        Check::Feed(own) => {
            with(["feed rate {}", "进给速度 {}", "подача {}"], in_unit(*own, &per_turn(language)))
        }
        Check::Speed(own) => with(
            ["spindle speed {}", "主轴转速 {}", "частота вращения {}"],
            in_unit(*own, labels::unit(fields::Unit::TurnsPerMinute, language)),
        ),
        Check::CuttingSpeed(own) => with(
            ["cutting speed {}", "切削速度 {}", "скорость резания {}"],
            in_unit(*own, labels::surface_speed(Unit::Millimetre, language)),
        ),
        Check::Time(own) => {
            with(["time {}", "时间 {}", "время {}"], in_unit(*own, labels::seconds(language)))
        }
        Check::CutsTo(at) => with(["a cut ends at {}", "有一次切削到达 {}", "проход в точку {}"], point(*at)),
        Check::SafeEnd(distance) => with(
            [
                "the tool ends at least {} away from the blank",
                "刀具最后离毛坯至少 {}",
                "инструмент в конце не ближе {} от заготовки",
            ],
            format!("{} {}", short(*distance), mm(language)),
        ),
        Check::SameBlocks => language
            .among([
                "all given blocks, and no others",
                "只含全部给定的程序段",
                "все данные кадры и только они",
            ])
            .to_owned(),
        Check::OnlyBlanks => language
            .among(["only the blanks are filled in", "只填写了空格", "заполнены только пропуски"])
            .to_owned(),
        Check::Prediction(line) => {
            with(["end point of line {}", "第 {} 行的终点", "конечная точка строки {}"], line.to_string())
        }
    }
}

/// What was found; empty if the check says it all.
pub fn describe_finding(checked: &Checked, language: Language) -> String {
    match &checked.finding {
        Finding::None => String::new(),
        Finding::Message(found) => found.sentence(language).message,
        Finding::Value(value) => short(*value),
        Finding::Unknown => label(Label::Unknown, language).to_owned(),
        Finding::NoWord('S') => language
            .among([
                "the spindle is stopped, or S or the limit G50 is missing",
                "主轴停止，或缺少 S 或 G50 限速",
                "шпиндель остановлен, либо не задан S или предел G50",
            ])
            .to_owned(),
        Finding::NoWord(address) => among(
            language,
            [
                format!("no feed rate {address} is programmed"),
                format!("未指令进给速度 {address}"),
                format!("подача {address} не задана"),
            ],
        ),
        Finding::NoCut => {
            language.among(["no cut to check", "没有可检查的切削", "нет проходов для проверки"]).to_owned()
        }
        Finding::NoAnswer => language.among(["no answer", "未回答", "нет ответа"]).to_owned(),
        Finding::Place(at) => point(*at),
    }
}

fn point([x, z]: [f64; 2]) -> String {
    format!("X{} Z{}", short(x), short(z))
}

fn mm(language: Language) -> String {
    labels::length(Unit::Millimetre, language).to_owned()
}

fn per_turn(language: Language) -> String {
    labels::feed_unit(FeedMode::PerTurn, Unit::Millimetre, language).to_string()
}

/// A range with its unit: `0.1 … 0.3 mm/rev`, `≤ 2.5 mm`.
fn in_unit(range: Range, unit: &str) -> String {
    match (range.least, range.most) {
        (Some(least), Some(most)) => format!("{} … {} {unit}", short(least), short(most)),
        (None, Some(most)) => format!("≤ {} {unit}", short(most)),
        (Some(least), None) => format!("≥ {} {unit}", short(least)),
        (None, None) => String::new(),
    }
}
