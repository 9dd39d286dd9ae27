//! What is wired to the controller: switches and knobs at its inputs, lamps at its outputs, the emergency stop of the
//! machine.

use motionbench_core::catalog::Kind;
use motionbench_core::controller::{Handle, Wired};

use crate::protocol::ToWorker;

/// How the switches and knobs stand. They are outside the controller: the mains switch and a simulator that starts again
/// leave them as they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Wiring {
    inputs: &'static [Wired],
    /// The unit whose inputs are meant, where several share a front panel, from 0; and how those of each stand.
    unit: usize,
    values: Vec<Vec<f64>>,
    estop: bool,
}

impl Wiring {
    /// A new bench for a controller.
    pub fn new(kind: &Kind) -> Wiring {
        Wiring {
            inputs: kind.inputs,
            unit: 0,
            values: vec![kind.inputs.iter().map(|input| input.at).collect()],
            estop: false,
        }
    }

    /// What there is at the inputs.
    pub fn inputs(&self) -> &'static [Wired] {
        self.inputs
    }

    /// How an input stands.
    pub fn value(&self, input: usize) -> f64 {
        let values = self.values.get(self.unit);
        let value = values.and_then(|values| values.get(input));
        value.copied().unwrap_or_default()
    }

    /// There are so many units, each with such inputs.
    pub fn set_units(&mut self, units: usize) {
        let usual = || self.inputs.iter().map(|input| input.at).collect();
        self.values.resize_with(units.max(1), usual);
        self.unit = self.unit.min(self.values.len() - 1);
    }

    /// Whether an input is on: nearer to its upper end.
    pub fn is_on(&self, input: usize) -> bool {
        let ends = self.inputs.get(input).map(|input| ends(input.handle));
        ends.is_some_and(|(from, to)| self.value(input) > 0.5 * (from + to))
    }

    /// Whether the emergency stop is pressed.
    pub fn is_stopped(&self) -> bool {
        self.estop
    }

    /// The message that switches an input over.
    pub fn switch(&self, input: usize) -> Option<ToWorker> {
        let (from, to) = ends(self.inputs.get(input)?.handle);
        self.turn(input, if self.is_on(input) { from } else { to })
    }

    /// The message that sets an input.
    pub fn turn(&self, input: usize, value: f64) -> Option<ToWorker> {
        let wired = self.inputs.get(input)?;
        let (from, to) = match wired.handle {
            Handle::Jog(_) => (value, value),
            handle => ends(handle),
        };
        Some(ToWorker::Wire {
            name: wired.wire.to_owned(),
            value: value.clamp(from, to),
        })
    }

    /// Takes in what is sent to the worker.
    pub fn hear(&mut self, message: &ToWorker) {
        match message {
            ToWorker::EmergencyStop(pressed) => self.estop = *pressed,
            ToWorker::Select(unit) if *unit < self.values.len() => self.unit = *unit,
            ToWorker::Wire { name, value } => {
                let stays = |input: &Wired| !matches!(input.handle, Handle::Jog(_));
                let place = self
                    .inputs
                    .iter()
                    .position(|input| input.wire == name && stays(input));
                let values = self.values.get_mut(self.unit);
                if let (Some(place), Some(values)) = (place, values)
                    && let Some(held) = values.get_mut(place)
                {
                    *held = *value;
                }
            }
            _ => {}
        }
    }

    /// What a simulator that has just started must be told.
    pub fn differences(&self) -> Vec<ToWorker> {
        let mut messages = Vec::new();
        let mut selected = 0;
        let mut select = |unit: usize, messages: &mut Vec<ToWorker>| {
            if selected != unit {
                selected = unit;
                messages.push(ToWorker::Select(unit));
            }
        };
        for (unit, values) in self.values.iter().enumerate() {
            let stands = self.inputs.iter().zip(values).enumerate();
            for (place, (_, value)) in stands.filter(|(_, (input, value))| input.at != **value) {
                select(unit, &mut messages);
                messages.extend(self.turn(place, *value));
            }
        }
        select(self.unit, &mut messages);
        if self.estop {
            messages.push(ToWorker::EmergencyStop(true));
        }
        messages
    }
}

fn ends(handle: Handle) -> (f64, f64) {
    match handle {
        Handle::Switch => (0.0, 1.0),
        Handle::Knob(range) | Handle::Pin(range) => (range.from, range.to),
        Handle::Jog(_) => (0.0, 0.0),
    }
}

/// Whether a bit of a recorded image of inputs or outputs is on.
pub fn is_on(image: f64, number: u8) -> bool {
    image as u32 & 1 << number != 0
}

/// The numbers of the bits that are on, for people.
pub fn bits_words(image: f64) -> String {
    let on: Vec<String> = (0..32)
        .filter(|&number| is_on(image, number))
        .map(|number| number.to_string())
        .collect();
    if on.is_empty() {
        "none".to_owned()
    } else {
        on.join(" ")
    }
}

/// The state of the drive.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Drive {
    Off,
    Stopped,
    /// In the drive's own words.
    Fault(String),
    Enabled,
    NotAllowed,
    Disabled,
}

impl Drive {
    /// For people.
    pub fn words(&self) -> String {
        match self {
            Drive::Off => "off".to_owned(),
            Drive::Stopped => "emergency stop".to_owned(),
            Drive::Fault(words) => format!("fault {words}"),
            Drive::Enabled => "enabled".to_owned(),
            Drive::NotAllowed => "disabled, ENABLE is off".to_owned(),
            Drive::Disabled => "disabled".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use motionbench_core::catalog::KINDS;
    use motionbench_core::controller::Range;

    use super::*;

    fn wiring() -> Wiring {
        Wiring::new(&KINDS[0])
    }

    #[test]
    fn a_simulator_that_starts_again_finds_the_switches_as_they_are() {
        let mut wiring = wiring();
        let enable = KINDS[0].enable_input.unwrap();
        assert!(wiring.differences().is_empty());
        for input in [3, enable, 4, 4] {
            let message = wiring.switch(input).unwrap();
            wiring.hear(&message);
        }
        wiring.hear(&ToWorker::EmergencyStop(true));
        assert!(wiring.is_on(3) && !wiring.is_on(4) && !wiring.is_on(enable));
        assert!(wiring.is_stopped());
        let wire = |name: &str, value| ToWorker::Wire {
            name: name.to_owned(),
            value,
        };
        let expected = [
            wire("in3", 1.0),
            wire("in12", 0.0),
            ToWorker::EmergencyStop(true),
        ];
        assert_eq!(wiring.differences(), expected);
    }

    #[test]
    fn each_unit_has_inputs_of_its_own() {
        let mut wiring = wiring();
        wiring.set_units(3);
        let hear = |wiring: &mut Wiring, message: ToWorker| wiring.hear(&message);
        let press = |wiring: &mut Wiring| {
            let message = wiring.switch(3).unwrap();
            wiring.hear(&message);
        };
        press(&mut wiring);
        hear(&mut wiring, ToWorker::Select(2));
        assert!(!wiring.is_on(3));
        press(&mut wiring);
        hear(&mut wiring, ToWorker::Select(1));
        let on = || ToWorker::Wire {
            name: "in3".to_owned(),
            value: 1.0,
        };
        let expected = [on(), ToWorker::Select(2), on(), ToWorker::Select(1)];
        assert_eq!(wiring.differences(), expected);
        hear(&mut wiring, ToWorker::Select(3));
        assert!(!wiring.is_on(3), "there is no fourth");
        wiring.set_units(1);
        assert_eq!(wiring.differences(), [on()]);
    }

    #[test]
    fn a_pin_is_switched_and_turned() {
        const PIN: [Wired; 1] = [Wired {
            label: "A",
            name: "Pin A",
            wire: "UAA",
            handle: Handle::Pin(Range {
                from: 0.0,
                to: 5.0,
                step: 0.1,
                unit: "V",
            }),
            at: 5.0,
        }];
        let mut wiring = Wiring {
            inputs: &PIN,
            unit: 0,
            values: vec![vec![5.0]],
            estop: false,
        };
        assert!(wiring.is_on(0));
        wiring.hear(&wiring.clone().switch(0).unwrap());
        assert!(!wiring.is_on(0));
        wiring.hear(&wiring.clone().turn(0, 9.0).unwrap());
        assert_eq!(wiring.value(0), 5.0);
        wiring.hear(&wiring.clone().turn(0, 1.5).unwrap());
        assert!(!wiring.is_on(0));
        assert_eq!(wiring.differences().len(), 1);
    }

    #[test]
    fn a_wire_that_is_no_input_changes_no_switch() {
        let mut wired = wiring();
        wired.hear(&ToWorker::Wire {
            name: "in31".to_owned(),
            value: 1.0,
        });
        assert_eq!(wired, wiring());
    }

    #[test]
    fn bits_are_said_by_their_numbers() {
        assert_eq!(bits_words(4105.0), "0 3 12");
        assert_eq!(bits_words(0.0), "none");
        assert!(is_on(4096.0, 12) && !is_on(f64::NAN, 0));
    }
}
