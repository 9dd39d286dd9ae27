//! Writes the seeds of the fuzzers into `fuzz/seeds/`, a folder for each.

use std::path::Path;

use motionbench_tests::fuzz::TARGETS;
use motionbench_tests::seeds::seeds;

fn main() -> std::io::Result<()> {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("fuzz");
    for (target, _) in TARGETS {
        let folder = fuzz.join("seeds").join(target);
        std::fs::create_dir_all(&folder)?;
        let seeds = seeds(target);
        for (name, bytes) in &seeds {
            std::fs::write(folder.join(name), bytes)?;
        }
        println!("fuzz/seeds/{target}: {} seeds", seeds.len());
    }
    Ok(())
}
