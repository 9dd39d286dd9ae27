//! What a newcomer to the MC-600 starts with.

use crate::controller::FirstStep::{self, PowerCycle, Type};

/// Moves the axis to and fro within two seconds, and says so.
pub const PROGRAM: &str = r#"10 REM TEN TURNS OUT AND BACK
20 MDRVEN() : REM DRIVE ON
30 MV_SPEED%=34952 : REM 1000 RPM
40 MV_ACC%=280 : MV_DEC%=280
50 FOR N=1 TO 3
60   MMOVE(40960) : GOSUB 110
70   PRINT "OUT"; GV_FEEDBACK%
80   MMOVE(0) : GOSUB 110
90   PRINT "BACK"; GV_FEEDBACK%
100 NEXT N : END
110 REM WAIT UNTIL IT IS THERE
120 IF (MV_FLAG% AND 1)=0 THEN 120
130 RETURN"#;

/// A program of one's own: typed, started, kept on disk B: and started again after a power cycle.
pub const STEPS: &[FirstStep] = &[
    Type("NEW", "clears the program that is there"),
    Type(
        "10 MDRVEN()",
        "a line with a number goes into the program: this one enables the drive",
    ),
    Type(
        "20 MMOVE(40960)",
        "moves the axis to position 40960, ten turns from 0",
    ),
    Type("LIST", "shows the program"),
    Type("RUN", "starts it"),
    Type(
        "SAVE \"B:TURNS\"",
        "keeps it on disk B:, which needs no power; A: does",
    ),
    PowerCycle,
    Type("FILES \"B:\"", "shows what is on the disk"),
    Type("LOAD \"B:TURNS\"", "gets the program back"),
    Type("RUN", "starts it again"),
];
