//! Finds the signs of other controls and machines in the statements of a text.
//!
//! In: statements. Out: a [`Sign`] and its place for each finding. Must not know how signs are weighed.

use super::signs::Sign;
use super::statement::{Name, Statement, Word};
use crate::source::Span;

/// Number of moves in X and Y that counts as many.
const MANY_Y: u32 = 8;

/// Names that are a sign anywhere.
const NAMES: [(&str, Sign); 35] = [
    ("ENDW", Sign::EndWhile),
    ("DIAMON", Sign::DiameterMode),
    ("DIAMOF", Sign::DiameterMode),
    ("DIAM90", Sign::DiameterMode),
    ("GOTOF", Sign::SiemensWord),
    ("GOTOB", Sign::SiemensWord),
    ("MCALL", Sign::SiemensWord),
    ("STOPRE", Sign::SiemensWord),
    ("SETMS", Sign::SiemensWord),
    ("SUPA", Sign::SiemensWord),
    ("TRANSMIT", Sign::SiemensWord),
    ("TRACYL", Sign::SiemensWord),
    ("TRAFOOF", Sign::SiemensWord),
    ("FMAX", Sign::FeedMax),
    ("LBL", Sign::LabelWord),
    ("NOEX", Sign::OkumaWord),
    ("MODIN", Sign::OkumaWord),
    ("MODOUT", Sign::OkumaWord),
    ("VLMON", Sign::OkumaWord),
    // With `=`:
    ("LIMS", Sign::SpeedLimit),
    ("CR", Sign::NamedAddress),
    ("RND", Sign::NamedAddress),
    ("RNDM", Sign::NamedAddress),
    ("CHF", Sign::NamedAddress),
    ("CHR", Sign::NamedAddress),
    ("ANG", Sign::NamedAddress),
    ("SPOS", Sign::NamedAddress),
    ("FRC", Sign::NamedAddress),
    ("SB", Sign::LiveToolSpeed),
    ("VC1", Sign::VVariable),
    // With `(`:
    ("MSG", Sign::MessageCall),
    ("IC", Sign::IncrementCall),
    ("AC", Sign::IncrementCall),
    ("WORKPIECE", Sign::SiemensWord),
    ("WAITM", Sign::WaitMark),
];
/// Index from which a name of [`NAMES`] needs `=` after it.
const ASSIGNED: usize = 19;
/// Index from which a name of [`NAMES`] needs `(` after it.
const CALLED: usize = 30;

/// Two adjacent names that are a sign.
const PAIRS: [(&str, &str, Sign); 6] = [
    ("BEGIN", "PGM", Sign::ProgramFrame),
    ("END", "PGM", Sign::ProgramFrame),
    ("BLK", "FORM", Sign::Definition),
    ("CYCL", "DEF", Sign::Definition),
    ("TOOL", "CALL", Sign::ToolCall),
    ("CALL", "LBL", Sign::LabelWord),
];

/// Names after `O100` that make it a statement of LinuxCNC.
const O_STATEMENTS: [&str; 12] = [
    "SUB",
    "ENDSUB",
    "CALL",
    "RETURN",
    "IF",
    "ELSE",
    "ENDIF",
    "WHILE",
    "ENDWHILE",
    "DO",
    "REPEAT",
    "ENDREPEAT",
];

/// Beginnings of commands of CNCSimulator, after `$`.
const SIMULATOR: [&[u8]; 3] = [b"ADDREGPART", b"MESSAGE", b"ADDPART"];

/// Beginnings of remarks that are commands.
const REMARKS: [(&str, Sign); 13] = [
    ("(RPT N", Sign::RepeatBlocks),
    ("(GOTO N", Sign::JumpInBrackets),
    ("(GOTO P", Sign::JumpInBrackets),
    ("(IF P", Sign::IfInBrackets),
    ("(IF (P", Sign::IfInBrackets),
    ("(CALL ", Sign::CallInBrackets),
    ("(PCALL ", Sign::CallInBrackets),
    ("(SUB ", Sign::SubInBrackets),
    ("(RET)", Sign::ReturnInBrackets),
    ("(DEBUG,", Sign::ActiveRemark),
    ("(PRINT,", Sign::ActiveRemark),
    ("(LOG,", Sign::ActiveRemark),
    ("(MSG,", Sign::MessageRemark),
];

/// Finds the signs of statements in order.
#[derive(Clone, Debug, Default)]
pub struct Finder {
    /// Number of moves in X and Y in the statements before.
    y_moves: u32,
}

impl Finder {
    /// Passes every sign of a statement to `found`.
    pub fn look(&mut self, text: &[u8], statement: &Statement, mut found: impl FnMut(Sign, Span)) {
        if statement.after_semicolon {
            printer_remark(text, statement, &mut found);
        } else {
            heads(text, statement, &mut found);
            names(text, statement, &mut found);
            assignments(text, statement, &mut found);
            remark(text, statement, &mut found);
        }
        // A statement with names is prose or another language, and its words may have any meaning.
        if statement.names().is_empty() {
            other_lathes(statement, &mut found);
            linuxcnc(statement, &mut found);
            self.mill(statement, &mut found);
            printer(statement, &mut found);
            fanuc_lathe(statement, &mut found);
        }
    }

    #[inline(never)]
    fn mill(&mut self, statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
        let xy = statement.has_all(b"XY");
        if let Some(word) = statement.word(b'Y').filter(|word| !is_zero(word)) {
            found(Sign::MoveY, word.span);
        }
        if xy {
            self.y_moves += 1;
            if self.y_moves == MANY_Y {
                found(Sign::ManyY, statement.span);
            }
        }
        let change = statement.codes(b'M').any(|(code, _)| code == 60);
        if change && let Some(tool) = statement.word(b'T').filter(|word| digits_written(word) <= 2) {
            found(Sign::ToolChange, tool.span);
        }
        for (code, span) in statement.codes(b'G') {
            match code {
                20 | 30 if xy && statement.has_all(b"IJ") => found(Sign::ArcXy, span),
                170 => found(Sign::PlaneXy, span),
                280 if statement.has(b'Z') && statement.codes(b'G').any(|(other, _)| other == 910) => {
                    found(Sign::HomeZ, span);
                }
                410 | 420 if statement.has(b'D') => found(Sign::RadiusOffset, span),
                430 => {
                    if let Some(offset) = statement.word(b'H') {
                        found(Sign::ToolLength, span.to(offset.span));
                    }
                }
                490 => found(Sign::LengthCancel, span),
                730 | 810..=890 if xy && statement.has(b'Z') => found(Sign::HoleXy, span),
                _ => {}
            }
        }
    }
}

/// Program heads and other lines that are recognised by their first bytes.
#[inline(never)]
fn heads(text: &[u8], statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let line = statement.span.of(text);
    match line {
        [b'%', b'0'..=b'9', ..] => found(Sign::PercentNumber, statement.span),
        [b'%', b'_', b'n' | b'N', b'_', ..] => found(Sign::TransferHead, statement.span),
        [b'%', b'M' | b'm' | b'S' | b's', b'P' | b'p', b'F' | b'f', b'0'..=b'9', ..] => {
            found(Sign::TransferHead, statement.span);
        }
        [b'%', b'P' | b'T', b'M'] => found(Sign::PhilipsHead, statement.span),
        [b'%', ..] if holds(line, b",MX,") => found(Sign::FagorHead, statement.span),
        [b'$', .., b'%'] if line.contains(&b'.') => found(Sign::OkumaHead, statement.span),
        [b'$', b'1'..=b'9', rest @ ..] if !rest.first().is_some_and(u8::is_ascii_alphanumeric) => {
            found(Sign::PathHead, statement.span)
        }
        [b'$', name @ ..] if SIMULATOR.iter().any(|&one| begins(name, one)) => {
            found(Sign::SimulatorCommand, statement.span);
        }
        [b'!', b'L' | b'l', b'0'..=b'9', ..] | [b'!', b'0'..=b'9', b'L' | b'l', b'0'..=b'9', ..] => {
            found(Sign::PathWait, statement.span);
        }
        // `O<NAME>` alone is the name of a FANUC program.
        [b'o' | b'O', b'<', b'a'..=b'z' | b'A'..=b'Z' | b'_', rest @ ..] if has_text_after_name(rest) => {
            found(Sign::OWord, statement.span);
        }
        _ => {}
    }
    if let Some(span) = statement.named_variable {
        found(Sign::NamedVariable, span);
    }
}

#[inline(never)]
fn names(text: &[u8], statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let names = statement.names();
    for (at, name) in names.iter().enumerate() {
        let written = name.span.of(text);
        let is = |expected: &str| written.eq_ignore_ascii_case(expected.as_bytes());
        for (index, &(expected, sign)) in NAMES.iter().enumerate() {
            let shaped = match index {
                ..ASSIGNED => true,
                ASSIGNED..CALLED => name.assigned,
                _ => name.called,
            };
            if shaped && is(expected) {
                let behind = u32::from(index >= ASSIGNED);
                found(sign, Span { start: name.span.start, end: name.span.end + behind });
            }
        }
        if let Some(next) = names.get(at + 1) {
            for &(first, second, sign) in &PAIRS {
                if is(first) && next.span.of(text).eq_ignore_ascii_case(second.as_bytes()) {
                    found(sign, name.span.to(next.span));
                }
            }
        }
        numbered_name(written, name, statement, found);
        let o_word = statement.words().first().filter(|word| word.letter == b'O' && at == 0);
        if let Some(o_word) = o_word
            && O_STATEMENTS.iter().any(|statement| is(statement))
        {
            found(Sign::OWord, o_word.span.to(name.span));
        }
        if (is("TRANS") || is("ATRANS")) && statement.has_any(b"XZ") {
            found(Sign::FrameShift, name.span);
        }
    }
}

/// Names that are recognised by their beginning.
fn numbered_name(written: &[u8], name: &Name, statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let behind = |head: &str| {
        let (start, rest) = written.split_at_checked(head.len())?;
        start.eq_ignore_ascii_case(head.as_bytes()).then_some(rest)
    };
    let number = |rest: &[u8]| (2..=3).contains(&rest.len()) && rest.iter().all(u8::is_ascii_digit);
    if behind("CYCLE").is_some_and(number) {
        found(if name.called { Sign::CycleCall } else { Sign::CycleName }, name.span);
    }
    if behind("LCYC").is_some_and(number) {
        found(Sign::CycleName, name.span);
    }
    if behind("NAT").is_some_and(number) {
        found(Sign::NamedSequence, name.span);
    }
    if name.assigned && (behind("VZSH").is_some() || behind("VZOF").is_some()) {
        found(Sign::ZeroVariable, name.span);
    }
    let lap = |(code, _): (u32, Span)| (850..=880).contains(&code);
    if behind("N").is_some_and(|rest| rest.len() >= 2) && statement.codes(b'G').any(lap) {
        found(Sign::LapCall, name.span);
    }
}

/// `R1=`, `X=R1`, `T="…"`, `P1=K20`, `V1=` and `L X+10`.
#[inline(never)]
fn assignments(text: &[u8], statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let words = statement.words();
    for (at, word) in words.iter().enumerate() {
        let next = words.get(at + 1);
        let next_is = |letter| next.is_some_and(|next| next.letter == letter && next.number.is_some());
        match (word.letter, word.number.is_some(), word.assigned) {
            (b'R', true, true) => found(Sign::RParameter, word.span),
            (b'X' | b'Z', false, true) if next_is(b'R') => found(Sign::AxisFromR, word.span),
            (b'T', false, true) if text.get(word.span.end as usize) == Some(&b'"') => {
                found(Sign::ToolByName, word.span);
            }
            (b'P', true, true) if next_is(b'K') => found(Sign::ParameterK, word.span),
            (b'V', true, true) => found(Sign::VVariable, word.span),
            (b'S', true, true) if word.span.len() == 3 => found(Sign::SpindleSpeed, word.span),
            (b'L', false, false) if next.is_some_and(|next| next.signed && is_axis(next)) => {
                found(Sign::LineMove, word.span);
            }
            _ => {}
        }
    }
}

#[inline(never)]
fn remark(text: &[u8], statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let Some(span) = statement.remark else { return };
    let written = span.of(text);
    for &(expected, sign) in &REMARKS {
        let head = written.get(..expected.len());
        if head.is_some_and(|head| head.eq_ignore_ascii_case(expected.as_bytes())) {
            // `(CALL THE FOREMAN)` is prose: in a statement a number follows.
            let next = written.get(expected.len());
            let numbered = sign == Sign::ReturnInBrackets || sign.weight() == Sign::ActiveRemark.weight();
            if numbered || sign == Sign::MessageRemark || next.is_some_and(u8::is_ascii_digit) {
                found(sign, span);
            }
        }
    }
    if let [b'(', b'P' | b'p', rest @ ..] = written {
        let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        if digits > 0 && rest.get(digits) == Some(&b'=') {
            found(Sign::ParameterInBrackets, span);
        }
    }
}

/// Cycles and modes of HNC and GSK928, and blocks that only Siemens has.
#[inline(never)]
fn other_lathes(statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let has_no = |letters: &[u8]| !statement.has_any(letters);
    let xz = statement.has_all(b"XZ");
    // A drill is at X0; a hole cycle has R or Q, or a place off the axis.
    let turning = xz && has_no(b"RQYCBH") && !statement.word(b'X').is_some_and(is_zero);
    let alone = statement.codes(b'G').count() == 1 && has_no(b"MT");
    for (code, span) in statement.codes(b'G') {
        match code {
            710..=730 if xz && statement.has_all(b"PQR") => found(Sign::OneLineRoughing, span),
            710..=730 if is_one_line_without_axes(statement) => {
                found(if statement.has(b'E') { Sign::OneLineRecess } else { Sign::OneLineShort }, span);
            }
            710 if xz && statement.has_all(b"BDHF") && has_no(b"PQ") => found(Sign::ThreadByBdh, span),
            1090 if statement.has(b'L') => found(Sign::Turret, span),
            710 | 720 if statement.has_all(b"IKL") && statement.has_any(b"XZ") && has_no(b"PQ") => {
                found(Sign::RoughingIkl, span);
            }
            760 if xz && statement.has_all(b"CAK") => found(Sign::OneLineThread, span),
            800..=820 if turning && alone && statement.has_all(b"IK") => {
                found(Sign::CycleIk, span);
                if statement.has_any(b"LA") {
                    found(Sign::CycleIkl, span);
                }
            }
            800 if turning && alone && statement.has(b'F') => found(Sign::TurningG80, span),
            810 if turning && alone => found(Sign::FacingG81, span),
            820 if turning && alone => found(Sign::ThreadingG82, span),
            660 | 680 | 690 if statement.has_all(b"XZCSE") && has_no(b"P") => found(Sign::ContourSe, span),
            810 | 820 if statement.has_all(b"XZQRCL") && has_no(b"P") => found(Sign::SectionQrcl, span),
            360 if xz && statement.has(b'R') => found(Sign::RoundingG36, span),
            360 if is_bare(statement) => found(Sign::DiametersG36, span),
            370 if is_bare(statement) => found(Sign::RadiiG37, span),
            2900 | 2910 => found(Sign::LanguageSwitch, span),
            _ => {}
        }
    }
    if let Some(tool) = statement.word(b'T').filter(|word| digits_written(word) == 6) {
        found(Sign::SixDigitTool, tool.span);
    }
    if let Some((170, span)) = statement.codes(b'M').next()
        && is_bare(statement)
        && has_no(b"G")
    {
        found(Sign::M17Alone, span);
    }
}

#[inline(never)]
fn linuxcnc(statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    for (code, span) in statement.codes(b'G') {
        match code {
            70 if !statement.has_any(b"XYZC") => found(Sign::DiametersG7, span),
            80 if !statement.has_any(b"PXYZC") => found(Sign::RadiiG8, span),
            640 if statement.has(b'P') => found(Sign::PathTolerance, span),
            331 => found(Sign::RigidTap, span),
            330 if statement.has_all(b"ZK") && !statement.has(b'F') => found(Sign::ThreadByK, span),
            960 if statement.has_all(b"DS") => found(Sign::SpeedLimitD, span),
            760 if statement.has_all(b"PZIJK") => found(Sign::ThreadIjk, span),
            921..=923 => found(Sign::OffsetCancel, span),
            430 if !statement.has_any(b"HXYZ") => found(Sign::ToolTable, span),
            911 if !statement.has_any(b"XYZUW") => found(Sign::IncrementalCentres, span),
            930 => found(Sign::InverseTime, span),
            _ => {}
        }
    }
}

#[inline(never)]
fn printer(statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    for (code, span) in statement.codes(b'M') {
        let heat = statement.has(b'S') && statement.words().len() == 2;
        match code {
            1040 if heat => found(Sign::HeatNozzle, span),
            1090 if heat => found(Sign::AwaitNozzle, span),
            1400 if heat => found(Sign::HeatBed, span),
            1900 if heat => found(Sign::AwaitBed, span),
            820 | 830 if statement.words().len() == 1 => found(Sign::ExtruderMode, span),
            _ => {}
        }
    }
    for (code, span) in statement.codes(b'G') {
        match code {
            0 | 10 if statement.has_all(b"XYE") => found(Sign::Extrusion, span),
            920 if statement.has(b'E') && !statement.has_any(b"XZUW") => found(Sign::ExtruderZero, span),
            290 if statement.words().len() == 1 => found(Sign::BedLevel, span),
            _ => {}
        }
    }
}

#[inline(never)]
fn printer_remark(text: &[u8], statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    let Some(name) = statement.names().first().filter(|name| name.span.start == statement.span.start) else {
        return;
    };
    let written = name.span.of(text);
    if text.get(name.span.end as usize) == Some(&b':') && (written == b"LAYER" || written == b"FLAVOR") {
        found(Sign::Layer, name.span);
    }
}

/// Signs of a lathe with FANUC's words.
#[inline(never)]
fn fanuc_lathe(statement: &Statement, found: &mut impl FnMut(Sign, Span)) {
    if let Some(tool) = statement.word(b'T').filter(|word| digits_written(word) >= 3) {
        found(Sign::ToolWithOffset, tool.span);
    }
    let axes = statement.has_any(b"XZUW");
    let mut other_code = false;
    for (code, span) in statement.codes(b'G') {
        match code {
            960 => found(Sign::SurfaceSpeed, span),
            500 | 920 if statement.has(b'S') && !axes => found(Sign::SpeedClamp, span),
            280 | 300 if statement.has_any(b"UW") => found(Sign::HomeUw, span),
            121 | 1120 => found(Sign::Polar, span),
            700 if statement.has_all(b"PQ") => found(Sign::Finishing, span),
            710..=730
                if statement.has_all(b"PQ")
                    && statement.has_any(b"UW")
                    && !statement.has_any(b"XZ")
                    && !is_one_line_without_axes(statement) =>
            {
                found(Sign::Roughing, span);
            }
            760 if statement.word(b'P').is_some_and(|word| digits_written(word) >= 5) => {
                found(Sign::ThreadData, span);
            }
            920 | 940 if axes && statement.has(b'F') && !statement.has_any(b"YE") => {
                found(Sign::SingleCycle, span);
            }
            900 if statement.has_all(b"XZR") => found(Sign::SingleCycle, span),
            650 | 660 if statement.has(b'P') => found(Sign::MacroCall, span),
            _ => {}
        }
        other_code |= !matches!(code, 0 | 10..=30 | 170..=190 | 400..=420 | 530..=590 | 900..=990);
    }
    if let Some(word) = statement.words().iter().find(|word| matches!(word.letter, b'U' | b'W'))
        && !other_code
        && word.number.is_some()
    {
        found(Sign::Incremental, word.span);
    }
}

/// `G71 U R P Q`, possibly with E: depth and retract in the block that names the contour. There is no
/// allowance, or a second U.
fn is_one_line_without_axes(statement: &Statement) -> bool {
    let allowances = statement.words().iter().filter(|word| word.letter == b'U').count() > 1;
    statement.has_all(b"PQRU") && !statement.has_any(b"XZD") && (allowances || !statement.has(b'W'))
}

/// Whether there are only the words G, M and N.
fn is_bare(statement: &Statement) -> bool {
    statement.words().iter().all(|word| matches!(word.letter, b'G' | b'M' | b'N'))
}

fn is_axis(word: &Word) -> bool {
    matches!(word.letter, b'X' | b'Y' | b'Z') && word.number.is_some()
}

/// Whether a word is like `X0`.
pub(super) fn is_zero(word: &Word) -> bool {
    word.number.is_some_and(|number| number.mantissa == 0)
}

/// Number of digits of a word, including leading zeros: 4 for `T0101`.
fn digits_written(word: &Word) -> u32 {
    word.number.map_or(0, |_| word.span.len().saturating_sub(1) as u32)
}

/// Whether a letter or `[` follows a name and its `>`.
fn has_text_after_name(rest: &[u8]) -> bool {
    let behind = rest.split(|&byte| byte == b'>').nth(1).unwrap_or_default();
    behind.trim_ascii_start().first().is_some_and(|&byte| byte.is_ascii_alphabetic() || byte == b'[')
}

fn begins(line: &[u8], head: &[u8]) -> bool {
    line.get(..head.len()).is_some_and(|start| start.eq_ignore_ascii_case(head))
}

fn holds(line: &[u8], part: &[u8]) -> bool {
    line.windows(part.len()).any(|window| window.eq_ignore_ascii_case(part))
}
