//! `cargo xtask regen`: writes the support tables of `docs/languages/` from the keyword tables.

use std::fmt::Write;

use serde_json::Value;

use crate::{Result, shell};

/// The controllers that have a keyword table, with the title of their page.
const CONTROLLERS: [(&str, &str); 2] = [
    ("mc600", "MC-600 MotionBasic"),
    ("smartmotor", "SmartMotor, class 4"),
];

/// Writes the generated files. Fails if one was not up to date: a regenerated file is to be
/// looked at and committed, not to pass unseen.
pub(crate) fn run() -> Result<()> {
    let mut changed = Vec::new();
    for (controller, title) in CONTROLLERS {
        let arguments = ["run", "--quiet", "--locked", "-p", "motionbench", "--"];
        let words = ["keywords", controller, "--json"];
        let json = shell::capture(shell::cargo(&[&arguments[..], &words].concat()))?;
        let text = page(title, &json)?;
        let name = format!("docs/languages/{controller}.md");
        let path = shell::root().join(&name);
        if std::fs::read_to_string(&path).is_ok_and(|old| old == text) {
            println!("  {name} is up to date");
            continue;
        }
        let folder = path.parent().unwrap_or(shell::root());
        std::fs::create_dir_all(folder)
            .and_then(|()| std::fs::write(&path, text))
            .map_err(|error| format!("{name}: {error}"))?;
        changed.push(name);
    }
    if changed.is_empty() {
        Ok(())
    } else {
        Err(format!(
            "written again, look at the difference: {}",
            changed.join(", ")
        ))
    }
}

/// The columns: the key of a row of `motionbench keywords --json`, and its heading.
const COLUMNS: [(&str, &str); 6] = [
    ("word", "word"),
    ("kind", "kind"),
    ("syntax", "syntax"),
    ("summary", "what it does"),
    ("section", "manual"),
    ("support", "support"),
];

fn page(title: &str, json: &str) -> Result<String> {
    let rows: Vec<Value> = serde_json::from_str(json)
        .map_err(|error| format!("the keyword table is not a list: {error}"))?;
    let mut text = format!(
        "<!-- Written by `cargo xtask regen` from the keyword table: change that. -->\n\
         # {title}\n\nThe words of the language, and how far the simulator supports them.\n\n"
    );
    let headings: Vec<&str> = COLUMNS.iter().map(|(_, heading)| *heading).collect();
    line(&mut text, &headings);
    line(&mut text, &COLUMNS.map(|_| "---"));
    for row in &rows {
        let cells = COLUMNS
            .iter()
            .map(|(key, _)| match row.get(key) {
                Some(Value::String(cell)) => Ok(escape(key, cell)),
                _ => Err(format!("a keyword row without {key}: {row}")),
            })
            .collect::<Result<Vec<String>>>()?;
        line(&mut text, &cells);
    }
    Ok(text)
}

fn line(text: &mut String, cells: &[impl AsRef<str>]) {
    let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
    // Writing to a string does not fail.
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}

/// A cell of a Markdown table: what stands in the device's language is code.
fn escape(key: &str, cell: &str) -> String {
    let cell = cell.replace('|', "\\|");
    match key {
        "word" | "syntax" if cell.contains('`') => format!("`` {cell} ``"),
        "word" | "syntax" if !cell.is_empty() => format!("`{cell}`"),
        _ => cell.replace('<', "&lt;").replace('*', "\\*"),
    }
}

#[cfg(test)]
mod tests {
    use super::page;

    #[test]
    fn a_row_becomes_a_line_of_the_table() {
        let json = r#"[{"word": "OR", "kind": "operator", "syntax": "a|b", "summary": "a * b < 1",
                        "section": "3.2", "support": "full"}]"#;
        let text = page("Title", json).unwrap();
        assert!(text.contains("\n# Title\n"));
        let last = "| `OR` | operator | `a\\|b` | a \\* b &lt; 1 | 3.2 | full |\n";
        assert!(text.ends_with(last), "{text}");
        assert!(page("Title", r#"[{"word": "OR"}]"#).is_err());
    }
}
