//! In: a command line as the reference shows it, such as `check PATH… --setup S.json`. Out: the arguments of
//! a working call, with the files that it needs.

use std::fs;
use std::path::Path;

/// A correct program, one that mills the end face, and one that drills the side.
pub const PROGRAM: &str = "O0001 (STOCK D=40 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X42 Z2\nG90 X36 Z-20 F0.2\nX32\nG00 X100 Z100\nM30\n";
/// An exercise that the program passes.
const EXERCISE: &str = "---\nid: step\n---\n\n```setup\n(STOCK D=40 LENGTH=60)\n```\n\n```target\nX0 Z0\nX32\nZ-20\nX40\nZ-30 free\n```\n\n# en: A step\n\nTurn it.\n";
const FACE: &str = "O0002 (STOCK D=80 LENGTH=60)\nT0101\nG98 G97 S800 M13\nM45\nG00 X100 Z2\nG12.1\nG01 X50 F100\nC20\nG13.1\nG00 X150 Z100\nM46\nM30\n";
const SIDE: &str = "O0003 (STOCK D=60 LENGTH=60)\n(TOOL T0303 TYPE=DRILL D=8)\nM45\nG28 H0\nT0303\nG97 S900 M13\nG00 X66 Z-30 C0\nG98 G87 Z-30 C0 X30 R-1 F80\nC90\nG80\nG00 X150 Z100\nM46\nM30\n";

/// The arguments of a call. Files are written into a folder and replace `FILE` and similar placeholders.
pub fn arguments(words: &[String], folder: &Path) -> Vec<String> {
    let names = |view: &str| words.iter().any(|word| word == view);
    let program = match (names("face"), names("side")) {
        (true, _) => FACE,
        (_, true) => SIDE,
        _ => PROGRAM,
    };
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let write = |name: &str, text: &str| {
        fs::write(folder.join(name), text).expect(name);
        path(name)
    };
    let one = |word: &String| match word.as_str() {
        "FILE" | "A" | "part.nc" => vec![write("part.nc", program)],
        "PAGE…" => vec![write("page.html", "<gcode-playground>\nM30\n</gcode-playground>\n")],
        "EXERCISE" => vec![write("exercise.md", EXERCISE)],
        "ANSWER…" => vec![write("part.nc", program), write("second.nc", program)],
        "MANUAL…" => vec![
            write("page.md", &format!("```gcode\n{program}```\n")),
            write("page.rst", ".. code-block:: gcode\n\n   M30\n"),
        ],
        "B" => vec![write("other.nc", &program.replace("X32", "X30"))],
        "PATH…" | "FOLDER" => {
            fs::create_dir_all(folder.join("programs")).expect("a folder");
            write("programs/part.nc", program);
            vec![path("programs")]
        }
        "PATTERN" => vec!["old/**".to_owned()],
        "ENDING" => vec!["nc".to_owned()],
        "RULE" => vec!["thread-angle".to_owned()],
        "ADDRESS" => vec!["https://playground.example/rules".to_owned()],
        "RULE=LEVEL" => vec!["thread-angle=warning".to_owned()],
        "CONF.toml" => vec![write("conf.toml", "ignore = [\"no-program-end\"]\n")],
        "KNOWN.json" => vec![write("known.json", "[]")],
        "FILE…" => vec![write("part.nc", program), write("second.nc", program)],
        "TEXT" => vec![write("page.txt", &format!("An example:\n\n{program}\nIt turns a step.\n"))],
        "S.json" => vec![write("setup.json", r#"{"stock": {"diameter": 40, "length": 60}}"#)],
        "NAME" => vec!["gsk".to_owned()],
        "L" => vec!["ru".to_owned()],
        "N" => vec!["1".to_owned()],
        "FIGURE" => vec!["cycle".to_owned()],
        "MM" => vec!["160".to_owned()],
        out if out.starts_with("OUT") => vec![path(out)],
        word => vec![word.to_owned()],
    };
    words.iter().flat_map(one).collect()
}
