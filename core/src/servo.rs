//! The position regulator: PID with velocity and acceleration feed-forward and a limited output.

/// What a [`Servo`] is tuned to. The error is in any unit of length `u`, the output in any unit of drive `o`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gains {
    /// o per u.
    pub proportional: f64,
    /// o per u and second.
    pub integral: f64,
    /// Errors up to this, in u, leave the integral as it is, so that an axis at rest does not hunt against friction.
    pub integral_deadband: f64,
    /// o per u/s.
    pub derivative: f64,
    /// o per u/s of the demand.
    pub velocity_feedforward: f64,
    /// o per u/s² of the demand.
    pub acceleration_feedforward: f64,
    /// Largest magnitude of the output, in o.
    pub output_limit: f64,
}

/// A regulator and its memory. The derivative acts on the error, so it needs no velocity of the encoder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    gains: Gains,
    /// Gains for one sample.
    integral_step: f64,
    derivative_step: f64,
    integral: f64,
    last_error: f64,
}

impl Servo {
    /// A regulator that is updated every `period` seconds.
    pub fn new(gains: Gains, period: f64) -> Servo {
        Servo {
            gains,
            integral_step: gains.integral * period,
            derivative_step: gains.derivative / period,
            integral: 0.0,
            last_error: 0.0,
        }
    }

    /// Changes the gains; what it remembers of the past stays.
    pub fn tune(&mut self, gains: Gains, period: f64) {
        self.gains = gains;
        self.integral_step = gains.integral * period;
        self.derivative_step = gains.derivative / period;
    }

    /// Forgets the past: the next update is the first.
    pub fn reset(&mut self) {
        self.integral = 0.0;
        self.last_error = 0.0;
    }

    /// The output for this sample from the position error and the demanded velocity and acceleration.
    ///
    /// While the output is at its limit the integral only unwinds.
    #[inline]
    pub fn update(&mut self, error: f64, velocity: f64, acceleration: f64) -> f64 {
        let counts = error.abs() > self.gains.integral_deadband;
        let integral = if counts {
            self.integral + error * self.integral_step
        } else {
            self.integral
        };
        let output = error * self.gains.proportional
            + integral
            + (error - self.last_error) * self.derivative_step
            + velocity * self.gains.velocity_feedforward
            + acceleration * self.gains.acceleration_feedforward;
        self.last_error = error;
        let limit = self.gains.output_limit;
        if output > limit {
            self.integral = if error > 0.0 { self.integral } else { integral };
            limit
        } else if output < -limit {
            self.integral = if error < 0.0 { self.integral } else { integral };
            -limit
        } else {
            self.integral = integral;
            output
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GAINS: Gains = Gains {
        proportional: 2.0,
        integral: 10.0,
        integral_deadband: 0.25,
        derivative: 0.5,
        velocity_feedforward: 3.0,
        acceleration_feedforward: 4.0,
        output_limit: 100.0,
    };

    #[test]
    fn each_term_has_its_unit() {
        let mut servo = Servo::new(GAINS, 0.1);
        assert_eq!(servo.update(1.0, 0.0, 0.0), 2.0 + 10.0 * 0.1 + 0.5 / 0.1);
        assert_eq!(servo.update(1.0, 0.0, 0.0), 2.0 + 2.0);
        servo.reset();
        assert_eq!(servo.update(0.0, 1.0, 1.0), 7.0);
    }

    #[test]
    fn small_errors_leave_the_integral() {
        let mut servo = Servo::new(GAINS, 0.1);
        servo.update(0.25, 0.0, 0.0);
        assert_eq!(servo.update(0.25, 0.0, 0.0), 2.0 * 0.25);
    }

    #[test]
    fn the_integral_does_not_wind_up() {
        let mut servo = Servo::new(GAINS, 0.1);
        (0..1000).for_each(|_| assert!(servo.update(60.0, 0.0, 0.0) <= 100.0));
        assert!(
            servo.update(-1.0, 0.0, 0.0) < 0.0,
            "the output follows the error back at once"
        );
    }
}
