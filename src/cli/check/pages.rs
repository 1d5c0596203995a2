//! `check --markdown`: all programs in a page of a manual, with their positions in the page.
//!
//! In: a page and the settings. Out: findings by line and column of the page. Examples marked `no-check` are
//! skipped, because manuals also show faulty programs.

use super::super::configuration::Settings;
use super::super::manual::attributes::{self, Fault};
use super::super::manual::{Example, Holder};
use super::super::manual_page::{self, Base, Page};
use super::finding::{Finding, Programs, Remark, Subject, What};
use super::selection::Selection;
use crate::api::InferredStock;
use crate::sentences::{Language, labels};
use crate::source::LineIndex;

/// Checks a page.
pub(super) fn check_page(
    page: Page,
    settings: &Settings,
    selection: &Selection,
    language: Language,
) -> Subject {
    let mut look = Look { base: Base::of(settings), page, settings, selection, language };
    let lines = LineIndex::new(&look.page.text);
    let mut programs = Programs::default();
    let mut findings = Vec::new();
    for example in look.page.examples() {
        if example.attributes.get("src").is_some_and(|address| !address.is_empty()) {
            continue;
        }
        if example.attributes.get("no-check").is_some() {
            programs.left_out += 1;
            continue;
        }
        let found = look.example(&example, &lines);
        findings.extend(found.into_iter().map(|what| Finding { program: programs.checked, what }));
        programs.checked += 1;
    }
    let text = std::mem::take(&mut look.page.text);
    Subject { name: look.page.name, text, programs, findings }
}

struct Look<'a> {
    page: Page,
    base: Base,
    settings: &'a Settings,
    selection: &'a Selection,
    language: Language,
}

impl Look<'_> {
    /// The findings of an example.
    fn example(&self, example: &Example, lines: &LineIndex) -> Vec<What> {
        let place = self.page.place(lines, example.at);
        let language = self.language;
        let remark = |slug, message| What::Remark(Remark { place, slug, message });
        let mut found = Vec::new();
        if !example.is_closed {
            found.push(remark("element-not-closed", labels::element_not_closed(language).to_owned()));
        }
        if example.holder != Holder::Code {
            for (name, value) in example.attributes.all() {
                let Some(fault) = attributes::fault(name, value) else { continue };
                let said = match fault {
                    Fault::Name => labels::attribute_unknown(name, language),
                    Fault::Value { expected } => labels::attribute_value(name, value, &expected, language),
                };
                found.push(remark("attribute-wrong", said));
            }
        }
        let setup = match self.base.setup(&example.attributes) {
            Ok(setup) => setup,
            Err(reason) => {
                found.push(remark("setup-unreadable", labels::setup_unreadable(&reason, language)));
                return found;
            }
        };
        let setup = self.selection.levelled(self.settings, setup);
        let mut program = manual_page::run(&self.page.name, example, setup);
        self.selection.keep(self.settings, &mut program.analysis.diagnostics);
        let own_lines = LineIndex::new(&program.text);
        let messages = program.analysis.diagnostics.iter();
        found.extend(messages.map(|told| {
            let (own, page) = (&program.text, &self.page.text);
            What::Message(manual_page::placed(told, example, &own_lines, own, page, lines))
        }));
        let stock = InferredStock::of(&program.analysis, language);
        found.extend(stock.map(|stock| What::InferredStock(Some(place), stock)));
        found
    }
}
