//! Describes codes with several meanings by their effect in a block.
//!
//! In: the function of a code, its block and the motions of the block. Out: a phrase for the setup sheet;
//! `None` if the general description of the code is sufficient.

use crate::assist::form::cycle_block;
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{Function, Multiple};
use crate::motion::{Motion, Step};
use crate::sentences::Language;
use crate::text::block::{Block, Value};

/// Tolerance for a level cut, mm.
const LEVEL: f64 = 1e-6;

/// The effect of the function in this block, whose motions are `own`.
pub(super) fn here(function: Function, block: &Block, own: &[Motion], language: Language) -> Option<String> {
    let is_first = |cycle: Multiple| cycle_block(cycle, block) == CycleBlock::First;
    let phrases = match function {
        Function::TurningCycle if is_taper(own, across)? => {
            ["turning cycle, taper", "锥面切削循环", "цикл точения конуса"]
        }
        Function::TurningCycle => ["turning cycle, straight", "圆柱面切削循环", "цикл точения цилиндра"],
        Function::ThreadingCycle if is_taper(own, across)? => {
            ["threading cycle, taper", "锥螺纹切削循环", "цикл нарезания конической резьбы"]
        }
        Function::ThreadingCycle => {
            ["threading cycle, straight", "圆柱螺纹切削循环", "цикл нарезания цилиндрической резьбы"]
        }
        Function::FacingCycle if is_taper(own, along)? => {
            ["facing cycle, taper", "锥形端面切削循环", "цикл подрезки конического торца"]
        }
        Function::FacingCycle => ["facing cycle, straight", "端面切削循环", "цикл подрезки прямого торца"],
        Function::RoughTurning if is_first(Multiple::RoughTurning) => {
            ["values for rough turning", "粗车循环参数", "параметры чернового точения"]
        }
        Function::RoughTurning => ["rough turning", "外（内）圆粗车循环", "черновое точение"],
        Function::RoughFacing if is_first(Multiple::RoughFacing) => {
            ["values for rough facing", "端面粗车循环参数", "параметры черновой обработки торца"]
        }
        Function::RoughFacing => ["rough facing", "端面粗车循环", "черновая обработка торца"],
        Function::Pattern if is_first(Multiple::Pattern) => {
            ["values for pattern repeating", "仿形循环参数", "параметры повторения контура"]
        }
        Function::FacePecking if is_first(Multiple::FacePecking) => {
            ["values for pecking", "啄式循环参数", "параметры прерывистого сверления"]
        }
        Function::FacePecking if has(block, b"XU") => {
            ["grooves in the face, pecking", "端面切槽循环", "канавки на торце с выводом"]
        }
        Function::FacePecking => ["peck drilling", "端面啄式钻孔循环", "сверление с выводом"],
        Function::Grooving if is_first(Multiple::Grooving) => {
            ["values for grooving", "切槽循环参数", "параметры точения канавок"]
        }
        Function::MultiThreading if is_first(Multiple::Threading) => {
            ["values for multi-pass threading", "复合螺纹循环参数", "параметры многопроходной резьбы"]
        }
        Function::Setting => return Some(setting(block, language)).filter(|text| !text.is_empty()),
        Function::Cylinder if is_zero(block, b'C') => {
            ["cylindrical interpolation off", "圆柱插补取消", "отмена цилиндрической интерполяции"]
        }
        Function::Cylinder => {
            ["cylindrical interpolation on", "圆柱插补开始", "включение цилиндрической интерполяции"]
        }
        Function::Drilling => ["drilling along Z", "Z 向钻孔", "сверление вдоль Z"],
        Function::CounterBoring => {
            ["drilling along Z with dwell", "Z 向钻孔，孔底暂停", "сверление вдоль Z с выдержкой"]
        }
        Function::FaceDrilling if has(block, b"Q") => {
            ["drilling along Z with pecks", "Z 向啄式钻孔", "сверление вдоль Z с выводом"]
        }
        Function::FaceDrilling => ["drilling along Z", "Z 向钻孔", "сверление вдоль Z"],
        Function::SideDrilling if has(block, b"Q") => {
            ["drilling along X with pecks", "X 向啄式钻孔", "сверление вдоль X с выводом"]
        }
        Function::SideDrilling => ["drilling along X", "X 向钻孔", "сверление вдоль X"],
        Function::BoringStop => {
            ["boring along Z, spindle stop", "Z 向镗孔，孔底主轴停", "растачивание вдоль Z, останов шпинделя"]
        }
        Function::LocalCall => {
            ["call of a part of the same program", "调用本程序中的一段", "вызов части той же программы"]
        }
        _ => return None,
    };
    Some(in_language(phrases, language))
}

/// Coordinates and limits of the spindle speed: one block can set all of them.
fn setting(block: &Block, language: Language) -> String {
    let parts: [(&[u8], [&str; 3]); 3] = [
        (b"XZUWC", ["set coordinates", "坐标系设定", "установка координат"]),
        (b"S", ["maximum spindle speed", "主轴最高转速", "наибольшая частота вращения шпинделя"]),
        (b"Q", ["minimum spindle speed", "主轴最低转速", "наименьшая частота вращения шпинделя"]),
    ];
    let said = parts.iter().filter(|(addresses, _)| has(block, addresses));
    said.map(|&(_, phrases)| in_language(phrases, language)).collect::<Vec<_>>().join(", ")
}

/// Whether the cut of a single cycle is a taper; `None` if there is no cut.
fn is_taper(own: &[Motion], rise: fn(&Motion) -> f64) -> Option<bool> {
    let cut = own.iter().find(|motion| motion.cycle.is_some_and(|step| step.step == Step::Cut))?;
    Some(rise(cut).abs() > LEVEL)
}

fn across(cut: &Motion) -> f64 {
    cut.to.x - cut.from.x
}

fn along(cut: &Motion) -> f64 {
    cut.to.z - cut.from.z
}

fn has(block: &Block, addresses: &[u8]) -> bool {
    block.words.iter().any(|word| !word.comma && addresses.contains(&word.address))
}

fn is_zero(block: &Block, address: u8) -> bool {
    block.words.iter().any(|word| {
        word.address == address
            && matches!(word.value, Value::Number { number, .. } if number.integer() == Some(0))
    })
}

pub(super) fn in_language([en, zh, ru]: [&str; 3], language: Language) -> String {
    let text = match language {
        Language::English => en,
        Language::Chinese => zh,
        Language::Russian => ru,
    };
    text.to_owned()
}
