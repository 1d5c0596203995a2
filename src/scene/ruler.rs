//! Tick positions.
