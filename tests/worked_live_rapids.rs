//! Rapids of live tools, calculated by hand: which of them enter the work, and which move where a cutter has
//! already been.
use gcode_playground::run::Run;
use gcode_playground::setup::Setup;

/// A bar of 60 mm; T1 turns, T7 drills along Z, T9 mills along X, T11 along Z.
const HEAD: &str = "O0001 (STOCK D=60 LENGTH=100)\n\
    (TOOL T0101 TYPE=TURNING)\n\
    (TOOL T0707 TYPE=DRILL D=6)\n\
    (TOOL T0909 TYPE=ENDMILL D=8)\n\
    (TOOL T1111 TYPE=ENDMILL D=8)\n";

/// Checks the messages for the rapids in a program of live tools: slug and line, counted from 1.
#[track_caller]
fn says(blocks: &str, expected: &[&str]) {
    let text = format!("{HEAD}{blocks}\nG00 X200 Z200\nM30\n");
    let mut run = Run::new(text.as_bytes().to_vec(), Setup::default());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    let told = analysis.diagnostics.iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() - HEAD.matches('\n').count() + 1;
        format!("{} {line}", told.message.slug())
    });
    let told: Vec<_> = told.collect();
    assert_eq!(told, expected, "{blocks}\n{:#?}", analysis.diagnostics);
}

const MILL: &str = "T0909\nM45\nG98 G97 S1500 M13\n";
const FACE: &str = "T1111\nM45\nG98 G97 S1500 M13\n";

#[test]
fn a_rapid_into_the_side_is_a_crash() {
    // Outside, down at feed, out again.
    says(&format!("{MILL}G00 X64 Z-20 C0\nG01 X52 F200\nG00 X64"), &[]);
    // Down at rapid.
    says(&format!("{MILL}G00 X64 Z-20 C0\nG00 X52\nG01 C90 F200\nG00 X64"), &["rapid-through-stock 5"]);
    // There is nothing in front of the face.
    says(&format!("{MILL}G00 X64 Z20 C0\nG00 X20\nG01 X10 F200\nG00 X64"), &[]);
}

#[test]
fn a_groove_is_free_where_it_was_milled() {
    let groove = format!("{MILL}G00 X64 Z-20 C0\nG01 X52 F200\nG01 C90\n");
    // Out along X, back along the groove, and down into it a second time.
    says(&format!("{groove}G00 X64"), &[]);
    says(&format!("{groove}G00 C0\nG00 X64"), &[]);
    says(&format!("{groove}G00 X64\nG00 C45\nG00 X53\nG01 X50\nG00 X64"), &[]);
    // Sideways out of it, beyond its end around the axis, and down beside it.
    says(&format!("{groove}G00 Z-40\nG00 X64"), &["rapid-through-stock 7"]);
    says(&format!("{groove}G00 C180\nG00 X64"), &["rapid-through-stock 7"]);
    says(&format!("{groove}G00 X64\nG00 C200\nG00 X53\nG01 X50\nG00 X64"), &["rapid-through-stock 9"]);
    // Deeper than the groove by more than the reach of the cutter. By less, a cutter along Z would already
    // have been there.
    says(&format!("{groove}G00 X64\nG00 C45\nG00 X40\nG01 X38\nG00 X64"), &["rapid-through-stock 9"]);
    // Sideways by less than the cutter radius, it stays within the swept region.
    says(&format!("{groove}G00 Z-22\nG00 X64"), &[]);
}

#[test]
fn holes_are_left_the_way_they_were_drilled() {
    let head = "T0707\nM45\nG98 G97 S1500 M13\nG00 X40 Z5 C0\n";
    says(&format!("{head}G83 Z-20 R-3 Q5000 F100\nC90\nC180\nG80\nG00 Z5"), &[]);
    says(&format!("{head}G01 Z-10 F100\nG00 Z2\nG00 Z-9\nG01 Z-20\nG00 Z5\nC90"), &[]);
    says(&format!("{head}G01 Z-10 F100\nG00 Z5\nC90\nG00 Z-9\nG01 Z-20\nG00 Z5"), &["rapid-through-stock 8"]);
    says(&format!("{head}G01 Z-10 F100\nG00 X60\nG00 Z5\nC90"), &["rapid-through-stock 6"]);
}

#[test]
fn a_pocket_in_the_face_is_free_where_the_cutter_was() {
    let square = "G112\nG42 G01 X40 C0 F200\nC20\nX-40\nC-20\nX40\nC0\nG40 X70\nG113";
    says(&format!("{FACE}G00 X90 Z2 C0\nG00 Z-5\n{square}\nG00 Z2"), &[]);
    let pocket = "G112\nG01 X20 C0 F200\nZ-5\nC8\nX-20\nC-8\nX20\nC0\n";
    says(&format!("{FACE}G00 X20 Z2 C0\n{pocket}G113\nG00 Z2"), &[]);
    says(&format!("{FACE}G00 X20 Z2 C0\n{pocket}G113\nG00 X50\nG00 Z2"), &["rapid-through-stock 14"]);
}

#[test]
fn what_was_turned_off_before_is_free() {
    let turned = "T0101\nG99 G97 S800 M03\nG00 X62 Z2\nG90 X52 Z-30 F0.2\nX44\nG00 X100 Z50\nM05\n";
    let mill = "T0909\nM45\nG98 G97 S1500 M13\nG00 X100 Z-20 C0\n";
    says(&format!("{turned}{mill}G00 X45\nG01 X40 F200\nG00 X100"), &[]);
    says(&format!("{mill}G00 X45\nG01 X40 F200\nG00 X100"), &["rapid-through-stock 5"]);
}
