//! What a program orders of the motor; written as in the program.

use std::fmt;

use super::ports::Port;
use super::status::Flag;

/// A command word without an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Command {
    /// `G`: starts what is buffered.
    Go,
    /// `X`: decelerates to a stop.
    Decelerate,
    /// `S`: stops at once and holds.
    StopNow,
    /// `OFF`: the motor is without torque.
    Off,
    /// A mode word: `MP`, `MV`, `MFR` and so on.
    Mode(ModeWord),
    /// `F`: loads the buffered gains into the filter.
    LoadFilter,
    /// `KGON`: the gravity term acts.
    GravityOn,
    /// `KGOFF`: it does not.
    GravityOff,
    /// `PID1`, `PID2`, `PID4`, `PID8`: the servo runs every so many samples.
    ServoDivisor(u8),
    /// A brake word.
    Brake(Brake),
    /// `BRKC`, `BRKG`: the brake signal leaves by a pin as well; `BRKI`: by none.
    BrakePin(Option<Port>),
    /// `LIMD`: a limit stops motion in its own direction only.
    LimitsDirectional,
    /// `LIMN`: a limit that becomes active stops motion in the other direction too.
    LimitsNondirectional,
    /// `LIMH`: a limit is active while its input is high.
    LimitsHigh,
    /// `LIML`: a limit is active while its input is low.
    LimitsLow,
    /// `UAI` to `UGI`: the pin is a plain input.
    Input(Port),
    /// `UAO` to `UGO`: the pin is an output.
    Output(Port),
    /// `UCP`: pin C is the right limit.
    RightLimit,
    /// `UDM`: pin D is the left limit.
    LeftLimit,
    /// `UG`: pin G is the GO input.
    GoInput,
    /// `ZS`: clears all latched bits.
    ClearAll,
    /// `Za` and so on: clears one.
    Clear(Flag),
}

/// Words that choose what G starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModeWord {
    /// `MP`: position.
    Position,
    /// `MV`: velocity.
    Velocity,
    /// `MT`: torque, at once.
    Torque,
    /// `MD`: contouring with positions from the host.
    Contour,
    /// `MF0`: counts the encoder on pins A and B from zero; does not follow.
    Count,
    /// `MF1`, `MF2`, `MF4`: follows with 1, 2 or 4 counts a cycle of the encoder.
    Follow(u8),
    /// `MFR`: follows by MFMUL / MFDIV.
    FollowRatio,
    /// `MS0`: counts steps on A with direction on B from zero; does not follow.
    CountSteps,
    /// `MS`: follows the steps.
    Steps,
    /// `MSR`: follows the steps by MFMUL / MFDIV.
    StepsRatio,
    /// `MC`, `MC2`, `MC4`, `MC8`: the cam of the table in aw[], its entries times so many.
    Cam(u8),
}

/// When the brake is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Brake {
    /// `BRKENG`: on.
    Engaged,
    /// `BRKRLS`: off.
    Released,
    /// `BRKSRV`: on while the motor is off.
    Servo,
    /// `BRKTRJ`: on while there is no trajectory.
    Trajectory,
}

/// Words of one meaning; pins (`UAI`, `UAO`) are made of the port's.
const WORDS: [(&str, Command); 49] = [
    ("G", Command::Go),
    ("X", Command::Decelerate),
    ("S", Command::StopNow),
    ("OFF", Command::Off),
    ("MP", Command::Mode(ModeWord::Position)),
    ("MV", Command::Mode(ModeWord::Velocity)),
    ("MT", Command::Mode(ModeWord::Torque)),
    ("MD", Command::Mode(ModeWord::Contour)),
    ("MF0", Command::Mode(ModeWord::Count)),
    ("MF1", Command::Mode(ModeWord::Follow(1))),
    ("MF2", Command::Mode(ModeWord::Follow(2))),
    ("MF4", Command::Mode(ModeWord::Follow(4))),
    ("MFR", Command::Mode(ModeWord::FollowRatio)),
    ("MS0", Command::Mode(ModeWord::CountSteps)),
    ("MS", Command::Mode(ModeWord::Steps)),
    ("MSR", Command::Mode(ModeWord::StepsRatio)),
    ("MC", Command::Mode(ModeWord::Cam(1))),
    ("MC2", Command::Mode(ModeWord::Cam(2))),
    ("MC4", Command::Mode(ModeWord::Cam(4))),
    ("MC8", Command::Mode(ModeWord::Cam(8))),
    ("F", Command::LoadFilter),
    ("KGON", Command::GravityOn),
    ("KGOFF", Command::GravityOff),
    ("PID1", Command::ServoDivisor(1)),
    ("PID2", Command::ServoDivisor(2)),
    ("PID4", Command::ServoDivisor(4)),
    ("PID8", Command::ServoDivisor(8)),
    ("BRKENG", Command::Brake(Brake::Engaged)),
    ("BRKRLS", Command::Brake(Brake::Released)),
    ("BRKSRV", Command::Brake(Brake::Servo)),
    ("BRKTRJ", Command::Brake(Brake::Trajectory)),
    ("BRKC", Command::BrakePin(Some(Port::C))),
    ("BRKG", Command::BrakePin(Some(Port::G))),
    ("BRKI", Command::BrakePin(None)),
    ("LIMD", Command::LimitsDirectional),
    ("LIMN", Command::LimitsNondirectional),
    ("LIMH", Command::LimitsHigh),
    ("LIML", Command::LimitsLow),
    ("UCP", Command::RightLimit),
    ("UDM", Command::LeftLimit),
    ("UG", Command::GoInput),
    ("ZS", Command::ClearAll),
    ("Za", Command::Clear(Flag::OverCurrent)),
    ("Zd", Command::Clear(Flag::MathOverflow)),
    ("Zl", Command::Clear(Flag::LeftLimit)),
    ("Zr", Command::Clear(Flag::RightLimit)),
    ("Zs", Command::Clear(Flag::Syntax)),
    ("Zu", Command::Clear(Flag::IndexRange)),
    ("Zw", Command::Clear(Flag::Wrap)),
];

impl Command {
    /// The command that a program means by `word`.
    pub fn from_word(word: &str) -> Option<Command> {
        let pin = |suffix| word.strip_suffix(suffix).and_then(Port::from_word);
        let row = WORDS.iter().find(|(known, _)| *known == word);
        row.map(|(_, command)| *command)
            .or_else(|| pin('I').map(Command::Input))
            .or_else(|| pin('O').map(Command::Output))
    }
}

impl fmt::Display for Command {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Command::Input(port) => write!(f, "{port}I"),
            Command::Output(port) => write!(f, "{port}O"),
            command => {
                let row = WORDS.iter().find(|(_, known)| known == command);
                f.write_str(row.map_or("", |(word, _)| word))
            }
        }
    }
}
