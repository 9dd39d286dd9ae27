//! `motionbench run`

mod input;
mod plot;
mod session;
mod table;

use std::path::Path;

use motionbench_core::scenario::program_text;

use crate::arguments::RunArguments;
use crate::files;
use input::Source;
use session::{Ended, Session};

/// Exit code for a run that did not come to an end.
const UNENDED: u8 = 1;
/// Exit code for a program that ended with an error.
const PROGRAM_ERROR: u8 = 3;

/// Runs a controller as the arguments say.
pub(crate) fn run(arguments: &RunArguments) -> Result<u8, String> {
    let record = arguments.csv.is_some() || arguments.plot.is_some();
    let mut session = Session::new(arguments, record)?;
    session.power_on()?;
    if let Some(program) = &arguments.program {
        load(&mut session, program)?;
    }
    for line in &arguments.typed {
        session.type_line(line)?;
    }
    let batch = !arguments.typed.is_empty();
    let source = if batch {
        Source::Nothing
    } else {
        Source::standard_input()?
    };
    let ended = session.run(source, arguments.program.is_none() && !batch)?;
    if record && let Some(first) = session.lost() {
        eprintln!("the record is full: it starts at {} s", first.seconds());
    }
    if let Some(path) = &arguments.csv {
        files::write(path, table::csv(session.info(), session.trace()).as_bytes())?;
    }
    if let Some(path) = &arguments.plot {
        let title = match &arguments.program {
            Some(program) => format!("{}: {}", session.info().name, program.display()),
            None => session.info().name.to_owned(),
        };
        let svg = plot::svg(session.info(), session.trace(), &title)
            .map_err(|why| format!("{}: {why}", path.display()))?;
        files::write(path, svg.as_bytes())?;
    }
    if arguments.json {
        files::print(&format!("{:#}\n", session.state(ended)))?;
    }
    Ok(session.code(ended))
}

fn load(session: &mut Session, path: &Path) -> Result<(), String> {
    let text = program_text(&files::read(path)?);
    session.load(&text).map_err(|error| {
        let line = u64::from(error.line) + 1;
        format!("{}:{line}: {}", path.display(), error.message)
    })?;
    let start = session.info().start.clone();
    session.type_line(&start)
}

/// What is said on standard error about a run's end that may surprise.
fn note(ended: Ended, busy: Option<String>) -> Option<String> {
    let busy = busy.unwrap_or_default();
    match ended {
        Ended::Idle | Ended::Left | Ended::TimeGiven => None,
        Ended::TimeOut => Some(format!(
            "stopped after ten minutes of simulated time: {busy}; --for sets another time"
        )),
        Ended::NoInput => Some(format!("stopped: {busy}, and there is none")),
    }
}

fn exit_code(ended: Ended, error: bool) -> u8 {
    match ended {
        _ if error => PROGRAM_ERROR,
        Ended::Idle | Ended::Left | Ended::TimeGiven => 0,
        Ended::TimeOut | Ended::NoInput => UNENDED,
    }
}
