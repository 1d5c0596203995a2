//! Finds invalid values in a setup.
//!
//! In: a setup as it was read. Out: the invalid values, and the setup without them, so that every setup can
//! be run and drawn.

use super::blank::{Outline, OutlineFault};
use super::tool::LARGEST_WEAR;
use super::{Blank, Machine, Setup, Tool};
use crate::limits::OUTLINE_POINTS;
use crate::message::{Message, said};
use crate::parts::early;
use crate::units::Diameter;

/// An invalid value.
#[derive(Clone, Debug, PartialEq)]
pub struct InvalidValue {
    /// Key as in JSON: `stock.diameter`, `tools.T0101.width`.
    pub key: String,
    /// The value; of an outline, the number of its points.
    pub value: f64,
    /// The requirement that it does not meet.
    pub requirement: Requirement,
}

impl InvalidValue {
    /// The message about the value.
    pub fn message(self) -> Message {
        let Self { key, value, requirement } = self;
        match requirement {
            Requirement::Positive => said::SetupPositive { key, value }.into(),
            Requirement::NotNegative => said::SetupNotNegative { key, value }.into(),
            Requirement::Below(most) => said::SetupBelow { key, value, most }.into(),
            Requirement::AtMost(most) => said::SetupAtMost { key, value, most }.into(),
            Requirement::Outline(fault) => outline_message(fault),
        }
    }
}

/// The message about the fault of an outline.
fn outline_message(fault: OutlineFault) -> Message {
    match fault {
        OutlineFault::Points(points) => {
            said::OutlinePoints { points, least: Outline::FEWEST, most: OUTLINE_POINTS }.into()
        }
        OutlineFault::NegativeX { point, x } => said::OutlineNegative { point, x: x.mm() }.into(),
        OutlineFault::TooFar { point, value } => {
            said::OutlineFar { point, value, most: Outline::FARTHEST }.into()
        }
        OutlineFault::Flat => said::OutlineFlat.into(),
        OutlineFault::Crosses { point } => said::OutlineCrosses { point }.into(),
    }
}

/// A requirement on a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Requirement {
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NotNegative,
    /// Less than this.
    Below(f64),
    /// Not more than this.
    AtMost(f64),
    /// An outline without this fault.
    Outline(OutlineFault),
}

/// Greatest length, mm.
const LONGEST: f64 = 5000.0;

impl Requirement {
    fn is_met(self, value: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Below(most) => value < most,
            Self::AtMost(most) => value <= most,
            Self::Outline(_) => false,
        }
    }
}

/// Checks values, and keeps the first requirement that each of them does not meet.
#[derive(Default)]
struct Checker {
    invalid: Vec<InvalidValue>,
}

impl Checker {
    fn at(&mut self, key: impl Into<String>, value: Option<f64>, requirements: &[Requirement]) {
        let Some(value) = value else { return };
        if let Some(&requirement) = requirements.iter().find(|requirement| !requirement.is_met(value)) {
            self.invalid.push(InvalidValue { key: key.into(), value, requirement });
        }
    }

    fn stock(&mut self, blank: &Blank) {
        let outline = blank.outline();
        if let Some((outline, fault)) = outline.and_then(|outline| Some((outline, outline.fault()?))) {
            let (key, value) = ("stock.outline".into(), outline.points().len() as f64);
            self.invalid.push(InvalidValue { key, value, requirement: Requirement::Outline(fault) });
            return;
        }
        let stock = blank.extents();
        const SIZE: [Requirement; 2] = [Requirement::Positive, Requirement::AtMost(LONGEST)];
        self.at("stock.diameter", Some(stock.diameter.mm()), &SIZE);
        self.at("stock.length", Some(stock.length), &SIZE);
        self.at("stock.face", Some(stock.face.abs()), &[Requirement::AtMost(LONGEST)]);
        self.at("stock.bore", Some(stock.bore.mm()), &[Requirement::NotNegative]);
        if self.invalid.is_empty() {
            self.at("stock.bore", Some(stock.bore.mm()), &[Requirement::Below(stock.diameter.mm())]);
            self.at("stock.grip", stock.grip, &[Requirement::NotNegative, Requirement::Below(stock.length)]);
        }
    }

    fn tool(&mut self, name: &str, tool: &Tool) {
        const LENGTH: [Requirement; 2] = [Requirement::Positive, Requirement::AtMost(LONGEST)];
        const RADIUS: [Requirement; 2] = [Requirement::NotNegative, Requirement::AtMost(100.0)];
        let angle = |most| [Requirement::Positive, Requirement::Below(most)];
        let key = |key: &str| format!("tools.{name}.{key}");
        self.at(key("noseRadius"), tool.nose_radius, &RADIUS);
        self.at(key("tip"), tool.tip.map(f64::from), &[Requirement::AtMost(9.0)]);
        self.at(key("pointAngle"), tool.point_angle, &angle(180.0));
        self.at(key("enteringAngle"), tool.entering_angle, &angle(180.0));
        // If the two angles together exceed a half turn, the edge behind the tip would be below the tip.
        let point = tool.point_angle.or_else(|| tool.insert()?.point_angle).unwrap_or(80.0);
        if tool.entering_angle.is_some_and(|entering| entering < 180.0) {
            self.at(key("enteringAngle"), tool.entering_angle, &[Requirement::AtMost(180.0 - point)]);
        }
        self.at(key("edgeLength"), tool.edge_length, &LENGTH);
        self.at(key("width"), tool.width, &LENGTH);
        self.at(key("diameter"), tool.diameter.map(Diameter::mm), &LENGTH);
        self.at(key("reach"), tool.reach, &LENGTH);
        self.at(key("shank"), tool.shank, &LENGTH);
        self.at(key("toolRadius"), tool.tool_radius, &RADIUS);
        self.at(key("geometryR"), tool.geometry_r, &RADIUS);
        for (name, length) in
            [("geometryX", tool.geometry_x.map(Diameter::mm)), ("geometryZ", tool.geometry_z)]
        {
            self.at(key(name), length.map(f64::abs), &[Requirement::AtMost(LONGEST)]);
        }
        for (name, wear) in
            [("wearX", tool.wear_x.map(Diameter::mm)), ("wearZ", tool.wear_z), ("wearR", tool.wear_r)]
        {
            self.at(key(name), wear.map(f64::abs), &[Requirement::AtMost(LARGEST_WEAR)]);
        }
        self.at(key("angle"), tool.angle, &[Requirement::Positive, Requirement::AtMost(180.0)]);
        if let (Some(width), Some(nose)) = (tool.width, tool.nose_radius) {
            self.at(key("noseRadius"), Some(nose), &[Requirement::AtMost(width / 2.0)]);
        }
    }
}

impl Setup {
    /// Removes invalid values and returns them. Stock and tools with an invalid value count as not given.
    pub fn without_invalid_values(self) -> (Self, Vec<InvalidValue>) {
        if self.has_nothing_to_check() { (self, Vec::new()) } else { checked(self) }
    }

    /// Whether it contains no value that can be invalid.
    fn has_nothing_to_check(&self) -> bool {
        let Self { initial, tools, stock, tailstock, machine, .. } = self;
        let Machine { rapid_x, rapid_z, max_speed, thread_speed_margin, .. } = machine;
        let has_machine = rapid_x.or(*rapid_z).or(*max_speed).or(*thread_speed_margin).is_some();
        tools.is_empty() && initial.is_none() && stock.is_none() && tailstock.is_none() && !has_machine
    }
}

early! {
    fn checked(setup: Setup) -> (Setup, Vec<InvalidValue>) {
        let mut setup = setup;
        let mut checker = Checker::default();
        if let Some(blank) = &setup.stock {
            checker.stock(blank);
            if !checker.invalid.is_empty() {
                setup.stock = None;
            }
        }
        setup.tools.retain(|name, tool| {
            let before = checker.invalid.len();
            checker.tool(name, tool);
            checker.invalid.len() == before
        });
        if let Some(tailstock) = setup.tailstock {
            let before = checker.invalid.len();
            checker.at(
                "tailstock.diameter",
                Some(tailstock.diameter.mm()),
                &[Requirement::Positive, Requirement::AtMost(LONGEST)],
            );
            checker.at("tailstock.z", Some(tailstock.z.abs()), &[Requirement::AtMost(LONGEST)]);
            if checker.invalid.len() > before {
                setup.tailstock = None;
            }
        }
        if let Some(start) = setup.initial {
            let before = checker.invalid.len();
            checker.at("initial.x", Some(start.x.mm().abs()), &[Requirement::AtMost(LONGEST)]);
            checker.at("initial.z", Some(start.z.abs()), &[Requirement::AtMost(LONGEST)]);
            if checker.invalid.len() > before {
                setup.initial = None;
            }
        }
        for (key, value) in [
            ("machine.rapidX", &mut setup.machine.rapid_x),
            ("machine.rapidZ", &mut setup.machine.rapid_z),
            ("machine.maxSpeed", &mut setup.machine.max_speed),
        ] {
            let before = checker.invalid.len();
            checker.at(key, *value, &[Requirement::Positive]);
            if checker.invalid.len() > before {
                *value = None;
            }
        }
        let before = checker.invalid.len();
        checker.at(
            "machine.threadSpeedMargin",
            setup.machine.thread_speed_margin,
            &[Requirement::NotNegative],
        );
        if checker.invalid.len() > before {
            setup.machine.thread_speed_margin = None;
        }
        (setup, checker.invalid)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(json: &str, invalid: &[(&str, f64, Requirement)]) {
        let (setup, found) = Setup::from_json(json).expect("well-formed JSON").without_invalid_values();
        let found: Vec<_> =
            found.iter().map(|fault| (fault.key.as_str(), fault.value, fault.requirement)).collect();
        assert_eq!(found, invalid, "{json}");
        assert_eq!(setup.without_invalid_values().1, [], "{json}");
    }

    #[test]
    fn each_fault_is_found_once() {
        check(r#"{"stock": {"diameter": 60, "length": 80, "bore": 59.9, "grip": 79}}"#, &[]);
        check(
            r#"{"stock": {"diameter": -60, "length": 80, "bore": 70}}"#,
            &[("stock.diameter", -60.0, Requirement::Positive)],
        );
        check(r#"{"stock": {"diameter": 60, "length": 0}}"#, &[("stock.length", 0.0, Requirement::Positive)]);
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "bore": 60}}"#,
            &[("stock.bore", 60.0, Requirement::Below(60.0))],
        );
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "bore": -1}}"#,
            &[("stock.bore", -1.0, Requirement::NotNegative)],
        );
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "grip": 80}}"#,
            &[("stock.grip", 80.0, Requirement::Below(80.0))],
        );
        check(
            r#"{"stock": {"diameter": 1e300, "length": 80}}"#,
            &[("stock.diameter", 1e300, Requirement::AtMost(5000.0))],
        );
        check(
            r#"{"tools": {"T0303": {"width": 3, "noseRadius": 2}}}"#,
            &[("tools.T0303.noseRadius", 2.0, Requirement::AtMost(1.5))],
        );
        check(
            r#"{"tools": {"T0303": {"width": -3}}}"#,
            &[("tools.T0303.width", -3.0, Requirement::Positive)],
        );
        check(r#"{"tools": {"T0101": {"tip": 10}}}"#, &[("tools.T0101.tip", 10.0, Requirement::AtMost(9.0))]);
        check(r#"{"tools": {"T0101": {"insert": "SNMG120408", "enteringAngle": 90}}}"#, &[]);
        check(
            r#"{"tools": {"T0101": {"insert": "SNMG120408", "enteringAngle": 95}}}"#,
            &[("tools.T0101.enteringAngle", 95.0, Requirement::AtMost(90.0))],
        );
        check(r#"{"machine": {"rapidX": 0}}"#, &[("machine.rapidX", 0.0, Requirement::Positive)]);
        check(
            r#"{"tailstock": {"z": 2, "diameter": -1}}"#,
            &[("tailstock.diameter", -1.0, Requirement::Positive)],
        );
    }
}
