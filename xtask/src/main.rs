//! `cargo xtask`: the commands of the project. Each sets up what it needs, says what it does
//! and how long that took, and installs nothing outside `target/` and `node_modules/` but a
//! browser and the rustup target.

mod bench;
mod browser;
mod dist;
mod offline;
mod regen;
mod report;
mod serve;
mod setup;
mod shell;
mod test;

use std::process::ExitCode;

/// What went wrong, in one or a few lines for the person at the terminal.
type Result<T> = std::result::Result<T, String>;

const HELP: &str = "\
The commands of Motionbench.

  cargo xtask serve [--dev] [--port N]   build the page, serve it on this machine, rebuild on change
  cargo xtask test [--list] [STEP...]    every check, or the steps named
  cargo xtask dist                       build the site as it is published
  cargo xtask bench [native|browser]     speed as ratios to the reference loop
  cargo xtask regen                      write the generated files again

Each sets up what it needs first; what is there already is left alone.
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments.as_slice() {
        ["serve", rest @ ..] => serve::run(rest),
        ["test", rest @ ..] => test::run(rest),
        ["dist"] => dist::run(),
        ["bench", rest @ ..] => bench::run(rest),
        ["regen"] => regen::run(),
        // For Trunk alone.
        ["service-worker"] => offline::run(),
        [] | ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        other => {
            eprintln!("no such command: {}\n\n{HELP}", other.join(" "));
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            if !message.is_empty() {
                eprintln!("{message}");
            }
            ExitCode::FAILURE
        }
    }
}
