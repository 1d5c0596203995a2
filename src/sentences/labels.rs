//! Short labels: severities and categories of messages, fields of the setup form, errors in entries.
//!
//! In: a severity, the name of a field, a choice, an error in an entry. Out: a label in a language, short
//! enough to fit beside it.

use super::language::Language;
use crate::limits::OUTLINE_POINTS;
use crate::message::{Kind, Severity};
use crate::setup::ToolKind;
use crate::setup::blank::{Outline, OutlineFault};
use crate::setup::dialect::{DecimalRule, FeedMode, GSystem};
use crate::setup::draft::EntryError;
use crate::setup::fields::{Name, ReadError, Unit};
use crate::setup::invalid::Requirement;
use crate::units::{self, number};

impl Language {
    /// Chooses the text of this language.
    pub(crate) fn among(self, [english, chinese, russian]: [&'static str; 3]) -> &'static str {
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

/// Text about an assumed stock and the checks that were skipped because of it; `note` is the comment that sets this
/// stock.
pub fn inferred_stock(note: &str, language: Language) -> String {
    let said = language.among([
        "stock assumed, collisions not checked; to check them, add this comment to the program:",
        "毛坯为假定，未检查碰撞；要检查，请在程序中加上此注释：",
        "заготовка по умолчанию, столкновения не проверялись; для проверки добавьте в программу комментарий:",
    ]);
    format!("{said} {note}")
}

/// Error: an element in a Markdown page is not closed.
pub fn element_not_closed(language: Language) -> &'static str {
    language.among([
        "the element is not closed here: in Markdown a blank line ends it. Put the program into <pre data-gcode-playground> … </pre>",
        "此处元素没有结束：Markdown 中空行会结束该元素。请把程序放在 <pre data-gcode-playground> … </pre> 中",
        "здесь элемент не закрыт: в Markdown его обрывает пустая строка. Поместите программу в <pre data-gcode-playground> … </pre>",
    ])
}

/// Error: the element has no attribute of this name.
pub fn attribute_unknown(name: &str, language: Language) -> String {
    let said = language.among([
        "the element has no attribute of this name:",
        "元素没有这个名称的属性：",
        "у элемента нет атрибута с таким именем:",
    ]);
    format!("{said} `{name}`")
}

/// Error: invalid value of an attribute; `expected` describes valid values.
pub fn attribute_value(name: &str, value: &str, expected: &str, language: Language) -> String {
    let said = language.among(["is not understood; expected:", "无法识别；应为：", "непонятно; ожидается:"]);
    format!("`{name}=\"{value}\"` {said} {expected}")
}

/// Error: the setup of an element cannot be parsed.
pub fn setup_unreadable(reason: &str, language: Language) -> String {
    let said = language.among(["the setup cannot be read:", "无法读取设置：", "наладка не читается:"]);
    format!("{said} {reason}")
}

/// Error: a picture in a page is outdated.
pub fn picture_out_of_date(language: Language) -> &'static str {
    language.among([
        "the picture is not what the program draws now",
        "图形与程序当前绘制的不一致",
        "рисунок не совпадает с тем, что программа рисует сейчас",
    ])
}

/// The name of a field.
pub fn field(name: Name, language: Language) -> &'static str {
    language.among(match name {
        Name::StockDiameter => ["Diameter", "直径", "Диаметр"],
        Name::Bore => ["Bore diameter", "内孔直径", "Диаметр отверстия"],
        Name::Length => ["Length", "长度", "Длина"],
        Name::Face => ["Z of the front face", "前端面 Z", "Z переднего торца"],
        Name::Grip => ["Clamping length", "夹持长度", "Длина зажима"],
        Name::Outline => ["Outline, X0 Z2 X30 …", "轮廓 X0 Z2 X30……", "Контур, X0 Z2 X30 …"],
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
        Name::GeometryX => ["Geometry X", "形状 X", "Геометрия X"],
        Name::GeometryZ => ["Geometry Z", "形状 Z", "Геометрия Z"],
        Name::GeometryR => ["Geometry R", "形状 R", "Геометрия R"],
        Name::WearX => ["Wear X", "磨损 X", "Износ X"],
        Name::WearZ => ["Wear Z", "磨损 Z", "Износ Z"],
        Name::WearR => ["Wear R", "磨损 R", "Износ R"],
        Name::StartX => ["X (diameter)", "X（直径）", "X (диаметр)"],
        Name::StartZ => ["Z", "Z", "Z"],
        Name::CenterZ => ["Z of the centre's point", "顶尖 Z", "Z острия центра"],
        Name::QuillDiameter => ["Quill diameter", "套筒直径", "Диаметр пиноли"],
        Name::RapidX => ["Rapid traverse X", "X 快速移动速度", "Ускоренное перемещение X"],
        Name::RapidZ => ["Rapid traverse Z", "Z 快速移动速度", "Ускоренное перемещение Z"],
        Name::ThreadSpeedMargin => [
            "K of threads, n ≤ 1200/P − K",
            "螺纹转速系数 K（n ≤ 1200/P − K）",
            "K для резьбы, n ≤ 1200/P − K",
        ],
        Name::MaxSpeed => ["Maximum spindle speed", "主轴最高转速", "Наибольшая частота вращения"],
        Name::LeastX => ["X min (diameter)", "X 最小值（直径）", "X мин. (диаметр)"],
        Name::GreatestX => ["X max (diameter)", "X 最大值（直径）", "X макс. (диаметр)"],
        Name::LeastZ => ["Z min", "Z 最小值", "Z мин."],
        Name::GreatestZ => ["Z max", "Z 最大值", "Z макс."],
        Name::Turret => ["Turret", "刀架", "Револьверная головка"],
        Name::YAxis => ["Y axis", "Y 轴", "Ось Y"],
        Name::Control => ["Control", "数控系统", "Система ЧПУ"],
        Name::GSystem => ["G-code system", "G 代码体系", "Система G-кодов"],
        Name::Unit => ["Unit without G20 or G21", "没有 G20、G21 时的单位", "Единица без G20 и G21"],
        Name::FeedMode => ["Feed mode at the start", "开始时的进给方式", "Подача в начале"],
        Name::Decimal => ["Number without a point", "无小数点的数", "Число без точки"],
        Name::PqUnit => ["P and Q of G74 to G76", "G74 至 G76 的 P、Q", "P и Q в G74–G76"],
        Name::RefPointX => {
            ["Reference point X (diameter)", "参考点 X（直径）", "Референтная точка X (диаметр)"]
        }
        Name::RefPointZ => ["Reference point Z", "参考点 Z", "Референтная точка Z"],
        Name::Recognise => {
            ["Recognise programs for other controls", "识别其他系统的程序", "Распознавать чужие программы"]
        }
        Name::Strict => ["Alarms instead of warnings", "用报警代替警告", "Ошибки вместо предупреждений"],
        Name::Pockets => ["Pockets in G71 and G72", "G71、G72 的凹槽", "Карманы в G71 и G72"],
        Name::NegativeArcR => ["Negative R on an arc", "圆弧的负 R", "Отрицательный R дуги"],
        Name::Classroom => ["Classroom checklist", "课堂检查清单", "Учебный контрольный список"],
    })
}

/// The name of a group of fields.
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

/// The label of a tool.
pub fn tool(name: &str, language: Language) -> String {
    match name {
        "T0000" => {
            language.among(["Tool before any T word", "无 T 指令时的刀具", "Инструмент без слова T"]).into()
        }
        name => format!("{} {name}", group("tool", language)),
    }
}

/// The symbol of a unit.
pub fn unit(unit: Unit, language: Language) -> &'static str {
    language.among(match unit {
        Unit::Millimetre => ["mm", "mm", "мм"],
        Unit::Degree => ["°", "°", "°"],
        Unit::MillimetrePerMinute => ["mm/min", "mm/min", "мм/мин"],
        Unit::TurnsPerMinute => ["rpm", "r/min", "об/мин"],
    })
}

/// The symbol of the second, after a number.
pub fn seconds(language: Language) -> &'static str {
    language.among(["s", "s", "с"])
}

/// The symbol of a unit of length on a ruler.
pub fn unit_of_ruler(unit: units::Unit, language: Language) -> &'static str {
    language.among(match unit {
        units::Unit::Millimetre => ["mm", "mm", "мм"],
        units::Unit::Inch => ["in", "in", "дюйм"],
    })
}

/// The symbol of a unit of length after a number.
pub fn length(unit: units::Unit, language: Language) -> &'static str {
    language.among(match unit {
        units::Unit::Millimetre => ["mm", "mm", "мм"],
        units::Unit::Inch => ["in", "in", "дюйма"],
    })
}

/// The legend of a drawing: rapids, cuts, threads; blank, part, chuck and tailstock, a collision, milled
/// areas; a note that passes on top of each other are drawn side by side; material that another cut leaves; a tool.
pub fn legend(language: Language) -> [&'static str; 11] {
    match language {
        Language::English => [
            "rapid",
            "cut",
            "thread",
            "blank",
            "part",
            "chuck, tailstock",
            "collision",
            "milled, see the end face",
            "passes drawn apart",
            "left if R is the length of the cone",
            "tool",
        ],
        Language::Chinese => [
            "快速移动",
            "切削",
            "螺纹",
            "毛坯",
            "零件",
            "卡盘、尾座",
            "碰撞",
            "铣削，见端面视图",
            "各次走刀分开绘制",
            "R 只取锥面长度时残留的材料",
            "刀具",
        ],
        Language::Russian => [
            "ускоренный ход",
            "рабочий ход",
            "резьба",
            "заготовка",
            "деталь",
            "патрон, задняя бабка",
            "столкновение",
            "фрезеруется, см. торец",
            "проходы разведены на рисунке",
            "материал останется, если R равно длине конуса",
            "инструмент",
        ],
    }
}

/// The name of a kind of tool, used in the form, the readout and the setup sheet.
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

/// The name of a choice in a field; the choice itself if it has no other name.
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
            "в 0.001 мм или 0.0001 дюйма",
        ]),
        (Name::Control, "fanuc") => "FANUC",
        (Name::Control, "gsk") => "GSK 980TD",
        (Name::Control, "forum") => {
            language.among(["FANUC, P and Q in mm", "FANUC，P、Q 以 mm 计", "FANUC, P и Q в мм"])
        }
        (Name::Unit, "mm") => unit_of_program(units::Unit::Millimetre, language),
        (Name::Unit, "inch") => unit_of_program(units::Unit::Inch, language),
        (Name::FeedMode, "G98") => language.among(["mm/min (G98)", "mm/min（G98）", "мм/мин (G98)"]),
        (Name::FeedMode, "G99") => language.among(["mm/rev (G99)", "mm/r（G99）", "мм/об (G99)"]),
        (Name::PqUnit, "auto") => language.among(["inferred from the program", "按程序判断", "по программе"]),
        (Name::PqUnit, "um") => language.among(["in 0.001 mm", "以 0.001 mm 计", "в 0.001 мм"]),
        (Name::PqUnit, "mm") => language.among(["in mm", "以 mm 计", "в мм"]),
        (Name::NegativeArcR, "over180") => {
            language.among(["arc of more than 180°", "大于 180° 的圆弧", "дуга больше 180°"])
        }
        (Name::NegativeArcR, "alarm") => language.among(["alarm", "报警", "ошибка"]),
        (Name::Recognise | Name::Strict | Name::Pockets | Name::YAxis, "true") => {
            language.among(["yes", "是", "да"])
        }
        (Name::Recognise | Name::Strict | Name::Pockets | Name::YAxis, "false") => {
            language.among(["no", "否", "нет"])
        }
        (Name::Classroom, level) => Severity::named(level).map_or(choice, |level| severity(level, language)),
        _ => ToolKind::ALL
            .into_iter()
            .find(|kind| kind.name() == choice)
            .map_or(choice, |own| tool_kind(own, language)),
    }
}

/// The name of a G-code system.
pub fn system(system: GSystem, language: Language) -> String {
    format!("{} {}", language.among(["system", "体系", "система"]), system.name())
}

/// The unit of length of a program.
pub fn unit_of_program(unit: units::Unit, language: Language) -> &'static str {
    language.among(match unit {
        units::Unit::Millimetre => ["mm", "mm", "мм"],
        units::Unit::Inch => ["inch", "英寸", "дюймы"],
    })
}

/// The meaning of a number without a decimal point.
pub fn without_point(rule: DecimalRule, unit: units::Unit, language: Language) -> String {
    let said = language.among(["no point", "无小数点", "без точки"]);
    let counts = language.among(match (rule, unit) {
        (DecimalRule::Calculator, units::Unit::Millimetre) => ["mm", "mm", "мм"],
        (DecimalRule::Calculator, units::Unit::Inch) => ["in", "in", "дюйм"],
        (DecimalRule::LeastIncrement, units::Unit::Millimetre) => ["0.001 mm", "0.001 mm", "0.001 мм"],
        (DecimalRule::LeastIncrement, units::Unit::Inch) => ["0.0001 in", "0.0001 in", "0.0001 дюйма"],
    });
    format!("{said} = {counts}")
}

/// The unit of a feed.
pub fn feed_unit(mode: FeedMode, unit: units::Unit, language: Language) -> &'static str {
    language.among(match (mode, unit) {
        (FeedMode::PerTurn, units::Unit::Millimetre) => ["mm/rev", "mm/r", "мм/об"],
        (FeedMode::PerTurn, units::Unit::Inch) => ["in/rev", "in/r", "дюйм/об"],
        (FeedMode::PerMinute, units::Unit::Millimetre) => ["mm/min", "mm/min", "мм/мин"],
        (FeedMode::PerMinute, units::Unit::Inch) => ["in/min", "in/min", "дюйм/мин"],
    })
}

/// The unit of a cutting speed: metres per minute; under G20, feet per minute.
pub fn surface_speed(unit: units::Unit, language: Language) -> &'static str {
    language.among(match unit {
        units::Unit::Millimetre => ["m/min", "m/min", "м/мин"],
        units::Unit::Inch => ["ft/min", "ft/min", "фут/мин"],
    })
}

/// The block skip levels that are on.
pub fn block_skip(levels: &[u8], language: Language) -> String {
    let said = language.among(["block skip", "程序段跳过", "пропуск кадров"]);
    let mark = |level: &u8| if *level == 1 { "/".to_owned() } else { format!("/{level}") };
    let levels: Vec<String> = levels.iter().map(mark).collect();
    let state = match levels[..] {
        [] => language.among(["off", "关", "выкл."]).to_owned(),
        _ => levels.join(" "),
    };
    format!("{said} {state}")
}

/// Note that a program is for another control or machine; `name` is empty for another kind of machine.
pub fn not_run(name: &str, language: Language) -> String {
    let other = language.among(["another machine", "其他机床", "другой станок"]);
    let said = language.among(["not run", "未运行", "не выполнена"]);
    format!("{}: {said}", if name.is_empty() { other } else { name })
}

/// The title of a fix that sets a field of the setup; without a value, the user enters it in the form.
pub fn setting(field: &str, value: Option<&str>, language: Language) -> String {
    let template = language.among(match value {
        Some(_) => ["set `{field}` to `{value}`", "将`{field}`设为`{value}`", "задать «{field}»: `{value}`"],
        None => ["enter `{field}` in the setup", "在设置中填写`{field}`", "указать в наладке: «{field}»"],
    });
    template.replace("{field}", field).replace("{value}", value.unwrap_or_default())
}

/// Describes the fault of an outline.
fn outline_fault(fault: OutlineFault, language: Language) -> String {
    let with = |texts: [&'static str; 3], point: usize, value: f64| {
        let text = language.among(texts).replace("{point}", &point.to_string());
        text.replace("{value}", &number(value))
    };
    match fault {
        OutlineFault::Points(points) if points < Outline::FEWEST => with(
            ["Needs {value} points", "至少 {value} 点", "Нужно точек: {value}"],
            0,
            Outline::FEWEST as f64,
        ),
        OutlineFault::Points(_) => with(
            ["{value} points at most", "最多 {value} 点", "Точек не больше {value}"],
            0,
            OUTLINE_POINTS as f64,
        ),
        OutlineFault::NegativeX { point, x } => with(
            [
                "X{value} of point {point} cannot be negative",
                "第 {point} 点的 X{value} 不能为负",
                "X{value} точки {point} не может быть отрицательным",
            ],
            point,
            x.mm(),
        ),
        OutlineFault::TooFar { point, value } => with(
            [
                "{value} of point {point} is too large",
                "第 {point} 点的 {value} 太大",
                "{value} у точки {point} слишком велико",
            ],
            point,
            value,
        ),
        OutlineFault::Flat => {
            language.among(["Encloses no area", "轮廓没有面积", "Контур не ограничивает площади"]).into()
        }
        OutlineFault::Crosses { point } => with(
            [
                "Crosses itself after point {point}",
                "第 {point} 点之后轮廓自相交",
                "Пересекает себя после точки {point}",
            ],
            point,
            0.0,
        ),
    }
}

/// Describes an error in an entry.
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
        EntryError::Unreadable(ReadError::NotAnOutline) => language
            .among([
                "Points as X and Z: X0 Z2 X30 Z2",
                "请用 X、Z 写点：X0 Z2 X30 Z2",
                "Точки словами X и Z: X0 Z2 X30 Z2",
            ])
            .into(),
        EntryError::OfOutline => language
            .among(["The outline gives this size", "此尺寸由轮廓给出", "Этот размер задан контуром"])
            .into(),
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
        EntryError::Unmet(Requirement::Outline(fault)) => outline_fault(fault, language),
    }
}
