//! `motionbench scenario`

use std::path::{Component, Path, PathBuf};

use motionbench_core::scenario::{Outcome, Report, Scenario, program_text};

use crate::{UNUSABLE, files};

/// Runs scenarios; the worst of them decides the exit code.
pub(crate) fn run(paths: &[PathBuf]) -> Result<u8, String> {
    let mut worst = 0;
    for path in paths {
        worst = worst.max(match run_one(path) {
            Ok(report) => say(path, &report)?,
            Err(message) => {
                eprintln!("{message}");
                UNUSABLE
            }
        });
    }
    Ok(worst)
}

fn run_one(path: &Path) -> Result<Report, String> {
    let text = program_text(&files::read(path)?);
    let scenario = Scenario::parse(&text)
        .map_err(|problem| format!("{}:{}: {}", path.display(), problem.line, problem.message))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let report = scenario.run(&mut |name| files::read(&folder.join(name)));
    for (name, bytes) in &report.files {
        if !stays_inside(name) {
            return Err(format!(
                "{}: \"{name}\" is not in the scenario's folder",
                path.display()
            ));
        }
        files::write(&folder.join(name), bytes)?;
    }
    Ok(report)
}

/// A scenario may come from a stranger: it writes nothing outside its folder.
fn stays_inside(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    parts.all(|part| matches!(part, Component::Normal(_)))
}

fn say(path: &Path, report: &Report) -> Result<u8, String> {
    let path = path.display();
    let at = format!("{path}:{}: {}", report.line, report.message);
    match report.outcome {
        Outcome::Held => files::print(&format!("ok {path}\n")).map(|()| 0),
        Outcome::KnownFailure => {
            eprintln!("{at}");
            files::print(&format!("ok {path}\n")).map(|()| 0)
        }
        Outcome::Failed => files::print(&format!("{at}\n")).map(|()| 1),
        Outcome::Unusable => Err(at),
    }
}
