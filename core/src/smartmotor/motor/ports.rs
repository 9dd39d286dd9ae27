//! The seven pins UA to UG.

use std::fmt;

/// A pin of the I/O connector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Port {
    /// Encoder A, or steps.
    A,
    /// Encoder B, or direction.
    B,
    /// Right (positive) limit.
    C,
    /// Left (negative) limit.
    D,
    /// General.
    E,
    /// General.
    F,
    /// GO input.
    G,
}

impl Port {
    /// All, in order.
    pub const ALL: [Port; 7] = [
        Port::A,
        Port::B,
        Port::C,
        Port::D,
        Port::E,
        Port::F,
        Port::G,
    ];

    /// `UA` to `UG`.
    pub fn from_word(word: &str) -> Option<Port> {
        Port::ALL.into_iter().find(|port| port.to_string() == word)
    }

    /// 0 to 6.
    pub const fn number(self) -> u8 {
        self as u8
    }
}

/// `UA` to `UG`.
impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "U{self:?}")
    }
}
