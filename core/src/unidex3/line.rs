//! The serial line: what comes in and goes out, with XON and XOFF both ways.

use std::collections::VecDeque;

use crate::controller::{Output, Ports};
use crate::serial::{Frame, LineSettings, Receiver, Transmitter, XOFF, XON};
use crate::time::Nanos;

/// Received bytes at which the other side is asked to stop.
const STOP_AT: usize = 192;
/// And at which it may go on.
const GO_ON_AT: usize = 32;
/// More than this is lost.
const MOST: usize = 512;

/// The unit's end of the line.
#[derive(Debug, Clone)]
pub struct Line {
    receiver: Receiver,
    transmitter: Transmitter,
    received: VecDeque<u8>,
    /// XOFF was sent.
    stopped: bool,
}

impl Line {
    /// A line as the switches set it.
    pub fn new(settings: LineSettings) -> Line {
        Line {
            receiver: Receiver::new(settings),
            transmitter: Transmitter::new(settings),
            received: VecDeque::new(),
            stopped: false,
        }
    }

    /// The switches are set.
    pub fn set(&mut self, settings: LineSettings) {
        self.receiver.set(settings);
        self.transmitter.set(settings);
    }

    /// A character has passed on the wire.
    pub fn accept(&mut self, frame: Frame) {
        self.receiver.accept(frame);
    }

    /// Takes in what has arrived by `now`. What is garbled is dropped.
    pub fn receive(&mut self, now: Nanos) {
        while let Some(received) = self.receiver.next(now) {
            match received.byte {
                _ if received.framing || received.parity => {}
                XOFF => self.transmitter.hold(true),
                XON => self.transmitter.hold(false),
                byte if self.received.len() < MOST => self.received.push_back(byte),
                _ => {}
            }
        }
        if self.received.len() >= STOP_AT && !self.stopped {
            self.stopped = true;
            self.transmitter.push_urgent(XOFF);
        }
    }

    /// The next byte.
    pub fn take(&mut self) -> Option<u8> {
        let byte = self.received.pop_front();
        if self.stopped && self.received.len() <= GO_ON_AT {
            self.stopped = false;
            self.transmitter.push_urgent(XON);
        }
        byte
    }

    /// The bytes that have not been taken, oldest first.
    pub fn waiting(&self) -> impl Iterator<Item = u8> + '_ {
        self.received.iter().copied()
    }

    /// Sends bytes.
    pub fn send(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.transmitter.push(byte));
    }

    /// Bytes that no one has taken.
    pub fn unread(&self) -> usize {
        self.received.len()
    }

    /// Bytes that have not begun to be sent.
    pub fn unsent(&self) -> usize {
        self.transmitter.pending()
    }

    /// Sends what begins before `until`.
    pub fn transmit(&mut self, now: Nanos, until: Nanos, ports: &mut Ports) {
        while let Some(frame) = self.transmitter.next_frame(now, until) {
            let output = Output::Frame {
                connector: 0,
                frame,
            };
            ports.outputs.push((frame.end(), output));
        }
    }
}
