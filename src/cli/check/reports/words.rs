//! The summary line of a report, in three languages.

use super::Counts;
use crate::cli::counted;
use crate::sentences::Language;

/// `3 errors, 2 warnings in 14 files, 5 fixable`.
pub(super) fn summary(counts: &Counts, language: Language) -> String {
    let Counts { files, errors, warnings, notes, fixable, without_stock, .. } = *counts;
    let is_clean = errors + warnings + notes == 0;
    match language {
        Language::English => {
            let found = join(&[(errors, "error"), (warnings, "warning"), (notes, "note")], ", ", counted);
            let found = if is_clean { "nothing found".to_owned() } else { found };
            let mut line = format!("{found} in {}", counted(files, "file"));
            if fixable > 0 {
                line += &format!(", {fixable} fixable with --fix");
            }
            if without_stock > 0 {
                line += &format!("; {without_stock} without a stock: collisions not checked");
            }
            line
        }
        Language::Chinese => {
            let found = join(
                &[(errors, "个错误"), (warnings, "个警告"), (notes, "条提示")],
                "，",
                |count, what| format!("{count} {what}"),
            );
            let found = if is_clean { "未发现问题".to_owned() } else { found };
            let mut line = format!("{found}，共 {files} 个文件");
            if fixable > 0 {
                line += &format!("，其中 {fixable} 处可用 --fix 修复");
            }
            if without_stock > 0 {
                line += &format!("；{without_stock} 个文件没有给出毛坯：未检查碰撞");
            }
            line
        }
        Language::Russian => {
            let found = join(
                &[(errors, "ошибок"), (warnings, "предупреждений"), (notes, "замечаний")],
                ", ",
                |count, what| format!("{what}: {count}"),
            );
            let found = if is_clean { "замечаний нет".to_owned() } else { found };
            let mut line = format!("{found}; файлов: {files}");
            if fixable > 0 {
                line += &format!("; исправит --fix: {fixable}");
            }
            if without_stock > 0 {
                line += &format!("; без заготовки: {without_stock}, столкновения не проверены");
            }
            line
        }
    }
}

/// Joins the counts that are not zero.
fn join(counts: &[(usize, &str)], between: &str, say: impl Fn(usize, &str) -> String) -> String {
    let found = counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| say(*count, what));
    found.collect::<Vec<_>>().join(between)
}
