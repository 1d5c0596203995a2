//! Code actions: the fixes of the messages, all safe fixes in one action, and plain moves as a cycle.
//!
//! In: a range. Out: actions with their edits. If the client can ask for an edit later, the edit of all
//! safe fixes is made only when the user chooses it.

use gen_lsp_types::{
    CodeAction, CodeActionContext, CodeActionKind, CodeActionParams, CodeActionResponse,
    CodeActionTriggerKind,
};
use serde_json::json;

use super::client::FIX_ALL;
use super::context::Asked;
use super::diagnostics::diagnostic;
use super::message::Failure;
use crate::message::{Diagnostic, Edit, Fix};
use crate::repair::{repaired_of, safe};
use crate::rewrite::offers;
use crate::sentences::server;
use crate::source::{Span, line_around};

/// Longest text, bytes, that is searched for cycles without being asked for.
const SEARCHED: usize = 256 << 10;

/// The answer to `textDocument/codeAction`.
pub fn actions(asked: &Asked, params: &CodeActionParams) -> Result<Option<Vec<CodeActionResponse>>, Failure> {
    let (span, wanted) = (asked.positions().span(params.range), &params.context);
    let mut actions = Vec::new();
    if wants(wanted, &CodeActionKind::QuickFix) {
        actions.extend(fixes(asked, span));
    }
    if wants(wanted, &FIX_ALL.into_kind()) {
        actions.extend(fix_all(asked));
    }
    if wants(wanted, &CodeActionKind::RefactorRewrite) && may_search(asked, wanted) {
        actions.extend(cycles(asked, span));
    }
    Ok(Some(actions.into_iter().map(CodeActionResponse::CodeAction).collect()))
}

/// The answer to `codeAction/resolve`: the action with its edit.
pub fn resolved(asked: &Asked, action: &CodeAction) -> Result<CodeAction, Failure> {
    let is_fix_all = action.kind == Some(FIX_ALL.into_kind());
    let edit = is_fix_all.then(|| asked.edits(&all_fixes(asked)));
    Ok(CodeAction { edit: edit.or_else(|| action.edit.clone()), ..action.clone() })
}

trait IntoKind {
    fn into_kind(self) -> CodeActionKind;
}

impl IntoKind for &'static str {
    fn into_kind(self) -> CodeActionKind {
        CodeActionKind::Custom(self.into())
    }
}

/// Whether the client requests actions of a kind: it requests all, this kind, or a parent of it.
fn wants(context: &CodeActionContext, kind: &CodeActionKind) -> bool {
    let name = |kind: &CodeActionKind| serde_json::to_value(kind).ok()?.as_str().map(str::to_owned);
    let Some(kind) = name(kind) else { return false };
    let is_in = |wanted: &CodeActionKind| {
        name(wanted).is_some_and(|wanted| {
            kind.strip_prefix(&wanted)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with('.') || wanted.is_empty())
        })
    };
    context.only.as_ref().is_none_or(|only| only.iter().any(is_in))
}

/// Whether the text may be searched for cycles: it takes two runs or more.
fn may_search(asked: &Asked, context: &CodeActionContext) -> bool {
    asked.text().len() <= SEARCHED || context.trigger_kind == Some(CodeActionTriggerKind::Invoked)
}

/// The fixes of the messages at a span.
fn fixes(asked: &Asked, span: Span) -> Vec<CodeAction> {
    let touches = |found: &&Diagnostic| found.span.start <= span.end && span.start <= found.span.end;
    let found = asked.document.messages().iter().filter(touches);
    found.flat_map(|found| found.fixes.iter().map(|fix| quick_fix(asked, found, fix))).collect()
}

fn quick_fix(asked: &Asked, found: &Diagnostic, fix: &Fix) -> CodeAction {
    CodeAction {
        title: fix.title.words(asked.language),
        kind: Some(CodeActionKind::QuickFix),
        diagnostics: Some(vec![diagnostic(asked, found)]),
        is_preferred: fix.safe.then_some(true),
        edit: Some(asked.edits(&fix.edits)),
        ..CodeAction::default()
    }
}

/// The action that applies all safe fixes, if there is one.
fn fix_all(asked: &Asked) -> Option<CodeAction> {
    if safe(asked.document.messages()).is_empty() {
        return None;
    }
    let edit = (!asked.client.resolves_edits).then(|| asked.edits(&all_fixes(asked)));
    Some(CodeAction {
        title: server::fix_all(asked.language).to_owned(),
        kind: Some(FIX_ALL.into_kind()),
        edit,
        data: Some(json!({"address": asked.address})),
        ..CodeAction::default()
    })
}

/// The edits of all safe fixes, as `check --fix` makes them. None if they do not come to an end.
fn all_fixes(asked: &Asked) -> Vec<Edit> {
    let settings = asked.document.settings();
    let repaired = repaired_of(asked.text(), &settings.setup, &|found| settings.takes(found));
    if repaired.open.is_some() { Vec::new() } else { changed_lines(asked.text(), &repaired.text) }
}

/// The edits that change a text into another one: one for each changed line if both have the same number of
/// lines.
fn changed_lines(before: &[u8], after: &[u8]) -> Vec<Edit> {
    let (old, new): (Vec<_>, Vec<_>) = (lines(before), lines(after));
    if old.len() != new.len() {
        return vec![changed_middle(before, after)];
    }
    let pairs = old.iter().zip(&new);
    let changed = pairs.filter(|(old, new)| old.of(before) != new.of(after));
    changed.map(|(old, new)| Edit { span: *old, text: new.quote(after) }).collect()
}

/// The edit of the lines between those that are the same at the begin and at the end.
fn changed_middle(before: &[u8], after: &[u8]) -> Edit {
    let same = before.iter().zip(after).take_while(|(old, new)| old == new).count();
    let start = line_around(before, same).start as usize;
    let rest = before[start..].iter().rev().zip(after[start..].iter().rev());
    let same = rest.take_while(|(old, new)| old == new).count();
    // A character is not cut.
    let is_cut = |byte: &usize| before.get(*byte).is_some_and(|byte| byte & 0xC0 == 0x80);
    let end = (before.len() - same..=before.len()).find(|byte| !is_cut(byte)).unwrap_or(before.len());
    let behind = before.len() - end;
    let text = String::from_utf8_lossy(&after[start..after.len() - behind]).into_owned();
    Edit { span: Span::new(start, end), text }
}

/// The spans of the lines, without their line ends.
fn lines(text: &[u8]) -> Vec<Span> {
    let index = crate::source::LineIndex::new(text);
    (0..index.len()).map(|line| index.line(text, line)).collect()
}

/// The plain moves at a span that form a cycle.
fn cycles(asked: &Asked, span: Span) -> Vec<CodeAction> {
    let text = asked.text();
    let lines = line_around(text, span.start as usize).to(line_around(text, span.end as usize));
    let setup = asked.document.run().setup_to_repeat();
    let offers = offers(text, &setup, Some(span)).into_iter();
    let here = offers.filter(|offer| offer.span.start <= lines.end && lines.start <= offer.span.end);
    let action = |offer: crate::rewrite::Offer| CodeAction {
        title: offer.title(asked.language),
        kind: Some(CodeActionKind::RefactorRewrite),
        edit: Some(asked.edits(&offer.edits)),
        ..CodeAction::default()
    };
    here.map(action).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::applied;

    #[test]
    fn the_edits_lead_from_one_text_to_the_other() {
        for (before, after, edits) in [
            ("GO1\nX5\nZ–2\n", "G01\nX5\nZ-2\n", 2),
            ("G0 X1\nG1", "G0 X1\nG1\nM30", 1),
            ("a外\nb", "a外\nb", 0),
            ("a外\nb\nc", "a夕\nc", 1),
            ("外", "外\n外", 1),
            ("", "M30\n", 1),
        ] {
            let found = changed_lines(before.as_bytes(), after.as_bytes());
            assert_eq!(found.len(), edits, "{before:?}");
            assert_eq!(String::from_utf8_lossy(&applied(before.as_bytes(), &found)), after);
        }
    }

    #[test]
    fn a_kind_contains_those_below_it() {
        let wants = |only: &[&'static str], kind: &'static str| {
            let only = Some(only.iter().map(|kind| kind.into_kind()).collect());
            wants(&CodeActionContext { only, ..CodeActionContext::default() }, &kind.into_kind())
        };
        assert!(wants(&["source"], FIX_ALL) && wants(&["source.fixAll"], FIX_ALL) && wants(&[""], FIX_ALL));
        assert!(!wants(&["source.fix"], FIX_ALL) && !wants(&["quickfix"], FIX_ALL) && !wants(&[], FIX_ALL));
    }
}
