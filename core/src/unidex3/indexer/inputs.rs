//! The C inputs with what is armed on them, the feedhold inputs, the external clock and the joystick (2-4, 2-5, 6-6).

use super::command::{Direction, Edge, Interrupt};
use super::feedrate::FRACTION_BITS;
use super::pair::{Axis, Pair};

/// After an edge a debounced input keeps its level for so long, in us (D297).
const DEBOUNCE_US: u64 = 5000;

/// The four C inputs. They are pulled up: high where nothing is wired (D297).
#[derive(Debug, Clone, Copy)]
pub(super) struct Inputs {
    inputs: [Input; 4],
}

#[derive(Debug, Clone, Copy)]
struct Input {
    /// At the connector, and as the unit sees it.
    outside: bool,
    level: bool,
    debounced: bool,
    /// The level stays until then.
    steady_until: u64,
    armed: Option<(Interrupt, Edge)>,
    holding: bool,
}

/// An armed input has seen its edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Fired {
    /// 1 to 4.
    pub input: u8,
    /// Abort or reset: holds are kept here.
    pub interrupt: Interrupt,
}

impl Inputs {
    pub fn new(debounced: [bool; 4]) -> Inputs {
        Inputs {
            inputs: debounced.map(|debounced| Input {
                outside: true,
                level: true,
                debounced,
                steady_until: 0,
                armed: None,
                holding: false,
            }),
        }
    }

    /// The jumpers JP20 to JP23.
    pub fn debounce(&mut self, debounced: [bool; 4]) {
        for (input, debounced) in self.inputs.iter_mut().zip(debounced) {
            input.debounced = debounced;
        }
    }

    /// Arms input 1 to 4, or disarms it; a hold by it ends.
    pub fn arm(&mut self, number: u8, armed: Option<(Interrupt, Edge)>) {
        if let Some(input) = self.get_mut(number) {
            (input.armed, input.holding) = (armed, false);
        }
    }

    /// Wires input 1 to 4; [`Inputs::settle`] tells what follows.
    pub fn wire(&mut self, number: u8, high: bool) {
        if let Some(input) = self.get_mut(number) {
            input.outside = high;
        }
    }

    /// Whether input 1 to 4 is high.
    pub fn level(&self, number: u8) -> bool {
        self.index(number)
            .and_then(|index| self.inputs.get(index))
            .is_some_and(|input| input.level)
    }

    /// Bit n is input n + 1.
    pub fn levels(&self) -> u8 {
        (1..=4u8).fold(0, |bits, number| {
            bits | u8::from(self.level(number)) << (number - 1)
        })
    }

    /// Some input holds.
    pub fn is_holding(&self) -> bool {
        self.inputs.iter().any(|input| input.holding)
    }

    /// When a level next follows what is wired; [`u64::MAX`] when nothing is to follow.
    #[inline]
    pub fn due(&self) -> u64 {
        let waits = |input: &&Input| input.level != input.outside;
        let due = self.inputs.iter().filter(waits);
        due.map(|input| input.steady_until)
            .min()
            .unwrap_or(u64::MAX)
    }

    /// Takes over the levels that are due at `now`, and does what is armed: the first interrupt, if any; call it again
    /// until there is none.
    pub fn settle(&mut self, now: u64) -> Option<Fired> {
        for (number, input) in (1u8..).zip(&mut self.inputs) {
            if input.level == input.outside || input.steady_until > now {
                continue;
            }
            if let Some(interrupt) = input.change(now) {
                return Some(Fired {
                    input: number,
                    interrupt,
                });
            }
        }
        None
    }

    fn get_mut(&mut self, number: u8) -> Option<&mut Input> {
        let index = self.index(number)?;
        self.inputs.get_mut(index)
    }

    fn index(&self, number: u8) -> Option<usize> {
        number.checked_sub(1).map(usize::from)
    }
}

impl Input {
    /// The level follows what is wired.
    fn change(&mut self, now: u64) -> Option<Interrupt> {
        self.level = self.outside;
        if self.debounced {
            self.steady_until = now + DEBOUNCE_US;
        }
        let (interrupt, edge) = self.armed?;
        let fires = self.level == (edge == Edge::Rising);
        if interrupt == Interrupt::Feedhold {
            self.holding = fires;
            return None;
        }
        fires.then_some(interrupt)
    }
}

/// The external clock, and the count of `D=` (5-3, D303).
#[derive(Debug, Clone, Copy)]
pub(super) struct Counter {
    left: u64,
    high: bool,
    /// Falling edges a second of a steady clock, and the part of the next one that has passed, in 1e-6.
    per_second: u64,
    phase: u64,
}

/// Edges come at least 2 us apart.
pub(super) const FASTEST_CLOCK: f64 = 500_000.0;

impl Counter {
    pub const NEW: Counter = Counter {
        left: 0,
        high: true,
        per_second: 0,
        phase: 0,
    };

    pub fn begin(&mut self, edges: u64) {
        (self.left, self.phase) = (edges, 0);
    }

    pub fn left(&self) -> u64 {
        self.left
    }

    /// A level at the input.
    pub fn wire(&mut self, high: bool) {
        if self.high && !high {
            self.left = self.left.saturating_sub(1);
        }
        self.high = high;
    }

    /// A steady clock at the input.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // checked to be 0 to 500,000
    pub fn run_at(&mut self, per_second: f64) {
        self.per_second = per_second as u64;
    }

    /// `elapsed` us pass.
    #[inline]
    pub fn pass(&mut self, elapsed: u64) {
        if self.left == 0 || self.per_second == 0 {
            return;
        }
        self.phase = self
            .phase
            .saturating_add(self.per_second.saturating_mul(elapsed));
        self.left = self.left.saturating_sub(self.phase / 1_000_000);
        self.phase %= 1_000_000;
    }
}

/// The joystick: two clocks with a direction each (2-5, D302).
#[derive(Debug, Clone, Copy)]
pub(super) struct Joystick {
    /// Pulses a second, as 2^-35.
    clocks: Pair<u64>,
    directions: Pair<Direction>,
    pub button: bool,
    /// Of slew mode; `None` while it is not in use.
    divisor: Option<u64>,
    /// A limit was hit: it is dead until a direction changes (4-10 D).
    blocked: bool,
}

/// The fastest clock of a joystick: half of it is the highest feedrate.
pub(super) const FASTEST_JOYSTICK: f64 = 300_000.0;

impl Joystick {
    pub const NEW: Joystick = Joystick {
        clocks: Pair { x: 0, y: 0 },
        directions: Pair {
            x: Direction::Positive,
            y: Direction::Positive,
        },
        button: false,
        divisor: None,
        blocked: false,
    };

    /// A clock of so many pulses a second, negative the other way.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most 300,000 x 2^35, and not negative
    pub fn wire(&mut self, axis: Axis, pulses_per_second: f64) {
        let fast = pulses_per_second.abs().min(FASTEST_JOYSTICK);
        *self.clocks.of_mut(axis) = (fast * (1u64 << FRACTION_BITS) as f64) as u64;
        let direction = if pulses_per_second < 0.0 {
            Direction::Negative
        } else if pulses_per_second > 0.0 {
            Direction::Positive
        } else {
            return;
        };
        if *self.directions.of(axis) != direction {
            *self.directions.of_mut(axis) = direction;
            self.blocked = false;
        }
    }

    /// Begins or ends its use.
    pub fn engage(&mut self, divisor: Option<u32>) {
        self.divisor = divisor.map(|divisor| u64::from(divisor.clamp(2, 65_535)));
        self.blocked = false;
    }

    /// A limit was hit.
    pub fn block(&mut self) {
        self.blocked = true;
    }

    /// Direction and rate in 2^-35 steps/s; `None` while it has no say.
    pub fn rate(&self, axis: Axis) -> Option<(Direction, u64)> {
        let divisor = self.divisor.filter(|_| !self.blocked)?;
        Some((*self.directions.of(axis), self.clocks.of(axis) / divisor))
    }

    /// One of its clocks gives pulses.
    pub fn has_clock(&self) -> bool {
        self.clocks.x != 0 || self.clocks.y != 0
    }
}
