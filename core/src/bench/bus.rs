//! The IEEE-488 bus that all stations with such an interface share, and its controller.

use super::Bench;
use crate::controller::{Input, Refused};
use crate::ieee488::{Controller, Lines, Message, Order, Report, Step};
use crate::probe::Probe;
use crate::time::Nanos;

/// How the bus stands, for a person who looks at it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct BusView {
    /// SRQ: some unit requests service.
    pub service: bool,
    /// REN.
    pub remote_enabled: bool,
    /// The controller has something to do.
    pub busy: bool,
    /// It cannot: the listener that holds it off, or no one listens.
    pub waits: Option<BusWait>,
}

/// Why the controller of the bus cannot go on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum BusWait {
    /// This station listens and is not ready for data.
    Station(usize),
    /// No one listens.
    NoListener,
}

impl Bench {
    /// Asks something of the controller of the IEEE-488 bus. It is done in its turn; what it learns goes to
    /// [`Probe::bus`].
    ///
    /// # Errors
    /// [`Refused`] if no station has such an interface, or too much is asked at once.
    pub fn order(&mut self, order: &Order) -> Result<(), Refused> {
        let refuse = |reason: &str| Err(Refused(reason.to_owned()));
        match self.bus.as_mut().map(|bus| bus.order(order)) {
            None => refuse("no controller has an IEEE-488 bus"),
            Some(true) => Ok(()),
            Some(false) => refuse("too much is asked of the bus at once"),
        }
    }

    /// How the IEEE-488 bus stands; `None` if no station has such an interface.
    pub fn bus(&self) -> Option<BusView> {
        let bus = self.bus.as_ref()?;
        let data = matches!(bus.next(), Some(Step::Message(Message::Data { .. })));
        Some(BusView {
            service: self.lines().any(|(_, lines)| lines.service),
            remote_enabled: bus.remote_enabled(),
            busy: bus.is_busy(),
            waits: self.obstacle().filter(|_| data),
        })
    }

    /// Why data would not be taken now.
    fn obstacle(&self) -> Option<BusWait> {
        let mut listeners = self.lines().filter(|(_, lines)| lines.listens).peekable();
        if listeners.peek().is_none() {
            return Some(BusWait::NoListener);
        }
        let holds = listeners.find(|(_, lines)| lines.holds_off);
        holds.map(|(station, _)| BusWait::Station(station))
    }

    /// What each station puts on the bus.
    fn lines(&self) -> impl Iterator<Item = (usize, Lines)> + '_ {
        let places = self.stations.iter().enumerate();
        places.filter_map(|(index, place)| Some((index, place.station.controller().ieee488()?)))
    }

    /// The station that talks, and what it offers.
    fn offer(&self) -> Option<(usize, (u8, bool))> {
        self.lines()
            .find_map(|(index, lines)| Some((index, lines.data?)))
    }

    /// Whether nothing is on the bus, nor about to be.
    pub(super) fn is_bus_quiet(&self) -> bool {
        self.bus_due().is_none()
    }

    /// When the controller of the bus acts next.
    pub(super) fn bus_due(&self) -> Option<Nanos> {
        let bus = self.bus.as_ref()?;
        let acts = bus.is_busy() || (bus.receives() && self.offer().is_some());
        acts.then(|| bus.free().max(self.now))
    }

    /// The controller of the bus does what is next.
    pub(super) fn act_on_bus(&mut self, probe: &mut Probe) {
        let now = self.now;
        let next = self.bus.as_ref().and_then(Controller::next);
        let done = match next {
            None => return self.hear_talker(probe),
            Some(Step::Message(Message::Data { .. })) if self.obstacle().is_some() => false,
            Some(Step::Message(message)) => {
                self.tell_all(message);
                true
            }
            Some(Step::Status(address)) => {
                let offer = self.offer();
                if let Some((talker, _)) = offer {
                    self.tell(talker, Message::Accepted);
                }
                let status = offer.map(|(_, (byte, _))| byte);
                probe.bus.push(Report::SerialPoll(address, status));
                true
            }
            Some(Step::Identify) => {
                let bits = self
                    .lines()
                    .fold(0, |bits, (_, lines)| bits | lines.parallel);
                probe.bus.push(Report::ParallelPoll(bits));
                true
            }
            Some(Step::Receive) => true,
        };
        if let Some(bus) = &mut self.bus {
            bus.tried(now, done);
        }
    }

    /// Takes a byte from the talker.
    fn hear_talker(&mut self, probe: &mut Probe) {
        let now = self.now;
        if let Some((talker, (byte, end))) = self.offer() {
            self.tell(talker, Message::Accepted);
            probe.bus.push(Report::Data(byte, end));
        }
        if let Some(bus) = &mut self.bus {
            bus.received(now);
        }
    }

    fn tell_all(&mut self, message: Message) {
        for station in 0..self.stations.len() {
            self.tell(station, message);
        }
    }

    fn tell(&mut self, station: usize, message: Message) {
        // A station without an interface refuses it.
        let _ = self.input(station, Input::Ieee488(message));
    }
}
