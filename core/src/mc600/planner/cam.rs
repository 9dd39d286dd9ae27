//! Camming: the axis follows a table of positions over the master's modulus.
//!
//! Source: "mcam(table)". The table's points stand at equal distances of the master; between two of them the way is a
//! straight line, and the last interval leads to point 0. With a modulus of the axis that last interval takes the
//! shorter way round, so that a table may turn the axis on and on (D194).

use std::rc::Rc;

use super::moves::Offset;
use super::units::{FRACTION, Modulus};
use crate::controller::CamTable;
use crate::motion::ramp::{next_velocity_to_speed, next_velocity_to_target};

/// Points of a table at power-up: what `mspline` makes (D195).
const POWER_UP_POINTS: i32 = 360;

/// The points of a cam in counts of the axis.
pub type Table = Rc<[i32]>;

/// How the axis is connected to the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Not at all.
    Released,
    /// Comes to the speed that the table asks for, by `sm_acc%`.
    Matching,
    /// At that speed, comes to the position by the limits of `mphase`.
    Phasing,
    /// Directly.
    Locked,
}

/// The cam and its variables.
#[derive(Debug, Clone, PartialEq)]
pub struct Cam {
    /// `cm_num%`.
    pub points: i32,
    table: Table,
    state: State,
    /// `cm_flag%` bit 0: released at the end of this modulus.
    ending: bool,
    /// Position demanded by the table, in 1/256 count.
    output: i64,
    index: i32,
    /// The master was last here, in 1/256 count.
    master: i64,
}

/// What the cam asks of the axis in a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// In 1/256 count per sample.
    pub velocity: i64,
    /// The master has passed the end of its modulus.
    pub passed_zero: bool,
    /// The cam is over with this sample.
    pub ends: bool,
}

impl Cam {
    pub(super) fn new() -> Cam {
        Cam {
            points: POWER_UP_POINTS,
            table: Table::default(),
            state: State::Released,
            ending: false,
            output: 0,
            index: 0,
            master: 0,
        }
    }

    /// `mcam` and `mcamhard`, with the master where it is now. An axis that is on a cam already only changes tables.
    pub(super) fn engage(
        &mut self,
        table: Table,
        hard: bool,
        master: &CamMaster,
        modulus: Modulus,
    ) {
        self.table = table;
        self.ending = false;
        (self.output, self.index) = self.demand(master.position, master.modulus, modulus);
        self.master = master.position;
        if hard {
            self.state = State::Locked;
        } else if self.state == State::Released {
            self.state = State::Matching;
        }
    }

    /// The master's positions have changed their numbers.
    pub(super) fn rebase(&mut self, master: &CamMaster) {
        self.master = master.position;
    }

    /// `mcamend`.
    pub fn end(&mut self) {
        self.ending = self.state != State::Released;
    }

    /// Another generator takes over.
    pub(super) fn release(&mut self) {
        (self.state, self.ending) = (State::Released, false);
    }

    /// The velocity of the next sample for an axis at `position` (1/256 count).
    pub(super) fn next(
        &mut self,
        velocity: i64,
        position: i64,
        master: &CamMaster,
        modulus: Modulus,
        speed_acceleration: i32,
        phase: &Offset,
    ) -> Step {
        let turn = i64::from(master.modulus) << FRACTION;
        let to = master.position;
        let passed_zero = turn > 0 && to.div_euclid(turn) != self.master.div_euclid(turn);
        let ends = passed_zero && self.ending;
        // A cam that ends does so exactly at the end of the modulus, which is point 0 (D215).
        let to = if ends { 0 } else { to };
        let (output, index) = self.demand(to, master.modulus, modulus);
        let pace = modulus.nearest(output.wrapping_sub(self.output));
        let behind = modulus.nearest(self.output.wrapping_sub(position));
        (self.output, self.index, self.master) = (output, index, master.position);
        let velocity = match self.state {
            State::Released => velocity,
            State::Matching => {
                let acceleration = i64::from(speed_acceleration);
                let next = next_velocity_to_speed(velocity, pace, acceleration, acceleration);
                if next == pace {
                    self.state = State::Phasing;
                }
                next
            }
            State::Phasing => {
                let gained = next_velocity_to_target(velocity - pace, behind, &phase.limits());
                if gained == 0 && behind == 0 {
                    self.state = State::Locked;
                }
                pace + gained
            }
            State::Locked => modulus.nearest(output.wrapping_sub(position)),
        };
        Step {
            velocity,
            passed_zero,
            ends,
        }
    }

    /// The table's position for a master at `master` (1/256 count), and the point it was reckoned from. Without a
    /// modulus of the master, or without points, it is point 0 (D195).
    fn demand(&self, master: i64, master_modulus: i32, modulus: Modulus) -> (i64, i32) {
        let points = i64::try_from(self.table.len())
            .unwrap_or(i64::MAX)
            .min(i64::from(self.points));
        let at = |index: i64| {
            let index = usize::try_from(index).unwrap_or(0);
            i64::from(self.table.get(index).copied().unwrap_or(0)) << FRACTION
        };
        let turn = i64::from(master_modulus) << FRACTION;
        if points <= 0 || turn <= 0 {
            return (at(0), 0);
        }
        // Below 2^39 * 2^15.
        let scaled = master.rem_euclid(turn) * points;
        let (index, rest) = (scaled / turn, scaled % turn);
        let from = at(index);
        let way = if index + 1 < points {
            at(index + 1) - from
        } else if modulus.counts().is_some() {
            modulus.nearest(at(0) - from)
        } else {
            at(0) - from
        };
        let part = (i128::from(way) * i128::from(rest)).div_euclid(i128::from(turn));
        let position = from + i64::try_from(part).unwrap_or(0);
        (position, i32::try_from(index).unwrap_or(0))
    }

    /// `cm_camout%`, within the modulus of the axis.
    pub fn output(&self, modulus: Modulus) -> i32 {
        modulus.reading(self.output)
    }

    /// `cm_index%`.
    pub fn index(&self) -> i32 {
        self.index
    }

    /// `cm_flag%`.
    pub fn flags(&self) -> i32 {
        i32::from(self.ending)
    }

    /// The points in use and where the master stands among them; `None` until there was a table.
    pub fn picture(&self, master: &CamMaster, modulus: Modulus) -> Option<CamTable> {
        let used = usize::try_from(self.points).unwrap_or(0);
        let points: Vec<i32> = self.table.iter().take(used).copied().collect();
        if points.is_empty() {
            return None;
        }
        let turn = i64::from(master.modulus) << FRACTION;
        let part = match turn > 0 {
            true => master.position.rem_euclid(turn) as f64 / turn as f64,
            false => 0.0,
        };
        let (demand, _) = self.demand(master.position, master.modulus, modulus);
        Some(CamTable {
            at: part * points.len() as f64,
            demand: demand as f64 / f64::from(1 << FRACTION),
            points,
        })
    }

    /// `gv_mflag%` bit 3.
    pub fn is_locked(&self) -> bool {
        self.state == State::Locked
    }
}

/// The master as a cam sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CamMaster {
    /// In 1/256 count, unwrapped.
    pub position: i64,
    /// `gv_mmod%`.
    pub modulus: i32,
}
