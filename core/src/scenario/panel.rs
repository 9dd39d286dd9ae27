//! Statements about what a person sees on a station: its display, LEDs and lamps.

use crate::catalog;
use crate::controller::{Led, Panel};

use super::runner::{Done, Failure, Runner};
use super::text::show;
use crate::language::latin1;

impl Runner<'_> {
    fn panel(&mut self, station: usize) -> Result<Panel, Failure> {
        let panel = self.state.bench.panel(station);
        panel.ok_or_else(|| self.has_no(station, "panel"))
    }

    pub(super) fn display(&mut self, station: usize, text: &str) -> Done {
        let shown = self.panel(station)?.display;
        if shown.trim() == text.trim() {
            return Ok(());
        }
        let (text, shown) = (latin1::bytes(text), latin1::bytes(&shown));
        Err(format!(
            "expected the display {}, it is {}",
            show(&text),
            show(&shown)
        )
        .into())
    }

    /// The paper of a printer is what the console's line has sent.
    pub(super) fn printer(&mut self, station: usize, text: &[u8]) -> Done {
        match self.state.bench.panel(station) {
            Some(_) => self.expect(station, text),
            None => Err(self.has_no(station, "printer")),
        }
    }

    pub(super) fn led(&mut self, station: usize, name: &str, state: Led) -> Done {
        let panel = self.panel(station)?;
        let found = panel.leds.iter().find(|(legend, _)| legend == name);
        match found {
            None => Err(self.has_no(station, &format!("LED {name}"))),
            Some(&(_, found)) if found == state => Ok(()),
            Some(&(_, found)) => {
                let (state, found) = (words(state), words(found));
                Err(format!("expected the LED {name} {state}, it is {found}").into())
            }
        }
    }

    /// A lamp is one bit of the signal that the catalogue names.
    pub(super) fn lamp(&mut self, station: usize, name: &str, on: bool) -> Done {
        let id = self.controller(station)?.info().id;
        let lamps = catalog::kind(id).map(|kind| kind.lamps);
        let bit = lamps.and_then(|lamps| {
            let bit = lamps.labels.iter().position(|&label| label == name)?;
            Some((lamps.signal, bit))
        });
        let Some((signal, bit)) = bit else {
            return Err(self.has_no(station, &format!("lamp {name}")));
        };
        let signals = &self.controller(station)?.info().signals;
        let place = signals.iter().position(|known| known.name == signal);
        self.record(station);
        let bits = place.and_then(|place| self.row.get(place)).copied();
        // Up to 32 lamps: exact in a number.
        let lit = libm::floor(bits.unwrap_or_default() / f64::from(1_u32 << bit.min(31))) % 2.0;
        match (lit != 0.0) == on {
            true => Ok(()),
            false if on => Err(format!("expected the lamp {name} on, it is off").into()),
            false => Err(format!("expected the lamp {name} off, it is on").into()),
        }
    }
}

fn words(led: Led) -> &'static str {
    match led {
        Led::Off => "off",
        Led::On => "on",
        Led::Flashing => "flashing",
    }
}
