//! The current run, everything derived from it, and how it is viewed.
//!
//! In: the text, its edits and the setup; time slices; the camera and the selection of the user. Out:
//! [`Current`]: the motions, the part, and the [`Picture`]s that a painter draws. A picture shows one run
//! only: all data derived from a run is in one value, `Derived`, which `Current::begin` replaces as a whole
//! when the next run begins. The part is available only once all its material is removed
//! ([`crate::machine::Simulation`]). Must not know of canvases or JavaScript.

pub(crate) mod machined;
mod material;
pub mod measuring;
pub mod per_plane;
mod picked;
pub mod question;
mod view_state;

use std::cell::OnceCell;
use std::ops::Range;

use crate::assist::Query;
use crate::figures;
use crate::geometry::Point;
use crate::machine::SimulationResult;
use crate::machine::compare::Comparison;
use crate::machine::feature::{self, Feature};
use crate::machine::live_holes::LiveHole;
use crate::machine::region::Region;
use crate::machine::resolved_setup::ResolvedSetup;
use crate::motion::{MotionKind, Motions};
use crate::parts::{Part, late};
use crate::playback::clock::{Clock, Playhead};
use crate::playback::holds::lines_that_move;
use crate::run::replay::{Found, Replay, VisitChoice, block_at};
use crate::run::{Run, TextEdit};
use crate::scene::annotation::Annotate;
use crate::scene::camera::{Pixel, Size, XPlus};
use crate::scene::path_index::PathIndex;
use crate::scene::pick::pick;
use crate::scene::side::Side;
use crate::scene::source::{Picture, Source, Stage};
use crate::scene::steps::labels;
use crate::scene::surface_moves::SurfaceMoves;
use crate::scene::view::{Frame, View};
use crate::scene::{Place, Plane, Scene};
use crate::setup::{Setup, Turret};
use crate::source::LineIndex;
use crate::text::parser::Resume;
use crate::units::Unit;
use machined::{Kept, Machined};
use material::Material;
use per_plane::PerPlane;
use view_state::ViewState;

/// The current run and how it is viewed.
pub struct Current {
    run: Run,
    /// The lines of the text; built on first use.
    lines: OnceCell<LineIndex>,
    /// Keeps the boxes of the motions that an edit leaves unchanged; it detects itself which those are.
    path_index: PathIndex,
    derived: Derived,
    view_state: ViewState,
}

/// All data derived from the current run; a new run begins without any of it.
#[derive(Default)]
struct Derived {
    /// Whether the path index matches the current motions.
    measured: bool,
    /// The clock of the current motions; built on first use.
    clock: OnceCell<Clock>,
    /// The argument and result of the last call of `lines_that_move`.
    moving_lines: (Vec<u32>, Vec<u32>),
    material: Material,
}

impl Current {
    /// Begins a run. Its picture is 300 × 150 CSS pixels, the default size of a canvas.
    pub fn new(text: Vec<u8>, setup: Setup) -> Self {
        let (run, path_index) = (Run::new(text, setup), PathIndex::new());
        let scene = Scene::new(run.motions(), &path_index, None);
        let views = PerPlane::new(|plane| {
            let height = match plane {
                Plane::Section => 150.0,
                Plane::Face | Plane::Side => 300.0,
            };
            View::new(&scene.on(plane), Size { width: 300.0, height })
        });
        let (lines, derived) = (OnceCell::new(), Derived::default());
        Self { run, lines, path_index, derived, view_state: ViewState::new(views) }
    }

    // ---- from one run to the next ---------------------------------------------------------------------

    /// Begins a run of another text.
    pub fn set_text(&mut self, text: Vec<u8>, setup: Setup) {
        self.begin(|run, lines| {
            *lines = OnceCell::new();
            *run = Run::new(text, setup);
        });
    }

    /// Begins a run of the same text with another setup.
    pub fn set_setup(&mut self, setup: Setup) {
        self.begin(|run, _| run.set_setup(setup));
    }

    /// Restarts the run if a part that it lacks has been loaded since. Returns whether it restarted.
    pub fn rerun_if_outdated(&mut self) -> bool {
        let begins = self.run.is_outdated();
        if begins {
            self.begin(|run, _| run.rerun());
        }
        begins
    }

    /// Decides again, for the current text, what numbers without a decimal point count; restarts the run if
    /// the rule changes.
    pub fn reinfer_decimal_rule(&mut self) {
        self.begin(|run, _| {
            run.reinfer_decimal_rule();
        });
    }

    /// Begins a run of the text with `from..to` (UTF-16 offsets) replaced. Results from before that place are
    /// reused.
    pub fn edit(&mut self, from: u32, to: u32, insert: &str) {
        let text = self.run.text();
        let start = self.lines().byte_at_utf16(text, from) as usize;
        let end = (self.lines().byte_at_utf16(text, to) as usize).max(start);
        let edit = TextEdit { start, end, insert: insert.into() };
        if EDITING.is_loaded() {
            continue_edited(self, edit);
        } else {
            self.begin(|run, lines| {
                *lines = OnceCell::new();
                run.edit(edit);
            });
        }
    }

    /// Continues the run with the changed text, and updates the lines.
    fn continue_edited(&mut self, edit: TextEdit) {
        let (place, inserted) = (edit.start..edit.end, edit.insert.len());
        self.begin(|run, lines| {
            run.edit(edit);
            if let Some(lines) = lines.get_mut() {
                lines.edit(run.text(), place, inserted);
            }
        });
    }

    /// The only way from one run to the next: drops the data derived from the run and keeps the state of the
    /// user.
    fn begin(&mut self, change: impl FnOnce(&mut Run, &mut OnceCell<LineIndex>)) {
        change(&mut self.run, &mut self.lines);
        self.derived = Derived::default();
        self.view_state.drop_selections();
    }

    /// Runs at most `blocks` blocks; returns true once the run has ended.
    pub fn advance(&mut self, blocks: usize) -> bool {
        if !self.run.is_finished() {
            self.invalidate_motions();
            self.run.advance(blocks);
        }
        self.run.is_finished()
    }

    /// Ends the run early, after `seconds` seconds, and reports that.
    pub fn stop(&mut self, seconds: f64) {
        self.invalidate_motions();
        self.run.stop(seconds);
    }

    /// Discards what depends on the number of motions.
    fn invalidate_motions(&mut self) {
        self.derived.measured = false;
        self.derived.clock = OnceCell::new();
        self.derived.moving_lines = Default::default();
    }

    // ---- the material ---------------------------------------------------------------------------------

    /// Removes the material of at most `motions` motions, once the run has ended; returns true when all is
    /// removed.
    pub fn remove_material(&mut self, motions: usize) -> bool {
        if !self.run.is_finished() {
            return false;
        }
        remove_material(self, motions)
    }

    /// Stops removing material, and reports that.
    pub fn stop_machining(&mut self) {
        stop_machining(self);
    }

    /// Removes all remaining material, if the program has finished.
    pub fn finish_part(&mut self) {
        while self.run.is_finished() && !self.remove_material(usize::MAX) {}
    }

    /// The fraction of the motions whose material has been removed, 0 to 1.
    pub fn machining_progress(&self) -> f64 {
        self.derived.material.progress()
    }

    fn finish_material(&mut self, simulation: SimulationResult) {
        // The path index may still be that of the previous program.
        self.measure();
        let mut machined = Machined::new(simulation, self.run.motions());
        machined.compare(&self.run, self.view_state.kept.as_ref());
        self.derived.material = Material::Off(Box::new(machined));
        self.view_state.section_mut().edge.clear();
        self.show();
        self.turn();
        for plane in Plane::SURFACES {
            let (scene, view) = self.scene_and_view(plane);
            view.follow(&scene);
        }
    }

    // ---- access to the run ----------------------------------------------------------------------------

    /// The run.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// Starts a replay of the run, up to the block at `byte`.
    pub fn replay(&self, byte: u32, time: VisitChoice) -> Replay {
        self.run.replay(self.begin_of_line(byte), byte, time)
    }

    /// Starts a replay like [`Current::replay`]. It may continue from the block of an earlier one.
    pub fn replay_after(&self, earlier: Replay, byte: u32, time: VisitChoice) -> Replay {
        self.run.replay_after(earlier, self.begin_of_line(byte), byte, time)
    }

    /// The position at the beginning of the line that contains `byte`.
    fn begin_of_line(&self, byte: u32) -> Resume {
        let (text, lines) = (self.run.text(), self.lines());
        let line = lines.line_of(byte.min(text.len() as u32));
        Resume::inside(lines.line(text, line).start, line)
    }

    /// The first byte of the block at a UTF-16 offset.
    pub fn start_of_block(&self, offset: u32) -> u32 {
        let text = self.run.text();
        let byte = self.lines().byte_at_utf16(text, offset);
        block_at(text, self.begin_of_line(byte), byte).0.start.byte
    }

    /// Continues a replay for at most `blocks` blocks; returns true once it has ended.
    pub fn advance_replay(&mut self, replay: &mut Replay, blocks: usize) -> bool {
        self.run.advance_replay(replay, blocks)
    }

    /// The motions of the run.
    pub fn motions(&self) -> &Motions {
        self.run.motions()
    }

    /// The lines of the text.
    pub fn lines(&self) -> &LineIndex {
        self.lines.get_or_init(|| LineIndex::new(self.run.text()))
    }

    /// How far the run has progressed.
    pub fn stage(&self) -> Stage {
        match self.machined() {
            Some(_) => Stage::Whole,
            None if self.run.is_finished() => Stage::Path,
            None => Stage::Running,
        }
    }

    /// The result of the simulation, once all material is removed.
    pub fn simulation(&self) -> Option<&SimulationResult> {
        self.machined().map(Machined::simulation)
    }

    /// Tools and blank, once the program has finished and material is being removed.
    pub fn resolved_setup(&self) -> Option<&ResolvedSetup> {
        self.derived.material.resolved_setup()
    }

    /// The finished part, once all material is removed. `None` without a blank, or if a limit was reached.
    pub fn part(&self) -> Option<&Region> {
        self.machined()?.part()
    }

    /// The part at the moment that is shown.
    pub fn part_shown(&mut self) -> Option<Region> {
        self.show();
        self.machined()?.part_shown(self.run.motions())
    }

    /// The holes of live tools in the part at that moment.
    pub fn holes_shown(&mut self) -> Vec<LiveHole> {
        self.show();
        self.machined().map_or_else(Vec::new, |machined| machined.holes_shown(self.run.motions()))
    }

    /// The moves over a surface. `None` if nothing moves over it, and for the section.
    pub fn moves(&self, plane: Plane) -> Option<&SurfaceMoves> {
        self.machined()?.moves(plane)
    }

    /// The view from the side, if anything moves there.
    pub fn side(&self) -> Option<&Side> {
        self.machined()?.side()
    }

    /// The differences between the part and the one kept for comparison.
    pub fn comparison(&self) -> Option<&Comparison> {
        self.machined()?.comparison()
    }

    /// The clock of the motions.
    pub fn clock(&self) -> &Clock {
        self.derived.clock.get_or_init(|| Clock::new(self.run.motions(), &self.run.setup().machine))
    }

    /// For each of these lines, from 0, the first line from there on whose blocks move the tool; in order.
    pub fn lines_that_move(&mut self, lines: &[u32]) -> Vec<u32> {
        if self.derived.moving_lines.0 != lines {
            self.derived.moving_lines = (lines.into(), lines_that_move(self.run.motions(), lines));
        }
        self.derived.moving_lines.1.clone()
    }

    fn machined(&self) -> Option<&Machined> {
        self.derived.material.machined()
    }

    // ---- views ----------------------------------------------------------------------------------------

    /// The view of a picture.
    pub fn view(&self, plane: Plane) -> &View {
        &self.view_state.views[plane]
    }

    /// Changes the view of a picture.
    pub fn look(&mut self, plane: Plane, change: impl FnOnce(&mut View, &Scene)) {
        self.show();
        let (scene, view) = self.scene_and_view(plane);
        change(view, &scene);
    }

    /// The motion whose stroke is within `reach` of a position in a picture, both in CSS pixels, and the tool
    /// position there, in coordinates of the section.
    pub fn pick(&mut self, plane: Plane, at: Pixel, reach: f64) -> Option<(usize, Point)> {
        let Picture { scene, view, .. } = self.picture(plane)?;
        let found = pick(&scene, view.camera(), at, reach, &view.highlight)?;
        let motion = found.stroke.motion;
        if plane == Plane::Section {
            return Some((motion, found.at));
        }
        let motion = self.moves(plane)?.motion(motion)?;
        let end = self.motions().get_on_workpiece(motion).to;
        let at = match plane {
            Plane::Section => found.at,
            Plane::Face => Point::new(found.at.x.hypot(found.at.z), end.z),
            Plane::Side => Point::new(end.x, found.at.z),
        };
        Some((motion, at))
    }

    /// Highlights the strokes of lines, from 0, while there is no cursor.
    pub fn set_marked_lines(&mut self, lines: Vec<Range<u32>>) {
        self.view_state.marked = lines;
        if self.derived.measured {
            self.highlight();
        }
    }

    /// Highlights the strokes of the block at an offset.
    pub fn set_cursor(&mut self, offset: Option<u32>) {
        self.view_state.cursor = offset;
        if self.view_state.annotate != Annotate::Part {
            self.view_state.clear_annotations();
        }
        // If nothing is measured yet, `measure` will highlight them.
        if self.derived.measured {
            self.highlight();
        }
    }

    /// Chooses the annotations; [`Self::annotate`] makes them.
    pub fn set_annotate(&mut self, annotate: Annotate) {
        self.view_state.annotate = annotate;
        self.view_state.clear_annotations();
        let frame = match annotate {
            Annotate::None | Annotate::Word => None,
            Annotate::Cycle => Some(Frame::Cuts),
            Annotate::Part => Some(Frame::Part),
        };
        self.look(Plane::Section, |view, scene| view.set_labels(scene, frame));
    }

    /// Makes the chosen annotations of the finished run. `asked`: the place of the cursor, and the execution of
    /// its block.
    pub fn annotate(&mut self, asked: Option<(u32, &Found)>) {
        let annotations = match self.view_state.annotate {
            Annotate::None => Vec::new(),
            Annotate::Word => asked.map_or_else(Vec::new, |(byte, found)| {
                let block = found.block(&self.run);
                figures::at_cursor(&Query::new(&self.run, found, &block), byte, self.run.motions())
            }),
            Annotate::Cycle => {
                let first = || figures::first_cycle(&self.run).filter(|_| self.view_state.cursor.is_none());
                let byte = asked.map(|(byte, _)| byte).or_else(first);
                byte.map_or_else(Vec::new, |byte| figures::of_cycle(&mut self.run, byte).annotations)
            }
            Annotate::Part => self.machined().map_or_else(Vec::new, |machined| {
                let dimensions = |part| figures::of_part(part, machined.threads(), self.run.motions());
                machined.part().map_or_else(Vec::new, dimensions)
            }),
        };
        self.view_state.section_mut().annotations = annotations;
        let milled = self.moves(Plane::Face).filter(|_| self.view_state.annotate == Annotate::Cycle);
        let letters = milled.map_or_else(Vec::new, figures::of_face);
        self.view_state.views[Plane::Face].annotations = letters;
    }

    /// Marks the stroke under the pointer.
    pub fn set_hover(&mut self, motion: Option<usize>) {
        let motion = motion.filter(|&index| index < self.run.motions().len());
        self.view_state.section_mut().hover = motion;
        if HIGHLIGHTING.is_loaded() {
            name_steps(self);
        }
    }

    /// Sets the symbols of millimetre and inch on the rulers, in the user's language.
    pub fn set_unit_symbols(&mut self, symbols: [&'static str; 2]) {
        self.view_state.unit_symbols = symbols;
        self.count_in_unit();
    }

    /// Chooses the unit in which lengths are shown; `None` for the unit of the program.
    pub fn set_unit(&mut self, unit: Option<Unit>) {
        self.view_state.unit = unit;
        self.count_in_unit();
    }

    /// The unit that the user has chosen.
    pub fn chosen_unit(&self) -> Option<Unit> {
        self.view_state.unit
    }

    /// The unit in which lengths are shown.
    pub fn unit(&self) -> Unit {
        self.view_state.unit.unwrap_or(self.run.state().unit)
    }

    /// Sets the unit of the rulers to the displayed unit.
    #[inline(never)]
    fn count_in_unit(&mut self) {
        let unit = self.unit();
        self.view_state.set_scale(unit);
    }

    /// Moves the tool to a position; `None` shows all strokes and no tool.
    pub fn seek(&mut self, playhead: Option<Playhead>) {
        let playhead = playhead.filter(|_| !self.run.motions().is_empty());
        self.view_state.section_mut().playhead = playhead;
    }

    /// Moves the tool to the start of the block at a UTF-16 offset, or of the next block that moves it.
    pub fn seek_block(&mut self, offset: u32) {
        self.measure();
        let motion = picked::first_motion(&self.run, self.lines(), &self.scene(), offset);
        self.seek(motion.map(|motion| Playhead { motion, share: 0.0 }));
    }

    /// Scrolls a picture that the user has moved, so that the tool stays in view while it cuts.
    pub fn keep_tool_in_view(&mut self) {
        let Some((playhead, place)) = self.place() else { return };
        if self.run.motions().get(playhead.motion).kind != MotionKind::Rapid {
            self.look(Plane::Section, |view, _| view.keep_in_view(place.at));
        }
    }

    /// The position of the tool.
    pub fn place(&mut self) -> Option<(Playhead, Place)> {
        self.measure();
        let playhead = self.view_state.section().playhead?;
        Some((playhead, self.scene().place(playhead)?))
    }

    /// Chooses the side of the turret; `None` for the side in the setup.
    pub fn set_turret(&mut self, turret: Option<Turret>) {
        self.view_state.turret = turret;
        self.turn();
    }

    /// The side on which the turret is drawn.
    pub fn turret(&self) -> Turret {
        self.view_state.turret.unwrap_or(self.run.setup().machine.turret)
    }

    /// Keeps the part of this program, if there is one, for comparison with the parts of later runs.
    pub fn keep(&mut self) {
        if self.part().is_some() {
            keep(self);
        }
    }

    /// Compares the parts of this run and of later ones with a wanted part. `left`: Z of its left end, mm.
    pub fn compare_with(&mut self, part: Region, left: f64) {
        self.view_state.kept = Some(Kept::Wanted { part, left });
        self.compare();
    }

    /// Ends the comparison.
    pub fn end_comparison(&mut self) {
        self.view_state.kept = None;
        self.compare();
    }

    /// Marks the edge of the part within `reach` (mm) of a position in the section, and returns its feature.
    pub fn mark_edge(&mut self, at: Pixel, reach: f64) -> Option<Feature> {
        let camera = *self.view_state.section().camera();
        let pointer = camera.to_world(at);
        let place = Point::new(pointer.x.abs(), pointer.z);
        let side = if pointer.x < 0.0 { -1.0 } else { 1.0 };
        let feature = match (self.machined(), self.view_state.section().playhead) {
            (Some(machined), None) => {
                let part = machined.part_on(side);
                part.and_then(|part| feature::at(part, machined.threads(), place, reach / camera.scale()))
            }
            _ => None,
        };
        let corners = feature.iter().flat_map(|feature| &feature.corners);
        self.view_state.section_mut().edge = corners.map(|at| Point::new(side * at.x, at.z)).collect();
        feature.map(|feature| feature.as_programmed(self.run.motions()))
    }

    /// Marks no edge.
    pub fn leave_edge(&mut self) {
        self.view_state.section_mut().edge.clear();
    }

    // ---- the pictures ---------------------------------------------------------------------------------

    /// The strokes of the section, without the workpiece.
    pub fn scene(&self) -> Scene<'_> {
        Scene::new(self.run.motions(), &self.path_index, None)
    }

    /// A picture as it is to be painted: the section always, the others only if anything moves in them.
    pub fn picture(&mut self, plane: Plane) -> Option<Picture<'_>> {
        self.show();
        if plane != Plane::Section {
            self.moves(plane)?;
        }
        let source = self.source();
        let (scene, view) = self.scene_and_view(plane);
        Some(Picture { scene, view, source })
    }

    fn source(&self) -> Source {
        Source { run: self.run.id(), stage: self.stage() }
    }

    /// The scene and the view of a picture.
    fn scene_and_view(&mut self, plane: Plane) -> (Scene<'_>, &mut View) {
        let Self { run, path_index, derived, view_state, .. } = self;
        let machined = derived.material.machined();
        let work = machined.and_then(|machined| machined.work(plane));
        let scene = match machined.and_then(|machined| machined.moves(plane)) {
            Some(moves) => moves.scene(work),
            // If nothing moves over a surface, there is nothing to fit its picture to either.
            None if plane != Plane::Section => Scene::new(run.motions(), path_index, None).on(plane),
            None => Scene::new(run.motions(), path_index, work),
        };
        (scene, &mut view_state.views[plane])
    }

    /// Updates everything that is shown to the tool position.
    fn show(&mut self) {
        self.measure();
        let place = self.view_state.section().playhead.and_then(|playhead| self.scene().place(playhead));
        let Self { run, derived, view_state, .. } = self;
        let Some(machined) = derived.material.machined_mut() else { return };
        machined.show(run.motions(), place);
        let (section, surfaces) = view_state.views.section_and_surfaces();
        for (plane, view) in surfaces {
            if let Some(moves) = machined.moves(plane) {
                follow(section, view, moves, place);
            }
        }
    }

    /// Measures the motions since the last call. Pictures are measured only on demand.
    fn measure(&mut self) {
        if self.derived.measured {
            return;
        }
        self.derived.measured = true;
        self.path_index.update(self.run.motions());
        // Until the run has ended, the view stays as the last run or the user has left it.
        if self.run.is_finished() {
            self.path_index.settle();
            self.count_in_unit();
            let (scene, view) = self.scene_and_view(Plane::Section);
            view.follow(&scene);
        }
        self.highlight();
    }

    fn turn(&mut self) {
        // The path index may still be that of the previous program.
        self.path_index.update(self.run.motions());
        let x_plus = XPlus::from(self.turret());
        let (scene, view) = self.scene_and_view(Plane::Section);
        view.turn(&scene, x_plus);
    }

    fn compare(&mut self) {
        let Self { run, derived, view_state, .. } = self;
        if let Some(machined) = derived.material.machined_mut() {
            machined.compare(run, view_state.kept.as_ref());
        }
        self.show();
    }

    /// Highlights the strokes of the block at the cursor, or of the marked lines.
    fn highlight(&mut self) {
        if HIGHLIGHTING.is_loaded() {
            highlight(self);
        }
    }
}

/// The part that finds the selected strokes; nothing is highlighted before it is loaded.
const HIGHLIGHTING: Part = Part::Late;

/// The part that continues a run and its lines after a change of the text.
const EDITING: Part = Part::Late;

late! {
    fn continue_edited(current: &mut Current, edit: TextEdit) {
        current.continue_edited(edit);
    }

    fn remove_material(current: &mut Current, motions: usize) -> bool {
        if let Some(simulation) = current.derived.material.remove(&current.run, motions) {
            current.finish_material(simulation);
        }
        current.machined().is_some()
    }

    fn highlight(current: &mut Current) {
        let (run, lines, scene) = (&current.run, current.lines(), current.scene());
        let picked = match current.view_state.cursor {
            Some(at) => picked::at(run, lines, &scene, at),
            None => (picked::of_lines(run, lines, &scene, &current.view_state.marked), Vec::new()),
        };
        let section = current.view_state.section_mut();
        (section.highlight, section.marks) = picked;
        name_steps(current);
    }

    // Labels the steps of the selected pass.
    fn name_steps(current: &mut Current) {
        let Current { run, view_state, .. } = current;
        let section = view_state.section_mut();
        section.steps = labels(run.motions(), &section.highlight, section.hover);
    }

    fn keep(current: &mut Current) {
        current.view_state.kept = Some(Kept::of(&current.run));
        current.compare();
    }

    fn stop_machining(current: &mut Current) {
        if let Some(simulation) = current.derived.material.stop() {
            current.finish_material(simulation);
        }
    }
}

/// Copies the selection and the tool position of the section to the view of a surface.
fn follow(section: &View, own: &mut View, moves: &SurfaceMoves, place: Option<Place>) {
    own.palette = section.palette.clone();
    own.playhead = place.map(|place| moves.playhead(place));
    own.hover = section.hover.and_then(|motion| moves.own(motion).next());
    own.highlight.clear();
    for motion in section.highlight.iter().flat_map(Range::clone) {
        let pieces = moves.own(motion);
        match own.highlight.last_mut() {
            _ if pieces.is_empty() => {}
            Some(last) if last.end == pieces.start => last.end = pieces.end,
            _ => own.highlight.push(pieces),
        }
    }
}
