//! A device's interface to the bus: who is addressed, what has come, and what is offered.

use std::collections::VecDeque;

use super::{Lines, Message, command};

/// Bytes that wait for the firmware before the next one is held off.
const MOST_WAITING: usize = 64;

/// What the firmware is to do, in the order in which it came.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heard {
    /// Addressed to listen while REN is true.
    Addressed,
    /// A byte, and whether it came with EOI.
    Data(u8, bool),
    /// DCL, or SDC while listening. What came before is gone, and so is what was offered.
    Clear,
    /// GET while listening.
    Trigger,
    /// GTL while listening, or REN has become false.
    Local,
}

/// The interface of one device.
#[derive(Debug, Clone, Default)]
pub struct Device {
    listens: bool,
    talks: bool,
    /// SPE: a talker offers its status.
    polls: bool,
    remote_enabled: bool,
    lockout: bool,
    heard: VecDeque<Heard>,
    offered: VecDeque<u8>,
    /// The last byte offered goes with EOI.
    ends: bool,
}

impl Device {
    /// As after power-up; REN and what it locks out are not the device's.
    #[must_use]
    pub fn initialized(&self) -> Device {
        Device {
            remote_enabled: self.remote_enabled,
            lockout: self.lockout,
            ..Device::default()
        }
    }

    /// Takes in what the controller sends to a device of that address; `true` if its status byte has been read.
    pub fn accept(&mut self, address: u8, message: Message) -> bool {
        match message {
            Message::Command(byte) => self.command(address, byte & 0x7F),
            Message::Data { byte, end } if self.listens => {
                self.heard.push_back(Heard::Data(byte, end));
            }
            Message::Data { .. } => {}
            Message::Accepted if self.talks && self.polls => return true,
            Message::Accepted if self.talks => drop(self.offered.pop_front()),
            Message::Accepted => {}
            Message::InterfaceClear => {
                (self.listens, self.talks, self.polls) = (false, false, false)
            }
            Message::RemoteEnable(true) => self.remote_enabled = true,
            Message::RemoteEnable(false) => {
                if std::mem::take(&mut self.remote_enabled) {
                    self.heard.push_back(Heard::Local);
                }
                self.lockout = false;
            }
        }
        false
    }

    fn command(&mut self, address: u8, byte: u8) {
        match byte {
            command::GO_TO_LOCAL if self.listens => self.heard.push_back(Heard::Local),
            command::SELECTED_CLEAR if self.listens => self.clear(),
            command::DEVICE_CLEAR => self.clear(),
            command::TRIGGER if self.listens => self.heard.push_back(Heard::Trigger),
            command::LOCAL_LOCKOUT => self.lockout = self.remote_enabled,
            command::POLL_ENABLE => self.polls = true,
            command::POLL_DISABLE => self.polls = false,
            command::UNLISTEN => self.listens = false,
            command::UNTALK => self.talks = false,
            command::LISTEN..command::UNLISTEN if byte - command::LISTEN == address => {
                (self.listens, self.talks) = (true, false);
                if self.remote_enabled {
                    self.heard.push_back(Heard::Addressed);
                }
            }
            command::TALK..command::UNTALK => {
                self.talks = byte - command::TALK == address;
                self.listens &= !self.talks;
            }
            _ => {}
        }
    }

    fn clear(&mut self) {
        self.heard.clear();
        self.offered.clear();
        self.heard.push_back(Heard::Clear);
    }

    /// The oldest that is to be done.
    pub fn take(&mut self) -> Option<Heard> {
        self.heard.pop_front()
    }

    /// The oldest that is to be done, where it is no data: the firmware takes data when it can.
    pub fn take_command(&mut self) -> Option<Heard> {
        match self.heard.front() {
            Some(Heard::Data(..)) | None => None,
            Some(_) => self.heard.pop_front(),
        }
    }

    /// Offers a reply in the place of one that was not read; `ends` with EOI.
    pub fn reply(&mut self, bytes: &[u8], ends: bool) {
        self.offered = bytes.iter().copied().collect();
        self.ends = ends;
    }

    /// It is addressed to listen.
    pub fn listens(&self) -> bool {
        self.listens
    }

    /// It is addressed to talk.
    pub fn talks(&self) -> bool {
        self.talks
    }

    /// LLO: the panel may not take the device back.
    pub fn is_locked_out(&self) -> bool {
        self.lockout
    }

    /// What the firmware has not taken.
    pub fn unread(&self) -> usize {
        self.heard.len()
    }

    /// Bytes of a reply that no one has read.
    pub fn unsent(&self) -> usize {
        self.offered.len()
    }

    /// What it puts on the bus: with a status byte, a request for service, whether the firmware takes data, and the line
    /// (1 to 8) that answers a parallel poll.
    pub fn lines(&self, status: u8, requests: bool, takes: bool, poll_line: u8) -> Lines {
        let reply = || {
            let byte = self.offered.front().copied()?;
            Some((byte, self.ends && self.offered.len() == 1))
        };
        let bit = 1_u8.checked_shl(u32::from(poll_line.saturating_sub(1)));
        Lines {
            service: requests,
            listens: self.listens,
            holds_off: self.listens && (!takes || self.heard.len() >= MOST_WAITING),
            talks: self.talks,
            data: match (self.talks, self.polls) {
                (false, _) => None,
                (true, true) => Some((status, false)),
                (true, false) => reply(),
            },
            parallel: bit.filter(|_| requests).unwrap_or_default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A device at address 5 that was sent these commands, with REN.
    fn told(commands: &[u8]) -> Device {
        let mut device = Device::default();
        device.accept(5, Message::RemoteEnable(true));
        for &byte in commands {
            device.accept(5, Message::Command(byte));
        }
        device
    }

    fn lines(device: &Device) -> Lines {
        device.lines(0x41, true, true, 8)
    }

    #[test]
    fn listener_and_talker_by_their_own_addresses() {
        for (commands, listens, talks) in [
            (&[command::LISTEN + 4][..], false, false),
            (&[command::LISTEN + 5], true, false),
            (&[command::LISTEN + 5, command::LISTEN + 4], true, false),
            (&[command::LISTEN + 5, command::UNLISTEN], false, false),
            (&[command::LISTEN + 5, command::TALK + 5], false, true),
            (&[command::TALK + 5, command::LISTEN + 5], true, false),
            (&[command::TALK + 5, command::TALK + 6], false, false),
            (&[command::TALK + 5, command::UNTALK], false, false),
            // Bit 7 of a command says nothing.
            (&[command::LISTEN + 5 + 0x80], true, false),
        ] {
            let device = told(commands);
            assert_eq!(
                (device.listens(), device.talks()),
                (listens, talks),
                "{commands:?}"
            );
        }
        let mut device = told(&[command::TALK + 5]);
        device.accept(5, Message::InterfaceClear);
        assert!(!device.listens() && !device.talks());
    }

    #[test]
    fn a_talker_offers_its_reply_or_while_polled_its_status() {
        let mut device = told(&[]);
        device.reply(b"AB", true);
        assert_eq!(lines(&device).data, None);
        device.accept(5, Message::Command(command::TALK + 5));
        assert_eq!(lines(&device).data, Some((b'A', false)));
        device.accept(5, Message::Command(command::POLL_ENABLE));
        assert_eq!(lines(&device).data, Some((0x41, false)));
        assert!(device.accept(5, Message::Accepted));
        device.accept(5, Message::Command(command::POLL_DISABLE));
        assert!(!device.accept(5, Message::Accepted));
        assert_eq!(lines(&device).data, Some((b'B', true)));
        assert!(!device.accept(5, Message::Accepted));
        assert_eq!(lines(&device).data, None);
    }

    #[test]
    fn what_is_heard_keeps_its_order_and_a_clear_forgets_it() {
        let data = |byte| Message::Data { byte, end: false };
        let mut device = told(&[command::LISTEN + 5]);
        device.accept(5, data(b'T'));
        device.accept(5, Message::Command(command::TRIGGER));
        assert_eq!(device.take(), Some(Heard::Addressed));
        assert_eq!(device.take_command(), None);
        assert_eq!(device.take(), Some(Heard::Data(b'T', false)));
        assert_eq!(device.take(), Some(Heard::Trigger));
        device.accept(5, data(b'X'));
        device.accept(5, Message::Command(command::DEVICE_CLEAR));
        assert_eq!(device.take(), Some(Heard::Clear));
        assert_eq!(device.take(), None);
    }

    #[test]
    fn a_listener_holds_off_when_it_is_full_or_does_not_take() {
        let mut device = told(&[command::LISTEN + 5]);
        assert!(!lines(&device).holds_off);
        assert!(device.lines(0, false, false, 1).holds_off);
        let data = Message::Data {
            byte: 0,
            end: false,
        };
        for _ in 0..MOST_WAITING {
            assert!(!device.accept(5, data));
        }
        assert!(lines(&device).holds_off);
    }

    #[test]
    fn a_parallel_poll_is_answered_on_its_own_line_by_who_requests() {
        let device = told(&[]);
        assert_eq!(device.lines(0, true, true, 8).parallel, 0x80);
        assert_eq!(device.lines(0, true, true, 1).parallel, 0x01);
        assert_eq!(device.lines(0, false, true, 1).parallel, 0);
    }

    #[test]
    fn the_lockout_lasts_until_ren_is_off() {
        let mut device = told(&[command::LOCAL_LOCKOUT]);
        assert!(device.is_locked_out());
        device.accept(5, Message::RemoteEnable(false));
        assert!(!device.is_locked_out());
        assert_eq!(device.take(), Some(Heard::Local));
        device.accept(5, Message::Command(command::LOCAL_LOCKOUT));
        assert!(!device.is_locked_out());
    }
}
