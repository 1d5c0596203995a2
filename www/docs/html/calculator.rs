//! The calculators in the manual.
//!
//! In: the name of a calculator, a language. Out: HTML: its worked example as a table, also for print, and the element
//! with the calculator.

use std::fmt::Write;

use gcode_playground::api::calculate::{Calculation, calculate, form};
use gcode_playground::calculate::{Calculator, Writing};
use gcode_playground::sentences::Language;

use super::site::escaped;

/// Name, meaning, value: the headings of the table.
fn headings(language: Language) -> [&'static str; 3] {
    match language {
        Language::English => ["Letter", "Meaning", "Example"],
        Language::Chinese => ["字母", "含义", "例"],
        Language::Russian => ["Буква", "Значение", "Пример"],
    }
}

/// The table and the element. `controls`: the groups of controls that the elements of the page show.
pub fn html(name: &str, controls: &str, language: Language) -> Result<String, String> {
    let calculator = Calculator::find(name).ok_or_else(|| format!("there is no calculator `{name}`"))?;
    let form = form(calculator, None, Writing::METRIC, language);
    let values: Vec<String> = form.fields.iter().map(|field| field.value.clone()).collect();
    let found = calculate(calculator, &values, Writing::METRIC, language, |_| Vec::new());
    let Calculation::Done(found) = found else {
        return Err(format!("the example of `{name}` has no result"));
    };
    let mut out = "<div class=\"table\" tabindex=\"0\">\n<table class=\"form\">\n".to_owned();
    let [letter, meaning, value] = headings(language);
    let _ = writeln!(out, "<caption>{}</caption>", escaped(form.title));
    let _ =
        writeln!(out, "<thead><tr><th>{letter}</th><th>{meaning}</th><th>{value}</th></tr></thead>\n<tbody>");
    let mut row = |letter: &str, meaning: &str, value: &str| {
        let _ = writeln!(
            out,
            "<tr><td><code lang=\"en\">{}</code></td><td>{}</td><td>{}</td></tr>",
            escaped(letter),
            escaped(meaning),
            escaped(value)
        );
    };
    for field in &form.fields {
        row(field.letter, field.title, &format!("{} {}", field.value, field.unit));
    }
    for result in &found.results {
        row(result.letter, result.title, &format!("= {}", result.value));
    }
    out.push_str("</tbody>\n</table>\n</div>\n");
    // The letters of a cycle, or the sizes of a part without one.
    let annotate = if matches!(name, "cone" | "speed") { "part" } else { "cycle" };
    let _ = writeln!(
        out,
        "<gcode-playground class=\"calculator\" calculator=\"{name}\" annotate=\"{annotate}\" language=\"{}\" \
         controls=\"{controls}\" caption=\"{}\">\n<pre>\n{}</pre>\n</gcode-playground>",
        language.tag(),
        escaped(form.title),
        escaped(&found.program),
    );
    Ok(out)
}
