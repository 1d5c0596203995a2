//! The machine and the tools of a setup, each as a separate setup.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::setup::profile::Profile;

/// The parts of a setup that can be saved under a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Profiles {
    /// A setup with only the control and the machine, as JSON; absent if it would be empty.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub machine: Option<String>,
    /// A setup with only the tools, as JSON; absent if it would be empty.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tools: Option<String>,
}

impl Profiles {
    /// The profiles of a setup given as JSON.
    pub fn of_setup(json: &str) -> Self {
        Self { machine: Profile::Machine.in_setup(json), tools: Profile::Tools.in_setup(json) }
    }
}
