//! Fixes that a message of the control offers.
//!
//! In: a message, and the span to change. Out: the message with its fix. The fix is omitted until the part
//! that contains the code of fixes is loaded; messages are not shown before that, and the run starts again
//! then.

use crate::control::words;
use crate::message::{Diagnostic, Fix};
use crate::parts::{Part, late};
use crate::source::Span;

/// The part of the module without which no messages are shown.
pub(super) const REPAIRS: Part = Part::Late;

late! {
    fn with_sign_changed(diagnostic: Diagnostic, text: &[u8], span: Span) -> Diagnostic {
        diagnostic.with(Fix::write(span, words::with_other_sign(&words::quote(text, span))))
    }
}

/// Offers the word with the opposite sign as a fix.
pub(super) fn offer_other_sign(diagnostic: Diagnostic, text: &[u8], span: Span) -> Diagnostic {
    if REPAIRS.is_loaded() { with_sign_changed(diagnostic, text, span) } else { diagnostic }
}
