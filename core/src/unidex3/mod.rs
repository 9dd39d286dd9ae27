//! The Aerotech Unidex IIIa: a two-axis indexer that is programmed in RS-274 from its front panel or by a controller.
//!
//! In reading order: `keys` and `panel` are the front panel, `display` its eight characters; `memory` keeps programs,
//! `words` takes their text apart, `run` carries it out; `execute` is the firmware around it, `power` the self-test and
//! resets; `line` and `remote` are the serial interface, `listing` what is printed, `status` and `trouble` what is told
//! of errors; `indexer` is everything that makes pulses. `face`, `wiring`, `switches` and `units` are what a person meets
//! around it.

pub mod diagnose;
mod display;
mod execute;
pub mod face;
mod firmware;
pub mod first_steps;
pub mod indexer;
mod keys;
pub mod keywords;
mod line;
mod listing;
mod memory;
mod options;
mod panel;
mod power;
mod remote;
mod run;
mod station;
mod status;
mod switches;
mod trouble;
pub mod units;
pub mod wiring;
mod words;

pub use firmware::LINE;
pub use options::OPTIONS;

use crate::controller::{ControllerInfo, MemoryItem};
use crate::exec::Credit;
use crate::time::Nanos;
use execute::Debugger;
use indexer::Indexer;
use line::Line;
use memory::Memory;
use options::Options;
use panel::Panel;
use remote::Remote;
use run::{Kind, Run};
use trouble::Errors;

/// One unit with its drives, motors and stages.
#[derive(Debug, Clone)]
pub struct Unidex3 {
    info: ControllerInfo,
    options: Options,
    /// The axis-pair selector of the panel, where units share one.
    pair: u8,
    powered: bool,
    indexer: Indexer,
    memory: Memory,
    panel: Panel,
    line: Line,
    remote: Remote,
    link: Link,
    run: Run,
    /// A program, a block or immediate commands run, or wait.
    executing: bool,
    /// What is executed, or was last.
    kind: Kind,
    /// The controller started it.
    remote_run: bool,
    /// EXC in single mode goes on with the next block.
    next_block: bool,
    /// Programs that still run by themselves after power-up.
    boot: Vec<u8>,
    /// What takes the firmware's time; keys do nothing meanwhile.
    busy: Option<Busy>,
    errors: Errors,
    /// The last of them, in the device's words.
    last_error: Option<String>,
    /// The strobe was given in this sample.
    strobed: bool,
    /// The last reset was from the panel or by a program, not by the mains switch.
    was_reset: bool,
    broken: Broken,
    credit: Credit,
    debugger: Debugger,
    next: Nanos,
    /// The RTS line as the unit before this one was told.
    rts: Option<bool>,
    /// Items of non-volatile memory that this version does not know.
    unknown: Vec<MemoryItem>,
    /// Moves as the program writes them, while someone wants them.
    log: Vec<String>,
}

/// Who has the unit (2-3 A).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Link {
    /// The front panel.
    Local,
    /// The front panel, until the controller addresses the unit: local with remote enabled.
    Enabled,
    /// The controller.
    Remote,
}

/// What the firmware is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Busy {
    /// Self-test; at its end a program may run by itself.
    SelfTest {
        until: Nanos,
        boots: bool,
        /// The controller asked for it: it is told by a service request.
        remote: bool,
    },
    /// PWR FAIL, then the editor.
    PowerFail { until: Nanos, number: u8 },
    /// A search in the editor, and what it will find.
    Looking { until: Nanos, found: Option<usize> },
    /// The user RAM test of the panel.
    Testing { until: Nanos },
    /// Prints, until everything is sent.
    Printing,
    /// Stands still until it is reset.
    Dead,
}

/// What is broken inside the unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Broken {
    rom: bool,
    system_ram: bool,
    user_ram: bool,
    /// User memory does not outlive the mains switch.
    battery: bool,
}

impl Unidex3 {
    /// A unit that is switched off.
    ///
    /// # Errors
    /// One clear line about an option that does not exist or a value that it cannot have.
    pub fn new(options: &[(String, String)]) -> Result<Unidex3, String> {
        let options = Options::new(options)?;
        Ok(Unidex3 {
            info: station::info(&options),
            pair: 1,
            powered: false,
            indexer: Indexer::new(options.config),
            memory: Memory::new(options.kilobytes),
            panel: Panel::default(),
            line: Line::new(options.line),
            remote: Remote::default(),
            link: Link::Enabled,
            run: Run::default(),
            executing: false,
            kind: Kind::Auto,
            remote_run: false,
            next_block: false,
            boot: Vec::new(),
            busy: None,
            errors: Errors::default(),
            last_error: None,
            strobed: false,
            was_reset: false,
            broken: Broken::default(),
            credit: Credit::default(),
            debugger: Debugger::default(),
            next: Nanos::ZERO,
            rts: None,
            unknown: Vec::new(),
            log: Vec::new(),
            options,
        })
    }
}
