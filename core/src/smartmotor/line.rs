//! The serial line: what comes in and goes out, the echo that makes a chain, the address that commands are for.

use std::collections::VecDeque;

use super::ast::{Channel, LineCommand, LineFlag};
use super::firmware::{LINE, RECEIVED};
use super::motor::Motor;
use crate::controller::{Output, Ports};
use crate::serial::{Frame, LineSettings, Receiver, Transmitter};
use crate::time::Nanos;

/// A statement that prints waits while more bytes than this have not been sent (D139).
const PENDING: usize = 16;
/// An echo is lost where so much has not been sent: the other side sends faster than this one.
const MOST_ECHO: usize = 4096;
/// What every motor listens to, and the first address.
pub const ALL_MOTORS: u8 = 128;
/// In front of what Q answers.
const QUERY_ANSWER: u8 = 0xF9;

/// The line's error bits, latched.
#[derive(Debug, Clone, Copy, Default)]
pub struct LineFlags {
    bits: u8,
}

impl LineFlags {
    fn mask(flag: LineFlag) -> u8 {
        match flag {
            LineFlag::Parity => 1,
            LineFlag::Overflow => 2,
            LineFlag::Framing => 4,
        }
    }

    /// Whether a bit is set.
    pub fn is(self, flag: LineFlag) -> bool {
        self.bits & LineFlags::mask(flag) != 0
    }

    fn raise(&mut self, flag: LineFlag) {
        self.bits |= LineFlags::mask(flag);
    }

    /// Clears a bit.
    pub fn clear(&mut self, flag: LineFlag) {
        self.bits &= !LineFlags::mask(flag);
    }

    /// Clears all.
    pub fn clear_all(&mut self) {
        self.bits = 0;
    }
}

/// The motor's end of the host's line, and of channel 1, to which nothing is connected (D148).
#[derive(Debug, Clone)]
pub struct Line {
    receiver: Receiver,
    transmitter: Transmitter,
    ring: VecDeque<u8>,
    /// Characters since power-up.
    received: u64,
    /// Errors of what came in.
    pub flags: LineFlags,
    echo: bool,
    /// 0 is none.
    address: u8,
    /// The last address byte was this motor's, or there was none.
    selected: bool,
    asleep: bool,
    silent: bool,
    /// What comes in is for GETCHR.
    data: bool,
    /// The host's channel is closed: nothing comes in or goes out.
    closed: bool,
    /// Channel 1, if it is open.
    second: Option<Transmitter>,
}

impl Line {
    /// The line at power-up, with an address and an echo that a bench may give.
    pub fn new(address: u8, echo: bool) -> Line {
        Line {
            receiver: Receiver::new(LINE),
            transmitter: Transmitter::new(LINE),
            ring: VecDeque::new(),
            received: 0,
            flags: LineFlags::default(),
            echo,
            address,
            selected: true,
            asleep: false,
            silent: false,
            data: false,
            closed: false,
            second: None,
        }
    }

    /// A character has passed on the wire.
    pub fn accept(&mut self, frame: Frame) {
        self.receiver.accept(frame);
    }

    /// Takes in what has arrived by `now`, and echoes it.
    pub fn receive(&mut self, now: Nanos) {
        while let Some(received) = self.receiver.next(now) {
            self.received += 1;
            if self.closed {
                continue;
            }
            if received.framing {
                self.flags.raise(LineFlag::Framing);
                continue;
            }
            if received.parity {
                self.flags.raise(LineFlag::Parity);
                continue;
            }
            if self.echo && self.transmitter.pending() < MOST_ECHO {
                self.transmitter.push(received.byte);
            }
            if self.ring.len() < RECEIVED {
                self.ring.push_back(received.byte);
            } else {
                self.flags.raise(LineFlag::Overflow);
            }
        }
    }

    /// Characters that have come since power-up, good or bad.
    pub fn received(&self) -> u64 {
        self.received
    }

    /// The next byte for the command interpreter.
    pub fn take_byte(&mut self) -> Option<u8> {
        match self.data {
            true => None,
            false => self.ring.pop_front(),
        }
    }

    /// GETCHR.
    pub fn take_character(&mut self) -> Option<u8> {
        match self.data {
            true => self.ring.pop_front(),
            false => None,
        }
    }

    /// What GETCHR would take.
    pub fn next_character(&self) -> Option<u8> {
        self.ring.front().copied().filter(|_| self.data)
    }

    /// LEN.
    pub fn characters(&self) -> usize {
        match self.data {
            true => self.ring.len(),
            false => 0,
        }
    }

    /// Whether a statement may print.
    pub fn has_room(&self) -> bool {
        let second = self.second.as_ref();
        self.transmitter.pending() <= PENDING
            && second.is_none_or(|second| second.pending() <= PENDING)
    }

    /// Sends what a statement of the host or of the program prints; SILENT keeps back the program's (D145).
    pub fn print(&mut self, channel: u8, bytes: &[u8], host: bool) {
        match (channel, &mut self.second) {
            (0, _) if !self.silent || host => self.send(bytes),
            (1, Some(second)) => bytes.iter().for_each(|&byte| second.push(byte)),
            _ => {}
        }
    }

    /// Sends bytes to the host.
    pub fn send(&mut self, bytes: &[u8]) {
        if !self.closed {
            bytes.iter().for_each(|&byte| self.transmitter.push(byte));
        }
    }

    /// An address byte: whether the commands that follow are for this motor.
    pub fn select(&mut self, byte: u8) {
        let own = self.address > 0 && byte == ALL_MOTORS.saturating_add(self.address);
        self.selected = byte == ALL_MOTORS || own;
    }

    /// Whether commands are for this motor.
    pub fn is_selected(&self) -> bool {
        self.selected
    }

    /// Whether commands other than WAKE are ignored.
    pub fn is_asleep(&self) -> bool {
        self.asleep
    }

    /// ADDR.
    pub fn address(&self) -> u8 {
        self.address
    }

    /// Sets the address; 0 is none.
    pub fn set_address(&mut self, address: u8) {
        self.address = address;
    }

    /// Carries out an order; what is not about the line itself is the firmware's.
    pub fn command(&mut self, command: LineCommand, motor: &Motor) {
        match command {
            LineCommand::Address(address) => self.set_address(address),
            LineCommand::Sleep => self.asleep = true,
            LineCommand::Wake => self.asleep = false,
            LineCommand::Echo(on) => self.echo = on,
            LineCommand::Silent(on) => self.silent = on,
            LineCommand::Baud(baud) => {
                let settings = self.transmitter.settings();
                self.set(LineSettings { baud, ..settings });
            }
            LineCommand::Open(channel) => self.open(channel),
            LineCommand::Close(0) => self.closed = true,
            LineCommand::Close(_) => self.second = None,
            LineCommand::Query => {
                let status = motor.stream_status();
                self.send(&[QUERY_ANSWER, status.state, status.free]);
            }
            LineCommand::Pause | LineCommand::Load | LineCommand::Upload { .. } => {}
        }
    }

    fn open(&mut self, channel: Channel) {
        let settings = LineSettings {
            baud: channel.baud,
            data_bits: channel.data_bits,
            parity: channel.parity,
            stop_bits: channel.stop_bits,
            ..LINE
        };
        if channel.number == 0 {
            self.set(settings);
            self.data = channel.data;
            self.closed = false;
        } else {
            self.second = Some(Transmitter::new(settings));
        }
    }

    fn set(&mut self, settings: LineSettings) {
        self.receiver.set(settings);
        self.transmitter.set(settings);
    }

    /// Received bytes that no one has read.
    pub fn unread(&self) -> usize {
        self.ring.len()
    }

    /// Bytes that have not begun to be sent.
    pub fn unsent(&self) -> usize {
        self.transmitter.pending()
    }

    /// Sends what begins before `until`. Channel 1 ends at a connector without a plug.
    pub fn transmit(&mut self, now: Nanos, until: Nanos, ports: &mut Ports) {
        let second = self.second.as_mut().map(|second| (1, second));
        for (connector, transmitter) in [(0, &mut self.transmitter)].into_iter().chain(second) {
            while let Some(frame) = transmitter.next_frame(now, until) {
                let output = Output::Frame { connector, frame };
                ports.outputs.push((frame.end(), output));
            }
        }
    }
}
