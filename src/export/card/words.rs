//! Texts of the setup sheet in every language. A missing translation is a compile error.

use super::here::in_language;
use crate::control::codes::Function;
use crate::sentences::{Language, labels};
use crate::setup::{Side, ToolKind};

/// The texts of a sheet.
pub(super) struct Words {
    pub card: &'static str,
    pub name: &'static str,
    pub date: &'static str,
    pub control: &'static str,
    pub blank: &'static str,
    pub clamped: &'static str,
    pub start: &'static str,
    pub length: &'static str,
    pub bore: &'static str,
    pub face: &'static str,
    pub outline: &'static str,
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
    /// `{}` is replaced by the rate.
    pub rapids_assumed: &'static str,
    pub program: &'static str,
    pub block: &'static str,
    pub does: &'static str,
    pub remark: &'static str,
    /// Follows a number.
    pub per_minute: &'static str,
    pub seconds: &'static str,
    /// `{}` is replaced by a count.
    pub passes: &'static str,
    pub moves: &'static str,
    pub more_blocks: &'static str,
    pub more_tools: &'static str,
    /// Used in a sentence, before a number.
    pub its_tool: &'static str,
    pub offset: &'static str,
}

pub(super) fn words(language: Language) -> &'static Words {
    match language {
        Language::English => &EN,
        Language::Chinese => &ZH,
        Language::Russian => &RU,
    }
}

/// Describes one of several codes with the same function: `index` is its position in their row of the table.
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
        (Function::HoleReturn, 0) => {
            ["return to the initial level", "返回初始平面", "возврат к исходной плоскости"]
        }
        (Function::HoleReturn, 1) => ["return to the R point", "返回 R 点", "возврат к точке R"],
        (Function::Data, 0) => ["write offsets", "输入补偿数据", "запись коррекций"],
        (Function::Data, 1) => ["end of data", "补偿数据输入结束", "конец данных"],
        (Function::ModalMacro, 0) => [
            "macro call after every move",
            "宏程序模态调用",
            "вызов макропрограммы после каждого перемещения",
        ],
        (Function::ModalMacro, 1) => ["macro call off", "宏程序模态调用取消", "отмена вызова макропрограммы"],
        (Function::StrokeCheck, 0) => {
            ["stored stroke check on", "存储行程检测开", "проверка пределов хода вкл."]
        }
        (Function::StrokeCheck, 1) => {
            ["stored stroke check off", "存储行程检测关", "проверка пределов хода выкл."]
        }
        (Function::ExactStop, 0) => ["exact stop", "准确停止", "точный останов"],
        (Function::ExactStop, 1) => ["exact stop mode", "准确停止方式", "режим точного останова"],
        (Function::ExactStop, 2) => ["tapping mode", "攻丝方式", "режим метчика"],
        (Function::ExactStop, 3) => ["cutting mode", "切削方式", "режим резания"],
        (Function::SpindleCheck, 0) => {
            ["spindle speed check off", "主轴速度波动检测关", "контроль частоты вращения выкл."]
        }
        (Function::SpindleCheck, 1) => {
            ["spindle speed check on", "主轴速度波动检测开", "контроль частоты вращения вкл."]
        }
        (Function::Chuck, 0 | 2) => ["chuck clamp", "卡盘夹紧", "зажим патрона"],
        (Function::Chuck, 1 | 3) => ["chuck unclamp", "卡盘松开", "разжим патрона"],
        (Function::LiveTool, 0) => {
            ["live tool forward", "动力刀具正转", "прямое вращение приводного инструмента"]
        }
        (Function::LiveTool, 1) => {
            ["live tool reverse", "动力刀具反转", "обратное вращение приводного инструмента"]
        }
        (Function::ThreadPullOut, 0) => ["thread pull-out on", "螺纹倒角（退尾）打开", "сбег резьбы вкл."],
        (Function::ThreadPullOut, 1) => ["thread pull-out off", "螺纹倒角（退尾）关闭", "сбег резьбы выкл."],
        (Function::Tailstock, 0) => ["tailstock forward", "尾座前进", "задняя бабка вперёд"],
        (Function::Tailstock, 1) => ["tailstock back", "尾座后退", "задняя бабка назад"],
        (Function::CAxis, 0) => ["C axis connect", "C 轴连接", "ось C включить"],
        (Function::CAxis, 1) => ["C axis release", "C 轴释放", "ось C отключить"],
        (Function::Synchronous, 0) => [
            "spindle and live tool synchronous",
            "主轴与动力刀具同步",
            "синхронность шпинделя и приводного инструмента",
        ],
        (Function::Synchronous, 1) => {
            ["spindle and live tool synchronous off", "主轴与动力刀具同步取消", "отмена синхронности"]
        }
        (Function::Conveyor, 0) => ["chip conveyor forward", "排屑器前进", "конвейер стружки вперёд"],
        (Function::Conveyor, 1) => ["chip conveyor stop", "排屑器停止", "конвейер стружки стоп"],
        (Function::Interlock, 0) => {
            ["tailstock interlock off", "尾座联锁关闭", "блокировка задней бабки снята"]
        }
        (Function::Interlock, 1) => {
            ["tailstock interlock on", "尾座联锁恢复", "блокировка задней бабки включена"]
        }
        (Function::Off, 0) => ["look-ahead off", "取消预读", "предварительный просмотр выкл."],
        (Function::Off, 1) => {
            ["tool length offset off", "取消刀具长度补偿", "отмена коррекции на длину инструмента"]
        }
        (Function::Off, 2) => ["polygon turning off", "取消多边形车削", "отмена точения многогранника"],
        (Function::Off, 3) => ["mirror image off", "取消镜像", "отмена зеркальной обработки"],
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
    Some(in_language([en, zh, ru], language))
}

/// The name of a kind of tool, with its working side if that is not the outside.
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
    clamped: "Clamping length",
    start: "Start of the tool",
    length: "length",
    bore: "bore",
    face: "face at Z",
    outline: "shape given by an outline",
    inferred: "inferred from the program",
    tools: "Tools",
    tool: "Tool",
    kind: "Kind",
    nose: "Nose radius",
    tip: "Tip",
    speed_and_feed: "Speed and feed",
    time: "Time",
    total: "Whole program",
    not_in_time: "Cuts whose speed is not known are not included in the time: {}.",
    rapids_assumed: "The setup gives no rapid traverse rate: {} is assumed.",
    program: "Program",
    block: "Block",
    does: "What it does",
    remark: "Remark",
    per_minute: "rpm",
    seconds: "s",
    passes: "{} passes",
    moves: "{} moves",
    more_blocks: "… and {} more blocks",
    more_tools: "… and {} more tools",
    its_tool: "tool",
    offset: "offset",
};

static ZH: Words = Words {
    card: "数控加工程序单",
    name: "姓名",
    date: "日期",
    control: "数控系统",
    blank: "毛坯",
    clamped: "夹持长度",
    start: "刀具起点",
    length: "长度",
    bore: "内孔",
    face: "端面 Z",
    outline: "形状由轮廓给出",
    inferred: "由程序推测",
    tools: "刀具",
    tool: "刀具号",
    kind: "类型",
    nose: "刀尖圆弧半径",
    tip: "刀尖方位",
    speed_and_feed: "转速与进给",
    time: "时间",
    total: "整个程序",
    not_in_time: "时间不含速度未知的切削：{} 段。",
    rapids_assumed: "设置中没有给出快移速度，按 {} 计算。",
    program: "程序",
    block: "程序段",
    does: "说明",
    remark: "备注",
    per_minute: "r/min",
    seconds: "s",
    passes: "共 {} 次走刀",
    moves: "共 {} 段运动",
    more_blocks: "……还有 {} 个程序段",
    more_tools: "……还有 {} 把刀具",
    its_tool: "刀具号",
    offset: "刀补",
};

static RU: Words = Words {
    card: "Карта наладки",
    name: "Фамилия",
    date: "Дата",
    control: "УЧПУ",
    blank: "Заготовка",
    clamped: "Длина зажима",
    start: "Исходная точка инструмента",
    length: "длина",
    bore: "отверстие",
    face: "торец на Z",
    outline: "форма задана контуром",
    inferred: "по программе, предположительно",
    tools: "Инструменты",
    tool: "Инструмент",
    kind: "Вид",
    nose: "Радиус вершины",
    tip: "Вершина",
    speed_and_feed: "Скорость и подача",
    time: "Время",
    total: "Вся программа",
    not_in_time: "Во времени не учтены рабочие ходы с неизвестной скоростью: {}.",
    rapids_assumed: "В наладке нет скорости ускоренного хода: взято {}.",
    program: "Программа",
    block: "Кадр",
    does: "Что происходит",
    remark: "Примечание",
    per_minute: "об/мин",
    seconds: "с",
    passes: "проходов: {}",
    moves: "перемещений: {}",
    more_blocks: "… и ещё кадров: {}",
    more_tools: "… и ещё инструментов: {}",
    its_tool: "инструмент",
    offset: "коррекция",
};
