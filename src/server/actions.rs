//! Code actions: the fixes of the messages, all safe fixes in one action, plain moves as a cycle, and the program
//! as plain moves.
//!
//! In: a range. Out: actions with their edits. If the client can ask for an edit later, the edit of the whole
//! program is made only when the user chooses it.

use gen_lsp_types::{
    CodeAction, CodeActionContext, CodeActionKind, CodeActionParams, CodeActionResponse,
    CodeActionTriggerKind, WorkspaceEdit,
};
use serde_json::json;

use super::client::FIX_ALL;
use super::context::Asked;
use super::diagnostics::diagnostic;
use super::message::{Failure, Reason};
use super::rewritten::{changed_lines, changed_middle};
use crate::expand::expansion;
use crate::message::{Diagnostic, Edit, Fix};
use crate::repair::{repaired_of, safe};
use crate::rewrite::offers;
use crate::run::Run;
use crate::sentences::server;
use crate::source::{Span, line_around};

/// Longest text, bytes, that is searched for cycles without being asked for.
const SEARCHED: usize = 256 << 10;
/// The kind of the action that expands the program.
const EXPAND: &str = "refactor.rewrite.expand.gcode-playground";

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
    if wants(wanted, &EXPAND.into_kind()) {
        actions.extend(expand_all(asked, span, wanted));
    }
    Ok(Some(actions.into_iter().map(CodeActionResponse::CodeAction).collect()))
}

/// The answer to `codeAction/resolve`: the action with its edit.
pub fn resolved(asked: &Asked, action: &CodeAction) -> Result<CodeAction, Failure> {
    let edit = match &action.kind {
        Some(kind) if *kind == FIX_ALL.into_kind() => Some(asked.edits(&all_fixes(asked))),
        Some(kind) if *kind == EXPAND.into_kind() => {
            let refused = || Failure::new(Reason::RequestFailed, server::not_expanded(asked.language));
            Some(asked.edits(&[expanded(asked).ok_or_else(refused)?]))
        }
        _ => action.edit.clone(),
    };
    Ok(CodeAction { edit, ..action.clone() })
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
    let found = asked.document.fixable().iter().filter(touches);
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
    if safe(asked.document.fixable()).is_empty() {
        return None;
    }
    let edit = (!asked.client.resolves_edits).then(|| asked.edits(&all_fixes(asked)));
    Some(of_whole(asked, server::fix_all(asked.language), FIX_ALL, edit))
}

/// An action on the whole program; without its edit, the client asks for it later.
fn of_whole(asked: &Asked, title: &str, kind: &'static str, edit: Option<WorkspaceEdit>) -> CodeAction {
    CodeAction {
        title: title.to_owned(),
        kind: Some(kind.into_kind()),
        edit,
        data: Some(json!({"address": asked.address})),
        ..CodeAction::default()
    }
}

/// The action that expands the program, if a cycle is at the span or if the client requests the kind.
fn expand_all(asked: &Asked, span: Span, context: &CodeActionContext) -> Option<CodeAction> {
    let run = asked.document.run();
    // The text of a document cannot contain the subprograms of other files.
    let is_whole = run.text().len() == asked.text().len();
    let lines = if context.only.is_some() { Span::new(0, asked.text().len()) } else { lines_of(asked, span) };
    if !is_whole || !has_cycle(run, lines) {
        return None;
    }
    let edit = match asked.client.resolves_edits {
        true => None,
        false if may_search(asked, context) => Some(asked.edits(&[expanded(asked)?])),
        false => return None,
    };
    Some(of_whole(asked, server::expand(asked.language), EXPAND, edit))
}

/// Whether a cycle moves in some lines.
fn has_cycle(run: &Run, lines: Span) -> bool {
    let motions = run.motions();
    let is_there = |index: usize| {
        let block = motions.span(index);
        block.start <= lines.end && lines.start <= block.end
    };
    (0..motions.len()).any(|index| is_there(index) && motions.get(index).cycle.is_some())
}

/// The edit that expands the program; `None` if its motions would not stay the same, or if there is nothing to expand.
fn expanded(asked: &Asked) -> Option<Edit> {
    let setup = asked.document.run().setup_to_repeat();
    let expanded = asked.with_line_ends(&expansion(asked.text(), &setup)?);
    (expanded.as_bytes() != asked.text()).then(|| changed_middle(asked.text(), expanded.as_bytes()))
}

/// The lines that a span touches.
fn lines_of(asked: &Asked, span: Span) -> Span {
    let line = |byte: u32| line_around(asked.text(), byte as usize);
    line(span.start).to(line(span.end))
}

/// The edits of all safe fixes, as `check --fix` makes them. None if they do not come to an end.
fn all_fixes(asked: &Asked) -> Vec<Edit> {
    let settings = asked.document.settings();
    let repaired = repaired_of(asked.text(), &settings.setup, &|found| settings.takes(found));
    if repaired.open.is_some() { Vec::new() } else { changed_lines(asked.text(), &repaired.text) }
}

/// The plain moves at a span that form a cycle.
fn cycles(asked: &Asked, span: Span) -> Vec<CodeAction> {
    let text = asked.text();
    let lines = lines_of(asked, span);
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
