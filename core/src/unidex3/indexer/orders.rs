//! What the firmware orders. Each order has the time at which it is given; one of a time that is over acts now.

use super::clock::{Clock, Job};
use super::command::{Direction, Edge, Interrupt, Move};
use super::feedrate::Feedrate;
use super::pair::{Axis, Pair};
use super::timeline::Homing;
use super::{Config, HomeKind, Indexer, ramp};
use crate::time::Nanos;

impl Indexer {
    /// Mains on: drives reset, registers and tracking displays 0, nothing armed. A limit switch that is closed now is
    /// no event: [`Indexer::limit`] tells of it.
    pub fn power_up(&mut self, at: Nanos) {
        self.advance(at);
        self.powered = true;
        self.clear();
    }

    /// Mains off: pulses stop and motors coast. What is wired or broken stays.
    pub fn power_off(&mut self, at: Nanos) {
        self.advance(at);
        self.clear();
        self.powered = false;
        for axis in Axis::BOTH {
            self.drives.of_mut(axis).power(false);
        }
    }

    /// RES, G99, clear device: as at power-up (D304).
    pub fn reset(&mut self, at: Nanos) {
        self.power_up(at);
    }

    fn clear(&mut self) {
        self.halt();
        for number in 1..=4 {
            self.inputs.arm(number, None);
        }
        self.registers = Pair::same(0);
        for axis in Axis::BOTH {
            self.drives.of_mut(axis).power(true);
        }
        self.closed = self.switches();
        self.events.clear();
        (self.finished, self.held) = (self.now, 0);
    }

    /// All of the time up to `now`; call it every millisecond, also while switched off.
    pub fn sample(&mut self, now: Nanos) {
        self.advance(now);
        for axis in Axis::BOTH {
            let velocity = self.velocity(axis);
            let before = self.velocities.of(axis).0;
            *self.velocities.of_mut(axis) = (velocity, before);
        }
    }

    /// Begins a move. Whatever an axis of it was doing is ended first.
    pub fn start(&mut self, at: Nanos, order: &Move) {
        self.advance(at);
        let Move { legs, ramp, vector } = order;
        let samples = legs.map(|leg| match (leg, ramp) {
            (Some(leg), Some(ramp)) => ramp::samples(&leg, ramp),
            _ => 0,
        });
        let longest = samples.x.max(samples.y);
        self.ordered = legs.map(|leg| leg.is_some());
        for axis in Axis::BOTH {
            if let Some(leg) = legs.of(axis) {
                let samples = if *vector { longest } else { *samples.of(axis) };
                self.give(axis, Clock::of_leg(leg, ramp.as_ref(), samples), None);
            }
        }
    }

    /// G7, G60, G61: sends the axes that have a feedrate home; hardware home has its own feedrates. The register and
    /// the tracking display of an axis that has found it are 0 (D295).
    pub fn home(&mut self, at: Nanos, feedrates: Pair<Option<Feedrate>>) {
        self.advance(at);
        self.ordered = feedrates.map(|feedrate| feedrate.is_some());
        for axis in Axis::BOTH {
            let Some(asked) = *feedrates.of(axis) else {
                continue;
            };
            let (to_switch, feedrate) = match self.config.home {
                HomeKind::Hardware if *self.config.reversed.of(axis) => {
                    (Direction::Negative, Feedrate::DEFAULT)
                }
                HomeKind::Hardware => (Direction::Positive, Feedrate::DEFAULT),
                HomeKind::Software(directions) => (*directions.of(axis), asked),
            };
            let homing = Homing::begin(to_switch, self.drives.of(axis).at_home());
            let clock = Clock::endless(Job::Home, homing.direction(), feedrate);
            self.give(axis, clock, Some(homing));
        }
    }

    /// An arrow key goes down in slew mode: pulses until [`Indexer::stop_axis`].
    pub fn slew(&mut self, at: Nanos, axis: Axis, direction: Direction, feedrate: Feedrate) {
        self.advance(at);
        self.give(axis, Clock::endless(Job::Slew, direction, feedrate), None);
    }

    /// An arrow key goes down in step mode: one pulse, at once. An axis that is busy or held takes no notice
    /// (D307).
    pub fn step(&mut self, at: Nanos, axis: Axis, direction: Direction) {
        self.advance(at);
        if self.is_busy(axis) || self.is_held() || *self.feedhold.of(axis) {
            return;
        }
        self.give(axis, Clock::single(direction), None);
        let given = self.clocks.of_mut(axis).pass(1);
        self.pulse(axis, given);
        self.look_at_switches();
    }

    /// Slew mode with the joystick: its clocks divided by `divisor` (2 to 65535); `None` ends it. A slew by key
    /// overrides it; a limit disables it until one of its directions changes (3-4 L, 4-10 D).
    pub fn joystick(&mut self, at: Nanos, divisor: Option<u32>) {
        self.advance(at);
        self.joystick.engage(divisor);
        self.follow_joystick();
    }

    /// Ends what an axis does; its register is true.
    pub fn stop_axis(&mut self, at: Nanos, axis: Axis) {
        self.advance(at);
        self.give(axis, Clock::IDLE, None);
        self.follow_joystick();
    }

    /// Ends all moves, homes, slews and counts, and the joystick; registers are true.
    pub fn stop(&mut self, at: Nanos) {
        self.advance(at);
        self.halt();
    }

    /// G20n to G41n: arms input 1 to 4; what was armed on it before is void.
    pub fn arm(&mut self, at: Nanos, input: u8, interrupt: Interrupt, edge: Edge) {
        self.advance(at);
        self.inputs.arm(input, Some((interrupt, edge)));
    }

    /// G321 to G325: disarms input 1 to 4; a hold by it ends.
    pub fn disarm(&mut self, at: Nanos, input: u8) {
        self.advance(at);
        self.inputs.arm(input, None);
    }

    /// `D=`: begins to count falling edges of the external clock; see [`Indexer::counts_left`].
    pub fn count(&mut self, at: Nanos, edges: u64) {
        self.advance(at);
        self.counter.begin(edges);
    }

    /// G10 to G12: the reset pulse to a drive. It takes its fault and its following error away; registers stay.
    pub fn reset_drive(&mut self, at: Nanos, axis: Axis) {
        self.advance(at);
        self.drives.of_mut(axis).reset();
    }

    /// G92: loads a register.
    pub fn preload(&mut self, at: Nanos, axis: Axis, value: i64) {
        self.advance(at);
        *self.registers.of_mut(axis) = value - self.clocks.of(axis).given();
    }

    /// The clear button of a tracking display.
    pub fn clear_tracking(&mut self, at: Nanos, axis: Axis) {
        self.advance(at);
        self.drives.of_mut(axis).clear_tracking();
    }

    /// Changes jumpers. Registers and tracking displays stay.
    pub fn set_config(&mut self, at: Nanos, config: Config) {
        self.advance(at);
        self.config = config;
        self.inputs.debounce(config.debounced);
        for axis in Axis::BOTH {
            let reversed = *config.reversed.of(axis);
            self.drives.of_mut(axis).rebuild(config.drive, reversed);
        }
        self.closed = self.switches();
    }
}
