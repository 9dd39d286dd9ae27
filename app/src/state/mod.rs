//! What the page knows, and how that changes: plain data and pure functions. `store` puts it into the page.

pub mod axis;
mod bench;
pub mod bus;
mod console;
pub mod device;
pub mod editor;
pub mod front;
mod keeping;
pub mod keys;
pub mod layout;
pub mod order;
mod program;
pub mod project;
pub mod recording;
mod revive;
pub mod scope;
mod store;
pub mod terminal;
pub mod versions;
pub mod wiring;
pub mod words;

pub use console::Console;
pub use device::Device;
pub use store::Store;

use crate::protocol::{Frame, FromWorker, Ready};

/// What the page hears from the worker.
#[derive(Debug, Clone, PartialEq)]
pub enum News {
    /// The bench stands.
    Ready(Ready),
    /// What happened, and the samples.
    Frame(Frame, Vec<f64>),
    /// What was asked for: [`FromWorker::Loaded`], `Listing` or `Kept`.
    Answer(FromWorker),
    /// There is no more to be heard.
    Fault(Fault),
}

/// Why there is no simulator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// Its files could not be loaded or run.
    NotStarted,
    /// It failed while it ran.
    Died,
    /// Its files are of another build than the page.
    OtherBuild,
}

impl Fault {
    /// For people: what happened, and what to do.
    pub fn words(self) -> &'static str {
        match self {
            Fault::NotStarted => {
                "The simulator could not be started. Reload the page to try again."
            }
            Fault::Died => {
                "The simulator has failed, and its program is lost. Reload the page to start a new one."
            }
            Fault::OtherBuild => "A newer version has been installed. Reload the page to use it.",
        }
    }
}
