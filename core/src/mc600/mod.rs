//! The Danaher MC-600: an add-on card for a SERVOSTAR 600 drive, programmed in MotionBasic.

pub mod firmware;
