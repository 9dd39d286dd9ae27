//! The bench: stations, the lines between them and the host, and the simulated clock.
//!
//! A discrete-event loop: what is due first happens first; at the same time, what is on the wires comes before
//! samples, and samples come in the order of the stations (the bus master first). What a sample sends acts at its own
//! stamp, never inside the sample that made it. A clone of the bench is a checkpoint.

mod bus;
mod panel;

pub use bus::{BusView, BusWait};

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::catalog::Station;
use crate::controller::{Controller, Input, Output, Ports, Refused, Sharing, Telegram};
use crate::ieee488;
use crate::probe::{ConsoleByte, MotionLog, Probe};
use crate::serial::Flow;
use crate::serial::{Frame, LineSettings, Receiver, Transmitter, XOFF, XON};
use crate::time::Nanos;
use crate::trace::Trace;

/// Bytes that a host may have queued; typing more is refused, sending a file goes on as room comes.
pub const HOST_QUEUE: usize = 4 << 20;
/// Rows that a probe's trace keeps: over half an hour at 500 a second.
pub const TRACE_ROWS: usize = 1 << 20;

/// Stations and wiring, at one point in simulated time.
#[derive(Debug, Clone, Default)]
pub struct Bench {
    now: Nanos,
    stations: Vec<Place>,
    lines: Vec<HostLine>,
    /// The controller of the IEEE-488 bus, once a station has an interface to it.
    bus: Option<ieee488::Controller>,
    events: BinaryHeap<Reverse<Event>>,
    sequence: u64,
}

/// A station in its place.
#[derive(Debug, Clone)]
struct Place {
    name: String,
    station: Station,
    /// Its console hangs on this host line.
    line: usize,
}

/// A serial line between a host and one or more stations: in a chain (host, first, second, ..., host), or on a bus.
#[derive(Debug, Clone)]
struct HostLine {
    transmitter: Transmitter,
    receiver: Receiver,
    chain: Vec<usize>,
    bus: bool,
}

/// Something on its way.
#[derive(Debug, Clone, PartialEq)]
struct Event {
    at: Nanos,
    sequence: u64,
    to: Destination,
    what: Passing,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Destination {
    Station(usize),
    Host(usize),
}

#[derive(Debug, Clone, PartialEq)]
enum Passing {
    Frame(u8, Frame),
    Telegram(Telegram),
    Wire(String, f64),
}

impl Eq for Event {}

impl PartialOrd for Event {
    fn partial_cmp(&self, other: &Event) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Event {
    fn cmp(&self, other: &Event) -> std::cmp::Ordering {
        (self.at, self.sequence).cmp(&(other.at, other.sequence))
    }
}

/// What is due next.
enum Due {
    Event,
    Bus,
    Host(usize),
    Station(usize),
}

impl Bench {
    /// An empty bench at time zero.
    pub fn new() -> Bench {
        Bench::default()
    }

    /// Puts a station on the bench, switched off, and its console on a host line: a new one set as the station's
    /// factory setting, or the chain of an existing one. Returns its index.
    pub fn add(&mut self, name: &str, station: Station, chain: Option<usize>) -> usize {
        let index = self.stations.len();
        let line = match chain.filter(|&line| line < self.lines.len()) {
            Some(line) => line,
            None => {
                let info = station.controller().info();
                let (settings, bus) = (info.line, info.sharing == Sharing::Bus);
                self.lines.push(HostLine {
                    transmitter: Transmitter::new(settings),
                    receiver: Receiver::new(settings),
                    chain: Vec::new(),
                    bus,
                });
                self.lines.len() - 1
            }
        };
        if let Some(line) = self.lines.get_mut(line) {
            line.chain.push(index);
        }
        if station.controller().ieee488().is_some() {
            self.bus.get_or_insert_default();
        }
        self.stations.push(Place {
            name: name.to_owned(),
            station,
            line,
        });
        index
    }

    /// The present time.
    pub fn now(&self) -> Nanos {
        self.now
    }

    /// How many stations there are.
    pub fn len(&self) -> usize {
        self.stations.len()
    }

    /// Whether there is no station.
    pub fn is_empty(&self) -> bool {
        self.stations.is_empty()
    }

    /// A station by its index.
    pub fn station(&self, index: usize) -> Option<&dyn Controller> {
        self.stations
            .get(index)
            .map(|place| place.station.controller())
    }

    /// A station by its index, to load, debug or restore.
    pub fn station_mut(&mut self, index: usize) -> Option<&mut dyn Controller> {
        self.stations
            .get_mut(index)
            .map(|place| place.station.controller_mut())
    }

    /// The index of the station called `name`.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.stations.iter().position(|place| place.name == name)
    }

    /// The host line that a station's console hangs on.
    pub fn line_of(&self, station: usize) -> Option<usize> {
        self.stations.get(station).map(|place| place.line)
    }

    /// Turns a station's mains switch.
    pub fn power(&mut self, station: usize, on: bool) {
        let now = self.now;
        if let Some(station) = self.station_mut(station) {
            station.power(now, on);
        }
    }

    /// Gives a station something from outside, now. A key of a shared panel reaches the one that it is switched to.
    ///
    /// # Errors
    /// [`Refused`] if there is no such station, or it has no such thing.
    pub fn input(&mut self, station: usize, input: Input) -> Result<(), Refused> {
        let now = self.now;
        let reached = self.at_shared_panel(station, &input);
        if !reached.is_empty() {
            return self.input_to(&reached, &input);
        }
        match self.station_mut(station) {
            Some(station) => station.input(now, input),
            None => Err(Refused(format!("there is no station {station}"))),
        }
    }

    /// Queues bytes on the host's side of a line; they travel at line speed. Returns how many had room.
    pub fn send(&mut self, line: usize, bytes: &[u8]) -> usize {
        let Some(line) = self.lines.get_mut(line) else {
            return 0;
        };
        let room = HOST_QUEUE
            .saturating_sub(line.transmitter.pending())
            .min(bytes.len());
        bytes
            .iter()
            .take(room)
            .for_each(|&byte| line.transmitter.push(byte));
        room
    }

    /// Sends bytes instead of everything queued, even when XOFF holds the rest: the Ctrl-C of an impatient person.
    pub fn send_urgent(&mut self, line: usize, bytes: &[u8]) {
        if let Some(line) = self.lines.get_mut(line) {
            line.transmitter.discard();
            line.transmitter.hold(false);
            bytes.iter().for_each(|&byte| line.transmitter.push(byte));
        }
    }

    /// Sends a break.
    pub fn send_break(&mut self, line: usize) {
        if let Some(line) = self.lines.get_mut(line) {
            line.transmitter.push_break();
        }
    }

    /// Forgets what the host has queued and not begun to send; returns how many bytes that were.
    pub fn cancel(&mut self, line: usize) -> usize {
        let Some(line) = self.lines.get_mut(line) else {
            return 0;
        };
        let pending = line.transmitter.pending();
        line.transmitter.discard();
        pending
    }

    /// Bytes that the host has queued and not begun to send.
    pub fn host_pending(&self, line: usize) -> usize {
        self.lines
            .get(line)
            .map_or(0, |line| line.transmitter.pending())
    }

    /// How the host's side of a line is set.
    pub fn line_settings(&self, line: usize) -> Option<LineSettings> {
        self.lines.get(line).map(|line| line.transmitter.settings())
    }

    /// Sets the host's side of a line.
    pub fn set_line(&mut self, line: usize, settings: LineSettings) {
        if let Some(line) = self.lines.get_mut(line) {
            line.transmitter.set(settings);
            line.receiver.set(settings);
            if settings.flow == Flow::None {
                line.transmitter.hold(false);
            }
        }
    }

    /// Whether no byte is on its way and no host has anything left to send (what XOFF holds back counts). On a bus between
    /// stations there may always be something.
    pub fn is_quiet(&self) -> bool {
        let is_telegram = |event: &Event| matches!(event.what, Passing::Telegram(_));
        self.is_bus_quiet()
            && self.events.iter().all(|Reverse(event)| is_telegram(event))
            && self
                .lines
                .iter()
                .all(|line| !line.transmitter.is_busy(self.now))
    }

    /// Advances simulated time to `until`; everything due by then has happened.
    pub fn run_until(&mut self, until: Nanos, probe: &mut Probe) {
        let mut ports = Ports {
            log_motion: probe.log_motion,
            ..Ports::default()
        };
        while let Some((at, due)) = self.next_due().filter(|&(at, _)| at <= until) {
            self.now = at;
            self.perform(due, &mut ports, probe);
        }
        self.now = self.now.max(until);
        for line in 0..self.lines.len() {
            self.receive(line, probe);
        }
    }

    /// Advances to the next thing that is due, if it is due by `until`, and does it; `false` if there was none.
    pub fn run_next(&mut self, until: Nanos, probe: &mut Probe) -> bool {
        let Some((at, due)) = self.next_due().filter(|&(at, _)| at <= until) else {
            return false;
        };
        let mut ports = Ports {
            log_motion: probe.log_motion,
            ..Ports::default()
        };
        self.now = at;
        self.perform(due, &mut ports, probe);
        true
    }

    fn next_due(&self) -> Option<(Nanos, Due)> {
        let event = self
            .events
            .peek()
            .map(|Reverse(event)| (event.at, Due::Event));
        let mut first = event;
        let mut consider = |at: Nanos, due: Due| {
            if first.as_ref().is_none_or(|&(earliest, _)| at < earliest) {
                first = Some((at, due));
            }
        };
        if let Some(at) = self.bus_due() {
            consider(at, Due::Bus);
        }
        for (index, line) in self.lines.iter().enumerate() {
            if let Some(at) = line.transmitter.next_start(self.now) {
                consider(at, Due::Host(index));
            }
        }
        for (index, place) in self.stations.iter().enumerate() {
            consider(place.station.controller().next(), Due::Station(index));
        }
        first
    }

    fn perform(&mut self, due: Due, ports: &mut Ports, probe: &mut Probe) {
        match due {
            Due::Event => {
                if let Some(Reverse(event)) = self.events.pop() {
                    self.deliver(event, probe);
                }
            }
            Due::Bus => self.act_on_bus(probe),
            Due::Host(index) => {
                let now = self.now;
                let line = self.lines.get_mut(index);
                let begun = line.and_then(|line| {
                    let frame = line.transmitter.next_frame(now, Nanos::MAX)?;
                    let hear = if line.bus { line.chain.len() } else { 1 };
                    let hearers = line.chain.iter().take(hear);
                    Some((frame, hearers.copied().collect::<Vec<usize>>()))
                });
                if let Some((frame, hearers)) = begun {
                    for station in hearers {
                        let to = Destination::Station(station);
                        self.schedule(frame.end(), to, Passing::Frame(0, frame));
                    }
                }
            }
            Due::Station(index) => self.sample(index, ports, probe),
        }
    }

    fn sample(&mut self, index: usize, ports: &mut Ports, probe: &mut Probe) {
        let now = self.now;
        let Some(place) = self.stations.get_mut(index) else {
            return;
        };
        let controller = place.station.controller_mut();
        controller.sample(now, ports);
        if probe.record {
            probe.row.clear();
            controller.record(&mut probe.row);
            while probe.traces.len() <= index {
                probe.traces.push(Trace::new(probe.row.len(), TRACE_ROWS));
            }
            if let Some(trace) = probe.traces.get_mut(index) {
                trace.push(now, &probe.row);
            }
        }
        for (at, command) in ports.motion.drain(..) {
            probe.motion.push(MotionLog {
                station: index,
                at,
                command,
            });
        }
        for (at, output) in std::mem::take(&mut ports.outputs) {
            self.route(index, at, output);
        }
    }

    /// Sends what left a station to whoever it is for.
    fn route(&mut self, from: usize, at: Nanos, output: Output) {
        match output {
            // Only the console has a line; other connectors have no plug.
            Output::Frame { connector, frame } if connector == 0 => {
                let Some(place) = self.stations.get(from) else {
                    return;
                };
                let Some(line) = self.lines.get(place.line) else {
                    return;
                };
                let position = line.chain.iter().position(|&station| station == from);
                let next = position.and_then(|position| line.chain.get(position + 1));
                let next = next.filter(|_| !line.bus);
                let to = next.map_or(Destination::Host(place.line), |&station| {
                    Destination::Station(station)
                });
                self.schedule(at, to, Passing::Frame(connector, frame));
            }
            Output::Telegram(telegram) => {
                for station in (0..self.stations.len()).filter(|&station| station != from) {
                    self.schedule(
                        at,
                        Destination::Station(station),
                        Passing::Telegram(telegram.clone()),
                    );
                }
            }
            Output::Wire { name, value } => {
                if let Some(before) = self.before_on_bus(from) {
                    let to = Destination::Station(before);
                    self.schedule(at, to, Passing::Wire(name, value));
                }
            }
            Output::Frame { .. } => {}
        }
    }

    /// The station nearer to the host on a bus.
    fn before_on_bus(&self, station: usize) -> Option<usize> {
        let line = self.lines.get(self.line_of(station)?)?;
        let position = line.chain.iter().position(|&other| other == station)?;
        let before = line.chain.get(position.checked_sub(1)?);
        before.copied().filter(|_| line.bus)
    }

    fn schedule(&mut self, at: Nanos, to: Destination, what: Passing) {
        self.sequence += 1;
        self.events.push(Reverse(Event {
            at: at.max(self.now),
            sequence: self.sequence,
            to,
            what,
        }));
    }

    fn deliver(&mut self, event: Event, probe: &mut Probe) {
        match (event.to, event.what) {
            (Destination::Station(index), Passing::Frame(connector, frame)) => {
                // A station has no say in what reaches it on a wire: there is nothing to refuse.
                let _ = self.input(index, Input::Frame { connector, frame });
            }
            (Destination::Station(index), Passing::Telegram(telegram)) => {
                let _ = self.input(index, Input::Telegram(telegram));
            }
            (Destination::Host(line), Passing::Frame(_, frame)) => {
                if let Some(line) = self.lines.get_mut(line) {
                    line.receiver.accept(frame);
                }
                self.receive(line, probe);
            }
            (Destination::Station(index), Passing::Wire(name, value)) => {
                let _ = self.input(index, Input::Wire { name, value });
            }
            (Destination::Host(_), Passing::Telegram(_) | Passing::Wire(..)) => {}
        }
    }

    /// Reads what has arrived at a host.
    fn receive(&mut self, index: usize, probe: &mut Probe) {
        let now = self.now;
        let Some(line) = self.lines.get_mut(index) else {
            return;
        };
        while let Some(received) = line.receiver.next(now) {
            let obeys = line.transmitter.settings().flow == Flow::XonXoff;
            match received.byte {
                XOFF if obeys => line.transmitter.hold(true),
                XON if obeys => line.transmitter.hold(false),
                byte => probe.console.push(ConsoleByte {
                    line: index,
                    at: received.at,
                    byte,
                }),
            }
        }
    }
}
