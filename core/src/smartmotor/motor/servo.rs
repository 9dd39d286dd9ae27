//! One sample: what is outside, the trajectory and the filter, the motor, and what follows from where it is now.

use super::filter::{Demand, ERROR_FRACTION};
use super::{
    Brake, CALL_AT_FAULT, COUNTS_PER_REVOLUTION, DECELERATE_AT_LIMIT, Drive, Flag, Motor, PERIOD,
    filter, trajectory,
};

/// Torque of a unit of the output, as a fraction of the peak.
const TORQUE: f64 = 1.0 / filter::FULL as f64;

impl Motor {
    /// One sample of 245.76 us. `table` is aw[], which MC takes its cam from.
    pub fn sample(&mut self, table: impl Fn(u8) -> i16) {
        self.master += self.counter.sample();
        self.look_outside();
        if self.powered {
            self.watch();
            if self.wait == 0 {
                self.wait = self.divisor;
                self.ticks += 1;
                self.servo(table);
            }
            self.wait -= 1;
        }
        self.apply_brake();
        self.plant.step(f64::from(self.output) * TORQUE);
        self.amplifier.sample(self.plant.torque(), PERIOD);
        self.take_position();
    }

    /// Limits and GO.
    fn look_outside(&mut self) {
        let right = self.broken.right_limit || self.plant.at_positive_limit();
        let left = self.broken.left_limit || self.plant.at_negative_limit();
        self.pins
            .mechanics(right, left, self.plant.at_home(), !self.braked);
        if !self.powered {
            return;
        }
        let before = self.limits;
        self.limits = self.pins.limits();
        if self.limits != (false, false) {
            let began = (self.limits.0 && !before.0) || (self.limits.1 && !before.1);
            self.at_limit(began);
        }
        let go = self.pins.go();
        if go && !self.go {
            self.go();
        }
        self.go = go;
    }

    /// A limit is active. It latches, and stops what goes its way; one that has just become active stops the other
    /// way too, unless LIMD is given (D180). Torque counts as motion.
    fn at_limit(&mut self, began: bool) {
        let (right, left) = self.limits;
        if right {
            self.status |= Flag::RightLimit.mask();
        }
        if left {
            self.status |= Flag::LeftLimit.mask();
        }
        let velocity = match self.drive {
            Drive::Off => return,
            Drive::Torque => i64::from(self.settings.torque),
            Drive::Servo => self.trajectory.velocity(),
        };
        let blocked = (right && velocity > 0) || (left && velocity < 0);
        if blocked || (began && velocity != 0 && !self.settings.directional) {
            self.stop_at_limit();
        }
    }

    /// With F=1 the motor decelerates and holds, otherwise it is switched off (D179).
    fn stop_at_limit(&mut self) {
        if self.drive == Drive::Servo && self.trajectory.is_stopping() {
            return;
        }
        self.call_fault_routine();
        if self.settings.functions & DECELERATE_AT_LIMIT != 0 {
            self.decelerate();
        } else {
            self.switch_off();
        }
    }

    fn call_fault_routine(&mut self) {
        if self.settings.functions & CALL_AT_FAULT != 0 {
            self.fault_call = true;
        }
    }

    /// Heat, current, and what is broken.
    fn watch(&mut self) {
        let was_hot = self.status & Flag::Overheat.mask() != 0;
        let hot = self.amplifier.is_hot(self.settings.trip_temperature);
        if hot != was_hot {
            self.status ^= Flag::Overheat.mask();
        }
        if self.broken.drive || self.amplifier.is_overloaded() {
            self.status |= Flag::OverCurrent.mask();
        }
        if self.drive != Drive::Off && (hot || self.broken.drive || self.broken.emergency_stop) {
            self.trip();
        }
    }

    /// A fault switches the motor off.
    fn trip(&mut self) {
        self.switch_off();
        self.call_fault_routine();
    }

    /// Trajectory and filter.
    fn servo(&mut self, table: impl Fn(u8) -> i16) {
        let master = std::mem::take(&mut self.master);
        match self.drive {
            Drive::Off => {
                self.trajectory.release(self.count, 0);
                self.output = 0;
            }
            Drive::Torque => {
                self.trajectory.release(self.count, 0);
                let amps = self.settings.amps;
                self.output = self.settings.torque.clamp(-amps, amps);
            }
            Drive::Servo => {
                self.follow(master, table);
            }
        }
    }

    fn follow(&mut self, master: i64, table: impl Fn(u8) -> i16) {
        if self.error().abs() > i64::from(self.settings.error_limit) {
            self.status |= Flag::PositionError.mask();
            self.trip();
            return;
        }
        let mut velocity = self
            .trajectory
            .next_velocity(master, &mut self.stream, &table);
        if (self.limits.0 && velocity > 0) || (self.limits.1 && velocity < 0) {
            self.stop_at_limit();
            if self.drive != Drive::Servo {
                return;
            }
            velocity = self.trajectory.next_velocity(0, &mut self.stream, table);
        }
        // Where the trajectory is now; `velocity` leads to where it will be with the next servo sample.
        let fine = self.trajectory.position() >> (trajectory::FRACTION - ERROR_FRACTION);
        self.trajectory.advance(velocity);
        let demand = Demand {
            error: fine - (self.count << ERROR_FRACTION),
            velocity,
            acceleration: self.trajectory.acceleration(),
        };
        self.output = self
            .filter
            .update(&demand, self.settings.amps, self.divisor);
    }

    /// The brake grips as its word says, and whatever that is while the emergency stop is open (D182).
    fn apply_brake(&mut self) {
        let grips = match self.settings.brake {
            Brake::Engaged => true,
            Brake::Released => false,
            Brake::Servo => self.drive == Drive::Off,
            Brake::Trajectory => !self.trajectory.is_active(),
        } || self.broken.emergency_stop;
        if grips != self.braked {
            self.braked = grips;
            self.apply_jam();
        }
    }

    /// The shaft turns unless the brake grips or it is seized.
    pub(super) fn apply_jam(&mut self) {
        self.plant.set_jammed(self.braked || self.broken.shaft);
    }

    /// Where the motor is now: index mark and end of the 32 bits.
    fn take_position(&mut self) {
        let count = self.plant.encoder.count();
        if count == self.count {
            return;
        }
        let turn = i64::from(COUNTS_PER_REVOLUTION);
        let (before, now) = (self.count.div_euclid(turn), count.div_euclid(turn));
        if before != now && self.status & Flag::IndexCaptured.mask() == 0 {
            self.status |= Flag::IndexCaptured.mask();
            self.index = before.max(now) * turn;
        }
        self.count = count;
        let round = count.wrapping_add(self.origin).wrapping_add(1 << 31) >> 32;
        if round != self.round {
            self.round = round;
            self.status |= Flag::Wrap.mask();
        }
    }
}
