//! The IEEE-488 interface: the same commands, but addressing, polls, clear, trigger and go to local are the bus's own
//! (2-7 B, 4-2 A; Appendix 1).

use super::{BYTES_A_SAMPLE, Interface, MOST_WAITING};
use crate::ieee488::{Heard, Lines, Message};
use crate::time::Nanos;
use crate::unidex3::Unidex3;

impl Unidex3 {
    /// The controller of the bus sends something.
    pub(in crate::unidex3) fn bus_message(&mut self, message: Message) {
        // Without mains it takes no part, but the REN line stands when they come.
        if !self.powered && !matches!(message, Message::RemoteEnable(_)) {
            return;
        }
        let polled = self.remote.bus.accept(self.options.address, message);
        if polled && self.remote.interface == Interface::Bus {
            self.remote.answer_request();
        }
    }

    /// What the unit puts on the bus.
    pub(in crate::unidex3) fn bus_lines(&self) -> Lines {
        if !self.powered {
            return Lines::default();
        }
        let remote = &self.remote;
        let requests = remote.requesting && remote.interface == Interface::Bus;
        let status = match requests {
            true => self.poll_byte(),
            false => self.poll_byte() & !0x40,
        };
        let takes = self.takes_bus_data();
        let poll_line = self.options.poll_line;
        remote.bus.lines(status, requests, takes, poll_line)
    }

    /// In local, and while the other interface is active, the unit holds data off (D322).
    pub(in crate::unidex3) fn takes_bus_data(&self) -> bool {
        self.busy.is_none()
            && self.is_remote_by(Interface::Bus)
            && self.remote.waiting.len() < MOST_WAITING
    }

    /// LLO: RMT does not take the unit from the controller.
    pub(in crate::unidex3) fn is_locked_out(&self) -> bool {
        self.is_remote_by(Interface::Bus) && self.remote.bus.is_locked_out()
    }

    /// Bytes that the firmware will take.
    pub(in crate::unidex3) fn unread_on_bus(&self) -> usize {
        match self.takes_bus_data() {
            true => self.remote.bus.unread(),
            false => 0,
        }
    }

    /// One sample of the bus.
    pub(super) fn bus_sample(&mut self, now: Nanos) {
        for _ in 0..BYTES_A_SAMPLE {
            let heard = match self.takes_bus_data() {
                true => self.remote.bus.take(),
                false => self.remote.bus.take_command(),
            };
            match heard {
                None => return,
                Some(Heard::Data(byte, end)) => self.bus_byte(now, byte, end),
                Some(Heard::Addressed) => self.enter_remote(now, Interface::Bus),
                Some(_) if !self.is_remote_by(Interface::Bus) => {}
                Some(Heard::Clear) => self.clear_device(now),
                Some(Heard::Trigger) => self.trigger(now),
                Some(Heard::Local) => self.go_to_local(now),
            }
        }
    }

    /// EOI ends a line as CR LF does (D323).
    fn bus_byte(&mut self, now: Nanos, byte: u8, end: bool) {
        self.remote_byte(now, byte);
        if end {
            if !matches!(byte, b'\r' | b'\n') {
                self.remote_byte(now, b'\n');
            }
            self.remote.ended_by = None;
        }
    }
}
