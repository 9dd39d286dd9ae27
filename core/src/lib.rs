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

pub mod bench;
pub mod catalog;
pub mod controller;
pub mod exec;
pub mod files;
pub mod hold;
pub mod ieee488;
pub mod io;
pub mod language;
pub mod mc600;
pub mod motion;
pub mod number;
pub mod plant;
pub mod probe;
pub mod scenario;
pub mod serial;
pub mod servo;
pub mod smartmotor;
pub mod time;
pub mod trace;
pub mod unidex3;
