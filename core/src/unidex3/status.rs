//! The ten status bytes (Appendix 2; spec, "Status bytes").

use super::indexer::{Direction, DriveKind, HomeKind};
use super::remote::Interface;
use super::run::{RegisterMode, Wait};
use super::{Link, Unidex3};

/// Bits by their places.
fn byte(bits: &[(u8, bool)]) -> u8 {
    bits.iter()
        .fold(0, |byte, &(place, set)| byte | u8::from(set) << place)
}

impl Unidex3 {
    /// What Q sends: status byte 2.
    pub(super) fn poll_byte(&self) -> u8 {
        if let Some(result) = self.remote.test_result {
            return result;
        }
        let wait = self.run.wait.filter(|_| self.executing);
        byte(&[
            (7, self.errors.any()),
            (6, self.remote.is_requesting()),
            (5, self.link == Link::Local),
            (3, self.executing),
            (2, self.remote.is_holding()),
            (1, wait == Some(Wait::Halt)),
            (0, wait == Some(Wait::Stop)),
        ])
    }

    /// What PS sends.
    pub(super) fn status_bytes(&self) -> [u8; 10] {
        let [syntax, run, editor] = self.errors.bytes();
        [
            self.configuration_byte(),
            self.poll_byte(),
            self.mode_byte(),
            byte(&[
                (5, self.is_remote_by(Interface::Serial)),
                (4, self.remote.is_addressed()),
                (3, self.line.unsent() > 0 || self.remote.bus.talks()),
                (1, self.remote.requests_by_string()),
            ]),
            byte(&[
                (7, self.link == Link::Remote),
                (6, self.may_have(Interface::Bus)),
                (5, self.may_have(Interface::Serial)),
                (4, self.may_have(Interface::Bus)),
                (3, self.remote.is_requesting()),
                (2, self.remote.hexadecimal),
                (1, self.is_printing() || self.is_listing()),
                (0, self.was_reset),
            ]),
            syntax,
            run,
            editor,
            self.run.outputs,
            self.input_byte(),
        ]
    }

    /// Whether an interface has the unit or may take it.
    fn may_have(&self, interface: Interface) -> bool {
        self.link == Link::Enabled || self.is_remote_by(interface)
    }

    fn configuration_byte(&self) -> u8 {
        let config = self.indexer.config();
        let homes = match config.home {
            HomeKind::Hardware => None,
            HomeKind::Software(directions) => Some(directions),
        };
        let backward = Some(Direction::Negative);
        byte(&[
            (7, config.drive != DriveKind::Dc),
            (6, config.drive == DriveKind::StepperHigh),
            (5, homes.is_some()),
            (4, homes.map(|directions| directions.x) == backward),
            (3, homes.map(|directions| directions.y) == backward),
            (2, !self.options.limit_goes_local),
            (1, self.options.keyboard != 0),
        ])
    }

    fn mode_byte(&self) -> u8 {
        let modes = &self.run.modes;
        let register = match modes.register {
            RegisterMode::Normal => 0,
            RegisterMode::SkipIfTrue => 0x80,
            RegisterMode::SkipIfFalse => 0xA0,
            RegisterMode::Assign => 0xC0,
            RegisterMode::Move => 0xE0,
        };
        register | byte(&[(1, modes.corner_rounding), (0, !modes.absolute)])
    }

    fn input_byte(&self) -> u8 {
        let indexer = &self.indexer;
        byte(&[
            (7, indexer.input(4)),
            (6, indexer.input(3)),
            (5, indexer.input(2)),
            (4, indexer.input(1)),
            (3, indexer.joystick_clock()),
            (2, self.options.last),
            (1, self.remote.parallel),
        ])
    }
}
