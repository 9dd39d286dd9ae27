//! What the unit says, how long it takes, and where its memory lies.

use crate::serial::LineSettings;
use crate::time::Nanos;

/// The unit's own sample; pulses and edges are timed inside it.
pub const SAMPLE: Nanos = Nanos::from_millis(1);
/// A codeword takes this long ("Statement time", D250).
pub const CODEWORD: Nanos = Nanos::from_millis(2);
/// A jump takes this long.
pub const JUMP: Nanos = Nanos::from_millis(1);
/// Most firmware time that one sample may hold, whatever the speed.
pub const CREDIT_A_SAMPLE: Nanos = Nanos::from_millis(10_000);

/// The serial line as the switches of a new bench set it.
pub const LINE: LineSettings = LineSettings::new(9600);

/// Self-test of the EPROMs and of the system RAM (D251).
pub const TEST_SYSTEM: Nanos = Nanos::from_millis(300);
/// Write and read test of a kilobyte of user memory: 28 KB take nearly 4 s (4-3 A).
pub const TEST_KILOBYTE: Nanos = Nanos::from_millis(130);
/// PWR FAIL stands this long (2-6 B).
pub const POWER_FAIL: Nanos = Nanos::from_millis(2000);
/// A search takes this long (D251).
pub const LOOKING: Nanos = Nanos::from_millis(300);

/// Characters that the immediate mode holds (3-3 D).
pub const IMMEDIATE: usize = 256;
/// Characters of a message and of the message buffer (6-12 A, 6-13).
pub const MESSAGE: usize = 32;
/// Levels of the stack (6-2).
pub const LEVELS: usize = 16;
/// The highest program number.
pub const LAST_PROGRAM: u8 = 99;
/// The first program that the OEM jumper protects (4-11 A).
pub const OEM_PROGRAM: u8 = 50;
/// Ends what is printed, unless programmed otherwise (2-7 E).
pub const END_OF_FILE: u8 = 0x03;

/// A message that stands on the display, from the left.
pub mod text {
    #![allow(missing_docs)]
    pub const READY_SYSTEM: &str = "SYS RDY";
    pub const ROM_ERROR: &str = "ROM ERR";
    pub const SYSTEM_RAM_ERROR: &str = "SRAM ERR";
    pub const ALTERED: &str = "URAM ALT";
    pub const CLEAR: &str = "URAM CLR";
    pub const USER_RAM_ERROR: &str = "URAM ERR";
    pub const POWER_FAIL: &str = "PWR FAIL";
    pub const EDITING: &str = "EDITING!";
    pub const REMOTE: &str = "REMOTE";
    pub const READY: &str = "READY";
    pub const RUNNING: &str = "RUNNING";
    pub const PROGRAM_END: &str = "PGM END";
    pub const WHAT: &str = "WHAT?";
    pub const LOOKING: &str = "LOOKING";
    pub const CLEARED: &str = "CLEARED";
    pub const PRINTING: &str = "PRINTING";
    pub const TESTING: &str = "TESTING";
    pub const MODIFIED: &str = "MODIFIED";
    pub const MODIFY_EOF: &str = "MOD. EOF";
    pub const ENTER: &str = "ENTER >>";
    pub const PROMPT: &str = "PGM <1>";
    pub const CLEAR_PROMPT: &str = "CLR ?<1>";
    pub const NO_BOOT: &str = "NOBOOT";
    pub const FREE: &str = "FREE MEM";
    pub const TEST: &str = "TST URAM";
    pub const ENTER_MESSAGE: &str = "ENTR MSG";
    pub const PRINT_DIRECTORY: &str = "PRNT DIR";
    pub const PRINT_MESSAGE: &str = "PRNT MES";
    pub const SLEW: &str = "SLEW";
    pub const STEP: &str = "STEP";
}
