//! Simulated motion controllers: keys and bytes come in, motion comes out.
#![cfg_attr(
    test,
    allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        clippy::string_slice,
        clippy::unreachable
    )
)]

pub mod controller;
pub mod exec;
pub mod files;
pub mod mc600;
pub mod probe;
pub mod serial;
pub mod time;
pub mod trace;
