//! The receiving end of a line.

use std::collections::VecDeque;

use super::{Frame, LineSettings, Parity, Symbol};
use crate::time::Nanos;

/// A character as the receiver read it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Received {
    /// Its data bits.
    pub byte: u8,
    /// When it was complete.
    pub at: Nanos,
    /// The parity bit was wrong.
    pub parity: bool,
    /// There was no stop bit where one should be.
    pub framing: bool,
}

/// Reads characters from the levels of a wire.
#[derive(Debug, Clone)]
pub struct Receiver {
    settings: LineSettings,
    /// Frames not yet read to their end, oldest first; the line idles between them.
    frames: VecDeque<Frame>,
    /// Everything before is read.
    read_to: Nanos,
    /// The line was low at the end of the last character: wait for it to rise first.
    wait_for_mark: bool,
}

impl Receiver {
    /// A receiver on an idle line.
    pub fn new(settings: LineSettings) -> Receiver {
        Receiver {
            settings,
            frames: VecDeque::new(),
            read_to: Nanos::ZERO,
            wait_for_mark: false,
        }
    }

    /// Changes the settings for what has not been read yet.
    pub fn set(&mut self, settings: LineSettings) {
        self.settings = settings;
    }

    /// How this end is set.
    pub fn settings(&self) -> LineSettings {
        self.settings
    }

    /// A frame has passed on the wire. Frames come in order.
    pub fn accept(&mut self, frame: Frame) {
        self.frames.push_back(frame);
    }

    /// The next character that is complete at `now`.
    pub fn next(&mut self, now: Nanos) -> Option<Received> {
        let frame = *self.frames.front()?;
        let Symbol::Byte(byte) = frame.symbol else {
            return self.sample(now);
        };
        let unread = frame.start >= self.read_to && !self.wait_for_mark;
        if unread && self.same_as(&frame.settings) {
            if frame.end() > now {
                return None;
            }
            self.frames.pop_front();
            self.read_to = frame.end();
            return Some(Received {
                byte: self.settings.mask(byte),
                at: frame.end(),
                parity: false,
                framing: false,
            });
        }
        self.sample(now)
    }

    fn same_as(&self, sender: &LineSettings) -> bool {
        let mine = &self.settings;
        (mine.baud, mine.data_bits, mine.parity, mine.stop_bits)
            == (
                sender.baud,
                sender.data_bits,
                sender.parity,
                sender.stop_bits,
            )
    }

    /// Reads one character by sampling levels in the middle of this end's bits.
    fn sample(&mut self, now: Nanos) -> Option<Received> {
        if self.wait_for_mark {
            let rise = self.next_level(self.read_to, true, now)?;
            self.read_to = rise;
            self.wait_for_mark = false;
        }
        let start = self.next_level(self.read_to, false, now)?;
        let settings = self.settings;
        let middle = |bit: u32| start + Nanos(settings.time_of(2 * bit + 1).0 / 2);
        let data_bits = u32::from(settings.data_bits);
        let stop = data_bits + 1 + u32::from(settings.parity != Parity::None);
        let at = middle(stop);
        if at > now {
            return None;
        }
        let byte = (0..data_bits).fold(0u8, |byte, bit| {
            byte | (u8::from(self.level(middle(bit + 1))) << bit)
        });
        let parity = settings.parity != Parity::None
            && self.level(middle(data_bits + 1)) != settings.parity_bit(byte);
        let framing = !self.level(at);
        self.read_to = at;
        self.wait_for_mark = framing;
        self.forget();
        Some(Received {
            byte,
            at,
            parity,
            framing,
        })
    }

    /// The level of the wire at `at`; it idles at mark.
    fn level(&self, at: Nanos) -> bool {
        self.frames
            .iter()
            .find(|frame| frame.start <= at && at < frame.end())
            .is_none_or(|frame| frame.level(at))
    }

    /// When the wire first has `level` at or after `from`, looking no further than `now`.
    fn next_level(&mut self, from: Nanos, level: bool, now: Nanos) -> Option<Nanos> {
        if self.level(from) == level && from <= now {
            return Some(from);
        }
        // Levels change only at the sender's bit borders and where frames begin and end.
        let mut borders: Vec<Nanos> = Vec::new();
        for frame in &self.frames {
            let bits = match frame.symbol {
                Symbol::Byte(_) => u32::from(frame.settings.frame_bits()),
                Symbol::Break => 0,
            };
            // One nanosecond after the border, so that rounding never lands in the bit before.
            borders
                .extend((0..=bits).map(|bit| frame.start + frame.settings.time_of(bit) + Nanos(1)));
            borders.push(frame.end());
        }
        let found = borders
            .into_iter()
            .find(|&at| at > from && at <= now && self.level(at) == level);
        if found.is_none() && level != self.level(now) {
            self.forget();
        }
        found
    }

    /// Drops the frames that lie wholly before what is read.
    fn forget(&mut self) {
        while self
            .frames
            .front()
            .is_some_and(|frame| frame.end() <= self.read_to)
        {
            self.frames.pop_front();
        }
    }
}
