//! `cargo xtask bench`: what `motionbench speed` measures, native and in the browser.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::report::Report;
use crate::setup::Need;
use crate::{Result, browser, shell};

/// Measures where `arguments` says, or on both sides, and prints the figures side by side.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    let (native, in_browser) = match arguments {
        [] => (true, true),
        ["native"] => (true, false),
        ["browser"] => (false, true),
        _ => return Err("bench takes `native`, `browser` or nothing for both".to_owned()),
    };
    let mut report = Report::default();
    let mut sides = Vec::new();
    Need::Rust.provide(&mut report);
    Need::Libraries.provide(&mut report);
    if native {
        report.step("native", "measures the runner, built for speed", || {
            sides.push(("native", figures(&measure_native()?)?));
            Ok(())
        });
    }
    if in_browser {
        let ready = [Need::Bindgen, Need::Browser].map(|need| need.provide(&mut report));
        if ready == [true, true] {
            report.step("browser", "measures the same as the page is built", || {
                sides.push(("browser", figures(&measure_browser()?)?));
                Ok(())
            });
        }
    }
    report.expect_passed()?;
    print!("{}", table(&sides));
    Ok(())
}

fn measure_native() -> Result<String> {
    let arguments = ["run", "--release", "--locked", "-p", "motionbench"];
    shell::capture(shell::cargo(&[&arguments[..], &["--", "speed"]].concat()))
}

/// Marks the report in the output of the test that writes it, `tests/tests/speed.rs`.
const MARK: &str = "speed report: ";

fn measure_browser() -> Result<String> {
    let driver = browser::find()
        .ok_or("no browser with a driver of its version")?
        .driver;
    let mut command = shell::cargo(&[
        "test",
        "--profile",
        "web",
        "--locked",
        "-p",
        "motionbench-tests",
        "--target",
        "wasm32-unknown-unknown",
        "--test",
        "speed",
        "--",
        "--include-ignored",
        "--nocapture",
    ]);
    command.env("CHROMEDRIVER", driver);
    let output = shell::capture(command)?;
    output
        .lines()
        .find_map(|line| line.split_once(MARK))
        .map(|(_, report)| report.to_owned())
        .ok_or_else(|| format!("{output}\nno speed report in this output"))
}

/// What one side measured: name, nanoseconds, and the figure that counts in words.
type Figures = BTreeMap<String, (f64, String)>;

fn figures(json: &str) -> Result<Figures> {
    let report: Value = serde_json::from_str(json)
        .map_err(|error| format!("{json}\nthis speed report is not JSON: {error}"))?;
    let number = |value: &Value, key: &str| {
        let number = value.get(key).and_then(Value::as_f64);
        number.ok_or_else(|| format!("the speed report has no number {key}: {value}"))
    };
    let entries = |key: &str| {
        let entries = report.get(key).and_then(Value::as_object);
        entries.into_iter().flatten().collect::<Vec<_>>()
    };
    let reference = number(&report, "reference_ns")?;
    let mut figures = Figures::from([(
        "reference".to_owned(),
        (reference, "1.00 of reference".to_owned()),
    )]);
    for (name, entry) in entries("programs") {
        let ratio = format!("{:.2} of reference", number(entry, "ratio")?);
        figures.insert(format!("program {name}"), (number(entry, "ns")?, ratio));
    }
    for (name, entry) in entries("motion") {
        let ns = number(entry, "ns_per_axis_sample")?;
        let times = number(entry, "times_real_time")?;
        let words = format!("{:.2}, {times:.0} x real time", ns / reference);
        figures.insert(format!("motion {name}"), (ns, words));
    }
    Ok(figures)
}

/// The figures of each side in columns, the reference loop last.
fn table(sides: &[(&str, Figures)]) -> String {
    let mut text = format!("\n{:<24}", "");
    for (side, _) in sides {
        text += &format!("{side:<40}");
    }
    let mut names: Vec<&String> = sides
        .iter()
        .flat_map(|(_, figures)| figures.keys())
        .collect();
    names.sort();
    names.dedup();
    for name in names {
        text += &format!("\n{name:<24}");
        for (_, figures) in sides {
            text += &match figures.get(name) {
                Some((ns, words)) => format!("{:<40}", format!("{ns:8.2} ns  {words}")),
                None => format!("{:<40}", "-"),
            };
        }
    }
    text.lines()
        .map(|line| format!("{}\n", line.trim_end()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{figures, table};

    #[test]
    fn a_report_becomes_a_column() {
        let json = r#"{"machine": "x", "reference_ns": 4.0,
            "programs": {"mc600/1": {"ns": 8.0, "ratio": 2.0}},
            "motion": {"32x2kHz": {"ns_per_axis_sample": 20.0, "times_real_time": 781.2}}}"#;
        let table = table(&[("native", figures(json).unwrap())]);
        assert!(
            table.contains("program mc600/1             8.00 ns  2.00 of reference\n"),
            "{table}"
        );
        assert!(
            table.contains("motion 32x2kHz             20.00 ns  5.00, 781 x real time\n"),
            "{table}"
        );
        assert!(figures("{}").is_err());
    }
}
