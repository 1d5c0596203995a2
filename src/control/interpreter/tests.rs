//! The control alone: blocks in, motions and events out, without lints and other stages.

use std::cell::RefCell;
use std::ops::Range;
use std::rc::Rc;

use super::{BlockPosition, Flow, Interpreter};
use crate::control::codes::{Compensation, MotionMode};
use crate::control::events::{Event, EventContext, Observer};
use crate::geometry::Point;
use crate::message::Diagnostic;
use crate::motion::MotionKind;
use crate::setup::Setup;
use crate::source::shift::Shift;
use crate::text::block::Block;
use crate::text::parser::Parser;

/// Records the events.
#[derive(Clone, Default)]
struct Recorder(Rc<RefCell<Vec<String>>>);

impl Observer for Recorder {
    fn on_event(&mut self, event: &Event<'_>, at: &EventContext<'_>, _: &mut Vec<Diagnostic>) {
        let (x, z) = (2.0 * at.state.position.x, at.state.position.z);
        let said = match *event {
            Event::Cut { feed, .. } => format!("cut at {feed} from X{x} Z{z}"),
            Event::Feed => format!("F after {:?}", at.state.feed),
            Event::MCode { number, .. } => format!("M{number} while {:?}", at.state.spindle.turn),
            Event::SpindleSpeed { value, .. } => format!("S{value}"),
            Event::Rapid => "rapid".to_owned(),
            Event::MotionCode { mode: MotionMode::Line, .. } => "G01".to_owned(),
            Event::ContourNamed { named, .. } => format!("contour {named:?}"),
            Event::RoughingCalled(call) => format!("roughs {} pieces", call.contour.pieces.len()),
            _ => return,
        };
        self.0.borrow_mut().push(said);
    }

    fn clone_box(&self) -> Box<dyn Observer> {
        Box::new(self.clone())
    }

    fn continues_like(&self, _: &dyn Observer) -> bool {
        true
    }

    fn shift(&mut self, _: &Shift) {}

    fn waits_for(&self, _: Range<u32>) -> bool {
        false
    }

    fn fork_for_contour(&mut self) -> Box<dyn Observer> {
        self.clone_box()
    }

    fn inherit_reported(&mut self, _: &mut dyn Observer) {}
}

/// Carries out blocks until one jumps; returns the control after them, and the flow of each block.
fn carried_out(mut control: Interpreter, text: &str) -> (Interpreter, Vec<Flow>) {
    let text = text.as_bytes();
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let mut flows = Vec::new();
    loop {
        let at = parser.position();
        if !parser.next_block(&mut block) {
            break;
        }
        let flow = control.run(text, &block, BlockPosition { at, next: parser.position() });
        flows.push(flow);
        match flow {
            Flow::Next => {}
            Flow::Jump(to) => parser = Parser::resume(text, to),
            Flow::Restart(_) | Flow::End => break,
        }
    }
    control.finish(text);
    control.close();
    (control, flows)
}

fn control() -> Interpreter {
    Interpreter::new(Setup::default())
}

/// The events of some blocks.
fn heard(text: &str) -> Vec<String> {
    let recorder = Recorder::default();
    carried_out(control().with_observer(recorder.clone_box()), text);
    recorder.0.take()
}

#[test]
fn words_of_a_block_take_effect_in_the_order_of_the_control() {
    let (control, flows) = carried_out(control(), "G01 X20 Z-5 M03 S800 F0.2\nM30");
    assert_eq!(flows, [Flow::Next, Flow::End]);
    assert_eq!(control.motions().len(), 1);
    let motion = control.motions().get(0);
    assert_eq!((motion.kind, motion.to), (MotionKind::Feed, Point::new(10.0, -5.0)));
    assert_eq!(motion.process.speed, crate::motion::SpindleSpeed::Constant(800.0));
    assert!(control.diagnostics().is_empty());
}

#[test]
fn an_error_drops_the_motion_of_its_block_and_keeps_the_position() {
    let (control, _) = carried_out(control(), "G00 X20 Z2\nG01 X30 Z-5 R-1 F0.2 G500\nG00 X40");
    assert_eq!(control.motions().len(), 2);
    let after = control.motions().get(1);
    assert_eq!(after.from, Point::new(10.0, 2.0));
    assert!(after.process.uncertain && after.process.incomplete);
}

#[test]
fn events_come_before_the_change_they_announce() {
    let heard = heard("G00 X20 Z2\nM03 S500\nG01 Z-5 F0.2\nZ-9\nX22 F0.1");
    assert_eq!(
        heard,
        [
            "rapid",
            "M3 while Stopped",
            "S500",
            "F after None",
            "G01",
            "cut at 0.2 from X20 Z2",
            // `Z-9` adds nothing that matters for cuts.
            "F after Some(0.2)",
            "cut at 0.1 from X20 Z-9",
        ]
    );
}

#[test]
fn a_contour_that_is_read_leaves_no_trace_in_the_state() {
    let text =
        "G00 X42 Z2\nM03 S500 F0.2\nG71 U2 R1\nG71 P1 Q2 U0.5 W0.1\nN1 G00 X20\nN2 G01 X40 Z-20\nG00 X50";
    let (control, flows) = carried_out(control(), text);
    assert!(matches!(flows[3], Flow::Jump(_)), "the program goes on after the contour: {flows:?}");
    assert_eq!(control.state.compensation, Compensation::Off);
    let last = control.motions().get(control.motions().len() - 1);
    assert_eq!((last.from, last.to), (Point::new(21.0, 2.0), Point::new(25.0, 2.0)));
    let heard = heard(text);
    assert!(heard.contains(&"contour (1, 2)".to_owned()) && heard.contains(&"roughs 1 pieces".to_owned()));
}

#[test]
fn a_call_leads_to_its_program_and_back() {
    let text = "M98 P7\nG00 X30\nM30\nO7\nG00 X20\nM99";
    let (control, flows) = carried_out(control(), text);
    // The head of the program is a block, too.
    let [Flow::Jump(_), Flow::Next, Flow::Next, Flow::Jump(_), Flow::Next, Flow::End] = flows[..] else {
        panic!("{flows:?}")
    };
    let ends: Vec<_> = (0..2).map(|index| control.motions().get(index).to.x).collect();
    assert_eq!(ends, [10.0, 15.0]);
}
