//! What the firmware's figures are: statement times, limits, the line at power-up.

use crate::serial::{Flow, LineSettings};
use crate::time::Nanos;

pub use super::motor::SAMPLE;

/// Firmware time of one cost, in ns: a statement takes a servo sample ("Rates and units", D130).
pub const COST_UNIT: i64 = 245_760;
/// The most firmware time that one sample holds: 10,000 statements.
pub const CREDIT_A_SAMPLE: Nanos = Nanos(2_457_600_000);
/// If nothing comes in for so long after power-up, the stored program starts ("Serial").
pub const START_WINDOW: Nanos = Nanos::from_millis(200);
/// Bytes of a stored program ("Serial").
pub const PROGRAM_BYTES: usize = 32_767;
/// Characters that are kept until they are read (D139).
pub const RECEIVED: usize = 31;
/// Bytes of a command from the host (D139).
pub const COMMAND_BYTES: usize = 1000;
/// The highest address on a chain.
pub const LAST_ADDRESS: u8 = 100;

/// The line at power-up: 9600 8N1, no flow control.
pub const LINE: LineSettings = LineSettings {
    flow: Flow::None,
    ..LineSettings::new(9600)
};
