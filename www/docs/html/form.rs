//! Tables of the manual that come from the interpreter: the words of a code, and rows of codes.
//!
//! In: the name of a code as in G-code system A, a language. Out: HTML. The words of a cycle, a move or a call are those
//! of the help in the playground, so the manual cannot differ from it.

use std::fmt::Write;

use gcode_playground::api;
use gcode_playground::assist::form::Form;
use gcode_playground::assist::role::words_of;
use gcode_playground::control::codes::cycles::CycleBlock;
use gcode_playground::control::codes::role::Role;
use gcode_playground::control::codes::words::{Axes, CodeWord, WhenOmitted};
use gcode_playground::control::codes::{self, G, MotionMode, Plane};
use gcode_playground::sentences::Language;
use gcode_playground::setup::dialect::CodeList;

use super::site::escaped;

/// The words of the tables in a language.
struct Words {
    word: &'static str,
    meaning: &'static str,
    unit: &'static str,
    omitted: &'static str,
    blocks: [&'static str; 3],
    /// Missing, the axis stays, zero, as set before, optional.
    omissions: [&'static str; 5],
    units: [&'static str; Unit::COUNT],
}

const WORDS: [Words; 3] = [
    Words {
        word: "Word",
        meaning: "Meaning",
        unit: "Unit",
        omitted: "If omitted",
        blocks: ["First block", "Second block", "One block (Series 10/11/15)"],
        omissions: ["required", "the axis does not move", "0", "as set before", "optional"],
        units: [
            "mm, diameter",
            "mm, radius",
            "mm",
            "0.001 mm",
            "mm/rev or mm/min",
            "mm/rev",
            "threads per inch",
            "r/min",
            "m/min",
            "°",
            "0.001°",
            "s",
            "ms",
            "number",
            "N number",
            "O number",
            "two digits each",
        ],
    },
    Words {
        word: "字",
        meaning: "含义",
        unit: "单位",
        omitted: "省略时",
        blocks: ["第一个程序段", "第二个程序段", "单程序段格式（10/11/15 系列）"],
        omissions: ["必须指定", "该轴不动", "0", "按前面的设定", "可省略"],
        units: [
            "mm，直径值",
            "mm，半径值",
            "mm",
            "0.001 mm",
            "mm/r 或 mm/min",
            "mm/r",
            "每英寸牙数",
            "r/min",
            "m/min",
            "°",
            "0.001°",
            "s",
            "ms",
            "数",
            "顺序号",
            "程序号",
            "各两位数字",
        ],
    },
    Words {
        word: "Слово",
        meaning: "Значение",
        unit: "Единица",
        omitted: "Если опущено",
        blocks: ["Первый кадр", "Второй кадр", "Один кадр (серии 10/11/15)"],
        omissions: ["обязательно", "ось не движется", "0", "как задано раньше", "необязательно"],
        units: [
            "мм, на диаметр",
            "мм, на радиус",
            "мм",
            "0.001 мм",
            "мм/об или мм/мин",
            "мм/об",
            "ниток на дюйм",
            "об/мин",
            "м/мин",
            "°",
            "0.001°",
            "с",
            "мс",
            "число",
            "номер кадра",
            "номер программы",
            "по две цифры",
        ],
    },
];

fn words(language: Language) -> &'static Words {
    match language {
        Language::English => &WORDS[0],
        Language::Chinese => &WORDS[1],
        Language::Russian => &WORDS[2],
    }
}

/// The unit of a word without a decimal point in a millimetre program, in the order of [`Words::units`].
#[derive(Clone, Copy)]
enum Unit {
    Diameter,
    Radius,
    Length,
    Increment,
    Feed,
    Lead,
    ThreadsPerInch,
    Speed,
    CuttingSpeed,
    Degrees,
    Millidegrees,
    Seconds,
    Milliseconds,
    Count,
    Sequence,
    Program,
    Digits,
}

impl Unit {
    const COUNT: usize = Self::Digits as usize + 1;

    /// The unit of a role. `letter`: depths are increments after P and Q and lengths after other letters.
    fn of(role: Role, letter: u8) -> Option<Self> {
        use Role::*;
        Some(match role {
            EndX | WayX | ViaX | ViaWayX | MachineX | OriginX | ShiftX | LocalX | CycleEndX | CycleWayX
            | PeckEndX | PeckWayX | ThreadEndX | ThreadWayX | HoleEndX | HoleWayX | HolePlaceX
            | AllowanceX => Self::Diameter,
            ArcCenterX | TaperX | ThreadTaper | PassDepth | ReliefX | PullOutAcross | CornerX
            | ThreadAllowance | BottomRelief => Self::Radius,
            ThreadHeight | FirstDepth | LeastDepth if matches!(letter, b'P' | b'Q' | b'D') => Self::Increment,
            Peck | StepOver | HolePeck if matches!(letter, b'P' | b'Q') => Self::Increment,
            ThreadHeight | FirstDepth | LeastDepth => Self::Radius,
            EndC | WayC | ViaC | HoleAngle | LineAngle | ThreadAngle => Self::Degrees,
            StartAngle => Self::Millidegrees,
            Feed => Self::Feed,
            Lead | LeadChange => Self::Lead,
            ThreadsPerInch => Self::ThreadsPerInch,
            SpindleSpeed | HighestSpeed | LowestSpeed => Self::Speed,
            CuttingSpeed => Self::CuttingSpeed,
            DwellSeconds => Self::Seconds,
            DwellMilliseconds | HoleDwell => Self::Milliseconds,
            ContourFirst | ContourLast | CalledSequence | ReturnsTo | BeginsAt => Self::Sequence,
            CalledProgram => Self::Program,
            PatternPasses | Starts | InfeedMethod | Repeats | CallRepeats | DataNumber | DataKind
            | DataTip | ReferencePoint | FrameNumber | FinishAfter | Argument => Self::Count,
            ThreadPacked | ToolAndOffset => Self::Digits,
            EndZ | EndY | WayZ | WayY | ViaZ | ViaWayZ | MachineZ | OriginZ | ShiftZ | LocalZ | CycleEndZ
            | CycleWayZ | PeckEndZ | PeckWayZ | ThreadEndZ | ThreadWayZ | HoleEndZ | HoleWayZ
            | HolePlaceZ | Chamfer | Rounding | ArcRadius | ArcCenterZ | ArcCenterC | ArcCenterY
            | CornerZ | TaperZ | PullOutAlong | Escape | AllowanceZ | ReliefZ | PeckRetract | RPoint
            | DataValue | DataRadius | CylinderRadius | PassDepthZ | Peck | StepOver | HolePeck => {
                Self::Length
            }
            _ => return None,
        })
    }
}

/// The words of a code in each block of its form. Systems and controls with the same words share a table, which names
/// the code in each of them.
pub fn table(code: &str, language: Language) -> Result<String, String> {
    let mut groups: Vec<(Vec<CodeList>, Blocks)> = Vec::new();
    for is_whole in [false, true] {
        for list in CodeList::ALL {
            let Some(Blocks(all)) = blocks(code, list) else { continue };
            let own = all.into_iter().filter(|(block, _)| (*block == WHOLE) == is_whole).collect();
            let blocks = Blocks(own);
            match groups.iter_mut().find(|(_, other)| other.key() == blocks.key()) {
                _ if blocks.0.is_empty() => {}
                Some((lists, _)) => lists.push(list),
                None => groups.push((vec![list], blocks)),
            }
        }
    }
    if groups.is_empty() {
        return Err(format!("`{code}` has no words"));
    }
    let mut out = String::new();
    for (lists, blocks) in &groups {
        write_group(&mut out, code, lists, blocks, words(language), language);
    }
    Ok(out)
}

/// The number of the one-block form in [`Words::blocks`].
const WHOLE: usize = 2;

/// The blocks of a form, each with its number in [`Words::blocks`], and their words.
struct Blocks(Vec<(usize, Vec<CodeWord>)>);

impl Blocks {
    /// A text that is the same for the same words.
    fn key(&self) -> String {
        let of = |(block, words): &(usize, Vec<CodeWord>)| {
            let words = words.iter().map(|word| {
                format!("{:?} {:?} {} {:?}", word.letters, word.roles, word.comma, word.otherwise)
            });
            format!("{block}: {}", words.collect::<Vec<_>>().join(", "))
        };
        self.0.iter().map(of).collect::<Vec<_>>().join("; ")
    }
}

/// The words of a code in a list of codes, given its name in system A; `None` if the list does not have it.
fn blocks(code: &str, list: CodeList) -> Option<Blocks> {
    let axes = Axes { surface: None, plane: Plane::Zx, c_axis: false };
    // Of a code without a signature, such as G10, all words.
    let shown = |words: &'static [CodeWord]| -> Vec<CodeWord> {
        let is_in_signature = |word: &&CodeWord| word.otherwise.is_some();
        let has_signature = words.iter().any(|word| is_in_signature(&word));
        words.iter().filter(|word| !has_signature || is_in_signature(word)).copied().collect()
    };
    let form = match code.strip_prefix('M') {
        Some(number) => {
            let number: u16 = number.parse().ok()?;
            Form::Call(codes::m_codes().find(|(own, ..)| *own == number)?.1)
        }
        None => {
            let own = codes::g_codes(CodeList::A).find(|(name, _)| name == code)?.1.code;
            codes::written(own, list)?;
            match own {
                G::Motion(MotionMode::Cycle(cycle)) if list == CodeList::Gsk => {
                    return Some(Blocks(vec![(0, shown(cycle.spec().on_gsk))]));
                }
                G::Motion(mode) => Form::Motion { mode, own: true },
                G::Hole(hole) => Form::Hole { hole, own: true },
                G::MacroCall(_) => Form::MacroCall,
                G::Multiple(cycle) => {
                    let all = [CycleBlock::First, CycleBlock::Second, CycleBlock::Whole];
                    let own = all.into_iter().enumerate();
                    let own = own.filter(|(_, block)| *block != CycleBlock::Whole || list != CodeList::Gsk);
                    let own = own.map(|(at, block)| (at, shown(cycle.spec().words(block))));
                    return Some(Blocks(own.filter(|(_, words)| !words.is_empty()).collect()));
                }
                other => Form::OneShot(other),
            }
        }
    };
    let words = shown(words_of(form, axes));
    (!words.is_empty()).then(|| Blocks(vec![(0, words)]))
}

fn write_group(
    out: &mut String,
    code: &str,
    lists: &[CodeList],
    blocks: &Blocks,
    words: &Words,
    language: Language,
) {
    let spelling = |list: CodeList| match code.starts_with('M') {
        true => code.to_owned(),
        false => {
            let own = codes::g_codes(CodeList::A).find(|(name, _)| name == code);
            own.and_then(|(_, own)| codes::written(own.code, list)).unwrap_or_default()
        }
    };
    let mut names: Vec<(String, Vec<&str>)> = Vec::new();
    for &list in lists {
        let own = spelling(list);
        match names.iter_mut().find(|(other, _)| *other == own) {
            Some((_, systems)) => systems.push(list.name()),
            None => names.push((own, vec![list.name()])),
        }
    }
    let names: Vec<String> = names
        .iter()
        .map(|(own, systems)| format!("<code lang=\"en\">{own}</code> {}", systems.join(", ")))
        .collect();
    out.push_str("<div class=\"table\" tabindex=\"0\">\n<table class=\"form\">\n");
    let _ = writeln!(out, "<caption>{}</caption>", names.join(" · "));
    let _ = writeln!(
        out,
        "<thead><tr><th>{}</th><th>{}</th><th>{}</th><th>{}</th></tr></thead>\n<tbody>",
        words.word, words.meaning, words.unit, words.omitted
    );
    for (block, own) in &blocks.0 {
        if blocks.0.len() > 1 || *block == WHOLE {
            let _ =
                writeln!(out, "<tr><th colspan=\"4\" scope=\"rowgroup\">{}</th></tr>", words.blocks[*block]);
        }
        for word in own {
            for (letter, role) in word.letters.iter().zip(word.roles) {
                let unit = Unit::of(*role, *letter).map_or("", |unit| words.units[unit as usize]);
                let omitted = word.otherwise.map_or("", |otherwise| match otherwise {
                    WhenOmitted::Missing => words.omissions[0],
                    WhenOmitted::Stays => words.omissions[1],
                    WhenOmitted::Zero => words.omissions[2],
                    WhenOmitted::AsSet => words.omissions[3],
                    WhenOmitted::Nothing => words.omissions[4],
                });
                let comma = if word.comma { "," } else { "" };
                let _ = writeln!(
                    out,
                    "<tr><td><code lang=\"en\">{comma}{}</code></td><td>{}</td><td>{unit}</td><td>{omitted}</td></tr>",
                    char::from(*letter),
                    escaped(role.words(language)),
                );
            }
        }
    }
    out.push_str("</tbody>\n</table>\n</div>\n");
}

/// The rows of codes, each with an anchor (`#g71`): its spelling in each list of codes, and its meaning.
pub fn rows(names: &[&str], language: Language) -> Result<String, String> {
    let table = api::codes(CodeList::A, language);
    let words = words(language);
    let mut out = "<div class=\"table\" tabindex=\"0\">\n<table class=\"codes\">\n<thead><tr>".to_owned();
    for list in CodeList::ALL {
        let _ = write!(out, "<th>{}</th>", list.name());
    }
    let _ = writeln!(out, "<th>{}</th></tr></thead>\n<tbody>", words.meaning);
    let mut found = Vec::new();
    for row in &table.rows {
        let own: Vec<&str> = names_of(&row.a).filter(|name| names.contains(name)).collect();
        let Some(first) = own.first() else { continue };
        found.extend(own.iter().copied());
        let _ = write!(out, "<tr id=\"{}\">", anchor(first));
        for (at, list) in CodeList::ALL.into_iter().enumerate() {
            let _ = write!(out, "<td><code lang=\"en\">{}</code>", row.printed(list));
            if at == 0 {
                for other in &own[1..] {
                    let _ = write!(out, "<a id=\"{}\"></a>", anchor(other));
                }
            }
            out.push_str("</td>");
        }
        let _ = writeln!(out, "<td>{}</td></tr>", escaped(row.does));
    }
    out.push_str("</tbody>\n</table>\n</div>\n");
    match names.iter().find(|name| !found.contains(name)) {
        Some(missing) => Err(format!("`{missing}` is not in the table of codes")),
        None => Ok(out),
    }
}

/// The codes of a row, such as `G96 G97`.
pub fn names_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '.')
        .filter(|name| !name.is_empty())
}

/// The anchor of a code: `g12-1` for `G12.1`.
pub fn anchor(code: &str) -> String {
    code.to_lowercase().replace('.', "-")
}
