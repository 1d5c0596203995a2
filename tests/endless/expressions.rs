//! Expressions of a megabyte.

use super::{Hostile, case, megabyte};

/// Expressions of a megabyte.
pub fn deep_expressions() -> Vec<Hostile> {
    let statement = |of: &str| format!("O1\n#1={}\nM30\n", megabyte(of));
    let address = |of: &str| format!("O1\nG0 X{}\nM30\n", megabyte(of));
    vec![
        case("#[#[#[", format!("O1\n{}\nM30\n", megabyte("#[")), "PS0118", 2),
        case("[[[[", statement("["), "PS0118", 2),
        case("X[[[[", address("["), "PS0118", 2),
        case("SIN[SIN[", statement("SIN["), "PS0118", 2),
        case("XSIN[SIN[", address("SIN["), "PS0118", 2),
        case("X#[#[", address("#["), "PS0118", 2),
        case("-----#1", format!("O1\n#1={}#1 2\nM30\n", megabyte("-")), "PS0114", 2),
        case("X-----#1", format!("O1\nG0 X{}[#1 2]\nM30\n", megabyte("-")), "PS0114", 2),
        case("X- X- X-", address("- X"), "PS0005", 2),
        case("IF THEN IF THEN", format!("O1\n{}\nM30\n", megabyte("IF[1EQ1]THEN ")), "PS0125", 2),
        case("IF IF IF", format!("O1\n{}\nM30\n", megabyte("IF")), "PS0125", 2),
        case("#1=1#1=1", format!("O1\n{}\nM30\n", megabyte("#1=1")), "PS0125", 2),
        case("#1=#1=", format!("O1\n{}\nM30\n", megabyte("#1=")), "PS0125", 2),
        case("]]]]", statement("]"), "PS0114", 2),
        case("1 EQ 1 EQ", format!("O1\nIF[{}1]GOTO 1\nM30\n", megabyte("1 EQ ")), "PS0114", 2),
        case("1 EQ 1 AND", format!("O1\nIF[{}1]GOTO 1\nM30\n", megabyte("1 AND ")), "PS0114", 2),
        case("1 EQ 1 OR [", format!("O1\nIF[1 EQ 1{}]GOTO 1\nM30\n", megabyte(" OR [1]")), "PS0128", 2),
        case("ATAN[1]/ATAN[1]/", statement("ATAN[1]/"), "PS0114", 2),
        case("digits", statement("9"), "PS0111", 2),
        case("a number of a megabyte", address("9"), "PS0003", 2),
        case("letters", statement("A"), "PS0113", 2),
        case("comments in an expression", format!("O1\n#1={}+\nM30\n", megabyte("(A)+1")), "PS0114", 2),
        case("open comments in an expression", statement("+("), "PS0114", 2),
        case(
            "G65 with a million arguments",
            format!("O1\nG65 P2 {}\nM30\nO2\nM99\n", megabyte("A1")),
            "E-BLOCK-TOO-LONG",
            2,
        ),
        case("G65 P1 of a million digits", format!("O1\nG65 P{}\nM30\n", megabyte("1")), "PS0003", 2),
        case("GOTO of a million digits", format!("O1\nGOTO {}\nM30\n", megabyte("1")), "PS0111", 2),
        case("an alarm of a megabyte", format!("O1\n#3000=1({})\nM30\n", megabyte("A")), "E-MACRO-ALARM", 2),
    ]
}
