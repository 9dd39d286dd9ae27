//! `motionbench keywords`

use motionbench_core::catalog::Kind;
use motionbench_core::language::{KeywordRow, Support};
use serde_json::{Value, json};

use crate::files;

/// Prints a controller's keyword table.
pub(crate) fn run(kind: &Kind, as_json: bool) -> Result<u8, String> {
    let rows = (kind.keywords)();
    let shown = if as_json {
        format!(
            "{:#}\n",
            Value::Array(rows.iter().map(|row| to_json(row)).collect())
        )
    } else {
        table(&rows)
    };
    files::print(&shown).map(|()| 0)
}

fn support(support: Support) -> String {
    match support {
        Support::Full => "full".to_owned(),
        Support::Partial(why) => format!("partial: {why}"),
        Support::Absent(why) => format!("absent: {why}"),
    }
}

fn to_json(row: &KeywordRow) -> Value {
    json!({
        "word": row.word,
        "kind": row.kind,
        "syntax": row.syntax,
        "summary": row.summary,
        "section": row.section.0,
        "support": support(row.support),
        "example": row.example,
    })
}

/// In columns, the widest texts last.
fn table(rows: &[&KeywordRow]) -> String {
    let heading = [
        "word",
        "kind",
        "support",
        "syntax",
        "what it does [section of the manual]",
    ];
    let mut lines = vec![heading.map(str::to_owned)];
    lines.extend(rows.iter().map(|row| {
        let (support, why) = match row.support {
            Support::Full => ("full", String::new()),
            Support::Partial(why) => ("partial", format!(" Partial: {why}")),
            Support::Absent(why) => ("absent", format!(" Absent: {why}")),
        };
        let what = format!("{} [{}]{why}", row.summary, row.section.0);
        [row.word, row.kind, support, row.syntax, &what].map(str::to_owned)
    }));
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max();
    let widths: Vec<usize> = (0..heading.len()).map(|c| width(c).unwrap_or(0)).collect();
    let mut text = String::new();
    for line in &lines {
        let cells = line.iter().zip(&widths);
        let padded: Vec<String> = cells
            .map(|(cell, width)| format!("{cell:width$}"))
            .collect();
        text.push_str(padded.join("  ").trim_end());
        text.push('\n');
    }
    text
}
