//! The serial console: what is typed becomes lines, what is printed goes out as fast as the line allows.

use std::collections::VecDeque;

use super::firmware::{COLUMNS, LINE_LENGTH};
use crate::controller::{Output, Ports};
use crate::serial::{Flow, Frame, LineSettings, Receiver, Transmitter, XOFF, XON};
use crate::time::Nanos;

/// Bytes that are kept until they are read (D41).
const RING: usize = 256;
/// The other side is stopped at this many, and let go again at the second figure (D41: three quarters, a quarter).
const RING_HIGH: usize = RING * 3 / 4;
const RING_LOW: usize = RING / 4;
/// Printing waits while more bytes than this have not been sent (D42).
const PENDING: usize = 16;

const CTRL_C: u8 = 0x03;
const BACKSPACE: u8 = 0x08;
/// Erases the last character typed, as backspace does.
pub const DELETE: u8 = 0x7F;

/// How typed characters come back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Echo {
    /// As they are.
    Plain,
    /// A star for each: a password.
    Stars,
}

/// The console's end of the serial line, and the line that is being typed.
#[derive(Debug, Clone)]
pub struct Console {
    receiver: Receiver,
    transmitter: Transmitter,
    ring: VecDeque<u8>,
    /// XOFF was sent and XON is owed.
    stopped_host: bool,
    /// Ctrl-C came.
    attention: bool,
    line: Vec<u8>,
    column: usize,
    /// How typed characters come back.
    pub echo: Echo,
}

/// A line that was typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Typed {
    /// Without its RETURN.
    pub text: Vec<u8>,
    /// It had more than 80 characters; the rest is lost.
    pub too_long: bool,
}

impl Console {
    /// A console on an idle line.
    pub fn new(settings: LineSettings) -> Console {
        Console {
            receiver: Receiver::new(settings),
            transmitter: Transmitter::new(settings),
            ring: VecDeque::new(),
            stopped_host: false,
            attention: false,
            line: Vec::new(),
            column: 0,
            echo: Echo::Plain,
        }
    }

    /// A character has passed on the wire.
    pub fn accept(&mut self, frame: Frame) {
        self.receiver.accept(frame);
    }

    /// Reads what has arrived by `now`. Ctrl-C is taken here and throws away what was typed ahead (D43).
    pub fn receive(&mut self, now: Nanos) {
        while let Some(received) = self.receiver.next(now) {
            match received.byte {
                CTRL_C => {
                    self.attention = true;
                    self.ring.clear();
                }
                XOFF if self.transmitter.settings().flow == Flow::XonXoff => {
                    self.transmitter.hold(true)
                }
                XON if self.transmitter.settings().flow == Flow::XonXoff => {
                    self.transmitter.hold(false)
                }
                byte if self.ring.len() < RING => self.ring.push_back(byte),
                // A host that does not obey XOFF loses characters, as on the device.
                _ => {}
            }
        }
        if self.ring.len() >= RING_HIGH && !self.stopped_host {
            self.stopped_host = true;
            self.transmitter.push_urgent(XOFF);
        } else if self.ring.len() <= RING_LOW && self.stopped_host {
            self.stopped_host = false;
            self.transmitter.push_urgent(XON);
        }
    }

    /// Whether Ctrl-C came since the last call.
    pub fn take_attention(&mut self) -> bool {
        std::mem::take(&mut self.attention)
    }

    /// Throws away what has not been sent, and what was typed of the present line. XOFF no longer holds: who presses
    /// Ctrl-C wants an answer.
    pub fn discard(&mut self) {
        self.transmitter.discard();
        self.transmitter.hold(false);
        if self.stopped_host {
            self.transmitter.push_urgent(XON);
            self.stopped_host = false;
        }
        self.line.clear();
    }

    /// Reads typed characters until a line is complete; `None` until then.
    pub fn take_line(&mut self) -> Option<Typed> {
        while self.transmitter.pending() <= PENDING {
            match self.ring.pop_front()? {
                b'\r' => {
                    self.put(b"\r\n");
                    let mut text = std::mem::take(&mut self.line);
                    let too_long = text.len() > LINE_LENGTH;
                    text.truncate(LINE_LENGTH);
                    return Some(Typed { text, too_long });
                }
                BACKSPACE | DELETE => {
                    if self.line.pop().is_some() {
                        self.put(b"\x08 \x08");
                    }
                }
                byte => self.typed(if byte == b'\t' { b' ' } else { byte }),
            }
        }
        None
    }

    /// Other control characters mean nothing and leave no trace (D53).
    fn typed(&mut self, byte: u8) {
        if byte < b' ' {
            return;
        }
        if self.line.len() <= LINE_LENGTH {
            self.line.push(byte);
        }
        self.put(&[if self.echo == Echo::Stars { b'*' } else { byte }]);
    }

    /// Sends bytes whatever is pending: echoes and short messages.
    pub fn put(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.column = column_after(self.column, byte);
            self.transmitter.push(byte);
        }
    }

    /// Sends as many bytes as may be pending, and says how many.
    pub fn print(&mut self, bytes: &[u8]) -> usize {
        let room = (PENDING + 1).saturating_sub(self.transmitter.pending());
        let taken = room.min(bytes.len());
        self.put(bytes.get(..taken).unwrap_or_default());
        taken
    }

    /// Where the next character will stand on the 80-column line, from 0.
    pub fn column(&self) -> usize {
        self.column
    }

    /// Where it will stand behind these bytes.
    pub fn column_behind(&self, bytes: &[u8]) -> usize {
        bytes
            .iter()
            .fold(self.column, |column, &byte| column_after(column, byte))
    }

    /// Received bytes that no one has read, the line being typed included.
    pub fn unread(&self) -> usize {
        self.ring.len()
    }

    /// Whether something is typed and not ended by RETURN.
    pub fn is_typing(&self) -> bool {
        !self.line.is_empty()
    }

    /// Printed bytes that have not begun to be sent.
    pub fn unsent(&self) -> usize {
        self.transmitter.pending()
    }

    /// Sends what begins before `until`.
    pub fn transmit(&mut self, now: Nanos, until: Nanos, ports: &mut Ports) {
        while let Some(frame) = self.transmitter.next_frame(now, until) {
            ports.outputs.push((
                frame.end(),
                Output::Frame {
                    connector: 0,
                    frame,
                },
            ));
        }
    }
}

fn column_after(column: usize, byte: u8) -> usize {
    match byte {
        b'\r' => 0,
        BACKSPACE => column.saturating_sub(1),
        byte if byte < b' ' => column,
        _ => (column + 1) % COLUMNS,
    }
}
