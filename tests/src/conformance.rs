//! The scenarios in `conformance/`, built in.

use motionbench_core::scenario::{Report, Scenario, program_text};

/// Every file in `conformance/`, by its name there.
pub static FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/files.rs"));

/// A file in `conformance/`.
pub fn file(name: &str) -> Option<&'static [u8]> {
    let found = FILES.iter().find(|(other, _)| *other == name);
    found.map(|(_, bytes)| *bytes)
}

/// The scenarios, by their names in `conformance/`.
pub fn scenarios() -> impl Iterator<Item = &'static str> {
    let names = FILES.iter().map(|(name, _)| *name);
    names.filter(|name| name.ends_with(".scenario"))
}

/// A scenario's text.
///
/// # Panics
/// If there is no such scenario.
pub fn text(name: &str) -> String {
    program_text(file(name).unwrap_or_else(|| panic!("there is no {name}")))
}

/// Runs a scenario.
///
/// # Panics
/// If it cannot be read.
pub fn run(name: &str) -> Report {
    run_text(name, &text(name))
}

/// Runs another text in place of a scenario's.
///
/// # Panics
/// If it is no scenario.
pub fn run_text(name: &str, text: &str) -> Report {
    let scenario = Scenario::parse(text)
        .unwrap_or_else(|problem| panic!("{name}:{}: {}", problem.line, problem.message));
    scenario.run(&mut |file_name| {
        let path = beside(name, file_name);
        file(&path)
            .map(<[u8]>::to_vec)
            .ok_or_else(|| format!("there is no {path}"))
    })
}

/// The name of a file that a scenario mentions.
pub fn beside(name: &str, file_name: &str) -> String {
    let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
    format!("{folder}/{file_name}")
}

/// Runs a scenario, which must hold, and do what it did elsewhere: see [`Report::digest`].
///
/// # Panics
/// If it does not.
pub fn holds(name: &str, elsewhere: Option<u64>) {
    let report = run(name);
    assert!(report.is_ok(), "{name}:{}: {}", report.line, report.message);
    if let Some(digest) = elsewhere {
        assert_eq!(
            report.digest, digest,
            "{name} does not do the same here, to the bit, as natively"
        );
    }
}
