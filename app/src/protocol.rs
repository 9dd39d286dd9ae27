//! What the page and the worker say to each other.
//!
//! A message is JSON text; the samples of a frame travel beside it as one array of numbers, whose buffer is handed
//! over rather than copied. Console bytes are text in the devices' eight-bit characters.

use motionbench_core::bench::BusView;
use motionbench_core::controller::{
    CamTable, Memory, Panel, Revision, Signal, Status, TerminalSettings,
};
use motionbench_core::ieee488::{Order, Report};
use motionbench_core::serial::LineSettings;
use motionbench_core::time::Nanos;
use motionbench_core::trace::Trace;
use serde::{Deserialize, Serialize};

/// Names the sources that this was built from. The worker's files have fixed names, so a cached worker may be of
/// another build than the page.
pub const BUILD: &str = env!("MOTIONBENCH_BUILD");

/// Frames that the worker may have sent without hearing that they were taken.
pub const MOST_UNTAKEN: u64 = 2;

/// From the page to the worker.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum ToWorker {
    /// These characters go to the console, at line speed.
    Send(String),
    /// These characters go to the console at a pace, behind those that wait.
    SendPaced {
        /// The characters.
        text: String,
        /// Their pace.
        pace: Pace,
    },
    /// The byte that stops a program goes to the console at once; what was still to be sent is forgotten.
    Stop,
    /// The start command is typed on the console, after [`ToWorker::Stop`] if the console is not at its prompt.
    Run,
    /// This text becomes the controller's program, and is started as by [`ToWorker::Run`] if asked for. Answered by
    /// [`FromWorker::Loaded`].
    Load {
        /// The program.
        text: String,
        /// Start it.
        start: bool,
    },
    /// The controller's program is wanted. Answered by [`FromWorker::Listing`].
    Take,
    /// These lines of the controller's program, and no others, hold it before they run.
    Breakpoints(Vec<u32>),
    /// Simulated time stands still, and the program with it, or goes on.
    Freeze(bool),
    /// One statement of the program, then everything stands still.
    Step,
    /// The emergency stop of the machine is pressed, or released.
    EmergencyStop(bool),
    /// A switch or a knob outside the controller, by the controller's name for it.
    Wire {
        /// For example `in3`.
        name: String,
        /// 0 and 1, or the unit of the thing.
        value: f64,
    },
    /// A key of the front panel goes down or up.
    Key {
        /// By the controller's name for it.
        key: String,
        /// Down or up.
        down: bool,
    },
    /// The selector of a front panel that units share is turned to this one, from 0. What comes behind is for that unit.
    Select(usize),
    /// Something is asked of the controller of the IEEE-488 bus.
    Bus(Order),
    /// How the terminal's end of the line is set.
    Line(LineSettings),
    /// What the terminal does besides.
    Terminal(TerminalSettings),
    /// The line is held low for a moment.
    Break,
    /// Characters that wait to be sent are forgotten.
    Cancel,
    /// What the controller holds is wanted, if it is not as it was when last asked for. Answered by
    /// [`FromWorker::Kept`], or not at all.
    Keep,
    /// What an earlier [`FromWorker::Kept`] said is put back.
    Restore(Memory),
    /// A text becomes a file of the controller. Answered by [`FromWorker::Filed`].
    PutFile {
        /// By the controller's own name: `B:CUT.BAS`.
        name: String,
        /// Its contents.
        text: String,
    },
    /// The cam table is wanted. Answered by [`FromWorker::Cam`].
    Cam,
    /// The mains switch.
    Power(bool),
    /// How fast simulated time shall pass.
    Speed(Speed),
    /// Frames up to this number have been taken.
    Taken(u64),
}

/// How the text of a file is sent, in simulated time, to a device that cannot take it as fast as the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Pace {
    /// The pause behind each character.
    pub character: Nanos,
    /// The pause behind each line, besides.
    pub line: Nanos,
    /// Each line waits for the prompt behind the one before.
    pub prompt: bool,
}

/// How fast simulated time passes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Speed {
    /// Simulated seconds a second, 0.01 to 100.
    Times(f64),
    /// As fast as the machine can.
    Max,
}

/// From the worker to the page. The first is [`FromWorker::Ready`].
#[allow(clippy::large_enum_variant)] // there is one at a time
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum FromWorker {
    /// The bench stands and takes messages.
    Ready(Ready),
    /// What happened since the frame before; at most 60 a second.
    Frame(Frame),
    /// The text became the controller's program, or why not.
    Loaded(Result<Revision, Unloadable>),
    /// The controller's program, and the revision that it has.
    Listing {
        /// As the controller would list it.
        text: String,
        /// As in [`Status::revision`].
        revision: u64,
    },
    /// All that the controller holds.
    Kept(Memory),
    /// The cam table that is in use, if there is one.
    Cam(Option<CamTable>),
    /// The name of a file that the controller has taken, or why it has not.
    Filed(Result<String, String>),
}

/// Why a text did not become the controller's program.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unloadable {
    /// Line of the text, from 0.
    pub line: u32,
    /// One clear sentence.
    pub message: String,
}

/// What the page must know before anything else.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ready {
    /// The worker's [`BUILD`].
    pub build: String,
    /// The controller's name for people.
    pub controller: String,
    /// How its console is set.
    pub line: LineSettings,
    /// What its samples hold, in this order.
    pub signals: Vec<Signal>,
    /// Units behind its front panel, each with such signals.
    pub units: usize,
}

/// What happened since the frame before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// From 1.
    pub number: u64,
    /// Simulated time.
    pub now: Nanos,
    /// The unit that its front panel is switched to, from 0: what is told here is of that one, if not of the bench.
    pub unit: usize,
    /// How many of the samples beside the frame are each unit's.
    pub parts: Vec<usize>,
    /// What the controller does.
    pub status: Status,
    /// Grows with all that may change what [`ToWorker::Keep`] keeps.
    pub work: u64,
    /// Simulated seconds a second, lately.
    pub reached: f64,
    /// What its front panel shows, where it has one.
    pub panel: Option<Panel>,
    /// How the IEEE-488 bus stands, where there is one.
    pub bus: Option<BusView>,
    /// What its controller has learnt.
    pub learnt: Vec<Report>,
    /// What the terminal shows: what the console received, and what was sent if that is shown too.
    pub console: String,
    /// What the console received, where that is not all that the terminal shows.
    pub received: Option<String>,
    /// Characters that wait to be sent to the controller.
    pub pending: usize,
    /// Simulated time stands still.
    pub frozen: bool,
}

#[cfg(test)]
impl Frame {
    /// The first frame of a controller that is switched on and does this, in line 20.
    pub(crate) fn first(run: motionbench_core::controller::RunState) -> Frame {
        let status = Status {
            power: true,
            run,
            line: Some(20),
            spent: 0,
            unread: 0,
            unsent: 0,
            moving: false,
            enabled: true,
            fault: None,
            at_prompt: false,
            listens: true,
            error: None,
            revision: 1,
        };
        Frame {
            number: 1,
            now: Nanos::from_millis(1500),
            unit: 0,
            parts: Vec::new(),
            status,
            work: 0,
            reached: 1.0,
            panel: None,
            bus: None,
            learnt: Vec::new(),
            console: String::new(),
            received: None,
            pending: 0,
            frozen: false,
        }
    }
}

/// What a worker is told by its name: the kind of controller, and its options as in a scenario.
pub fn bench_name(kind: &str, options: &[(String, String)]) -> String {
    let words = options.iter().map(|(key, value)| format!(" {key}={value}"));
    kind.to_owned() + &words.collect::<String>()
}

/// What [`bench_name`] was given; an option that is not one is passed over.
pub fn read_bench_name(name: &str) -> (&str, Vec<(String, String)>) {
    let (kind, options) = name.split_once(' ').unwrap_or((name, ""));
    let options = options.split(' ').filter_map(|word| word.split_once('='));
    let options = options.map(|(key, value)| (key.to_owned(), value.to_owned()));
    (kind, options.collect())
}

/// The rows of a trace, column by column: first the times in nanoseconds (exact for 104 days), then each signal.
pub fn pack(trace: &Trace) -> Vec<f64> {
    let mut packed = Vec::with_capacity(trace.len() * (trace.signals() + 1));
    packed.extend(trace.rows(0).map(|(at, _)| at.0 as f64));
    for signal in 0..trace.signals() {
        packed.extend(trace.rows(signal).map(|(_, value)| value));
    }
    packed
}

/// Appends what [`pack`] gave to a trace of the same signals; calls `each` with every row. Anything else is ignored.
pub fn unpack(packed: &[f64], trace: &mut Trace, mut each: impl FnMut(Nanos, &[f64])) {
    let columns = trace.signals() + 1;
    let rows = packed.len() / columns;
    if packed.len() != rows * columns {
        return;
    }
    let mut values = vec![0.0; trace.signals()];
    for row in 0..rows {
        let at = Nanos(packed[row] as u64);
        for (signal, value) in values.iter_mut().enumerate() {
            *value = packed[(signal + 1) * rows + row];
        }
        trace.push(at, &values);
        each(at, &values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_arrive_as_they_were_recorded() {
        let mut recorded = Trace::new(2, 100);
        (0..50).for_each(|i| recorded.push(Nanos(i * 2_000_000), &[i as f64, -0.5 * i as f64]));
        let mut arrived = Trace::new(2, 100);
        let mut rows = 0;
        unpack(&pack(&recorded), &mut arrived, |_, _| rows += 1);
        assert_eq!(rows, 50);
        for signal in 0..2 {
            assert!(recorded.rows(signal).eq(arrived.rows(signal)));
        }
    }

    #[test]
    fn samples_of_other_signals_are_ignored() {
        let mut trace = Trace::new(2, 100);
        unpack(&[1.0, 2.0, 3.0, 4.0], &mut trace, |_, _| {});
        assert!(trace.is_empty());
    }

    #[test]
    fn every_eight_bit_character_and_a_century_survive_the_wire() {
        let console: String = (0..=255u8).map(char::from).collect();
        let message = ToWorker::Send(console);
        let wire = serde_json::to_string(&message).unwrap();
        assert_eq!(serde_json::from_str::<ToWorker>(&wire).unwrap(), message);
        let century = Nanos(3_155_760_000 * 1_000_000_000 + 1);
        let wire = serde_json::to_string(&century).unwrap();
        assert_eq!(serde_json::from_str::<Nanos>(&wire).unwrap(), century);
    }
}
