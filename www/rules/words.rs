//! The fixed texts of the rule pages, in three languages.

use gcode_playground::message::Kind;
use gcode_playground::sentences::Language;

/// Fixed texts of the pages.
pub struct Words {
    pub own_name: &'static str,
    pub playground: &'static str,
    pub rules: &'static str,
    pub about: &'static str,
    pub languages: &'static str,
    pub what: &'static str,
    pub why: &'static str,
    pub repair: &'static str,
    pub example: &'static str,
    pub wrong: &'static str,
    pub right: &'static str,
    pub open: &'static str,
    pub setup: &'static str,
    pub nothing_drawn: &'static str,
    pub difference: &'static str,
    pub message: &'static str,
    pub code: &'static str,
    pub severity: &'static str,
    pub alarm: &'static str,
    pub off: &'static str,
    pub off_how: &'static str,
    pub off_program: &'static str,
    pub off_setup: &'static str,
    /// Headings of the index, by kind.
    pub kinds: [(Kind, &'static str); 3],
}

/// The texts of a language.
pub fn words(language: Language) -> &'static Words {
    match language {
        Language::English => &ENGLISH,
        Language::Chinese => &CHINESE,
        Language::Russian => &RUSSIAN,
    }
}

const ENGLISH: Words = Words {
    own_name: "English",
    playground: "G-code playground",
    rules: "All rules",
    about: "The messages of the playground about turning programs: what they mean, why they matter, how to fix the program.",
    languages: "Language",
    what: "What it looks at",
    why: "Why it matters",
    repair: "Repair",
    example: "Example",
    wrong: "Failing",
    right: "Corrected",
    open: "Open in the playground",
    setup: "Both programs run with this setup:",
    nothing_drawn: "Nothing moves in this program, so there is nothing to draw.",
    difference: "Marked: where the part differs from that of the corrected program.",
    message: "Message",
    code: "Code",
    severity: "Severity",
    alarm: "Alarm",
    off: "Switch it off, or change its severity",
    off_how: "`OFF` silences the rule; `INFO`, `WARNING` and `ERROR` change its severity.",
    off_program: "In the program, as a comment:",
    off_setup: "In the setup, for all programs:",
    kinds: [
        (Kind::Wrong, "Faults in the program"),
        (Kind::Unsupported, "Not supported here"),
        (Kind::Machine, "Depends on the machine"),
    ],
};

const CHINESE: Words = Words {
    own_name: "中文",
    playground: "G 代码演练场",
    rules: "全部规则",
    about: "本程序对车削程序给出的提示、其原因和改正方法。",
    languages: "语言",
    what: "检查什么",
    why: "为什么重要",
    repair: "如何改正",
    example: "示例",
    wrong: "有误的程序",
    right: "改正后的程序",
    open: "在演练场中打开",
    setup: "两个程序都使用以下设置：",
    nothing_drawn: "此程序没有任何移动，因此没有图形。",
    difference: "标记处：与修正后程序加工的零件不同的部分。",
    message: "提示",
    code: "代号",
    severity: "级别",
    alarm: "报警",
    off: "关闭规则或改变级别",
    off_how: "`OFF` 关闭此规则；`INFO`、`WARNING`、`ERROR` 把级别改为提示、警告、错误。",
    off_program: "在程序中，写成注释：",
    off_setup: "在设置中，对所有程序有效：",
    kinds: [(Kind::Wrong, "程序有误"), (Kind::Unsupported, "此处不支持"), (Kind::Machine, "取决于机床")],
};

const RUSSIAN: Words = Words {
    own_name: "Русский",
    playground: "Песочница G-кода",
    rules: "Все правила",
    about: "Что сообщается о токарной программе, почему и как это исправить.",
    languages: "Язык",
    what: "Что проверяется",
    why: "Почему это важно",
    repair: "Как исправить",
    example: "Пример",
    wrong: "С ошибкой",
    right: "Исправлено",
    open: "Открыть в песочнице",
    setup: "Обе программы выполняются с этой настройкой:",
    nothing_drawn: "В этой программе нет перемещений, рисовать нечего.",
    difference: "Отмечено, где деталь отличается от детали исправленной программы.",
    message: "Сообщение",
    code: "Код",
    severity: "Важность",
    alarm: "Сигнал",
    off: "Отключить правило или изменить его важность",
    off_how: "`OFF` отключает правило; `INFO`, `WARNING` и `ERROR` делают его примечанием, предупреждением, ошибкой.",
    off_program: "В программе, комментарием:",
    off_setup: "В настройках, для всех программ:",
    kinds: [
        (Kind::Wrong, "Ошибки в программе"),
        (Kind::Unsupported, "Здесь не поддерживается"),
        (Kind::Machine, "Зависит от станка"),
    ],
};
