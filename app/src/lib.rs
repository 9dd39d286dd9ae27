//! The page, and the worker that owns the bench.
//!
//! In reading order: [`protocol`] is what the two say to each other, [`worker`] runs the bench, [`client`] is the
//! page's end of the wire, [`state`] is what the page knows, [`panels`] draw it.

pub mod client;
pub mod clock;
pub mod locks;
pub mod offline;
pub mod panels;
pub mod protocol;
pub mod state;
pub mod storage;
pub mod worker;
