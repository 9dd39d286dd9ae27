//! The ServoBus: a master's position every sample, and telegrams by identifier.
//!
//! Source: "Servobus".

use std::collections::VecDeque;

use crate::controller::Telegram;
use crate::time::Nanos;

/// What a telegram takes on the bus (D211).
pub const TELEGRAM_TIME: Nanos = Nanos(130_000);
/// Telegrams that the bus carries in a sample; the rest waits.
const TELEGRAMS_A_SAMPLE: usize = 15;
/// Telegrams that can wait; more are lost (D211).
const QUEUE: usize = 64;
/// Identifier of the master's position.
const SYNC: u16 = 0;
/// Identifiers that a program may use.
pub const IDENTIFIERS: std::ops::RangeInclusive<u16> = 1..=2047;
/// Mailboxes.
pub const MAILBOXES: u8 = 8;

/// A card's side of the bus.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ServoBus {
    /// `msetsb(1)`.
    pub(super) master: bool,
    /// `gv_canout%`: the master position (D212).
    pub(super) sent: i32,
    /// `gv_canin%`; `None` until something has come.
    pub(super) received: Option<i32>,
    /// The identifier that each mailbox takes; 0 takes none.
    boxes: [u16; MAILBOXES as usize],
    /// `can_data%`.
    data: [i32; MAILBOXES as usize],
    /// `can_flag%`; the program takes its bits back (D213).
    pub(super) flags: u8,
    queue: VecDeque<Telegram>,
}

impl ServoBus {
    /// `mcantx`.
    pub(super) fn transmit(&mut self, identifier: u16, data: i32) {
        if self.queue.len() < QUEUE {
            self.queue.push_back(Telegram {
                identifier,
                data: vec![data],
            });
        }
    }

    /// `mcanrx`.
    pub(super) fn set_mailbox(&mut self, number: u8, identifier: u16) {
        if let Some(mailbox) = self.boxes.get_mut(usize::from(number)) {
            *mailbox = identifier;
            self.flags &= !(1 << number);
        }
    }

    /// `can_data%(number)`.
    pub(super) fn data(&self, number: usize) -> Option<i32> {
        self.data.get(number).copied()
    }

    /// A telegram of another card.
    pub(super) fn receive(&mut self, telegram: &Telegram) {
        let value = telegram.data.first().copied().unwrap_or(0);
        if telegram.identifier == SYNC {
            self.received = Some(value);
            return;
        }
        let boxes = self.boxes.iter().zip(&mut self.data).enumerate();
        for (number, (&identifier, data)) in boxes {
            if identifier == telegram.identifier {
                *data = value;
                self.flags |= 1 << number;
            }
        }
    }

    /// Whether a sample sends nothing.
    pub(super) fn is_silent(&self) -> bool {
        !self.master && self.queue.is_empty()
    }

    /// What goes out after a sample: the master's position first.
    pub(super) fn send(&mut self, position: i32) -> Vec<Telegram> {
        let mut telegrams = Vec::new();
        if self.master {
            self.sent = position;
            telegrams.push(Telegram {
                identifier: SYNC,
                data: vec![position],
            });
        }
        let room = TELEGRAMS_A_SAMPLE.min(self.queue.len());
        telegrams.extend(self.queue.drain(..room));
        telegrams
    }
}
