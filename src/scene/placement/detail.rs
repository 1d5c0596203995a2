//! Places a detail: a part of the picture at a larger scale, in a free area.
//!
//! In: a detail in mm, and the free space. Out: its drawing with its own labels, and the circle around it.

use super::super::annotation::{Annotation, Detail};
use super::super::camera::Pixel;
use super::super::hatch::hatch;
use super::super::occupied::{Occupied, Rectangle};
use super::lines::{RAPID, dashed};
use super::{LABEL_HEIGHT, PlaceOfRows, PlacedLabel, Placing, ROW_STEP, size_of};
use crate::geometry::Point;
use crate::geometry::bounds::Bounds;

/// Scales of a detail relative to the picture, and the greatest width and height of its lines, CSS pixels.
const DETAIL_SCALES: [f64; 7] = [50.0, 40.0, 20.0, 10.0, 8.0, 5.0, 2.0];
const DETAIL_SIZE: [f64; 2] = [260.0, 150.0];
/// Space for the labels of a detail to its left and right, and above and below, CSS pixels.
const DETAIL_ROOM: [f64; 2] = [96.0, 48.0];
/// Least radius of the circle around what is enlarged, CSS pixels.
const LEAST_CIRCLE: f64 = 7.0;
/// The names of the details of a picture.
const DETAIL_NAMES: [&str; 4] = ["I", "II", "III", "IV"];

impl Placing<'_> {
    /// A circle around the detail, and its drawing in a free area, at the largest scale that fits. Returns the name at
    /// the circle; `None` without room.
    pub(super) fn add_detail(&mut self, detail: &Detail) -> Option<Annotation> {
        let middle = self.camera.to_screen(detail.at);
        let radius = (detail.radius * self.camera.scale()).max(LEAST_CIRCLE);
        let circle = (0..=32).map(|step| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 32.0).sin_cos();
            Pixel::new(middle.x + radius * cos, middle.y + radius * sin)
        });
        self.placed.lines.push(circle.collect());
        let mut sizes = detail_sizes(detail, self.camera.scale());
        let Some((scale, area)) = sizes.find_map(|(scale, size)| Some((scale, self.free_area(size)?))) else {
            self.placed.lines.pop();
            return None;
        };
        let mut camera = *self.camera;
        camera.zoom(scale, camera.to_screen(detail.at));
        let Bounds { min, max } = bounds_of(detail);
        let middle = Point::new((min.x + max.x) / 2.0, (min.z + max.z) / 2.0);
        let (from, to) = (camera.to_screen(middle), area.middle());
        camera.pan(to.x - from.x, to.y - from.y);
        let on_screen = |lines: &[Vec<Point>]| -> Vec<Vec<Pixel>> {
            let line = |line: &Vec<Point>| line.iter().map(|at| camera.to_screen(*at)).collect();
            lines.iter().map(line).collect()
        };
        let [lines, edges, part] = [&detail.lines, &detail.edges, &detail.part].map(|own| on_screen(own));
        let hatch = hatch(&part, camera.to_screen(detail.at), camera.size());
        let rapids: Vec<[Pixel; 2]> =
            detail.rapids.iter().map(|ends| ends.map(|at| camera.to_screen(at))).collect();
        let all = lines.iter().chain(&edges).cloned().chain(rapids.iter().map(|ends| ends.to_vec()));
        let occupied = Occupied::of_lines(&all.collect::<Vec<_>>(), &camera);
        // Below its title.
        let room = Rectangle { min: Pixel::new(area.min.x, area.min.y + LABEL_HEIGHT), max: area.max };
        let name = DETAIL_NAMES.get(self.details).copied().unwrap_or_default();
        self.details += 1;
        let text = format!("{name} ×{scale}");
        let [width, height] = size_of(&text);
        let title = Rectangle::around(Pixel::new(area.middle().x, area.min.y + height / 2.0), width, height);
        let title = PlacedLabel { text, area: title };
        let mut inner = Placing::new(room, &occupied, &camera, self.unit);
        inner.placed.labels.push(title);
        inner.place_of_rows = PlaceOfRows::Outside;
        inner.rows = std::mem::take(&mut self.rows);
        let own_rows = inner.rows.len();
        inner.add_all(&detail.annotations);
        let Placing { placed, mut rows, .. } = inner;
        rows.iter_mut().skip(own_rows).for_each(|(_, label)| *label += self.placed.labels.len());
        self.rows = rows;
        self.placed.lines.extend(lines.into_iter().chain(placed.lines));
        self.placed.lines.extend(rapids.into_iter().flat_map(|ends| dashed(ends, RAPID)));
        self.placed.edges.extend(edges);
        self.placed.hatch.extend(hatch);
        self.placed.heads.extend(placed.heads);
        self.placed.dots.extend(placed.dots);
        self.placed.ends.extend(placed.ends);
        self.placed.labels.extend(placed.labels);
        self.placed.omitted.extend(placed.omitted);
        Some(Annotation::note(detail.at, name))
    }

    /// A free area of a size, from right to left: below the picture as high as possible, or else as low as possible.
    fn free_area(&self, [width, height]: [f64; 2]) -> Option<Rectangle> {
        let [across, down] = self.inside(2.0);
        let steps = |room: f64| if room < 0.0 { 0 } else { (room / ROW_STEP) as usize + 1 };
        let columns = steps(across[1] - across[0] - width);
        let first = self.occupied.down().map_or(down[0], |[_, lowest]| lowest) + height;
        let below = (0..steps(down[1] - first)).map(|step| first + ROW_STEP * step as f64);
        let lines = (0..steps(down[1] - down[0] - height)).map(|step| down[1] - ROW_STEP * step as f64);
        let lines = below.chain(lines);
        let mut areas = lines.flat_map(|bottom| {
            (0..columns).map(move |step| {
                let right = across[1] - ROW_STEP * step as f64;
                let min = Pixel::new(right - width, bottom - height);
                Rectangle { min, max: Pixel::new(right, bottom) }
            })
        });
        areas.find(|area| self.is_free(area))
    }
}

/// The scales of a detail that are small enough, the largest first, each with the size of the drawing and its labels,
/// CSS pixels; `scale`: that of the picture.
pub fn detail_sizes(detail: &Detail, scale: f64) -> impl Iterator<Item = (f64, [f64; 2])> {
    let bounds = bounds_of(detail);
    let own = [bounds.length() * scale, bounds.height() * scale];
    let sizes = DETAIL_SCALES.into_iter().map(move |factor| (factor, own.map(|length| factor * length)));
    sizes.filter(|(_, size)| size[0] <= DETAIL_SIZE[0] && size[1] <= DETAIL_SIZE[1]).map(
        |(factor, [width, height])| {
            let [beside, around] = DETAIL_ROOM;
            (factor, [width + 2.0 * beside, height + 2.0 * around])
        },
    )
}

fn bounds_of(detail: &Detail) -> Bounds {
    let Detail { lines, edges, part, rapids, .. } = detail;
    let corners = [lines, edges, part].into_iter().flatten().flatten();
    let corners = corners.chain(rapids.iter().flatten());
    corners.fold(Bounds::of(detail.at), |bounds, at| bounds.with(*at))
}
