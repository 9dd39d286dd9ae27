//! The keys of the front panel, what is printed on them, and what they mean.
//!
//! A pad key has two legends, and in message entry two characters: unshifted and shifted (spec, "Keycap layout").

/// One key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Key {
    Edit,
    Auto,
    Single,
    Immediate,
    Remote,
    Execute,
    Print,
    Reset,
    Shift,
    Step,
    Backstep,
    Slew,
    ClearEntry,
    /// One of the sixteen of the pad, by its unshifted character.
    Pad(u8),
    Right,
    Left,
    Up,
    Down,
    ClearX,
    ClearY,
}

/// What a key stands for, SHIFT taken into account.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A character of a program or a message.
    Character(u8),
    /// A function, also of a mode key.
    Function(Function),
}

/// What keys do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Function {
    Edit,
    Auto,
    Single,
    Immediate,
    Remote,
    Execute,
    Print,
    Step,
    Backstep,
    Slew,
    Search,
    ClearEntry,
    ClearCommand,
}

/// The pad: unshifted character, shifted legend where it is one of a program, shifted character of a message.
const PAD: [(u8, Option<u8>, u8); 16] = [
    (b'7', Some(b'G'), b'G'),
    (b'8', Some(b'F'), b'F'),
    (b'9', None, b'H'),
    (b'=', Some(b'X'), b'X'),
    (b'4', None, b'J'),
    (b'5', None, b'O'),
    (b'6', None, b'Q'),
    (b'-', Some(b'Y'), b'Y'),
    (b'1', None, b'B'),
    (b'2', None, b'C'),
    (b'3', None, b'U'),
    (b'*', Some(b'M'), b'M'),
    (b'0', None, b'V'),
    (b'<', Some(b'D'), b'D'),
    (b'>', Some(b'N'), b'N'),
    (b'+', Some(b'"'), b'"'),
];

/// Function keys: name, key, what it does, shifted; then its characters in a message.
type FunctionKey = (&'static str, Key, Function, Function, Option<(u8, u8)>);
const FUNCTIONS: [FunctionKey; 11] = {
    use Function::{
        Auto, Backstep, ClearCommand, ClearEntry, Edit, Execute, Immediate, Print, Remote, Search,
        Single, Slew, Step,
    };
    [
        ("EDT", Key::Edit, Edit, Edit, Some((b'E', b'E'))),
        ("AUT", Key::Auto, Auto, Auto, Some((b'A', b'A'))),
        ("SGL", Key::Single, Single, Single, Some((b'S', b'S'))),
        (
            "IMD",
            Key::Immediate,
            Immediate,
            Immediate,
            Some((b'I', b'I')),
        ),
        ("RMT", Key::Remote, Remote, Remote, Some((b'R', b'R'))),
        ("EXC", Key::Execute, Execute, Execute, None),
        ("PRT", Key::Print, Print, Print, Some((b'P', b'/'))),
        ("STP", Key::Step, Step, Step, Some((b'T', b'W'))),
        ("BST", Key::Backstep, Backstep, Backstep, Some((b'K', b'Z'))),
        ("SLW", Key::Slew, Slew, Search, Some((b'L', b' '))),
        ("CE", Key::ClearEntry, ClearEntry, ClearCommand, None),
    ]
};

/// Every name that a key is pressed by: keys, their shifted legends, characters of messages.
pub const NAMES: [&str; 67] = [
    "EDT", "AUT", "SGL", "IMD", "RMT", "EXC", "PRT", "RES", "SHIFT", "STP", "BST", "SCH", "SLW",
    "CE", "CC", "UP", "DOWN", "LEFT", "RIGHT", "CLRX", "CLRY", "0", "1", "2", "3", "4", "5", "6",
    "7", "8", "9", "=", "-", "*", "<", ">", "+", "G", "X", "Y", "F", "M", "D", "N", "\"", "H", "J",
    "O", "Q", "B", "C", "U", "V", "A", "E", "S", "I", "R", "P", "T", "K", "L", "W", "Z", "/",
    "SPACE", " ",
];

/// The key of that name; `true` if the name is a shifted legend, which is meant whether or not SHIFT is lit.
pub fn named(name: &str) -> Option<(Key, bool)> {
    let plain = match name {
        "RES" => Some(Key::Reset),
        "SHIFT" => Some(Key::Shift),
        "UP" => Some(Key::Up),
        "DOWN" => Some(Key::Down),
        "LEFT" => Some(Key::Left),
        "RIGHT" => Some(Key::Right),
        "CLRX" => Some(Key::ClearX),
        "CLRY" => Some(Key::ClearY),
        "CC" => return Some((Key::ClearEntry, true)),
        "SCH" | "SPACE" => return Some((Key::Slew, true)),
        _ => None,
    };
    if let Some(key) = plain {
        return Some((key, false));
    }
    if let Some(&(_, key, ..)) = FUNCTIONS.iter().find(|row| row.0 == name) {
        return Some((key, false));
    }
    let &[character] = name.as_bytes() else {
        return None;
    };
    let character = character.to_ascii_uppercase();
    if let Some(&(unshifted, ..)) = PAD.iter().find(|row| row.0 == character) {
        return Some((Key::Pad(unshifted), false));
    }
    if let Some(&(unshifted, ..)) = PAD.iter().find(|row| row.2 == character) {
        return Some((Key::Pad(unshifted), true));
    }
    FUNCTIONS.iter().find_map(|&(_, key, _, _, characters)| {
        let (unshifted, shifted) = characters?;
        match character {
            c if c == unshifted => Some((key, false)),
            c if c == shifted => Some((key, true)),
            _ => None,
        }
    })
}

/// The keyword table's word for a key; pad keys have none.
pub fn word(key: Key, shifted: bool) -> Option<&'static str> {
    Some(match key {
        Key::Reset => "RES",
        Key::Shift => "SHIFT",
        Key::Up => "UP",
        Key::Down => "DOWN",
        Key::Left => "LEFT",
        Key::Right => "RIGHT",
        Key::ClearX => "CLRX",
        Key::ClearY => "CLRY",
        Key::ClearEntry if shifted => "CC",
        Key::Slew if shifted => "SCH",
        Key::Pad(_) => return None,
        key => FUNCTIONS.iter().find(|row| row.1 == key)?.0,
    })
}

/// What a key means; `None` where nothing is printed on it, or it is none of those that type.
pub fn stroke(key: Key, shifted: bool, message: bool) -> Option<Stroke> {
    if let Key::Pad(unshifted) = key {
        let &(_, legend, character) = PAD.iter().find(|row| row.0 == unshifted)?;
        return match (shifted, message) {
            (false, _) => Some(Stroke::Character(unshifted)),
            (true, false) => legend.map(Stroke::Character),
            (true, true) => Some(Stroke::Character(character)),
        };
    }
    let &(_, _, plain, other, characters) = FUNCTIONS.iter().find(|row| row.1 == key)?;
    Some(match (message, characters) {
        (true, Some((unshifted, _))) if !shifted => Stroke::Character(unshifted),
        (true, Some((_, shifted))) => Stroke::Character(shifted),
        _ if shifted => Stroke::Function(other),
        _ => Stroke::Function(plain),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_key() {
        for name in NAMES {
            assert!(named(name).is_some(), "{name}");
        }
        assert_eq!(named("@"), None);
        assert_eq!(named("NO"), None);
    }

    #[test]
    fn every_character_of_a_message_has_a_key() {
        for character in b"ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789=-*<>+/ " {
            let name = char::from(*character).to_string();
            let (key, shifted) = named(&name).unwrap();
            let expected = Some(Stroke::Character(*character));
            assert_eq!(stroke(key, shifted, true), expected, "{name}");
        }
    }
}
