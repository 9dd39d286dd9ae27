//! Currents and temperature.

/// Motor current at the peak torque, in A.
pub const PEAK_CURRENT: f64 = 10.0;
/// The supply without load, in V, and what it gives in for each A.
const SUPPLY: f64 = 48.0;
const SUPPLY_RESISTANCE: f64 = 0.1;
/// Part of the peak torque from which on the current counts as too much, and for how many samples it may be (4 ms).
const OVERCURRENT: f64 = 0.95;
const OVERCURRENT_SAMPLES: u32 = 16;
/// Of the room, in °C; how far the peak torque would heat the motor above it if it lasted; and how fast, in seconds.
const ROOM: f64 = 25.0;
const PEAK_RISE: f64 = 400.0;
const THERMAL_TIME: f64 = 60.0;
/// Samples between two looks at the temperature: 63 ms.
const HEAT_SAMPLES: u32 = 256;
/// How far below TH a motor that was too hot must cool.
const HYSTERESIS: f64 = 5.0;

/// The power stage and the heat that it makes.
#[derive(Debug, Clone, PartialEq)]
pub struct Amplifier {
    /// In °C.
    temperature: f64,
    /// Of the squared torque since the last look, and how many samples that is.
    heat: f64,
    samples: u32,
    /// Samples in a row with too much current.
    overloaded: u32,
    /// The motor is too hot.
    hot: bool,
}

impl Amplifier {
    /// At the room's temperature.
    pub fn new() -> Amplifier {
        Amplifier {
            temperature: ROOM,
            heat: 0.0,
            samples: 0,
            overloaded: 0,
            hot: false,
        }
    }

    /// One sample of `period` seconds with the motor giving `torque`, a fraction of its peak.
    #[inline]
    pub fn sample(&mut self, torque: f64, period: f64) {
        self.heat += torque * torque;
        self.samples += 1;
        self.overloaded = if torque.abs() > OVERCURRENT {
            self.overloaded.saturating_add(1)
        } else {
            0
        };
        if self.samples >= HEAT_SAMPLES {
            let step = period / THERMAL_TIME;
            let cooling = (self.temperature - ROOM) * f64::from(self.samples);
            self.temperature += (self.heat * PEAK_RISE - cooling) * step;
            (self.heat, self.samples) = (0.0, 0);
        }
    }

    /// Whether the motor is too hot for a limit of `trip` °C; once it is, until it has cooled some degrees below.
    #[inline]
    pub fn is_hot(&mut self, trip: i32) -> bool {
        let limit = f64::from(trip) - if self.hot { HYSTERESIS } else { 0.0 };
        self.hot = self.temperature > limit;
        self.hot
    }

    /// Whether the current has been too much for some time.
    pub fn is_overloaded(&self) -> bool {
        self.overloaded >= OVERCURRENT_SAMPLES
    }

    /// In whole °C.
    #[allow(clippy::cast_possible_truncation)] // a temperature
    pub fn degrees(&self) -> i32 {
        self.temperature as i32
    }
}

/// Motor current in A at `torque`, a fraction of the peak.
pub fn current(torque: f64) -> f64 {
    torque.abs() * PEAK_CURRENT
}

/// `UIA`, in 0.01 A.
pub fn current_reading(torque: f64) -> i32 {
    whole(current(torque) * 100.0)
}

/// `UJA`, in 0.1 V.
pub fn supply_reading(torque: f64) -> i32 {
    whole((SUPPLY - current(torque) * SUPPLY_RESISTANCE) * 10.0)
}

#[allow(clippy::cast_possible_truncation)] // `as` saturates
fn whole(value: f64) -> i32 {
    (value + 0.5).floor() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 245.76e-6;

    fn run(amplifier: &mut Amplifier, torque: f64, seconds: f64) {
        (0..(seconds / PERIOD) as u32).for_each(|_| amplifier.sample(torque, PERIOD));
    }

    #[test]
    fn a_third_of_the_peak_can_last_and_more_trips() {
        let mut amplifier = Amplifier::new();
        run(&mut amplifier, 0.33, 600.0);
        assert!(
            (65..70).contains(&amplifier.degrees()),
            "{}",
            amplifier.degrees()
        );
        assert!(!amplifier.is_hot(70));
        run(&mut amplifier, 1.0, 2.0);
        assert!(amplifier.is_hot(70));
        run(&mut amplifier, 0.0, 8.0);
        assert!(amplifier.is_hot(70), "{}", amplifier.degrees());
        run(&mut amplifier, 0.0, 20.0);
        assert!(!amplifier.is_hot(70), "{}", amplifier.degrees());
    }

    #[test]
    fn only_a_lasting_current_is_too_much() {
        let mut amplifier = Amplifier::new();
        run(&mut amplifier, 1.0, 0.003);
        assert!(!amplifier.is_overloaded());
        run(&mut amplifier, 1.0, 0.002);
        assert!(amplifier.is_overloaded());
        run(&mut amplifier, 0.5, 0.001);
        assert!(!amplifier.is_overloaded());
    }
}
