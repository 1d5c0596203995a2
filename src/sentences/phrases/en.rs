//! The phrases in English.

use super::Phrase;

pub(in crate::sentences) const fn phrase(phrase: Phrase) -> &'static str {
    use Phrase::*;
    match phrase {
        CloseComment => "Close the comment",
        DecimalPoint => "Write a decimal point",
        LetterO => "Write the letter O",
        Minus => "Write a minus sign",
        Write => "Write `{text}`",
        Delete => "Delete `{text}`",
        Insert => "Insert `{text}`",
        AsCycle => "Write these four moves as {cycle}",
        AsCyclePasses => "Write these {passes} passes as {cycle}",
        Rapid => "rapid to {to}",
        Feed => "feed to {to}",
        ArcClockwise => "arc G02 to {to}",
        ArcCounterclockwise => "arc G03 to {to}",
        Thread => "thread to {to}",
        Dwell => "dwell to {to}",
        DwellFor => "dwell {seconds} s at {to}",
        Infeed => "infeed",
        Cut => "cut",
        PullOut => "pull-out",
        Retract => "retract",
        Return => "return",
        Approach => "approach",
        Escape => "escape",
        Contour => "along the contour",
        Relief => "relief",
        Stepover => "step-over",
        AtRapid => "at rapid",
        WithSpindle => "synchronized with the spindle",
        AtFeed => "at feed",
        Pass => ", pass {pass}",
        PassOf => ", pass {pass} of {passes}",
        OfCycle => "{cycle}{pass}: {step} {manner} to {to}",
        CutOfCycle => "{cycle}{pass}: {step} {manner} to {to}",
    }
}
