//! Describes the word at a place.
//!
//! In: an executed block, a place in it. Out: the word, its role, its value, and facts about it.

use super::Query;
use super::explain::Explanation;
use super::fact::{Fact, NoMotion, Quantity};
use super::form::{Form, g_of};
use super::place::of_c;
use super::role::{Role, axes};
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{self, Function, G, Hole, MotionMode, Multiple};
use crate::control::contour::ContourUse;
use crate::control::macros;
use crate::control::modal::{Lead, State};
use crate::control::origins::{Modal, Origins};
use crate::control::program::{Labels, program_and_repeats};
use crate::control::tool_offset;
use crate::control::words::{Reading, plain};
use crate::cycles::units::{self, Amount, Written};
use crate::geometry::virtual_plane::Surface;
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, CycleStep, Motion, Motions, SpindleTurn, Step};
use crate::playback::timing;
use crate::run::replay::Visit;
use crate::setup::dialect::{DecimalRule, FeedMode, PqUnit};
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::highlight::sequence_span;
use crate::text::parser::{Parser, Resume};
use crate::text::program_name;
use crate::units::Diameter;

/// Description of the word at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Hover {
    /// The word.
    pub span: Span,
    /// The row of the table of codes, if the word is a code.
    pub function: Option<Function>,
    /// Its role.
    pub role: Option<Role>,
    /// Its value.
    pub quantity: Option<Quantity>,
    /// The explanation of the block, at a code.
    pub block: Option<Explanation>,
    /// Further facts, the most important first.
    pub facts: Vec<Fact>,
}

impl Hover {
    fn of(span: Span, role: Role) -> Self {
        Self { span, function: None, role: Some(role), quantity: None, block: None, facts: Vec::new() }
    }
}

impl<'a> Query<'a> {
    /// Describes the word at a byte, or the word that ends there, because a cursor after a word still refers
    /// to it. `None` if there is nothing to explain. `notes`: the comments that set up the program;
    /// `motions`: the motions of the run.
    pub fn hover(&self, byte: u32, notes: &[Span], motions: &Motions) -> Option<Hover> {
        let before = byte.checked_sub(1).filter(|before| self.block.span.start <= *before);
        self.hover_on(byte, notes, motions)
            .or_else(|| before.and_then(|before| self.hover_on(before, notes, motions)))
    }

    fn hover_on(&self, byte: u32, notes: &[Span], motions: &Motions) -> Option<Hover> {
        let at = |span: &Span| span.start <= byte && byte < span.end;
        let block = self.block;
        if let Some(comment) = block.comments.iter().find(|span| at(span)) {
            let is_note = notes.iter().any(|note| comment.contains(*note) || note.contains(*comment));
            return Some(Hover::of(*comment, if is_note { Role::SetupNote } else { Role::Comment }));
        }
        let mut hover = self.word_at(byte, motions)?;
        if self.visit.is_none()
            && hover.role != Some(Role::ProgramNumber)
            && hover.role != Some(Role::Percent)
        {
            let is_skipped = block.delete.filter(|level| self.setup.block_skip.contains(level));
            if is_skipped.is_none() {
                hover.facts.push(Fact::NotCarriedOut);
            }
        }
        if let Some(level) = block.delete.filter(|level| self.setup.block_skip.contains(level)) {
            hover.facts.push(Fact::Skipped(level));
        }
        self.about_block(&mut hover, motions);
        match self.visit {
            Some(visit) if visit.purpose.is_some() => hover.facts.push(match self.read_by {
                [true, true] => Fact::ReadByBoth,
                [_, false] => Fact::ReadBy(ContourUse::Roughing),
                [false, true] => Fact::ReadBy(ContourUse::Finishing),
            }),
            Some(visit) if self.times > 1 => hover.facts.push(Fact::Time(visit.number, self.times)),
            _ => {}
        }
        Some(hover)
    }

    /// Adds the explanation of the block at a code, and at a code or an axis the reason for no motion.
    fn about_block(&self, hover: &mut Hover, motions: &Motions) {
        let Some(visit) = self.visit.filter(|visit| visit.purpose.is_none()) else { return };
        let own = self.block.words.iter().find(|word| word.span == hover.span);
        let Some(word) = own.filter(|word| b"GMXZUW".contains(&word.address)) else { return };
        let explanation = self.explanation(motions);
        if !explanation.actions.is_empty() {
            if word.address == b'G' {
                hover.block = Some(explanation);
            }
        } else if visit.motions.is_empty() {
            let is_axis = |word: &Word| b"XZUWCHYV".contains(&word.address) && !word.comma;
            let form = Form::of(self.block, &visit.before.state, self.codes);
            let why = match form {
                // The second block makes the motions.
                Form::Multiple(..) => return,
                _ if !self.block.words.iter().any(is_axis) => NoMotion::WithoutAxis,
                Form::Motion { .. } => NoMotion::SamePlace,
                _ => NoMotion::ByCode,
            };
            hover.facts.push(Fact::NoMotion(why));
        }
    }

    fn word_at(&self, byte: u32, motions: &Motions) -> Option<Hover> {
        let (block, text) = (self.block, self.text);
        let at = |span: &Span| span.start <= byte && byte < span.end;
        if block.kind == BlockKind::Percent {
            return Some(Hover::of(block.span, Role::Percent));
        }
        if let Some((number, span)) = block.program.filter(|(_, span)| at(span)) {
            let quantity = (!program_name::is_name(number)).then_some(Quantity::Program(number));
            return Some(Hover { quantity, ..Hover::of(span, Role::ProgramNumber) });
        }
        let sequence = block.sequence.and_then(|number| {
            let span = sequence_span(text, block)?;
            at(&span).then_some((number, span))
        });
        if let Some((number, span)) = sequence {
            let quantity = Some(Quantity::Sequence(number));
            return Some(Hover { quantity, ..Hover::of(span, Role::SequenceNumber) });
        }
        if text.get(byte as usize) == Some(&b'/') && (block.delete.is_some() || block.optional.is_some()) {
            return Some(Hover::of(Span::new(byte as usize, byte as usize + 1), Role::BlockSkip));
        }
        if let Some(hover) = self.variable_at(byte) {
            return Some(hover);
        }
        let word = block.words.iter().find(|word| at(&word.span));
        match word {
            Some(word) => Some(self.word(word, motions)),
            None if block.kind == BlockKind::Macro && at(&block.words_span()) => {
                Some(Hover::of(block.words_span(), Role::MacroStatement))
            }
            None => None,
        }
    }

    /// A variable in a macro statement or an expression.
    fn variable_at(&self, byte: u32) -> Option<Hover> {
        let block = self.block;
        let within = match block.kind {
            BlockKind::Macro => Some(block.words_span()),
            _ => {
                let expressions = block.words.iter().filter(|word| word.value == Value::Expression);
                expressions.map(|word| word.span).find(|span| span.start <= byte && byte < span.end)
            }
        }?;
        let (number, span) = variable_in(self.text, within, byte)?;
        let mut facts = Vec::new();
        if let Some(visit) = self.visit {
            let level = visit.before.state.variables.level();
            facts.push(Fact::Variable(number, value_of(&visit.before.state, number)));
            if let Some(by) = visit.before.origins.set_by(level, number) {
                facts.push(Fact::VariableSet(number, by));
            }
            let mut memory = visit.before.state.variables.clone();
            if block.kind == BlockKind::Macro
                && macros::assigned(within.of(self.text), &mut memory) == Some(number)
            {
                facts.push(Fact::VariableBecomes(number, value_of(&visit.after.state, number)));
            }
        }
        let quantity = Some(Quantity::Variable(number));
        Some(Hover { quantity, facts, ..Hover::of(span, Role::Variable) })
    }

    fn word(&self, word: &Word, motions: &Motions) -> Hover {
        match word.address {
            b'G' if !word.comma => self.g_code(word),
            b'M' if !word.comma => self.m_code(word),
            _ => self.data(word, motions),
        }
    }

    // ---- codes ------------------------------------------------------------------------------------------

    fn g_code(&self, word: &Word) -> Hover {
        let Value::Number { number, .. } = word.value else { return Hover::of(word.span, Role::UnknownCode) };
        let Some(found) = number.tenths().and_then(|key| codes::g_code(key, self.codes)) else {
            return Hover::of(word.span, Role::UnknownCode);
        };
        let mut facts = vec![Fact::Group(found.group)];
        if let (Some(visit), Some(modal)) = (self.visit, modal_of(found.code)) {
            let (before, origins) = (&visit.before.state, &visit.before.origins);
            let since = origins.since(modal);
            let was = code_in_force(modal, before, self.codes);
            if was == codes::written(found.code, self.codes) {
                facts.push(Fact::Unchanged(since));
            } else if let Some(was) = was {
                facts.push(Fact::CodeBefore(was, since));
            }
        }
        facts.extend(cuts_thread(found.code).then_some(Fact::ThreadLocked));
        let (function, role) = (Some(found.function()), found.role());
        let quantity = match found.code {
            G::Frame(frame) => Some(Quantity::Count(f64::from(frame + 1))),
            _ => None,
        };
        Hover { span: word.span, function, role, quantity, block: None, facts }
    }

    fn m_code(&self, word: &Word) -> Hover {
        let number = plain(word).filter(|number| *number >= 0.0).map(|number| number as u64);
        let Some((function, role)) = number.and_then(codes::m_function) else {
            return Hover::of(word.span, Role::UnknownCode);
        };
        Hover {
            span: word.span,
            function: Some(function),
            role,
            quantity: None,
            block: None,
            facts: Vec::new(),
        }
    }

    // ---- other words ------------------------------------------------------------------------------------

    fn data(&self, written: &Word, motions: &Motions) -> Hover {
        let Some(visit) = self.visit else { return self.unvisited(written) };
        let (before, after) = (&visit.before.state, &visit.after.state);
        let own = self.evaluated(written);
        let word = own.as_ref().unwrap_or(written);
        let form = Form::of(self.block, before, self.codes);
        let surface = self.surface_in_block().unwrap_or(before.spindle.surface);
        let axes = axes(before, after.c_axis || before.virtual_plane.is_some());
        let role = Role::of(word, form, surface, axes);
        let reading = Reading { unit: after.unit, decimal: self.dialect.decimal };
        let quantity = self.quantity(word, role, form, before, reading);
        let mut facts = Vec::new();
        self.about_role(word, role, form, quantity, motions, &mut facts);
        let is_in_millimetres = || {
            !matches!(form, Form::Multiple(_, CycleBlock::Whole))
                && self.amount_reading(word, form, before, reading) != units::Reading::Micrometres
        };
        if counts_increments(word, role, reading.decimal) && !(is_amount(role) && is_in_millimetres()) {
            let increment = reading.unit.increment() * reading.unit.millimetres();
            facts.push(Fact::WithoutPoint(Quantity::Length(increment)));
        }
        Hover { quantity, facts, ..Hover::of(written.span, role) }
    }

    /// A word of a block that is never executed, described with the state at power-on.
    fn unvisited(&self, word: &Word) -> Hover {
        let state = self.before();
        let form = Form::of(self.block, &state, self.codes);
        let own =
            |form| matches!(form, Form::Motion { own: true, .. } | Form::Multiple(..) | Form::OneShot(_));
        let role = Role::of(word, form, self.surface_in_block().unwrap_or(false), axes(&state, false));
        let reading = Reading { unit: state.unit, decimal: self.dialect.decimal };
        let quantity = own(form).then(|| self.quantity(word, role, form, &state, reading)).flatten();
        Hover { quantity, ..Hover::of(word.span, role) }
    }

    /// The mode of S, if the block itself sets it: `true` for cutting speed.
    fn surface_in_block(&self) -> Option<bool> {
        self.block.words.iter().rev().find_map(|word| match g_of(word, self.codes)? {
            G::SurfaceSpeed => Some(true),
            G::ConstantSpeed => Some(false),
            _ => None,
        })
    }

    /// The word, with the value of its expression.
    fn evaluated(&self, word: &Word) -> Option<Word> {
        if word.value != Value::Expression {
            return None;
        }
        let values = self.visit?.values.as_deref()?;
        let nth = self.block.words.iter().filter(|other| other.address == word.address);
        let index = nth.take_while(|other| other.span != word.span).count();
        let mut block = Block::default();
        Parser::new(values.as_bytes()).next_block(&mut block);
        let found = block.words.iter().filter(|other| other.address == word.address).nth(index)?;
        Some(Word { span: word.span, ..*found })
    }

    /// The value of a word.
    fn quantity(
        &self,
        word: &Word,
        role: Role,
        form: Form,
        state: &State,
        reading: Reading,
    ) -> Option<Quantity> {
        use Role::*;
        let length = || reading.length(word).map(Quantity::Length);
        let diameter = || reading.length(word).map(|length| Quantity::Diameter(Diameter::new(length)));
        let count = || plain(word).map(Quantity::Count);
        Some(match role {
            EndX | ViaX | MachineX | OriginX | LocalX | CycleEndX | PeckEndX | ThreadEndX | HoleEndX
            | HolePlaceX
                if word.address == b'X' =>
            {
                diameter()?
            }
            EndC | WayC | ViaC | HoleAngle
                if state.interpolation().is_none_or(|plane| plane.surface != Surface::Face) =>
            {
                Quantity::Degrees(reading.degrees(word)?)
            }
            EndX | EndZ | EndC | EndY | WayX | WayZ | WayC | WayY | ViaX | ViaZ | ViaC | ViaWayX
            | ViaWayZ | MachineX | MachineZ | OriginX | OriginZ | ShiftX | ShiftZ | LocalX | LocalZ
            | CycleEndX | CycleEndZ | CycleWayX | CycleWayZ | PeckEndX | PeckEndZ | PeckWayX | PeckWayZ
            | ThreadEndX | ThreadEndZ | ThreadWayX | ThreadWayZ | HoleEndX | HoleEndZ | HoleWayX
            | HoleWayZ | HolePlaceX | HolePlaceZ | HoleAngle | Chamfer | Rounding | ArcRadius
            | ArcCenterX | ArcCenterZ | ArcCenterC | ArcCenterY | CornerX | CornerZ | TaperX | TaperZ
            | ThreadTaper | PullOutAcross | PullOutAlong | Escape | AllowanceX | AllowanceZ | ReliefX
            | ReliefZ | PeckRetract | BottomRelief | ThreadAllowance | RPoint | DataValue | DataRadius
            | CylinderRadius => length()?,
            PassDepth | PassDepthZ if word.address != b'D' => length()?,
            LineAngle | ThreadAngle => Quantity::Degrees(plain(word)?),
            StartAngle => Quantity::Degrees(plain(word)? / 1000.0),
            Feed => match self.feed_mode(state) {
                FeedMode::PerMinute => Quantity::FeedPerMinute(reading.feed(word)?),
                FeedMode::PerTurn => Quantity::FeedPerTurn(reading.feed(word)?),
            },
            Lead => Quantity::FeedPerTurn(reading.feed(word)?),
            LeadChange => Quantity::FeedPerTurn(reading.length(word)?),
            ThreadsPerInch => Quantity::ThreadsPerInch(plain(word)?),
            SpindleSpeed | HighestSpeed | LowestSpeed => Quantity::Speed(plain(word)?),
            CuttingSpeed => Quantity::CuttingSpeed(plain(word)? * reading.unit.surface_metres()),
            DwellSeconds => Quantity::Seconds(reading.seconds(word)?),
            DwellMilliseconds | HoleDwell => Quantity::Seconds(plain(word)? / 1000.0),
            Peck | StepOver | LeastDepth | ThreadHeight | FirstDepth | HolePeck | PassDepth | PassDepthZ => {
                Quantity::Length(self.amount(word, form, state, reading)?)
            }
            ContourFirst | ContourLast | CalledSequence | ReturnsTo | BeginsAt => {
                Quantity::Sequence(plain(word)? as u32)
            }
            CalledProgram if program_name::is_name(plain(word)? as u32) => return None,
            CalledProgram => Quantity::Program(program_of(plain(word)? as u64, form)),
            PatternPasses | Starts | InfeedMethod | Repeats | CallRepeats | DataNumber | DataKind
            | DataTip | ReferencePoint | FrameNumber | FinishAfter | Argument => count()?,
            ProgramNumber | SequenceNumber | BlockSkip | Percent | Comment | SetupNote | MacroStatement
            | Variable | InchInput | MetricInput | FeedPerMinute | FeedPerTurn | SpindleForward
            | SpindleReverse | SpindleStop | LiveTool | LiveToolForward | LiveToolReverse | ToolChange
            | CoolantOn | CoolantOff | ChuckClamp | ChuckUnclamp | FirstOrientation | SecondOrientation
            | TailstockForward | TailstockBack | SynchronousOn | SynchronousOff | ConveyorForward
            | ConveyorStop | InterlockOff | InterlockOn | PlaneXy | PlaneZx | PlaneYz | Absolute
            | Incremental | InitialLevel | RPointLevel | ProgramStop | OptionalStop | CAxisOn | CAxisOff
            | PullOutOn | PullOutOff | DataInput | DataEnd | MacroOnce | MacroModal | MacroOff
            | WorkFrame | UnknownCode | Ignored | ToolAndOffset | ThreadPacked => return None,
        })
    }

    fn feed_mode(&self, state: &State) -> FeedMode {
        let own = self.block.words.iter().rev().find_map(|word| match g_of(word, self.codes)? {
            G::Feed(mode) => Some(mode),
            _ => None,
        });
        own.unwrap_or(state.feed_mode)
    }

    /// P and Q of G74 to G76, Q of holes, D of the one-block forms, in mm.
    fn amount(&self, word: &Word, form: Form, state: &State, reading: Reading) -> Option<f64> {
        let Value::Number { number, .. } = word.value else { return None };
        let increment = reading.unit.increment() * reading.unit.millimetres();
        if matches!(form, Form::Multiple(_, CycleBlock::Whole)) {
            // On older controls I and K are lengths, and D without a decimal point counts increments.
            return match word.address {
                b'D' if !number.has_point() => Some(plain(word)? * increment),
                _ => reading.length(word),
            };
        }
        let read = self.amount_reading(word, form, state, reading);
        Some(amount(word, increment)?.mm(read, reading.unit))
    }

    /// The unit of P and Q in G74 to G76, and of Q in hole cycles.
    fn amount_reading(&self, word: &Word, form: Form, state: &State, reading: Reading) -> units::Reading {
        let increment = reading.unit.increment() * reading.unit.millimetres();
        let of = |address: u8| {
            let word = self.block.words.iter().rev().find(|word| word.address == address && !word.comma)?;
            amount(word, increment)
        };
        match (self.dialect.pq_unit, form) {
            (PqUnit::Mm, _) => units::Reading::Millimetres(units::Because::Point),
            (PqUnit::Um, _) => units::Reading::Micrometres,
            (PqUnit::Auto, Form::Hole { .. }) => self.peck_reading(amount(word, increment), reading),
            (PqUnit::Auto, Form::Multiple(Multiple::Threading, CycleBlock::First)) => {
                units::threading(amount(word, increment), None, None)
            }
            (PqUnit::Auto, Form::Multiple(Multiple::Threading, _)) => {
                units::threading(state.parameters.least_amount, of(b'P'), of(b'Q'))
            }
            (PqUnit::Auto, _) => units::pecking(state.position, self.end(state, reading), of(b'P'), of(b'Q')),
        }
    }

    /// The unit of Q of a hole when the block was executed: it depends on the levels of the hole.
    fn peck_reading(&self, amount: Option<Amount>, reading: Reading) -> units::Reading {
        let in_millimetres = units::Reading::Millimetres(units::Because::Point);
        let peck = self.visit.and_then(|visit| visit.after.state.hole?.peck);
        let is_peck = |amount: Amount| peck == Some(amount.mm(in_millimetres, reading.unit).abs());
        if amount.is_some_and(is_peck) { in_millimetres } else { units::Reading::Micrometres }
    }

    /// The position that the axis words of the block lead to.
    pub(super) fn end(&self, state: &State, reading: Reading) -> Point {
        let mut end = state.position;
        for word in &self.block.words {
            match (word.address, reading.length(word)) {
                (b'X', Some(x)) => end.x = Diameter::new(x).radius(),
                (b'U', Some(u)) => end.x += Diameter::new(u).radius(),
                (b'Z', Some(z)) => end.z = z,
                (b'W', Some(w)) => end.z += w,
                _ => {}
            }
        }
        end
    }

    // ---- facts ------------------------------------------------------------------------------------------

    fn about_role(
        &self,
        word: &Word,
        role: Role,
        form: Form,
        quantity: Option<Quantity>,
        motions: &Motions,
        facts: &mut Vec<Fact>,
    ) {
        let Some(visit) = self.visit else { return };
        let (before, after) = (&visit.before.state, &visit.after.state);
        let origins = &visit.after.origins;
        if let (Some(Quantity::Diameter(diameter)), b'X') = (quantity, word.address) {
            facts.push(Fact::FromCentre(Quantity::Length(diameter.radius())));
        }
        if matches!(role, Role::TaperX | Role::TaperZ | Role::ThreadTaper) {
            self.about_taper(role, motions, facts);
        }
        match role {
            Role::EndX | Role::WayX => {
                facts.push(from_to(before.turning_place().x, after.turning_place().x, true))
            }
            Role::EndZ | Role::WayZ => {
                facts.push(from_to(before.turning_place().z, after.turning_place().z, false))
            }
            Role::EndC | Role::WayC => {
                facts.push(Fact::FromTo(of_c(before, before.place_of_c()), of_c(after, after.place_of_c())))
            }
            Role::Feed | Role::Lead => {
                self.about_feed(role, quantity, before, after, &visit.before.origins, facts)
            }
            Role::CuttingSpeed => self.about_cutting_speed(before, after, &visit.before.origins, facts),
            Role::SpindleSpeed => about_value(
                Quantity::Speed(before.spindle.rpm),
                quantity,
                &visit.before.origins,
                Modal::Speed,
                facts,
            ),
            Role::ToolAndOffset => {
                let (station, offset) = after.tool;
                facts.push(Fact::StationAndOffset(station, offset));
                let (radius, _) = tool_offset::nose_entry(after, self.setup);
                if radius != 0.0 {
                    facts.push(Fact::NoseRadius(Quantity::Length(radius.abs())));
                }
                if after.tip_shift != Point::default() {
                    let Point { x, z } = after.tip_shift;
                    let along_x = Quantity::Length(Diameter::from_radius(x).mm());
                    facts.push(Fact::TipShift(along_x, Quantity::Length(z)));
                }
            }
            Role::ThreadPacked => {
                let packed = plain(word).unwrap_or_default() as u32;
                facts.push(Fact::ThreadPacked(
                    (packed / 10_000 % 100).max(1),
                    packed / 100 % 100,
                    packed % 100,
                ));
            }
            Role::ContourFirst | Role::ContourLast => facts.push(self.contour()),
            Role::CalledProgram | Role::CalledSequence | Role::ReturnsTo => {
                facts.push(self.called(role, word))
            }
            Role::Argument => facts.extend(self.argument(word)),
            Role::TaperX
            | Role::TaperZ
            | Role::CycleEndX
            | Role::CycleEndZ
            | Role::CycleWayX
            | Role::CycleWayZ => {
                facts.extend(way_of_roughing_a_cone(role, before, after));
            }
            _ => {}
        }
        if let Form::Multiple(_, CycleBlock::Second | CycleBlock::Whole) = form
            && matches!(role, Role::FirstDepth | Role::ThreadHeight | Role::PassDepth | Role::PassDepthZ)
        {
            self.about_passes(motions, facts);
        }
        if matches!(word.address, b'F' | b'S' | b'T') {
            match visit.purpose {
                Some(ContourUse::Roughing) => facts.push(Fact::IgnoredByRoughing),
                Some(ContourUse::Finishing) => facts.push(Fact::TakenByFinishing),
                None => {}
            }
        }
        if let Form::Motion { mode, own: false } = form
            && matches!(word.address, b'X' | b'Z' | b'U' | b'W' | b'R' | b'I' | b'K')
        {
            let code = codes::written(G::Motion(mode), self.codes);
            facts.extend(code.map(|code| Fact::ByCode(code, visit.before.origins.since(Modal::Motion))));
        }
        let cuts = match form {
            Form::Motion { mode: MotionMode::Line | MotionMode::Arc(_), .. } => true,
            Form::Motion { mode: MotionMode::Cycle(cycle), .. } => !cycle.is_thread(),
            Form::Multiple(_, CycleBlock::Second | CycleBlock::Whole) | Form::Hole { .. } => true,
            _ => false,
        };
        let has_feed = self.block.words.iter().any(|word| word.address == b'F');
        if cuts
            && !has_feed
            && matches!(word.address, b'X' | b'Z' | b'U' | b'W' | b'P' | b'Q')
            && let Some(feed) = feed_of(after)
        {
            let of_contour = match form {
                Form::Multiple(Multiple::Finishing, _) => self.first_feed_of_contour(),
                _ => None,
            };
            facts.push(match of_contour {
                Some(block) => Fact::ByFeedOfContour(block),
                None => Fact::ByFeed(feed, origins.since(Modal::Feed)),
            });
        }
    }

    fn about_feed(
        &self,
        role: Role,
        quantity: Option<Quantity>,
        before: &State,
        after: &State,
        origins: &Origins,
        facts: &mut Vec<Fact>,
    ) {
        if role == Role::Feed
            && let Some(was) = feed_of(before)
        {
            about_value(was, quantity, origins, Modal::Feed, facts);
        }
        let (Some(Quantity::FeedPerTurn(feed)), process) = (quantity, after.process()) else { return };
        if let Some(speed) = timing::speed_at(&process, &self.setup.machine, after.position.x) {
            facts.push(Fact::FeedAtSpeed(Quantity::FeedPerMinute(feed * speed), Quantity::Speed(speed)));
        }
    }

    fn about_cutting_speed(&self, before: &State, after: &State, origins: &Origins, facts: &mut Vec<Fact>) {
        let x = before.position.x.abs();
        let turning =
            crate::control::modal::Spindle { surface: true, turn: SpindleTurn::Forward, ..after.spindle };
        let Some(speed) = turning.speed_within(x, self.setup.machine.max_speed).filter(|_| x > 0.0) else {
            return;
        };
        facts.push(Fact::SpeedAt(Quantity::Speed(speed), Quantity::Diameter(Diameter::from_radius(x))));
        if let Some(highest) = after.spindle.highest {
            facts.push(Fact::SpeedHeld(Quantity::Speed(highest), origins.since(Modal::HighestSpeed)));
        }
    }

    /// The blocks that P and Q refer to.
    fn contour(&self) -> Fact {
        let named = |address: u8| {
            let word = self.block.words.iter().rev().find(|word| word.address == address)?;
            plain(word).map(|number| number as u32)
        };
        let labels = Labels::new(self.text);
        let find = |number: Option<u32>, from: u32| labels.find(number?, from);
        let Some(first) = find(named(b'P'), self.block.span.start) else { return Fact::NamesNothing };
        let Some(last) = find(named(b'Q'), first.byte) else { return Fact::NamesNothing };
        let span = |byte: u32| {
            let (_, block) =
                crate::run::replay::block_at(self.text, crate::text::parser::Resume::inside(byte, 0), byte);
            block.span
        };
        Fact::Contour(span(first.byte), span(last.byte))
    }

    /// The first block with F in the contour that P and Q refer to, identified by its first byte.
    fn first_feed_of_contour(&self) -> Option<u32> {
        let Fact::Contour(first, last) = self.contour() else { return None };
        let mut parser = Parser::resume(self.text, Resume::inside(first.start, 0));
        let mut block = Block::default();
        while parser.next_block(&mut block) && block.span.start <= last.start {
            if block.words.iter().any(|word| word.address == b'F' && !word.comma) {
                return Some(block.span.start);
            }
        }
        None
    }

    /// The block that a call refers to.
    fn called(&self, role: Role, word: &Word) -> Fact {
        let Some(number) = plain(word) else { return Fact::NamesNothing };
        let labels = Labels::new(self.text);
        let found = match role {
            Role::CalledProgram => {
                let whole = labels.program(number as u32);
                whole.or_else(|| labels.program(program_and_repeats(number as u64).0))
            }
            _ => labels.find(number as u32, self.block.span.start),
        };
        found.map_or(Fact::NamesNothing, |found| Fact::Names(found.byte))
    }

    /// The variable that receives a word of a macro call.
    fn argument(&self, word: &Word) -> Option<Fact> {
        let mut is_argument = false;
        let mut words = Vec::new();
        for other in &self.block.words {
            if codes::calls_macro(other) {
                is_argument = true;
            } else if is_argument && !matches!(other.address, b'P' | b'L') {
                words.push((other.address, if other.span == word.span { 1.0 } else { 0.0 }));
            }
        }
        let locals = macros::arguments(words.into_iter()).ok()?;
        let index = locals.iter().position(|value| *value == Some(1.0))?;
        Some(Fact::Argument(index as u32 + 1))
    }

    /// Where the cut of a taper starts and ends, its angle, and where it would start with the other sign of R.
    fn about_taper(&self, role: Role, motions: &Motions, facts: &mut Vec<Fact>) {
        let Some(visit) = self.visit else { return };
        let is_cut = |motion: &Motion| motion.cycle.is_some_and(|step| step.step == Step::Cut);
        let Some(cut) = motions_of(visit, motions).rev().find(is_cut) else { return };
        let (along_x, along_z) = ((cut.to.x - cut.from.x).abs(), (cut.to.z - cut.from.z).abs());
        let (from, to) = if role == Role::TaperZ { (cut.from.z, cut.to.z) } else { (cut.from.x, cut.to.x) };
        if (from - to).abs() <= SAME {
            return;
        }
        let at = |value: f64| match role {
            Role::TaperZ => Quantity::Length(value),
            _ => Quantity::Diameter(Diameter::from_radius(value)),
        };
        let angle = (along_x.atan2(along_z).to_degrees() * 100.0).round() / 100.0;
        facts.push(Fact::TaperFromTo(at(from), at(to), Quantity::Degrees(angle)));
        let other = 2.0 * to - from;
        if role == Role::TaperZ || other >= 0.0 {
            facts.push(Fact::TaperOtherSign(at(other)));
        }
    }

    /// The number of passes in the block, and the position of the last one.
    fn about_passes(&self, motions: &Motions, facts: &mut Vec<Fact>) {
        let Some(visit) = self.visit else { return };
        let passes = motions_of(visit, motions).filter(|motion| motion.kind.cuts());
        let passes: Vec<_> = passes
            .filter_map(|motion| Some((motion.cycle.filter(|step| step.pass > 0)?, motion.to.x)))
            .collect();
        let Some(last) = passes.iter().map(|(step, _)| step.pass).max() else { return };
        facts.push(Fact::Passes(last));
        // The pull-out at the end of a pass is not on the thread diameter, so use the cut.
        let cut = passes.iter().rev().find(|(step, _)| step.step == Step::Cut);
        if let Some((CycleStep { cycle: Cycle::MultiThreading, .. }, x)) = cut {
            facts.push(Fact::LastPass(Quantity::Diameter(Diameter::from_radius(*x))));
        }
    }
}

/// The motions of one execution of a block.
fn motions_of<'a>(visit: &'a Visit, motions: &'a Motions) -> impl DoubleEndedIterator<Item = Motion> + 'a {
    let own = visit.motions.start..visit.motions.end.min(motions.len());
    own.map(|index| motions.get(index))
}

/// Relation of this pass of a taper to the previous one: another R to the same end, or the same R to another
/// end. R of both G90 and G94 is the start of the cut minus its end.
fn way_of_roughing_a_cone(role: Role, before: &State, after: &State) -> Option<Fact> {
    let (last, this) = (before.memory, after.memory);
    let goes_on = before.motion == after.motion && this.passes > last.passes && last.passes > 0;
    let same_end = (last.x, last.z) == (this.x, this.z);
    let taper = last.taper;
    if !goes_on || taper == 0.0 {
        return None;
    }
    match role {
        Role::TaperX | Role::TaperZ => {
            (same_end && this.taper != taper).then_some(Fact::TaperBefore(Quantity::Length(taper)))
        }
        _ => (!same_end && this.taper == taper).then_some(Fact::TaperKept(Quantity::Length(taper))),
    }
}

/// Facts about a value that is set again or changed.
fn about_value(was: Quantity, now: Option<Quantity>, origins: &Origins, modal: Modal, facts: &mut Vec<Fact>) {
    let Some(since) = origins.since(modal) else { return };
    if now == Some(was) {
        facts.push(Fact::Unchanged(Some(since)));
    } else {
        facts.push(Fact::ValueBefore(was, Some(since)));
    }
}

fn from_to(from: f64, to: f64, across: bool) -> Fact {
    let place = |place: f64| match across {
        true => Quantity::Diameter(Diameter::from_radius(place)),
        false => Quantity::Length(place),
    };
    Fact::FromTo(place(from), place(to))
}

/// The feed in force.
pub fn feed_of(state: &State) -> Option<Quantity> {
    match (state.feed, state.lead, state.feed_mode) {
        (_, Some(Lead::ThreadsPerInch(threads)), _) => Some(Quantity::ThreadsPerInch(threads)),
        (None, ..) => None,
        (Some(feed), _, FeedMode::PerMinute) => Some(Quantity::FeedPerMinute(feed)),
        (Some(feed), _, FeedMode::PerTurn) => Some(Quantity::FeedPerTurn(feed)),
    }
}

/// Whether a code cuts a thread, with the slide synchronised to the spindle.
pub(super) fn cuts_thread(code: G) -> bool {
    match code {
        G::Motion(mode) => match mode {
            MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping => true,
            MotionMode::Cycle(cycle) => cycle.is_thread(),
            MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_) => false,
        },
        G::Multiple(cycle) => cycle == Multiple::Threading,
        G::Hole(hole) => matches!(hole, Hole::G84 | Hole::G88),
        _ => false,
    }
}

fn modal_of(code: G) -> Option<Modal> {
    Some(match code {
        G::Motion(_) => Modal::Motion,
        G::Plane(_) => Modal::Plane,
        G::Unit(_) => Modal::Unit,
        G::Distance { .. } => Modal::Distance,
        G::Hole(_) | G::NoHole => Modal::Hole,
        G::HoleReturn(_) => Modal::HoleReturn,
        G::Compensation(_) => Modal::Compensation,
        G::Frame(_) | G::ExtendedFrame => Modal::Frame,
        G::Polar(_) | G::Cylinder => Modal::Interpolation,
        G::SurfaceSpeed | G::ConstantSpeed => Modal::SpeedMode,
        G::Feed(_) => Modal::FeedMode,
        _ => return None,
    })
}

/// The code of a modal group in force, as written in a code list.
pub fn code_in_force(modal: Modal, state: &State, list: crate::setup::dialect::CodeList) -> Option<String> {
    let code = match modal {
        Modal::Motion => G::Motion(state.motion),
        Modal::FeedMode => G::Feed(state.feed_mode),
        Modal::SpeedMode if state.spindle.surface => G::SurfaceSpeed,
        Modal::SpeedMode => G::ConstantSpeed,
        Modal::Compensation => G::Compensation(state.compensation),
        Modal::Unit => G::Unit(state.unit),
        Modal::Distance => G::Distance { incremental: state.incremental },
        Modal::Plane => G::Plane(state.plane),
        Modal::Hole => state.hole.map_or(G::NoHole, |memory| G::Hole(memory.kind)),
        Modal::HoleReturn => G::HoleReturn(state.hole_return),
        Modal::Frame if state.frames.active < 6 => G::Frame(state.frames.active),
        Modal::Frame => G::ExtendedFrame,
        _ => return None,
    };
    codes::written(code, list)
}

/// The value of a variable, unless it is a system variable.
fn value_of(state: &State, variable: u32) -> Option<f64> {
    match state.variables.read(variable) {
        Ok(macros::Found::Value(value)) => value,
        _ => None,
    }
}

/// The variable at a byte: `#100`.
fn variable_in(text: &[u8], within: Span, byte: u32) -> Option<(u32, Span)> {
    let (start, end) = (within.start as usize, (within.end as usize).min(text.len()));
    let at = byte as usize;
    let hash = (start..=at).rev().find(|&index| text.get(index) == Some(&b'#'))?;
    let digits = text[hash + 1..end].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let last = hash + 1 + digits;
    let number = std::str::from_utf8(&text[hash + 1..last]).ok()?.parse().ok()?;
    (at < last).then(|| (number, Span::new(hash, last)))
}

fn program_of(number: u64, form: Form) -> u32 {
    match form {
        Form::Call(_) if number > 9999 => program_and_repeats(number).0,
        _ => u32::try_from(number).unwrap_or(u32::MAX),
    }
}

fn amount(word: &Word, increment: f64) -> Option<Amount> {
    let Value::Number { number, .. } = word.value else { return None };
    let written = if number.has_point() { Written::WithPoint } else { Written::WithoutPoint };
    Some(Amount { in_increments: plain(word)? * increment, written })
}

/// Whether a role is P or Q of G74 to G76, or Q of a hole.
fn is_amount(role: Role) -> bool {
    use Role::*;
    matches!(role, Peck | StepOver | LeastDepth | ThreadHeight | FirstDepth | HolePeck)
}

/// Whether the unit of a number without a decimal point may surprise a beginner.
fn counts_increments(word: &Word, role: Role, rule: DecimalRule) -> bool {
    let Value::Number { number, .. } = word.value else { return false };
    let is_length = matches!(word.address, b'X' | b'Z' | b'U' | b'W' | b'R' | b'I' | b'K')
        && !matches!(
            role,
            Role::DwellSeconds | Role::PatternPasses | Role::Repeats | Role::Argument | Role::Ignored
        );
    !number.has_point()
        && number.mantissa > 0
        && (is_amount(role) || (is_length && rule == DecimalRule::LeastIncrement))
}
