//! The motion planner: the position and speed reference of each 2 ms sample.
//!
//! Source: "The Motion planner", "The Motion functions". One variant of [`Generator`] and one arm of
//! `Planner::next_velocity` for each trajectory generator; what is added to the reference besides (phasing) belongs
//! into `Planner::sample`.

use crate::motion::ramp::{
    RampLimits, next_velocity_to_speed, next_velocity_to_target, stopping_distance,
};

/// Bits of a fraction of a count in a position, and of a count per sample in a speed.
const FRACTION: u32 = 8;

/// Acceleration of every generator at power-up: 1 rpm/ms (D61), in counts*256/sample².
const POWER_UP_ACCELERATION: i32 = 70;
/// Speed of every generator at power-up: 1000 rpm (D61), in counts*256/sample.
const POWER_UP_SPEED: i32 = 34_952;
/// Deceleration of an emergency stop (D67; the drive's own parameter is not in the manual). 1 rpm/ms is the
/// 15000th part of a revolution per sample².
const EMERGENCY_RPM_PER_MS: i64 = 20;

/// `mv_flag%` bit 4: moves go in the positive direction.
const ALWAYS_POSITIVE: i32 = 1 << 4;
/// `mv_flag%` bit 5: moves go in the negative direction.
const ALWAYS_NEGATIVE: i32 = 1 << 5;
/// `mv_flag%` bit 6: moves go the shortest way.
const SHORTEST: i32 = 1 << 6;

const STATUS_IDLE: i32 = 1 << 10;
const STATUS_SPEED: i32 = 1 << 11;
const STATUS_MOVE: i32 = 1 << 13;

/// What drives the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Generator {
    /// Nothing: the reference rests.
    Idle,
    /// The speed generator at speed 0, on the way to idle: `midle`, or an emergency stop with its own ramp.
    Stop { emergency: bool },
    /// `mspeed`, in counts*256/sample.
    Speed { demand: i64 },
    /// `mmove` and `mimove`, to a target in 1/256 count on the planner's unwrapped scale.
    Move { target: i64 },
}

/// Directions that a limit switch forbids.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Blocked {
    /// No positive speed.
    pub forward: bool,
    /// No negative speed.
    pub reverse: bool,
}

/// The reference that the drive follows during one sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reference {
    /// At the end of the sample, in 1/256 count, unwrapped.
    pub position: i64,
    /// Moved by in the sample, in 1/256 count.
    pub velocity: i64,
    /// Change of the velocity since the last sample.
    pub acceleration: i64,
}

/// The planner's state and its variables.
///
/// Internally positions never wrap, which keeps every generator plain arithmetic; they are wrapped where a program
/// reads or gives one ([`Planner::reading`]).
#[derive(Debug, Clone, PartialEq)]
pub struct Planner {
    /// `sm_acc%`.
    pub speed_acceleration: i32,
    /// `mv_acc%`.
    pub move_acceleration: i32,
    /// `mv_dec%`.
    pub move_deceleration: i32,
    /// `mv_speed%`.
    pub move_speed: i32,
    /// Bits 4 to 6 of `mv_flag%`.
    direction: i32,
    /// `gv_smod%`.
    modulus: i32,
    /// `mres%` is 1.
    fine: bool,
    reference: Reference,
    generator: Generator,
    /// `gv_mflag%` bit 0.
    final_position: bool,
}

impl Planner {
    /// As at power-up.
    pub fn new() -> Planner {
        Planner {
            speed_acceleration: POWER_UP_ACCELERATION,
            move_acceleration: POWER_UP_ACCELERATION,
            move_deceleration: POWER_UP_ACCELERATION,
            move_speed: POWER_UP_SPEED,
            direction: 0,
            modulus: 0,
            fine: false,
            reference: Reference {
                position: 0,
                velocity: 0,
                acceleration: 0,
            },
            generator: Generator::Idle,
            final_position: false,
        }
    }

    /// One sample.
    pub fn sample(&mut self, blocked: Blocked) {
        if self.generator == Generator::Idle && self.reference.velocity != 0 {
            // The drive was enabled while the motor turned (it is stopped like any other motion, D74).
            self.generator = Generator::Stop { emergency: false };
        }
        let mut velocity = self.next_velocity();
        if (blocked.forward && velocity > 0) || (blocked.reverse && velocity < 0) {
            self.emergency_stop();
            velocity = self.next_velocity();
        }
        self.reference.acceleration = velocity - self.reference.velocity;
        self.reference.velocity = velocity;
        self.reference.position = self.reference.position.wrapping_add(velocity);
        self.finish();
    }

    fn next_velocity(&self) -> i64 {
        let velocity = self.reference.velocity;
        let acceleration = i64::from(self.speed_acceleration);
        match self.generator {
            Generator::Idle => 0,
            Generator::Stop { emergency: false } => {
                next_velocity_to_speed(velocity, 0, acceleration, acceleration)
            }
            Generator::Stop { emergency: true } => {
                let deceleration = EMERGENCY_RPM_PER_MS * self.units_per_revolution() / 15_000;
                next_velocity_to_speed(velocity, 0, deceleration, deceleration)
            }
            Generator::Speed { demand } => {
                next_velocity_to_speed(velocity, demand, acceleration, acceleration)
            }
            Generator::Move { target } => {
                let limits = RampLimits {
                    speed: i64::from(self.move_speed),
                    acceleration: i64::from(self.move_acceleration),
                    deceleration: i64::from(self.move_deceleration),
                };
                next_velocity_to_target(
                    velocity,
                    target.wrapping_sub(self.reference.position),
                    &limits,
                )
            }
        }
    }

    /// A generator that has done its work gives way to idle (D69 for a move: bit 13 is reset with the bit that
    /// says that no move is active).
    fn finish(&mut self) {
        let at_rest = self.reference.velocity == 0;
        match self.generator {
            Generator::Stop { .. } if at_rest => self.generator = Generator::Idle,
            Generator::Move { target } if at_rest && target == self.reference.position => {
                self.generator = Generator::Idle;
                self.final_position = true;
            }
            _ => {}
        }
    }

    /// Takes the reference from the axis, while the drive does not follow it: position in 1/256 count, velocity in
    /// counts*256/sample.
    pub fn follow(&mut self, position: i64, velocity: i64) {
        self.reference = Reference {
            position,
            velocity,
            acceleration: 0,
        };
    }

    /// `mspeed`, in counts*256/sample.
    pub fn speed(&mut self, demand: i32) {
        self.final_position = false;
        self.generator = Generator::Speed {
            demand: i64::from(demand),
        };
    }

    /// `mmove`, in counts. Without a modulus the way is the 32-bit difference; with one the target is taken into it
    /// and reached as the direction bits say, without them on the way that does not pass 0 (D72).
    pub fn move_to(&mut self, position: i32) {
        let (position, here) = (i64::from(position), counts(self.reference.position));
        let distance = match self.modulus() {
            Some(modulus) => self.modular_distance(position, here, modulus),
            None => i64::from(wrap32(position - here)),
        };
        self.start_move(here + distance);
    }

    /// `mimove`, in counts: added to the target of a move that is active, else to the present reference.
    pub fn move_by(&mut self, distance: i32) {
        let here = counts(self.reference.position);
        let target = match self.generator {
            Generator::Move { target } => counts(target),
            _ => here,
        };
        self.start_move(here + i64::from(wrap32(target - here + i64::from(distance))));
    }

    fn start_move(&mut self, target: i64) {
        self.final_position = false;
        self.generator = Generator::Move {
            target: target << FRACTION,
        };
    }

    fn modular_distance(&self, position: i64, here: i64, modulus: i64) -> i64 {
        let forward = (position - here).rem_euclid(modulus);
        if self.direction & ALWAYS_POSITIVE != 0 {
            forward + self.turns_to_stop(forward, 1, modulus)
        } else if self.direction & ALWAYS_NEGATIVE != 0 {
            let reverse = (here - position).rem_euclid(modulus);
            -(reverse + self.turns_to_stop(reverse, -1, modulus))
        } else if self.direction & SHORTEST != 0 {
            if forward * 2 <= modulus {
                forward
            } else {
                forward - modulus
            }
        } else {
            position.rem_euclid(modulus) - here.rem_euclid(modulus)
        }
    }

    /// Counts of whole turns to add to a `distance` in a fixed `direction`, so that the axis need not turn round
    /// because it is too fast to stop there.
    fn turns_to_stop(&self, distance: i64, direction: i64, modulus: i64) -> i64 {
        let velocity = self.reference.velocity * direction;
        if velocity <= 0 || self.move_deceleration <= 0 {
            return 0;
        }
        let stopping = stopping_distance(velocity, i64::from(self.move_deceleration));
        let missing = (stopping >> FRACTION) + 1 - distance;
        if missing <= 0 {
            0
        } else {
            (missing + modulus - 1) / modulus * modulus
        }
    }

    /// `midle`: decelerates to zero by `sm_acc%`, then holds. An emergency stop goes on.
    pub fn idle(&mut self) {
        if !matches!(self.generator, Generator::Idle | Generator::Stop { .. }) {
            self.generator = Generator::Stop { emergency: false };
        }
    }

    /// Gives up what is active and stops as fast as the drive may.
    pub fn emergency_stop(&mut self) {
        self.generator = Generator::Stop { emergency: true };
    }

    /// Gives up what is active where it is; for a drive that no longer follows.
    pub fn abort(&mut self) {
        self.generator = Generator::Idle;
    }

    /// What the drive follows.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// Whether the reference moves or is going to. The speed generator may stay active at speed 0, which is rest.
    pub fn is_moving(&self) -> bool {
        match self.generator {
            Generator::Idle => false,
            Generator::Speed { demand } => demand != 0 || self.reference.velocity != 0,
            Generator::Stop { .. } | Generator::Move { .. } => true,
        }
    }

    /// Positions per motor revolution, in 1/256 count.
    pub fn units_per_revolution(&self) -> i64 {
        (if self.fine { 65_536 } else { 4096 }) << FRACTION
    }

    /// `mres%`.
    pub fn resolution(&self) -> i32 {
        i32::from(self.fine)
    }

    /// Sets `mres%`: 0 is 4096 counts a revolution, anything else 65536 (D71). The axis stays where it is, so the
    /// positions change their numbers; speeds and accelerations that were set keep theirs.
    pub fn set_resolution(&mut self, resolution: i32) {
        let fine = resolution != 0;
        if fine == self.fine {
            return;
        }
        let scale = |value: i64| {
            if fine {
                value.wrapping_mul(16)
            } else {
                value / 16
            }
        };
        self.fine = fine;
        let Reference {
            position,
            velocity,
            acceleration,
        } = self.reference;
        self.reference = Reference {
            position: scale(position),
            velocity: scale(velocity),
            acceleration: scale(acceleration),
        };
        if let Generator::Move { target } = self.generator {
            self.generator = Generator::Move {
                target: counts(scale(target)) << FRACTION,
            };
        }
    }

    /// `gv_smod%`.
    pub fn modulus_word(&self) -> i32 {
        self.modulus
    }

    /// Sets `gv_smod%`; 0 or less is no modulus. Positions first become what they read as, and the difference, in
    /// 1/256 count, is returned for the drive to apply too.
    pub fn set_modulus(&mut self, modulus: i32) -> i64 {
        let here = counts(self.reference.position);
        let shift = (i64::from(self.wrap(here)) - here) << FRACTION;
        self.reference.position += shift;
        if let Generator::Move { target } = self.generator {
            self.generator = Generator::Move {
                target: target + shift,
            };
        }
        self.modulus = modulus;
        shift
    }

    fn modulus(&self) -> Option<i64> {
        (self.modulus > 0).then_some(i64::from(self.modulus))
    }

    fn wrap(&self, counts: i64) -> i32 {
        wrap32(
            self.modulus()
                .map_or(counts, |modulus| counts.rem_euclid(modulus)),
        )
    }

    /// A position in 1/256 count as a program reads it: in counts, wrapped to the modulus or to 32 bits.
    pub fn reading(&self, position: i64) -> i32 {
        self.wrap(counts(position))
    }

    /// The planner's bits of `gv_status%`.
    pub fn status(&self) -> i32 {
        match self.generator {
            Generator::Idle => STATUS_IDLE,
            Generator::Stop { .. } | Generator::Speed { .. } => STATUS_SPEED,
            Generator::Move { .. } => STATUS_MOVE,
        }
    }

    fn at_speed(&self) -> bool {
        matches!(self.generator, Generator::Speed { demand } if demand == self.reference.velocity)
    }

    fn speed_contributes(&self) -> bool {
        matches!(
            self.generator,
            Generator::Stop { .. } | Generator::Speed { .. }
        )
    }

    /// `gv_mflag%`. Bit 0 stays until the next motion (D69).
    pub fn motion_flags(&self) -> i32 {
        i32::from(self.final_position) | i32::from(self.at_speed()) << 2
    }

    /// `sm_flag%`.
    pub fn speed_flags(&self) -> i32 {
        i32::from(!self.speed_contributes()) | i32::from(self.at_speed()) << 2
    }

    /// `sm_speed%`; 0 while the speed generator is not active (D70).
    pub fn speed_demand(&self) -> i32 {
        if self.speed_contributes() {
            saturate(self.reference.velocity)
        } else {
            0
        }
    }

    /// `mv_flag%`.
    pub fn move_flags(&self) -> i32 {
        i32::from(!matches!(self.generator, Generator::Move { .. })) | self.direction
    }

    /// Sets the direction bits of `mv_flag%`, for the next move; the others report.
    pub fn set_move_flags(&mut self, flags: i32) {
        self.direction = flags & (ALWAYS_POSITIVE | ALWAYS_NEGATIVE | SHORTEST);
    }
}

impl Default for Planner {
    fn default() -> Planner {
        Planner::new()
    }
}

/// The nearest whole count.
fn counts(position: i64) -> i64 {
    position.wrapping_add(1 << (FRACTION - 1)) >> FRACTION
}

#[allow(clippy::cast_possible_truncation)] // wrapping is what the device's registers do
fn wrap32(value: i64) -> i32 {
    value as i32
}

/// A 64-bit value in a 32-bit register that does not wrap.
pub fn saturate(value: i64) -> i32 {
    i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(counts: i64) -> Planner {
        let mut planner = Planner::new();
        planner.follow(counts << FRACTION, 0);
        planner
    }

    /// Where the axis went, in counts.
    fn finish(planner: &mut Planner) -> i64 {
        let start = planner.reference.position;
        while planner.is_moving() {
            planner.sample(Blocked::default());
        }
        (planner.reference.position - start) >> FRACTION
    }

    fn here(planner: &Planner) -> i32 {
        planner.reading(planner.reference.position)
    }

    #[test]
    fn positions_wrap_at_32_bits() {
        let mut planner = at(i64::from(i32::MAX));
        planner.move_by(10);
        assert_eq!(finish(&mut planner), 10);
        assert_eq!(here(&planner), i32::MIN + 9);
        planner.move_to(i32::MAX - 5);
        assert_eq!(
            finish(&mut planner),
            -15,
            "the shorter way, across the wrap"
        );
        assert_eq!(here(&planner), i32::MAX - 5);
    }

    #[test]
    fn a_distance_that_does_not_fit_32_bits_wraps() {
        let mut planner = at(0);
        planner.move_by(i32::MAX);
        planner.move_by(i32::MAX);
        assert_eq!(finish(&mut planner), -2);
    }

    #[test]
    fn a_move_lands_on_a_whole_count_wherever_it_starts() {
        let mut planner = at(0);
        planner.follow(1000 * 256 + 77, 12_345);
        planner.move_to(4000);
        finish(&mut planner);
        assert_eq!(planner.reference.position, 4000 << FRACTION);
    }

    #[test]
    fn without_acceleration_nothing_moves_until_it_is_set() {
        let mut planner = at(0);
        planner.move_acceleration = 0;
        planner.move_to(500);
        (0..100).for_each(|_| planner.sample(Blocked::default()));
        assert_eq!((here(&planner), planner.status()), (0, STATUS_MOVE));
        planner.move_acceleration = 70;
        assert_eq!(finish(&mut planner), 500);
    }
}
