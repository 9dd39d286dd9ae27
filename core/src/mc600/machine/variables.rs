//! What a program reads and writes: system variables, and the drive's objects.
//!
//! Source: "The other system variables", "The Drive related functions".

use super::{Machine, OUTPUTS, STANDSTILL, SysVar, to_register};
use crate::mc600::drive::objects::Object;
use crate::mc600::drive::{ENCODER_COUNTS, WARNING_NEGATIVE_LIMIT, WARNING_POSITIVE_LIMIT};
use crate::mc600::planner::units::{saturate, wrap32};

/// `gv_velmot%` of 1 rpm ("The other system variables").
const VELMOT_PER_RPM: f64 = 33_554_432.0 / 240_000.0;
/// `gv_curmot%` at the drive's peak current.
const CURMOT_PEAK: f64 = 3280.0;
/// `gv_status%` bit 7.
const STATUS_WARNING: i32 = 1 << 7;

impl Machine {
    /// The value of a system variable; of an array, that of its first element.
    pub fn get(&self, var: SysVar) -> i32 {
        let planner = &self.planner;
        match var {
            SysVar::Mres => planner.resolution(),
            SysVar::SmAcc => planner.speed_acceleration,
            SysVar::SmFlag => planner.speed_flags(),
            SysVar::SmSpeed => planner.speed_demand(),
            SysVar::MvAcc => planner.moves.acceleration,
            SysVar::MvDec => planner.moves.deceleration,
            SysVar::MvSpeed => planner.moves.speed,
            SysVar::MvFlag => planner.move_flags(),
            SysVar::MinSpeed => planner.moves.merge_speed,
            SysVar::HmFlag => planner.home_flags(),
            SysVar::GvFeedback => planner.reading(self.feedback()),
            SysVar::GvSmod => planner.modulus().0,
            SysVar::SlPosDemand => planner.reading(planner.reference().position),
            SysVar::SlSpdDemand => saturate(planner.reference().velocity),
            SysVar::GvMflag => planner.motion_flags(),
            SysVar::GvStatus => self.status(),
            SysVar::GvCommand => self.drive.command(),
            SysVar::GvIn(number) => self.input_word(number),
            SysVar::GvOut(number) => i32::from(number < OUTPUTS && self.outputs.get(number)),
            SysVar::GvCompare => i32::from(self.comparators.word),
            SysVar::GvCapposf => self.captured_position(0),
            SysVar::GvCappos => self.captured_position(1),
            SysVar::GvCapsel => self.capture_source,
            SysVar::GvCanout => self.bus.sent,
            SysVar::GvCanin => self.bus.received.unwrap_or(0),
            SysVar::CanData => self.mailbox(0).unwrap_or(0),
            SysVar::CanFlag => i32::from(self.bus.flags),
            _ => self
                .get_follower(var)
                .unwrap_or_else(|| self.get_drive(var)),
        }
    }

    /// Gear, cam, phase and master.
    fn get_follower(&self, var: SysVar) -> Option<i32> {
        let planner = &self.planner;
        let (gear, cam, phase) = (&planner.gear, &planner.cam, &planner.phase);
        let master = &planner.master;
        Some(match var {
            SysVar::GrRation => gear.numerator,
            SysVar::GrRatioid => gear.denominator,
            SysVar::GrAcc => gear.acceleration,
            SysVar::GrSpeed => gear.speed,
            SysVar::GrPrepost => gear.prepost,
            SysVar::GrFlag => gear.flags(),
            SysVar::CmCamout => cam.output(planner.modulus()),
            SysVar::CmNum => cam.points,
            SysVar::CmIndex => cam.index(),
            SysVar::CmFlag => cam.flags(),
            SysVar::CmMaster | SysVar::GvMaster => master.word(),
            SysVar::VxAcc => master.axis.acceleration,
            SysVar::VxDec => master.axis.deceleration,
            SysVar::VxSpeed => master.axis.speed,
            SysVar::VxPos => master.axis.reading(),
            SysVar::VxFlag => master.axis_flags(),
            SysVar::VsAcc => master.speed_acceleration,
            SysVar::VsFlag => master.speed_flags(),
            SysVar::VsSpeed => master.speed(),
            SysVar::PhAcc => phase.acceleration,
            SysVar::PhDec => phase.deceleration,
            SysVar::PhSpeed => phase.speed,
            SysVar::PhFlag => phase.flags(),
            SysVar::PhPosition => phase.reading(),
            SysVar::GvEncoder => master.encoder.count(),
            SysVar::GvEncspeed => master.encoder.speed(),
            SysVar::GvMmod => master.modulus(),
            _ => return None,
        })
    }

    /// What the drive measures and keeps.
    fn get_drive(&self, var: SysVar) -> i32 {
        match var {
            SysVar::GvError => self.drive.error_code().cast_signed(),
            SysVar::GvWarning => self.warnings().cast_signed(),
            SysVar::GvTrjstat => self.trajectory_status().cast_signed(),
            SysVar::GvAnin1 => self.analog.inputs[0],
            SysVar::GvAnin2 => self.analog.inputs[1],
            SysVar::GvMonitor1 => self.analog.monitors[0],
            SysVar::GvMonitor2 => self.analog.monitors[1],
            SysVar::GvLatch1 | SysVar::GvLatch1n | SysVar::GvLatch2 | SysVar::GvLatch2n => {
                self.latch(var)
            }
            SysVar::GvVelmot => {
                saturate(to_register(self.plant.velocity() * 60.0 * VELMOT_PER_RPM))
            }
            SysVar::GvCurmot => saturate(to_register(self.drive.output() * CURMOT_PEAK)),
            SysVar::GvUsvar(number) => self.drive.objects.get(Object::Dprvar(number)),
            _ => 0,
        }
    }

    /// Assigns a system variable. Those that cannot be assigned stay as they are.
    pub fn set(&mut self, var: SysVar, value: i32) {
        let planner = &mut self.planner;
        match var {
            SysVar::Mres => {
                let before = planner.resolution();
                planner.set_resolution(value);
                if planner.resolution() != before {
                    self.drive.rescale(before == 0);
                }
            }
            SysVar::SmAcc => planner.speed_acceleration = value,
            SysVar::MvAcc => planner.moves.acceleration = value,
            SysVar::MvDec => planner.moves.deceleration = value,
            SysVar::MvSpeed => planner.moves.speed = value,
            SysVar::MvFlag => planner.moves.set_flags(value),
            SysVar::MinSpeed => planner.moves.merge_speed = value,
            SysVar::GvSmod => {
                let shift = planner.set_modulus(value);
                self.drive.shift(shift);
                self.feedback_before = self.feedback_before.wrapping_add(shift);
            }
            SysVar::GvMmod => planner.set_master_modulus(value),
            SysVar::GvCommand => self.drive.set_command(value),
            SysVar::GvOut(number) if number < OUTPUTS => self.outputs.set(number, value != 0),
            SysVar::GvCapsel => self.select_capture(value),
            SysVar::CanFlag => self.bus.flags = value.to_le_bytes()[0],
            SysVar::GvMonitor1 => self.analog.monitors[0] = value.clamp(-10_000, 10_000),
            SysVar::GvMonitor2 => self.analog.monitors[1] = value.clamp(-10_000, 10_000),
            SysVar::GvUsvar(number @ 1..=8) => self.drive.objects.set_user(number, value),
            _ => self.set_follower(var, value),
        }
    }

    /// Gear, cam, phase and master.
    fn set_follower(&mut self, var: SysVar, value: i32) {
        let planner = &mut self.planner;
        let (gear, master) = (&mut planner.gear, &mut planner.master);
        match var {
            SysVar::GrRation => gear.numerator = value,
            SysVar::GrRatioid => gear.denominator = value,
            SysVar::GrAcc => gear.acceleration = value,
            SysVar::GrSpeed => gear.speed = value,
            SysVar::GrPrepost => gear.prepost = value,
            SysVar::CmNum => planner.cam.points = value,
            SysVar::VxAcc => master.axis.acceleration = value,
            SysVar::VxDec => master.axis.deceleration = value,
            SysVar::VxSpeed => master.axis.speed = value,
            SysVar::VxFlag => master.set_axis_flags(value),
            SysVar::VsAcc => master.speed_acceleration = value,
            SysVar::PhAcc => planner.phase.acceleration = value,
            SysVar::PhDec => planner.phase.deceleration = value,
            SysVar::PhSpeed => planner.phase.speed = value,
            _ => {}
        }
    }

    /// `can_data%(number)`; `None` for a mailbox that the card does not have.
    pub fn mailbox(&self, number: usize) -> Option<i32> {
        self.bus.data(number)
    }

    /// `gv_warning%`: STATCODE.
    fn warnings(&self) -> u32 {
        let blocked = self.blocked();
        let warning = |on: bool, bit: u32| if on { bit } else { 0 };
        warning(blocked.forward, WARNING_POSITIVE_LIMIT)
            | warning(blocked.reverse, WARNING_NEGATIVE_LIMIT)
    }

    pub(super) fn status(&self) -> i32 {
        let warning = if self.warnings() != 0 {
            STATUS_WARNING
        } else {
            0
        };
        self.drive.status(&self.conditions()) | warning | self.planner.status()
    }

    /// `gv_trjstat%`: TRJSTAT (D217).
    fn trajectory_status(&self) -> u32 {
        let homing = self.planner.is_homing();
        let moving = self.planner.reference().velocity != 0;
        let enabled = self.drive.is_enabled();
        let taken = |latch: u8| self.latches.taken & 1 << latch != 0;
        let bits = [
            (0, homing),
            (2, taken(3)),
            (3, self.drive.is_stopping()),
            (4, taken(0)),
            (5, taken(1)),
            (7, self.planner.is_homed()),
            (16, moving),
            (17, self.planner.is_homed()),
            (18, self.plant.at_home()),
            (19, enabled && !moving && !self.drive.is_settling()),
            (20, taken(2)),
            (26, true),
            (28, (self.plant.velocity() * 60.0).abs() < STANDSTILL),
            (30, enabled),
            (31, self.drive.error_code() != 0),
        ];
        bits.iter()
            .fold(0, |word, &(bit, on)| word | u32::from(on) << bit)
    }

    /// `sdoread`: 0 for what cannot be read.
    pub fn read_object(&mut self, number: i32) -> i32 {
        match self.drive.objects.reading(number) {
            None => 0,
            Some(Object::Pfb) => {
                let turn = self.planner.units_per_revolution();
                let base = 1i128 << self.drive.objects.get(Object::Prbase);
                let scaled = (i128::from(self.feedback()) * base).div_euclid(i128::from(turn));
                wrap32(i64::try_from(scaled).unwrap_or(0))
            }
            Some(Object::Prd) => wrap32(
                self.plant
                    .encoder
                    .count()
                    .rem_euclid(i64::from(ENCODER_COUNTS)),
            ),
            Some(Object::Status) => self.status(),
            Some(Object::Drvstat) => self.warnings().cast_signed(),
            Some(object) => self.drive.objects.get(object),
        }
    }

    /// `sdowrite`.
    pub fn write_object(&mut self, number: i32, value: i32) {
        let enabled = self.drive.is_enabled();
        if self.drive.objects.write(number, value, enabled) {
            self.drive.tune();
        }
    }

    /// `sdoerror`.
    pub fn object_error(&self) -> i32 {
        self.drive.objects.error()
    }
}
