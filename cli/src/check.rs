//! `motionbench check`

use std::path::Path;

use motionbench_core::catalog::Kind;
use motionbench_core::language::{Diagnostic, Severity};
use motionbench_core::scenario::program_text;
use serde_json::{Value, json};

use crate::files;

/// Prints what is wrong with a program; exit code 1 if the controller would object to something.
pub(crate) fn run(kind: &Kind, path: &Path, as_json: bool) -> Result<u8, String> {
    let text = program_text(&files::read(path)?);
    let found = (kind.diagnose)(&text);
    let shown = if as_json {
        let rows: Vec<Value> = found.iter().map(to_json).collect();
        format!("{:#}\n", Value::Array(rows))
    } else {
        found.iter().map(|found| line(path, found)).collect()
    };
    files::print(&shown)?;
    let errors = found.iter().any(|found| found.severity == Severity::Error);
    Ok(u8::from(errors))
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

fn line(path: &Path, found: &Diagnostic) -> String {
    format!(
        "{}:{}:{}: {}: {}: {}\n",
        path.display(),
        u64::from(found.line) + 1,
        u64::from(found.span.start) + 1,
        severity(found.severity),
        found.message,
        found.cause
    )
}

/// Lines and columns count from 1; the end is behind the last column.
fn to_json(found: &Diagnostic) -> Value {
    json!({
        "line": u64::from(found.line) + 1,
        "column": u64::from(found.span.start) + 1,
        "end_column": u64::from(found.span.end) + 1,
        "severity": severity(found.severity),
        "message": found.message,
        "cause": found.cause,
        "cure": found.cure.as_ref().map(|cure| json!({
            "label": cure.label,
            "column": u64::from(cure.span.start) + 1,
            "end_column": u64::from(cure.span.end) + 1,
            "replacement": cure.replacement,
        })),
    })
}
