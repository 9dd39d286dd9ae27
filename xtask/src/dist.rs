//! `cargo xtask dist`: the site as it is published.

use std::io::Write;
use std::path::Path;

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::report::Report;
use crate::setup::Need::{Bindgen, Libraries, Node, Rust, Trunk};
use crate::{Result, offline, shell};

/// What a first visit may load, compressed, in bytes.
const LIMIT: usize = 1_200_000;

/// Builds the site, says where it is, and what each file of it takes to load.
pub(crate) fn run() -> Result<()> {
    let mut report = Report::default();
    for need in [Rust, Libraries, Bindgen, Trunk, Node] {
        if !need.provide(&mut report) {
            return report.expect_passed();
        }
    }
    report.step("site", "built as it is published", build);
    report.expect_passed()?;
    println!(
        "\nThe site is in {}: put it on any server, in any folder.",
        shell::site().display()
    );
    Ok(())
}

/// Builds the site, and fails if a first visit would load too much.
pub(crate) fn build() -> Result<()> {
    shell::run(shell::command(
        "trunk",
        &["build", "--release", "--offline"],
    ))?;
    let sizes = compressed(&shell::site())?;
    println!("\n{:>10}  compressed", "bytes");
    for (name, size) in &sizes {
        println!("{size:>10}  {name}");
    }
    // All is loaded: what the page does not ask for, the service worker keeps.
    let total: usize = sizes.iter().map(|(_, size)| size).sum();
    println!("{total:>10}  in all, of {LIMIT}");
    if total > LIMIT {
        return Err(format!(
            "a first visit loads {total} bytes; the limit is {LIMIT}"
        ));
    }
    Ok(())
}

/// The files of a site, each with its size as servers send it.
fn compressed(folder: &Path) -> Result<Vec<(String, usize)>> {
    let sized = |name: String| {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        let contents = offline::read(&folder.join(&name))?;
        let packed = encoder.write_all(&contents).and_then(|()| encoder.finish());
        let packed = packed.map_err(|error| format!("{name}: {error}"))?;
        Ok((name, packed.len()))
    };
    offline::files(folder)?.into_iter().map(sized).collect()
}
