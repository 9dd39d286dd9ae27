//! The last step of building the site: its service worker, and a name for this version. Trunk calls it when all other
//! files are there.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

use crate::{Result, shell};

/// Set while a site is built that is served for development.
pub(crate) const DEVELOPMENT: &str = "MOTIONBENCH_DEVELOPMENT";

/// The worker's files, which a page asks for long after it has started.
const WORKER: [&str; 3] = ["worker.js", "worker_bg.wasm", "worker_loader.js"];
/// Where the page learns its version; without one it uses no service worker.
const UNNAMED: &str = "data-version=\"development\"";

/// Finishes the site in the folder that Trunk names.
pub(crate) fn run() -> Result<()> {
    let folder = std::env::var_os("TRUNK_STAGING_DIR")
        .ok_or("Trunk calls this, with TRUNK_STAGING_DIR set; there is nothing to do by hand")?;
    let folder = PathBuf::from(folder);
    let sources = shell::root().join("app/service-worker");
    let release = std::env::var("TRUNK_PROFILE").is_ok_and(|profile| profile == "release");
    if release && std::env::var_os(DEVELOPMENT).is_none() {
        let script = read(&sources.join("service-worker.js"))?;
        publish(&folder, &String::from_utf8_lossy(&script))
    } else {
        let script = read(&sources.join("remove.js"))?;
        write(&folder.join("sw.js"), &script)
    }
}

/// Names the version after the contents of all files, puts the worker's into a folder of that name, and writes the
/// service worker with the list of what is to be kept.
fn publish(folder: &Path, script: &str) -> Result<()> {
    let mut hash = Sha256::new_with_prefix(script);
    for name in files(folder)? {
        let contents = read(&folder.join(&name))?;
        hash.update(format!("\n{name} {}\n", contents.len()));
        hash.update(contents);
    }
    let version: String = hash.finalize()[..8]
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    name_version(folder, &version)?;
    let mut list = BTreeMap::new();
    for name in files(folder)? {
        let digest = Sha256::digest(read(&folder.join(&name))?);
        // Servers may send the browser from index.html to its folder, but not the other way.
        let address = if name == "index.html" { "" } else { &name };
        list.insert(
            address.to_owned(),
            format!("sha256-{}", STANDARD.encode(digest)),
        );
    }
    let list = serde_json::to_string_pretty(&list).map_err(|error| error.to_string())?;
    let text = format!("const VERSION = \"{version}\";\nconst FILES = {list};\n\n{script}");
    write(&folder.join("sw.js"), text.as_bytes())
}

fn name_version(folder: &Path, version: &str) -> Result<()> {
    std::fs::create_dir(folder.join(version)).map_err(|error| format!("{version}: {error}"))?;
    for name in WORKER {
        std::fs::rename(folder.join(name), folder.join(version).join(name))
            .map_err(|error| format!("{name}: {error}"))?;
    }
    let index = folder.join("index.html");
    let page = String::from_utf8_lossy(&read(&index)?).into_owned();
    if page.matches(UNNAMED).count() != 1 {
        return Err(format!("index.html must have {UNNAMED} once"));
    }
    let named = page.replace(UNNAMED, &format!("data-version=\"{version}\""));
    write(&index, named.as_bytes())
}

/// All files below `folder`, by their addresses relative to it, in order.
pub(crate) fn files(folder: &Path) -> Result<Vec<String>> {
    let mut found = Vec::new();
    let mut open = vec![(folder.to_owned(), String::new())];
    while let Some((folder, prefix)) = open.pop() {
        let entries = folder
            .read_dir()
            .map_err(|error| format!("{}: {error}", folder.display()))?;
        for entry in entries {
            let entry = entry.map_err(|error| format!("{}: {error}", folder.display()))?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                open.push((entry.path(), format!("{name}/")));
            } else {
                found.push(name);
            }
        }
    }
    found.sort();
    Ok(found)
}

pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, contents: &[u8]) -> Result<()> {
    std::fs::write(path, contents).map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A site with these contents of the style sheet; returns the folder.
    fn built(name: &str, style: &str) -> PathBuf {
        let folder =
            std::env::temp_dir().join(format!("motionbench-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(folder.join("icons")).unwrap();
        write(
            &folder.join("index.html"),
            format!("<html {UNNAMED}>").as_bytes(),
        )
        .unwrap();
        write(&folder.join("style.css"), style.as_bytes()).unwrap();
        write(&folder.join("icons/icon.svg"), b"<svg/>").unwrap();
        for file in WORKER {
            write(&folder.join(file), file.as_bytes()).unwrap();
        }
        folder
    }

    fn published(name: &str, style: &str, script: &str) -> (Vec<String>, String, String) {
        let folder = built(name, style);
        publish(&folder, script).unwrap();
        let text = |name| String::from_utf8(read(&folder.join(name)).unwrap()).unwrap();
        let result = (files(&folder).unwrap(), text("index.html"), text("sw.js"));
        std::fs::remove_dir_all(&folder).unwrap();
        result
    }

    fn version(page: &str) -> &str {
        page.split('"').nth(1).unwrap()
    }

    #[test]
    fn a_published_site_names_its_version_and_lists_its_files() {
        let (files, page, worker) = published("whole", "a{}", "run();\n");
        let version = version(&page);
        assert_eq!(version.len(), 16);
        assert!(
            files.contains(&format!("{version}/worker_bg.wasm")),
            "{files:?}"
        );
        assert!(!files.contains(&"worker.js".to_owned()));
        assert!(worker.starts_with(&format!("const VERSION = \"{version}\";\n")));
        assert!(worker.ends_with("\nrun();\n"));
        // The digest of `a{}`, as a browser checks it.
        let style = "\"style.css\": \"sha256-X1RutGBrXCt9KkSaXMK7tHftWiRscFHOhxsS8tv8hBk=\"";
        for listed in [
            "\"\": \"sha256-",
            style,
            "\"icons/icon.svg\"",
            &format!("\"{version}/worker.js\""),
        ] {
            assert!(worker.contains(listed), "{listed} is missing:\n{worker}");
        }
        for absent in ["\"index.html\"", "\"sw.js\"", "\"worker.js\""] {
            assert!(!worker.contains(absent), "{absent}");
        }
    }

    #[test]
    fn a_version_is_its_contents() {
        let first = published("first", "a{}", "run();");
        assert_eq!(published("same", "a{}", "run();"), first);
        assert_ne!(
            version(&published("style", "b{}", "run();").1),
            version(&first.1)
        );
        assert_ne!(
            version(&published("script", "a{}", "go();").1),
            version(&first.1)
        );
    }

    #[test]
    fn a_page_that_cannot_be_named_is_an_error() {
        let folder = built("unnamed", "");
        write(&folder.join("index.html"), b"<html>").unwrap();
        assert!(publish(&folder, "").unwrap_err().contains(UNNAMED));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
