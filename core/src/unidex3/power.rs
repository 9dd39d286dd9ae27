//! Power-up, self-test and resets (2-6).

use super::firmware::{POWER_FAIL, TEST_KILOBYTE, TEST_SYSTEM, text};
use super::indexer::Axis;
use super::panel::{Mode, Panel};
use super::run::{Kind, Run};
use super::trouble::{Errors, Trouble};
use super::{Busy, Link, Unidex3};
use crate::exec::Credit;
use crate::time::Nanos;

impl Unidex3 {
    /// The mains switch goes on.
    pub(super) fn power_up(&mut self, at: Nanos) {
        self.indexer.power_up(at);
        self.line = super::Line::new(self.options.line);
        self.remote = self.remote.switched_on();
        self.credit = Credit::default();
        self.was_reset = false;
        if self.broken.battery {
            self.memory.lose();
        }
        self.initialize();
        self.begin_test(at, true, false);
    }

    /// RES: the self-test, but no boot-strap program (2-6 C). DEL does the same from the line.
    pub(super) fn reset(&mut self, at: Nanos, tests: bool) {
        self.leave_manual(at);
        self.close_edit();
        self.indexer.reset(at);
        self.was_reset = true;
        self.remote = self.remote.switched_on();
        self.initialize();
        match tests {
            true => self.begin_test(at, false, false),
            false => self.ready(at, false),
        }
    }

    /// G99, C and the reset interrupt: as RES without the self-test (6-1).
    pub(super) fn clear_device(&mut self, at: Nanos) {
        let (link, remote) = (self.link, self.remote.clone());
        self.reset(at, false);
        if link == Link::Remote {
            self.remote = remote.cleared();
            self.link = link;
            self.panel.mode = Mode::None;
            self.say(text::REMOTE);
        }
    }

    /// The states of 2-6 D.
    fn initialize(&mut self) {
        self.run = Run::default();
        self.errors = Errors::default();
        self.panel = Panel::default();
        self.link = Link::Enabled;
        self.executing = false;
        self.remote_run = false;
        self.next_block = false;
        self.boot.clear();
        self.busy = None;
        self.debugger.forget();
    }

    pub(super) fn begin_test(&mut self, at: Nanos, boots: bool, remote: bool) {
        let memory = TEST_KILOBYTE.0 * u64::from(self.memory.kilobytes());
        self.busy = Some(Busy::SelfTest {
            until: at + TEST_SYSTEM + Nanos(memory),
            boots,
            remote,
        });
    }

    /// What the self-test has found; whether the unit goes on.
    pub(super) fn tested(&mut self, at: Nanos, boots: bool) {
        self.busy = None;
        if self.broken.rom || self.broken.system_ram {
            self.busy = Some(Busy::Dead);
            self.say(match self.broken.rom {
                true => text::ROM_ERROR,
                false => text::SYSTEM_RAM_ERROR,
            });
        } else if self.broken.user_ram {
            self.say(text::USER_RAM_ERROR);
        } else if !self.memory.is_valid() {
            self.say(text::ALTERED);
        } else if let Some(number) = self.memory.editing.filter(|_| !self.memory.is_sealed()) {
            self.busy = Some(Busy::PowerFail {
                until: at + POWER_FAIL,
                number,
            });
            self.say(text::POWER_FAIL);
        } else if !self.memory.is_sealed() {
            self.say(text::ALTERED);
        } else {
            self.memory.editing = None;
            self.ready(at, boots);
        }
    }

    /// Says what comes first: a limit, what boots, what is set up, nothing to run.
    fn ready(&mut self, at: Nanos, boots: bool) {
        let start = self.memory.start();
        let limit = Axis::BOTH
            .into_iter()
            .find(|&axis| self.indexer.limit(axis).is_some());
        if let Some(axis) = limit {
            self.link = Link::Local;
            self.complain(Trouble::Limit(axis));
        } else if boots && start.boot.is_some() {
            let both = [self.memory.user.boot, self.memory.oem.boot];
            self.boot = both.into_iter().flatten().collect();
            self.boot_next(at);
        } else if let Some(number) = start.set_up {
            self.panel.number = Some(number);
            self.panel.mode = Mode::Auto { select: true };
            self.say(&format!("RUN   {number:02}"));
        } else if self.memory.programs().is_empty() && self.memory.is_valid() {
            self.say(text::CLEAR);
        } else {
            self.say(text::READY_SYSTEM);
        }
    }

    /// The next program that runs by itself: the OEM's, then the user's (4-11 A).
    pub(super) fn boot_next(&mut self, at: Nanos) {
        if let Some(number) = self.boot.pop() {
            self.panel.number = Some(number);
            self.panel.mode = Mode::Auto { select: false };
            self.start_program(at, number, Kind::Auto);
        }
    }

    /// The result of V (4-3 A).
    pub(super) fn test_result(&self) -> u8 {
        let Self { broken, memory, .. } = self;
        let altered = !memory.is_valid() || !memory.is_sealed();
        let bits = [broken.rom, broken.system_ram, broken.user_ram, altered];
        let bits = bits
            .iter()
            .zip(0..)
            .map(|(&bit, place)| u8::from(bit) << place);
        let failures = bits.sum::<u8>();
        0x40 | failures | if failures != 0 { 0x80 } else { 0 }
    }
}
