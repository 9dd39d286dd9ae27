//! Front panels: of one station, or one for several with a selector.

use super::Bench;
use crate::controller::{Input, Panel, Refused};

impl Bench {
    /// What the panel in front of a station shows: of a shared one, what it is switched to, and blanks where that is no
    /// station. `None` if the station has no panel.
    pub fn panel(&self, station: usize) -> Option<Panel> {
        let controller = self.station(station)?;
        let Some(selector) = controller.info().panel_selector else {
            return controller.panel();
        };
        let mut panels = self.behind_panel(selector);
        let shown = panels.find_map(|station| self.station(station)?.panel());
        Some(shown.unwrap_or_default())
    }

    /// The stations whose panel has this selector.
    fn behind_panel(&self, selector: &'static str) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(move |&station| {
            let station = self.station(station);
            station.is_some_and(|station| station.info().panel_selector == Some(selector))
        })
    }

    /// The stations that an input at a shared panel reaches; none if it is no such input.
    pub(super) fn at_shared_panel(&self, station: usize, input: &Input) -> Vec<usize> {
        let selector = self.station(station).and_then(|s| s.info().panel_selector);
        match (selector, input) {
            (Some(selector), Input::Key { .. }) => self.behind_panel(selector).collect(),
            (Some(selector), Input::Wire { name, .. }) if name == selector => {
                self.behind_panel(selector).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Gives an input to each of them.
    pub(super) fn input_to(&mut self, stations: &[usize], input: &Input) -> Result<(), Refused> {
        let now = self.now;
        stations.iter().try_for_each(|&station| {
            let station = self.station_mut(station);
            station.map_or(Ok(()), |station| station.input(now, input.clone()))
        })
    }
}
