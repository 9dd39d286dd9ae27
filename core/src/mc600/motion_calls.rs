//! Motion, drive and I/O calls: the seam between the language and the machine.

use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::machine::{Machine, MotionCommand};
use super::value::to_integer;

/// The calls in the order of their numbers.
const CALLS: [Keyword; 8] = [
    Keyword::Mspeed,
    Keyword::Mmove,
    Keyword::Mimove,
    Keyword::Midle,
    Keyword::Mdrven,
    Keyword::Mdrvdis,
    Keyword::Mclrfault,
    Keyword::Outw,
];

/// The number that compiled programs know a call by; `None` for what does not work yet.
pub fn number(keyword: Keyword) -> Option<u16> {
    let position = CALLS.iter().position(|&call| call == keyword)?;
    u16::try_from(position).ok()
}

/// Checks a call whole and gives the command; what only writes outputs is done at once.
///
/// # Errors
/// ILLEGAL QUANTITY for an argument that does not fit.
pub fn command(
    number: u16,
    argument: f64,
    machine: &mut Machine,
) -> Result<Option<MotionCommand>, ErrorCode> {
    let value = || to_integer(argument);
    Ok(Some(match CALLS.get(usize::from(number)) {
        Some(Keyword::Mspeed) => MotionCommand::Speed(value()?),
        Some(Keyword::Mmove) => MotionCommand::Move(value()?),
        Some(Keyword::Mimove) => MotionCommand::MoveBy(value()?),
        Some(Keyword::Midle) => MotionCommand::Idle,
        Some(Keyword::Mdrven) => MotionCommand::EnableDrive,
        Some(Keyword::Mdrvdis) => MotionCommand::DisableDrive,
        Some(Keyword::Mclrfault) => MotionCommand::ClearFault,
        _ => {
            machine.write_outputs(u8::try_from(value()?).map_err(|_| ErrorCode::IllegalQuantity)?);
            return Ok(None);
        }
    }))
}
