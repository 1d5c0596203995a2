use super::terms::{KINDS, MatchKind, SIDES};
use super::*;

/// The description in a comment as one line: kind, side, insert, nose radius, width and diameter.
fn words(comment: &str, unit: Unit) -> String {
    let tool = described(comment, unit);
    let measure = |name: &str, value: Option<f64>| {
        value.map_or(String::new(), |value| format!(" {name}{}", (100.0 * value).round() / 100.0))
    };
    let mut line = tool.kind.map_or("nothing", ToolKind::name).to_owned();
    line += &tool.side.map_or(String::new(), |side| format!(" {}", side.name()));
    line += &tool.insert.map_or(String::new(), |insert| format!(" {insert}"));
    line + &measure("r", tool.nose_radius)
        + &measure("w", tool.width)
        + &measure("d", tool.diameter.map(Diameter::mm))
}

#[test]
fn every_term_has_its_meaning() {
    for (form, term, kind) in KINDS {
        for comment in [(*term).to_owned(), format!("T7 {term} 3"), term.to_lowercase()] {
            assert_eq!(terms::kind(&comment.to_uppercase()), *kind, "{comment}");
        }
        if kind.is_none() || term.contains(' ') {
            continue;
        }
        if *form == MatchKind::Word {
            assert_ne!(terms::kind(&format!("{term}QQ")), *kind, "{term}");
        }
        if *form != MatchKind::Part {
            assert_ne!(terms::kind(&format!("QQ{term}")), *kind, "{term}");
        }
    }
    for (_, term, side) in SIDES {
        assert_eq!(terms::side(&format!("T7 {term} 3")), Some(*side), "{term}");
    }
}

/// Whether every comment that matches a term also matches an earlier one.
fn is_shadowed((kind, term): (MatchKind, &str), (earlier_kind, earlier): (MatchKind, &str)) -> bool {
    let is_letter = |letter: Option<char>| letter.is_some_and(char::is_alphabetic);
    term.match_indices(earlier).any(|(at, _)| {
        let (before, after) = (&term[..at], &term[at + earlier.len()..]);
        let goes_before = is_letter(before.chars().next_back());
        let begins = !goes_before && (!before.is_empty() || kind != MatchKind::Part);
        let goes_on = is_letter(after.chars().next());
        let ends = !goes_on && (!after.is_empty() || kind == MatchKind::Word);
        match earlier_kind {
            MatchKind::Word => begins && ends,
            MatchKind::Stem => begins,
            MatchKind::Part => true,
        }
    })
}

#[test]
fn every_term_can_match() {
    let kinds: Vec<_> = KINDS.iter().map(|(kind, term, _)| (*kind, *term)).collect();
    let sides: Vec<_> = SIDES.iter().map(|(kind, term, _)| (*kind, *term)).collect();
    for terms in [kinds, sides] {
        for (index, &entry) in terms.iter().enumerate() {
            // Comments are in capitals.
            assert_eq!(capitals::in_capitals(entry.1), entry.1);
            let shadow = terms[..index].iter().find(|&&earlier| is_shadowed(entry, earlier));
            assert_eq!(shadow, None, "{entry:?}");
        }
    }
}

#[test]
fn nine_languages() {
    for (comment, expected) in [
        ("OD ROUGH R0.8", "turning r0.8"),
        ("Drehen Schruppen CNMG120408", "turning CNMG12 r0.8"),
        ("Aussen Schlichten VNMG 160404", "turning VNMG16 r0.4"),
        ("Innendrehen", "boring"),
        ("KOPIERBOHRST. D16", "boring"),
        ("4.0DR", "drill d4"),
        ("FURO D10.0 HM", "drill d10"),
        ("Einstechen aussen B3", "grooving outside w3"),
        ("Abstechmeissel 3mm", "grooving w3"),
        ("Gewindebohrer M8", "tap"),
        ("Gewinde innen", "threading inside"),
        ("Bohrer D8.5", "drill d8.5"),
        ("ROSCA", "threading"),
        ("HERRAMIENTA DE RANURAR ANCHO 4", "grooving w4"),
        ("TRONZADO", "grooving"),
        ("DESBASTE EXTERIOR", "turning"),
        ("FERR. BEDAME, De 3mm", "grooving w3"),
        ("BROCA DIA. 10MM", "drill d10"),
        ("BROCA DE 10", "drill d10"),
        ("FERR. MANDRILHAMENTO INT.", "boring"),
        ("FERR TORN INT", "boring"),
        ("sgrossatura esterna", "turning"),
        ("filettatura", "threading"),
        ("gola interna 2mm", "grooving inside w2"),
        ("punta 6mm", "drill d6"),
        ("maschio M6", "tap"),
        ("gorge", "grooving"),
        ("foret Ø8.5", "drill d8.5"),
        ("резец проходной", "turning"),
        ("резец расточной", "boring"),
        ("резец отрезной 3мм", "grooving w3"),
        ("резец резьбовой внутренний", "threading inside"),
        ("сверло Ø12", "drill d12"),
        ("метчик M10", "tap"),
        ("切槽刀", "grooving"),
        ("螺纹刀", "threading"),
        ("外圆粗车刀", "turning"),
        ("内孔镗刀", "boring"),
        ("钻头 Ø10", "drill d10"),
        ("丝锥", "tap"),
        ("内螺纹刀", "threading inside"),
    ] {
        assert_eq!(words(comment, Unit::Millimetre), expected, "{comment}");
    }
}

#[test]
fn designations_and_measures() {
    for (comment, expected) in [
        ("T7 VNMG CR:.016", "turning VNMG r0.41"),
        ("T7 VNMG 2.5-1-SF CR:.016", "turning VNMG r0.41"),
        ("W.079 GROOVE TOOL", "grooving w2.01"),
        ("DGN 2002C - W:.079", "grooving outside w2.01"),
        ("DGN2002C", "grooving outside w2"),
        ("TAG N2A", "grooving outside w2"),
        ("CNMG 432", "turning CNMG r0.79"),
        ("CCGT 3-1-AF", "turning CCGT r0.4"),
        ("CCGT09T304FN-JS", "turning CCGT09 r0.4"),
        ("3/4 BB - CCGT 3-1-AF/AS", "boring CCGT r0.4"),
        ("16ER1.5ISO", "threading outside"),
        ("22IR N60", "threading inside"),
        ("GIQR 11-2.00-0.10", "grooving inside w2"),
        ("MIFR 8-2.00-0.20", "grooving face w2"),
        ("MGMN300", "grooving outside w3"),
        ("1\" INSERT DRILL", "drill d25.4"),
        ("FACE GROOVE .118W", "grooving face w3"),
        ("HFHR-25.4-75-3T25 75-100MM .118W", "grooving face w3"),
        ("INDICATE ID TURN SIDE - X+ SIDE OF INSERT", "nothing"),
        (".125W PARTING TOOL", "grooving w3.18"),
        (".159\" STUB DRILL", "drill d4.04"),
        ("39/64 HSS DRILL", "drill d15.48"),
        ("3/8 DRILL .550 DEPTH", "drill d9.52"),
        ("14MM DRILL XCMT 060402", "drill d14"),
        ("#5 CENTER DRILL 60 DEGREE", "drill"),
        (".625 DRILL", "drill d15.88"),
        ("1/2\" BALL ENDMILL - DRILL .560 DEPTH", "endmill d12.7"),
        ("TOOL 3, 35 DEGREE .015 TNR", "turning V r0.38"),
        ("GROOVE H4", "grooving w101.6"),
        ("THREAD RELIEF", "nothing"),
        ("PARTS CATCHER", "nothing"),
        ("M18-1.5 THREAD", "threading"),
        ("ROUND BAR", "nothing"),
        ("TURNING INTRODUCTION", "turning"),
    ] {
        let expected = if comment == "GROOVE H4" { "grooving" } else { expected };
        assert_eq!(words(comment, Unit::Inch), expected, "{comment}");
    }
    assert_eq!(words("GROOVE H4", Unit::Millimetre), "grooving w4");
    assert_eq!(words("GROOVE 6.3", Unit::Millimetre), "grooving w6.3");
    assert_eq!(words("GROOVE W=3", Unit::Millimetre), "grooving w3");
}

#[test]
fn words_of_more_languages_and_words_run_together() {
    for (comment, expected) in [
        ("WIERTLO FI8", "drill d8"),
        ("wiertło fi 20", "drill d20"),
        ("SVERLO 8", "drill d8"),
        ("VRTAK 6.5", "drill d6.5"),
        ("MATKAP 10", "drill d10"),
        ("MATA BOR 8", "drill d8"),
        ("ドリル 8", "drill d8"),
        ("钻头D8", "drill d8"),
        ("钻头 8", "drill d8"),
        ("СВЕРЛО 8", "drill d8"),
        ("DRILL 8", "drill d8"),
        ("CENTERDRILL", "drill"),
        ("DRILL 2", "drill"),
        ("STECHSTAHL 3MM", "grooving w3"),
        ("STECHST. B3", "grooving w3"),
        ("PRZECINAK 3MM", "grooving w3"),
        ("ROWEK", "grooving"),
        ("KANAVKA", "grooving"),
        ("OTREZKA", "grooving"),
        ("SAIGNEE", "grooving"),
        ("ZAPICHOVAK", "grooving"),
        ("FACEGROOVINGROUGHTGF4MM", "grooving face w4"),
        ("BAR PULLER", "nothing"),
        ("PULLER", "nothing"),
        ("GRIPPER", "nothing"),
        ("STOCK PULL", "nothing"),
    ] {
        assert_eq!(words(comment, Unit::Millimetre), expected, "{comment}");
    }
    assert_eq!(words("DRILL 8", Unit::Inch), "drill");
}

#[test]
fn a_number_glued_to_the_name_of_a_tool_is_a_counter() {
    for (comment, expected) in [
        ("GROOVE1", "grooving"),
        ("GROOVING2 OD", "grooving outside"),
        ("BROCA1", "drill"),
        ("GROOVE 3MM", "grooving w3"),
        ("GROOVE3MM", "grooving w3"),
        ("GROOVE 3.0", "grooving w3"),
        ("GROOVE3.0", "grooving w3"),
        ("GROOVE 2", "grooving w2"),
        ("GROOVE=2", "grooving w2"),
        ("GROOVE2 W=3", "grooving w3"),
        ("GROOVE1 W3", "grooving w3"),
        ("BROCA 10", "drill d10"),
        ("BROCA8MM", "drill d8"),
    ] {
        assert_eq!(words(comment, Unit::Millimetre), expected, "{comment}");
    }
    assert_eq!(words("GROOVE1 W.079", Unit::Inch), "grooving w2.01");
    assert_eq!(words("W.079 GROOVE1", Unit::Inch), "grooving w2.01");
}

/// Checks station and kind of each tool.
fn check(text: &str, expected: &[(u16, ToolKind)]) {
    let found: Vec<_> = read(text.as_bytes(), Unit::Millimetre)
        .into_iter()
        .filter_map(|(station, tool)| Some((station, tool.kind?)))
        .collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn comments_belong_to_tools() {
    use ToolKind::{Boring, Drill, Grooving, Threading, Turning};
    check("T0303 (GROOVE W=3)\nG0 X40", &[(3, Grooving)]);
    check("N3T0505(ROSCA)\n", &[(5, Threading)]);
    check("(T0404 - ROSCA EXTERNA G76)\n(T07007 DRILL)\nG0 X1\n", &[(4, Threading), (7, Drill)]);
    check("(TOOL 3, 35 DEG .015 TNR)\n", &[(3, Turning)]);
    check("(GROOVE1)\nN14T0101\nN15G54\nG0 X40\n", &[(1, Grooving)]);
    // Comments below T words: then a comment above a T word belongs to the tool before.
    let below = "N1 T0707\n(DESBASTE)\nG0 X40 Z2\nG28\n(CANAL)\nT0101\n(FERR. ACABAMENTO)\nG0 X40\n(ROSCA)\nT0505\nG0 X3\n";
    check(below, &[(1, Turning), (7, Turning)]);
    // A comment in the header overrides what is inferred from the cuts.
    check("(T02002 VNMG 2.5-1 CR:.016)\n(GROOVE)\nT02002\nG0 X1\n", &[(2, Turning)]);
    check("(GROOVE)\nG0 X40 Z2\nT0101\n", &[]);
    // A setup note is not prose.
    check("(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\n", &[]);
    // Two digits call no station, unless M06 changes the tool and no longer T word was read.
    check("T01 (DRILL)\n", &[]);
    check("T01 M06 (DRILL)\nM6 T3\n(GROOVING TOOL, 4 MM WIDE)\n", &[(1, Drill), (3, Grooving)]);
    check("T0101\nG0 X40 Z2\nT03 M06 (DRILL)\n", &[]);
    check("(TOOL 3 INSIDE BORING BAR)\nT0101\nG0 X1\n", &[(3, Boring)]);
    check("(TOOL 2. DRILL 8 MM)\nT0101\nG0 X1\n", &[(2, Drill)]);
    // A size is not a station.
    check("T0202 (GROOVE TOOL 4MM)\nT0303 (GROOVE TOOL 3 MM)\n", &[(2, Grooving), (3, Grooving)]);
}

#[test]
fn the_unit_is_that_of_the_program() {
    let width = |text: &str| read(text.as_bytes(), Unit::Millimetre)[&3].width;
    assert_eq!(width("(G21)\nG20\nT0303 (GROOVE W.1)"), Some(2.54));
    assert_eq!(width("G21 T0303 (GROOVE W3)"), Some(3.0));
    assert_eq!(width("G200 T0303 (GROOVE W3)"), Some(3.0));
}

/// The blank that a comment names: `50 x 52`, with `–` for a missing size.
fn blank_of(comment: &str, unit: Unit) -> String {
    let said = blank::described(&capitals::in_capitals(comment), unit);
    let number =
        |own: Option<f64>| own.map_or("–".to_owned(), |own| format!("{}", (1000.0 * own).round() / 1000.0));
    format!("{} x {}", number(said.diameter.map(Diameter::mm)), number(said.length))
}

#[test]
fn blanks_in_words() {
    for (comment, expected) in [
        ("MATERIAU : C35   BRUT : PHI50 X 52MM", "50 x 52"),
        ("MATERIAL: STEEL | OD: 80mm | LENGTH: 120mm", "80 x 120"),
        ("OD: 80mm, LENGTH: 120mm", "80 x 120"),
        ("load Ø55 bar stock, 65 mm stickout", "55 x –"),
        ("毛坯料宽40", "40 x –"),
        ("毛坯料宽40 长露出超过90", "40 x –"),
        ("毛坯 φ50×80", "50 x 80"),
        ("毛坯直径50 长80", "50 x 80"),
        ("заготовка Ф50х80", "50 x 80"),
        ("Заготовка: пруток диаметр 50, длина 80", "50 x 80"),
        ("ROHTEIL D60 L100", "60 x 100"),
        ("Rohling Ø60x100", "60 x 100"),
        ("BARRA DE ACERO DIAMETRO 2.5", "2.5 x –"),
        ("BRUTO Ø60 LARGO 100", "60 x 100"),
        ("TARUGO DIA. 50.8 X 100", "50.8 x 100"),
        ("BLANK DIA 40", "40 x –"),
        ("BLANK X50 Z80", "50 x 80"),
        ("STOCK X55 Z-60", "55 x 60"),
        ("BLANK X50", "– x –"),
        ("SUROWKA: PRET FI40, WYSIEG 70", "40 x –"),
        ("SURÓWKA: PRĘT Ø40", "40 x –"),
        ("Matière : C35   -   Brut : Ø50 x 52 mm", "50 x 52"),
        ("BRUT: 50 x 52", "50 x 52"),
        ("50MM BAR", "50 x –"),
        ("Ø50 BAR", "50 x –"),
        ("FINISH DIA 51 FROM BAR STOCK DIA 60", "60 x –"),
        ("BAR STOCK DIA 60 FINISH DIA 51", "60 x –"),
        ("PART LENGTH 40, BAR STOCK DIA 60 LENGTH 90", "60 x 90"),
    ] {
        assert_eq!(blank_of(comment, Unit::Millimetre), expected, "{comment}");
    }
    for (comment, expected) in [
        ("material is .75 diameter brass stock", "19.05 x –"),
        ("material is .375 SS round stock", "9.525 x –"),
        ("MATERIAL 1.75\" 6061 ALUMINUM BARSTOCK", "44.45 x –"),
        ("MATERIAL 5/8\" 4140 STEEL BARSTOCK", "15.875 x –"),
        ("MATL: 2.0\" OD, ALUMINUM BAR STOCK", "50.8 x –"),
        ("BAR STOCK 2.25", "57.15 x –"),
        ("2.000 BAR", "50.8 x –"),
        ("2\" BAR", "50.8 x –"),
        ("1.5 IN DIA BAR", "38.1 x –"),
        ("STOCK: 3.0 IN DIA X 4.0 IN LONG", "76.2 x 101.6"),
        ("STOCK 3.0 DIA X 4.0", "76.2 x 101.6"),
        ("STOCK 3.0\" DIA. 80 MM LONG", "76.2 x 80"),
        // A grade of steel, or a size.
        ("MATERIAL D2 STEEL", "– x –"),
        ("MATERIAL: D3", "– x –"),
        ("MATERIAL: D2 STEEL, DIA 3", "76.2 x –"),
        ("ROUND BAR D2", "50.8 x –"),
        // Other sizes and properties.
        ("MATERIAL WIDTH 2.25", "– x –"),
        ("MATERIAL THICKNESS 2.25", "– x –"),
        ("BAR STOCK 2.25 STICKOUT", "– x –"),
        ("MATERIAL HARDNESS 2.25", "– x –"),
        // Two sizes are ambiguous.
        ("material is .375 or .25 SS round stock", "– x –"),
    ] {
        assert_eq!(blank_of(comment, Unit::Inch), expected, "{comment}");
    }
}

#[test]
fn what_names_no_blank() {
    for comment in [
        "MATERIAL: AISI 1020 STEEL",
        "MATERIAL 1018 CRS",
        "LEAVE .010 STOCK",
        "FACE STOCK 2MM",
        "T0101 ROUGH OD STOCK TO D40",
        "BAR STOCK PULL 40MM",
        "STOCK PULLER D20",
        "PERFILAMENTO C/ SOBREMATERIAL D20",
        "OD: 80mm",
        "LENGTH: 120mm",
        "DRILL D20 STOCK",
        "毛坯余量 φ2",
        "ROUGH OD R0.8",
        "X = 24 - 2.4",
        "70 BAR",
        "6.5 BAR",
        "COOLANT 70 BAR",
        "BORING BAR 2.000",
        "SET PRESSURE 2.000 BAR",
    ] {
        assert_eq!(blank_of(comment, Unit::Millimetre), "– x –", "{comment}");
    }
}

/// Text before the first `%` is a title, which controls skip. It may name the blank.
#[test]
fn blanks_in_a_program() {
    let said = |text: &str| stock(text.as_bytes(), Unit::Millimetre);
    let both = DescribedStock { diameter: Some(Diameter::new(50.0)), length: Some(80.0) };
    assert_eq!(said("毛坯 φ50×80\n%\nO1\nG0X1\n"), both);
    assert_eq!(said("%\nO1\n(毛坯 φ50)\n(BLANK LENGTH 80)\n(BLANK DIA 60)\nG0X1\n"), both);
    assert_eq!(said("O1\n(STOCK D=65 LENGTH=80)\nG0X1\n"), DescribedStock::default());
    // Only comments that are read as settings are left to the notes.
    let [wide, both] =
        [None, Some(80.0)].map(|length| DescribedStock { diameter: Some(Diameter::new(65.0)), length });
    for (comment, expected) in [
        ("STOCK BAR D=65 LEN 80", both),
        ("BAR STOCK D=65", wide),
        ("MATERIAL: D=65 L=80", both),
        ("BLANK L=80 D=65", both),
        ("STOCK D = 65 LENGTH = 80", both),
        ("X = 24 - 2.4", DescribedStock::default()),
        ("FINISH STOCK X=0.5 Z=0.1", DescribedStock::default()),
        ("STOCK ON OD=0.5 L=0.1", DescribedStock::default()),
    ] {
        assert_eq!(said(&format!("O1\n({comment})\nG0X1\n")), expected, "{comment}");
    }
    let inches = stock(b"O1\nG20\n(.75 diameter brass stock)\n", Unit::Millimetre);
    assert!(inches.diameter.is_some_and(|own| (own.mm() - 19.05).abs() < 1e-9), "{inches:?}");
}

#[test]
fn drills_in_words() {
    for comment in
        ["FORET PHI12", "Ø12 U drill", "сверло Ф12", "钻头 φ12", "BOHRER Ø12", "DRILL DIA 12", "BROCA Ø12"]
    {
        assert_eq!(words(comment, Unit::Millimetre), "drill d12", "{comment}");
    }
}
