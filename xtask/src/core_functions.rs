//! In: the module of the page as it is built first, whole and cut. Out: what the compiler is to do when it builds it again:
//! what the first picture needs is to be quick, all else small.
//!
//! A crate has one level. Level `s` inlines what makes a run quick, level `z` makes the later parts a tenth smaller, where
//! nobody waits for milliseconds. Which function is in the core is known only when the module has been cut, so it is
//! built twice, as a program is that is optimised by what was measured of it. LLVM then gives each function the attribute
//! `minsize`, which is level `z`, but those of the core, and the few of later parts that take most of their time.

use std::collections::BTreeSet;

use wasmparser::{KnownCustom, Name, Parser, Payload};

use crate::run::Result;

/// Rooms of later parts that are to be quick as well: programs with macros, taking material off with the Boolean operations
/// it needs, and the lints that read all words. At level `z` the part takes half as long again, a program of sixty lines
/// a fifth.
const QUICK_ROOMS: [&str; 7] = [
    "gcode_playground::control",
    "gcode_playground::lint::plausible",
    "gcode_playground::machine",
    "i_float",
    "i_overlay",
    "i_shape",
    "i_tree",
];

/// What comes before and after the name of a function that stays as it is.
const QUICK: [&str; 2] = ["llvm-args=-force-remove-attribute=", ":minsize"];

/// The arguments of the compiler, a line each, by which all functions are made small but those of the core and of the
/// quick rooms in the whole module.
pub fn arguments(core: &[u8], whole: &[u8]) -> Result<String> {
    let rooms: Vec<[String; 2]> = QUICK_ROOMS.iter().map(|path| mangled(path)).collect();
    let is_quick = |name: &String| rooms.iter().flatten().any(|path| name.contains(path));
    let mut quick: BTreeSet<String> = names(core)?.into_iter().collect();
    quick.extend(names(whole)?.into_iter().filter(is_quick));
    let mut lines = "-C\nllvm-args=-force-attribute=minsize\n".to_owned();
    for name in quick.iter().filter(|name| is_plain(name)) {
        lines.push_str(&format!("-C\n{}{name}{}\n", QUICK[0], QUICK[1]));
    }
    Ok(lines)
}

/// That the functions which these arguments name are in the module that was built with them. Were they named otherwise
/// in each build, all would be small, and the core slow.
pub fn are_named_in(arguments: &[u8], module: &[u8]) -> Result {
    let arguments = String::from_utf8_lossy(arguments);
    let quick = arguments.lines().filter_map(|line| line.strip_prefix(QUICK[0])?.strip_suffix(QUICK[1]));
    let names: BTreeSet<String> = names(module)?.into_iter().collect();
    let (found, gone): (Vec<&str>, Vec<&str>) = quick.partition(|&name| names.contains(name));
    // Some are merged into others now.
    if found.len() < 9 * gone.len() {
        let count = found.len() + gone.len();
        return Err(format!(
            "only {} of {count} functions that are to be quick have the same names when it is built again",
            found.len()
        ));
    }
    Ok(())
}

/// A path as it is written in the names of functions: of those in it, and of those that implement a trait for what is in it.
fn mangled(path: &str) -> [String; 2] {
    let words = || path.split("::");
    [words().map(|word| format!("{}{word}", word.len())).collect(), words().collect::<Vec<_>>().join("..")]
}

/// The names of all functions, as the compiler knows them.
fn names(module: &[u8]) -> Result<Vec<String>> {
    read_names(module).map_err(|error| format!("cannot read the names of functions: {error}"))
}

fn read_names(module: &[u8]) -> wasmparser::Result<Vec<String>> {
    let mut names = Vec::new();
    for payload in Parser::new(0).parse_all(module) {
        let Payload::CustomSection(custom) = payload? else { continue };
        let KnownCustom::Name(sections) = custom.as_known() else { continue };
        for section in sections {
            let Name::Function(functions) = section? else { continue };
            for function in functions {
                names.push(function?.name.to_owned());
            }
        }
    }
    Ok(names)
}

/// Tools after the compiler have functions of their own, with words for names.
fn is_plain(name: &str) -> bool {
    name.chars().all(|letter| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '.' | '$'))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A module with nothing but the names of some functions.
    fn module(names: &[&str]) -> Vec<u8> {
        let sized = |bytes: Vec<u8>| {
            let size = [bytes.len() as u8 & 0x7f | 0x80, (bytes.len() >> 7) as u8];
            [size.to_vec(), bytes].concat()
        };
        let rows: Vec<u8> = (0..)
            .zip(names)
            .flat_map(|(index, name)| [vec![index], sized(name.as_bytes().to_vec())].concat())
            .collect();
        let list = sized([vec![names.len() as u8], rows].concat());
        let section = [sized(b"name".to_vec()), vec![1], list].concat();
        [b"\0asm\x01\0\0\0".to_vec(), vec![0], sized(section)].concat()
    }

    #[test]
    fn all_but_the_functions_of_the_core_are_made_small() {
        let core = module(&["_ZN4core3one17h1E", "a shim of another tool", "$two.3"]);
        let quick = "_ZN16gcode_playground7machine4part3all17h1E";
        let quick_too =
            "_ZN56_$LT$gcode_playground..machine..part..Part$u20$as$u20$core..fmt..Debug$GT$3fmt17h1E";
        let whole = module(&["_ZN4core3one17h1E", "_ZN16gcode_playground4card17h1E", quick, quick_too]);
        let arguments = arguments(&core, &whole).expect("two modules");
        let named = |names: &[&str]| -> String {
            names
                .iter()
                .map(|name| format!("-C\nllvm-args=-force-remove-attribute={name}:minsize\n"))
                .collect()
        };
        let all = named(&["$two.3", quick, "_ZN4core3one17h1E", quick_too]);
        assert_eq!(arguments, format!("-C\nllvm-args=-force-attribute=minsize\n{all}"));
        let second = module(&["_ZN4core3one17h1E", "$two.3", quick, quick_too]);
        assert_eq!(are_named_in(arguments.as_bytes(), &second), Ok(()));
        let renamed = module(&["_ZN4core3one17h2E", "$two.3", quick, quick_too]);
        assert!(
            are_named_in(arguments.as_bytes(), &renamed).is_err_and(|error| error.starts_with("only 3 of 4"))
        );
    }
}
