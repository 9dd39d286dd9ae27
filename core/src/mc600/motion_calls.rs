//! Motion, drive and I/O calls: the seam between the language and the machine.

use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::machine::{Compared, IDENTIFIERS, MAILBOXES, MotionCommand};
use super::planner::gear::GearType;
use super::value::to_integer;

/// The calls in the order of their numbers, with the arguments that each takes.
const CALLS: [(Keyword, usize); 29] = [
    (Keyword::Mspeed, 1),
    (Keyword::Mmove, 1),
    (Keyword::Mimove, 1),
    (Keyword::Mmerge, 1),
    (Keyword::Mimerge, 1),
    (Keyword::Mgear, 1),
    (Keyword::Mcam, 1),
    (Keyword::Mcamhard, 1),
    (Keyword::Mcamend, 0),
    (Keyword::Mspline, 3),
    (Keyword::Mvirtualax, 1),
    (Keyword::Mvspeed, 1),
    (Keyword::Mphase, 1),
    (Keyword::Midle, 0),
    (Keyword::Mhome, 1),
    (Keyword::Intdisable, 0),
    (Keyword::Intenable, 0),
    (Keyword::Intsetup, 3),
    (Keyword::Mquotecmp, 4),
    (Keyword::Mclrfault, 0),
    (Keyword::Mdrven, 0),
    (Keyword::Mdrvdis, 0),
    (Keyword::Sdowrite, 2),
    (Keyword::Msetoutcmp, 2),
    (Keyword::Msetincap, 3),
    (Keyword::Outw, 1),
    (Keyword::Msetsb, 1),
    (Keyword::Mcantx, 2),
    (Keyword::Mcanrx, 2),
];

/// Most arguments of a call.
pub const ARGUMENTS: usize = 4;

fn position(keyword: Keyword) -> Option<usize> {
    let mut calls = CALLS.iter();
    calls.position(|&(call, _)| call == keyword)
}

/// The number that compiled programs know a call by; `None` for what is none.
pub fn number(keyword: Keyword) -> Option<u16> {
    u16::try_from(position(keyword)?).ok()
}

/// The call with that number.
pub fn by_number(number: u16) -> Option<Keyword> {
    CALLS.get(usize::from(number)).map(|&(keyword, _)| keyword)
}

/// How many arguments a call takes that is a statement by itself.
pub fn arguments(keyword: Keyword) -> Option<usize> {
    CALLS.get(position(keyword)?).map(|&(_, count)| count)
}

/// Whether an argument is the name of a table.
pub fn takes_table(keyword: Keyword, argument: usize) -> bool {
    match keyword {
        Keyword::Mcam | Keyword::Mcamhard => argument == 0,
        Keyword::Mspline => argument == 0 || argument == 2,
        _ => false,
    }
}

/// Checks a call whole and gives the command; `None` for those that are no order to the machine.
///
/// # Errors
/// ILLEGAL QUANTITY for an argument that does not fit.
pub fn command(
    keyword: Keyword,
    arguments: [f64; ARGUMENTS],
) -> Result<Option<MotionCommand>, ErrorCode> {
    let [first, second, third, fourth] = arguments;
    let value = || to_integer(first);
    Ok(Some(match keyword {
        Keyword::Mspeed => MotionCommand::Speed(value()?),
        Keyword::Mmove => MotionCommand::Move(value()?),
        Keyword::Mimove => MotionCommand::MoveBy(value()?),
        Keyword::Mmerge => MotionCommand::Merge(value()?),
        Keyword::Mimerge => MotionCommand::MergeBy(value()?),
        Keyword::Mgear => {
            let kind = GearType::from_number(value()?).ok_or(ErrorCode::IllegalQuantity)?;
            MotionCommand::Gear(value()?, kind)
        }
        Keyword::Mcam => MotionCommand::Cam,
        Keyword::Mcamhard => MotionCommand::CamHard,
        Keyword::Mcamend => MotionCommand::CamEnd,
        Keyword::Mvirtualax => MotionCommand::VirtualAxis(value()?),
        Keyword::Mvspeed => MotionCommand::VirtualSpeed(value()?),
        Keyword::Mphase => MotionCommand::Phase(value()?),
        Keyword::Midle => MotionCommand::Idle,
        Keyword::Mhome => match value()? {
            1 => MotionCommand::Home { start: true },
            2 => MotionCommand::Home { start: false },
            _ => return Err(ErrorCode::IllegalQuantity),
        },
        Keyword::Mclrfault => MotionCommand::ClearFault,
        Keyword::Mdrven => MotionCommand::EnableDrive,
        Keyword::Mdrvdis => MotionCommand::DisableDrive,
        Keyword::Mquotecmp => MotionCommand::Comparator {
            source: match value()? {
                0 => Compared::Feedback,
                1 => Compared::Master,
                2 => Compared::CamMaster,
                _ => return Err(ErrorCode::IllegalQuantity),
            },
            number: small(second, 7)?,
            on: to_integer(third)?,
            off: to_integer(fourth)?,
        },
        Keyword::Msetoutcmp => MotionCommand::OutputComparator {
            on: value()?,
            off: to_integer(second)?,
        },
        Keyword::Msetincap => MotionCommand::Capture {
            input: small(first, 1)?,
            edge: small(second, 3)?,
            delay: to_integer(third)
                .ok()
                .filter(|delay| *delay >= 0)
                .ok_or(ErrorCode::IllegalQuantity)?,
        },
        Keyword::Msetsb => MotionCommand::BusMaster(small(first, 1)? == 1),
        Keyword::Mcantx => MotionCommand::Transmit {
            identifier: identifier(first)?,
            data: to_integer(second)?,
        },
        Keyword::Mcanrx => MotionCommand::Mailbox {
            number: small(first, MAILBOXES - 1)?,
            identifier: identifier(second)?,
        },
        _ => return Ok(None),
    }))
}

/// A number from 0 to `most`.
pub fn small(value: f64, most: u8) -> Result<u8, ErrorCode> {
    u8::try_from(to_integer(value)?)
        .ok()
        .filter(|value| *value <= most)
        .ok_or(ErrorCode::IllegalQuantity)
}

/// An identifier of the ServoBus.
fn identifier(value: f64) -> Result<u16, ErrorCode> {
    u16::try_from(to_integer(value)?)
        .ok()
        .filter(|identifier| IDENTIFIERS.contains(identifier))
        .ok_or(ErrorCode::IllegalQuantity)
}
