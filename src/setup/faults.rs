//! What cannot be in a setup.
//!
//! In: a setup as it was read. Out: the faults, and the setup without what is wrong in it, so that a run and a picture
//! come of every setup.

use super::{Setup, Stock, Tool};
use crate::message::Message;

/// An invalid value.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Where it stands, as in JSON: `stock.diameter`, `tools.T0101.width`.
    pub key: String,
    /// The value.
    pub value: f64,
    /// What is asked of it.
    pub need: Need,
}

impl Fault {
    /// What is said of it.
    pub fn message(self) -> Message {
        let Self { key, value, need } = self;
        match need {
            Need::Positive => Message::SetupPositive { key, value },
            Need::NotNegative => Message::SetupNotNegative { key, value },
            Need::Below(most) => Message::SetupBelow { key, value, most },
            Need::AtMost(most) => Message::SetupAtMost { key, value, most },
        }
    }
}

/// What is asked of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NotNegative,
    /// Less than this.
    Below(f64),
    /// Not more than this.
    AtMost(f64),
}

/// Longest length of anything, mm.
const LONGEST: f64 = 5000.0;

impl Need {
    fn is_met(self, value: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Below(most) => value < most,
            Self::AtMost(most) => value <= most,
        }
    }
}

/// Looks at values, and keeps the first fault of each.
#[derive(Default)]
struct Look {
    faults: Vec<Fault>,
}

impl Look {
    fn at(&mut self, key: impl Into<String>, value: Option<f64>, needs: &[Need]) {
        let Some(value) = value else { return };
        if let Some(&need) = needs.iter().find(|need| !need.is_met(value)) {
            self.faults.push(Fault { key: key.into(), value, need });
        }
    }

    fn stock(&mut self, stock: &Stock) {
        const SIZE: [Need; 2] = [Need::Positive, Need::AtMost(LONGEST)];
        self.at("stock.diameter", Some(stock.diameter), &SIZE);
        self.at("stock.length", Some(stock.length), &SIZE);
        self.at("stock.face", Some(stock.face.abs()), &[Need::AtMost(LONGEST)]);
        self.at("stock.bore", Some(stock.bore), &[Need::NotNegative]);
        if self.faults.is_empty() {
            self.at("stock.bore", Some(stock.bore), &[Need::Below(stock.diameter)]);
            self.at("stock.grip", stock.grip, &[Need::NotNegative, Need::Below(stock.length)]);
        }
    }

    fn tool(&mut self, name: &str, tool: &Tool) {
        const LENGTH: [Need; 2] = [Need::Positive, Need::AtMost(LONGEST)];
        const RADIUS: [Need; 2] = [Need::NotNegative, Need::AtMost(100.0)];
        let angle = |most| [Need::Positive, Need::Below(most)];
        let key = |key: &str| format!("tools.{name}.{key}");
        self.at(key("noseRadius"), tool.nose_radius, &RADIUS);
        self.at(key("tip"), tool.tip.map(f64::from), &[Need::AtMost(9.0)]);
        self.at(key("pointAngle"), tool.point_angle, &angle(180.0));
        self.at(key("enteringAngle"), tool.entering_angle, &angle(180.0));
        // Edges that are together wider than a half turn: the one behind the tip would be below it.
        let point = tool.point_angle.or_else(|| tool.insert()?.point_angle).unwrap_or(80.0);
        if tool.entering_angle.is_some_and(|entering| entering < 180.0) {
            self.at(key("enteringAngle"), tool.entering_angle, &[Need::AtMost(180.0 - point)]);
        }
        self.at(key("edgeLength"), tool.edge_length, &LENGTH);
        self.at(key("width"), tool.width, &LENGTH);
        self.at(key("diameter"), tool.diameter, &LENGTH);
        self.at(key("reach"), tool.reach, &LENGTH);
        self.at(key("shank"), tool.shank, &LENGTH);
        self.at(key("toolRadius"), tool.tool_radius, &RADIUS);
        self.at(key("geometryR"), tool.geometry_r, &RADIUS);
        self.at(key("angle"), tool.angle, &[Need::Positive, Need::AtMost(180.0)]);
        if let (Some(width), Some(nose)) = (tool.width, tool.nose_radius) {
            self.at(key("noseRadius"), Some(nose), &[Need::AtMost(width / 2.0)]);
        }
    }
}

impl Setup {
    /// The setup without what cannot be in it, and why. Stock and tools with a fault count as not given.
    pub fn without_faults(mut self) -> (Self, Vec<Fault>) {
        let mut look = Look::default();
        if let Some(stock) = self.stock {
            look.stock(&stock);
            if !look.faults.is_empty() {
                self.stock = None;
            }
        }
        self.tools.retain(|name, tool| {
            let before = look.faults.len();
            look.tool(name, tool);
            look.faults.len() == before
        });
        if let Some(tailstock) = self.tailstock {
            let before = look.faults.len();
            look.at("tailstock.diameter", Some(tailstock.diameter), &[Need::Positive, Need::AtMost(LONGEST)]);
            look.at("tailstock.z", Some(tailstock.z.abs()), &[Need::AtMost(LONGEST)]);
            if look.faults.len() > before {
                self.tailstock = None;
            }
        }
        if let Some(start) = self.initial {
            let before = look.faults.len();
            look.at("initial.x", Some(start.x.abs()), &[Need::AtMost(LONGEST)]);
            look.at("initial.z", Some(start.z.abs()), &[Need::AtMost(LONGEST)]);
            if look.faults.len() > before {
                self.initial = None;
            }
        }
        for (key, value) in [
            ("machine.rapidX", &mut self.machine.rapid_x),
            ("machine.rapidZ", &mut self.machine.rapid_z),
            ("machine.maxSpeed", &mut self.machine.max_speed),
        ] {
            let before = look.faults.len();
            look.at(key, *value, &[Need::Positive]);
            if look.faults.len() > before {
                *value = None;
            }
        }
        (self, look.faults)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(json: &str, faults: &[(&str, f64, Need)]) {
        let (setup, found) = Setup::from_json(json).expect("well-formed JSON").without_faults();
        let found: Vec<_> = found.iter().map(|fault| (fault.key.as_str(), fault.value, fault.need)).collect();
        assert_eq!(found, faults, "{json}");
        assert_eq!(setup.without_faults().1, [], "{json}");
    }

    #[test]
    fn each_fault_is_found_once() {
        check(r#"{"stock": {"diameter": 60, "length": 80, "bore": 59.9, "grip": 79}}"#, &[]);
        check(
            r#"{"stock": {"diameter": -60, "length": 80, "bore": 70}}"#,
            &[("stock.diameter", -60.0, Need::Positive)],
        );
        check(r#"{"stock": {"diameter": 60, "length": 0}}"#, &[("stock.length", 0.0, Need::Positive)]);
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "bore": 60}}"#,
            &[("stock.bore", 60.0, Need::Below(60.0))],
        );
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "bore": -1}}"#,
            &[("stock.bore", -1.0, Need::NotNegative)],
        );
        check(
            r#"{"stock": {"diameter": 60, "length": 80, "grip": 80}}"#,
            &[("stock.grip", 80.0, Need::Below(80.0))],
        );
        check(
            r#"{"stock": {"diameter": 1e300, "length": 80}}"#,
            &[("stock.diameter", 1e300, Need::AtMost(5000.0))],
        );
        check(
            r#"{"tools": {"T0303": {"width": 3, "noseRadius": 2}}}"#,
            &[("tools.T0303.noseRadius", 2.0, Need::AtMost(1.5))],
        );
        check(r#"{"tools": {"T0303": {"width": -3}}}"#, &[("tools.T0303.width", -3.0, Need::Positive)]);
        check(r#"{"tools": {"T0101": {"tip": 10}}}"#, &[("tools.T0101.tip", 10.0, Need::AtMost(9.0))]);
        check(r#"{"tools": {"T0101": {"insert": "SNMG120408", "enteringAngle": 90}}}"#, &[]);
        check(
            r#"{"tools": {"T0101": {"insert": "SNMG120408", "enteringAngle": 95}}}"#,
            &[("tools.T0101.enteringAngle", 95.0, Need::AtMost(90.0))],
        );
        check(r#"{"machine": {"rapidX": 0}}"#, &[("machine.rapidX", 0.0, Need::Positive)]);
        check(r#"{"tailstock": {"z": 2, "diameter": -1}}"#, &[("tailstock.diameter", -1.0, Need::Positive)]);
    }
}
