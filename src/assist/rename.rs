//! Renames a number everywhere: a sequence number, a program or a variable, with all words that refer to it.
//!
//! In: a text, a place in it, the new number. Out: the edits, or the reason why the number cannot be
//! renamed. Needs no run: the caller compares the motions before and after.

use super::names::{Computed, Kind, Name, Named};
use super::uses::{all, first_computed, is_local, name_at};
use crate::message::Edit;
use crate::order;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::program_name;

/// The largest sequence number.
const LARGEST_SEQUENCE: u32 = 99_999;

/// The largest program number. P of M98 has the repeats before four digits.
const LARGEST_PROGRAM: u32 = 9_999;

/// Why a number cannot be renamed. Places are bytes of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// There is no number at the place.
    NothingHere,
    /// The program has a name instead of a number.
    ProgramName,
    /// A system variable, or one that is always vacant.
    SystemVariable,
    /// The new name is no number of this kind; an example of one.
    NotANumber(&'static str),
    /// The new number must be between these.
    OutOfRange(u32, u32),
    /// The new number is in use at this place.
    Taken(u32),
    /// The program computes a target of this kind at this place.
    Computed(u32),
    /// No block has the number, or no assignment sets the variable.
    NotDefined,
    /// The block may be in several programs; the place of a second one.
    SeveralPrograms(u32),
    /// The number at this place is written in a way that cannot be changed.
    Unclear(u32),
}

/// The number that can be renamed at a byte.
pub fn renamed_at(text: &[u8], codes: CodeList, byte: u32) -> Result<Named, Refusal> {
    let own = name_at(text, codes, byte).ok_or(Refusal::NothingHere)?;
    match own.name {
        Name::Program(number) if program_name::is_name(number) => Err(Refusal::ProgramName),
        name => range(name).map(|_| own),
    }
}

/// The edits that rename the number at a byte.
pub fn renamed(text: &[u8], codes: CodeList, byte: u32, new: &str) -> Result<Vec<Edit>, Refusal> {
    let own = renamed_at(text, codes, byte)?;
    let new = read(own.name, new)?;
    if new == own.name.number() {
        return Ok(Vec::new());
    }
    let scope = Scope::of(text, codes, own)?;
    scope.refuse_taken(text, codes, with_number(own.name, new))?;
    scope.refuse_computed(text, codes, own.name.kind())?;
    let mut edits = scope.places.iter().map(|named| edit(text, named, new)).collect::<Result<Vec<_>, _>>()?;
    order::by_key(&mut edits, |edit| edit.span.start);
    Ok(edits)
}

/// The name with another number.
fn with_number(name: Name, number: u32) -> Name {
    match name {
        Name::Sequence(_) => Name::Sequence(number),
        Name::Program(_) => Name::Program(number),
        Name::Variable(_) => Name::Variable(number),
    }
}

/// The numbers that a name can be changed to. Variables stay in their group: local, common, or kept at
/// power-off.
fn range(name: Name) -> Result<(u32, u32), Refusal> {
    match name {
        Name::Sequence(_) => Ok((1, LARGEST_SEQUENCE)),
        Name::Program(number) => Ok((1, LARGEST_PROGRAM.max(number))),
        Name::Variable(number) => match number {
            1..=33 => Ok((1, 33)),
            100..=499 => Ok((100, 499)),
            500..=999 => Ok((500, 999)),
            _ => Err(Refusal::SystemVariable),
        },
    }
}

/// Reads a new name: a number, with or without its letter.
fn read(name: Name, new: &str) -> Result<u32, Refusal> {
    let (letters, example) = match name.kind() {
        Kind::Sequence => (['N', 'P'], "N20"),
        Kind::Program => (['O', 'P'], "O2000"),
        Kind::Variable => (['#', '#'], "#101"),
    };
    let new = new.trim();
    let digits =
        new.strip_prefix(|letter: char| letters.contains(&letter.to_ascii_uppercase())).unwrap_or(new);
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if !is_number {
        return Err(Refusal::NotANumber(example));
    }
    let (least, most) = range(name)?;
    let number = digits.parse().ok().filter(|number| (least..=most).contains(number));
    number.ok_or(Refusal::OutOfRange(least, most))
}

/// Where a name is valid, and its places there.
struct Scope {
    /// The index of the program in the text; `None` for a name that all programs share.
    program: Option<u32>,
    /// Whether a return from another program refers to the name.
    has_returns: bool,
    places: Vec<Named>,
}

impl Scope {
    fn of(text: &[u8], codes: CodeList, own: Named) -> Result<Self, Refusal> {
        let found = all(text, codes, own.name);
        if !is_local(own.name) {
            let places = found.into_iter().map(|(named, _)| named).collect();
            return Ok(Self { program: None, has_returns: false, places });
        }
        let program = program_of(&found, own)?;
        let has_returns = found.iter().any(|(named, _)| named.scope.is_elsewhere());
        let others = |(named, of): &&(Named, u32)| named.defines && *of != program;
        if let Some((other, _)) = found.iter().find(others).filter(|_| has_returns) {
            return Err(Refusal::SeveralPrograms(other.span.start));
        }
        let places = found.into_iter().filter(|(named, of)| *of == program || named.scope.is_elsewhere());
        Ok(Self { program: Some(program), has_returns, places: places.map(|(named, _)| named).collect() })
    }

    /// Whether a place in a program belongs to the scope.
    fn has(&self, program: u32, anywhere: bool) -> bool {
        self.program.is_none_or(|own| own == program) || anywhere || self.has_returns
    }

    fn refuse_taken(&self, text: &[u8], codes: CodeList, new: Name) -> Result<(), Refusal> {
        let mut found = all(text, codes, new).into_iter();
        match found.find(|(named, program)| self.has(*program, named.scope.is_elsewhere())) {
            Some((named, _)) => Err(Refusal::Taken(named.span.start)),
            None => Ok(()),
        }
    }

    fn refuse_computed(&self, text: &[u8], codes: CodeList, kind: Kind) -> Result<(), Refusal> {
        let is_here =
            |found: &Computed, program| found.kind == kind && self.has(program, found.scope.is_elsewhere());
        match first_computed(text, codes, is_here) {
            Some(found) => Err(Refusal::Computed(found.span.start)),
            None => Ok(()),
        }
    }
}

/// The program that defines a local name.
fn program_of(found: &[(Named, u32)], own: Named) -> Result<u32, Refusal> {
    let defining = |is_meant: &dyn Fn(u32) -> bool| {
        found.iter().find(|(named, program)| named.defines && is_meant(*program)).map(|(_, program)| *program)
    };
    let own_program = found.iter().find(|(named, _)| named.span == own.span).map(|(_, program)| *program);
    let own_program = own_program.ok_or(Refusal::NothingHere)?;
    let defined_here = defining(&|program| program == own_program);
    let defined_elsewhere = || if own.scope.is_elsewhere() { defining(&|_| true) } else { None };
    defined_here.or_else(defined_elsewhere).ok_or(Refusal::NotDefined)
}

/// The edit of one place: the digits of the number, with as many leading zeros as needed for the same width.
fn edit(text: &[u8], named: &Named, new: u32) -> Result<Edit, Refusal> {
    let unclear = Refusal::Unclear(named.span.start);
    let digits = digits(text, named.span).ok_or_else(|| unclear.clone())?;
    let written = digits.quote(text);
    let is_call_with_repeats = !named.defines && named.name.kind() == Kind::Program && written.len() > 4;
    let (kept, own) = written.split_at(if is_call_with_repeats { written.len() - 4 } else { 0 });
    let is_own = own.parse() == Ok(named.name.number());
    let fits = kept.is_empty() || new <= LARGEST_PROGRAM;
    if !is_own || !fits {
        return Err(unclear);
    }
    let width = if own.starts_with('0') || !kept.is_empty() { own.len() } else { 0 };
    Ok(Edit { span: digits, text: format!("{kept}{new:0width$}") })
}

/// The first digits in a span.
fn digits(text: &[u8], span: Span) -> Option<Span> {
    let (bytes, start) = (span.of(text), span.start as usize);
    let first = bytes.iter().position(u8::is_ascii_digit)?;
    let count = bytes[first..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    Some(Span::new(start + first, start + first + count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::applied;

    /// Renames the number at the mark `$0`.
    fn rename(marked: &str, new: &str) -> Result<String, Refusal> {
        let byte = marked.find("$0").expect("a mark") as u32;
        let text = marked.replace("$0", "");
        let edits = renamed(text.as_bytes(), CodeList::A, byte, new)?;
        Ok(String::from_utf8(applied(text.as_bytes(), &edits)).expect("UTF-8"))
    }

    #[track_caller]
    fn renames(marked: &str, new: &str, after: &str) {
        assert_eq!(rename(marked, new).as_deref(), Ok(after));
    }

    #[test]
    fn all_words_that_refer_to_a_block_follow() {
        renames(
            "O1\nG71 P10 Q20\nN$010 X1\nGOTO 10\nIF[#1EQ2]GOTO10\nN20 X2 (N10)\nG70 P10 Q20\nM30\nO2\nN10\nM99 P11\n",
            "N15",
            "O1\nG71 P15 Q20\nN15 X1\nGOTO 15\nIF[#1EQ2]GOTO15\nN20 X2 (N10)\nG70 P15 Q20\nM30\nO2\nN10\nM99 P11\n",
        );
        renames("O1\nM98 P2\nN$030 X1\nM30\nO2\nM99 P30\n", "40", "O1\nM98 P2\nN40 X1\nM30\nO2\nM99 P40\n");
        renames("O1\nM98 P2\nN30 X1\nM30\nO2\nM99 P$030\n", "40", "O1\nM98 P2\nN40 X1\nM30\nO2\nM99 P40\n");
        renames("G65 H80 P$010\nN0010 X1\nM30\n", "N7", "G65 H80 P7\nN0007 X1\nM30\n");
        renames("/GOTO 10\nN$010 M30\n", "1", "/GOTO 1\nN1 M30\n");
    }

    #[test]
    fn calls_of_a_program_follow_with_their_repeats() {
        renames(
            "O1\nM98 P2000\nM98 P32000\nG65 P2000 A1\nM30\nO$02000\nM99\n",
            "O0021",
            "O1\nM98 P21\nM98 P30021\nG65 P21 A1\nM30\nO21\nM99\n",
        );
        renames("O0001\nM98 P$00002\nM30\nO0002\nM99\n", "3", "O0001\nM98 P0003\nM30\nO0003\nM99\n");
    }

    #[test]
    fn a_variable_stays_in_its_group_and_program() {
        renames(
            "O1\n#$01=2\nG1 X[#1*#10]\nM30\nO2\n#1=3\nM99\n",
            "#2",
            "O1\n#2=2\nG1 X[#2*#10]\nM30\nO2\n#1=3\nM99\n",
        );
        renames("O1\n#100=2\nM30\nO2\n#3=#$0100\nM99\n", "101", "O1\n#101=2\nM30\nO2\n#3=#101\nM99\n");
        assert_eq!(rename("#$01=2\nM30\n", "#100"), Err(Refusal::OutOfRange(1, 33)));
        assert_eq!(rename("#$05041=2\nM30\n", "#100"), Err(Refusal::SystemVariable));
    }

    #[test]
    fn what_cannot_be_renamed_is_refused() {
        for (marked, new, refusal) in [
            ("G1 X$01\n", "5", Refusal::NothingHere),
            ("N$010 X1\n", "ten", Refusal::NotANumber("N20")),
            ("N$010 X1\n", "", Refusal::NotANumber("N20")),
            ("N$010 X1\n", "N0", Refusal::OutOfRange(1, 99_999)),
            ("N$010 X1\n", "99999999999", Refusal::OutOfRange(1, 99_999)),
            ("N$010 X1\nN20 X2\n", "20", Refusal::Taken(7)),
            ("N$010 X1\nGOTO 20\n", "20", Refusal::Taken(12)),
            ("N$010 X1\nGOTO #1\n", "20", Refusal::Computed(11)),
            ("N$010 X1\nG71 P#1 Q20\n", "30", Refusal::Computed(11)),
            ("O1\nN$010 X1\nM30\nO2\nM99 P#1\n", "30", Refusal::Computed(21)),
            ("M98 P#1\nO$02\nM99\n", "3", Refusal::Computed(4)),
            ("#$01=2\n#[#1]=3\n", "#2", Refusal::Computed(5)),
            ("GOTO $010\nM30\n", "20", Refusal::NotDefined),
            ("G1 X#$01\nM30\n", "2", Refusal::NotDefined),
            ("O1\nN10 M30\nO2\nN10\nM99 P$010\n", "20", Refusal::SeveralPrograms(3)),
            ("<SHA$0FT>\nM30\n", "2", Refusal::ProgramName),
        ] {
            assert_eq!(rename(marked, new), Err(refusal), "{marked:?}");
        }
        // A computed target of another kind, or in another program, does not matter.
        renames(
            "O1\nN$010 M98 P#1\nM30\nO2\nGOTO #1\nM99\n",
            "20",
            "O1\nN20 M98 P#1\nM30\nO2\nGOTO #1\nM99\n",
        );
        renames("N$010 M30\n", "N10", "N10 M30\n");
    }
}
