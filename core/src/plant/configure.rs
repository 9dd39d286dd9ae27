//! The plant as a scenario describes it: `inertia=2 friction=0.1 home=1200 travel=-5000..5000`.

use super::axis::{PlantAxis, Span};

/// The keys of [`PlantAxis::configure`] and what their values mean.
///
/// A position is a number of the controller's counts as it counts at power-up, or of revolutions (`2.5rev`), from
/// where the axis stood when it was built. A range is two positions with `..` between; either may be left out, and
/// `none` is no such thing.
pub const KEYS: [(&str, &str); 10] = [
    (
        "inertia",
        "of the load, as a multiple of the motor's; 0 to 1000",
    ),
    (
        "friction",
        "torque that it takes to turn at all, as a fraction of the motor's peak; 0 to 1",
    ),
    (
        "viscous",
        "torque for each 1000 rpm, as a fraction of the motor's peak; 0 to 1",
    ),
    (
        "torque",
        "largest torque the drive gives, as a fraction of the motor's peak; 0 to 1",
    ),
    (
        "bandwidth",
        "of the drive's current loop in Hz; 1 to 100000",
    ),
    (
        "maxspeed",
        "that the drive's voltage allows, in rpm; 1 to 1000000",
    ),
    (
        "travel",
        "range between the hard stops; an axis outside is put to the nearer one",
    ),
    ("limits", "range outside which a limit switch is pressed"),
    (
        "home",
        "where the home switch is pressed: a range, or the position from which on it is",
    ),
    (
        "pull",
        "torque that always acts on the load, backwards where it is above zero, as a fraction of the motor's peak; -1 to 1",
    ),
];

impl PlantAxis {
    /// Sets one thing about the mechanics, by the [`KEYS`].
    ///
    /// # Errors
    /// One line that names the known keys, or says what the value should be; nothing has changed then.
    pub fn configure(&mut self, key: &str, value: &str) -> Result<(), String> {
        let mut parameters = *self.parameters();
        let p = &mut parameters;
        match key {
            "inertia" => p.load_inertia = number(key, value, 0.0, 1000.0)?,
            "friction" => p.coulomb_friction = number(key, value, 0.0, 1.0)?,
            "viscous" => p.viscous_friction = number(key, value, 0.0, 1.0)?,
            "torque" => p.torque_limit = number(key, value, 0.0, 1.0)?,
            "bandwidth" => p.bandwidth = number(key, value, 1.0, 100_000.0)?,
            "maxspeed" => p.max_speed = number(key, value, 1.0, 1_000_000.0)? / 60.0,
            "travel" => p.travel = self.range(key, value, Span::ENDLESS)?,
            "limits" => p.limits = self.range(key, value, Span::ENDLESS)?,
            "pull" => p.pull = number(key, value, -1.0, 1.0)?,
            "home" => p.home = self.home(key, value)?,
            _ => {
                let known = KEYS.map(|(key, _)| key).join(", ");
                return Err(format!("an axis has no `{key}`; it has {known}"));
            }
        }
        self.set_parameters(parameters);
        Ok(())
    }

    fn home(&self, key: &str, value: &str) -> Result<Span, String> {
        match self.position_of(value) {
            Some(from) => Ok(Span {
                from,
                to: f64::INFINITY,
            }),
            None => self.range(key, value, Span::NOWHERE),
        }
    }

    fn range(&self, key: &str, value: &str, none: Span) -> Result<Span, String> {
        if value == "none" {
            return Ok(none);
        }
        let end = |text: &str, open: f64| {
            if text.is_empty() {
                Some(open)
            } else {
                self.position_of(text)
            }
        };
        value
            .split_once("..")
            .and_then(|(from, to)| {
                Some(Span {
                    from: end(from, f64::NEG_INFINITY)?,
                    to: end(to, f64::INFINITY)?,
                })
            })
            .filter(|span| span.from < span.to)
            .ok_or_else(|| {
                format!(
                    "{key}={value}: expected a range such as -5000..5000 or -2rev..2rev, or none"
                )
            })
    }

    /// In revolutions.
    fn position_of(&self, text: &str) -> Option<f64> {
        let (number, counts) = match text.strip_suffix("rev") {
            Some(number) => (number, 1.0),
            None => (text, self.counts_per_revolution),
        };
        number
            .parse::<f64>()
            .ok()
            .filter(|n| n.is_finite())
            .map(|n| n / counts)
    }
}

fn number(key: &str, value: &str, least: f64, most: f64) -> Result<f64, String> {
    match value.parse::<f64>() {
        Ok(number) if number >= least && number <= most => Ok(number),
        _ => Err(format!(
            "{key}={value}: expected a number from {least} to {most}"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::AxisParameters;
    use crate::plant::presets::SERVO;

    fn axis() -> PlantAxis {
        PlantAxis::new(SERVO, 250e-6, 1 << 20, 4096)
    }

    #[test]
    fn the_example_of_the_scenario_language() {
        let mut axis = axis();
        for (key, value) in [
            ("inertia", "2"),
            ("friction", "0.1"),
            ("home", "1200"),
            ("travel", "-5000..5000"),
        ] {
            axis.configure(key, value).unwrap();
        }
        let expected = AxisParameters {
            load_inertia: 2.0,
            coulomb_friction: 0.1,
            home: Span {
                from: 1200.0 / 4096.0,
                to: f64::INFINITY,
            },
            travel: Span {
                from: -5000.0 / 4096.0,
                to: 5000.0 / 4096.0,
            },
            ..SERVO
        };
        assert_eq!(*axis.parameters(), expected);
    }

    #[test]
    fn positions_in_revolutions_and_open_ends() {
        let mut axis = axis();
        axis.configure("limits", "-1.5rev..").unwrap();
        axis.configure("home", "0rev..0.25rev").unwrap();
        assert_eq!(
            axis.parameters().limits,
            Span {
                from: -1.5,
                to: f64::INFINITY
            }
        );
        assert!(axis.at_home());
        axis.configure("home", "none").unwrap();
        assert!(!axis.at_home());
    }

    #[test]
    fn every_key_is_known_and_bad_input_is_one_line() {
        let mut axis = axis();
        let before = axis.clone();
        for (key, _) in KEYS {
            for value in ["", "x", "NaN", "5..-5", "1..x", "inf"] {
                let error = axis.configure(key, value).unwrap_err();
                assert!(
                    error.contains(key) && !error.contains('\n') && !error.contains("has no"),
                    "{error}"
                );
            }
        }
        assert_eq!(
            axis.configure("colour", "red").unwrap_err(),
            "an axis has no `colour`; it has inertia, friction, viscous, torque, bandwidth, maxspeed, travel, limits, home, pull"
        );
        assert_eq!(axis, before);
    }
}
