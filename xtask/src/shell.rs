//! Running other programs, and where things lie.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Result;

/// The top of the checkout.
pub(crate) fn root() -> &'static Path {
    // This manifest lies one folder below.
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .unwrap_or(Path::new("."))
}

/// Where the tools are installed; it lies first on PATH for everything started here.
pub(crate) fn tools() -> PathBuf {
    root().join("target/tools")
}

/// The built site.
pub(crate) fn site() -> PathBuf {
    root().join("target/site")
}

/// A program with its arguments, to be started at the top of the checkout.
pub(crate) fn command(program: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root());
    command.env("PATH", path());
    command
}

/// The `cargo` that started this program.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let program = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    command(&program, arguments)
}

/// Runs a program to its end, its output on the terminal. A failure names the command.
pub(crate) fn run(mut command: Command) -> Result<()> {
    println!("  $ {}", line(&command));
    let status = command
        .status()
        .map_err(|error| format!("{}: {error}", line(&command)))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("`{}` failed: {status}", line(&command)))
    }
}

/// Runs a program to its end and returns what it wrote to standard output; what it wrote to
/// standard error stays on the terminal.
pub(crate) fn capture(mut command: Command) -> Result<String> {
    let output = command
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("{}: {error}", line(&command)))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        Ok(text)
    } else {
        Err(format!(
            "{text}`{}` failed: {}",
            line(&command),
            output.status
        ))
    }
}

/// What a program writes, or `None` if it is missing or fails; nothing on the terminal.
pub(crate) fn probe(program: impl AsRef<Path>, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program.as_ref())
        .args(arguments)
        .env("PATH", path())
        .stdin(Stdio::null())
        .output()
        .ok()?;
    output
        .status
        .success()
        .then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Whether this process may install packages of the system.
pub(crate) fn is_root() -> bool {
    probe("id", &["-u"]).is_some_and(|user| user == "0")
}

fn path() -> OsString {
    let inherited = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(tools().join("bin")).chain(std::env::split_paths(&inherited));
    // A folder with a colon in its name cannot be on PATH: then only what was inherited is.
    std::env::join_paths(folders).unwrap_or(inherited)
}

fn line(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let program = program.file_name().unwrap_or(program.as_os_str());
    std::iter::once(program)
        .chain(command.get_args())
        .map(|word| word.to_string_lossy())
        .collect::<Vec<_>>()
        .join(" ")
}
