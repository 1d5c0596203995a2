//! Parts of a setup that are saved under a name and used again: a machine, a table of tools.
//!
//! In: setups as JSON. Out: setups as JSON, which the command line and the page read like any other. The
//! other parts of a setup are unchanged.

use serde_json::{Map, Value};

use super::Setup;

/// A part of a setup that can be saved under a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// The control with its switches, travel, rapids, speed, turret and tailstock.
    Machine,
    /// The tools with their stations.
    Tools,
}

impl Profile {
    /// The profile with a name; the machine for an unknown name.
    pub fn of(name: &str) -> Self {
        if name == "tools" { Self::Tools } else { Self::Machine }
    }

    /// The keys of a setup that belong to the profile.
    const fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Machine => &["dialect", "machine", "tailstock"],
            Self::Tools => &["tools"],
        }
    }

    /// The profile's part of a setup; `None` if it is empty.
    pub fn in_setup(self, json: &str) -> Option<String> {
        let mut all = object(json);
        all.retain(|key, _| self.keys().contains(&key.as_str()));
        (!all.is_empty()).then(|| Value::Object(all).to_string())
    }

    /// Replaces the profile's part of a setup by `profile`. Returns an empty text if the result is empty.
    pub fn put_into(self, json: &str, profile: &str) -> String {
        let mut all = object(json);
        all.retain(|key, _| !self.keys().contains(&key.as_str()));
        all.extend(object(profile).into_iter().filter(|(key, _)| self.keys().contains(&key.as_str())));
        if all.is_empty() { String::new() } else { Value::Object(all).to_string() }
    }
}

/// Merges setups, as JSON; of each top-level key the last value is used.
pub fn joined_text(setups: &[String]) -> String {
    Value::Object(setups.iter().flat_map(|json| object(json)).collect()).to_string()
}

/// Merges setups; of each top-level key the last value is used.
///
/// # Errors
///
/// The error of a text that is not a setup.
pub fn joined(setups: &[String]) -> Result<Setup, String> {
    let [one] = setups else {
        for json in setups {
            // Each setup is read separately, so that an error refers to its own text.
            Setup::from_json(json)?;
        }
        return Setup::from_json(&joined_text(setups));
    };
    Setup::from_json(one)
}

fn object(json: &str) -> Map<String, Value> {
    match serde_json::from_str(json) {
        Ok(Value::Object(all)) => all,
        _ => Map::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: &str = r#"{"blockSkip":[1],"dialect":{"control":"gsk"},"machine":{"rapidX":8000},"tools":{"T0101":{"tip":3}}}"#;

    #[test]
    fn a_setup_is_taken_apart_and_put_together() {
        let machine = r#"{"dialect":{"control":"gsk"},"machine":{"rapidX":8000}}"#;
        assert_eq!(Profile::Machine.in_setup(WHOLE).as_deref(), Some(machine));
        assert_eq!(Profile::Tools.in_setup(WHOLE).as_deref(), Some(r#"{"tools":{"T0101":{"tip":3}}}"#));
        assert_eq!(Profile::Tools.in_setup(machine), None);
        let other = r#"{"tailstock":{"z":2,"diameter":20},"tools":{"T0202":{}}}"#;
        assert_eq!(
            Profile::Machine.put_into(WHOLE, other),
            r#"{"blockSkip":[1],"tailstock":{"diameter":20,"z":2},"tools":{"T0101":{"tip":3}}}"#
        );
        assert_eq!(Profile::Machine.put_into(machine, "{}"), "");
    }

    #[test]
    fn of_several_setups_the_last_that_says_something_holds() {
        let both = joined(&[WHOLE.into(), r#"{"tools":{"T0202":{"tip":2}}}"#.into()]);
        let one = r#"{"blockSkip":[1],"dialect":{"control":"gsk"},"machine":{"rapidX":8000},"tools":{"T0202":{"tip":2}}}"#;
        assert_eq!(both, Setup::from_json(one));
        assert_eq!(joined(&[]), Ok(Setup::default()));
        assert!(
            joined(&["{}".into(), r#"{"stok": {}}"#.into()]).is_err_and(|reason| reason.contains("stok"))
        );
    }
}
