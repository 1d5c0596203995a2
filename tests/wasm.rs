//! Every program of `tests/programs` through the public wasm interface, under Node: the same motions and
//! messages as in the native run, whose output is committed next to each program.
#![cfg(target_arch = "wasm32")]

#[allow(dead_code, reason = "the hostile programs run in the shipped module")]
mod endless;
mod fixtures;

use endless::{MAX_SECONDS, bounds, endless};
use fixtures::{Program, check_messages, compare};
use gcode_playground::wasm::{PictureName, Playground};
use serde_json::Value;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen(module = "fs")]
extern "C" {
    #[wasm_bindgen(js_name = readFileSync)]
    fn read_file(path: &str, encoding: &str) -> String;
    #[wasm_bindgen(js_name = readdirSync)]
    fn read_folder(path: &str) -> Vec<String>;
}

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/programs");

fn all() -> Vec<Program> {
    let mut ids: Vec<String> = read_folder(FOLDER).into_iter().filter(|name| !name.contains('.')).collect();
    ids.sort();
    assert!(ids.len() >= 36, "programs are missing");
    let read = |file: &str| read_file(&format!("{FOLDER}/{file}"), "utf8");
    ids.iter().map(|id| fixtures::program(id, &read)).collect()
}

/// The value returned to JavaScript, as JSON.
fn rows(value: Result<JsValue, JsValue>) -> Vec<Value> {
    let text = js_sys::JSON::stringify(&value.expect("value")).expect("JSON");
    serde_json::from_str(&String::from(text)).expect("rows")
}

fn play(program: &Program) -> Playground {
    let mut playground = Playground::new();
    playground.set_setup(&program.setup).expect("setup");
    playground.set_text(program.text.clone());
    // In slices, as the page runs it.
    while !playground.advance(3) {}
    playground
}

#[wasm_bindgen_test]
fn motions_are_the_expected_ones() {
    let mut checked = 0;
    for program in &all() {
        let found = rows(play(program).motions(0, u32::MAX));
        compare(&program.motions, &found).unwrap_or_else(|why| panic!("{}: {why}", program.id));
        checked += 1;
    }
    assert!(checked >= 25, "only {checked} programs were checked");
}

#[wasm_bindgen_test]
fn messages_are_the_expected_ones() {
    for program in &all() {
        let mut playground = play(program);
        while !playground.remove_material(100) {}
        let found = rows(playground.diagnostics());
        check_messages(program, &found).unwrap_or_else(|why| panic!("{}: {why}", program.id));
    }
}

/// The same output as natively, to the last digit.
#[wasm_bindgen_test]
fn output_equals_the_native_one() {
    for program in all() {
        let playground = play(&program);
        let mut found = rows(playground.motions(0, u32::MAX));
        found.extend(rows(playground.diagnostics()));
        let native: Vec<Value> =
            program.output.lines().map(|line| serde_json::from_str(line).expect("output.jsonl")).collect();
        assert_eq!(found.len(), native.len(), "{}", program.id);
        for (found, native) in found.iter().zip(&native) {
            assert_eq!(numbers_as_doubles(found), numbers_as_doubles(native), "{}", program.id);
        }
    }
}

/// The columns that a page reads contain the same end points as the objects.
#[wasm_bindgen_test]
fn chunks_hold_the_same_motions() {
    for program in all() {
        let playground = play(&program);
        let rows = rows(playground.motions(0, u32::MAX));
        let mut index = 0;
        for chunk in (0..playground.chunk_count()).filter_map(|at| playground.chunk(at)) {
            let (xs, zs, lines) = (chunk.x.to_vec(), chunk.z.to_vec(), chunk.line.to_vec());
            for at in 0..xs.len() {
                // In a virtual plane, X of the program differs from X of the machine.
                let x = rows[index]["machine"]["x"].as_f64().or(rows[index]["to"]["x"].as_f64());
                assert!((x.unwrap() - 2.0 * xs[at]).abs() < 1e-5, "{}", program.id);
                assert!((rows[index]["to"]["z"].as_f64().unwrap() - zs[at]).abs() < 1e-5);
                assert_eq!(rows[index]["line"], lines[at]);
                index += 1;
            }
        }
        assert_eq!(index, rows.len(), "{}", program.id);
    }
}

/// The views of a chunk contain the same numbers as its copy.
#[wasm_bindgen_test]
fn views_of_chunks_hold_the_same_numbers() {
    for program in all() {
        let playground = play(&program);
        for index in 0..playground.chunk_count() {
            let copy = playground.chunk(index).expect("a chunk");
            let view = playground.chunk_view(index).expect("a chunk");
            let read = (view.kind.to_vec(), view.x.to_vec(), view.z.to_vec());
            let copied = (copy.kind.to_vec(), copy.x.to_vec(), copy.z.to_vec());
            assert_eq!(read, copied, "{}", program.id);
        }
        assert!(playground.chunk_view(playground.chunk_count()).is_none());
    }
}

/// A text encoded into the memory of the module is read unchanged.
#[wasm_bindgen_test]
fn a_text_can_be_handed_in_through_the_buffer() {
    let text = "(外圆) G0 X50\nG1 Z-20 F0.2\nM30\n";
    let mut playground = Playground::new();
    // Too small at first, as for a text expected to be ASCII.
    playground.text_buffer(4).expect("room").copy_from(&text.as_bytes()[..4]);
    let room = playground.text_buffer(100).expect("room");
    room.subarray(4, text.len() as u32).copy_from(&text.as_bytes()[4..]);
    playground.set_text_from_buffer(text.len());
    while !playground.advance(1) {}
    assert_eq!(playground.lines_as_written(0, u32::MAX), text);
    assert_eq!(rows(playground.motions(0, u32::MAX)).len(), 2);
}

/// An edited text gives the same result as the same text set directly, with any line ends and characters.
#[wasm_bindgen_test]
fn an_edited_text_runs_as_the_text_it_became() {
    type Edits = &'static [(u32, u32, &'static str)];
    let cases: [(&str, Edits, &str); 4] = [
        ("G0 X50\nG1 Z-20 F0.2\nM30\n", &[(4, 6, "60")], "G0 X60\nG1 Z-20 F0.2\nM30\n"),
        ("(外圆😀) G0 X50\r\nM30\r\n", &[(6, 6, "\n"), (1, 3, "")], "(😀)\n G0 X50\r\nM30\r\n"),
        ("G0 X5\r\nZ1\r\nG33.7\n", &[(5, 6, " ")], "G0 X5 Z1\r\nG33.7\n"),
        ("", &[(0, 0, "G1 X1\nZ1 ; Z2\n")], "G1 X1\nZ1 ; Z2\n"),
    ];
    for (before, edits, after) in cases {
        let mut edited = Playground::new();
        edited.set_text(before.into());
        edited.advance(2);
        for &(from, to, insert) in edits {
            edited.edit(from, to, insert);
        }
        while !edited.advance(1) {}
        let mut fresh = Playground::new();
        fresh.set_text(after.into());
        while !fresh.advance(1) {}
        assert_eq!(edited.lines_as_written(0, u32::MAX), after);
        assert_eq!(rows(edited.motions(0, u32::MAX)), rows(fresh.motions(0, u32::MAX)), "{after:?}");
        assert_eq!(rows(edited.diagnostics()), rows(fresh.diagnostics()), "{after:?}");
        assert_eq!(edited.tokens(0, u32::MAX), fresh.tokens(0, u32::MAX), "{after:?}");
    }
}

/// While a program runs, the view stays; after the run it is fitted to the result.
#[wasm_bindgen_test]
fn the_picture_is_fitted_when_the_run_has_ended() {
    let mut playground = Playground::new();
    playground.resize(PictureName::Section, 400.0, 300.0, 1.0);
    let before = playground.screen_of(PictureName::Section, 10.0, -5.0);
    playground.set_text("G0 X50 Z2\nG1 Z-200 F0.2\nM30\n".into());
    assert!(!playground.advance(2));
    assert_eq!(playground.screen_of(PictureName::Section, 10.0, -5.0), before);
    while !playground.advance(1) {}
    assert_ne!(playground.screen_of(PictureName::Section, 10.0, -5.0), before);
}

/// Every start of a new run removes the tool from the path.
#[wasm_bindgen_test]
fn another_run_begins_without_the_tool() {
    type Change = fn(&mut Playground);
    let changes: [Change; 3] = [
        |playground| playground.set_text("G0 X40\n".into()),
        |playground| playground.edit(4, 5, "4"),
        |playground| playground.set_setup("{}").expect("setup"),
    ];
    for change in changes {
        let mut playground = Playground::new();
        playground.set_text("G0 X50\nG1 Z-20 F0.2\n".into());
        while !playground.advance(1) {}
        playground.seek(0.5);
        assert!(!playground.readout().expect("a stroke").is_undefined());
        change(&mut playground);
        while !playground.advance(1) {}
        assert!(playground.readout().expect("no stroke").is_undefined());
    }
}

#[wasm_bindgen_test]
fn an_unknown_key_of_a_setup_is_named() {
    let mut playground = Playground::new();
    let problem = playground.set_setup(r#"{"dialect": {"kontrol": "gsk"}}"#).expect_err("an error");
    let problem = String::from(problem.unchecked_into::<js_sys::Error>().message());
    assert!(problem.contains("kontrol"), "{problem}");
}

#[wasm_bindgen_test]
fn tokens_and_messages_are_in_utf16_offsets() {
    let mut playground = Playground::new();
    playground.set_text("(外圆😀)\r\nG01 X5\nG33.7 Z1".into());
    while !playground.advance(1) {}
    assert_eq!(playground.tokens(0, 2), [0, 6, 0, 7, 10, 1, 11, 13, 3]);
    let found = rows(playground.diagnostics());
    let unknown = found.iter().find(|row| row["code"] == "PS0010").expect("PS0010");
    assert_eq!((&unknown["from"], &unknown["to"]), (&Value::from(14), &Value::from(19)));
    assert_eq!((&unknown["line"], &unknown["column"]), (&Value::from(3), &Value::from(1)));
}

/// Cycles with a far too small step are rejected within a second, with a message.
#[wasm_bindgen_test]
fn endless_cycles_are_refused_at_once() {
    for case in endless() {
        let mut playground = Playground::new();
        playground.set_setup(case.setup).expect("setup");
        let begun = js_sys::Date::now();
        playground.set_text(case.text);
        while !playground.advance(1_000) {}
        let seconds = (js_sys::Date::now() - begun) / 1_000.0;
        assert!(seconds < MAX_SECONDS, "{}: {seconds} s", case.name);
        let messages = rows(playground.diagnostics());
        assert!(messages.iter().any(|row| row["code"] == case.code), "{}: {messages:?}", case.name);
        // At most the contour of the cycle is drawn, as uncertain.
        let motions = rows(playground.motions(0, u32::MAX));
        assert!(motions.len() <= 10, "{}", case.name);
        let certain = motions.iter().filter(|row| row["uncertain"] != true).count();
        assert_eq!(certain, 1, "{}", case.name);
    }
}

/// Each limit can be set here as well, and is reported for a program that exceeds it by one.
#[wasm_bindgen_test]
fn every_bound_is_exact() {
    for bound in bounds() {
        let is_told = |text: &str| {
            let mut playground = Playground::new();
            playground.set_setup(&bound.setup).expect("setup");
            playground.set_text(text.into());
            while !playground.advance(1) {}
            while !playground.remove_material(1) {}
            rows(playground.diagnostics()).iter().any(|row| row["slug"] == bound.slug)
        };
        assert!(!is_told(&bound.within), "{}", bound.slug);
        assert!(is_told(&bound.beyond), "{}", bound.slug);
    }
}

/// A contour that is read repeatedly ends with a message before the page seems frozen.
#[wasm_bindgen_test]
fn a_long_contour_called_again_and_again_ends_with_a_message() {
    let blocks: String = (0..40_000).map(|block| format!("G1 X{} W-0.001\n", 50 + block % 2)).collect();
    let calls = "G70 P1 Q2\n".repeat(1_000);
    let mut playground = Playground::new();
    let begun = js_sys::Date::now();
    playground.set_text(format!("M3 S500\nG99 F0.2\nN1 G0 X50\n{blocks}G28 U0\nN2 X200\n{calls}M30\n"));
    while !playground.advance(1_000) {}
    let seconds = (js_sys::Date::now() - begun) / 1_000.0;
    assert!(seconds < 10.0, "{seconds} s");
    let messages = rows(playground.diagnostics());
    assert!(messages.iter().any(|row| row["code"] == "E-TOO-MUCH-WORK"), "{seconds} s");
}

/// JavaScript does not distinguish 2 from 2.0.
fn numbers_as_doubles(value: &Value) -> Value {
    match value {
        Value::Number(number) => Value::from(number.as_f64().expect("number")),
        Value::Array(rows) => rows.iter().map(numbers_as_doubles).collect(),
        Value::Object(map) => {
            map.iter().map(|(key, value)| (key.clone(), numbers_as_doubles(value))).collect()
        }
        other => other.clone(),
    }
}

/// The part belongs to the current text.
#[wasm_bindgen_test]
fn a_change_of_the_text_makes_another_part() {
    let mut playground = Playground::new();
    playground.set_setup(r#"{"stock": {"diameter": 60, "length": 50}}"#).expect("setup");
    let part = |playground: &mut Playground| {
        while !playground.advance(100) {}
        while !playground.remove_material(1) {}
        js_sys::JSON::stringify(&playground.part().expect("a part")).map(String::from).expect("JSON")
    };
    playground.set_text("G0 X50 Z2\nG1 Z-20 F1\n".into());
    let first = part(&mut playground);
    playground.edit(4, 6, "40");
    let second = part(&mut playground);
    assert!(first.contains("[0,50]") && second.contains("[0,40]"), "{first} {second}");
}

/// There is no part during the material removal, and requests in the meantime do not change the final part.
#[wasm_bindgen_test]
fn there_is_no_part_before_all_material_is_off() {
    let text = |value: Result<JsValue, JsValue>| {
        js_sys::JSON::stringify(&value.expect("a value")).map(String::from).unwrap_or_default()
    };
    let whole = |interrupted: bool| {
        let mut playground = Playground::new();
        playground.set_text("G0 X60 Z2\n".to_owned() + &"G90 X50 Z-30 F1\nX46\nX40\n".repeat(20));
        while !playground.advance(100) {}
        let mut slices = 0;
        while !playground.remove_material(1) {
            slices += 1;
            if interrupted {
                assert!(playground.part().expect("no part").is_undefined());
                assert_eq!(text(playground.section()), "[]");
                playground.fit(PictureName::Section);
                let _ = playground.draw(PictureName::Section);
            }
        }
        assert!(slices > 100, "{slices}");
        (
            text(playground.part()),
            text(playground.section()),
            playground.screen_of(PictureName::Section, 40.0, -30.0),
        )
    };
    assert_eq!(whole(true), whole(false));
}
