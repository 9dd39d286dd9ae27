//! The rows of the system variables. Positions are in counts, speeds in counts*256/sample, accelerations in
//! counts*256/sample² unless told otherwise; a sample is 2 ms.

use super::{INTERRUPTS, IO, LATER, MOTION, OTHER, SERVOBUS, SysVar, UNITS};
use crate::language::KeywordRow;
use crate::language::Support::Full;

/// Makes the rows; those of variables that a program sets come with a value for the example.
macro_rules! variables {
    ($($word:literal $(= $value:literal)? $section:ident $support:ident $summary:literal;)*) => {
        static ROWS: &[KeywordRow] = &[$(KeywordRow {
            word: $word,
            kind: "sysvar",
            syntax: $word,
            summary: $summary,
            section: $section,
            support: $support,
            example: variables!(@example $word $($value)?),
        },)*];
    };
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
    "MINSPEED%" = "350" MOTION LATER "Lowest speed of MMERGE and MIMERGE.";
    "MINSPPED%" = "350" MOTION LATER "MINSPEED%, as the manual misspells it.";
    "GR_RATION%" = "1" MOTION LATER "Gear ratio, numerator.";
    "GR_RATIOID%" = "2" MOTION LATER "Gear ratio, denominator.";
    "GR_ACC%" = "700" MOTION LATER "Acceleration of engaging a gear.";
    "GR_SPEED%" = "34952" MOTION LATER "Speed of recovering the phase of a gear.";
    "GR_FLAG%" MOTION LATER "Flags of the gear: bit 0 engaging, bit 1 locked.";
    "GR_PREPOST%" = "1000" MOTION LATER "Distance added to the phase that a gear recovers.";
    "CM_CAMOUT%" MOTION LATER "Position that the cam demands, within the slave's modulus.";
    "CM_NUM%" = "360" MOTION LATER "Number of points of the cam table.";
    "CM_INDEX%" MOTION LATER "Point of the cam table that was used last.";
    "CM_FLAG%" MOTION LATER "Flags of the cam: bit 0 ends with this modulus.";
    "CM_MASTER%" INTERRUPTS LATER "Master position of the cam.";
    "VX_ACC%" = "700" MOTION LATER "Acceleration of the virtual axis.";
    "VX_DEC%" = "700" MOTION LATER "Deceleration of the virtual axis.";
    "VX_SPEED%" = "34952" MOTION LATER "Highest speed of the virtual axis.";
    "VX_POS%" MOTION LATER "Position of the virtual axis.";
    "VX_FLAG%" = "4" MOTION LATER "Flags of the virtual axis: bit 0 at the target; bit 2 leaves the encoder out of the master.";
    "VS_ACC%" = "700" MOTION LATER "Acceleration and deceleration of MVSPEED.";
    "VS_FLAG%" MOTION LATER "Flags of MVSPEED: bit 0 adds nothing, bit 2 at speed.";
    "VS_SPEED%" MOTION LATER "Speed that MVSPEED demands now.";
    "PH_ACC%" = "700" MOTION LATER "Acceleration of phasing.";
    "PH_DEC%" = "700" MOTION LATER "Deceleration of phasing.";
    "PH_SPEED%" = "34952" MOTION LATER "Highest speed of phasing.";
    "PH_FLAG%" MOTION LATER "Flags of phasing: bit 0 at the target.";
    "PH_POSITION%" MOTION LATER "Present phase.";
    "HM_FLAG%" MOTION LATER "Flags of homing: bit 0 in progress, bit 1 done.";
    "GV_MASTER%" OTHER LATER "Master position: the selected encoder and the virtual axis.";
    "GV_FEEDBACK%" OTHER Full "Actual position of the axis.";
    "GV_ENCODER%" OTHER LATER "Position of the selected encoder.";
    "GV_ENCSPEED%" OTHER LATER "Speed of the selected encoder.";
    "GV_MMOD%" = "4096" OTHER LATER "Modulus of the master position; 0 is none.";
    "GV_SMOD%" = "4096" OTHER Full "Modulus of the axis; 0 is none.";
    "SL_POSDEMAND%" OTHER Full "Reference of the position loop.";
    "SL_SPDDEMAND%" OTHER Full "Speed of the reference.";
    "GV_STATUS%" OTHER Full "Drive and planner: bits 0 to 8 the drive's state, 10 to 15 idle, speed, gear, move, cam, home.";
    "GV_COMMAND%" = "15" OTHER Full "Control word of the drive: bit 0 enable, bits 1 and 2 emergency stop at 0, bit 3 reference enable.";
    "GV_ERROR%" OTHER LATER "Error code of the drive.";
    "GV_WARNING%" OTHER LATER "Warning code of the drive.";
    "GV_ANIN1%" OTHER LATER "Analog input 1 of the drive.";
    "GV_ANIN2%" OTHER LATER "Analog input 2 of the drive.";
    "GV_TRJSTAT%" OTHER LATER "Trajectory status of the drive.";
    "GV_LATCH1%" OTHER LATER "Position that the drive captured, input 1, rising edge.";
    "GV_LATCH1N%" OTHER LATER "Position that the drive captured, input 1, falling edge.";
    "GV_LATCH2%" OTHER LATER "Position that the drive captured, input 2, rising edge.";
    "GV_LATCH2N%" OTHER LATER "Position that the drive captured, input 2, falling edge.";
    "GV_MONITOR1%" = "1000" OTHER LATER "Analog output 1 of the drive.";
    "GV_MONITOR2%" = "1000" OTHER LATER "Analog output 2 of the drive.";
    "GV_VELMOT%" OTHER Full "Actual motor speed; 1 rpm is 33554432/240000.";
    "GV_CURMOT%" OTHER LATER "Torque demand; the drive's peak current is 3280.";
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
    "GV_USVAR1%" = "1" OTHER LATER "User variable 1 of the drive, for the card to set.";
    "GV_USVAR2%" = "1" OTHER LATER "User variable 2 of the drive, for the card to set.";
    "GV_USVAR3%" = "1" OTHER LATER "User variable 3 of the drive, for the card to set.";
    "GV_USVAR4%" = "1" OTHER LATER "User variable 4 of the drive, for the card to set.";
    "GV_USVAR5%" = "1" OTHER LATER "User variable 5 of the drive, for the card to set.";
    "GV_USVAR6%" = "1" OTHER LATER "User variable 6 of the drive, for the card to set.";
    "GV_USVAR7%" = "1" OTHER LATER "User variable 7 of the drive, for the card to set.";
    "GV_USVAR8%" = "1" OTHER LATER "User variable 8 of the drive, for the card to set.";
    "GV_USVAR9%" OTHER LATER "User variable 9 of the drive, for the card to read.";
    "GV_USVAR10%" OTHER LATER "User variable 10 of the drive, for the card to read.";
    "GV_USVAR11%" OTHER LATER "User variable 11 of the drive, for the card to read.";
    "GV_USVAR12%" OTHER LATER "User variable 12 of the drive, for the card to read.";
    "GV_USVAR13%" OTHER LATER "User variable 13 of the drive, for the card to read.";
    "GV_USVAR14%" OTHER LATER "User variable 14 of the drive, for the card to read.";
    "GV_USVAR15%" OTHER LATER "User variable 15 of the drive, for the card to read.";
    "GV_USVAR16%" OTHER LATER "User variable 16 of the drive, for the card to read.";
    "GV_COMPARE%" INTERRUPTS LATER "The eight position comparators, comparator 0 in bit 0.";
    "GV_CAPPOSF%" IO LATER "Actual position captured by input 2.";
    "GV_CAPPOS%" IO LATER "Position captured by input 3.";
    "GV_CAPSEL%" = "1" IO LATER "What input 3 captures: 0 master, 1 cam master, 2 position demand.";
    "GV_CANOUT%" SERVOBUS LATER "Position that the bus's master sends.";
    "GV_CANIN%" SERVOBUS LATER "Position received from the bus.";
    "CAN_DATA%" SERVOBUS LATER "Array of what the mailboxes received.";
    "CAN_FLAG%" SERVOBUS LATER "Mailboxes that have received something, mailbox 0 in bit 0.";
}

/// Stands in for an input, output or user variable of a number that the device does not have.
static NONE: KeywordRow = KeywordRow {
    word: "",
    kind: "sysvar",
    syntax: "",
    summary: "There is no such variable.",
    section: OTHER,
    support: LATER,
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
            assert_eq!(row.support == Full, variable.is_in_this_part(), "{word}");
            let sets = row.example.contains('=');
            assert!(!(sets && variable.is_read_only()), "{word}");
        }
        assert_eq!(ROWS.len(), SysVar::all().len() + 1, "and the misprint");
    }
}
