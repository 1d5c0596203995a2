//! The words of the setup sheet in every language. A card without a translation does not compile.

use crate::control::codes::Function;
use crate::sentences::{Language, labels};
use crate::setup::{Side, ToolKind};

/// What is printed on a card.
pub(super) struct Words {
    pub card: &'static str,
    pub name: &'static str,
    pub date: &'static str,
    pub control: &'static str,
    pub blank: &'static str,
    pub length: &'static str,
    pub bore: &'static str,
    pub face: &'static str,
    pub inferred: &'static str,
    pub tools: &'static str,
    pub tool: &'static str,
    pub kind: &'static str,
    pub nose: &'static str,
    pub tip: &'static str,
    pub speed_and_feed: &'static str,
    pub time: &'static str,
    pub total: &'static str,
    pub not_in_time: &'static str,
    pub program: &'static str,
    pub block: &'static str,
    pub does: &'static str,
    pub remark: &'static str,
    /// After a number: rpm, m/min, mm/rev, mm/min.
    pub per_minute: &'static str,
    pub surface: &'static str,
    pub feed_per_turn: &'static str,
    pub feed_per_minute: &'static str,
    pub seconds: &'static str,
    /// With `{}` for a count.
    pub passes: &'static str,
    pub moves: &'static str,
    pub more_blocks: &'static str,
    pub offset: &'static str,
}

pub(super) fn words(language: Language) -> &'static Words {
    match language {
        Language::English => &EN,
        Language::Chinese => &ZH,
        Language::Russian => &RU,
    }
}

/// What one code of several with the same function does: `index` counts the codes of its
/// row in the table of codes.
pub(super) fn one_of(function: Function, index: usize, language: Language) -> Option<String> {
    let [en, zh, ru] = match (function, index) {
        (Function::Spindle, 0) => ["spindle forward", "主轴正转", "прямое вращение шпинделя"],
        (Function::Spindle, 1) => ["spindle reverse", "主轴反转", "обратное вращение шпинделя"],
        (Function::Spindle, 2) => ["spindle stop", "主轴停", "остановка шпинделя"],
        (Function::Coolant, 0 | 1) => ["coolant on", "切削液开", "включение СОЖ"],
        (Function::Coolant, 2) => ["coolant off", "切削液关", "выключение СОЖ"],
        (Function::Unit, 0) => ["inch", "英制", "дюймы"],
        (Function::Unit, 1) => ["metric", "公制", "миллиметры"],
        (Function::Feed, 0) => ["feed per minute", "每分钟进给", "минутная подача"],
        (Function::Feed, 1) => ["feed per revolution", "每转进给", "подача на оборот"],
        (Function::Distance, 0) => ["absolute words", "绝对值编程", "абсолютные размеры"],
        (Function::Distance, 1) => ["incremental words", "增量值编程", "размеры в приращениях"],
        (Function::Pause, 0) => ["program stop", "程序停止", "программируемый останов"],
        (Function::Pause, 1) => ["optional stop", "选择停止", "останов с подтверждением"],
        (Function::Plane, 0) => ["plane XY", "XY 平面", "плоскость XY"],
        (Function::Plane, 1) => ["plane ZX", "ZX 平面", "плоскость ZX"],
        (Function::Plane, 2) => ["plane YZ", "YZ 平面", "плоскость YZ"],
        (Function::Frame, _) => {
            let number = index + 1;
            return Some(match language {
                Language::English => format!("work coordinates {number}"),
                Language::Chinese => format!("工件坐标系 {number}"),
                Language::Russian => format!("система координат детали {number}"),
            });
        }
        _ => return None,
    };
    let text = match language {
        Language::English => en,
        Language::Chinese => zh,
        Language::Russian => ru,
    };
    Some(text.to_owned())
}

/// The name of a kind of tool, with the side it works on where that is not the outside.
pub(super) fn tool_kind(kind: ToolKind, side: Side, language: Language) -> String {
    let [english, chinese, russian] = match (kind, side) {
        (ToolKind::Grooving | ToolKind::Threading, Side::Inside) => [", inside", "（内）", ", внутренний"],
        (ToolKind::Grooving | ToolKind::Threading, Side::Face) => [", face", "（端面）", ", торцовый"],
        _ => ["", "", ""],
    };
    let side = match language {
        Language::English => english,
        Language::Chinese => chinese,
        Language::Russian => russian,
    };
    [labels::tool_kind(kind, language), side].concat()
}

static EN: Words = Words {
    card: "Setup sheet",
    name: "Name",
    date: "Date",
    control: "Control",
    blank: "Blank",
    length: "length",
    bore: "bore",
    face: "face at Z",
    inferred: "inferred from the program",
    tools: "Tools",
    tool: "Tool",
    kind: "Kind",
    nose: "Nose radius",
    tip: "Tip",
    speed_and_feed: "Speed and feed",
    time: "Time",
    total: "Whole program",
    not_in_time: "Moves whose speed is not known are not included in the time: {}.",
    program: "Program",
    block: "Block",
    does: "What it does",
    remark: "Remark",
    per_minute: "rpm",
    surface: "m/min",
    feed_per_turn: "mm/rev",
    feed_per_minute: "mm/min",
    seconds: "s",
    passes: "{} passes",
    moves: "{} moves",
    more_blocks: "… and {} more blocks",
    offset: "offset",
};

static ZH: Words = Words {
    card: "数控加工程序单",
    name: "姓名",
    date: "日期",
    control: "数控系统",
    blank: "毛坯",
    length: "长度",
    bore: "内孔",
    face: "端面 Z",
    inferred: "由程序推测",
    tools: "刀具",
    tool: "刀具号",
    kind: "类型",
    nose: "刀尖圆弧半径",
    tip: "刀尖方位",
    speed_and_feed: "转速与进给",
    time: "时间",
    total: "整个程序",
    not_in_time: "时间不含速度未知的运动：{} 段。",
    program: "程序",
    block: "程序段",
    does: "说明",
    remark: "备注",
    per_minute: "r/min",
    surface: "m/min",
    feed_per_turn: "mm/r",
    feed_per_minute: "mm/min",
    seconds: "s",
    passes: "共 {} 次走刀",
    moves: "共 {} 段运动",
    more_blocks: "……还有 {} 个程序段",
    offset: "刀补",
};

static RU: Words = Words {
    card: "Карта наладки",
    name: "Фамилия",
    date: "Дата",
    control: "УЧПУ",
    blank: "Заготовка",
    length: "длина",
    bore: "отверстие",
    face: "торец на Z",
    inferred: "по программе, предположительно",
    tools: "Инструменты",
    tool: "Инструмент",
    kind: "Вид",
    nose: "Радиус вершины",
    tip: "Вершина",
    speed_and_feed: "Скорость и подача",
    time: "Время",
    total: "Вся программа",
    not_in_time: "Во времени не учтены перемещения с неизвестной скоростью: {}.",
    program: "Программа",
    block: "Кадр",
    does: "Что происходит",
    remark: "Примечание",
    per_minute: "об/мин",
    surface: "м/мин",
    feed_per_turn: "мм/об",
    feed_per_minute: "мм/мин",
    seconds: "с",
    passes: "проходов: {}",
    moves: "перемещений: {}",
    more_blocks: "… и ещё кадров: {}",
    offset: "коррекция",
};
