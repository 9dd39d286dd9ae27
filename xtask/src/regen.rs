//! `cargo xtask regen`: writes the pages of `docs/languages/` from the keyword tables.
//!
//! A page is what a newcomer learns a language from: the introduction that stands in `docs/languages/intro/`, then every
//! word by its kind, with its syntax, what it does, and an example that was run here.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::{Result, shell};

/// A controller that has a keyword table.
struct Language {
    id: &'static str,
    title: &'static str,
    /// What its console sends before and behind the output of a program that is run.
    frame: (&'static str, &'static str),
    /// Kinds of words whose examples show something by themselves, without a machine or a larger program around them.
    shown: &'static [&'static str],
}

const LANGUAGES: [Language; 3] = [
    Language {
        id: "mc600",
        title: "MC-600 MotionBasic",
        frame: (">RUN\r\n", ">"),
        shown: &["statement", "operator", "function", "constant"],
    },
    Language {
        id: "smartmotor",
        title: "SmartMotor, class 4",
        frame: ("", ""),
        shown: &[],
    },
    Language {
        id: "unidex3",
        title: "Unidex IIIa",
        frame: ("", ""),
        shown: &[],
    },
];

/// Kinds of words in the order of their sections, each with its heading. Others follow under their own names.
const SECTIONS: [(&str, &str); 29] = [
    ("flow", "Program flow"),
    ("variable", "Variables and memory"),
    ("command", "Commands"),
    ("axis", "Moves"),
    ("feedrate", "Feedrates"),
    ("dwell", "Dwells"),
    ("m", "M codes"),
    ("n", "N codes"),
    ("g", "G codes"),
    ("register", "Registers"),
    ("message", "Messages"),
    ("block", "Blocks"),
    ("statement", "Statements"),
    ("operator", "Operators"),
    ("function", "Functions"),
    ("constant", "Constants"),
    ("motion", "Motion"),
    ("tuning", "Tuning"),
    ("protection", "Protection"),
    ("drive", "Drive"),
    ("io", "Inputs and outputs"),
    ("anilink", "AniLink modules"),
    ("status", "Status"),
    ("report", "Reports"),
    ("serial", "The serial line"),
    ("remote", "Commands of the controller"),
    ("key", "Keys"),
    ("sysvar", "System variables"),
    ("not-implemented", "Not implemented by the device"),
];

/// Writes the generated files. Fails if one was not up to date: a regenerated file is to be
/// looked at and committed, not to pass unseen.
pub(crate) fn run() -> Result<()> {
    let mut changed = Vec::new();
    for language in LANGUAGES {
        let arguments = ["run", "--quiet", "--locked", "-p", "motionbench", "--"];
        let words = ["keywords", language.id, "--json"];
        let json = shell::capture(shell::cargo(&[&arguments[..], &words].concat()))?;
        let name = format!("docs/languages/{}.md", language.id);
        let path = shell::root().join(&name);
        let intro = shell::root().join(format!("docs/languages/intro/{}.md", language.id));
        let intro = std::fs::read_to_string(&intro)
            .map_err(|error| format!("{}: {error}", intro.display()))?;
        let runner = Runner::new(language.id, language.frame)?;
        let text = page(&language, &intro, &json, |example| runner.show(example))?;
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

/// Runs examples on a simulated controller.
struct Runner {
    id: &'static str,
    frame: (&'static str, &'static str),
    /// The runner that cargo has just built beside this program.
    motionbench: PathBuf,
    /// Where the example lies for it.
    program: PathBuf,
}

impl Runner {
    fn new(id: &'static str, frame: (&'static str, &'static str)) -> Result<Runner> {
        let own = std::env::current_exe().map_err(|error| error.to_string())?;
        let folder = own.parent().unwrap_or(Path::new("."));
        Ok(Runner {
            id,
            frame,
            motionbench: folder.join("motionbench"),
            program: folder.join("example.txt"),
        })
    }

    /// What a program of these lines prints, if it ends by itself and without an error.
    fn show(&self, example: &str) -> Result<Option<String>> {
        let failed = |error: std::io::Error| format!("example {example}: {error}");
        std::fs::write(&self.program, format!("{example}\n")).map_err(failed)?;
        let mut command = std::process::Command::new(&self.motionbench);
        command.args(["run", self.id]).arg(&self.program);
        command.stdin(std::process::Stdio::null());
        let output = command.output().map_err(failed)?;
        let console = String::from_utf8_lossy(&output.stdout);
        let (before, behind) = self.frame;
        let printed = console
            .strip_prefix(before)
            .and_then(|rest| rest.strip_suffix(behind))
            .filter(|printed| output.status.success() && !printed.trim().is_empty());
        Ok(printed.map(|printed| printed.trim_end_matches(['\r', '\n']).to_owned()))
    }
}

fn page(
    language: &Language,
    intro: &str,
    json: &str,
    show: impl Fn(&str) -> Result<Option<String>>,
) -> Result<String> {
    let rows: Vec<Value> = serde_json::from_str(json)
        .map_err(|error| format!("the keyword table is not a list: {error}"))?;
    let mut text = format!(
        "<!-- Written by `cargo xtask regen` from the keyword table and `intro/`: change those. -->\n\
         # {}\n\n{}\n\n## Words\n\n\
         In the syntax, what stands in `[ ]` may be left out, `...` repeats, and `|` separates choices.\n",
        language.title,
        intro.trim_end()
    );
    let mut kinds: Vec<&str> = SECTIONS.iter().map(|(kind, _)| *kind).collect();
    for row in &rows {
        let kind = cell(row, "kind")?;
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    for kind in kinds {
        let of_kind: Vec<&Value> = rows.iter().filter(|row| row["kind"] == kind).collect();
        if !of_kind.is_empty() {
            let shown = language.shown.contains(&kind);
            section(&mut text, kind, &of_kind, shown.then_some(&show))?;
        }
    }
    Ok(text)
}

/// One table: the words of a kind.
fn section(
    text: &mut String,
    kind: &str,
    rows: &[&Value],
    show: Option<impl Fn(&str) -> Result<Option<String>>>,
) -> Result<()> {
    let heading = SECTIONS.iter().find(|(known, _)| *known == kind);
    // Writing to a string does not fail.
    let _ = writeln!(
        text,
        "\n### {}\n",
        heading.map_or(kind, |(_, heading)| heading)
    );
    let mut headings = vec!["word", "syntax", "what it does", "example"];
    if show.is_some() {
        headings.push("prints");
    }
    headings.extend(["manual", "support"]);
    line(text, &headings);
    line(text, &headings.iter().map(|_| "---").collect::<Vec<_>>());
    for row in rows {
        let example = cell(row, "example")?;
        let mut cells = vec![
            code(cell(row, "word")?),
            code(cell(row, "syntax")?),
            prose(cell(row, "summary")?),
            lines_of_code(example.split('\n')),
        ];
        if let Some(show) = &show {
            let printed = show(example)?.unwrap_or_default();
            cells.push(lines_of_code(printed.split("\r\n")));
        }
        cells.push(prose(cell(row, "section")?));
        cells.push(prose(cell(row, "support")?));
        line(text, &cells);
    }
    Ok(())
}

fn cell<'a>(row: &'a Value, key: &str) -> Result<&'a str> {
    row.get(key)
        .and_then(Value::as_str)
        .ok_or_else(|| format!("a keyword row without {key}: {row}"))
}

fn line(text: &mut String, cells: &[impl AsRef<str>]) {
    let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
    // Writing to a string does not fail.
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}

/// What stands in the device's language, in a cell of a Markdown table.
fn code(cell: &str) -> String {
    let cell = cell.replace('|', "\\|");
    match cell.trim() {
        "" => String::new(),
        _ if cell.contains('`') => format!("`` {cell} ``"),
        // Markdown takes one blank off both ends where there are two.
        _ if cell.starts_with(' ') && cell.ends_with(' ') => format!("` {cell} `"),
        _ => format!("`{cell}`"),
    }
}

fn lines_of_code<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    lines.map(code).collect::<Vec<String>>().join("<br>")
}

/// A sentence in a cell of a Markdown table.
fn prose(cell: &str) -> String {
    cell.replace('|', "\\|")
        .replace('<', "&lt;")
        .replace('*', "\\*")
}

#[cfg(test)]
mod tests {
    use super::{Language, page};

    const ROW: &str = r#"[{"word": "OR", "kind": "operator", "syntax": "a|b", "summary": "a * b < 1",
        "section": "3.2", "support": "full", "example": "10 PRINT 1 OR 2\n20 PRINT \"A\""},
        {"word": "X", "kind": "strange", "syntax": "X", "summary": "Why?", "section": "9",
        "support": "absent: no", "example": "X"}]"#;

    #[test]
    fn a_row_becomes_a_line_of_its_kinds_table() {
        let show = |example: &str| Ok((example != "X").then(|| " 3 \r\nA".to_owned()));
        let language = Language {
            id: "x",
            title: "Title",
            frame: ("", ""),
            shown: &["operator"],
        };
        let text = page(&language, "First words.\n", ROW, show).unwrap();
        assert!(text.contains("\n# Title\n\nFirst words.\n\n"));
        let operator = "| `OR` | `a\\|b` | a \\* b &lt; 1 | `10 PRINT 1 OR 2`<br>`20 PRINT \"A\"` | `  3  `<br>`A` | 3.2 | full |\n";
        assert!(text.contains(&format!("### Operators\n\n| word | syntax | what it does | example | prints | manual | support |\n| --- | --- | --- | --- | --- | --- | --- |\n{operator}")), "{text}");
        assert!(text.ends_with("### strange\n\n| word | syntax | what it does | example | manual | support |\n| --- | --- | --- | --- | --- | --- |\n| `X` | `X` | Why? | `X` | 9 | absent: no |\n"), "{text}");
        assert!(page(&language, "", r#"[{"word": "OR"}]"#, show).is_err());
    }
}
