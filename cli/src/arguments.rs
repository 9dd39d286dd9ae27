//! What can be given on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use motionbench_core::catalog::{self, Kind};
use motionbench_core::scenario::duration;
use motionbench_core::time::Nanos;

const EXAMPLES: &str = "\
Examples:
  motionbench run mc600 move.bas --plot move.svg   run a program and draw what the axis did
  motionbench run mc600 --type 'PRINT SQR(5)'      type a line at the controller's console
  motionbench run mc600                            sit down at the console (Ctrl-D leaves)
  motionbench scenario tests/*.scenario            run scenarios; exit code 0 if everything held
  motionbench check mc600 move.bas                 say what is wrong with a program

Exit codes: 0 all is well; 1 something did not hold or was found; 2 the arguments or files cannot
be used; 3 the controller's program ended with an error.";

/// Classic motion controllers, simulated: programs, scenarios and measurements without a browser.
///
/// Time is simulated and passes as fast as this machine allows; the results do not depend on it.
#[derive(Debug, Parser)]
#[command(name = "motionbench", version, after_help = with_controllers(EXAMPLES))]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Run(RunArguments),
    /// Run scenarios and say whether everything held
    ///
    /// Prints `ok FILE` or `FILE:LINE: message` for each. The language is described in docs/scenario.md.
    #[command(after_help = SCENARIO_EXAMPLE)]
    Scenario {
        /// Scenarios; the files that they mention are relative to them
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
    },
    /// Say what is wrong with a program, from its text alone
    ///
    /// Prints `FILE:LINE:COLUMN: error: message` for each finding.
    #[command(after_help = "Exit codes: 0 no error found; 1 some; 2 the file cannot be read.")]
    Check {
        /// The kind of controller
        #[arg(value_parser = kind)]
        controller: &'static Kind,
        /// A program in its language
        program: PathBuf,
        /// Print the findings as JSON
        #[arg(long)]
        json: bool,
    },
    /// List the words of a controller's language
    ///
    /// Word, kind, syntax, what it does, section of the manual, and how far it is supported.
    Keywords {
        /// The kind of controller
        #[arg(value_parser = kind)]
        controller: &'static Kind,
        /// Print the table as JSON
        #[arg(long)]
        json: bool,
    },
    /// Measure how fast the simulator is on this machine, as JSON
    ///
    /// Nanoseconds per innermost pass of programs, and per axis and sample of motion, beside a reference loop that tells
    /// how fast the machine is.
    Speed {
        /// Measure only what has this in its name: `mc600/1`, `32x2kHz`
        name: Option<String>,
    },
}

const SCENARIO_EXAMPLE: &str = "\
Example of a scenario:
  bench mc600
  power on
  type PRINT 6*7
  reply \" 42 \"

Exit codes: 0 everything held; 1 something did not; 2 a file is missing or is no scenario.";

/// Run a controller: its program, or its console
///
/// Without --json, prints what the console sends, byte for byte. The run ends when the program has ended and the axes
/// stand still, after --for, or after ten minutes of simulated time.
///
/// Without --type, standard input is the console: a terminal key by key (Ctrl-C goes to the controller, Ctrl-D leaves), a
/// pipe line by line, whenever the controller waits for one.
#[derive(Debug, Args)]
#[command(after_help = with_controllers(RUN_EXAMPLES))]
pub(crate) struct RunArguments {
    /// The kind of controller
    #[arg(value_parser = kind)]
    pub(crate) controller: &'static Kind,
    /// A program in its language: loaded and started; without it there is only the console
    pub(crate) program: Option<PathBuf>,
    /// A line typed at the console after the start; give it again for more lines
    #[arg(long = "type", value_name = "TEXT", allow_hyphen_values = true)]
    pub(crate) typed: Vec<String>,
    /// Stop after this simulated time: 10s, 500ms, 2min
    #[arg(long = "for", value_name = "TIME", value_parser = duration)]
    pub(crate) time: Option<Nanos>,
    /// An option of the controller, as on a scenario's `bench` line; give it again for more
    #[arg(long = "option", value_name = "KEY=VALUE", value_parser = option)]
    pub(crate) options: Vec<(String, String)>,
    /// Write the recorded signals as comma-separated values
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Draw demanded and actual position and velocity
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) plot: Option<PathBuf>,
    /// Print the final state as JSON instead of the console's bytes
    #[arg(long)]
    pub(crate) json: bool,
    /// Let simulated time pass no faster than real time
    #[arg(long)]
    pub(crate) real_time: bool,
}

const RUN_EXAMPLES: &str = "\
Examples:
  motionbench run mc600 move.bas
  motionbench run mc600 move.bas --csv move.csv --plot move.svg
  motionbench run mc600 ask.bas --type 5 --type 7        answers two INPUTs
  motionbench run mc600 --type 'MDRVEN()' --type 'MMOVE(40960)' --json
  printf 'A=5\\nPRINT A*A\\n' | motionbench run mc600
  motionbench run mc600 loop.bas --for 10s --option speed=fast

Exit codes: 0 the run ended; 1 it did not end within ten minutes of simulated time, or waits for input
that does not come; 2 the arguments or files cannot be used; 3 the program ended with an error.";

/// The controllers and their options, behind `text`.
fn with_controllers(text: &str) -> String {
    let mut text = format!(
        "{text}\n\nControllers, and what --option and a scenario's `bench` line can give them:"
    );
    for kind in catalog::KINDS {
        text.push_str(&format!("\n  {}  {}", kind.id, kind.name));
        for option in kind.options {
            text.push_str(&format!("\n    {}=  {}", option.key, option.help));
        }
    }
    text
}

fn kind(id: &str) -> Result<&'static Kind, String> {
    let known: Vec<&str> = catalog::KINDS.iter().map(|kind| kind.id).collect();
    catalog::kind(id).ok_or_else(|| format!("there are: {}", known.join(", ")))
}

fn option(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("write KEY=VALUE")?;
    Ok((key.to_owned(), value.to_owned()))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Arguments::command().debug_assert();
    }
}
