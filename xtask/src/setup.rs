//! What the checks and the page need beside Rust. Each is left alone if it is there already
//! in the right version.

use std::path::{Path, PathBuf};

use crate::report::Report;
use crate::{Result, browser, shell};

/// The version of wasm-bindgen in the top-level Cargo.toml; its tools must be equal.
const WASM_BINDGEN: &str = "0.2.129";
/// The last version of Trunk that the pinned Rust builds.
const TRUNK: &str = "0.21.14";

/// Something to be set up.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    /// rustfmt, clippy and the standard library for the browser.
    Rust,
    /// The sources of the libraries.
    Libraries,
    /// wasm-bindgen's command-line tools.
    Bindgen,
    /// The builder of the page.
    Trunk,
    /// Node and the packages of package.json.
    Node,
    /// A Chromium with a driver of its version.
    Browser,
}

impl Need {
    /// The name of the step.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::Libraries => "libraries",
            Self::Bindgen => "bindgen",
            Self::Trunk => "trunk",
            Self::Node => "node",
            Self::Browser => "browser",
        }
    }

    /// Sets it up as a step of `report`; returns whether it is there now.
    pub(crate) fn provide(self, report: &mut Report) -> bool {
        let (what, run): (&str, fn() -> Result<()>) = match self {
            Self::Rust => ("rustfmt, clippy and the wasm32 target of rustup", rust),
            Self::Libraries => ("the sources that Cargo.lock names", libraries),
            Self::Bindgen => (
                "the wasm-bindgen tools in target/tools (2 minutes the first time)",
                bindgen,
            ),
            Self::Trunk => ("Trunk in target/tools (3 minutes the first time)", trunk),
            Self::Node => ("the packages of package-lock.json in node_modules", node),
            Self::Browser => ("a Chromium or Chrome and its driver", browser::provide),
        };
        report.step(self.name(), what, run)
    }
}

fn rust() -> Result<()> {
    let sysroot = shell::capture(shell::command("rustc", &["--print", "sysroot"]))?;
    let target = Path::new(sysroot.trim()).join("lib/rustlib/wasm32-unknown-unknown");
    if !target.exists() {
        shell::run(shell::command(
            "rustup",
            &["target", "add", "wasm32-unknown-unknown"],
        ))?;
    }
    for (component, program) in [("rustfmt", "cargo-fmt"), ("clippy", "cargo-clippy")] {
        if shell::probe(program, &["--version"]).is_none() {
            shell::run(shell::command("rustup", &["component", "add", component]))?;
        }
    }
    println!(
        "  {}",
        shell::probe("rustc", &["--version"]).unwrap_or_default()
    );
    Ok(())
}

fn libraries() -> Result<()> {
    let version = shell::capture(shell::command("rustc", &["-vV"]))?;
    let host = version
        .lines()
        .find_map(|line| line.strip_prefix("host: "))
        .ok_or("rustc does not say which host it is for")?;
    let targets = ["--target", "wasm32-unknown-unknown", "--target", host];
    shell::run(shell::cargo(
        &[&["fetch", "--locked"][..], &targets].concat(),
    ))
}

fn bindgen() -> Result<()> {
    let wanted = format!(" {WASM_BINDGEN}");
    let there = ["wasm-bindgen", "wasm-bindgen-test-runner"]
        .iter()
        .all(|tool| version_of(tool).is_some_and(|version| version.ends_with(&wanted)));
    if there {
        println!("  wasm-bindgen {WASM_BINDGEN} is there");
        return Ok(());
    }
    cargo_install(&["--path", "tools/wasm-bindgen"], &[])
}

fn trunk() -> Result<()> {
    if version_of("trunk").is_some_and(|version| version == format!("trunk {TRUNK}")) {
        println!("  trunk {TRUNK} is there");
        return Ok(());
    }
    // Its default features are an update check and TLS; the page is served on loopback. It only
    // directs other programs: optimising it takes 5 minutes and gains nothing.
    cargo_install(
        &["trunk", "--version", TRUNK, "--no-default-features"],
        &[("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0")],
    )
}

fn version_of(tool: &str) -> Option<String> {
    shell::probe(shell::tools().join("bin").join(tool), &["--version"])
}

fn cargo_install(what: &[&str], settings: &[(&str, &str)]) -> Result<()> {
    let options = ["install", "--locked", "--force", "--root", "target/tools"];
    let mut command = shell::cargo(&[&options[..], what].concat());
    // A folder of its own: the project's builds neither wait for it nor are invalidated.
    command.env("CARGO_TARGET_DIR", shell::tools().join("build"));
    command.envs(settings.iter().copied());
    shell::run(command)
}

fn node() -> Result<()> {
    let node = shell::probe("node", &["--version"])
        .ok_or("Node 20 or later is needed: install it and run this again")?;
    let major = node.trim_start_matches('v').split('.').next();
    if major.and_then(|major| major.parse().ok()).unwrap_or(0) < 20 {
        return Err(format!("Node 20 or later is needed; this is {node}"));
    }
    let lock = read(shell::root().join("package-lock.json"))?;
    let stamp = shell::root().join("node_modules/.installed-lock.json");
    if read(stamp.clone()).is_ok_and(|installed| installed == lock) {
        println!("  node {node}, packages are there");
        return Ok(());
    }
    shell::run(shell::command("npm", &["ci"]))?;
    std::fs::write(&stamp, lock).map_err(|error| format!("{}: {error}", stamp.display()))
}

fn read(path: PathBuf) -> Result<String> {
    std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tools_have_the_version_of_the_library() {
        let library = read(shell::root().join("Cargo.toml")).unwrap();
        assert!(library.contains(&format!("wasm-bindgen = \"={WASM_BINDGEN}\"")));
        let tools = read(shell::root().join("tools/wasm-bindgen/Cargo.toml")).unwrap();
        assert!(tools.contains(&format!("\nversion = \"{WASM_BINDGEN}\"")));
        assert!(tools.contains(&format!("\"={WASM_BINDGEN}\"")));
    }
}
