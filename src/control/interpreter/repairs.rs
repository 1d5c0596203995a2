//! Repairs that a message of the control offers.
//!
//! In: a message, and the place of what is to be changed. Out: the message with its repair; without, as long as nobody
//! can read messages: a run begins anew when that part has been loaded.

use crate::control::words;
use crate::message::{Diagnostic, Fix};
use crate::parts::{Part, late};
use crate::source::Span;

/// The part without which nobody reads messages.
pub(super) const REPAIRS: Part = Part::Late;

late! {
    fn with_sign_changed(diagnostic: Diagnostic, text: &[u8], span: Span) -> Diagnostic {
        diagnostic.with(Fix::write(span, words::with_other_sign(&words::quote(text, span))))
    }
}

/// Offers the word with the other sign.
pub(super) fn offer_other_sign(diagnostic: Diagnostic, text: &[u8], span: Span) -> Diagnostic {
    if REPAIRS.is_loaded() { with_sign_changed(diagnostic, text, span) } else { diagnostic }
}
