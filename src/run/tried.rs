//! Tries other values of variables without changing the text.
//!
//! In: the values in the setup, each with its block and the number of the execution. Out: the variables with
//! these values, and the blocks as their origins. A run with such values takes no snapshots, because
//! executions are counted from the start.

use super::Run;
use crate::control::macros::Variables;
use crate::setup::TriedValue;

impl Run {
    /// Gives variables the values to try, before the block at `byte` is executed.
    #[cold]
    pub(super) fn try_values(&mut self, byte: u32) {
        if self.ended {
            return;
        }
        for at in 0..self.tried.len() {
            let tried = self.setup().tried[at];
            if tried.block != byte {
                continue;
            }
            self.tried[at] += 1;
            if self.tried[at] == tried.time {
                self.interpreter.set_tried_value(tried);
            }
        }
    }
}

/// Sets a variable to a value to try; a variable that cannot be written stays unchanged.
pub(super) fn set_tried_value(variables: &mut Variables, tried: TriedValue) {
    let _ = variables.write(tried.variable, Some(tried.value));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::TextEdit;
    use crate::run::replay::VisitChoice;
    use crate::setup::Setup;
    use crate::source::LineIndex;
    use crate::text::parser::Resume;
    use crate::units::Diameter;

    const LOOP: &str =
        "O1\n#1=0\nWHILE[#1LT3]DO1\nG0 X[#1*10] Z0\nG65 P9 A7\n#1=#1+1\nEND1\nM30\nO9\nG0 Z#1\nM99\n";

    fn byte_of(text: &str, line: usize) -> u32 {
        text.split_inclusive('\n').take(line).map(str::len).sum::<usize>() as u32
    }

    fn tried(line: usize, time: u32, variable: u32, value: f64) -> TriedValue {
        TriedValue { block: byte_of(LOOP, line), time, variable, value }
    }

    fn run(text: &str, tried: &[TriedValue]) -> Run {
        let setup = Setup { tried: tried.into(), ..Setup::default() };
        let mut run = Run::new(text.into(), setup);
        while !run.advance(2) {}
        run
    }

    /// X (a diameter) and Z of the end of each motion.
    fn ends(run: &Run) -> Vec<(f64, f64)> {
        run.motions().iter().map(|motion| (Diameter::from_radius(motion.to.x).mm(), motion.to.z)).collect()
    }

    #[test]
    fn a_value_holds_from_its_block_on_in_the_time_that_is_named() {
        assert_eq!(
            ends(&run(LOOP, &[])),
            [(0.0, 0.0), (0.0, 7.0), (10.0, 0.0), (10.0, 7.0), (20.0, 0.0), (20.0, 7.0)]
        );
        // Before the second execution of line 4: the loop also ends one iteration earlier.
        let later = run(LOOP, &[tried(3, 2, 1, 2.5)]);
        assert_eq!(ends(&later), [(0.0, 0.0), (0.0, 7.0), (25.0, 0.0), (25.0, 7.0)]);
        // An execution that never happens changes nothing.
        assert_eq!(ends(&run(LOOP, &[tried(3, 9, 1, 2.5)])), ends(&run(LOOP, &[])));
    }

    #[test]
    fn a_local_variable_of_a_macro_is_that_of_its_call() {
        let within = run(LOOP, &[tried(9, 2, 1, 99.0)]);
        assert_eq!(
            ends(&within),
            [(0.0, 0.0), (0.0, 7.0), (10.0, 0.0), (10.0, 99.0), (20.0, 0.0), (20.0, 7.0)]
        );
    }

    #[test]
    fn the_state_at_the_block_has_the_value_and_names_the_block() {
        let value = tried(3, 2, 1, 2.5);
        let mut run = run(LOOP, &[value]);
        let mut replay = run.replay(Resume::inside(value.block, 3), value.block, VisitChoice::Number(2));
        while !run.advance_replay(&mut replay, 1) {}
        let visit = replay.found().visit.expect("a visit");
        assert_eq!(visit.carried_out, 2);
        let read = |moment: &crate::run::replay::Moment| moment.state.variables.read(1);
        assert_eq!(format!("{:?}", read(&visit.before)), format!("{:?}", read(&visit.after)));
        assert_eq!(visit.after.origins.set_by(0, 1), Some(value.block));
    }

    #[test]
    fn an_edit_counts_from_the_start_again() {
        let mut text = String::from("O1\n#1=0\n");
        for line in 0..3000 {
            text += &format!("G0 X{} Z{}\n", 20 + line % 7, line % 11);
        }
        text += "#1=#1+1\nG0 X[#1*10]\nM30\n";
        let block = byte_of(&text, 3003);
        let setup =
            Setup { tried: vec![TriedValue { block, time: 1, variable: 1, value: 4.0 }], ..Setup::default() };
        let mut run = Run::new(text.clone().into(), setup);
        while !run.advance(usize::MAX) {}
        assert_eq!(ends(&run).last(), Some(&(40.0, f64::from(2999 % 11))));
        assert_eq!(LineIndex::new(run.text()).len(), LineIndex::new(text.as_bytes()).len());
        // An edit of the same length, so the value still belongs to its block.
        let at = byte_of(&text, 2000) as usize + 4;
        run.edit(TextEdit { start: at, end: at + 1, insert: b"9".to_vec() });
        while !run.advance(usize::MAX) {}
        assert_eq!(ends(&run).last(), Some(&(40.0, f64::from(2999 % 11))));
    }
}
