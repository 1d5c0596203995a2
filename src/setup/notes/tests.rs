//! Setup comments are read, and their mistakes are reported.

use super::*;
use crate::setup::{Side, ToolKind, Turret};

#[test]
fn notes_are_read() {
    let notes = Notes::read(
        b"%\nO1 (STOCK D=65 BORE=18 LENGTH=80 FACE=1 GRIP=30)\n(tool t0101 type=turning insert=CNMG120408 kr=95)\n\
          (TOOL T3 TYPE=GROOVING SIDE=INSIDE WIDTH=3 R=.2)\n(TAILSTOCK Z=2 D=20)\n\
          (MACHINE RAPIDX=8000 ZMIN=-300 TURRET=FRONT)\n(START X=150 Z=20)\n\
          (rules classroom=warning No-Program-End=Off)\nG0 X1\n",
    );
    assert_eq!(notes.unreadable, []);
    assert_eq!(
        notes.stock.map(|blank| blank.extents()),
        Some(Stock {
            diameter: Diameter::new(65.0),
            bore: Diameter::new(18.0),
            face: 1.0,
            length: 80.0,
            grip: Some(30.0)
        })
    );
    let [(first, turning), (second, groove)] = &notes.tools[..] else { panic!("{:?}", notes.tools) };
    assert_eq!((first.as_str(), second.as_str()), ("T0101", "T0303"));
    assert_eq!(
        (turning.kind, turning.nose(), turning.entering_angle),
        (Some(ToolKind::Turning), 0.8, Some(95.0))
    );
    assert_eq!((groove.side, groove.width, groove.tip_direction()), (Some(Side::Inside), Some(3.0), 2));
    assert_eq!(notes.tailstock, Some(Tailstock { z: 2.0, diameter: Diameter::new(20.0) }));
    let machine = notes.machine.unwrap();
    assert_eq!(
        (machine.rapid_x, machine.travel.z_min, machine.turret),
        (Some(8000.0), Some(-300.0), Turret::Front)
    );
    assert_eq!(notes.start, Some(Position { x: Diameter::new(150.0), z: 20.0 }));
    let rules: Vec<_> = notes.rules.iter().collect();
    assert_eq!(rules, [("classroom", Severity::Warning), ("no-program-end", Severity::Off)]);
}

/// `may_contain_notes` is true for everything that is read as a note, in any spelling, and false for prose and
/// code.
#[test]
fn where_notes_may_stand() {
    let written = |name: &str| {
        let swapped: String = name
            .chars()
            .enumerate()
            .map(|(at, c)| if at % 2 == 0 { c.to_ascii_lowercase() } else { c })
            .collect();
        [name.to_owned(), name.to_ascii_lowercase(), swapped]
    };
    for name in Keyword::ALL.into_iter().flat_map(|keyword| written(keyword.name())) {
        let notes = [
            format!("({name} T1 D=1)"),
            format!("O1 (PART) ( \t{name}\t Q=1"),
            format!("G0 X1\r\n;({name}=2 Q=1)"),
            format!("[({name} X=1]"),
            format!("({name}  =  T1=1"),
            format!("[{name} X1 Z2"),
            format!("([ {name} x1 z2)"),
            format!("\u{e9} ({name} Q=\u{e9})"),
        ];
        let read: Vec<_> = notes.iter().filter(|text| read(text.as_bytes()) != Notes::default()).collect();
        assert_eq!(read.len(), if name.eq_ignore_ascii_case("billet") { 2 } else { 6 }, "{read:?}");
        for text in read {
            assert!(Notes::may_contain_notes(text.as_bytes()), "{text}");
        }
    }
    for text in [
        "",
        "O1 (STOCK)\n(TOOL 1 - ROUGHING)\n(MACHINE THE FACE)",
        "(STOCKS D=1)",
        "(A STOCK D=1)",
        "#1=[2+3] (A=3)",
        "STOCK D=1",
        "(BILLET X1 Z2)",
        "[STOCK D=1]",
    ] {
        assert!(!Notes::may_contain_notes(text.as_bytes()), "{text}");
    }
    let behind = format!("{}(STOCK D=1)", " ".repeat(HEAD));
    assert!(!Notes::may_contain_notes(behind.as_bytes()));
}

#[test]
fn a_class_billet_is_read() {
    for (text, stock) in [
        ("[BILLET X62 Z70", Some((62.0, 70.0))),
        ("[billet x51.8 z15.5]", Some((51.8, 15.5))),
        ("[BILLET", None),
    ] {
        assert_eq!(
            Notes::read(text.as_bytes())
                .stock
                .map(|blank| (blank.extents().diameter.mm(), blank.extents().length)),
            stock,
            "{text}"
        );
    }
}

/// The points and the clamping length of an outline in notes.
fn outline(text: &str) -> Option<(String, Option<f64>)> {
    let blank = Notes::read(text.as_bytes()).stock?;
    Some((blank.outline()?.to_string(), blank.extents().grip))
}

#[test]
fn an_outline_is_read_point_by_point() {
    let points = "X0 Z2 X30 Z2 X30 Z-20 X50 Z-30 X50 Z-60";
    for text in [
        "(STOCK X=0 Z=2 X=30 Z=2 X=30 Z=-20 X=50 Z=-30 X=50 Z=-60)",
        // X keeps its value.
        "(stock x=0 z=2 x=30 z=2 z=-20 x=50 z=-30 z=-60)",
        "O1 (STOCK X=0 Z=2 X=30 Z=2)\nN10 (STOCK Z=-20 X=50 Z=-30)\r\n(STOCK Z=-60)\n",
        // Another blank between them: the last outline counts.
        "(STOCK X=9 Z=9 X=8 Z=8)\n(STOCK D=20 LENGTH=30)\n(STOCK X=0 Z=2 X=30 Z=2)(STOCK Z=-20 X=50 Z=-30 Z=-60)",
    ] {
        assert_eq!(outline(text), Some((points.to_owned(), None)), "{text}");
    }
    for text in [
        "(STOCK GRIP=15 X=30 Z=2 X=50 Z=-60)",
        "(STOCK X=30 Z=2 GRIP=15 X=50 Z=-60)",
        "(STOCK X=30 Z=2)\n(STOCK X=50 Z=-60 GRIP=15)",
        "(STOCK X=30 Z=2 X=50 Z=-60)\n(STOCK GRIP=15)",
    ] {
        assert_eq!(outline(text), Some(("X30 Z2 X50 Z-60".to_owned(), Some(15.0))), "{text}");
    }
    // Code or another note between two notes: the second one replaces the first.
    for between in ["G0 X1", "O2", "(START X=100 Z=50)"] {
        let text = format!("(STOCK X=1 Z=1 X=2 Z=-2)\n{between}\n(STOCK X=30 Z=2 X=50 Z=-60)");
        assert_eq!(outline(&text), Some(("X30 Z2 X50 Z-60".to_owned(), None)), "{text}");
    }
    assert_eq!(outline("(STOCK X=30 Z=2 X=50 Z=-60)\n(STOCK D=60 LENGTH=80)"), None);
}

#[test]
fn a_slip_in_an_outline_is_told_once() {
    for (text, slip) in [
        ("(STOCK X=30 Z=2 X=50)", "X=50"),
        ("(STOCK Z=2 X=50 Z=-60)", "Z=2"),
        ("(STOCK X=30 X=40 Z=2 Z=-60)", "X=40"),
        ("(STOCK X=30 Z=a X=50 Z=-60)", "Z=a"),
        ("(STOCK X=30 Z=2 X=50 Z=-60 D=50)", "D=50"),
        ("(STOCK X=30 Z=2 X=50 Z=-60)\n(STOCK GRIP=x)", "GRIP=x"),
    ] {
        let notes = Notes::read(text.as_bytes());
        let told: Vec<_> = notes.unreadable.iter().map(|fault| fault.span.of(text.as_bytes())).collect();
        assert_eq!(told, [slip.as_bytes()], "{text}");
        let (_, invalid) = notes.applied_to(Setup::default()).without_invalid_values();
        assert_eq!(notes.diagnostics(invalid, text.as_bytes()).len(), 1, "{text}");
    }
}

#[test]
fn prose_is_prose_and_a_slip_is_told() {
    let prose = Notes::read(b"(STOCK: ROUND BAR)\n(TOOL 1 - ROUGHING)\n(MACHINE THE FACE)\n(X=3)");
    assert_eq!(prose, Notes::default());
    let sizes = Notes::read(
        b"(Start spindle, D=1.748, SFM=300, RPM=655)\n(Stock removal, D=40)\n(machine the OD, D=40)\n(TOOL CHANGE POINT AT X=200 Z=100)",
    );
    assert_eq!(sizes, Notes::default());
    assert_eq!(Notes::read(b"(STOCK BAR D=65 LENGTH=80)").unreadable.len(), 1);
    let text = b"(STOCK D=65 LENGHT=80 BORE=x)";
    let notes = Notes::read(text);
    let told: Vec<_> = notes.unreadable.iter().map(|fault| fault.span.of(text)).collect();
    assert_eq!(told, [&b"LENGHT=80"[..], b"BORE=x"]);
    assert_eq!(Notes::read(b"(TOOL TURNING R=1)").unreadable.len(), 1);
    assert_eq!(Notes::read(b"(RULES: CLASSROOM=OFF)\n(RULES OF THE SHOP)"), Notes::default());
    let notes = Notes::read(b"(RULES NO-PROGRAM-ENDS=OFF NO-PROGRAM-END=LOUD QQQ=OFF)");
    let expected: Vec<_> = notes.unreadable.iter().map(|fault| &*fault.expected).collect();
    let end = "NO-PROGRAM-END=OFF (INFO, WARNING, ERROR)";
    assert_eq!(expected, [end, end, RULE_WORDS]);
}
