//! Commands: modes, starts and stops.

use super::counter::Counting;
use super::follow::{Cam, Ratio};
use super::settings::Buffered;
use super::{Command, Drive, LATCHED, ModeWord, Motor, Port};

impl Motor {
    /// Carries out a command. What cannot be, because the motor is too hot or something is broken, is ignored.
    pub fn command(&mut self, command: Command) {
        match command {
            Command::Go => self.go(),
            Command::Decelerate => self.decelerate(),
            Command::StopNow => self.stop_now(),
            Command::Off => self.switch_off(),
            Command::Mode(mode) => self.choose(mode),
            Command::LoadFilter => self.filter.load(),
            Command::GravityOn => self.filter.gravity = true,
            Command::GravityOff => self.filter.gravity = false,
            Command::ServoDivisor(divisor) => self.divisor = divisor.clamp(1, 8),
            Command::Brake(brake) => self.settings.brake = brake,
            Command::BrakePin(port) => self.pins.brake_by(port),
            Command::LimitsDirectional => self.settings.directional = true,
            Command::LimitsNondirectional => self.settings.directional = false,
            Command::LimitsHigh => self.pins.limits_high = true,
            Command::LimitsLow => self.pins.limits_high = false,
            Command::Input(port) => {
                self.uncount(port);
                self.pins.make_input(port);
            }
            Command::Output(port) => {
                self.uncount(port);
                self.pins.make_output(port);
            }
            Command::RightLimit => self.pins.make_special(Port::C),
            Command::LeftLimit => self.pins.make_special(Port::D),
            Command::GoInput => {
                // A pin that is low already is no start.
                self.go = true;
                self.pins.make_special(Port::G);
            }
            Command::ClearAll => self.status &= !LATCHED,
            Command::Clear(flag) => self.status &= !(flag.mask() & LATCHED),
        }
    }

    /// UA and UB become the counter's.
    fn count_by(&mut self, counting: Counting) {
        self.pins.make_input(Port::A);
        self.pins.make_input(Port::B);
        self.counter.count_by(counting);
    }

    /// A pin that becomes plain no longer counts.
    fn uncount(&mut self, port: Port) {
        if matches!(port, Port::A | Port::B) {
            self.counter.count_by(Counting::Stopped);
        }
    }

    /// A mode word: what the next G starts. MT acts at once, and those that count do from now on.
    fn choose(&mut self, mode: ModeWord) {
        match mode {
            ModeWord::Count => {
                self.count_by(Counting::Quadrature(4));
                self.counter.zero();
                return;
            }
            ModeWord::CountSteps => {
                self.count_by(Counting::Steps);
                self.counter.zero();
                return;
            }
            ModeWord::Follow(counts) => self.count_by(Counting::Quadrature(counts)),
            ModeWord::FollowRatio => self.count_by(Counting::Quadrature(4)),
            ModeWord::Steps | ModeWord::StepsRatio => self.count_by(Counting::Steps),
            ModeWord::Cam(_) if self.counter.counting == Counting::Stopped => {
                self.count_by(Counting::Quadrature(4));
            }
            ModeWord::Contour => self.stream.clear(),
            ModeWord::Torque => {
                if self.switch_on() {
                    self.trajectory.hold();
                    self.drive = Drive::Torque;
                }
            }
            ModeWord::Cam(_) | ModeWord::Position | ModeWord::Velocity => {}
        }
        self.buffered.mode = mode;
    }

    /// `G`.
    pub(super) fn go(&mut self) {
        if !self.switch_on() {
            return;
        }
        let Buffered {
            acceleration,
            velocity,
            position,
            distance,
            relative,
            mode,
            multiplier,
            divisor,
            base,
            size,
        } = self.buffered;
        if mode != ModeWord::Contour {
            self.stream.end();
        }
        let here = self.trajectory.count();
        match mode {
            ModeWord::Position => {
                // Across the end of the 32 bits, if that is the shorter way.
                let way = if relative {
                    distance
                } else {
                    position.wrapping_sub(self.reading(here))
                };
                let target = here + i64::from(way);
                self.trajectory.move_to(target, velocity, acceleration);
            }
            ModeWord::Velocity => self.trajectory.run_at(velocity, acceleration),
            ModeWord::Torque => {
                self.trajectory.hold();
                self.drive = Drive::Torque;
            }
            ModeWord::Contour => {
                self.stream.begin(self.reading(here));
                self.trajectory.contour();
            }
            ModeWord::Follow(_) | ModeWord::Steps => self.trajectory.follow(Ratio::new(1, 1)),
            ModeWord::FollowRatio | ModeWord::StepsRatio => {
                self.trajectory.follow(Ratio::new(multiplier, divisor));
            }
            ModeWord::Cam(times) => self.trajectory.cam(Cam::new(base, size, times)),
            ModeWord::Count | ModeWord::CountSteps => {}
        }
        // What came before G is not followed.
        self.master = 0;
    }

    /// `X`. A motor in torque mode is caught by the servo and decelerated.
    pub(super) fn decelerate(&mut self) {
        let acceleration = self.buffered.acceleration;
        if self.drive == Drive::Torque && self.switch_on() {
            self.trajectory.run_at(0, acceleration);
        }
        self.stream.end();
        self.trajectory.decelerate(acceleration);
    }

    /// `S`. A motor that is off stays off.
    fn stop_now(&mut self) {
        self.stream.end();
        if self.drive != Drive::Off && self.switch_on() {
            self.trajectory.hold();
        }
    }
}
