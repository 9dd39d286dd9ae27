//! What a program orders of planner, drive and I/O: the seam between language and motion.

use std::fmt;
use std::rc::Rc;

use super::positions::{Compared, Window};
use super::{Edges, Machine};
use crate::mc600::planner::gear::GearType;

/// What a program orders of planner and drive; written as in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionCommand {
    /// `mspeed(vel)`, in counts*256/sample.
    Speed(i32),
    /// `mmove(pos)`, in counts.
    Move(i32),
    /// `mimove(ipos)`, in counts.
    MoveBy(i32),
    /// `mmerge(pos)`, in counts.
    Merge(i32),
    /// `mimerge(ipos)`, in counts.
    MergeBy(i32),
    /// `mgear(type)`.
    Gear(i32, GearType),
    /// `mcam(table)`, with the table that was laid ready.
    Cam,
    /// `mcamhard(table)`, likewise.
    CamHard,
    /// `mcamend()`.
    CamEnd,
    /// `mvirtualax(pos)`, in counts of the master.
    VirtualAxis(i32),
    /// `mvspeed(vel)`, in counts*256/sample of the master.
    VirtualSpeed(i32),
    /// `mphase(pos)`, in counts.
    Phase(i32),
    /// `midle()`.
    Idle,
    /// `mhome(1)`, `mhome(2)`.
    Home {
        /// Starts it; else aborts it.
        start: bool,
    },
    /// `mdrven()`.
    EnableDrive,
    /// `mdrvdis()`.
    DisableDrive,
    /// `mclrfault()`.
    ClearFault,
    /// `mquotecmp(source,dest,on,off)`.
    Comparator {
        /// What is compared.
        source: Compared,
        /// 0 to 7.
        number: u8,
        /// First position at which it is on, in counts.
        on: i32,
        /// Last position at which it is on, in counts.
        off: i32,
    },
    /// `msetoutcmp(on,off)`, in counts of the axis.
    OutputComparator {
        /// First position at which output 7 is on.
        on: i32,
        /// Last position at which it is on.
        off: i32,
    },
    /// `msetincap(in,edge,time)`.
    Capture {
        /// 0 is input 2, 1 is input 3.
        input: u8,
        /// 0 off, 1 rising, 2 falling, 3 both.
        edge: u8,
        /// Delay of the sensor in 0.8 us.
        delay: i32,
    },
    /// `msetsb(mode)`: master of the ServoBus, or slave.
    BusMaster(bool),
    /// `mcantx(id,data)`.
    Transmit {
        /// 1 to 2047.
        identifier: u16,
        /// Sent.
        data: i32,
    },
    /// `mcanrx(box,id)`.
    Mailbox {
        /// 0 to 7.
        number: u8,
        /// 1 to 2047.
        identifier: u16,
    },
}

impl fmt::Display for MotionCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MotionCommand::Speed(velocity) => write!(f, "mspeed({velocity})"),
            MotionCommand::Move(position) => write!(f, "mmove({position})"),
            MotionCommand::MoveBy(distance) => write!(f, "mimove({distance})"),
            MotionCommand::Merge(position) => write!(f, "mmerge({position})"),
            MotionCommand::MergeBy(distance) => write!(f, "mimerge({distance})"),
            MotionCommand::Gear(kind, _) => write!(f, "mgear({kind})"),
            MotionCommand::Cam => f.write_str("mcam(table%)"),
            MotionCommand::CamHard => f.write_str("mcamhard(table%)"),
            MotionCommand::CamEnd => f.write_str("mcamend()"),
            MotionCommand::VirtualAxis(position) => write!(f, "mvirtualax({position})"),
            MotionCommand::VirtualSpeed(velocity) => write!(f, "mvspeed({velocity})"),
            MotionCommand::Phase(position) => write!(f, "mphase({position})"),
            MotionCommand::Idle => f.write_str("midle()"),
            MotionCommand::Home { start } => write!(f, "mhome({})", if start { 1 } else { 2 }),
            MotionCommand::EnableDrive => f.write_str("mdrven()"),
            MotionCommand::DisableDrive => f.write_str("mdrvdis()"),
            MotionCommand::ClearFault => f.write_str("mclrfault()"),
            MotionCommand::Comparator {
                source,
                number,
                on,
                off,
            } => write!(f, "mquotecmp({},{number},{on},{off})", source as u8),
            MotionCommand::OutputComparator { on, off } => write!(f, "msetoutcmp({on},{off})"),
            MotionCommand::Capture { input, edge, delay } => {
                write!(f, "msetincap({input},{edge},{delay})")
            }
            MotionCommand::BusMaster(master) => write!(f, "msetsb({})", u8::from(master)),
            MotionCommand::Transmit { identifier, data } => {
                write!(f, "mcantx({identifier},{data})")
            }
            MotionCommand::Mailbox { number, identifier } => {
                write!(f, "mcanrx({number},{identifier})")
            }
        }
    }
}

impl Machine {
    /// Carries out a command of the program.
    ///
    /// A motion command has an effect once the drive is enabled or on its way there, in the very next statement after
    /// `mdrven`: the motion then starts with the enabled drive. Otherwise, and while an emergency stop is held, the
    /// reference is not enabled and the planner stays idle (D63). The master needs no drive.
    pub fn command(&mut self, command: MotionCommand) {
        match command {
            MotionCommand::VirtualAxis(position) => self.planner.master.axis.move_to(position),
            MotionCommand::VirtualSpeed(velocity) => self.planner.master.turn(velocity),
            MotionCommand::CamEnd => self.planner.cam.end(),
            MotionCommand::Home { start: false } => self.planner.abort_homing(),
            MotionCommand::Idle => self.planner.idle(),
            MotionCommand::EnableDrive => self.drive.enable(&self.conditions()),
            MotionCommand::DisableDrive => self.drive.disable(),
            MotionCommand::ClearFault => self.drive.clear_faults(&self.conditions()),
            MotionCommand::Comparator {
                source,
                number,
                on,
                off,
            } => {
                self.comparators.are_set = true;
                let place = self.comparators.windows.get_mut(usize::from(number));
                if let Some(comparator) = place {
                    *comparator = Some((source, Window { on, off }));
                }
                self.compare();
            }
            MotionCommand::OutputComparator { on, off } => {
                self.comparators.are_set = true;
                // The one position of on = off switches it off (D208).
                self.comparators.output = (on != off).then_some(Window { on, off });
                self.compare();
            }
            MotionCommand::Capture { input, edge, delay } => {
                if let Some(capture) = self.captures.get_mut(usize::from(input)) {
                    capture.set(edge, delay);
                }
            }
            MotionCommand::BusMaster(master) => self.bus.master = master,
            MotionCommand::Transmit { identifier, data } => self.bus.transmit(identifier, data),
            MotionCommand::Mailbox { number, identifier } => {
                self.bus.set_mailbox(number, identifier);
            }
            _ if self.drive.takes_reference(&self.conditions()) => self.motion_command(command),
            _ => {}
        }
    }

    /// What the axis itself does.
    fn motion_command(&mut self, command: MotionCommand) {
        let planner = &mut self.planner;
        match command {
            MotionCommand::Speed(velocity) => planner.speed(velocity),
            MotionCommand::Move(position) => planner.move_to(position, false),
            MotionCommand::MoveBy(distance) => planner.move_by(distance, false),
            MotionCommand::Merge(position) => planner.move_to(position, true),
            MotionCommand::MergeBy(distance) => planner.move_by(distance, true),
            MotionCommand::Gear(_, kind) => planner.follow_master(kind),
            MotionCommand::Cam => planner.follow_cam(Rc::clone(&self.table), false),
            MotionCommand::CamHard => planner.follow_cam(Rc::clone(&self.table), true),
            MotionCommand::Phase(position) => planner.phase.move_to(position),
            MotionCommand::Home { start: true } => {
                self.drive.edges = Edges::default();
                let (homing, around) = (self.homing(), self.surroundings());
                self.planner.start_homing(homing, &around);
            }
            _ => {}
        }
    }
}
