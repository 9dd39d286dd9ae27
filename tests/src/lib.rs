//! What the tests share.

pub mod conformance;
pub mod fuzz;
pub mod programs;
pub mod seeds;
