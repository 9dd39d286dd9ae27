//! The motion planner: the position and speed reference of each 2 ms sample.
//!
//! Source: "The Motion planner", "The Motion functions". The manual's block diagram is the reading order of
//! [`Planner::sample`]: master, one trajectory generator, phase. A file for each block: `master` with its `encoder`,
//! `moves` (targets), `gear`, `cam`, `home`; `spline` makes a cam's table.

pub mod cam;
pub mod encoder;
pub mod gear;
pub mod home;
pub mod master;
pub mod moves;
mod report;
pub mod spline;
#[cfg(test)]
mod tests;
pub mod units;

use crate::motion::ramp::{next_velocity_to_speed, next_velocity_to_target};
use cam::{Cam, Table};
use encoder::Encoder;
use gear::{Gear, GearType};
use home::{Home, Homing, Step, Surroundings};
use master::Master;
use moves::{Moves, Offset};
use units::{FRACTION, Modulus, counts, wrap32};

/// Acceleration of every generator at power-up: 1 rpm/ms (D61), in counts*256/sample².
const POWER_UP_ACCELERATION: i32 = 70;
/// Speed of every generator at power-up: 1000 rpm (D61), in counts*256/sample.
const POWER_UP_SPEED: i32 = 34_952;
/// Deceleration of an emergency stop (D67; the drive's own parameter is not in the manual). 1 rpm/ms is the
/// 15000th part of a revolution per sample².
const EMERGENCY_RPM_PER_MS: i64 = 20;

/// What drives the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Generator {
    /// Nothing: the reference rests.
    Idle,
    /// The speed generator at speed 0, on the way to idle: `midle`, or an emergency stop with its own ramp.
    Stop { emergency: bool },
    /// `mspeed`, in counts*256/sample.
    Speed { demand: i64 },
    /// `mmove` and `mimove`, to a target in 1/256 count on the planner's unwrapped scale; `mmerge` and `mimerge` with
    /// the speed that they keep.
    Move { target: i64, merge: Option<i64> },
    /// `mgear`.
    Gear,
    /// `mcam`, `mcamhard`.
    Cam,
    /// `mhome`.
    Home(Home),
}

/// Directions that a limit switch forbids.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Blocked {
    /// No positive speed.
    pub forward: bool,
    /// No negative speed.
    pub reverse: bool,
}

impl Blocked {
    fn stops(self, velocity: i64) -> bool {
        (self.forward && velocity > 0) || (self.reverse && velocity < 0)
    }
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

impl Reference {
    fn advance(&mut self, velocity: i64) {
        self.acceleration = velocity - self.velocity;
        self.velocity = velocity;
        self.position = self.position.wrapping_add(velocity);
    }
}

/// The planner's state and its variables.
///
/// Internally positions never wrap, which keeps every generator plain arithmetic; they are wrapped where a program
/// reads or gives one ([`Planner::reading`]).
#[derive(Debug, Clone, PartialEq)]
pub struct Planner {
    /// `sm_acc%`.
    pub speed_acceleration: i32,
    /// Of `mmove` and `mmerge`.
    pub moves: Moves,
    /// Of `mgear`.
    pub gear: Gear,
    /// Of `mcam`.
    pub cam: Cam,
    /// Encoder, virtual axis and virtual speed.
    pub master: Master,
    /// Of `mphase`: added to what the generator gives, whichever that is (D214).
    pub phase: Offset,
    /// `gv_smod%`.
    modulus: Modulus,
    /// `mres%` is 1.
    fine: bool,
    /// Of the active generator, without the phase.
    base: Reference,
    /// What the drive follows.
    reference: Reference,
    generator: Generator,
    /// `gv_mflag%` bit 0.
    final_position: bool,
    /// The last homing ended well.
    homed: bool,
    /// The cam's master passed the end of its modulus in the last sample.
    cam_passed_zero: bool,
}

impl Planner {
    /// As at power-up, with an encoder that may turn already.
    pub fn new(mut encoder: Encoder) -> Planner {
        let rest = Reference {
            position: 0,
            velocity: 0,
            acceleration: 0,
        };
        encoder.reset();
        Planner {
            speed_acceleration: POWER_UP_ACCELERATION,
            moves: Moves::new(),
            gear: Gear::new(),
            cam: Cam::new(),
            master: Master::new(encoder),
            phase: Offset::new(),
            modulus: Modulus::default(),
            fine: false,
            base: rest,
            reference: rest,
            generator: Generator::Idle,
            final_position: false,
            homed: false,
            cam_passed_zero: false,
        }
    }

    /// The master's part of a sample, which does not need the drive; with the last position from the ServoBus.
    pub fn sample_master(&mut self, bus: Option<i32>) {
        self.master.sample(bus);
        self.cam_passed_zero = false;
    }

    /// One sample of the axis, behind the master's. Gives by how much the scale of positions moves (1/256 count) when
    /// homing has ended with it.
    pub fn sample(&mut self, blocked: Blocked, around: &Surroundings) -> i64 {
        if self.generator == Generator::Idle && self.base.velocity != 0 {
            // The drive was enabled while the motor turned (it is stopped like any other motion, D74).
            self.generator = Generator::Stop { emergency: false };
        }
        let (homing, shift) = self.home(around);
        let mut velocity = homing.unwrap_or_else(|| self.next_velocity());
        let phase = self.phase.sample();
        if blocked.stops(velocity + phase) && homing.is_none() {
            self.emergency_stop();
            velocity = self.next_velocity();
        }
        self.base.advance(velocity);
        let before = self.reference.velocity;
        self.reference = Reference {
            position: self.base.position.wrapping_add(self.phase.position()),
            velocity: velocity + phase,
            acceleration: velocity + phase - before,
        };
        self.finish();
        shift
    }

    fn next_velocity(&mut self) -> i64 {
        let velocity = self.base.velocity;
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
            Generator::Move { target, merge } => next_velocity_to_target(
                velocity,
                target.wrapping_sub(self.base.position),
                &self.moves.limits(merge),
            ),
            Generator::Gear => self.gear.next_velocity(velocity, self.master.velocity()),
            Generator::Cam => self.cam_velocity(),
            Generator::Home(_) => velocity,
        }
    }

    fn cam_velocity(&mut self) -> i64 {
        let step = self.cam.next(
            self.base.velocity,
            self.base.position,
            &self.master.of_cam(),
            self.modulus,
            self.speed_acceleration,
            &self.phase,
        );
        self.cam_passed_zero = step.passed_zero;
        if step.ends {
            self.take_over(Generator::Stop { emergency: false });
        }
        step.velocity
    }

    /// The velocity that homing wants, if it is active, and by how much it moves the scale of positions.
    fn home(&mut self, around: &Surroundings) -> (Option<i64>, i64) {
        let Generator::Home(mut home) = self.generator else {
            return (None, 0);
        };
        let step = home.next(self.base.velocity, self.base.position, around);
        self.generator = Generator::Home(home);
        match step {
            Step::Go(velocity) => (Some(velocity), 0),
            Step::Yield => {
                self.base.position = around.feedback;
                (Some(0), 0)
            }
            Step::Done(position) => {
                self.generator = Generator::Idle;
                self.homed = true;
                let here = self.base.position;
                let shift = position.map_or(0, |position| position.wrapping_sub(here));
                self.base.position = here.wrapping_add(shift);
                (Some(0), shift)
            }
            Step::Failed => {
                self.take_over(Generator::Stop { emergency: true });
                (None, 0)
            }
        }
    }

    /// A generator that has done its work gives way to idle (D69 for a move: bit 13 is reset with the bit that
    /// says that no move is active).
    fn finish(&mut self) {
        let at_rest = self.base.velocity == 0;
        match self.generator {
            Generator::Stop { .. } if at_rest => self.generator = Generator::Idle,
            Generator::Move { target, .. } if at_rest && target == self.base.position => {
                self.generator = Generator::Idle;
                self.final_position = true;
            }
            _ => {}
        }
    }

    /// Another generator takes over, whatever was active.
    fn take_over(&mut self, generator: Generator) {
        self.gear.release();
        self.cam.release();
        self.generator = generator;
    }

    /// A motion command takes over.
    fn start(&mut self, generator: Generator) {
        self.final_position = false;
        self.take_over(generator);
    }

    /// Takes the reference from the axis, while the drive does not follow it: position in 1/256 count, velocity in
    /// counts*256/sample.
    pub fn follow(&mut self, position: i64, velocity: i64) {
        self.reference = Reference {
            position,
            velocity,
            acceleration: 0,
        };
        self.base = Reference {
            position: position.wrapping_sub(self.phase.position()),
            ..self.reference
        };
    }

    /// `mspeed`, in counts*256/sample.
    pub fn speed(&mut self, demand: i32) {
        self.start(Generator::Speed {
            demand: i64::from(demand),
        });
    }

    /// `mmove`, or `mmerge`, in counts.
    pub fn move_to(&mut self, position: i32, merge: bool) {
        let here = counts(self.base.position);
        let velocity = self.base.velocity;
        let distance = self.moves.distance(position, here, self.modulus, velocity);
        self.start_move(here + distance, merge);
    }

    /// `mimove`, or `mimerge`, in counts: added to the target of a move that is active, else to the present reference.
    pub fn move_by(&mut self, distance: i32, merge: bool) {
        let here = counts(self.base.position);
        let target = match self.generator {
            Generator::Move { target, .. } => counts(target),
            _ => here,
        };
        let way = i64::from(wrap32(target - here + i64::from(distance)));
        self.start_move(here + way, merge);
    }

    fn start_move(&mut self, target: i64, merge: bool) {
        let merge = merge.then(|| self.moves.merge_speed(self.base.velocity));
        self.start(Generator::Move {
            target: target << FRACTION,
            merge,
        });
    }

    /// `mgear`. Until the edge that it waits for, what is active goes on (D192).
    pub fn follow_master(&mut self, kind: GearType) {
        if self.gear.request(kind) {
            self.engage_gear(0, 0);
        }
    }

    /// An edge of input 3, since which some part of the last sample has passed (0 none, 1 all of it).
    pub fn gear_edge(&mut self, rising: bool, passed: f64) {
        if self.gear.waits_for(rising) {
            let part = |way: i64| whole(way as f64 * passed);
            self.engage_gear(part(self.base.velocity), part(self.master.velocity()));
        }
    }

    fn engage_gear(&mut self, moved: i64, master: i64) {
        self.final_position = false;
        self.cam.release();
        self.generator = Generator::Gear;
        self.gear.engage(moved, master);
    }

    /// `mcam`, or `mcamhard`.
    pub fn follow_cam(&mut self, table: Table, hard: bool) {
        self.final_position = false;
        self.gear.release();
        self.generator = Generator::Cam;
        let master = self.master.of_cam();
        self.cam.engage(table, hard, &master, self.modulus);
    }

    /// `mhome(1)`, which only an idle planner takes. What the phase has added becomes part of the position (D200).
    pub fn start_homing(&mut self, homing: Homing, around: &Surroundings) {
        if self.generator == Generator::Idle && !self.phase.is_active() {
            self.homed = false;
            self.phase.clear();
            self.base = self.reference;
            if matches!(homing.kind, 0 | 6) {
                // The following error is lost (D199).
                self.base.position = around.feedback;
            }
            self.start(Generator::Home(Home::new(homing, around)));
        }
    }

    /// `mhome(2)`.
    pub fn abort_homing(&mut self) {
        if matches!(self.generator, Generator::Home(_)) {
            self.take_over(Generator::Stop { emergency: false });
        }
    }

    /// Whether homing pushes against a mechanical stop.
    pub fn pushes(&self) -> bool {
        matches!(self.generator, Generator::Home(home) if home.pushes())
    }

    /// `midle`: decelerates to zero by `sm_acc%`, then holds. An emergency stop goes on.
    pub fn idle(&mut self) {
        if !matches!(self.generator, Generator::Idle | Generator::Stop { .. }) {
            self.take_over(Generator::Stop { emergency: false });
        }
        self.gear.release();
    }

    /// Gives up what is active and stops as fast as the drive may.
    pub fn emergency_stop(&mut self) {
        self.phase.abort();
        self.take_over(Generator::Stop { emergency: true });
    }

    /// Gives up what is active where it is; for a drive that no longer follows.
    pub fn abort(&mut self) {
        self.phase.abort();
        self.take_over(Generator::Idle);
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
        for reference in [&mut self.base, &mut self.reference] {
            *reference = Reference {
                position: scale(reference.position),
                velocity: scale(reference.velocity),
                acceleration: scale(reference.acceleration),
            };
        }
        self.phase.rescale(scale);
        self.abort_homing();
        if let Generator::Move { target, .. } = &mut self.generator {
            *target = counts(scale(*target)) << FRACTION;
        }
    }

    /// Sets `gv_smod%`; 0 or less is no modulus. Positions first become what they read as, and the difference, in
    /// 1/256 count, is returned for the drive to apply too.
    pub fn set_modulus(&mut self, modulus: i32) -> i64 {
        let shift = self.modulus.shift(self.reference.position);
        self.base.position += shift;
        self.reference.position += shift;
        match &mut self.generator {
            Generator::Move { target, .. } => *target += shift,
            Generator::Home(home) => home.shift(shift),
            _ => {}
        }
        self.modulus = Modulus(modulus);
        shift
    }

    /// Sets `gv_mmod%`.
    pub fn set_master_modulus(&mut self, modulus: i32) {
        self.master.set_modulus(modulus);
        self.cam.rebase(&self.master.of_cam());
    }
}

/// A way in 1/256 count without its fraction.
#[allow(clippy::cast_possible_truncation)] // `as` saturates
fn whole(way: f64) -> i64 {
    way as i64
}
