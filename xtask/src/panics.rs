//! In: the linked module of the page, with relocations. Out: the same module in which a panic is a trap and
//! nothing else.
//!
//! No page hears what a panic says: the module has no hook that would hand the text on, and the worker knows a
//! panic by the trap that ends it. So the texts, the places in the source and the code that hands them over
//! are weight alone. Each call of a function that panics becomes `unreachable` here, in as many bytes, and
//! its relocation and those of the addresses before it are left out: wasm-split then finds nobody who needs the
//! texts.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use wasmparser::{KnownCustom, Linking, Parser, Payload, RelocationEntry, RelocationType, SymbolInfo};

use crate::run::Result;

/// Parts of the mangled names of the standard library's functions that panic. One that is not named here
/// stays as it is.
const PANIC: [&str; 14] = [
    "4core9panicking",
    "4core6option13unwrap_failed",
    "4core6option13expect_failed",
    "4core6result13unwrap_failed",
    "4core5slice5index16slice_index_fail",
    "4core3str16slice_error_fail",
    "17len_mismatch_fail",
    "4core4cell22panic_already_borrowed",
    "4core4cell30panic_already_mutably_borrowed",
    "9smallsort22panic_on_ord_violation",
    "5alloc7raw_vec12handle_error",
    "5alloc7raw_vec17capacity_overflow",
    "5alloc5alloc18handle_alloc_error",
    "13assert_failed",
];

/// The custom section with the relocations of the code.
const RELOCATIONS: &str = "reloc.CODE";

/// `call` and its operand, whose five bytes the linker fills.
const CALL: u8 = 0x10;
const CALL_BYTES: usize = 6;

/// `i32.const` and an address, likewise.
const ADDRESS: u8 = 0x41;
const ADDRESS_BYTES: usize = 6;

/// `unreachable`, and `nop` up to the end of the call that was there.
const TRAP: [u8; CALL_BYTES] = [0x00, 0x01, 0x01, 0x01, 0x01, 0x01];

/// The module with traps for panics.
pub fn as_traps(mut module: Vec<u8>) -> Result<Vec<u8>> {
    let linked = Linked::read(&module).map_err(|error| format!("cannot read the linked module: {error}"))?;
    // Addresses by where their instructions end.
    let addresses: BTreeMap<usize, usize> = linked
        .relocations
        .iter()
        .enumerate()
        .filter(|(_, row)| row.entry.ty == RelocationType::MemoryAddrSleb)
        .map(|(index, row)| (linked.code.start + row.entry.offset as usize + ADDRESS_BYTES - 1, index))
        .collect();
    let mut gone = BTreeSet::new();
    for (index, row) in linked.relocations.iter().enumerate() {
        let calls =
            row.entry.ty == RelocationType::FunctionIndexLeb && linked.panics.contains(&row.entry.index);
        let call = linked.code.start + (row.entry.offset as usize).saturating_sub(1);
        if !calls || module[call] != CALL {
            continue;
        }
        module[call..call + CALL_BYTES].copy_from_slice(&TRAP);
        gone.insert(index);
        let mut end = call;
        while let Some(&before) = addresses.get(&end)
            && module[end - ADDRESS_BYTES] == ADDRESS
        {
            gone.insert(before);
            end -= ADDRESS_BYTES;
        }
    }
    if gone.is_empty() {
        return Err(
            "the linked module calls nothing that panics: have the functions other names now?".to_owned()
        );
    }
    let kept = linked.relocations.iter().enumerate().filter(|(index, _)| !gone.contains(index));
    let kept: Vec<&[u8]> = kept.map(|(_, row)| &module[row.bytes.clone()]).collect();
    let section = section(linked.section_of_code, &kept);
    module.splice(linked.section, section);
    Ok(module)
}

/// What has to be known of a linked module.
#[derive(Default)]
struct Linked {
    /// Where the contents of its code section are: relocations count from there.
    code: Range<usize>,
    /// The relocations of the code.
    relocations: Vec<Row>,
    /// Where their section is, from its first byte on.
    section: Range<usize>,
    /// The number of the code section, which that section names.
    section_of_code: u32,
    /// The symbols of functions that panic.
    panics: BTreeSet<u32>,
}

/// A relocation, and where it is written.
struct Row {
    entry: RelocationEntry,
    bytes: Range<usize>,
}

impl Linked {
    fn read(module: &[u8]) -> wasmparser::Result<Self> {
        let mut linked = Self::default();
        let mut end = 0;
        for payload in Parser::new(0).parse_all(module) {
            let payload = payload?;
            let start = end;
            end = match (&payload, payload.as_section()) {
                (Payload::Version { range, .. }, _) => range.end as usize,
                (_, Some((_, range))) => range.end as usize,
                _ => end,
            };
            match payload {
                Payload::CodeSectionStart { range, .. } => {
                    linked.code = range.start as usize..range.end as usize
                }
                Payload::CustomSection(custom) => match custom.as_known() {
                    KnownCustom::Linking(parts) => linked.panics.extend(panics(parts)?),
                    KnownCustom::Reloc(relocations) if custom.name() == RELOCATIONS => {
                        linked.section = start..end;
                        linked.section_of_code = relocations.section_index();
                        let entries = relocations.entries();
                        let ends = entries.range().end as usize;
                        for entry in entries.into_iter_with_offsets() {
                            let (offset, entry) = entry?;
                            let bytes = offset as usize..ends;
                            if let Some(Row { bytes, .. }) = linked.relocations.last_mut() {
                                bytes.end = offset as usize;
                            }
                            linked.relocations.push(Row { entry, bytes });
                        }
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        Ok(linked)
    }
}

/// The symbols of functions that panic.
fn panics(linking: wasmparser::LinkingSectionReader) -> wasmparser::Result<Vec<u32>> {
    let mut found = Vec::new();
    for part in linking {
        let Linking::SymbolTable(symbols) = part? else { continue };
        for (index, symbol) in (0..).zip(symbols) {
            let SymbolInfo::Func { name: Some(name), .. } = symbol? else { continue };
            if PANIC.iter().any(|part| name.contains(part)) {
                found.push(index);
            }
        }
    }
    Ok(found)
}

/// The section of these relocations, from its first byte on.
fn section(of_section: u32, relocations: &[&[u8]]) -> Vec<u8> {
    let mut contents = Vec::new();
    unsigned(RELOCATIONS.len(), &mut contents);
    contents.extend(RELOCATIONS.as_bytes());
    unsigned(of_section as usize, &mut contents);
    unsigned(relocations.len(), &mut contents);
    contents.extend(relocations.concat());
    let mut section = vec![0];
    unsigned(contents.len(), &mut section);
    section.extend(contents);
    section
}

/// A number as WebAssembly writes it (LEB128).
fn unsigned(mut value: usize, to: &mut Vec<u8>) {
    while value > 0x7f {
        to.push(value as u8 | 0x80);
        value >>= 7;
    }
    to.push(value as u8);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A section by its number, or a custom one by its name before the contents.
    fn numbered(number: u8, contents: &[&[u8]]) -> Vec<u8> {
        let contents = contents.concat();
        [&[number, u8::try_from(contents.len()).expect("a short section")], &*contents].concat()
    }

    /// Two functions: one panics, the other calls it with an address, and calls itself. Its relocations are of the
    /// address, of the first call, and of the second.
    fn module(panics: &str) -> Vec<u8> {
        let address = [ADDRESS, 0x90, 0x80, 0x80, 0x80, 0x00];
        let [panic, other] = [0, 1].map(|index| [CALL, 0x80 | index, 0x80, 0x80, 0x80, 0x00]);
        let body = [&[0][..], &address, &panic, &other, &[0x0b]].concat();
        let code = numbered(10, &[&[2, 3, 0, 0, 0x0b], &[body.len() as u8], &body]);
        // Kind, flags, index of the function, length of its name.
        let named = |index: u8, name: &str| [&[0, 0, index, name.len() as u8], name.as_bytes()].concat();
        let symbols = [&[2], &*named(0, panics), &named(1, "other")].concat();
        let linking = numbered(0, &[&[7], b"linking", &[2], &numbered(8, &[&symbols])]);
        // Kind, offset, symbol, and what is added to an address.
        let relocations = [4, 8, 1, 0, 0, 14, 0, 0, 20, 1];
        let relocations = numbered(0, &[&[10], RELOCATIONS.as_bytes(), &[2, 3], &relocations]);
        let types = [numbered(1, &[&[1, 0x60, 0, 0]]), numbered(3, &[&[2, 0, 0]])].concat();
        [b"\0asm\x01\0\0\0", &*types, &code, &linking, &relocations].concat()
    }

    #[test]
    fn a_call_that_panics_becomes_a_trap_and_nothing_refers_to_what_it_says() {
        let before = module("_RNvNtCs_4core9panicking9panic_fmt");
        let after = as_traps(before.clone()).expect("a module with a panic");
        let linked = Linked::read(&after).expect("a module");
        let left: Vec<u32> = linked.relocations.iter().map(|row| row.entry.offset).collect();
        assert_eq!(left, [20], "the call of the other function");
        let code = &after[linked.code.clone()];
        assert_eq!(code[13..19], TRAP);
        assert_eq!(code[19..25], before[linked.code.start + 19..linked.code.start + 25]);
        assert!(Linked::read(&after).is_ok_and(|linked| linked.panics.contains(&0)));
    }

    #[test]
    fn a_module_without_a_panic_is_an_error() {
        assert!(as_traps(module("one")).is_err());
        assert!(as_traps(b"no module".to_vec()).is_err());
    }
}
