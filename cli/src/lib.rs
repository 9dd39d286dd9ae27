//! What the runner shares with the tests: the measured programs of `motionbench speed`.

pub mod speed;
