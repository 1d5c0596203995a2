//! Workshop terms in many languages, and designations of inserts.
//!
//! In: a comment in capitals. Out: a kind of tool, a side of the workpiece, the tool of an insert's
//! designation.

use crate::setup::{Side, Tool, ToolKind};
use ToolKind::{Boring, Drill, Endmill, Grooving, Tap, Threading, Turning};

/// How a term matches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatchKind {
    /// One or several whole words: `TAP`.
    Word,
    /// The beginning of a word: `GROOV` for GROOVE and GROOVING.
    Stem,
    /// Anywhere: in scripts without spaces, and within compounds.
    Part,
}
use MatchKind::{Part, Stem, Word};

/// Terms and the kind of tool they name. The first match is used, so a term that is part of a longer one
/// comes after it. A term with `None` names the work, not the tool. Some terms are written as found in
/// programs: misspelt, mis-encoded or transliterated.
#[rustfmt::skip]
pub const KINDS: &[(MatchKind, &str, Option<ToolKind>)] = &[
    // Not tools.
    (Stem, "THREAD RELIEF", None), (Stem, "THREAD BUR", None),
    (Stem, "CENTER OF", None), (Stem, "CUT OFF LENGTH", None), (Part, "退刀槽", None), (Stem, "TURNING TOOL CHANGE", None),
    // Live cutters.
    (Stem, "ENDMILL", Some(Endmill)), (Stem, "END MILL", Some(Endmill)), (Stem, "THREADMILL", Some(Endmill)),
    (Stem, "THREAD MILL", Some(Endmill)), (Stem, "MILL", Some(Endmill)), (Stem, "FRESA", Some(Endmill)),
    (Stem, "FRAISE", Some(Endmill)), (Part, "FRÄSER", Some(Endmill)), (Part, "FRAESER", Some(Endmill)), (Stem, "ФРЕЗ", Some(Endmill)),
    (Part, "铣", Some(Endmill)), (Part, "銑", Some(Endmill)),
    // Taps, before threads and drills.
    (Word, "TAP", Some(Tap)), (Word, "TAPPING", Some(Tap)), (Part, "GEWINDEBOHR", Some(Tap)), (Stem, "MACHO", Some(Tap)),
    (Stem, "MASCHI", Some(Tap)), (Stem, "TARAUD", Some(Tap)), (Stem, "МЕТЧИК", Some(Tap)), (Part, "丝锥", Some(Tap)),
    (Part, "絲錐", Some(Tap)), (Part, "丝攻", Some(Tap)), (Part, "攻丝", Some(Tap)), (Part, "攻牙", Some(Tap)),
    // Threading tools.
    (Stem, "THREAD", Some(Threading)), (Stem, "THRD", Some(Threading)), (Part, "GEWINDE", Some(Threading)),
    (Stem, "ROSCA", Some(Threading)), (Stem, "ROSQUEA", Some(Threading)), (Stem, "FILET", Some(Threading)),
    (Stem, "РЕЗЬБ", Some(Threading)), (Part, "螺纹", Some(Threading)), (Part, "螺紋", Some(Threading)), (Part, "牙刀", Some(Threading)),
    // Boring bars, before drills.
    (Part, "BOHRST", Some(Boring)), (Part, "AUSDREH", Some(Boring)), (Part, "INNENDREH", Some(Boring)),
    (Stem, "BORING", Some(Boring)), (Word, "BORE", Some(Boring)), (Word, "BB", Some(Boring)), (Stem, "MANDRIN", Some(Boring)),
    (Stem, "MANDRIL", Some(Boring)), (Stem, "ALESA", Some(Boring)), (Stem, "ALÉSA", Some(Boring)), (Stem, "BARENO", Some(Boring)),
    (Stem, "РАСТОЧ", Some(Boring)), (Part, "镗", Some(Boring)), (Part, "鏜", Some(Boring)), (Part, "内孔", Some(Boring)), (Part, "內孔", Some(Boring)),
    // Drills.
    (Part, "DRILL", Some(Drill)), (Stem, "WIERT", Some(Drill)), (Stem, "SVERL", Some(Drill)), (Stem, "VRTAK", Some(Drill)),
    (Stem, "VRTÁK", Some(Drill)), (Stem, "MATKAP", Some(Drill)), (Stem, "MATA BOR", Some(Drill)), (Part, "ドリル", Some(Drill)), (Word, "SPOT", Some(Drill)), (Stem, "CSINK", Some(Drill)), (Stem, "COUNTERSINK", Some(Drill)),
    (Stem, "REAMER", Some(Drill)), (Part, "BOHRER", Some(Drill)), (Part, "BOHREN", Some(Drill)), (Part, "ZENTRIER", Some(Drill)),
    (Stem, "BROCA", Some(Drill)), (Stem, "FURAC", Some(Drill)), (Stem, "FURAÇ", Some(Drill)), (Stem, "FURAA", Some(Drill)),
    (Stem, "FURAR", Some(Drill)), (Word, "FURO", Some(Drill)), (Word, "FÚRÓ", Some(Drill)), (Word, "DR", Some(Drill)), (Stem, "TALADR", Some(Drill)), (Stem, "PUNTA", Some(Drill)), (Stem, "FORATURA", Some(Drill)),
    (Stem, "FORET", Some(Drill)), (Stem, "PERÇ", Some(Drill)), (Stem, "PERCAGE", Some(Drill)), (Stem, "СВЕРЛ", Some(Drill)),
    (Stem, "ЦЕНТРОВ", Some(Drill)), (Stem, "РАЗВЕРТ", Some(Drill)), (Part, "钻", Some(Drill)), (Part, "鑽", Some(Drill)),
    // Grooving inserts.
    (Part, "GROOV", Some(Grooving)), (Part, "STECHSTAHL", Some(Grooving)), (Part, "STECHST.", Some(Grooving)), (Stem, "PRZECIN", Some(Grooving)),
    (Stem, "ROWEK", Some(Grooving)), (Stem, "KANAVK", Some(Grooving)), (Stem, "OTREZ", Some(Grooving)), (Stem, "SAIGN", Some(Grooving)),
    (Stem, "ZAPICH", Some(Grooving)), (Word, "GRV", Some(Grooving)), (Stem, "CUTOFF", Some(Grooving)), (Stem, "CUT OFF", Some(Grooving)),
    (Stem, "CUT-OFF", Some(Grooving)), (Stem, "PARTING", Some(Grooving)), (Stem, "PART OFF", Some(Grooving)), (Stem, "PART-OFF", Some(Grooving)),
    (Stem, "PARTOFF", Some(Grooving)), (Part, "STECHEN", Some(Grooving)), (Part, "STECHER", Some(Grooving)), (Part, "STECHMEI", Some(Grooving)),
    (Part, "STECHDREH", Some(Grooving)), (Part, "ABSTECH", Some(Grooving)), (Part, "EINSTICH", Some(Grooving)), (Part, "NUTDREH", Some(Grooving)),
    (Stem, "RANURA", Some(Grooving)), (Stem, "TRONZA", Some(Grooving)), (Stem, "BEDAM", Some(Grooving)), (Stem, "SANGRA", Some(Grooving)),
    (Stem, "CANAL", Some(Grooving)), (Stem, "GOLA", Some(Grooving)), (Stem, "GOLE", Some(Grooving)),
    (Stem, "SCANAL", Some(Grooving)), (Stem, "TRONCA", Some(Grooving)), (Stem, "TRONCON", Some(Grooving)), (Stem, "TRONÇON", Some(Grooving)),
    (Stem, "GORGE", Some(Grooving)), (Stem, "RAINUR", Some(Grooving)), (Stem, "КАНАВ", Some(Grooving)), (Stem, "ОТРЕЗ", Some(Grooving)),
    (Stem, "ПРОРЕЗ", Some(Grooving)), (Part, "切槽", Some(Grooving)), (Part, "割槽", Some(Grooving)), (Part, "槽刀", Some(Grooving)),
    (Part, "切断", Some(Grooving)), (Part, "切斷", Some(Grooving)), (Part, "割刀", Some(Grooving)), (Part, "切刀", Some(Grooving)),
    // Turning tools.
    (Stem, "ROUGH", Some(Turning)), (Stem, "FINISH", Some(Turning)), (Stem, "TURN", Some(Turning)), (Stem, "FACING", Some(Turning)),
    (Word, "FACE", Some(Turning)), (Stem, "PROFIL", Some(Turning)), (Stem, "CONTOUR", Some(Turning)), (Word, "TNR", Some(Turning)),
    (Part, "SCHRUPP", Some(Turning)), (Part, "SCHLICHT", Some(Turning)), (Part, "DREHEN", Some(Turning)), (Part, "DREHMEI", Some(Turning)),
    (Part, "DREHSTAHL", Some(Turning)), (Stem, "DESBASTE", Some(Turning)), (Stem, "DESBBASTE", Some(Turning)), (Word, "DESB", Some(Turning)),
    (Stem, "ACABA", Some(Turning)), (Word, "ACAB", Some(Turning)), (Word, "TORN", Some(Turning)), (Stem, "TORNEA", Some(Turning)),
    (Stem, "USINAGEM", Some(Turning)), (Stem, "FACEA", Some(Turning)), (Stem, "CILINDRA", Some(Turning)), (Stem, "REFRENTA", Some(Turning)),
    (Stem, "SGROSS", Some(Turning)), (Stem, "FINITURA", Some(Turning)), (Stem, "TORNIT", Some(Turning)), (Stem, "SFACC", Some(Turning)),
    (Stem, "EBAUCHE", Some(Turning)), (Stem, "ÉBAUCHE", Some(Turning)), (Stem, "FINITION", Some(Turning)), (Stem, "CHARIOT", Some(Turning)),
    (Stem, "ПРОХОДН", Some(Turning)), (Stem, "ПОДРЕЗ", Some(Turning)), (Stem, "ЧЕРНОВ", Some(Turning)), (Stem, "ЧИСТОВ", Some(Turning)),
    (Stem, "ТОЧЕН", Some(Turning)), (Stem, "ТОКАР", Some(Turning)), (Part, "外圆", Some(Turning)), (Part, "外圓", Some(Turning)), (Part, "粗车", Some(Turning)),
    (Part, "精车", Some(Turning)), (Part, "粗車", Some(Turning)), (Part, "精車", Some(Turning)), (Part, "端面", Some(Turning)), (Part, "偏刀", Some(Turning)),
    (Part, "车刀", Some(Turning)), (Part, "車刀", Some(Turning)),
    // Live tools without a more specific term.
    (Stem, "LIVE TOOL", Some(Endmill)), (Stem, "DRIVEN TOOL", Some(Endmill)), (Stem, "ПРИВОДН", Some(Endmill)), (Part, "动力刀", Some(Endmill)),
];

/// Devices that hold or move the workpiece and do not cut.
#[rustfmt::skip]
const HANDLING: &[(MatchKind, &str)] = &[
    (Stem, "BAR PUL"), (Part, "BARPUL"), (Stem, "PULLER"), (Stem, "GRIPPER"), (Stem, "STOCK PULL"), (Stem, "STOCK STOP"), (Stem, "BAR STOP"),
    (Word, "BARSTOP"), (Stem, "PARTS CATCH"), (Stem, "TAILSTOCK CENT"),
];

/// Terms for flipping the part end for end, so that the other end is machined afterwards.
#[rustfmt::skip]
const FLIPPED: &[(MatchKind, &str)] = &[
    (Word, "FLIP PART"), (Word, "FLIP THE PART"), (Word, "FLIP WORK"), (Word, "FLIP WORKPIECE"), (Word, "FLIP THE WORKPIECE"),
    (Word, "FLIP PIECE"), (Word, "TURN PART"), (Word, "TURN THE PART"), (Word, "TURN WORK"), (Word, "REVERSE PART"),
    (Word, "REVERSE THE PART"), (Word, "REVERSE WORK"), (Word, "SECOND SIDE"), (Word, "2ND SIDE"), (Word, "SECOND END"), (Word, "2ND END"),
    (Word, "WENDEN"), (Word, "UMSPANNEN"), (Word, "ZWEITE SEITE"), (Word, "2. SEITE"), (Word, "2.SEITE"), (Stem, "RETOURNER LA PI"),
    (Stem, "DEUXIÈME CÔT"), (Stem, "DEUXIEME COT"), (Stem, "2EME COT"), (Stem, "2ÈME CÔT"), (Stem, "VIRAR A PE"), (Stem, "VIRAR PE"),
    (Stem, "INVERTER A PE"), (Stem, "INVERTER PE"), (Word, "SEGUNDO LADO"), (Word, "SEGUNDA CARA"), (Stem, "VOLTEAR LA PI"),
    (Stem, "VOLTEAR PI"), (Stem, "GIRARE IL PEZZ"), (Stem, "GIRARE PEZZ"), (Word, "GIRA PEZZO"), (Word, "SECONDO LATO"), (Stem, "ПЕРЕВЕРН"),
    (Stem, "ПЕРЕВОРОТ"), (Stem, "ПЕРЕУСТАНОВКА ДЕТАЛ"), (Stem, "ПЕРЕУСТАНОВИТЬ ДЕТАЛ"), (Stem, "ВТОРАЯ СТОРОН"), (Stem, "2 СТОРОН"),
    (Stem, "2-Я СТОРОН"), (Stem, "ВТОРОЙ УСТАНОВ"), (Part, "调头"), (Part, "掉头"), (Part, "調頭"), (Part, "掉頭"), (Part, "翻面"), (Part, "第二面"),
];

/// Terms that mean this only in the block of a stop (M00, M01); elsewhere they are about a groove, the
/// spindle or the chips.
#[rustfmt::skip]
const FLIPPED_AT_STOP: &[(MatchKind, &str)] = &[
    (Stem, "FLIP"), (Word, "TURN AROUND"), (Word, "TURN ROUND"), (Word, "TURN OVER"), (Word, "SIDE 2"), (Word, "OTHER SIDE"),
    (Word, "OTHER END"), (Word, "UMDREHEN"), (Word, "SEITE 2"), (Stem, "RETOURN"), (Word, "VIRAR"), (Word, "VIRE A"), (Word, "OUTRO LADO"),
    (Word, "DAR VUELTA"), (Word, "DAR LA VUELTA"), (Stem, "VOLTEAR"), (Word, "OTRO LADO"), (Word, "GIRARE"), (Stem, "ПЕРЕУСТАНОВ"),
    (Part, "反面"), (Part, "另一端"), (Part, "另一头"),
];

/// Comments of an M00 block that consist only of the name of the second operation.
const SECOND_OPERATION: [&str; 6] = ["OP2", "OP 2", "OP20", "OP 20", "2ND OP", "SECOND OP"];

/// Cutting inserts, in the languages whose terms in [`FLIPPED`] do not name the part: `PLATTE WENDEN` flips
/// the insert.
const INSERTS: &[(MatchKind, &str)] = &[(Part, "PLATTE"), (Stem, "ПЛАСТИН"), (Part, "刀片")];

/// Other objects that are turned: beside them, terms of [`FLIPPED_AT_STOP`] do not count.
#[rustfmt::skip]
const OTHER_OBJECTS: &[(MatchKind, &str)] = &[
    (Stem, "INSERT"), (Stem, "TOOL"), (Stem, "CHIP"), (Stem, "SPINDLE"), (Stem, "MANDRIN"), (Word, "ZERO"), (Word, "ZÉRO"), (Word, "HOME"),
    (Stem, "РЕЗЕЦ"), (Stem, "РЕЗЦ"), (Stem, "ИНСТРУМЕНТ"), (Part, "刀"),
];

/// Negations: terms after a negation do not count.
#[rustfmt::skip]
const NEGATIONS: &[(MatchKind, &str)] = &[
    (Word, "NOT"), (Word, "DON'T"), (Word, "DONT"), (Word, "NO FLIP"), (Stem, "NO VOLTE"), (Word, "NO DAR"), (Word, "NICHT"), (Word, "NE"), (Word, "NAO"), (Word, "NÃO"), (Word, "NON"),
    (Word, "НЕ"), (Part, "不"), (Part, "勿"),
];

/// Terms and the side of the workpiece they name.
#[rustfmt::skip]
pub const SIDES: &[(MatchKind, &str, Side)] = &[
    (Stem, "FACE GROOV", Side::Face), (Part, "FACEGROOV", Side::Face), (Stem, "FACIAL", Side::Face), (Part, "PLANSTECH", Side::Face), (Part, "PLANEINSTECH", Side::Face),
    (Part, "AXIALEINSTECH", Side::Face), (Part, "AXIALSTECH", Side::Face), (Stem, "GOLA FRONTALE", Side::Face), (Stem, "RANURADO FRONTAL", Side::Face),
    (Stem, "КАНАВОЧНЫЙ ТОРЦ", Side::Face), (Part, "端面槽", Side::Face), (Part, "端面切槽", Side::Face),
    (Word, "ID", Side::Inside), (Word, "I.D", Side::Inside), (Stem, "INSIDE", Side::Inside), (Stem, "INTERN", Side::Inside),
    (Stem, "INTERIOR", Side::Inside), (Stem, "INTÉRIEUR", Side::Inside), (Stem, "INTERIEUR", Side::Inside), (Word, "INT", Side::Inside), (Word, "INTER", Side::Inside),
    (Part, "INNEN", Side::Inside), (Stem, "ВНУТР", Side::Inside), (Part, "内", Side::Inside), (Part, "內", Side::Inside),
    (Word, "OD", Side::Outside), (Word, "O.D", Side::Outside), (Stem, "OUTSIDE", Side::Outside), (Stem, "EXTERN", Side::Outside),
    (Stem, "EXTERIOR", Side::Outside), (Stem, "EXTÉRIEUR", Side::Outside), (Stem, "EXTERIEUR", Side::Outside), (Stem, "ESTERN", Side::Outside), (Word, "EXT", Side::Outside),
    (Part, "AUSSEN", Side::Outside), (Stem, "НАРУЖ", Side::Outside), (Part, "外", Side::Outside),
];

/// Prefixes of designations of grooving inserts, and their side of the workpiece.
#[rustfmt::skip]
const BLADES: &[(&str, Side)] = &[
    ("MGMN", Side::Outside), ("MGGN", Side::Outside), ("DGN", Side::Outside), ("GTN", Side::Outside), ("N151", Side::Outside),
    ("N123", Side::Outside), ("TAG", Side::Outside), ("TGFH", Side::Outside), ("GIQR", Side::Inside), ("GIQL", Side::Inside),
    ("MIFR", Side::Face), ("MIFL", Side::Face), ("HFHR", Side::Face), ("HFHL", Side::Face),
];

/// Whether a comment says that the programmed point is the right corner of a grooving insert.
pub fn names_right_corner(text: &str) -> bool {
    const TERMS: [&str; 8] = [
        "RIGHT CORNER",
        "RIGHT EDGE",
        "ESQUINA DERECHA",
        "FILO DERECHO",
        "CANTO DIREITO",
        "RECHTE ECKE",
        "ПРАВЫЙ УГОЛ",
        "右刀尖",
    ];
    TERMS.iter().any(|term| text.contains(term))
}

/// The kind of tool that a comment names.
pub fn kind(text: &str) -> Option<ToolKind> {
    if handles_work(text) {
        return None;
    }
    let bytes = ByteSet::of(text);
    KINDS.iter().find(|(form, term, _)| contains_term(text, &bytes, term, *form)).and_then(|(.., kind)| *kind)
}

/// Whether a comment names a device that holds or moves the workpiece and does not cut, such as a bar stop.
pub fn handles_work(text: &str) -> bool {
    names_any(text, HANDLING)
}

/// Whether a comment tells the operator to flip the part. `is_at_stop`: the comment is in the block of a
/// stop.
pub fn flips_part(text: &str, is_at_stop: bool) -> bool {
    let affirmed = split_at_first(text, NEGATIONS).map_or(text, |(before, _)| before);
    let bytes = ByteSet::of(affirmed);
    let says = |terms: &[(MatchKind, &str)]| {
        let mut found = terms.iter().flat_map(|(form, term)| places(affirmed, &bytes, term, *form));
        found.any(|(before, term, after)| names_part(before, term, after))
    };
    let says_at_stop = || says(FLIPPED_AT_STOP) && !names_any(text, OTHER_OBJECTS);
    (says(FLIPPED) || is_at_stop && says_at_stop()) && !names_any(text, INSERTS)
}

/// Whether a side or an end belongs to the part: not the beginning of a size (`SIDE 2.5`), nor
/// `OTHER SIDE OF SHOULDER`.
fn names_part(before: &str, term: &str, after: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit();
    let is_size = term.ends_with(is_digit) && after.starts_with(|c| is_digit(c) || matches!(c, '.' | ','))
        || term.starts_with(is_digit) && before.ends_with(|c| is_digit(c) || matches!(c, '.' | ','));
    let owner = after.trim_start().strip_prefix("OF ").map(|owner| owner.trim_start_matches("THE "));
    let is_part = |owner: &str| ["PART", "WORK", "PIECE"].iter().any(|name| owner.starts_with(name));
    !is_size && owner.is_none_or(is_part)
}

/// Whether a comment only names the second operation.
pub fn is_second_operation(text: &str) -> bool {
    SECOND_OPERATION.contains(&text.trim())
}

/// The side of the workpiece that a comment names.
pub fn side(text: &str) -> Option<Side> {
    let bytes = ByteSet::of(text);
    SIDES.iter().find(|(form, term, _)| contains_term(text, &bytes, term, *form)).map(|(.., side)| *side)
}

/// The set of bytes of a text: a term with a byte that is not in it need not be searched for.
struct ByteSet([u64; 4]);

impl ByteSet {
    fn of(text: &str) -> Self {
        let mut bytes = Self([0; 4]);
        for byte in text.bytes() {
            bytes.0[usize::from(byte >> 6)] |= 1 << (byte & 63);
        }
        bytes
    }

    fn hold_all_of(&self, term: &str) -> bool {
        term.bytes().all(|byte| self.0[usize::from(byte >> 6)] & 1 << (byte & 63) != 0)
    }
}

/// Whether a comment contains one of some terms.
pub fn names_any(text: &str, terms: &[(MatchKind, &str)]) -> bool {
    let bytes = ByteSet::of(text);
    terms.iter().any(|(form, term)| contains_term(text, &bytes, term, *form))
}

/// The text before and after the first of some terms in a comment.
pub fn split_at_first<'a>(text: &'a str, terms: &[(MatchKind, &'a str)]) -> Option<(&'a str, &'a str)> {
    let bytes = ByteSet::of(text);
    let found = terms.iter().flat_map(|(form, term)| places(text, &bytes, term, *form));
    found.map(|(before, _, after)| (before, after)).min_by_key(|(before, _)| before.len())
}

/// Whether a comment with these bytes contains a term.
fn contains_term(text: &str, bytes: &ByteSet, term: &str, form: MatchKind) -> bool {
    places(text, bytes, term, form).next().is_some()
}

/// The places of a term in a comment with these bytes: the text before it, the term and the text after it.
fn places<'a>(
    text: &'a str,
    bytes: &ByteSet,
    term: &'a str,
    form: MatchKind,
) -> impl Iterator<Item = (&'a str, &'a str, &'a str)> + use<'a> {
    let text = if bytes.hold_all_of(term) { text } else { "" };
    let places = text.match_indices(term).map(|(at, term)| (&text[..at], term, &text[at + term.len()..]));
    places.filter(move |(before, _, after)| {
        let before = before.chars().next_back().is_some_and(char::is_alphabetic);
        let after = after.chars().next().is_some_and(char::is_alphabetic);
        match form {
            Word => !before && !after,
            Stem => !before,
            Part => true,
        }
    })
}

/// The tool of the first designation of an insert in a comment.
pub fn insert_tool(text: &str) -> Option<Tool> {
    let mut words = text.split([' ', ',', ';', ':', '(', '=']).filter(|word| !word.is_empty()).peekable();
    while let Some(word) = words.next() {
        let next = words.peek().copied().unwrap_or_default();
        if let Some(tool) = turning(word, next).or_else(|| threading(word)).or_else(|| blade(word, next)) {
            return Some(tool);
        }
    }
    None
}

/// `CNMG120408`, `CCGT 09T304`, `VNMG 2.5-1-SF`: shape, clearance, tolerance, type (ISO 1832), then metric
/// digits in pairs, or those of ANSI B212.4, the last of which is the nose radius in 64ths of an inch.
fn turning(word: &str, next: &str) -> Option<Tool> {
    let letters = word.get(..4)?;
    let sets = ["CDVTWSRK", "NBCPAEFDG", "MGUEACHJKLN", "GMTNAWXQRUHFJ"];
    if !letters.chars().zip(sets).all(|(letter, set)| set.contains(letter)) {
        return None;
    }
    let size = if word.len() > 4 { &word[4..] } else { next };
    let has_size = size.starts_with(|first: char| first.is_ascii_digit());
    // Without digits they may be an ordinary word, except for the usual designations.
    let usual = ["CDVTWSR", "NBCP", "MG", "GMTAX"];
    let is_usual = word.len() == 4 && letters.chars().zip(usual).all(|(letter, set)| set.contains(letter));
    if !(has_size || is_usual) {
        return None;
    }
    let mut tool = Tool { kind: Some(Turning), insert: Some(letters.to_owned()), ..Tool::default() };
    if !has_size {
        return Some(tool);
    }
    let digits = |part: &str| part.len() == 2 && part.bytes().all(|byte| byte.is_ascii_digit());
    let metric = (size.get(..2), size.get(4..6));
    if let (Some(edge), Some(nose)) = metric
        && digits(edge)
        && digits(nose)
    {
        tool.insert = Some(format!("{letters}{edge}"));
        tool.nose_radius = crate::units::read_number(nose).map(|tenths| tenths / 10.0);
        return Some(tool);
    }
    let size = size.split_terminator(|c: char| c.is_alphabetic()).next().unwrap_or_default();
    let last = size.trim_end_matches('-').chars().next_back().and_then(|digit| digit.to_digit(10));
    tool.nose_radius =
        last.filter(|&sixtyfourths| sixtyfourths > 0 && size.len() > 2).map(|n| f64::from(n) * 25.4 / 64.0);
    Some(tool)
}

/// `16ER1.5ISO`, `22IR`: a thread insert for the outside or the inside.
fn threading(word: &str) -> Option<Tool> {
    let (size, rest) = word.split_at_checked(2)?;
    let known = ["06", "08", "11", "16", "22", "27"].contains(&size);
    let side = match rest.get(..2)? {
        "ER" | "EL" => Side::Outside,
        "IR" | "IL" => Side::Inside,
        _ => return None,
    };
    known.then(|| Tool { kind: Some(Threading), side: Some(side), ..Tool::default() })
}

/// `MGMN300`, `DGN 2002C`, `TAG N2A`, `GIQR 11-2.00-0.10`: a grooving insert, with its width if the
/// designation contains it.
fn blade(word: &str, next: &str) -> Option<Tool> {
    let (name, side) = BLADES.iter().find(|(name, _)| word.starts_with(name))?;
    let own = &word[name.len()..];
    // `TAGGED` is not a designation.
    if own.starts_with(char::is_alphabetic) && *name == "TAG" {
        return None;
    }
    let size = if own.is_empty() { next } else { own };
    let number = crate::units::read_number;
    let leading = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let width = match *name {
        "MGMN" | "MGGN" => number(&size[..leading(size)]).map(|w| if w >= 100.0 { w / 100.0 } else { w }),
        // Two digits for the width in tenths of a millimetre, two for the corner radius.
        "DGN" if leading(size) == 4 => number(&size[..2]).map(|w| w / 10.0),
        "TAG" => size.strip_prefix('N').and_then(|rest| number(&rest[..leading(rest)])),
        "GIQR" | "GIQL" | "MIFR" | "MIFL" => size.split('-').nth(1).and_then(number),
        _ => None,
    };
    let width = width.filter(|width| (0.3..=20.0).contains(width));
    Some(Tool { kind: Some(Grooving), side: Some(*side), width, ..Tool::default() })
}
