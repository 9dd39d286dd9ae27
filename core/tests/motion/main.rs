//! Motion: closed forms, limits and everything behind the interpreter of the MC-600.

// Tests may panic, and their numbers are in range.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
#![allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)]

mod bench;
mod mc600_drive;
mod mc600_planner;
mod profile;
mod ramp;
mod random;
