//! The IEEE-488 bus: what its controller sends, how a device is addressed, and what stands on its lines.
//!
//! `device` is the interface of a device, `controller` the bench's side. A byte is handed over whole: of the handshake
//! remains that a listener may hold the next one off.

mod controller;
mod device;

pub(crate) use controller::Step;
pub use controller::{Controller, Order, Report};
pub use device::{Device, Heard};

/// The highest address.
pub const LAST_ADDRESS: u8 = 30;

/// What the controller of the bus sends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Message {
    /// A byte with ATN: an interface message.
    Command(u8),
    /// A byte without ATN, for those that listen.
    Data {
        /// The byte.
        byte: u8,
        /// It comes with EOI: the last one.
        end: bool,
    },
    /// The byte that the talker offers has been taken.
    Accepted,
    /// IFC: no one talks or listens any more.
    InterfaceClear,
    /// The REN line.
    RemoteEnable(bool),
}

/// What a device puts on the bus.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Lines {
    /// SRQ.
    pub service: bool,
    /// It is addressed to listen.
    pub listens: bool,
    /// It is addressed to listen and not ready for data (NRFD).
    pub holds_off: bool,
    /// It is addressed to talk.
    pub talks: bool,
    /// What it offers as the talker, and whether with EOI.
    pub data: Option<(u8, bool)>,
    /// Its answer to a parallel poll: one bit or none.
    pub parallel: u8,
}

/// What an interface message says; the address of a talker or listener is in it.
pub(crate) mod command {
    #![allow(missing_docs)]
    pub const GO_TO_LOCAL: u8 = 0x01;
    pub const SELECTED_CLEAR: u8 = 0x04;
    pub const TRIGGER: u8 = 0x08;
    pub const LOCAL_LOCKOUT: u8 = 0x11;
    pub const DEVICE_CLEAR: u8 = 0x14;
    pub const POLL_ENABLE: u8 = 0x18;
    pub const POLL_DISABLE: u8 = 0x19;
    pub const LISTEN: u8 = 0x20;
    pub const UNLISTEN: u8 = 0x3F;
    pub const TALK: u8 = 0x40;
    pub const UNTALK: u8 = 0x5F;
}
