//! The controller of the bus: what a person asks of it becomes messages, one after the other.

use std::collections::VecDeque;

use super::{LAST_ADDRESS, Message, command};
use crate::time::Nanos;

/// A byte takes this long, or a look at a listener that holds it off (D321).
pub const BYTE: Nanos = Nanos::from_micros(100);
/// Messages that may wait.
const MOST_STEPS: usize = 1 << 16;

/// What a person asks of the controller of the bus. Where there are addresses, these units listen first; without, those
/// that listen already.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Order {
    /// The REN line.
    RemoteEnable(bool),
    /// IFC: at once, and what was asked before is forgotten.
    InterfaceClear,
    /// These units listen, and no others; without any, no one listens.
    Listen(Vec<u8>),
    /// Data for those that listen, the last byte with EOI or not.
    Send(Vec<u8>, bool),
    /// This unit talks to the controller, until another order for the bus.
    Talk(u8),
    /// Serial poll of a unit.
    SerialPoll(u8),
    /// Parallel poll.
    ParallelPoll,
    /// GET.
    Trigger(Vec<u8>),
    /// SDC to these units; without any DCL, to all.
    Clear(Vec<u8>),
    /// GTL.
    GoToLocal(Vec<u8>),
    /// LLO.
    LocalLockout,
}

/// What the controller has learnt.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Report {
    /// A byte of the talker, and whether it came with EOI.
    Data(u8, bool),
    /// A unit's status byte; `None` if there is no such unit.
    SerialPoll(u8, Option<u8>),
    /// The data lines of a parallel poll.
    ParallelPoll(u8),
}

impl Report {
    /// It as a number, for a digest of a run.
    pub fn word(self) -> u64 {
        match self {
            Report::Data(byte, end) => u64::from(byte) | u64::from(end) << 8,
            Report::SerialPoll(address, status) => {
                let status = status.map_or(0x100, u64::from);
                1 << 16 | u64::from(address) << 32 | status
            }
            Report::ParallelPoll(bits) => 2 << 16 | u64::from(bits),
        }
    }
}

/// One thing at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Step {
    /// Sends it.
    Message(Message),
    /// Reads the status byte of the talker, whose address is this.
    Status(u8),
    /// ATN with EOI.
    Identify,
    /// From now on takes what the talker says.
    Receive,
}

/// The controller of a bus.
#[derive(Debug, Clone, Default)]
pub struct Controller {
    steps: VecDeque<Step>,
    /// The bus is busy until then.
    free: Nanos,
    receives: bool,
    remote_enabled: bool,
}

impl Controller {
    /// Takes an order; `false` if there is no room for it.
    pub fn order(&mut self, order: &Order) -> bool {
        if let Order::InterfaceClear = order {
            self.steps.clear();
            self.receives = false;
        }
        let mut steps = Vec::new();
        plan(order, &mut steps);
        let fits = self.steps.len() + steps.len() <= MOST_STEPS;
        if fits {
            if let Order::RemoteEnable(on) = order {
                self.remote_enabled = *on;
            }
            self.steps.extend(steps);
        }
        fits
    }

    /// Whether something is left to do.
    pub fn is_busy(&self) -> bool {
        !self.steps.is_empty()
    }

    /// Whether it takes what a talker says.
    pub fn receives(&self) -> bool {
        self.receives && self.steps.is_empty()
    }

    /// REN, as ordered last.
    pub fn remote_enabled(&self) -> bool {
        self.remote_enabled
    }

    /// When the bus is free for the next thing.
    pub(crate) fn free(&self) -> Nanos {
        self.free
    }

    /// The next thing.
    pub(crate) fn next(&self) -> Option<Step> {
        self.steps.front().copied()
    }

    /// It has been tried at `now`, and is done or not.
    pub(crate) fn tried(&mut self, now: Nanos, done: bool) {
        self.free = now + BYTE;
        if done && let Some(step) = self.steps.pop_front() {
            self.receives = step == Step::Receive;
        }
    }

    /// A byte of the talker has been taken.
    pub(crate) fn received(&mut self, now: Nanos) {
        self.free = now + BYTE;
    }
}

/// The messages of an order.
fn plan(order: &Order, steps: &mut Vec<Step>) {
    let listen = |addresses: &[u8], steps: &mut Vec<Step>| {
        let known = addresses.iter().filter(|&&address| address <= LAST_ADDRESS);
        let listen = known.map(|&address| command::LISTEN + address);
        let commands = [command::UNTALK, command::UNLISTEN]
            .into_iter()
            .chain(listen);
        steps.extend(commands.map(commanded));
    };
    let addressed = |addresses: &[u8], byte: u8, steps: &mut Vec<Step>| {
        if !addresses.is_empty() {
            listen(addresses, steps);
        }
        steps.push(commanded(byte));
    };
    match order {
        Order::RemoteEnable(on) => steps.push(Step::Message(Message::RemoteEnable(*on))),
        Order::InterfaceClear => steps.push(Step::Message(Message::InterfaceClear)),
        Order::Listen(addresses) => listen(addresses, steps),
        Order::Send(bytes, ends) => {
            let last = bytes.len().saturating_sub(1);
            let data = bytes
                .iter()
                .enumerate()
                .map(|(index, &byte)| Message::Data {
                    byte,
                    end: *ends && index == last,
                });
            steps.extend(data.map(Step::Message));
        }
        Order::Talk(address) => {
            let talk = command::TALK + address.min(&LAST_ADDRESS);
            steps.extend([command::UNLISTEN, talk].map(commanded));
            steps.push(Step::Receive);
        }
        Order::SerialPoll(address) => {
            let talk = command::TALK + address.min(&LAST_ADDRESS);
            steps.extend([command::UNLISTEN, command::POLL_ENABLE, talk].map(commanded));
            steps.push(Step::Status(*address));
            steps.extend([command::POLL_DISABLE, command::UNTALK].map(commanded));
        }
        Order::ParallelPoll => steps.push(Step::Identify),
        Order::Trigger(addresses) => addressed(addresses, command::TRIGGER, steps),
        Order::Clear(addresses) if addresses.is_empty() => {
            steps.push(commanded(command::DEVICE_CLEAR));
        }
        Order::Clear(addresses) => addressed(addresses, command::SELECTED_CLEAR, steps),
        Order::GoToLocal(addresses) => addressed(addresses, command::GO_TO_LOCAL, steps),
        Order::LocalLockout => steps.push(commanded(command::LOCAL_LOCKOUT)),
    }
}

fn commanded(byte: u8) -> Step {
    Step::Message(Message::Command(byte))
}
