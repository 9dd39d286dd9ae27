//! The sending end of a line.

use std::collections::VecDeque;

use super::{Frame, LineSettings, Symbol};
use crate::time::Nanos;

/// Sends bytes one after the other at the line's speed.
#[derive(Debug, Clone)]
pub struct Transmitter {
    settings: LineSettings,
    queue: VecDeque<Symbol>,
    /// XON and XOFF for the other side: they go first, held or not.
    urgent: VecDeque<Symbol>,
    /// When the character now on the wire ends.
    free_at: Nanos,
    /// The other side sent XOFF.
    held: bool,
}

impl Transmitter {
    /// An idle transmitter.
    pub fn new(settings: LineSettings) -> Transmitter {
        Transmitter {
            settings,
            queue: VecDeque::new(),
            urgent: VecDeque::new(),
            free_at: Nanos::ZERO,
            held: false,
        }
    }

    /// Queues a byte. The caller bounds the queue.
    pub fn push(&mut self, byte: u8) {
        self.queue.push_back(Symbol::Byte(byte));
    }

    /// Queues a break.
    pub fn push_break(&mut self) {
        self.queue.push_back(Symbol::Break);
    }

    /// Sends a byte before everything that is queued, held or not (XON and XOFF themselves).
    pub fn push_urgent(&mut self, byte: u8) {
        self.urgent.push_back(Symbol::Byte(byte));
    }

    /// Bytes not yet begun.
    pub fn pending(&self) -> usize {
        self.queue.len()
    }

    /// Whether a character is on the wire at `now`, or waits.
    pub fn is_busy(&self, now: Nanos) -> bool {
        !self.queue.is_empty() || !self.urgent.is_empty() || self.free_at > now
    }

    /// Forgets what has not begun.
    pub fn discard(&mut self) {
        self.queue.clear();
    }

    /// Obeys XOFF (`true`) and XON (`false`).
    pub fn hold(&mut self, held: bool) {
        self.held = held;
    }

    /// Whether XOFF holds it.
    pub fn is_held(&self) -> bool {
        self.held
    }

    /// How the line is set.
    pub fn settings(&self) -> LineSettings {
        self.settings
    }

    /// Changes the settings; what is on the wire ends as it began.
    pub fn set(&mut self, settings: LineSettings) {
        self.settings = settings;
    }

    /// When the next character would begin if asked for at `now`; `None` if there is none or XOFF holds it.
    pub fn next_start(&self, now: Nanos) -> Option<Nanos> {
        let ready = !self.urgent.is_empty() || (!self.held && !self.queue.is_empty());
        ready.then(|| self.free_at.max(now))
    }

    /// Begins the next character if it can start before `until`; call until it returns `None`.
    pub fn next_frame(&mut self, now: Nanos, until: Nanos) -> Option<Frame> {
        let start = self.next_start(now).filter(|&start| start < until)?;
        let symbol = self.urgent.pop_front().or_else(|| self.queue.pop_front())?;
        let frame = Frame {
            start,
            symbol,
            settings: self.settings,
        };
        self.free_at = frame.end();
        Some(frame)
    }
}
