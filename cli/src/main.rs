//! `motionbench`: the simulator without a browser.

use std::time::Instant;

fn main() {
    let start = Instant::now();
    let now = || start.elapsed().as_nanos() as f64;
    println!("{}", motionbench::speed::report(None, &now));
}
