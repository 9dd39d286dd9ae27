//! How time passes: from one pulse, edge or period of the drives to the next.

use super::clock::{Clock, Job};
use super::command::{Direction, Event, Interrupt};
use super::drive::PERIOD_US;
use super::feedrate::Feedrate;
use super::pair::{Axis, Pair};
use super::{HomeKind, Indexer, MOST_EVENTS};
use crate::time::Nanos;

/// The drive's own feedrate from the home switch to the marker (D295).
const TO_MARKER: Feedrate = Feedrate::fixed(1000);

/// An axis on its way home, and the direction that leads to the switch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Homing {
    /// It stood on the switch: back, until that opens.
    Back(Direction),
    /// Until the switch closes.
    Switch(Direction),
    /// On, until the marker.
    Marker(Direction),
}

impl Homing {
    pub fn begin(to_switch: Direction, at_home: bool) -> Homing {
        if at_home {
            Homing::Back(to_switch)
        } else {
            Homing::Switch(to_switch)
        }
    }

    /// Where to now.
    pub fn direction(self) -> Direction {
        match self {
            Homing::Back(to_switch) => to_switch.opposite(),
            Homing::Switch(to_switch) | Homing::Marker(to_switch) => to_switch,
        }
    }
}

impl Indexer {
    /// Lets time pass until `at`; a time that is over lets none pass.
    pub(super) fn advance(&mut self, at: Nanos) {
        let to = at.0 / 1000;
        while self.now < to {
            let period = self.now / PERIOD_US;
            let boundary = (period + 1) * PERIOD_US;
            let until = boundary.min(to);
            self.run_until(until);
            if until == boundary {
                self.drives.x.step();
                self.drives.y.step();
                self.look_at_switches();
            }
        }
        self.settle_inputs();
    }

    /// Pulses and edges up to `until`, at most a period away.
    fn run_until(&mut self, until: u64) {
        loop {
            self.settle_inputs();
            if self.now >= until {
                return;
            }
            let held = self.inputs.is_holding();
            let runs = self.feedhold.map(|low| !low && !held);
            let mut elapsed = (until - self.now).min(self.inputs.due().saturating_sub(self.now));
            if runs.x {
                elapsed = elapsed.min(self.clocks.x.due());
            }
            if runs.y {
                elapsed = elapsed.min(self.clocks.y.due());
            }
            self.now += elapsed;
            self.counter.pass(elapsed);
            if held {
                self.held += elapsed;
            }
            let x = runs.x && self.clocks.x.pass(elapsed);
            let y = runs.y && self.clocks.y.pass(elapsed);
            if x || y {
                // Both pulses are out before anything that they bring about.
                self.pulse(Axis::X, x);
                self.pulse(Axis::Y, y);
                self.look_at_switches();
            }
        }
    }

    /// A pulse leaves a clock output.
    #[inline]
    pub(super) fn pulse(&mut self, axis: Axis, given: bool) {
        if !given {
            return;
        }
        let direction = self.clocks.of(axis).direction();
        self.drives.of_mut(axis).clock(direction);
        if !self.clocks.of(axis).is_busy() {
            self.finished = self.now + u64::from(*self.config.clock_width_us.of(axis));
        }
    }

    /// Gives an axis something else to do. Without mains there is nothing.
    pub(super) fn give(&mut self, axis: Axis, clock: Clock, homing: Option<Homing>) {
        if self.clocks.of(axis).is_busy() {
            self.finished = self.now;
        }
        if self.powered {
            *self.registers.of_mut(axis) = self.register(axis);
            *self.clocks.of_mut(axis) = clock;
            *self.homing.of_mut(axis) = homing;
        }
    }

    /// Ends everything that is under way.
    pub(super) fn halt(&mut self) {
        for axis in Axis::BOTH {
            self.give(axis, Clock::IDLE, None);
        }
        self.joystick.engage(None);
        self.counter.begin(0);
    }

    /// An axis that has nothing else to do follows the joystick.
    pub(super) fn follow_joystick(&mut self) {
        if !self.powered {
            return;
        }
        for axis in Axis::BOTH {
            let clock = *self.clocks.of(axis);
            match (self.joystick.rate(axis), clock.job()) {
                (Some((direction, rate)), Job::Idle | Job::Joystick) => {
                    self.give(axis, clock.with_joystick(direction, rate), None);
                }
                (None, Job::Joystick) => self.give(axis, Clock::IDLE, None),
                _ => {}
            }
        }
    }

    /// Limit and home switches after something has moved.
    #[inline]
    pub(super) fn look_at_switches(&mut self) {
        if !self.powered {
            return;
        }
        let closed = self.switches();
        if closed != self.closed {
            self.limits_changed(closed);
        }
        for axis in Axis::BOTH {
            if let Some(homing) = *self.homing.of(axis) {
                self.go_home(axis, homing);
            }
        }
    }

    /// The limit switches: positive, negative.
    pub(super) fn switches(&self) -> Pair<(bool, bool)> {
        let of = |axis| {
            (
                self.is_barred(axis, Direction::Positive),
                self.is_barred(axis, Direction::Negative),
            )
        };
        Pair {
            x: of(Axis::X),
            y: of(Axis::Y),
        }
    }

    /// A switch that closes stops both indexers; one that opens changes nothing. Switches are not debounced (4-10,
    /// D299).
    fn limits_changed(&mut self, closed: Pair<(bool, bool)>) {
        let before = std::mem::replace(&mut self.closed, closed);
        for axis in Axis::BOTH {
            let (then, now) = (before.of(axis), closed.of(axis));
            if (now.0 && !then.0) || (now.1 && !then.1) {
                for axis in Axis::BOTH {
                    self.give(axis, Clock::IDLE, None);
                }
                self.joystick.block();
                self.tell(Event::Limit(axis));
            }
        }
    }

    /// One look at an axis on its way home.
    fn go_home(&mut self, axis: Axis, homing: Homing) {
        let drive = self.drives.of_mut(axis);
        let hardware = self.config.home == HomeKind::Hardware;
        match homing {
            Homing::Back(to_switch) if !drive.at_home() => {
                let rate = self.clocks.of(axis).rate();
                let next = Homing::Switch(to_switch);
                let clock = Clock::at_rate(Job::Home, to_switch, rate);
                self.give(axis, clock, Some(next));
            }
            Homing::Switch(to_switch) if drive.at_home() && hardware => {
                let clock = Clock::endless(Job::Home, to_switch, TO_MARKER);
                self.give(axis, clock, Some(Homing::Marker(to_switch)));
                self.find_marker(axis);
            }
            Homing::Switch(_) if drive.at_home() => self.arrive(axis),
            Homing::Marker(_) => self.find_marker(axis),
            Homing::Back(_) | Homing::Switch(_) => {}
        }
    }

    fn find_marker(&mut self, axis: Axis) {
        if self.drives.of(axis).at_marker() {
            self.arrive(axis);
        }
    }

    /// The axis is home.
    fn arrive(&mut self, axis: Axis) {
        self.give(axis, Clock::IDLE, None);
        let drive = self.drives.of_mut(axis);
        drive.stop_here();
        drive.clear_tracking();
        *self.registers.of_mut(axis) = 0;
    }

    /// Takes over the inputs that are due, and does what is armed on them.
    pub(super) fn settle_inputs(&mut self) {
        while let Some(fired) = self.inputs.settle(self.now) {
            if !self.powered {
                continue;
            }
            self.halt();
            self.tell(match fired.interrupt {
                Interrupt::Reset => Event::Reset(fired.input),
                Interrupt::Abort | Interrupt::Feedhold => Event::Abort(fired.input),
            });
        }
    }

    pub(super) fn tell(&mut self, event: Event) {
        if self.events.len() >= MOST_EVENTS {
            self.events.pop_front();
        }
        self.events.push_back((Nanos::from_micros(self.now), event));
    }
}
