//! What a scenario says: the parser's result.

use crate::controller::{Led, Slot};
use crate::ieee488::Order;
use crate::serial::{Flow, Parity};
use crate::time::Nanos;

use super::condition::Condition;

/// One statement, where it stands and which station it is about.
#[derive(Debug, Clone)]
pub(super) struct Statement {
    /// Line of the scenario, from 1.
    pub(super) line: u32,
    /// Index of the station; 0 for what concerns none.
    pub(super) station: usize,
    pub(super) action: Action,
}

/// Every statement of the language.
#[derive(Debug, Clone)]
pub(super) enum Action {
    /// Puts the statement's station on the bench.
    Bench,
    /// Sets the host's side of the line.
    Line(Vec<LineSetting>),
    Break,
    /// Changes the mechanics behind an axis.
    Axis {
        axis: String,
        settings: Vec<(String, String)>,
    },
    FilePut {
        name: String,
        file: String,
    },
    FileGet {
        name: String,
        file: String,
    },
    /// `None`: there is no such file.
    FileExpect {
        name: String,
        text: Option<Vec<u8>>,
    },
    Load {
        slot: Option<Slot>,
        file: String,
    },
    /// The text between `program` and `end`; its first line is the one after the statement's.
    Program {
        slot: Option<Slot>,
        text: String,
    },
    Power(bool),
    /// The line as typed, without its CR.
    Type(Vec<u8>),
    Send(Vec<u8>),
    Press(Vec<String>),
    Hold {
        key: String,
        time: Nanos,
    },
    Wire {
        name: String,
        value: f64,
    },
    Fault {
        kind: String,
        axis: Option<String>,
        active: bool,
    },
    Run(Nanos),
    RunUntilIdle {
        within: Nanos,
    },
    RunUntil {
        text: Vec<u8>,
        within: Nanos,
    },
    Expect(Vec<u8>),
    ExpectExactly(Vec<u8>),
    ExpectNothing,
    Reply {
        text: Vec<u8>,
        within: Nanos,
    },
    /// The text display, blanks at its ends aside.
    Display(String),
    Led {
        name: String,
        state: Led,
    },
    Lamp {
        name: String,
        on: bool,
    },
    /// On the paper, which is what the console's line has sent.
    Printer(Vec<u8>),
    /// On the IEEE-488 bus.
    Bus(BusAction),
    /// Needs a part that no present controller has: `modbus bus`.
    Needs(String),
    Repeat {
        count: u32,
        body: Vec<Statement>,
    },
    /// Time since the station's last `power on`.
    At {
        time: Nanos,
        statement: Box<Statement>,
    },
    Rewind(Nanos),
    Check(Condition),
    /// Index of its watch.
    CheckAlways(usize),
    /// Index of its watch.
    CheckEver(usize),
    CheckSettled {
        condition: Condition,
        within: Nanos,
    },
}

/// One setting of the host's side of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LineSetting {
    Baud(u32),
    Parity(Parity),
    DataBits(u8),
    StopBits(u8),
    Flow(Flow),
}

impl Action {
    /// Whether it is done at one moment, so that `at` can schedule it.
    pub(super) fn is_momentary(&self) -> bool {
        if let Action::Bus(action) = self {
            return action.is_momentary();
        }
        !matches!(
            self,
            Action::Bench
                | Action::Run(_)
                | Action::RunUntilIdle { .. }
                | Action::RunUntil { .. }
                | Action::Reply { .. }
                | Action::Repeat { .. }
                | Action::At { .. }
                | Action::Rewind(_)
                | Action::CheckSettled { .. }
        )
    }
}

/// What is wanted of the bus.
#[derive(Debug, Clone)]
pub(super) enum BusAction {
    /// Asks something.
    Order(Order),
    /// Asks for a status or a parallel poll, waits for it, and compares it.
    Poll {
        order: Order,
        expected: Option<u8>,
        within: Nanos,
    },
    /// Waits until a unit requests service.
    UntilService { within: Nanos },
    /// Whether one does.
    Service(bool),
    /// What the talker has said since the last time, and that it ended with EOI.
    Expect { bytes: Vec<u8>, end: bool },
}

impl BusAction {
    pub(super) fn is_momentary(&self) -> bool {
        !matches!(
            self,
            BusAction::Poll { .. } | BusAction::UntilService { .. }
        )
    }
}
