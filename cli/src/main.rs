//! `motionbench`: the simulator without a browser.

use std::process::ExitCode;

fn main() -> ExitCode {
    motionbench::main()
}
