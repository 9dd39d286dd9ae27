//! Text that is sent as a file is: at a pace that the device can follow.

use std::collections::VecDeque;

use motionbench_core::time::Nanos;

use crate::protocol::Pace;

/// While it waits for the line or for the prompt, it looks again after so long.
const LOOK_AGAIN: Nanos = Nanos::from_millis(1);

/// What waits to be sent, and when it may go on.
#[derive(Debug, Default)]
pub struct Sender {
    waiting: VecDeque<u8>,
    pace: Pace,
    next: Nanos,
    /// A line has been sent whose prompt is awaited.
    wants_prompt: bool,
}

/// What decides whether the next character goes.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Simulated time.
    pub now: Nanos,
    /// The time of one character.
    pub character: Nanos,
    /// Nothing else waits to be sent.
    pub is_free: bool,
    /// The controller waits for a line.
    pub at_prompt: bool,
}

impl Sender {
    /// Sends these bytes behind those that wait; all of them at a new pace, if there is one.
    pub fn queue(&mut self, bytes: &[u8], pace: Option<Pace>) {
        self.pace = pace.unwrap_or(self.pace);
        self.waiting.extend(bytes);
    }

    /// Forgets what waits.
    pub fn clear(&mut self) {
        *self = Sender::default();
    }

    /// How many bytes wait.
    pub fn len(&self) -> usize {
        self.waiting.len()
    }

    /// Whether none waits.
    pub fn is_empty(&self) -> bool {
        self.waiting.is_empty()
    }

    /// The byte that goes now, if one does.
    pub fn take(&mut self, line: Line) -> Option<u8> {
        if line.now < self.next || !line.is_free || (self.wants_prompt && !line.at_prompt) {
            return None;
        }
        let byte = self.waiting.pop_front()?;
        let ends_line = byte == b'\r';
        self.wants_prompt = ends_line && self.pace.prompt;
        self.next = line.now + line.character + self.pace.character;
        if ends_line {
            self.next += self.pace.line;
        }
        Some(byte)
    }

    /// When to look again, after `now`.
    pub fn due(&self, now: Nanos) -> Nanos {
        self.next.max(now + LOOK_AGAIN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHARACTER: Nanos = Nanos::from_millis(1);

    fn line(now: Nanos) -> Line {
        Line {
            now,
            character: CHARACTER,
            is_free: true,
            at_prompt: false,
        }
    }

    /// When each byte goes, in ms, on a line that is always free; the prompt comes `answers` ms after a line.
    fn times(text: &[u8], pace: Pace, answers: u64) -> Vec<u64> {
        let mut sender = Sender::default();
        sender.queue(text, Some(pace));
        let (mut now, mut times, mut prompt) = (Nanos::ZERO, Vec::new(), Nanos::ZERO);
        while !sender.is_empty() {
            let at_prompt = now >= prompt;
            if let Some(byte) = sender.take(Line {
                at_prompt,
                ..line(now)
            }) {
                times.push(now.0 / 1_000_000);
                if byte == b'\r' {
                    prompt = now + Nanos::from_millis(answers);
                }
            }
            now = sender.due(now);
        }
        times
    }

    #[test]
    fn characters_and_lines_are_apart_as_asked() {
        let pace = Pace {
            character: Nanos::from_millis(4),
            line: Nanos::from_millis(100),
            prompt: false,
        };
        assert_eq!(times(b"A\rB", pace, 0), [0, 5, 110]);
    }

    #[test]
    fn the_next_line_waits_for_the_prompt() {
        let pace = Pace {
            prompt: true,
            ..Pace::default()
        };
        assert_eq!(times(b"A\rB\rC", pace, 50), [0, 1, 51, 52, 102]);
    }

    #[test]
    fn it_waits_while_the_line_is_held() {
        let mut sender = Sender::default();
        sender.queue(b"AB", None);
        let held = Line {
            is_free: false,
            ..line(Nanos::ZERO)
        };
        assert_eq!(sender.take(held), None);
        assert_eq!(sender.take(line(Nanos::ZERO)), Some(b'A'));
        assert_eq!(sender.len(), 1);
        sender.clear();
        assert_eq!(sender.take(line(Nanos::from_millis(100))), None);
    }
}
