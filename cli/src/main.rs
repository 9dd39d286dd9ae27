//! `motionbench`: the simulator without a browser.

fn main() {}
