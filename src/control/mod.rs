//! Carries out the program: the only place that handles units, diameters, coordinate frames and modal state.

pub mod arcs;
pub mod codes;
pub mod compensation;
pub mod contour;
pub mod corners;
pub mod doubt;
pub mod events;
pub mod interpreter;
pub mod macros;
pub mod modal;
pub mod offsets;
pub mod origins;
pub mod program;
pub mod second_axis;
pub mod sink;
pub mod tool_offset;
pub mod words;
