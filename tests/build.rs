//! Makes a test of every scenario in `conformance/`: their texts are built in, since a browser has no files, and for the
//! browser so is the digest of what the same run does here, to the last bit.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use motionbench_core::scenario::{Scenario, program_text};

/// Files by their names relative to `conformance/`.
type Files = BTreeMap<String, PathBuf>;

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("conformance");
    println!("cargo::rerun-if-changed={}", folder.display());
    println!("cargo::rerun-if-changed=build.rs");
    let mut files = Files::new();
    collect(&folder, "", &mut files);
    let in_browser = std::env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family == "wasm");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    std::fs::write(out.join("files.rs"), table(&files)).expect("OUT_DIR can be written");
    std::fs::write(out.join("scenarios.rs"), tests(&files, in_browser))
        .expect("OUT_DIR can be written");
}

fn collect(folder: &Path, prefix: &str, files: &mut Files) {
    for entry in folder.read_dir().into_iter().flatten().flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let name = format!("{prefix}{}", name.to_string_lossy());
        if path.is_dir() {
            collect(&path, &format!("{name}/"), files);
        } else {
            files.insert(name, path);
        }
    }
}

/// The files' contents, as an expression.
fn table(files: &Files) -> String {
    let rows = files.iter().map(|(name, path)| {
        let path = path.display().to_string();
        format!("    ({name:?}, include_bytes!({path:?})),\n")
    });
    format!("&[\n{}]\n", rows.collect::<String>())
}

/// A test function for each scenario.
fn tests(files: &Files, in_browser: bool) -> String {
    let mut text = String::new();
    let mut taken = BTreeMap::new();
    for (name, path) in files {
        let Some(stem) = name.strip_suffix(".scenario") else {
            continue;
        };
        let mut function: String = stem
            .chars()
            .map(|c| {
                if c.is_ascii_alphanumeric() {
                    c.to_ascii_lowercase()
                } else {
                    '_'
                }
            })
            .collect();
        let same = taken.entry(function.clone()).or_insert(0);
        *same += 1;
        if *same > 1 {
            let _ = write!(function, "_{same}");
        }
        let digest = in_browser.then(|| digest(path)).flatten();
        let _ = write!(
            text,
            "#[cfg_attr(not(target_family = \"wasm\"), test)]\n\
             #[cfg_attr(target_family = \"wasm\", wasm_bindgen_test::wasm_bindgen_test)]\n\
             fn {function}() {{\n    \
                 motionbench_tests::conformance::holds({name:?}, {digest:?});\n}}\n\n"
        );
    }
    text
}

/// What a run of the scenario does, in a number. A scenario that cannot be run fails in its test.
fn digest(path: &Path) -> Option<u64> {
    let folder = path.parent()?;
    let scenario = Scenario::parse(&program_text(&std::fs::read(path).ok()?)).ok()?;
    let run = || {
        scenario
            .run(&mut |name| std::fs::read(folder.join(name)).map_err(|error| error.to_string()))
    };
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(run))
        .ok()
        .map(|report| report.digest)
}
