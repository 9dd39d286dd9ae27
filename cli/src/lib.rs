//! The headless runner, and the measurements that it shares with the browser's tests.
//!
//! `arguments` says what can be given; each command is a module of its own.

pub mod speed;

#[cfg(not(target_family = "wasm"))]
mod arguments;
#[cfg(not(target_family = "wasm"))]
mod check;
#[cfg(not(target_family = "wasm"))]
mod files;
#[cfg(not(target_family = "wasm"))]
mod keywords;
#[cfg(not(target_family = "wasm"))]
mod run;
#[cfg(not(target_family = "wasm"))]
mod scenario;

/// Does what the command line says.
#[cfg(not(target_family = "wasm"))]
pub fn main() -> std::process::ExitCode {
    use clap::Parser;

    // Bad arguments end here: clap says so and exits with 2.
    let arguments = arguments::Arguments::parse();
    match command(arguments.command) {
        Ok(code) => std::process::ExitCode::from(code),
        Err(message) => {
            eprintln!("{message}");
            std::process::ExitCode::from(UNUSABLE)
        }
    }
}

/// Exit code for arguments and files that cannot be used.
#[cfg(not(target_family = "wasm"))]
const UNUSABLE: u8 = 2;

#[cfg(not(target_family = "wasm"))]
fn command(command: arguments::Command) -> Result<u8, String> {
    use arguments::Command;

    match command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Scenario { files } => scenario::run(&files),
        Command::Check {
            controller,
            program,
            json,
        } => check::run(controller, &program, json),
        Command::Keywords { controller, json } => keywords::run(controller, json),
        Command::Speed { name } => {
            let start = std::time::Instant::now();
            let now = || start.elapsed().as_nanos() as f64;
            let report = speed::report(name.as_deref(), &now);
            files::print(&format!("{report:#}\n")).map(|()| 0)
        }
    }
}
