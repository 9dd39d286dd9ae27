//! The encoder of the master: what the card counts of a shaft that the bench turns.
//!
//! Source: "How the MC-600 works" (the encoder interfaces), "Gv_encoder%", "Gv_encspeed%".

use crate::time::Nanos;

use super::units::FRACTION;
use crate::mc600::firmware::SAMPLE;

/// Lines, pulses or sine periods of the encoder's turn (D196).
const LINES: f64 = 1024.0;
/// Bits of a fraction of a count in the shaft's position; what is above them wraps as the register does.
const FINE: u32 = 32;

/// The interface that the encoder is connected to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// 5 V, tracks A and B (X5).
    Quadrature,
    /// 5 V, pulse and direction (X5).
    Pulse,
    /// 24 V, tracks A and B (X3).
    SlowQuadrature,
    /// 24 V, pulse and direction (X3).
    SlowPulse,
    /// Sine and cosine (X1).
    SinCos,
    /// No encoder: the master position of the ServoBus.
    ServoBus,
}

impl Interface {
    /// By the name of the card's option.
    pub const NAMES: [(&'static str, Interface); 6] = [
        ("quadrature", Interface::Quadrature),
        ("pulse", Interface::Pulse),
        ("24v", Interface::SlowQuadrature),
        ("24v-pulse", Interface::SlowPulse),
        ("sincos", Interface::SinCos),
        ("servobus", Interface::ServoBus),
    ];

    /// Counts of one line, pulse or period.
    fn counts_per_line(self) -> f64 {
        match self {
            Interface::Quadrature | Interface::SlowQuadrature => 4.0,
            Interface::Pulse | Interface::SlowPulse => 1.0,
            Interface::SinCos => 1024.0,
            Interface::ServoBus => 0.0,
        }
    }

    /// Most lines, pulses or periods a second; what is faster is lost (D196).
    fn lines_per_second(self) -> f64 {
        match self {
            Interface::Quadrature | Interface::Pulse => 2_000_000.0,
            Interface::SlowQuadrature | Interface::SlowPulse => 10_000.0,
            Interface::SinCos => 250_000.0,
            Interface::ServoBus => 0.0,
        }
    }
}

/// The encoder, its shaft and the counter.
#[derive(Debug, Clone, PartialEq)]
pub struct Encoder {
    interface: Interface,
    /// Of the shaft, in counts a sample.
    speed: f64,
    /// Turned by hand since the last sample, in counts.
    jog: f64,
    /// In counts with a fraction of [`FINE`] bits.
    position: i64,
    /// Counted in the last sample.
    counted: i32,
    /// The bus's last position, while it is the source.
    bus: Option<i32>,
}

impl Encoder {
    /// An encoder whose shaft stands still.
    pub fn new() -> Encoder {
        Encoder {
            interface: Interface::Quadrature,
            speed: 0.0,
            jog: 0.0,
            position: 0,
            counted: 0,
            bus: None,
        }
    }

    /// Where it is connected.
    pub fn set_interface(&mut self, interface: Interface) {
        self.interface = interface;
    }

    /// Turns the shaft at a speed in rpm.
    pub fn turn(&mut self, rpm: f64) {
        let counts_per_turn = LINES * self.interface.counts_per_line();
        self.speed = rpm / 60.0 * seconds(SAMPLE) * counts_per_turn;
    }

    /// Turns the shaft at a speed in counts*256/sample.
    pub fn turn_by_counts(&mut self, speed: f64) {
        self.speed = speed / f64::from(1 << FRACTION);
    }

    /// Turns the shaft on by some counts at once.
    pub fn jog(&mut self, counts: f64) {
        self.jog += counts;
    }

    /// Power-up: the counter starts at 0, the shaft goes on as it does.
    pub fn reset(&mut self) {
        (self.position, self.counted, self.bus, self.jog) = (0, 0, None, 0.0);
    }

    /// One sample, with the last position that came on the ServoBus.
    pub fn sample(&mut self, bus: Option<i32>) {
        let before = self.count();
        if self.interface == Interface::ServoBus {
            // The first position that comes is where the counter starts.
            let from = self.bus.or(bus).unwrap_or_default();
            let way = bus.unwrap_or(from).wrapping_sub(from);
            self.bus = bus.or(self.bus);
            self.position = self.position.wrapping_add(i64::from(way) << FINE);
        } else {
            let most = self.interface.lines_per_second()
                * self.interface.counts_per_line()
                * seconds(SAMPLE);
            let way = fine(self.speed.clamp(-most, most)).wrapping_add(fine(self.jog));
            self.position = self.position.wrapping_add(way);
        }
        self.jog = 0.0;
        self.counted = self.count().wrapping_sub(before);
    }

    /// `gv_encoder%`.
    #[allow(clippy::cast_possible_truncation)] // 32 bits are left of 64
    pub fn count(&self) -> i32 {
        (self.position >> FINE) as i32
    }

    /// Counted in the last sample.
    pub fn counted(&self) -> i32 {
        self.counted
    }

    /// `gv_encspeed%`, in counts*256/sample.
    pub fn speed(&self) -> i32 {
        super::units::saturate(i64::from(self.counted) << FRACTION)
    }
}

fn seconds(time: Nanos) -> f64 {
    time.0 as f64 * 1e-9
}

/// Counts in the encoder's fixed point.
#[allow(clippy::cast_possible_truncation)] // `as` saturates, and what wraps is bounded by 32 bits of counts
fn fine(counts: f64) -> i64 {
    const SCALE: f64 = (1u64 << FINE) as f64;
    (counts.clamp(-2_147_483_648.0, 2_147_483_647.0) * SCALE) as i64
}
