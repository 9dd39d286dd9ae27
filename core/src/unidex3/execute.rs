//! The firmware around the interpreter: starts programs, lets them run on their credit, and says how they end.

use std::rc::Rc;

use super::firmware::{CODEWORD, CREDIT_A_SAMPLE, JUMP, SAMPLE, text};
use super::indexer::Event;
use super::memory::DEFAULT_PROGRAM;
use super::run::{Flow, Kind, Run, Wait, World};
use super::trouble::{Errors, Trouble};
use super::{Busy, Link, Unidex3};
use crate::hold::Hold;
use crate::time::Nanos;

/// What holds a program for a person who looks at it.
#[derive(Debug, Clone, Default)]
pub struct Debugger {
    /// Device lines, from 1: the blocks of the program.
    pub breakpoints: Vec<u32>,
    /// Whether the program goes on.
    pub hold: Hold,
    /// The breakpoint that the program stands at.
    passed: Option<u32>,
}

impl Debugger {
    /// No program runs any more.
    pub fn forget(&mut self) {
        (self.hold, self.passed) = (Hold::Free, None);
    }

    /// Whether the program stops before the codeword in this block.
    fn stops(&mut self, line: Option<u32>, spent: u64) -> bool {
        let at_breakpoint = line.is_some_and(|line| self.breakpoints.contains(&line));
        self.hold.arrive(spent);
        if at_breakpoint && self.passed != line {
            self.hold = Hold::Held;
        }
        if self.hold.holds() {
            self.passed = line;
            return true;
        }
        self.passed = line.filter(|_| at_breakpoint);
        false
    }
}

impl Unidex3 {
    /// Begins a program; one that is not there or does not compile says so.
    pub(super) fn start_program(&mut self, at: Nanos, number: u8, kind: Kind) {
        let start = match self.memory.text(number) {
            Some(_) if !self.memory.is_valid() => Err(Trouble::Internal(3)),
            Some(text) => match self.compiles(number, &text) {
                true => Ok(text),
                false => Err(Trouble::Compile(number)),
            },
            None => Err(Trouble::NoProgram),
        };
        match start {
            Ok(text) => self.start_text(at, Some(number), text, kind),
            Err(trouble) => {
                self.errors = Errors::default();
                self.remote_run = self.link == Link::Remote;
                self.end_with(at, trouble);
            }
        }
    }

    /// Begins a text.
    pub(super) fn start_text(&mut self, at: Nanos, number: Option<u8>, text: Rc<[u8]>, kind: Kind) {
        self.leave_manual(at);
        self.errors = Errors::default();
        self.run.begin(number, text);
        self.kind = kind;
        self.remote_run = self.link == Link::Remote;
        self.go_on();
    }

    /// Runs what has begun, or its next block.
    pub(super) fn go_on(&mut self) {
        self.executing = true;
        self.next_block = false;
        self.panel.message = false;
        self.say(match self.remote_run {
            true => text::REMOTE,
            false => text::RUNNING,
        });
    }

    fn compiles(&self, _number: u8, text: &[u8]) -> bool {
        super::words::objections(text, |called| self.has_program(called)).is_empty()
    }

    fn has_program(&self, number: u32) -> bool {
        let number = u8::try_from(number).ok();
        number.is_some_and(|number| self.memory.text(number).is_some())
    }

    /// Ends an edit of the memory; the first program that does not compile, in the order they were entered.
    pub(super) fn close_edit(&mut self) -> Option<u8> {
        self.memory.editing.take()?;
        self.memory.seal();
        let mut programs = self.memory.programs().iter();
        let wrong = programs.find(|program| !self.compiles(program.number, &program.text));
        wrong.map(|program| program.number)
    }

    /// One sample of the program: what happened, what it waited for, and what its credit lets it do.
    pub(super) fn execute_sample(&mut self, now: Nanos, log: bool) {
        while let Some((at, event)) = self.indexer.take_event() {
            self.happened(at, event);
        }
        self.credit
            .deposit(SAMPLE, self.options.speed, CREDIT_A_SAMPLE);
        while self.executing && self.credit.balance > 0 {
            if self.indexer.is_held() || !self.is_over(now) || self.debugger.hold.holds() {
                return;
            }
            let line = self.device_line();
            if self.debugger.stops(line, self.credit.spent) {
                return;
            }
            self.codeword(now, log);
        }
    }

    /// Carries out one codeword.
    fn codeword(&mut self, now: Nanos, log: bool) {
        let mut shown = None;
        let mut world = World {
            indexer: &mut self.indexer,
            memory: &self.memory,
            now,
            oem_in: self.options.oem_in,
            remote: self.remote_run,
            without: self.options.without,
            show: &mut shown,
            log: log.then_some(&mut self.log),
        };
        let outcome = self.run.step(&mut world);
        if let Some(shown) = shown {
            self.panel.display.message(&shown.text);
        }
        let cost = match outcome {
            Ok(Flow::Jump) => JUMP,
            _ => CODEWORD,
        };
        let left = self.credit.balance.saturating_sub_unsigned(cost.0);
        self.credit.settle(left);
        match outcome {
            Ok(Flow::Next | Flow::Jump) => {}
            Ok(Flow::Block) if self.kind == Kind::Single => self.block_ended(),
            Ok(Flow::Block) => {}
            Ok(Flow::Wait(wait)) => self.wait(now, wait),
            Ok(Flow::End) => self.program_ended(now),
            Ok(Flow::Reset) => self.clear_device(now),
            Err(trouble) => self.end_with(now, trouble),
        }
    }

    /// Begins to wait; what a person has to know is on the display.
    fn wait(&mut self, now: Nanos, wait: Wait) {
        self.run.wait = Some(wait);
        match wait {
            Wait::Halt => {
                self.show_halt();
                if self.remote_run {
                    self.remote.request();
                }
            }
            Wait::Input(target) => self.ask(target),
            Wait::Slew => self.show_slew(now),
            Wait::Print => {
                let listing = self.list_message();
                self.line.send(&listing);
            }
            Wait::Move | Wait::Dwell { .. } | Wait::Count | Wait::Stop => {}
        }
    }

    /// Whether the program may go on.
    fn is_over(&mut self, now: Nanos) -> bool {
        let corner_rounding = self.run.modes.corner_rounding;
        let over = match self.run.wait {
            None => true,
            Some(Wait::Move) => self.indexer.is_complete(corner_rounding),
            Some(Wait::Dwell { until }) => now >= until + self.indexer.held_for(),
            Some(Wait::Count) => self.indexer.counts_left() == 0,
            Some(Wait::Print) => self.line.unsent() == 0,
            Some(Wait::Stop | Wait::Halt | Wait::Input(_) | Wait::Slew) => false,
        };
        if over {
            self.run.wait = None;
        }
        over
    }

    fn block_ended(&mut self) {
        let at_end = self.run.is_at_end();
        self.executing = false;
        self.next_block = !at_end;
        self.ended(match at_end {
            true => text::PROGRAM_END,
            false => text::READY,
        });
    }

    fn program_ended(&mut self, now: Nanos) {
        self.executing = false;
        self.next_block = false;
        if self.remote_run || self.boot.is_empty() {
            return self.ended(match self.kind {
                Kind::Single => text::PROGRAM_END,
                Kind::Auto | Kind::Immediate => text::READY,
            });
        }
        self.boot_next(now);
    }

    /// Says that nothing runs any more: to the person, or to the controller.
    fn ended(&mut self, message: &str) {
        self.debugger.forget();
        if self.remote_run {
            self.remote.request();
            self.say(text::REMOTE);
        } else {
            self.say(message);
        }
    }

    /// Ends a program with an error.
    pub(super) fn end_with(&mut self, at: Nanos, trouble: Trouble) {
        let remote = self.remote_run && self.link == Link::Remote;
        self.cancel(at);
        self.boot.clear();
        self.complain(trouble);
        if remote {
            self.remote.request();
        }
    }

    /// Ends a program where it is.
    pub(super) fn cancel(&mut self, at: Nanos) {
        if self.executing {
            self.indexer.stop(at);
        }
        self.executing = false;
        self.next_block = false;
        self.run.wait = None;
        self.panel.message = false;
        self.debugger.forget();
    }

    /// What the indexers tell.
    fn happened(&mut self, at: Nanos, event: Event) {
        match event {
            Event::Limit(axis) => self.limit(at, axis),
            Event::Abort(input) if self.executing => {
                let flag = 1_u8.checked_shl(u32::from(input.saturating_sub(1)));
                self.run.flags |= flag.unwrap_or_default();
                self.leave_manual(at);
                self.panel.message = false;
                self.run.wait = None;
                if let Err(trouble) = self.run.skip(self.run.place.at) {
                    self.end_with(at, trouble);
                }
            }
            Event::Abort(_) => {}
            Event::Reset(_) => self.clear_device(at),
            Event::JoystickButton => self.joystick_button(at),
        }
    }

    /// In a programmed slew the button goes on with the program; in a manual one it clears the registers (6-11).
    fn joystick_button(&mut self, at: Nanos) {
        if self.panel.manual.is_none() {
            return;
        }
        if self.run.wait == Some(Wait::Slew) {
            self.leave_manual(at);
            self.resume();
        } else {
            for axis in super::indexer::Axis::BOTH {
                self.indexer.preload(at, axis, 0);
            }
        }
    }

    /// A limit switch has stopped the axes (4-10).
    fn limit(&mut self, at: Nanos, axis: super::indexer::Axis) {
        let trouble = Trouble::Limit(axis);
        let manual = self.panel.manual.is_some();
        let programmed_slew = self.executing && self.run.wait == Some(Wait::Slew);
        let by_joystick = manual && self.indexer.joystick_clock();
        if programmed_slew {
            // The program goes on once the axis is out of the limit.
            self.complain(trouble);
            if !by_joystick {
                self.leave_manual(at);
            }
            if self.remote_run {
                self.remote.request();
            }
            return;
        }
        if manual && !by_joystick {
            self.leave_manual(at);
        }
        let was = self.link;
        let remote_run = self.remote_run && self.executing;
        if self.executing {
            self.cancel(at);
        }
        self.complain(trouble);
        match was {
            Link::Remote if remote_run || self.options.limit_goes_local => {
                if self.options.limit_goes_local {
                    self.link = Link::Enabled;
                }
                self.remote.request();
            }
            Link::Remote => self.remote.request(),
            Link::Enabled | Link::Local => self.link = Link::Local,
        }
    }

    /// Firmware work that takes its time.
    pub(super) fn busy_sample(&mut self, now: Nanos) {
        match self.busy {
            Some(Busy::SelfTest {
                until,
                boots,
                remote,
            }) if now >= until => {
                self.busy = None;
                match remote {
                    true => self.remote_tested(),
                    false => self.tested(now, boots),
                }
            }
            Some(Busy::PowerFail { until, number }) if now >= until => {
                self.busy = None;
                self.open(number);
            }
            Some(Busy::Looking { until, found }) if now >= until => {
                self.busy = None;
                self.looked(found);
            }
            Some(Busy::Testing { until }) if now >= until => {
                self.busy = None;
                self.panel.mode = super::panel::Mode::None;
                let kilobytes = self.memory.kilobytes();
                match self.broken.user_ram {
                    true => self.say(text::USER_RAM_ERROR),
                    false => self.say(&format!("MEM={kilobytes:>2}K")),
                }
            }
            Some(Busy::Printing) if self.line.unsent() == 0 => {
                self.busy = None;
                self.say(text::READY);
            }
            _ => {}
        }
    }

    /// The block that runs, from 1: ends of block before it, and one. Only of the program that is loaded and listed where
    /// none is named: breakpoints are not in others.
    pub(super) fn device_line(&self) -> Option<u32> {
        let is_meant = self.run.place.number == Some(DEFAULT_PROGRAM);
        (self.executing && is_meant).then(|| line_of(&self.run))
    }
}

fn line_of(run: &Run) -> u32 {
    let before = run.place.text.get(..run.place.at).unwrap_or_default();
    let mut blocks = 1;
    let mut at = 0;
    while let Some(end) = super::words::end_of_block(before, at) {
        blocks += 1;
        at = end + 1;
    }
    blocks
}
