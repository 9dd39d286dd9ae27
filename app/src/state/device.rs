//! The controller as the page last heard of it.

use motionbench_core::bench::BusView;
use motionbench_core::controller::{Panel, RunState, Status};
use motionbench_core::exec::Wait;
use motionbench_core::serial::{LineSettings, Parity};
use motionbench_core::time::Nanos;

use super::wiring::Drive;
use super::{Fault, News};
use crate::protocol::Speed;

/// The controller and its simulator.
#[derive(Debug, Clone, PartialEq)]
pub struct Device {
    /// Its name; empty until it is known.
    pub name: String,
    /// How the terminal's end of its console's line is set; as the console, until the user sets it.
    pub line: Option<LineSettings>,
    /// How its console is set.
    pub console: Option<LineSettings>,
    /// What it does; `None` until it is known.
    pub status: Option<Status>,
    /// Grows with all that may change what it holds.
    pub work: u64,
    /// Units behind its front panel, and the one that is selected there, from 0.
    pub units: usize,
    /// All that is known of a unit is of this one.
    pub unit: usize,
    /// What its front panel shows, where it has one.
    pub panel: Option<Panel>,
    /// How the IEEE-488 bus stands, where there is one.
    pub bus: Option<BusView>,
    /// Simulated time.
    pub now: Nanos,
    /// The simulation speed asked for.
    pub speed: Speed,
    /// Simulated seconds a second, lately.
    pub reached: f64,
    /// Characters that wait to be sent to it.
    pub pending: usize,
    /// Simulated time stands still.
    pub frozen: bool,
    /// Why there is no simulator any more.
    pub fault: Option<Fault>,
}

/// What the program does, in one word and a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Activity {
    Starting,
    Off,
    Idle,
    Command,
    Running,
    WaitingForInput,
    WaitingForOutput,
    Paused,
    Failed,
}

impl Default for Device {
    fn default() -> Device {
        Device {
            name: String::new(),
            line: None,
            console: None,
            status: None,
            work: 0,
            units: 1,
            unit: 0,
            panel: None,
            bus: None,
            now: Nanos::ZERO,
            speed: Speed::Times(1.0),
            reached: 0.0,
            pending: 0,
            frozen: false,
            fault: None,
        }
    }
}

impl Device {
    /// Takes in what was heard.
    pub fn hear(&mut self, news: &News) {
        match news {
            News::Ready(ready) => {
                self.name.clone_from(&ready.controller);
                self.console = Some(ready.line);
                (self.units, self.unit) = (ready.units, 0);
                // A worker that replaces another is set as the user had set it.
                self.line.get_or_insert(ready.line);
            }
            News::Frame(frame, _) => {
                self.status = Some(frame.status.clone());
                self.work = frame.work;
                self.unit = frame.unit;
                self.panel.clone_from(&frame.panel);
                self.bus = frame.bus;
                self.now = frame.now;
                self.reached = frame.reached;
                self.pending = frame.pending;
                self.frozen = frame.frozen;
            }
            News::Answer(_) => {}
            News::Fault(fault) => self.fault = Some(*fault),
        }
    }

    /// Whether the mains switch is on.
    pub fn is_on(&self) -> bool {
        self.status.as_ref().is_some_and(|status| status.power)
    }

    /// Whether there is a next statement to run.
    pub fn can_step(&self) -> bool {
        let run = self.status.as_ref().map(|status| status.run);
        self.runs_program() && run != Some(RunState::Command)
    }

    /// A program, or a command of the console that is held, is under way.
    fn runs_program(&self) -> bool {
        use Activity::{Paused, Running, WaitingForInput, WaitingForOutput};
        matches!(
            self.activity(),
            Running | WaitingForInput | WaitingForOutput | Paused
        )
    }

    /// What the program does.
    pub fn activity(&self) -> Activity {
        let Some(status) = self.status.as_ref().filter(|_| self.fault.is_none()) else {
            return self.fault.map_or(Activity::Starting, |_| Activity::Failed);
        };
        match status.run {
            _ if !status.power => Activity::Off,
            RunState::Idle => Activity::Idle,
            RunState::Command | RunState::Running | RunState::Waiting(_) if self.frozen => {
                Activity::Paused
            }
            RunState::Command => Activity::Command,
            RunState::Running | RunState::Waiting(Wait::Time | Wait::Motion) => Activity::Running,
            RunState::Waiting(Wait::Input) => Activity::WaitingForInput,
            RunState::Waiting(Wait::Output) => Activity::WaitingForOutput,
            RunState::Paused => Activity::Paused,
        }
    }

    /// How the controller's end of the line is set, if the terminal's is set otherwise: neither understands the other.
    pub fn other_line(&self) -> Option<LineSettings> {
        self.console
            .filter(|&console| self.line.is_some_and(|line| line != console))
    }

    /// The program line that runs, where one does.
    pub fn running_line(&self) -> Option<u32> {
        self.status.as_ref().filter(|_| self.runs_program())?.line
    }

    /// Why nothing goes on, where that is so; otherwise empty.
    pub fn why(&self) -> &'static str {
        let held = self.status.as_ref().map(|status| status.run) == Some(RunState::Paused);
        match self.activity() {
            Activity::Paused if held => "held before its next statement",
            _ if self.frozen => "simulated time stands still",
            Activity::WaitingForInput => "answer in the terminal",
            Activity::WaitingForOutput => "printed faster than the line carries",
            _ => "",
        }
    }

    /// The axis moves, whether a program runs or not.
    pub fn is_moving(&self) -> bool {
        self.status.as_ref().is_some_and(|status| status.moving)
    }

    /// The state of the drive, when the emergency stop is pressed or not, and its ENABLE is on or not.
    pub fn drive(&self, stopped: bool, enable: bool) -> Drive {
        match self.status.as_ref().filter(|status| status.power) {
            None => Drive::Off,
            Some(status) => match &status.fault {
                Some(words) => Drive::Fault(words.clone()),
                None if stopped => Drive::Stopped,
                None if status.enabled => Drive::Enabled,
                None if !enable => Drive::NotAllowed,
                None => Drive::Disabled,
            },
        }
    }

    /// The error that the last program ended with, in the device's words.
    pub fn error(&self) -> Option<&str> {
        self.status.as_ref()?.error.as_deref()
    }
}

impl Activity {
    /// For people.
    pub fn words(self) -> &'static str {
        match self {
            Activity::Starting => "starting",
            Activity::Off => "off",
            Activity::Idle => "idle",
            Activity::Command => "executing",
            Activity::Running => "running",
            Activity::WaitingForInput => "waiting for input",
            Activity::WaitingForOutput => "waiting for the line",
            Activity::Paused => "paused",
            Activity::Failed => "failed",
        }
    }

    /// Whether a program or command is under way.
    pub fn is_running(self) -> bool {
        use Activity::{Command, Running, WaitingForInput, WaitingForOutput};
        matches!(self, Command | Running | WaitingForInput | WaitingForOutput)
    }
}

/// `9600 8N1`.
pub fn line_words(line: &LineSettings) -> String {
    let parity = match line.parity {
        Parity::None => 'N',
        Parity::Even => 'E',
        Parity::Odd => 'O',
    };
    format!("{} {}{parity}{}", line.baud, line.data_bits, line.stop_bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::Frame;

    fn heard(run: RunState, power: bool) -> Device {
        let mut frame = Frame::first(run);
        frame.status.power = power;
        frame.status.enabled = false;
        let mut device = Device::default();
        device.hear(&News::Frame(frame, Vec::new()));
        device
    }

    #[test]
    fn the_line_is_shown_while_a_program_runs() {
        assert_eq!(heard(RunState::Running, true).running_line(), Some(20));
        assert_eq!(heard(RunState::Idle, true).running_line(), None);
        assert_eq!(heard(RunState::Running, false).activity(), Activity::Off);
    }

    #[test]
    fn what_stands_still_says_why() {
        assert_eq!(heard(RunState::Running, true).why(), "");
        let mut device = heard(RunState::Running, true);
        device.frozen = true;
        assert_eq!(device.activity(), Activity::Paused);
        assert_eq!(device.why(), "simulated time stands still");
        assert!(device.can_step());
        let mut held = heard(RunState::Paused, true);
        held.frozen = true;
        assert_eq!(held.why(), "held before its next statement");
        let waits = heard(RunState::Waiting(Wait::Input), true);
        assert_eq!(waits.why(), "answer in the terminal");
    }

    #[test]
    fn a_fault_is_what_counts() {
        let mut device = heard(RunState::Running, true);
        device.hear(&News::Fault(Fault::Died));
        assert_eq!(device.activity(), Activity::Failed);
        assert!(!device.activity().is_running());
    }

    #[test]
    fn the_drive_says_what_keeps_it_from_turning() {
        let mut device = heard(RunState::Running, true);
        assert_eq!(device.drive(false, true).words(), "disabled");
        assert_eq!(
            device.drive(false, false).words(),
            "disabled, ENABLE is off"
        );
        assert_eq!(device.drive(true, true), Drive::Stopped);
        device.status.as_mut().unwrap().fault = Some("F04 feedback".to_owned());
        assert_eq!(device.drive(false, true).words(), "fault F04 feedback");
        assert_eq!(heard(RunState::Idle, false).drive(true, true), Drive::Off);
    }

    #[test]
    fn a_line_setting_is_said_the_usual_way() {
        assert_eq!(line_words(&LineSettings::new(9600)), "9600 8N1");
    }
}
