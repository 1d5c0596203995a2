//! Arrow heads.
