//! What ends a program or is refused: the message on the display and the error bits of the status (Appendix 2, 3).

use super::indexer::Axis;

/// An error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trouble {
    /// A character that has no meaning where it stands.
    IllegalCharacter,
    /// An N code.
    N,
    /// A G code.
    G,
    /// A feedrate.
    F,
    /// An M code.
    M,
    /// A dwell.
    D,
    /// Numerals without a command before them.
    NoCommand,
    /// More than sixteen levels, or a return without a call.
    Stack,
    /// There is no end of block to skip to.
    EndOfBlock,
    /// The program is not in memory.
    NoProgram,
    /// A limit switch.
    Limit(Axis),
    /// The precompilation of a program.
    Compile(u8),
    /// No room for another character.
    BufferFull,
    /// The firmware's own, by number: it stands still until it is reset.
    Internal(u8),
}

impl Trouble {
    /// What the display says (spec, "Messages").
    pub fn text(self) -> String {
        match self {
            Trouble::IllegalCharacter | Trouble::NoCommand => "ILL.CHAR".to_owned(),
            Trouble::N => "-N-ERROR".to_owned(),
            Trouble::G => "-G-ERROR".to_owned(),
            Trouble::F => "-F-ERROR".to_owned(),
            Trouble::M => "-M-ERROR".to_owned(),
            Trouble::D => "-D-ERROR".to_owned(),
            Trouble::Stack => "STK OVFL".to_owned(),
            Trouble::EndOfBlock => "EOB ERR".to_owned(),
            Trouble::NoProgram => "NO PGM".to_owned(),
            Trouble::Limit(Axis::X) => "-X-LIMIT".to_owned(),
            Trouble::Limit(Axis::Y) => "-Y-LIMIT".to_owned(),
            Trouble::Compile(number) => format!("C-ERR {number:02}"),
            Trouble::BufferFull => "BUF FULL".to_owned(),
            Trouble::Internal(number) => format!("ERROR {number:02}"),
        }
    }
}

/// Status bytes 6 to 8. Bit 7 of each says that another is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Errors {
    syntax: u8,
    run: u8,
    editor: u8,
}

impl Errors {
    /// Sets the bits of an error.
    pub fn note(&mut self, trouble: Trouble) {
        let (byte, bit) = match trouble {
            Trouble::NoCommand => (&mut self.syntax, 0),
            Trouble::D => (&mut self.syntax, 1),
            Trouble::M => (&mut self.syntax, 2),
            Trouble::F => (&mut self.syntax, 3),
            Trouble::G => (&mut self.syntax, 4),
            Trouble::N => (&mut self.syntax, 5),
            Trouble::IllegalCharacter => (&mut self.syntax, 6),
            Trouble::NoProgram => (&mut self.run, 0),
            Trouble::EndOfBlock => (&mut self.run, 1),
            Trouble::Stack => (&mut self.run, 3),
            Trouble::Limit(Axis::Y) => (&mut self.run, 5),
            Trouble::Limit(Axis::X) => (&mut self.run, 6),
            Trouble::Compile(_) => (&mut self.editor, 0),
            Trouble::BufferFull => (&mut self.editor, 1),
            Trouble::Internal(_) => return,
        };
        *byte |= 0x80 | 1 << bit;
    }

    /// Syntax, run and editor errors.
    pub fn bytes(self) -> [u8; 3] {
        [self.syntax, self.run, self.editor]
    }

    /// Whether any bit is set.
    pub fn any(self) -> bool {
        self != Errors::default()
    }
}
