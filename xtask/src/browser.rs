//! The browser of the tests: an installed Chromium or Chrome with a driver of its major
//! version, or Debian's packages.

use std::path::{Path, PathBuf};

use serde_json::json;

use crate::{Result, shell};

/// A browser and the driver that fits it.
pub(crate) struct Browser {
    /// The program of the browser.
    pub(crate) program: PathBuf,
    /// The program of its driver.
    pub(crate) driver: PathBuf,
    version: String,
}

/// Finds a browser, or installs one where that is Debian's to do, and writes
/// `target/webdriver.json` for the test runner.
pub(crate) fn provide() -> Result<()> {
    let browser = match find() {
        Some(browser) => browser,
        None => {
            install()?;
            find().ok_or_else(|| format!("still no browser with its driver.\n{}", advice()))?
        }
    };
    println!("  {} at {}", browser.version, browser.program.display());
    println!("  its driver at {}", browser.driver.display());
    let settings = json!({
        "goog:chromeOptions": { "binary": browser.program, "args": arguments() }
    });
    let path = shell::root().join("target/webdriver.json");
    std::fs::write(&path, format!("{settings:#}\n"))
        .map_err(|error| format!("{}: {error}", path.display()))
}

/// The arguments for a browser that talks to nobody but this machine.
pub(crate) fn arguments() -> Vec<&'static str> {
    let mut arguments = vec![
        "--headless",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
    ];
    if shell::is_root() {
        // Chromium's sandbox refuses to start for root.
        arguments.push("--no-sandbox");
    }
    arguments
}

/// The first browser that has a driver of its major version.
pub(crate) fn find() -> Option<Browser> {
    let drivers: Vec<(u32, PathBuf)> = candidates("CHROMEDRIVER", &DRIVERS)
        .into_iter()
        .filter_map(|path| Some((major(&shell::probe(&path, &["--version"])?)?, path)))
        .collect();
    candidates("CHROME", &BROWSERS)
        .into_iter()
        .find_map(|program| {
            let version = shell::probe(&program, &["--version"])?;
            let (_, driver) = drivers
                .iter()
                .find(|(driver, _)| Some(*driver) == major(&version))?;
            Some(Browser {
                program,
                driver: driver.clone(),
                version,
            })
        })
}

const BROWSERS: [&str; 7] = [
    "chromium",
    "google-chrome",
    "google-chrome-stable",
    "chromium-browser",
    "chrome",
    "/opt/google/chrome/chrome",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
];
const DRIVERS: [&str; 3] = [
    "chromedriver",
    "/usr/lib/chromium/chromedriver",
    "/usr/lib/chromium-browser/chromedriver",
];

/// The programs there are: what the environment variable names, what was put in
/// `target/browser`, then `names` on PATH or as they stand.
fn candidates(variable: &str, names: &[&str]) -> Vec<PathBuf> {
    let named = std::env::var_os(variable).map(PathBuf::from);
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    let known = names.iter().flat_map(|name| {
        // Joining an absolute name gives that name.
        let found = folders.iter().map(move |folder| folder.join(name));
        found.collect::<Vec<_>>()
    });
    let mut all: Vec<PathBuf> = named
        .into_iter()
        .chain(fetched(names))
        .chain(known)
        .filter(|path| path.is_file() && !is_snap(path))
        .collect();
    all.dedup();
    all
}

/// What `advice` made the user fetch: `target/browser/KIND/VERSION/FOLDER/PROGRAM`.
fn fetched(names: &[&str]) -> Vec<PathBuf> {
    let below = |folders: Vec<PathBuf>| -> Vec<PathBuf> {
        let entries = folders.iter().filter_map(|folder| folder.read_dir().ok());
        entries
            .flatten()
            .flatten()
            .map(|entry| entry.path())
            .collect()
    };
    let folders = below(below(below(vec![shell::root().join("target/browser")])));
    folders
        .iter()
        .flat_map(|folder| names.iter().map(|name| folder.join(name)))
        .collect()
}

/// Ubuntu's package is a stub that starts a snap, which sees neither our files nor a driver.
fn is_snap(path: &Path) -> bool {
    let real = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let stub = || std::fs::read_to_string(&real).is_ok_and(|text| text.contains("/snap/bin"));
    path.starts_with("/snap") || real.ends_with("snap") || real.starts_with("/snap") || stub()
}

/// The first number of `Chromium 156.0.8078.79 built on Debian`.
fn major(version: &str) -> Option<u32> {
    let mut numbers = version.split(|c: char| !c.is_ascii_digit());
    numbers.find(|number| !number.is_empty())?.parse().ok()
}

fn install() -> Result<()> {
    if !(is_debian() && shell::is_root()) {
        return Err(format!(
            "no browser with a driver of its version.\n{}",
            advice()
        ));
    }
    println!("  none with a driver of its version: installing Debian's");
    shell::run(apt(&["update"]))?;
    shell::run(apt(&[
        "install",
        "--yes",
        "--no-install-recommends",
        "chromium",
        "chromium-driver",
    ]))
}

fn apt(arguments: &[&str]) -> std::process::Command {
    let mut command = shell::command("apt-get", arguments);
    command.env("DEBIAN_FRONTEND", "noninteractive");
    command
}

fn is_debian() -> bool {
    std::fs::read_to_string("/etc/os-release")
        .is_ok_and(|text| text.lines().any(|line| line == "ID=debian"))
}

/// The commands that bring a browser to this machine.
fn advice() -> String {
    if is_debian() {
        return "Give this command, then run this again:\n\
                \n  sudo apt-get install chromium chromium-driver"
            .to_owned();
    }
    "Give these commands, then run this again:\n\
     \n  npx --yes @puppeteer/browsers install chrome@stable --path target/browser\
     \n  npx --yes @puppeteer/browsers install chromedriver@stable --path target/browser\n\
     \nor name an installed pair in the environment variables CHROME and CHROMEDRIVER."
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::major;

    #[test]
    fn versions_of_browsers_and_drivers() {
        assert_eq!(
            major("Chromium 156.0.8078.79 built on Debian 12"),
            Some(156)
        );
        assert_eq!(major("Google Chrome 140.0.7339.80 "), Some(140));
        assert_eq!(major("ChromeDriver 156.0.8078.79 (abc)"), Some(156));
        assert_eq!(major("needs the snap"), None);
    }
}
