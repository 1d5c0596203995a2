//! The rows of a picture: texts of labels that are only a number.
//!
//! In: texts without a place at their annotations. Out: numbers there, and the texts in free areas.

use super::super::camera::Pixel;
use super::super::occupied::Rectangle;
use super::candidates::Candidate;
use super::{LABEL_HEIGHT, PlaceOfRows, PlacedLabel, Placing, ROW_STEP, row_of, size_of};

/// Space between the picture and rows below it, CSS pixels.
const BELOW: f64 = 8.0;

impl Placing<'_> {
    /// The number of the next row; with its sign it is no number of a pass.
    pub(super) fn next_number(&self) -> String {
        format!("*{}", self.rows.len() + 1)
    }

    /// Draws an annotation with a number, whose text is in a row.
    pub(super) fn draw_number(&mut self, candidate: Candidate, number: String, text: &str) {
        let row = row_of(&number, text);
        self.draw(candidate, number);
        self.rows.push((row, self.placed.labels.len() - 1));
    }

    /// Whether the texts of all numbers and one more text have room.
    pub(super) fn has_room_for_row(&self, text: &str) -> bool {
        if self.place_of_rows == PlaceOfRows::Outside {
            return true;
        }
        let row = (row_of(&self.next_number(), text), 0);
        let rows: Vec<(String, usize)> = self.rows.iter().cloned().chain([row]).collect();
        self.free_block(&rows).is_some()
    }

    /// Adds the texts of the numbers where the picture is free, in as few blocks as possible. The labels of the
    /// texts without room are omitted.
    pub(super) fn add_rows(&mut self) {
        let mut rows = std::mem::take(&mut self.rows);
        while !rows.is_empty() {
            let first = |count: usize| Some((count, self.free_block(&rows[..count])?));
            let Some((count, at)) = (1..=rows.len()).rev().find_map(first) else { break };
            for (row, (text, _)) in rows.drain(..count).enumerate() {
                let min = Pixel::new(at.x, at.y + LABEL_HEIGHT * row as f64);
                let max = Pixel::new(min.x + size_of(&text)[0], min.y + LABEL_HEIGHT);
                self.placed.labels.push(PlacedLabel { text, area: Rectangle { min, max } });
            }
        }
        let (texts, omitted): (Vec<String>, Vec<usize>) = rows.into_iter().unzip();
        self.placed.omitted.extend(texts);
        let mut index = 0;
        self.placed.labels.retain(|_| {
            index += 1;
            !omitted.contains(&(index - 1))
        });
    }

    /// The upper left corner of a free area for rows, from the right to the left: below the picture and its annotations,
    /// at the upper or lower border, then anywhere else.
    pub(super) fn free_block(&self, rows: &[(String, usize)]) -> Option<Pixel> {
        let width = rows.iter().map(|(text, _)| size_of(text)[0]).fold(0.0, f64::max);
        let height = LABEL_HEIGHT * rows.len() as f64;
        let [across, down] = self.inside(4.0);
        let steps = |room: f64| (room.max(0.0) / ROW_STEP) as usize;
        let (columns, lines) = (steps(across[1] - across[0] - width), steps(down[1] - down[0] - height));
        let row =
            |y: f64| (0..=columns).map(move |step| Pixel::new(across[1] - width - ROW_STEP * step as f64, y));
        let drawn = [self.placed.down(), self.occupied.down()].into_iter().flatten();
        let below = drawn.map(|[_, lowest]| lowest + BELOW).fold(down[0], f64::max);
        let below = Some(below).filter(|below| *below <= down[1] - height).into_iter();
        let borders = below.chain([down[0], down[1] - height]);
        let others = (1..lines).map(|step| down[1] - height - ROW_STEP * step as f64);
        borders
            .chain(others)
            .flat_map(row)
            .find(|at| self.is_free(&Rectangle { min: *at, max: Pixel::new(at.x + width, at.y + height) }))
    }
}
