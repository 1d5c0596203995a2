//! Short labels: severity and category of a message; the setup form: names of fields, and errors in entries.
//!
//! In: a severity, a field's name, a choice, an error in an entry. Out: the words in a language, short
//! enough to stand beside it.

use super::language::Language;
use crate::message::{Kind, Severity};
use crate::setup::ToolKind;
use crate::setup::draft::EntryError;
use crate::setup::fields::{Name, ReadError, Unit};
use crate::setup::invalid::Requirement;
use crate::units::{self, number};

impl Language {
    /// The one of three texts that is in this language.
    fn among(self, [english, chinese, russian]: [&'static str; 3]) -> &'static str {
        match self {
            Self::English => english,
            Self::Chinese => chinese,
            Self::Russian => russian,
        }
    }
}

/// The name of a severity.
pub fn severity(severity: Severity, language: Language) -> &'static str {
    language.among(match severity {
        Severity::Off => ["Off", "关闭", "Выключено"],
        Severity::Info => ["Note", "提示", "Примечание"],
        Severity::Warning => ["Warning", "警告", "Предупреждение"],
        Severity::Error => ["Error", "错误", "Ошибка"],
    })
}

/// The name of a category of messages.
pub fn category(kind: Kind, language: Language) -> &'static str {
    language.among(match kind {
        Kind::Wrong => ["error in the program", "程序有误", "ошибка в программе"],
        Kind::Unsupported => ["not supported here", "此处不支持", "здесь не поддерживается"],
        Kind::Machine => ["depends on the machine", "取决于机床", "зависит от станка"],
    })
}

/// That a stock is assumed, and what was not checked because of it; `note` is the
/// comment that names this stock.
pub fn inferred_stock(note: &str, language: Language) -> String {
    let said = language.among([
        "stock assumed, collisions not checked. This stock in the program:",
        "毛坯为假定，未检查碰撞。在程序中写明此毛坯：",
        "заготовка по умолчанию, столкновения не проверялись. Эта заготовка в программе:",
    ]);
    format!("{said} {note}")
}

/// What a field is called.
pub fn field(name: Name, language: Language) -> &'static str {
    language.among(match name {
        Name::StockDiameter => ["Diameter", "直径", "Диаметр"],
        Name::Bore => ["Bore diameter", "内孔直径", "Диаметр отверстия"],
        Name::Length => ["Length", "长度", "Длина"],
        Name::Face => ["Z of the front face", "前端面 Z", "Z переднего торца"],
        Name::Grip => ["Clamping length", "夹持长度", "Длина зажима"],
        Name::Kind => ["Kind", "类型", "Вид"],
        Name::Side => ["Side of the work", "加工部位", "Сторона детали"],
        Name::Insert => ["Insert (ISO)", "刀片（ISO）", "Пластина (ISO)"],
        Name::NoseRadius => ["Nose radius", "刀尖圆弧半径", "Радиус при вершине"],
        Name::Tip => ["Tool-tip direction", "刀尖方位号", "Положение вершины"],
        Name::EnteringAngle => ["Entering angle κr", "主偏角 κr", "Главный угол в плане κr"],
        Name::PointAngle => ["Point angle", "刀尖角", "Угол при вершине"],
        Name::EdgeLength => ["Edge length", "切削刃长度", "Длина кромки"],
        Name::Width => ["Width", "刀宽", "Ширина"],
        Name::ToolDiameter => ["Diameter", "直径", "Диаметр"],
        Name::Reach => ["Reach", "伸出长度", "Вылет"],
        Name::Shank => ["Bar diameter", "刀杆直径", "Диаметр державки"],
        Name::Angle => ["Thread angle or drill point angle", "尖角", "Угол при вершине"],
        Name::ToolRadius => ["Cutter radius", "铣刀半径", "Радиус фрезы"],
        Name::GeometryR => ["Offset R", "刀补 R", "Корректор R"],
        Name::StartX => ["X (diameter)", "X（直径）", "X (диаметр)"],
        Name::StartZ => ["Z", "Z", "Z"],
        Name::CenterZ => ["Z of the centre's point", "顶尖 Z", "Z острия центра"],
        Name::QuillDiameter => ["Quill diameter", "套筒直径", "Диаметр пиноли"],
        Name::RapidX => ["Rapid traverse X", "X 快速移动速度", "Ускоренное перемещение X"],
        Name::RapidZ => ["Rapid traverse Z", "Z 快速移动速度", "Ускоренное перемещение Z"],
        Name::MaxSpeed => ["Maximum spindle speed", "主轴最高转速", "Наибольшая частота вращения"],
        Name::LeastX => ["X min (diameter)", "X 最小值（直径）", "X мин. (диаметр)"],
        Name::GreatestX => ["X max (diameter)", "X 最大值（直径）", "X макс. (диаметр)"],
        Name::LeastZ => ["Z min", "Z 最小值", "Z мин."],
        Name::GreatestZ => ["Z max", "Z 最大值", "Z макс."],
        Name::Turret => ["Turret", "刀架", "Револьверная головка"],
        Name::Decimal => ["Number without a point", "无小数点的数", "Число без точки"],
        Name::Classroom => ["Classroom checklist", "课堂检查清单", "Учебный контрольный список"],
    })
}

/// What a group of fields is called.
pub fn group(group: &str, language: Language) -> &'static str {
    language.among(match group {
        "stock" => ["Stock", "毛坯", "Заготовка"],
        "start" => ["Start of the tool tip", "刀尖起点", "Начальная точка вершины"],
        "machine" => ["Machine", "机床", "Станок"],
        "control" => ["Control", "数控系统", "Система ЧПУ"],
        "rules" => ["Rules", "规则", "Правила"],
        "tailstock" => ["Tailstock", "尾座", "Задняя бабка"],
        _ => ["Tool", "刀具", "Инструмент"],
    })
}

/// What a tool is called.
pub fn tool(name: &str, language: Language) -> String {
    match name {
        "T0000" => {
            language.among(["Tool before any T word", "无 T 指令时的刀具", "Инструмент без слова T"]).into()
        }
        name => format!("{} {name}", group("tool", language)),
    }
}

/// How a unit is written.
pub fn unit(unit: Unit, language: Language) -> &'static str {
    language.among(match unit {
        Unit::Millimetre => ["mm", "mm", "мм"],
        Unit::Degree => ["°", "°", "°"],
        Unit::MillimetrePerMinute => ["mm/min", "mm/min", "мм/мин"],
        Unit::TurnsPerMinute => ["rpm", "r/min", "об/мин"],
    })
}

/// How a unit of length is written after a number.
pub fn length(unit: units::Unit, language: Language) -> &'static str {
    language.among(match unit {
        units::Unit::Millimetre => ["mm", "mm", "мм"],
        units::Unit::Inch => ["in", "in", "дюйма"],
    })
}

/// What a kind of tool is called, wherever it is named: form, readout, setup sheet.
pub fn tool_kind(kind: ToolKind, language: Language) -> &'static str {
    language.among(match kind {
        ToolKind::Turning => ["turning tool", "车刀", "проходной резец"],
        ToolKind::Boring => ["boring bar", "镗刀", "расточной резец"],
        ToolKind::Grooving => ["grooving tool", "切槽刀", "канавочный резец"],
        ToolKind::Threading => ["threading tool", "螺纹刀", "резьбовой резец"],
        ToolKind::Drill => ["drill", "钻头", "сверло"],
        ToolKind::Tap => ["tap", "丝锥", "метчик"],
        ToolKind::Endmill => ["live end mill", "动力刀具（铣刀）", "приводная фреза"],
    })
}

/// What a choice of another field is called; the choice itself, where it has no other name.
pub fn choice(name: Name, choice: &'static str, language: Language) -> &'static str {
    match (name, choice) {
        (Name::Side, "outside") => language.among(["outside", "外圆", "снаружи"]),
        (Name::Side, "inside") => language.among(["bore", "内孔", "отверстие"]),
        (Name::Side, "face") => language.among(["end face", "端面", "торец"]),
        (Name::Turret, "rear") => language.among(["rear", "后置", "за осью шпинделя"]),
        (Name::Turret, "front") => language.among(["front", "前置", "перед осью шпинделя"]),
        (Name::Decimal, "auto") => {
            language.among(["inferred from the program", "按程序判断", "по программе"])
        }
        (Name::Decimal, "calculator") => {
            language.among(["in mm or inches", "按 mm 或英寸计", "в мм или дюймах"])
        }
        (Name::Decimal, "leastIncrement") => language.among([
            "in 0.001 mm or 0.0001 in",
            "按 0.001 mm 或 0.0001 in 计",
            "в 0,001 мм или 0,0001 дюйма",
        ]),
        (Name::Classroom, level) => Severity::named(level).map_or(choice, |level| severity(level, language)),
        _ => ToolKind::ALL
            .into_iter()
            .find(|kind| kind.name() == choice)
            .map_or(choice, |own| tool_kind(own, language)),
    }
}

/// What is wrong with an entry.
pub fn entry_error(error: EntryError, language: Language) -> String {
    let with = |texts: [&'static str; 3], most: f64| language.among(texts).replace("{most}", &number(most));
    match error {
        EntryError::Unreadable(ReadError::NotANumber) => {
            language.among(["Not a number", "不是数字", "Не число"]).into()
        }
        EntryError::Unreadable(ReadError::NotWhole) => {
            language.among(["Must be a whole number", "必须是整数", "Нужно целое число"]).into()
        }
        EntryError::Unreadable(ReadError::NotKnown) => {
            language.among(["Unknown value", "无法识别", "Неизвестное значение"]).into()
        }
        EntryError::Missing => language.among(["Required", "必填", "Нужно указать"]).into(),
        EntryError::Unmet(Requirement::Positive) => {
            language.among(["Must be greater than zero", "必须大于零", "Должно быть больше нуля"]).into()
        }
        EntryError::Unmet(Requirement::NotNegative) => {
            language.among(["Cannot be negative", "不能为负", "Не может быть отрицательным"]).into()
        }
        EntryError::Unmet(Requirement::Below(most)) => {
            with(["Must be less than {most}", "必须小于 {most}", "Должно быть меньше {most}"], most)
        }
        EntryError::Unmet(Requirement::AtMost(most)) => {
            with(["{most} at most", "最大 {most}", "Не больше {most}"], most)
        }
    }
}
