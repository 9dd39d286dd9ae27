//! Numbers as digits: what is read, and the nine-digit form of Microsoft BASIC in which they are printed.

mod print;
mod read;

pub use print::{integer, microsoft9};
pub use read::{Constant, leading, unsigned};
