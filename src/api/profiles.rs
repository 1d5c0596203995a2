//! Machine and tools of a setup, each as a setup of its own.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::setup::profile::Profile;

/// What of a setup can be kept under a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Profiles {
    /// A setup with the control and the machine alone, as JSON; none where nothing is said of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub machine: Option<String>,
    /// The same with the tools alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tools: Option<String>,
}

impl Profiles {
    /// Those of a setup as JSON.
    pub fn of_setup(json: &str) -> Self {
        Self { machine: Profile::Machine.in_setup(json), tools: Profile::Tools.in_setup(json) }
    }
}
