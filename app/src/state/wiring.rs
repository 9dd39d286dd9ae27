//! What is wired to the controller: switches at its inputs, lamps at its outputs, the emergency stop of the machine.

use crate::protocol::ToWorker;

/// Inputs of the controller, by number; the last is the drive's ENABLE.
pub const INPUTS: u8 = 13;
/// The input that lets the drive be enabled.
pub const ENABLE: u8 = 12;
/// Outputs of the controller.
pub const OUTPUTS: u8 = 10;

/// How the switches stand. They are outside the controller: the mains switch and a simulator that starts again leave
/// them as they are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wiring {
    inputs: u32,
    estop: bool,
}

impl Default for Wiring {
    fn default() -> Wiring {
        Wiring {
            inputs: 1 << ENABLE,
            estop: false,
        }
    }
}

impl Wiring {
    /// Whether the switch of an input is on.
    pub fn is_on(&self, input: u8) -> bool {
        bit(self.inputs, input)
    }

    /// Whether the emergency stop is pressed.
    pub fn is_stopped(&self) -> bool {
        self.estop
    }

    /// Takes in what is sent to the worker.
    pub fn hear(&mut self, message: &ToWorker) {
        match message {
            ToWorker::EmergencyStop(pressed) => self.estop = *pressed,
            ToWorker::Wire { name, value } => {
                if let Some(input) = (0..INPUTS).find(|input| *name == wire(*input)) {
                    let on = u32::from(*value != 0.0);
                    self.inputs = self.inputs & !(1 << input) | on << input;
                }
            }
            _ => {}
        }
    }

    /// What a simulator that has just started must be told.
    pub fn differences(&self) -> Vec<ToWorker> {
        let fresh = Wiring::default();
        let mut messages: Vec<ToWorker> = (0..INPUTS)
            .filter(|&input| self.is_on(input) != fresh.is_on(input))
            .map(|input| switch(input, self.is_on(input)))
            .collect();
        if self.estop {
            messages.push(ToWorker::EmergencyStop(true));
        }
        messages
    }
}

/// The message that puts the switch of an input on or off.
pub fn switch(input: u8, on: bool) -> ToWorker {
    ToWorker::Wire {
        name: wire(input),
        value: f64::from(u8::from(on)),
    }
}

fn wire(input: u8) -> String {
    format!("in{input}")
}

/// Whether a bit of a recorded image of inputs or outputs is on.
pub fn is_on(image: f64, number: u8) -> bool {
    bit(image as u32, number)
}

fn bit(image: u32, number: u8) -> bool {
    image & 1 << number != 0
}

/// What an input is called.
pub fn input_name(input: u8) -> String {
    match input {
        ENABLE => "ENABLE".to_owned(),
        _ => input.to_string(),
    }
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
    use super::*;

    #[test]
    fn a_simulator_that_starts_again_finds_the_switches_as_they_are() {
        let mut wiring = Wiring::default();
        assert!(wiring.differences().is_empty());
        for message in [
            switch(3, true),
            switch(ENABLE, false),
            switch(4, true),
            switch(4, false),
            ToWorker::EmergencyStop(true),
        ] {
            wiring.hear(&message);
        }
        assert!(wiring.is_on(3) && !wiring.is_on(4) && !wiring.is_on(ENABLE));
        assert!(wiring.is_stopped());
        let expected = [
            switch(3, true),
            switch(ENABLE, false),
            ToWorker::EmergencyStop(true),
        ];
        assert_eq!(wiring.differences(), expected);
    }

    #[test]
    fn a_wire_that_is_no_input_changes_no_switch() {
        let mut wiring = Wiring::default();
        wiring.hear(&ToWorker::Wire {
            name: "in31".to_owned(),
            value: 1.0,
        });
        assert_eq!(wiring, Wiring::default());
    }

    #[test]
    fn bits_are_said_by_their_numbers() {
        assert_eq!(bits_words(4105.0), "0 3 12");
        assert_eq!(bits_words(0.0), "none");
        assert!(is_on(4096.0, 12) && !is_on(f64::NAN, 0));
    }
}
