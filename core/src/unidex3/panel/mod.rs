//! The front panel: what its keys do to what its displays and LEDs show (2-3, 3-4).
//!
//! `select` has the mode keys and what follows them up to EXC, `edit` the editor and the immediate mode, `manual` step
//! and slew, `entry` the keys while a program waits for a person.

mod edit;
mod entry;
mod manual;
mod select;

use super::display::Display;
use super::firmware::text;
use super::indexer::{Axis, Direction};
use super::keys::{self, Function, Key, Stroke};
use super::run::{Register, Target, Wait};
use super::{Busy, Link, Unidex3};
use crate::controller::{self, Led, Refused};
use crate::time::Nanos;
pub use manual::Manual;

/// What the keys mean at present.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Mode {
    /// No mode key is lit.
    #[default]
    None,
    /// EDT.
    Edit(Edit),
    /// AUT; digits select a program until it has run.
    Auto {
        /// Digits select.
        select: bool,
    },
    /// SGL.
    Single {
        /// Digits select.
        select: bool,
    },
    /// IMD.
    Immediate,
    /// PRT.
    Print(Print),
}

/// What EDT and the keys after it have asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Edit {
    /// `EDIT nn`.
    Select,
    /// `>>G7X100`.
    Program,
    /// SCH: a text to look for.
    Search(Vec<u8>),
    /// `CLR nn`.
    Clear(Option<u8>),
    /// `BOOT nn`.
    Boot(u8),
    /// `SETUP nn`.
    SetUp(u8),
    /// `NOBOOT`.
    NoBoot,
    /// `FREE MEM`.
    Free,
    /// `TST URAM`.
    Test,
    /// `MOD. EOF`.
    ModifyEnd,
    /// `ENTER >>`, and the digits.
    EnterEnd(Vec<u8>),
}

/// What PRT and the keys after it have asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Print {
    Program,
    Directory,
    Message,
    Register(Register),
}

/// A program under the editor's cursor.
#[derive(Debug, Clone, Default)]
pub struct Edited {
    /// Its number.
    pub number: u8,
    /// Its characters.
    pub text: Vec<u8>,
    /// What is typed goes here.
    pub cursor: usize,
}

/// The panel's state.
#[derive(Debug, Clone, Default)]
pub struct Panel {
    /// What the display shows.
    pub display: Display,
    /// What EDITING! hides.
    hidden: Option<Display>,
    shift: bool,
    /// What the keys mean.
    pub mode: Mode,
    /// Message entry: keys type the characters of messages, and the EDIT LED flashes.
    pub message: bool,
    /// The selected program; `None` until one is, which means program 1.
    pub number: Option<u8>,
    /// The program in the editor.
    pub edited: Edited,
    /// The immediate mode's block.
    pub block: Vec<u8>,
    /// The block has run: the next character begins another.
    block_ran: bool,
    /// What has been typed for a G62.
    pub typed: Vec<u8>,
    /// Step or slew.
    pub manual: Option<Manual>,
    /// Arrow keys that are down.
    held: Vec<(Axis, Direction)>,
}

impl Unidex3 {
    /// A key goes down or up.
    pub(super) fn key(&mut self, at: Nanos, name: &str, down: bool) -> Result<(), Refused> {
        let Some((key, shifted)) = keys::named(name) else {
            return Err(Refused(format!("unidex3 has no key '{name}'")));
        };
        let word = keys::word(key, shifted || (self.panel.shift && !self.panel.message));
        let reached = self.powered && self.has_keyboard();
        if !reached || (word.is_some() && word == self.options.without) {
            return Ok(());
        }
        match (key, down) {
            (Key::Right | Key::Left | Key::Up | Key::Down, false) => self.arrow_up(at, key),
            (_, false) => {}
            (Key::ClearX, _) => self.indexer.clear_tracking(at, Axis::X),
            (Key::ClearY, _) => self.indexer.clear_tracking(at, Axis::Y),
            (Key::Reset, _) => self.reset_key(at),
            (key, _) => self.press(at, key, shifted),
        }
        Ok(())
    }

    fn press(&mut self, at: Nanos, key: Key, shifted: bool) {
        if self.busy.is_some() {
            return;
        }
        let waits_for_person = matches!(self.run.wait, Some(Wait::Input(_) | Wait::Slew));
        match self.link {
            // The controller has the unit, but a program that asks for a person is answered (4-10 E).
            Link::Remote if !waits_for_person || self.remote.is_requesting() => {
                if key == Key::Remote && !self.executing && !self.is_locked_out() {
                    self.remote_key(at);
                }
                return;
            }
            Link::Remote => {}
            Link::Enabled | Link::Local if key != Key::Remote || self.panel.message => {
                self.link = Link::Local;
            }
            Link::Enabled | Link::Local => {}
        }
        if key == Key::Shift {
            self.panel.shift = !self.panel.shift;
            return;
        }
        if matches!(key, Key::Right | Key::Left | Key::Up | Key::Down) {
            return self.arrow_down(at, key);
        }
        let shifted = std::mem::take(&mut self.panel.shift) || shifted;
        // A pad key that PRT expects means its legend without SHIFT (3-4 F to J).
        let shifted = shifted || self.print_takes(key);
        let Some(stroke) = keys::stroke(key, shifted, self.panel.message) else {
            return;
        };
        if let Some(hidden) = self.panel.hidden.take() {
            match stroke {
                Stroke::Function(Function::Execute) => self.panel.display = hidden,
                _ => self.panel.hidden = Some(hidden),
            }
            return;
        }
        if self.executing {
            self.key_while_running(at, stroke);
        } else if self.panel.manual.is_some() {
            self.key_in_manual(at, stroke);
        } else {
            self.key_in_mode(at, stroke);
        }
    }

    /// RES: not while a program is edited (2-6 C).
    fn reset_key(&mut self, at: Nanos) {
        let editing = matches!(self.panel.mode, Mode::Edit(Edit::Program | Edit::Search(_)));
        if editing && self.busy.is_none() {
            let shown = self.panel.display;
            self.panel.hidden.get_or_insert(shown);
            self.say(text::EDITING);
            return;
        }
        self.reset(at, true);
    }

    /// RMT: back to "local with remote enabled" (2-3 A).
    pub(super) fn remote_key(&mut self, at: Nanos) {
        self.end_edit();
        self.leave_manual(at);
        if !self.leave_edit() {
            return;
        }
        self.link = Link::Enabled;
        self.panel.mode = Mode::None;
        self.panel.message = false;
        if !self.executing {
            self.say(text::READY_SYSTEM);
        }
    }

    /// A message on the display.
    pub(super) fn say(&mut self, text: &str) {
        self.panel.display.message(text.as_bytes());
    }

    /// What a person sees.
    pub(super) fn shown(&self) -> controller::Panel {
        let dark = !self.powered;
        let lit = |on: bool| if on && !dark { Led::On } else { Led::Off };
        let flashing = |on: bool| if on && !dark { Led::Flashing } else { Led::Off };
        let panel = &self.panel;
        let edit = match panel.message {
            true => flashing(true),
            false => lit(matches!(panel.mode, Mode::Edit(_))),
        };
        let indexer = &self.indexer;
        let mut leds = vec![
            ("EDIT", edit),
            ("AUTO", lit(matches!(panel.mode, Mode::Auto { .. }))),
            ("SINGLE", lit(matches!(panel.mode, Mode::Single { .. }))),
            ("IMMEDIATE", lit(panel.mode == Mode::Immediate)),
            ("REMOTE", lit(self.link != Link::Local)),
            ("LOCAL", lit(self.link != Link::Remote)),
            ("SHIFT", lit(panel.shift)),
        ];
        for (axis, names) in [
            (Axis::X, ["XCZ", "XM", "XLMT"]),
            (Axis::Y, ["YCZ", "YM", "YLMT"]),
        ] {
            let [in_position, marker, limit] = names;
            leds.push((in_position, lit(indexer.in_position(axis))));
            leds.push((marker, lit(indexer.marker(axis))));
            leds.push((limit, lit(indexer.limit(axis).is_some())));
        }
        let tracking = |axis| match dark {
            true => String::new(),
            false => indexer.tracking(axis).to_string(),
        };
        controller::Panel {
            display: if dark {
                Display::default()
            } else {
                panel.display
            }
            .text(),
            leds: leds
                .into_iter()
                .map(|(name, led)| (name.to_owned(), led))
                .collect(),
            tracking: vec![
                ("x".to_owned(), tracking(Axis::X)),
                ("y".to_owned(), tracking(Axis::Y)),
            ],
        }
    }

    /// The prompt of a G62, unless the program has its own (6-14).
    pub(super) fn ask(&mut self, target: Target) {
        self.panel.typed.clear();
        self.panel.message = target == Target::Message;
        if self.run.own_prompt {
            return;
        }
        match target {
            Target::Message => self.say(text::ENTER_MESSAGE),
            Target::Register(register) => self.say(&format!("ENTER {}", register.word())),
            Target::Outputs => self.say("ENTER M"),
            Target::Flags => self.say("ENTER F"),
        }
    }

    /// Whether keys may act; a person would see nothing happen.
    pub(super) fn is_printing(&self) -> bool {
        matches!(self.busy, Some(Busy::Printing))
    }
}
