//! The PID filter with its feed-forwards, in integers.
//!
//! With the error e in counts, its change over KS samples de, the demanded velocity v (counts/sample) and acceleration a
//! (counts/sample²), the output in 1/1023 of the peak torque is
//! `KP e / 4 + KI (sum of e) / 256 + KD de / 4 + KV v / 256 + KA a + KG`, where KL limits the part of KI. With PID2, PID4
//! and PID8 sums and differences are scaled to the time of PID1, so that a tuning keeps its meaning (D173).

use super::register::Register;

/// Largest magnitude of the output.
pub const FULL: i32 = 1023;

/// Bits behind the point of an error as the filter takes it: 1/256 count.
pub const ERROR_FRACTION: u32 = 8;
/// Errors beyond 2^20 counts count as that, which keeps 64 bits exact.
const LARGEST_ERROR: i64 = 1 << (20 + ERROR_FRACTION);
/// Demands beyond 2^24 counts/sample, which no motor follows, count as that.
const LARGEST_DEMAND: i64 = 1 << 40;
/// The terms are added up in units of 2^-18 of the output's.
const FRACTION: u32 = 18;
/// Of the integral.
const INTEGRAL_FRACTION: u32 = ERROR_FRACTION + 8;

/// What the filter is tuned to; the names of the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Gains {
    /// 0 to 32767.
    pub kp: i32,
    /// 0 to 32767.
    pub ki: i32,
    /// 0 to 32767.
    pub kd: i32,
    /// Most that KI may give, in units of the output; 0 to 32767.
    pub kl: i32,
    /// Servo samples over which KD takes its difference, 1 to 255.
    pub ks: i32,
    /// 0 to 32767.
    pub kv: i32,
    /// 0 to 32767.
    pub ka: i32,
    /// In units of the output, -1023 to 1023.
    pub kg: i32,
}

impl Gains {
    /// At power-up ("Default tuning").
    pub const DEFAULT: Gains = Gains {
        kp: 42,
        ki: 28,
        kd: 550,
        kl: 80,
        ks: 1,
        kv: 0,
        ka: 0,
        kg: 0,
    };

    /// The gain of a register.
    pub fn get(&self, register: Register) -> Option<i32> {
        Some(match register {
            Register::Proportional => self.kp,
            Register::Integral => self.ki,
            Register::Derivative => self.kd,
            Register::IntegralLimit => self.kl,
            Register::DerivativeSamples => self.ks,
            Register::VelocityFeedForward => self.kv,
            Register::AccelerationFeedForward => self.ka,
            Register::Gravity => self.kg,
            _ => return None,
        })
    }

    /// Sets the gain of a register, limited to its range; whether the register is a gain.
    pub fn set(&mut self, register: Register, value: i32) -> bool {
        let positive = value.clamp(0, 32_767);
        match register {
            Register::Proportional => self.kp = positive,
            Register::Integral => self.ki = positive,
            Register::Derivative => self.kd = positive,
            Register::IntegralLimit => self.kl = positive,
            Register::DerivativeSamples => self.ks = value.clamp(1, 255),
            Register::VelocityFeedForward => self.kv = positive,
            Register::AccelerationFeedForward => self.ka = positive,
            Register::Gravity => self.kg = value.clamp(-FULL, FULL),
            _ => return false,
        }
        true
    }
}

/// What the filter follows in a servo sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Demand {
    /// Demanded minus actual position in 1/256 count.
    pub error: i64,
    /// Demanded, counts/sample x 65536.
    pub velocity: i64,
    /// Demanded, counts/sample² x 65536.
    pub acceleration: i64,
}

/// The filter and its memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Filter {
    /// What a program has set and F has yet to load.
    pub buffered: Gains,
    /// KGON.
    pub gravity: bool,
    gains: Gains,
    /// Of the errors.
    sum: i64,
    /// The error when the difference was last taken, and the difference.
    last_error: i64,
    difference: i64,
    /// Servo samples until the next.
    wait: i32,
}

impl Filter {
    /// As at power-up.
    pub fn new() -> Filter {
        Filter {
            buffered: Gains::DEFAULT,
            gravity: true,
            gains: Gains::DEFAULT,
            sum: 0,
            last_error: 0,
            difference: 0,
            wait: 0,
        }
    }

    /// `F`: the buffered gains act from the next sample on. What the integral gives stays what it was, so that the
    /// shaft does not jump.
    pub fn load(&mut self) {
        let given = i64::from(self.gains.ki) * self.sum;
        self.gains = self.buffered;
        self.sum = given.checked_div(i64::from(self.gains.ki)).unwrap_or(0);
    }

    /// Forgets the past: the next sample is the first, with the motor just switched on.
    pub fn reset(&mut self) {
        self.sum = 0;
        self.last_error = 0;
        self.difference = 0;
        self.wait = 0;
    }

    /// The output for this sample of PID`divisor`, within `limit` (0 to [`FULL`]). While it is at the limit the integral only unwinds.
    #[inline]
    pub fn update(&mut self, demand: &Demand, limit: i32, divisor: u8) -> i32 {
        let Gains { kp, ki, kd, kl, .. } = self.gains;
        let error = demand.error.clamp(-LARGEST_ERROR, LARGEST_ERROR);
        self.wait -= 1;
        if self.wait < 0 {
            self.wait = self.gains.ks - 1;
            self.difference = (error - self.last_error) / i64::from(divisor.max(1));
            self.last_error = error;
        }
        let before = self.sum;
        if ki != 0 {
            self.sum += error * i64::from(divisor);
        }
        let most = i64::from(kl) << INTEGRAL_FRACTION;
        let mut integral = i64::from(ki) * self.sum;
        if integral.abs() > most {
            integral = integral.clamp(-most, most);
            self.sum = integral.checked_div(i64::from(ki)).unwrap_or(0);
        }
        let mut total = ((i64::from(kp) * error + i64::from(kd) * self.difference) << 8)
            + (integral << (FRACTION - INTEGRAL_FRACTION))
            + self.feed_forward(demand);
        if self.gravity {
            total += i64::from(self.gains.kg) << FRACTION;
        }
        let output = (total + (1 << (FRACTION - 1))) >> FRACTION;
        let limit = i64::from(limit);
        if (output > limit && error > 0) || (output < -limit && error < 0) {
            self.sum = before;
        }
        i32::try_from(output.clamp(-limit, limit)).unwrap_or(0)
    }

    /// Whether the integral still works on an error.
    pub fn is_winding(&self) -> bool {
        let Gains { ki, kl, .. } = self.gains;
        let given = i64::from(ki) * self.sum;
        ki != 0 && given.abs() < i64::from(kl) << INTEGRAL_FRACTION
    }

    fn feed_forward(&self, demand: &Demand) -> i64 {
        let Gains { kv, ka, .. } = self.gains;
        // Most of the time there is none.
        if kv | ka == 0 {
            return 0;
        }
        let bounded = |value: i64| value.clamp(-LARGEST_DEMAND, LARGEST_DEMAND);
        ((i64::from(kv) * bounded(demand.velocity)) >> 6)
            + ((i64::from(ka) * bounded(demand.acceleration)) << 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filter(change: impl FnOnce(&mut Gains)) -> Filter {
        let mut filter = Filter::new();
        filter.buffered = Gains {
            kp: 0,
            ki: 0,
            kd: 0,
            kl: 1000,
            ks: 1,
            kv: 0,
            ka: 0,
            kg: 0,
        };
        change(&mut filter.buffered);
        filter.load();
        filter
    }

    fn counts(error: i64) -> Demand {
        Demand {
            error: error << ERROR_FRACTION,
            velocity: 0,
            acceleration: 0,
        }
    }

    #[test]
    fn each_term_has_its_unit() {
        assert_eq!(filter(|g| g.kp = 40).update(&counts(10), FULL, 1), 100);
        assert_eq!(filter(|g| g.kd = 40).update(&counts(10), FULL, 1), 100);
        let mut integral = filter(|g| g.ki = 256);
        integral.update(&counts(10), FULL, 1);
        assert_eq!(integral.update(&counts(10), FULL, 1), 20);
        let moving = Demand {
            error: 0,
            velocity: 3 << 16,
            acceleration: 2 << 16,
        };
        assert_eq!(filter(|g| g.kv = 256).update(&moving, FULL, 1), 3);
        assert_eq!(filter(|g| g.ka = 50).update(&moving, FULL, 1), 100);
        assert_eq!(filter(|g| g.kg = -70).update(&counts(0), FULL, 1), -70);
    }

    #[test]
    fn gains_wait_for_f() {
        let mut filter = filter(|g| g.kp = 40);
        filter.buffered.kp = 80;
        assert_eq!(filter.update(&counts(10), FULL, 1), 100);
        filter.load();
        assert_eq!(filter.update(&counts(10), FULL, 1), 200);
    }

    #[test]
    fn kl_limits_the_integral_and_saturation_does_not_wind_it_up() {
        let mut limited = filter(|g| (g.ki, g.kl) = (100, 25));
        (0..10_000).for_each(|_| assert!(limited.update(&counts(5), FULL, 1) <= 25));
        assert_eq!(limited.update(&counts(5), FULL, 1), 25);
        let mut wound = filter(|g| (g.kp, g.ki) = (400, 100));
        (0..10_000).for_each(|_| assert!(wound.update(&counts(50), 300, 1) <= 300));
        assert!(wound.update(&counts(-5), 300, 1) < 0);
    }

    #[test]
    fn ks_stretches_the_difference() {
        let mut filter = filter(|g| (g.kd, g.ks) = (4, 3));
        let outputs: Vec<i32> = (1..=7)
            .map(|error| filter.update(&counts(error), FULL, 1))
            .collect();
        assert_eq!(outputs, [1, 1, 1, 3, 3, 3, 3]);
    }

    #[test]
    fn nothing_overflows() {
        let mut filter = filter(|g| {
            *g = Gains {
                kp: 32_767,
                ki: 32_767,
                kd: 32_767,
                kl: 32_767,
                ks: 1,
                kv: 32_767,
                ka: 32_767,
                kg: FULL,
            }
        });
        for error in [i64::MAX, i64::MIN, 1, -1, i64::MIN, i64::MAX] {
            let demand = Demand {
                error,
                velocity: i64::MAX,
                acceleration: i64::MIN,
            };
            assert!(filter.update(&demand, FULL, 1).abs() <= FULL);
        }
    }
}
