//! Motion: closed forms, limits and everything behind the interpreter of the MC-600.

// Tests may panic, and their numbers are in range.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss
)]

mod bench;
mod mc600_cam;
mod mc600_drive;
mod mc600_extremes;
mod mc600_gear;
mod mc600_home;
mod mc600_master;
mod mc600_planner;
mod profile;
mod ramp;
mod random;
