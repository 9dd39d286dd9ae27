//! The master: the selected encoder, to which the virtual axis and the virtual speed are added.
//!
//! Source: "Mvirtualax(pos)", "Mvspeed(vel)", "Gv_master%", "Gv_mmod%".

use super::POWER_UP_ACCELERATION;
use super::cam::CamMaster;
use super::encoder::Encoder;
use super::moves::Offset;
use super::units::{FRACTION, Modulus, saturate};
use crate::motion::ramp::next_velocity_to_speed;

/// `vx_flag%` bit 2: the encoder is left out of the master.
const WITHOUT_ENCODER: i32 = 1 << 2;

/// The master and its variables.
#[derive(Debug, Clone, PartialEq)]
pub struct Master {
    /// The selected encoder.
    pub encoder: Encoder,
    /// `mvirtualax`.
    pub axis: Offset,
    /// `vs_acc%`.
    pub speed_acceleration: i32,
    /// Of `mvspeed`, in counts*256/sample.
    speed_demand: i64,
    speed: i64,
    without_encoder: bool,
    /// `gv_mmod%`.
    modulus: Modulus,
    /// In 1/256 count, unwrapped.
    position: i64,
    /// Moved by in the last sample.
    velocity: i64,
}

impl Master {
    pub(super) fn new(encoder: Encoder) -> Master {
        Master {
            encoder,
            axis: Offset::new(),
            speed_acceleration: POWER_UP_ACCELERATION,
            speed_demand: 0,
            speed: 0,
            without_encoder: false,
            modulus: Modulus::default(),
            position: 0,
            velocity: 0,
        }
    }

    /// One sample, with the last position that came on the ServoBus.
    pub(super) fn sample(&mut self, bus: Option<i32>) {
        self.encoder.sample(bus);
        let encoder = if self.without_encoder {
            0
        } else {
            i64::from(self.encoder.counted()) << FRACTION
        };
        let acceleration = i64::from(self.speed_acceleration);
        self.speed =
            next_velocity_to_speed(self.speed, self.speed_demand, acceleration, acceleration);
        self.velocity = encoder + self.axis.sample() + self.speed;
        self.position = self.position.wrapping_add(self.velocity);
    }

    /// `mvspeed`, in counts*256/sample.
    pub fn turn(&mut self, speed: i32) {
        self.speed_demand = i64::from(speed);
    }

    /// Moved by in the last sample, in 1/256 count.
    pub fn velocity(&self) -> i64 {
        self.velocity
    }

    /// In 1/256 count, unwrapped.
    pub fn position(&self) -> i64 {
        self.position
    }

    /// As a cam sees it.
    pub(super) fn of_cam(&self) -> CamMaster {
        CamMaster {
            position: self.position,
            modulus: self.modulus.0,
        }
    }

    /// A position of the master in 1/256 count as a program reads it.
    pub fn reading(&self, position: i64) -> i32 {
        self.modulus.reading(position)
    }

    /// `gv_master%`.
    pub fn word(&self) -> i32 {
        self.reading(self.position)
    }

    /// `gv_mmod%`.
    pub fn modulus(&self) -> i32 {
        self.modulus.0
    }

    /// Sets `gv_mmod%`; the position first becomes what it reads as.
    pub(super) fn set_modulus(&mut self, modulus: i32) {
        self.position += self.modulus.shift(self.position);
        self.modulus = Modulus(modulus);
    }

    /// `vx_flag%`.
    pub fn axis_flags(&self) -> i32 {
        let without_encoder = if self.without_encoder {
            WITHOUT_ENCODER
        } else {
            0
        };
        self.axis.flags() | without_encoder
    }

    /// Sets bit 2 of `vx_flag%`; the master does not jump by it (D197).
    pub fn set_axis_flags(&mut self, flags: i32) {
        self.without_encoder = flags & WITHOUT_ENCODER != 0;
    }

    /// `vs_flag%`: bit 0 adds nothing, bit 2 at speed.
    pub fn speed_flags(&self) -> i32 {
        let rests = self.speed == 0 && self.speed_demand == 0;
        let at_speed = !rests && self.speed == self.speed_demand;
        i32::from(rests) | i32::from(at_speed) << 2
    }

    /// `vs_speed%`.
    pub fn speed(&self) -> i32 {
        saturate(self.speed)
    }

    /// Whether a virtual generator moves it or is going to.
    pub fn is_moving(&self) -> bool {
        self.axis.is_active() || self.speed != 0 || self.speed_demand != 0
    }
}
