//! `cargo xtask test`: every check, on a machine with rustup, Node and a C compiler.

use std::path::PathBuf;

use crate::report::Report;
use crate::setup::Need::{self, Bindgen, Browser, Libraries, Node, Rust, Trunk};
use crate::{Result, browser, dist, regen, shell};

/// One check.
struct Check {
    name: &'static str,
    what: &'static str,
    needs: &'static [Need],
    run: fn() -> Result<()>,
}

const CHECKS: [Check; 8] = [
    Check {
        name: "format",
        what: "the sources are formatted",
        needs: &[Rust],
        run: format,
    },
    Check {
        name: "clippy",
        what: "no lint of the compiler or clippy, native and wasm",
        needs: &[Rust, Libraries],
        run: clippy,
    },
    Check {
        name: "docs",
        what: "the documentation of the simulator has no broken link",
        needs: &[Rust, Libraries],
        run: docs,
    },
    Check {
        name: "native",
        what: "unit tests, conformance scenarios, properties, seeds of the fuzzers",
        needs: &[Rust, Libraries],
        run: native,
    },
    Check {
        name: "generated",
        what: "the generated files are those that `cargo xtask regen` writes",
        needs: &[Rust, Libraries],
        run: regen::run,
    },
    Check {
        name: "wasm",
        what: "the same scenarios, and parts of the page, in a headless browser",
        needs: &[Rust, Libraries, Bindgen, Browser],
        run: wasm,
    },
    Check {
        name: "site",
        what: "the page is built as it is published, and is small enough",
        needs: &[Rust, Libraries, Bindgen, Trunk, Node],
        run: dist::build,
    },
    Check {
        name: "e2e",
        what: "the built site in a headless browser",
        needs: &[Node, Browser],
        run: end_to_end,
    },
];

/// Runs the checks named, or all, after setting up what they need. All are tried, whatever
/// fails, but those that stand on something that failed.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    if arguments.contains(&"--list") {
        for check in &CHECKS {
            println!("{:<10} {}", check.name, check.what);
        }
        return Ok(());
    }
    if let Some(unknown) = arguments
        .iter()
        .find(|name| CHECKS.iter().all(|check| check.name != **name))
    {
        return Err(format!(
            "no such step: {unknown}; `cargo xtask test --list` names them"
        ));
    }
    let chosen = || {
        CHECKS
            .iter()
            .filter(|check| arguments.is_empty() || arguments.contains(&check.name))
    };
    let mut report = Report::default();
    let mut missing = Vec::new();
    for need in [Rust, Libraries, Node, Browser, Bindgen, Trunk] {
        let needed = chosen().any(|check| check.needs.contains(&need));
        if needed && !need.provide(&mut report) {
            missing.push(need);
        }
    }
    for check in chosen() {
        match check.needs.iter().find(|need| missing.contains(need)) {
            Some(need) => report.skip(check.name, format!("it needs {}", need.name())),
            None => {
                report.step(check.name, check.what, check.run);
            }
        }
    }
    report.finish()
}

fn format() -> Result<()> {
    shell::run(shell::cargo(&["fmt", "--all", "--check"]))
}

fn clippy() -> Result<()> {
    let deny = ["--", "-D", "warnings"];
    let native = ["clippy", "--locked", "--all-targets"];
    shell::run(shell::cargo(&[&native[..], &deny].concat()))?;
    let wasm = [
        "clippy",
        "--locked",
        "--all-targets",
        "--target",
        "wasm32-unknown-unknown",
        "-p",
        "motionbench-app",
        "-p",
        "motionbench-tests",
    ];
    shell::run(shell::cargo(&[&wasm[..], &deny].concat()))
}

fn docs() -> Result<()> {
    let options = ["doc", "--locked", "--no-deps", "-p", "motionbench-core"];
    let mut command = shell::cargo(&options);
    command.env("RUSTDOCFLAGS", "-D warnings");
    shell::run(command)
}

fn native() -> Result<()> {
    shell::run(shell::cargo(&["test", "--locked", "--no-fail-fast"]))?;
    // The page's state and update functions need no browser.
    shell::run(shell::cargo(&[
        "test",
        "--locked",
        "-p",
        "motionbench-app",
        "--lib",
    ]))
}

fn wasm() -> Result<()> {
    let driver = found_browser()?.driver;
    let test = |package: &[&str]| {
        let target = ["--target", "wasm32-unknown-unknown"];
        let common = ["test", "--locked", "--no-fail-fast"];
        let mut command = shell::cargo(&[&common[..], &target, package].concat());
        command.env("CHROMEDRIVER", &driver);
        shell::run(command)
    };
    test(&["-p", "motionbench-tests"])?;
    test(&["-p", "motionbench-app", "--lib", "--test", "*"])
}

fn end_to_end() -> Result<()> {
    let folder = shell::root().join("tests/e2e");
    let entries = folder
        .read_dir()
        .map_err(|error| format!("tests/e2e: {error}"))?;
    let mut tests: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.to_string_lossy().ends_with(".test.mjs"))
        .collect();
    tests.sort();
    if !shell::site().join("index.html").is_file() {
        return Err("there is no site in target/site: run the step site first".to_owned());
    }
    // One after the other: a test measures what the page takes of the machine.
    let options = ["--test", "--test-concurrency=1", "--test-reporter=spec"];
    let mut command = shell::command("node", &options);
    command
        .args(tests)
        .env("MOTIONBENCH_SITE", shell::site())
        .env("MOTIONBENCH_BROWSER", found_browser()?.program)
        .env(
            "MOTIONBENCH_BROWSER_ARGUMENTS",
            browser::arguments().join(" "),
        );
    shell::run(command)
}

fn found_browser() -> Result<browser::Browser> {
    browser::find().ok_or_else(|| "no browser with a driver of its version".to_owned())
}
