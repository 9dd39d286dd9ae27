//! What the planner reports: positions as a program reads them, and the flags of every generator.

use super::units::{FRACTION, Modulus, saturate};
use super::{Generator, Planner, Reference};
use crate::controller::CamTable;

const STATUS_IDLE: i32 = 1 << 10;
const STATUS_SPEED: i32 = 1 << 11;
const STATUS_GEAR: i32 = 1 << 12;
const STATUS_MOVE: i32 = 1 << 13;
const STATUS_CAM: i32 = 1 << 14;
const STATUS_HOME: i32 = 1 << 15;

impl Planner {
    /// What the drive follows.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// Whether the axis or its master moves by a command or is going to. The speed generator, gear and cam may stay
    /// active at rest.
    pub fn is_moving(&self) -> bool {
        let axis = match self.generator {
            Generator::Idle => false,
            Generator::Speed { demand } => demand != 0 || self.base.velocity != 0,
            Generator::Gear => self.base.velocity != 0 || !self.gear.is_locked(),
            Generator::Cam => self.base.velocity != 0 || !self.cam.is_locked(),
            Generator::Stop { .. } | Generator::Move { .. } | Generator::Home(_) => true,
        };
        axis || self.phase.is_active() || self.master.is_moving()
    }

    /// Positions per motor revolution, in 1/256 count.
    pub fn units_per_revolution(&self) -> i64 {
        (if self.fine { 65_536 } else { 4096 }) << FRACTION
    }

    /// `mres%`.
    pub fn resolution(&self) -> i32 {
        i32::from(self.fine)
    }

    /// `gv_smod%`.
    pub fn modulus(&self) -> Modulus {
        self.modulus
    }

    /// A position in 1/256 count as a program reads it: in counts, wrapped to the modulus or to 32 bits.
    pub fn reading(&self, position: i64) -> i32 {
        self.modulus.reading(position)
    }

    /// The planner's bits of `gv_status%`.
    pub fn status(&self) -> i32 {
        match self.generator {
            Generator::Idle => STATUS_IDLE,
            Generator::Stop { .. } | Generator::Speed { .. } => STATUS_SPEED,
            Generator::Move { .. } => STATUS_MOVE,
            Generator::Gear => STATUS_GEAR,
            Generator::Cam => STATUS_CAM,
            Generator::Home(_) => STATUS_HOME,
        }
    }

    fn at_speed(&self) -> bool {
        matches!(self.generator, Generator::Speed { demand } if demand == self.base.velocity)
    }

    fn speed_contributes(&self) -> bool {
        matches!(
            self.generator,
            Generator::Stop { .. } | Generator::Speed { .. }
        )
    }

    /// `gv_mflag%`. Bit 0 stays until the next motion (D69), bit 4 until the next homing.
    pub fn motion_flags(&self) -> i32 {
        i32::from(self.final_position)
            | i32::from(self.gear.is_locked()) << 1
            | i32::from(self.at_speed()) << 2
            | i32::from(self.cam.is_locked()) << 3
            | i32::from(self.homed) << 4
    }

    /// `sm_flag%`.
    pub fn speed_flags(&self) -> i32 {
        i32::from(!self.speed_contributes()) | i32::from(self.at_speed()) << 2
    }

    /// `sm_speed%`; 0 while the speed generator is not active (D70).
    pub fn speed_demand(&self) -> i32 {
        if self.speed_contributes() {
            saturate(self.base.velocity)
        } else {
            0
        }
    }

    /// `mv_flag%`.
    pub fn move_flags(&self) -> i32 {
        let over = !matches!(self.generator, Generator::Move { .. });
        i32::from(over) | self.moves.direction()
    }

    /// `hm_flag%`: bit 0 in progress, bit 1 done.
    pub fn home_flags(&self) -> i32 {
        i32::from(self.is_homing()) | i32::from(self.homed) << 1
    }

    /// Whether homing is under way.
    pub fn is_homing(&self) -> bool {
        matches!(self.generator, Generator::Home(_))
    }

    /// Whether the last homing ended well.
    pub fn is_homed(&self) -> bool {
        self.homed
    }

    /// The cam's table, for a drawing.
    pub fn cam_table(&self) -> Option<CamTable> {
        self.cam.picture(&self.master.of_cam(), self.modulus)
    }

    /// Whether the cam's index has passed 0 in the last sample.
    pub fn cam_passed_zero(&self) -> bool {
        self.cam_passed_zero
    }
}
