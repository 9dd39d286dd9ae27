//! What a program reads and sets of the motor.

use std::fmt;

use super::ports::Port;

/// A number of the motor that the language reads, sets or both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Register {
    /// `A`: acceleration, counts/sample² x 65536, buffered until G.
    Acceleration,
    /// `V`: velocity, counts/sample x 65536, buffered until G.
    Velocity,
    /// `P`: target in counts, buffered until G.
    Position,
    /// `D`: distance in counts of a relative move, buffered until G.
    Distance,
    /// `T`: torque of MT, -1023 to 1023, acts at once.
    Torque,
    /// `E`: largest position error in counts.
    ErrorLimit,
    /// `O`: the actual position becomes this; write only.
    Origin,
    /// `AMPS`: limit of the output, 0 to 1023.
    Amps,
    /// `TH`: temperature in °C at which the motor trips.
    TripTemperature,
    /// `TEMP`: of the motor in °C.
    Temperature,
    /// `UIA`: motor current in 0.01 A.
    Current,
    /// `UJA`: supply in 0.1 V.
    Supply,
    /// `@P`: actual position in counts.
    ActualPosition,
    /// `@V`: velocity of the trajectory, without one that of the motor; counts/sample x 65536 (D176).
    ActualVelocity,
    /// `@PE`: position error in counts, commanded minus actual.
    PositionError,
    /// `I`: where the index mark was last captured, in counts. [`super::Motor::read`] arms the next capture.
    Index,
    /// `KP`, buffered until F.
    Proportional,
    /// `KI`, buffered until F.
    Integral,
    /// `KD`, buffered until F.
    Derivative,
    /// `KL`, buffered until F.
    IntegralLimit,
    /// `KS`, buffered until F.
    DerivativeSamples,
    /// `KV`, buffered until F.
    VelocityFeedForward,
    /// `KA`, buffered until F.
    AccelerationFeedForward,
    /// `KG`, buffered until F.
    Gravity,
    /// `CTR`: the external encoder or the steps counted on ports A and B.
    Counter,
    /// `CLK`: servo samples; can be set.
    Clock,
    /// `MFMUL`: numerator of the ratio.
    FollowMultiplier,
    /// `MFDIV`: denominator of the ratio.
    FollowDivisor,
    /// `BASE`: master counts of a turn of the cam.
    CamBase,
    /// `SIZE`: segments of the cam table.
    CamSize,
    /// `F`: the mask of special functions.
    Functions,
    /// `UAI` to `UGI` as a value: the level of a pin. Set, `UA` to `UG`: the level of an output.
    Pin(Port),
    /// `UAA` to `UGA`: the voltage at a pin, 0 to 1023 for 0 to 5 V.
    Analog(Port),
}

use Register as R;

/// The words that stand for a register in an expression or before `=`. Pins have two: `UAI` reads, `UA` is set.
const WORDS: [(&str, Register); 31] = [
    ("A", R::Acceleration),
    ("V", R::Velocity),
    ("P", R::Position),
    ("D", R::Distance),
    ("T", R::Torque),
    ("E", R::ErrorLimit),
    ("O", R::Origin),
    ("AMPS", R::Amps),
    ("TH", R::TripTemperature),
    ("TEMP", R::Temperature),
    ("UIA", R::Current),
    ("UJA", R::Supply),
    ("@P", R::ActualPosition),
    ("@V", R::ActualVelocity),
    ("@PE", R::PositionError),
    ("I", R::Index),
    ("KP", R::Proportional),
    ("KI", R::Integral),
    ("KD", R::Derivative),
    ("KL", R::IntegralLimit),
    ("KS", R::DerivativeSamples),
    ("KV", R::VelocityFeedForward),
    ("KA", R::AccelerationFeedForward),
    ("KG", R::Gravity),
    ("CTR", R::Counter),
    ("CLK", R::Clock),
    ("MFMUL", R::FollowMultiplier),
    ("MFDIV", R::FollowDivisor),
    ("BASE", R::CamBase),
    ("SIZE", R::CamSize),
    ("F", R::Functions),
];

impl Register {
    /// The register that a program means by `word` in an expression: `KP`, `@PE`, `UAI`, `UAA`.
    pub fn readable(word: &str) -> Option<Register> {
        let pin = |suffix| word.strip_suffix(suffix).and_then(Port::from_word);
        let register = named(word)
            .or_else(|| pin('I').map(R::Pin))
            .or_else(|| pin('A').map(R::Analog))?;
        (register != R::Origin).then_some(register)
    }

    /// The register that a program sets by `word` before `=`: `KP`, `O`, `UA`.
    pub fn writable(word: &str) -> Option<Register> {
        let register = named(word).or_else(|| Port::from_word(word).map(R::Pin))?;
        let measured = matches!(
            register,
            R::Temperature
                | R::Current
                | R::Supply
                | R::ActualPosition
                | R::ActualVelocity
                | R::PositionError
                | R::Index
                | R::Counter
        );
        (!measured).then_some(register)
    }
}

fn named(word: &str) -> Option<Register> {
    let row = WORDS.iter().find(|(known, _)| *known == word)?;
    Some(row.1)
}

/// As before `=`: `KP`, `UA`; analog pins as they are read.
impl fmt::Display for Register {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            R::Pin(port) => write!(f, "{port}"),
            R::Analog(port) => write!(f, "{port}A"),
            register => {
                let row = WORDS.iter().find(|(_, known)| known == register);
                f.write_str(row.map_or("", |(word, _)| word))
            }
        }
    }
}
