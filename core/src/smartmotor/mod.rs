//! The Animatics SmartMotor, class 4: a servo motor with its amplifier and its controller inside.

pub mod motor;
