//! What every controller is to the bench: one trait, and the plain data that passes through it. `surroundings` is what
//! a person is told of it.

mod surroundings;

pub use surroundings::{
    Binary, Choices, DiskInfo, Face, FirstStep, Handle, Joystick, Keycap, Lamps, Opt, Range,
    Setting, TerminalSettings, TextRules, Wired,
};

use crate::exec::Wait;
use crate::ieee488;
use crate::serial::{Frame, LineSettings};
use crate::time::Nanos;

/// A controller with its drives, motors and loads: one station on the bench.
pub trait Controller {
    /// What it is and what it has; constant for the life of the station.
    fn info(&self) -> &ControllerInfo;
    /// The mains switch. Motors coast and files on non-volatile memory stay while it is off.
    fn power(&mut self, at: Nanos, on: bool);
    /// When the next sample is due, also while switched off (the motor still coasts).
    fn next(&self) -> Nanos;
    /// Something reaches the station from outside. It acts at once where the device would, else at the next sample.
    ///
    /// # Errors
    /// [`Refused`] names what the station does not have; nothing has changed then.
    fn input(&mut self, at: Nanos, input: Input) -> Result<(), Refused>;
    /// One sample. What leaves is stamped; the bench delivers it at its stamp, never inside this sample.
    fn sample(&mut self, now: Nanos, ports: &mut Ports);
    /// Appends the value of each of [`ControllerInfo::signals`], in that order.
    fn record(&self, row: &mut Vec<f64>);
    /// Small plain data for every frame of a display; [`Debug::Read`] tells the rest.
    fn status(&self) -> Status;
    /// What its front panel shows; most controllers have none, and a shared one may be switched to another.
    fn panel(&self) -> Option<Panel> {
        None
    }
    /// What it puts on the IEEE-488 bus; most controllers have no such interface.
    fn ieee488(&self) -> Option<ieee488::Lines> {
        None
    }
    /// Breakpoints, stepping, reading and writing.
    fn debug(&mut self, command: Debug) -> DebugReply;
    /// Puts text where the controller keeps programs or files, the way its user would, but taking no time.
    ///
    /// # Errors
    /// [`LoadError`] with the line of the text; the slot is unchanged then.
    fn load(&mut self, slot: &Slot, text: &str) -> Result<Revision, LoadError>;
    /// What stands in a slot; `None` where there is no such thing.
    fn listing(&self, slot: &Slot) -> Option<String>;
    /// What survives, as the device's own items.
    fn memory(&self, event: Survives) -> Memory;
    /// Puts back what [`Controller::memory`] gave, files and all; items it does not know are kept and given again.
    /// What the mains switch clears must be put back after it is turned on.
    fn restore(&mut self, memory: &Memory);
}

/// What a controller is and what it has.
#[derive(Debug, Clone, PartialEq)]
pub struct ControllerInfo {
    /// The name in scenarios and on the command line: `mc600`.
    pub id: &'static str,
    /// For people: `Danaher MC-600`.
    pub name: &'static str,
    /// Axes by their names in signals: `x`.
    pub axes: Vec<&'static str>,
    /// The console's line as it is at the factory.
    pub line: LineSettings,
    /// What the console prints when it is ready for a command; empty where it prints nothing.
    pub prompt: &'static str,
    /// What stops a running program from the console.
    pub attention: &'static [u8],
    /// What the user types to start the loaded program.
    pub start: String,
    /// What the user presses where the console is not listened to; `None` where it always is.
    pub hands_on: Option<HandsOn>,
    /// Where programs are kept: the slot that a bare `load` means.
    pub program_slot: Slot,
    /// Recorded at every sample, in this order.
    pub signals: Vec<Signal>,
    /// Things outside that can be set by [`Input::Wire`].
    pub wires: Vec<String>,
    /// Faults that can be injected.
    pub faults: Vec<&'static str>,
    /// Keys of the front panel, by name; empty without one.
    pub keys: Vec<&'static str>,
    /// Time between samples.
    pub sample: Nanos,
    /// How stations of its kind share a host line.
    pub sharing: Sharing,
    /// The wire of the selector of a front panel that it shares: keys and the selector reach all stations that have it,
    /// and the one that is selected has [`Controller::panel`].
    pub panel_selector: Option<&'static str>,
}

/// Keys of a front panel that has the station for itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HandsOn {
    /// Stops whatever runs.
    pub stop: &'static str,
    /// Has the console listened to, while nothing runs.
    pub listen: &'static str,
}

/// How stations of a kind share the host's serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sharing {
    /// Each has a line of its own.
    Alone,
    /// One behind the other: each passes on what comes in.
    Chain,
    /// All hear the host, and the host hears all. A level that one puts out reaches the one before it.
    Bus,
}

/// One recorded signal.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Signal {
    /// For example `x.position`.
    pub name: String,
    /// For example `counts`.
    pub unit: String,
}

/// What reaches a station.
#[derive(Debug, Clone, PartialEq)]
pub enum Input {
    /// A character on a serial connector (0 is the console), given at the end of its stop bit.
    Frame {
        /// Which connector.
        connector: u8,
        /// The character as it stood on the wire.
        frame: Frame,
    },
    /// A digital or analog input, a joystick, a master encoder, by the controller's own name.
    Wire {
        /// For example `in3`.
        name: String,
        /// 0 and 1, or the unit of the thing.
        value: f64,
    },
    /// A message on a bus between stations.
    Telegram(Telegram),
    /// A message of the controller of the IEEE-488 bus.
    Ieee488(ieee488::Message),
    /// A panel key goes down or up.
    Key {
        /// By the legend.
        key: String,
        /// Down or up.
        down: bool,
    },
    /// Something breaks or is mended.
    Fault {
        /// For example `limit+`.
        kind: String,
        /// The axis it concerns.
        axis: Option<String>,
        /// Broken or mended.
        active: bool,
    },
    /// Changes the mechanics behind an axis.
    Plant {
        /// The axis.
        axis: String,
        /// For example `inertia`.
        key: String,
        /// As written in the scenario.
        value: String,
    },
}

/// A message on a bus (ServoBus, McWay): who may read it is the bus's business.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Telegram {
    /// 1..=2047; 0 is the master's sync.
    pub identifier: u16,
    /// Its data.
    pub data: Vec<i32>,
}

/// What leaves a station in one sample.
#[derive(Debug, Default)]
pub struct Ports {
    /// In the order made; each with the time at which it acts.
    pub outputs: Vec<(Nanos, Output)>,
    /// Motion commands as the program wrote them, where the seam between language and motion is logged.
    pub motion: Vec<(Nanos, String)>,
    /// Whether anyone wants the log of motion commands.
    pub log_motion: bool,
}

/// Something that leaves a station.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// A character on a serial connector, acting at the end of its stop bit.
    Frame {
        /// Which connector.
        connector: u8,
        /// The character as it stands on the wire.
        frame: Frame,
    },
    /// A level that other stations may be wired to.
    Wire {
        /// By the controller's own name.
        name: String,
        /// The new value.
        value: f64,
    },
    /// A message on the bus.
    Telegram(Telegram),
}

/// The station has no such thing; one clear line for the person who asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused(pub String);

/// Where a controller keeps text.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Slot {
    /// The program in working memory.
    Program,
    /// A numbered program.
    Number(u16),
    /// A file, by the device's own name: `B:CUT.BAS`.
    File(String),
}

/// Names one state of a slot's text.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Revision {
    /// Grows with every change of the device's program.
    pub number: u64,
    /// For each line of the text, from 0: the device's own line, where it has one.
    pub lines: Vec<Option<u32>>,
}

/// Why text was not taken.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoadError {
    /// Line of the text, from 0.
    pub line: u32,
    /// One clear sentence, with the device's own words where it has some.
    pub message: String,
}

/// What a display shows of a station.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Status {
    /// The mains switch.
    pub power: bool,
    /// What the program does.
    pub run: RunState,
    /// The device's line that runs or would run next, where the device has lines; of several programs, only in that of
    /// [`ControllerInfo::program_slot`].
    pub line: Option<u32>,
    /// Statements have spent this much firmware time since power-up: names a place in the run.
    pub spent: u64,
    /// Received bytes that no one has read.
    pub unread: usize,
    /// Printed bytes that have not been sent.
    pub unsent: usize,
    /// Some axis is commanded to move or still moves.
    pub moving: bool,
    /// Drive or axis enabled.
    pub enabled: bool,
    /// What has tripped the drive, in its own words; `None` while nothing has.
    pub fault: Option<String>,
    /// The console stands at its prompt, or takes commands without one, and nothing is typed.
    pub at_prompt: bool,
    /// What comes from the console is listened to, now or as soon as there is time.
    pub listens: bool,
    /// The last error that the program ended with, in the device's words; cleared by the next start.
    pub error: Option<String>,
    /// Grows with every change of the device's program, whoever made it.
    pub revision: u64,
}

/// What a front panel shows; its keys are [`ControllerInfo::keys`]. All blank while the station is off.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct Panel {
    /// The text display at its full width, blanks and all.
    pub display: String,
    /// Every LED by its legend.
    pub leds: Vec<(String, Led)>,
    /// The numeric displays by their axes; blank while dark.
    pub tracking: Vec<(String, String)>,
}

/// How an LED stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs)]
pub enum Led {
    #[default]
    Off,
    On,
    Flashing,
}

/// What the program does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum RunState {
    /// No program runs; the console may execute a command.
    Idle,
    /// A direct command runs.
    Command,
    /// A program runs.
    Running,
    /// The running statement waits.
    Waiting(Wait),
    /// Held by the debugger.
    Paused,
}

/// What a debugger asks of a station.
#[derive(Debug, Clone, PartialEq)]
pub enum Debug {
    /// These device lines and no others stop the program before they run.
    Breakpoints(Vec<u32>),
    /// Holds the program, or lets it go.
    Control(Control),
    /// The value of a variable, element or signal by the controller's own name.
    Read(String),
    /// Sets a variable.
    Write(String, Value),
    /// The cam table that is in use.
    Cam,
}

/// How a debugger lets a program run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// Holds the program before its next statement; motion goes on.
    Pause,
    /// Lets a held program go.
    Continue,
    /// Runs one statement of a held program, then holds it again.
    Step,
    /// Runs a held program until [`Status::spent`] is at least this, then holds it again.
    RunTo(u64),
}

/// What a debugger is told.
#[derive(Debug, Clone, PartialEq)]
pub enum DebugReply {
    /// It is done.
    Done,
    /// A value was asked for.
    Value(Value),
    /// The cam table was asked for.
    Cam(CamTable),
    /// It cannot be done; one clear line.
    Refused(String),
}

/// A cam table, for a drawing.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CamTable {
    /// Its points, in counts of the axis; they stand at equal distances of the master.
    pub points: Vec<i32>,
    /// Where the master stands, in points from the first.
    pub at: f64,
    /// Where the axis is to be there, in counts.
    pub demand: f64,
}

/// A value of some controller's language.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub enum Value {
    /// Numbers of every kind.
    Number(f64),
    /// Bytes as characters U+0000 to U+00FF.
    Text(String),
}

/// What memory has to survive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Survives {
    /// The mains switch: only non-volatile memory.
    MainsSwitch,
    /// A reload of the page around a device that stays on: also programs and files in RAM.
    Reload,
}

/// What a device holds that can be put back.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct Memory {
    /// Of the items below; an unknown one is kept untouched.
    pub version: u32,
    /// Files, EEPROM contents, options.
    pub items: Vec<MemoryItem>,
}

/// One item of non-volatile memory.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct MemoryItem {
    /// By the device's own name: `B:CUT.BAS`.
    pub name: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}
