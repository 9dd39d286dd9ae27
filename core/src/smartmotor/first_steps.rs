//! What a newcomer to the SmartMotor starts with.

use crate::controller::FirstStep::{self, PowerCycle, Type};

/// Moves the shaft to and fro, and says where it is.
pub const PROGRAM: &str = r#"'TEN TURNS OUT AND BACK, THREE TIMES
A=3958        'ACCELERATION, 500 REV/S/S
V=644252      'VELOCITY, 20 REV/S
a=0
WHILE a<3
  P=20000 G TWAIT
  PRINT("OUT ",@P,#13)
  P=0 G TWAIT
  PRINT("BACK ",@P,#13)
  a=a+1
LOOP
END"#;

/// Commands from the host, and a variable that outlives the mains switch; so does the program, which the editor loads.
pub const STEPS: &[FirstStep] = &[
    Type(
        "A=3958 V=644252",
        "acceleration and velocity for the moves to come",
    ),
    Type("P=20000 G", "a target, ten turns from 0, and go"),
    Type("RP", "reports the position"),
    Type("b=7 Rb", "sets a variable, and reports it"),
    Type("EPTR=100 VST(b,1)", "keeps it in the EEPROM"),
    PowerCycle,
    Type("EPTR=100 VLD(b,1) Rb", "gets it back"),
];
