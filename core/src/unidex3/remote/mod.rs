//! The remote interface: bytes become lines, lines become commands for the units that are addressed (4; Appendix 1).
//!
//! `commands` carries them out, `edit` takes the text of a program, `replies` sends what was asked for. `bus` is the other
//! way that bytes come.

mod bus;
mod commands;
mod edit;
mod replies;

use std::collections::VecDeque;
use std::rc::Rc;

use super::{Link, Unidex3};
use crate::ieee488::{Device, LAST_ADDRESS};
use crate::time::Nanos;
pub(super) use commands::word;
use edit::OpenEdit;

const ESCAPE: u8 = 0x1B;
const DELETE: u8 = 0x7F;
/// Characters of a command; the immediate mode's block is the longest.
const LONGEST_LINE: usize = 300;
/// Commands that wait for a poll.
const MOST_WAITING: usize = 4096;
/// Bytes of replies beyond which the next is not begun.
const MOST_UNSENT: usize = 1 << 15;
/// Bytes that the firmware takes in one sample: more than any line brings.
const BYTES_A_SAMPLE: usize = 64;

/// What was started last, and is by a bare CR LF again.
#[derive(Debug, Clone)]
enum Again {
    Auto(u8),
    Single(u8),
    Immediate(Rc<[u8]>),
}

/// Where `E N` stands (2-7 E).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum EndEntry {
    #[default]
    None,
    /// `ENTER >>` is shown; the code comes next.
    Code,
}

/// Which interface the controller uses: one at a time (4-3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Interface {
    /// RS-232C or RS-422A.
    #[default]
    Serial,
    /// IEEE-488.
    Bus,
}

/// The state of the interface.
#[derive(Debug, Clone)]
pub struct Remote {
    /// The one that is active, or was last.
    pub interface: Interface,
    /// The connector to the IEEE-488 bus.
    pub bus: Device,
    /// The line so far.
    line: Vec<u8>,
    /// The first of CR and LF that has ended a line: the other one belongs to it.
    ended_by: Option<u8>,
    /// The line end that comes belongs to the `%` or `&` before it.
    ends_edit: bool,
    addressed: bool,
    /// Which of the addressed units this is, from 0, and how many there are.
    turn: (u32, u32),
    /// How often each reply was asked for since addressing.
    asked: [u32; replies::TURNS],
    requesting: bool,
    /// The request is yet to be sent.
    announce: bool,
    /// W: sent instead of raising RTS.
    string: Option<Vec<u8>>,
    /// U: status in hexadecimal digits.
    pub hexadecimal: bool,
    /// K: one unit raises RTS for all; J: all have to.
    pub parallel: bool,
    /// The next start is held.
    hold: bool,
    held: Option<Again>,
    again: Option<Again>,
    edit: Option<OpenEdit>,
    end_entry: EndEntry,
    /// Commands that wait for a poll, or for the end of what runs.
    waiting: VecDeque<Vec<u8>>,
    /// The last reply was a listing.
    lists: bool,
    /// What V has found, until it is polled.
    pub test_result: Option<u8>,
    /// The RTS lines of the units behind in the chain, combined; an open input is low.
    behind: bool,
}

impl Default for Remote {
    fn default() -> Remote {
        Remote {
            interface: Interface::default(),
            bus: Device::default(),
            line: Vec::new(),
            ended_by: None,
            ends_edit: false,
            addressed: false,
            turn: (0, 1),
            asked: [0; replies::TURNS],
            requesting: false,
            announce: false,
            string: None,
            hexadecimal: false,
            parallel: true,
            hold: false,
            held: None,
            again: None,
            edit: None,
            end_entry: EndEntry::None,
            waiting: VecDeque::new(),
            lists: false,
            test_result: None,
            behind: false,
        }
    }
}

impl Remote {
    /// As after power-up; the cables stay.
    pub fn switched_on(&self) -> Remote {
        Remote {
            bus: self.bus.initialized(),
            behind: self.behind,
            ..Remote::default()
        }
    }

    /// What the interface keeps when the device is cleared: its address and how it requests (D257).
    pub fn cleared(self) -> Remote {
        Remote {
            line: Vec::new(),
            requesting: false,
            announce: false,
            hold: false,
            held: None,
            again: None,
            edit: None,
            end_entry: EndEntry::None,
            waiting: VecDeque::new(),
            test_result: None,
            ..self
        }
    }

    /// Requests service.
    pub fn request(&mut self) {
        if !self.requesting {
            self.requesting = true;
            self.announce = true;
        }
    }

    /// The request is answered by a poll.
    pub fn answer_request(&mut self) {
        self.requesting = false;
        self.announce = false;
        self.test_result = None;
    }

    /// Whether a request waits for its poll.
    pub fn is_requesting(&self) -> bool {
        self.requesting
    }

    /// Whether commands are for this unit.
    pub fn is_addressed(&self) -> bool {
        match self.interface {
            Interface::Serial => self.addressed,
            Interface::Bus => self.bus.listens(),
        }
    }

    /// Whether a start is held, or will be.
    pub fn is_holding(&self) -> bool {
        self.hold || self.held.is_some()
    }

    /// Whether W has been given.
    pub fn requests_by_string(&self) -> bool {
        self.string.is_some()
    }

    /// Whether the line so far, or a command, is yet to be acted on.
    pub fn is_typing(&self) -> bool {
        !self.line.is_empty() || !self.waiting.is_empty() || self.edit.is_some()
    }

    /// Commands that wait.
    pub fn unread(&self) -> usize {
        self.waiting.len()
    }

    /// The RTS line: this unit's, and those behind it unless it is the last device (4-4 B, D331).
    pub fn rts(&self, last: bool) -> bool {
        let by_line = self.interface == Interface::Serial && self.string.is_none();
        let own = self.requesting && by_line;
        match (last, self.parallel) {
            (true, _) => own,
            (false, true) => own || self.behind,
            (false, false) => own && self.behind,
        }
    }

    /// The RTS line of the next unit in the chain.
    pub fn set_behind(&mut self, rts: bool) {
        self.behind = rts;
    }
}

impl Unidex3 {
    /// One sample of the interfaces.
    pub(super) fn remote_sample(&mut self, now: Nanos) {
        self.bus_sample(now);
        self.line_sample(now);
        self.waiting_commands(now);
        if std::mem::take(&mut self.remote.announce)
            && self.remote.interface == Interface::Serial
            && let Some(string) = &self.remote.string
        {
            self.line.send(string);
        }
    }

    fn line_sample(&mut self, now: Nanos) {
        for _ in 0..BYTES_A_SAMPLE {
            // DEL resets whatever the firmware is at.
            if self.busy.is_some() && !self.line.waiting().any(|byte| byte == DELETE) {
                break;
            }
            let Some(byte) = self.line.take() else {
                break;
            };
            if !self.listens() {
                continue;
            }
            if byte != DELETE {
                self.remote_byte(now, byte);
            } else if self.knows("<DEL>") {
                self.reset(now, true);
            }
        }
    }

    /// In local the unit hears nothing but XON and XOFF (3-4 J, note), nor while it has the bus.
    pub(super) fn listens(&self) -> bool {
        self.link != Link::Local && !self.is_remote_by(Interface::Bus)
    }

    fn remote_byte(&mut self, now: Nanos, byte: u8) {
        if self.busy.is_some() || byte == DELETE {
            return;
        }
        let addressed = self.has_controller();
        let in_line = !self.remote.line.is_empty();
        if addressed
            && !in_line
            && byte != ESCAPE
            && self.remote.edit.is_some()
            && self.remote.waiting.is_empty()
            && !self.is_command(byte)
        {
            return self.edit_byte(byte);
        }
        match byte {
            b'\r' | b'\n' => self.line_end(now, byte),
            ESCAPE => {
                self.remote.line = vec![ESCAPE];
                self.remote.ended_by = None;
            }
            // The unit does not know the HP-85's @.
            0..b' ' | b'@' => {}
            byte => {
                self.remote.ended_by = None;
                if self.remote.line.len() < LONGEST_LINE {
                    self.remote.line.push(byte);
                }
                if addressed && self.remote.line.iter().filter(|&&b| b != b' ').eq(b"EN") {
                    self.say(super::firmware::text::MODIFY_EOF);
                }
            }
        }
    }

    /// CR LF, LF CR, or one of them alone. An LF that ends nothing is no command.
    fn line_end(&mut self, now: Nanos, byte: u8) {
        let remote = &mut self.remote;
        if remote.ended_by.take().is_some_and(|first| first != byte) {
            return;
        }
        let line = std::mem::take(&mut remote.line);
        let ends_edit = std::mem::take(&mut remote.ends_edit) && line.is_empty();
        if ends_edit || !line.is_empty() || byte == b'\r' {
            remote.ended_by = Some(byte);
        }
        if ends_edit || (line.is_empty() && byte == b'\n') {
            return;
        }
        if let Some((&ESCAPE, rest)) = line.split_first() {
            // On the bus addressing is the bus's own.
            return match self.remote.interface {
                Interface::Bus if self.link == Link::Remote => {}
                _ => self.address(now, rest),
            };
        }
        if self.has_controller() {
            self.queue(now, line);
        }
    }

    /// `ESC 8, 17, 2`, or `ESC c` for all units.
    fn address(&mut self, now: Nanos, text: &[u8]) {
        let mut parts = text.split(|byte| matches!(byte, b' ' | b',' | b';'));
        let parts: Vec<&[u8]> = parts.by_ref().filter(|part| !part.is_empty()).collect();
        if let [[command @ (b'C' | b'H' | b'O' | b'L' | b'Z' | b'J' | b'K')]] = parts.as_slice() {
            if self.knows("<ESC>") {
                self.command(now, &[*command]);
            }
            return;
        }
        let number = |part: &&[u8]| {
            let number = std::str::from_utf8(part).ok()?.parse::<u8>().ok()?;
            (number <= LAST_ADDRESS).then_some(number)
        };
        let asked: Vec<u8> = parts.iter().filter_map(number).collect();
        let mut addresses = (0..=LAST_ADDRESS).filter(|address| asked.contains(address));
        let count = addresses.clone().count();
        let own = addresses.position(|address| address == self.options.address);
        let remote = &mut self.remote;
        remote.asked = [0; replies::TURNS];
        remote.addressed = false;
        if let Some(own) = own
            && self.knows("<ESC>")
        {
            let small = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
            self.remote.addressed = true;
            self.remote.turn = (small(own), small(count));
            self.enter_remote(now, Interface::Serial);
        }
    }

    /// Whether the unit is in remote, and commands are for it.
    fn has_controller(&self) -> bool {
        self.link == Link::Remote
            && (self.remote.addressed || self.remote.interface == Interface::Bus)
    }

    /// Whether the controller has the unit by this interface.
    pub(super) fn is_remote_by(&self, interface: Interface) -> bool {
        self.link == Link::Remote && self.remote.interface == interface
    }

    /// The controller has the unit.
    fn enter_remote(&mut self, now: Nanos, interface: Interface) {
        if self.link == Link::Enabled {
            self.leave_manual(now);
            self.remote.interface = interface;
            // What the other interface has begun is void.
            self.remote.line.clear();
            self.link = Link::Remote;
            self.panel.mode = super::panel::Mode::None;
            self.say(super::firmware::text::REMOTE);
        }
    }

    /// Carries out a command, or lets it wait: for a poll, or for the end of what runs.
    fn queue(&mut self, now: Nanos, line: Vec<u8>) {
        let waits = !self.remote.waiting.is_empty() || self.must_wait(&line);
        if waits && !acts_at_once(&line) {
            if self.remote.waiting.len() < MOST_WAITING {
                self.remote.waiting.push_back(line);
            }
            return;
        }
        self.command(now, &line);
    }

    fn must_wait(&self, line: &[u8]) -> bool {
        let first = line.iter().find(|&&byte| byte != b' ');
        let starts = matches!(first, Some(b'A' | b'S' | b'I' | b'E' | b'V' | b'R'));
        let prints = first == Some(&b'P') && self.line.unsent() > MOST_UNSENT;
        self.remote.requesting || (self.executing && starts) || prints
    }

    fn waiting_commands(&mut self, now: Nanos) {
        while self.busy.is_none()
            && let Some(line) = self.remote.waiting.front()
            && !self.must_wait(line)
        {
            let Some(line) = self.remote.waiting.pop_front() else {
                return;
            };
            let commands = line.first().is_some_and(|&byte| self.is_command(byte));
            match self.remote.edit.is_some() && !commands {
                true => self.edit_line(&line),
                false => self.command(now, &line),
            }
        }
    }

    /// Whether the unit has a word.
    fn knows(&self, word: &str) -> bool {
        self.options.without != Some(word)
    }
}

/// What is answered or done whatever waits.
fn acts_at_once(line: &[u8]) -> bool {
    let line: Vec<u8> = line.iter().copied().filter(|&byte| byte != b' ').collect();
    matches!(line.as_slice(), [b'Q' | b'C' | b'L' | b'O' | b'T'])
}
