//! The rows of the system variables. Positions are in counts, speeds in counts*256/sample, accelerations in
//! counts*256/sample² unless told otherwise; a sample is 2 ms.

use super::{INTERRUPTS, IO, MOTION, OTHER, SERVOBUS, SysVar, UNITS};
use crate::language::KeywordRow;
use crate::language::Support::Full;

/// Makes the rows; those of variables that a program sets come with a value for the example, an array's with a
/// subscript.
macro_rules! variables {
    ($($word:literal $([$subscript:literal])? $(= $value:literal)? $section:ident $support:ident $summary:literal;)*) => {
        static ROWS: &[KeywordRow] = &[$(KeywordRow {
            word: $word,
            kind: "sysvar",
            syntax: concat!($word $(, $subscript)?),
            summary: $summary,
            section: $section,
            support: $support,
            example: variables!(@example $word $([$subscript])? $($value)?),
        },)*];
    };
    (@example $word:literal [$subscript:literal]) => { concat!("10 PRINT ", $word, $subscript) };
    (@example $word:literal) => { concat!("10 PRINT ", $word) };
    (@example $word:literal $value:literal) => { concat!("10 ", $word, "=", $value) };
}

variables! {
    "MRES%" = "1" UNITS Full "Counts of one motor turn: 0 is 4096, 1 is 65536; not to be changed after homing.";
    "SM_ACC%" = "700" MOTION Full "Acceleration and deceleration of MSPEED.";
    "SM_FLAG%" MOTION Full "Flags of MSPEED: bit 0 does not move the motor, bit 2 at speed.";
    "SM_SPEED%" MOTION Full "Speed that MSPEED demands now.";
    "MV_ACC%" = "700" MOTION Full "Acceleration of moves.";
    "MV_DEC%" = "700" MOTION Full "Deceleration of moves.";
    "MV_SPEED%" = "34952" MOTION Full "Highest speed of moves.";
    "MV_FLAG%" = "64" MOTION Full "Flags of moves: bit 0 at the target; bits 4 to 6 always positive, always negative, shortest way.";
    "MINSPEED%" = "350" MOTION Full "Lowest speed of MMERGE and MIMERGE.";
    "MINSPPED%" = "350" MOTION Full "MINSPEED%, as the manual misspells it.";
    "GR_RATION%" = "1" MOTION Full "Gear ratio, numerator.";
    "GR_RATIOID%" = "2" MOTION Full "Gear ratio, denominator.";
    "GR_ACC%" = "700" MOTION Full "Acceleration of engaging a gear.";
    "GR_SPEED%" = "34952" MOTION Full "Speed of recovering the phase of a gear.";
    "GR_FLAG%" MOTION Full "Flags of the gear: bit 0 engaging, bit 1 locked.";
    "GR_PREPOST%" = "1000" MOTION Full "Distance added to the phase that a gear recovers.";
    "CM_CAMOUT%" MOTION Full "Position that the cam demands, within the slave's modulus.";
    "CM_NUM%" = "360" MOTION Full "Number of points of the cam table.";
    "CM_INDEX%" MOTION Full "Point of the cam table that was used last.";
    "CM_FLAG%" MOTION Full "Flags of the cam: bit 0 ends with this modulus.";
    "CM_MASTER%" INTERRUPTS Full "Master position of the cam.";
    "VX_ACC%" = "700" MOTION Full "Acceleration of the virtual axis.";
    "VX_DEC%" = "700" MOTION Full "Deceleration of the virtual axis.";
    "VX_SPEED%" = "34952" MOTION Full "Highest speed of the virtual axis.";
    "VX_POS%" MOTION Full "Position of the virtual axis.";
    "VX_FLAG%" = "4" MOTION Full "Flags of the virtual axis: bit 0 at the target; bit 2 leaves the encoder out of the master.";
    "VS_ACC%" = "700" MOTION Full "Acceleration and deceleration of MVSPEED.";
    "VS_FLAG%" MOTION Full "Flags of MVSPEED: bit 0 adds nothing, bit 2 at speed.";
    "VS_SPEED%" MOTION Full "Speed that MVSPEED demands now.";
    "PH_ACC%" = "700" MOTION Full "Acceleration of phasing.";
    "PH_DEC%" = "700" MOTION Full "Deceleration of phasing.";
    "PH_SPEED%" = "34952" MOTION Full "Highest speed of phasing.";
    "PH_FLAG%" MOTION Full "Flags of phasing: bit 0 at the target.";
    "PH_POSITION%" MOTION Full "Present phase.";
    "HM_FLAG%" MOTION Full "Flags of homing: bit 0 in progress, bit 1 done.";
    "GV_MASTER%" OTHER Full "Master position: the selected encoder and the virtual axis.";
    "GV_FEEDBACK%" OTHER Full "Actual position of the axis.";
    "GV_ENCODER%" OTHER Full "Position of the selected encoder.";
    "GV_ENCSPEED%" OTHER Full "Speed of the selected encoder.";
    "GV_MMOD%" = "4096" OTHER Full "Modulus of the master position; 0 is none.";
    "GV_SMOD%" = "4096" OTHER Full "Modulus of the axis; 0 is none.";
    "SL_POSDEMAND%" OTHER Full "Reference of the position loop.";
    "SL_SPDDEMAND%" OTHER Full "Speed of the reference.";
    "GV_STATUS%" OTHER Full "Drive and planner: bits 0 to 8 the drive's state, 10 to 15 idle, speed, gear, move, cam, home.";
    "GV_COMMAND%" = "15" OTHER Full "Control word of the drive: bit 0 enable, bits 1 and 2 emergency stop at 0, bit 3 reference enable.";
    "GV_ERROR%" OTHER Full "Error code of the drive.";
    "GV_WARNING%" OTHER Full "Warning code of the drive.";
    "GV_ANIN1%" OTHER Full "Analog input 1 of the drive.";
    "GV_ANIN2%" OTHER Full "Analog input 2 of the drive.";
    "GV_TRJSTAT%" OTHER Full "Trajectory status of the drive.";
    "GV_LATCH1%" OTHER Full "Position that the drive captured, input 1, rising edge.";
    "GV_LATCH1N%" OTHER Full "Position that the drive captured, input 1, falling edge.";
    "GV_LATCH2%" OTHER Full "Position that the drive captured, input 2, rising edge.";
    "GV_LATCH2N%" OTHER Full "Position that the drive captured, input 2, falling edge.";
    "GV_MONITOR1%" = "1000" OTHER Full "Analog output 1 of the drive.";
    "GV_MONITOR2%" = "1000" OTHER Full "Analog output 2 of the drive.";
    "GV_VELMOT%" OTHER Full "Actual motor speed; 1 rpm is 33554432/240000.";
    "GV_CURMOT%" OTHER Full "Torque demand; the drive's peak current is 3280.";
    "GV_MFLAG%" OTHER Full "Bit 0 final position reached, 1 gear locked, 2 at speed, 3 cam locked, 4 homed.";
    "GV_IN0%" OTHER Full "Digital input 0.";
    "GV_IN1%" OTHER Full "Digital input 1.";
    "GV_IN2%" OTHER Full "Digital input 2.";
    "GV_IN3%" OTHER Full "Digital input 3.";
    "GV_IN4%" OTHER Full "Digital input 4.";
    "GV_IN5%" OTHER Full "Digital input 5.";
    "GV_IN6%" OTHER Full "Digital input 6.";
    "GV_IN7%" OTHER Full "Digital input 7.";
    "GV_IN8%" OTHER Full "Input IN1 of the drive.";
    "GV_IN9%" OTHER Full "Input IN2 of the drive.";
    "GV_IN10%" OTHER Full "Input IN3 of the drive.";
    "GV_IN11%" OTHER Full "Input IN4 of the drive.";
    "GV_IN12%" OTHER Full "Input ENABLE of the drive.";
    "GV_OUT0%" = "1" OTHER Full "Digital output 0.";
    "GV_OUT1%" = "1" OTHER Full "Digital output 1.";
    "GV_OUT2%" = "1" OTHER Full "Digital output 2.";
    "GV_OUT3%" = "1" OTHER Full "Digital output 3.";
    "GV_OUT4%" = "1" OTHER Full "Digital output 4.";
    "GV_OUT5%" = "1" OTHER Full "Digital output 5.";
    "GV_OUT6%" = "1" OTHER Full "Digital output 6.";
    "GV_OUT7%" = "1" OTHER Full "Digital output 7.";
    "GV_OUT8%" = "1" OTHER Full "Output 1 of the drive.";
    "GV_OUT9%" = "1" OTHER Full "Output 2 of the drive.";
    "GV_USVAR1%" = "1" OTHER Full "User variable 1 of the drive, for the card to set.";
    "GV_USVAR2%" = "1" OTHER Full "User variable 2 of the drive, for the card to set.";
    "GV_USVAR3%" = "1" OTHER Full "User variable 3 of the drive, for the card to set.";
    "GV_USVAR4%" = "1" OTHER Full "User variable 4 of the drive, for the card to set.";
    "GV_USVAR5%" = "1" OTHER Full "User variable 5 of the drive, for the card to set.";
    "GV_USVAR6%" = "1" OTHER Full "User variable 6 of the drive, for the card to set.";
    "GV_USVAR7%" = "1" OTHER Full "User variable 7 of the drive, for the card to set.";
    "GV_USVAR8%" = "1" OTHER Full "User variable 8 of the drive, for the card to set.";
    "GV_USVAR9%" OTHER Full "User variable 9 of the drive, for the card to read.";
    "GV_USVAR10%" OTHER Full "User variable 10 of the drive, for the card to read.";
    "GV_USVAR11%" OTHER Full "User variable 11 of the drive, for the card to read.";
    "GV_USVAR12%" OTHER Full "User variable 12 of the drive, for the card to read.";
    "GV_USVAR13%" OTHER Full "User variable 13 of the drive, for the card to read.";
    "GV_USVAR14%" OTHER Full "User variable 14 of the drive, for the card to read.";
    "GV_USVAR15%" OTHER Full "User variable 15 of the drive, for the card to read.";
    "GV_USVAR16%" OTHER Full "User variable 16 of the drive, for the card to read.";
    "GV_COMPARE%" INTERRUPTS Full "The eight position comparators, comparator 0 in bit 0.";
    "GV_CAPPOSF%" IO Full "Actual position captured by input 2.";
    "GV_CAPPOS%" IO Full "Position captured by input 3.";
    "GV_CAPSEL%" = "1" IO Full "What input 3 captures: 0 master, 1 cam master, 2 position demand.";
    "GV_CANOUT%" SERVOBUS Full "Position that the bus's master sends.";
    "GV_CANIN%" SERVOBUS Full "Position received from the bus.";
    "CAN_DATA%" ["(0)"] SERVOBUS Full "Array of what the mailboxes received, 0 to 7.";
    "CAN_FLAG%" = "0" SERVOBUS Full "Mailboxes that have received something, mailbox 0 in bit 0.";
}

/// Stands in for an input, output or user variable of a number that the device does not have.
static NONE: KeywordRow = KeywordRow {
    word: "",
    kind: "sysvar",
    syntax: "",
    summary: "There is no such variable.",
    section: OTHER,
    support: Full,
    example: "",
};

pub(super) fn rows() -> impl Iterator<Item = &'static KeywordRow> {
    ROWS.iter()
}

pub(super) fn row(variable: SysVar) -> &'static KeywordRow {
    let word = variable.word();
    ROWS.iter().find(|row| row.word == word).unwrap_or(&NONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_variables_agree() {
        for &(word, variable) in SysVar::all() {
            let row = row(variable);
            assert_eq!(row.word, word);
            let sets = row.example.contains('=');
            assert!(!(sets && variable.is_read_only()), "{word}");
        }
        assert_eq!(ROWS.len(), SysVar::all().len() + 1, "and the misprint");
    }
}
