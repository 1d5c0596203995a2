//! Straight lines of which each part is drawn once.
//!
//! In: lines that may lie on each other, in whole or in part. Out: lines that do not.

use super::super::camera::Pixel;

/// Lines this near to each other are one line, CSS pixels.
const SAME: f64 = 0.75;
/// A smaller gap between two pieces of a line is closed, CSS pixels.
const GAP: f64 = 0.5;
/// Lines beyond this number are drawn as they are.
const MAX_LINES: usize = 5_000;

/// A line without ends, and the parts of it that are drawn.
struct Track {
    from: Pixel,
    /// Unit vector.
    along: Pixel,
    /// Distances from `from`, each pair in order.
    parts: Vec<[f64; 2]>,
}

impl Track {
    /// The distance of a point along the line, and across it.
    fn place(&self, at: Pixel) -> [f64; 2] {
        let (x, y) = (at.x - self.from.x, at.y - self.from.y);
        [x * self.along.x + y * self.along.y, x * self.along.y - y * self.along.x]
    }

    fn at(&self, distance: f64) -> Pixel {
        Pixel::new(self.from.x + distance * self.along.x, self.from.y + distance * self.along.y)
    }

    /// The ends of its parts, with those that touch joined.
    fn joined(mut self) -> Vec<[Pixel; 2]> {
        self.parts.sort_by(|one, other| one[0].total_cmp(&other[0]));
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for part in &self.parts {
            match joined.last_mut().filter(|last| part[0] <= last[1] + GAP) {
                Some(last) => last[1] = last[1].max(part[1]),
                None => joined.push(*part),
            }
        }
        joined.into_iter().map(|ends| ends.map(|distance| self.at(distance))).collect()
    }
}

/// The parts of the plane that some lines cover, as lines.
pub fn each(lines: &[[Pixel; 2]]) -> Vec<[Pixel; 2]> {
    let mut tracks: Vec<Track> = Vec::new();
    for &[from, to] in lines.iter().take(MAX_LINES) {
        let length = from.distance(to);
        if length < f64::EPSILON {
            continue;
        }
        let is_on = |track: &&mut Track| [from, to].iter().all(|end| track.place(*end)[1].abs() <= SAME);
        match tracks.iter_mut().find(is_on) {
            Some(track) => {
                let [a, b] = [from, to].map(|end| track.place(end)[0]);
                track.parts.push([a.min(b), a.max(b)]);
            }
            None => {
                let along = Pixel::new((to.x - from.x) / length, (to.y - from.y) / length);
                tracks.push(Track { from, along, parts: vec![[0.0, length]] });
            }
        }
    }
    let rest = lines.iter().skip(MAX_LINES).copied();
    tracks.into_iter().flat_map(Track::joined).chain(rest).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: [f64; 2], to: [f64; 2]) -> [Pixel; 2] {
        [from, to].map(|[x, y]| Pixel::new(x, y))
    }

    #[test]
    fn lines_on_each_other_become_one() {
        let row =
            [line([0.0, 5.0], [10.0, 5.0]), line([20.0, 5.2], [8.0, 5.0]), line([40.0, 5.0], [50.0, 5.0])];
        assert_eq!(each(&row), [line([0.0, 5.0], [20.0, 5.0]), line([40.0, 5.0], [50.0, 5.0])]);
    }

    #[test]
    fn lines_that_cross_or_are_beside_each_other_stay() {
        let lines = [
            line([0.0, 0.0], [10.0, 0.0]),
            line([0.0, 1.0], [10.0, 1.0]),
            line([5.0, -5.0], [5.0, 5.0]),
            line([0.0, 0.0], [100.0, 3.0]),
        ];
        assert_eq!(each(&lines), lines);
        assert!(each(&[line([1.0, 1.0], [1.0, 1.0])]).is_empty());
    }
}
