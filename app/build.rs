//! Names this build, so that a page notices a worker of another one (the worker's files are not hashed by name).

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

fn main() {
    let mut sources = vec![PathBuf::from("../Cargo.lock")];
    for folder in ["src", "../core/src"] {
        println!("cargo::rerun-if-changed={folder}");
        collect(Path::new(folder), &mut sources);
    }
    println!("cargo::rerun-if-changed=../Cargo.lock");
    // The same sources give the same name on every machine.
    sources.sort();
    let mut hash = DefaultHasher::new();
    for source in &sources {
        source.hash(&mut hash);
        std::fs::read(source).unwrap_or_default().hash(&mut hash);
    }
    println!("cargo::rustc-env=MOTIONBENCH_BUILD={:016x}", hash.finish());
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return;
    };
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            collect(&path, files);
        } else {
            files.push(path);
        }
    }
}
