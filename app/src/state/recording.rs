//! Keys of a front panel as they are pressed, written down as a scenario that presses them again.

use std::fmt::Write as _;

use motionbench_core::time::Nanos;

/// Keys that act for as long as they are held.
const HELD: [&str; 4] = ["UP", "DOWN", "LEFT", "RIGHT"];
/// Presses that are kept.
const MOST: usize = 10_000;

/// What was pressed since when.
#[derive(Debug, Clone, Default)]
pub struct Recording {
    started: Nanos,
    presses: Vec<Press>,
}

#[derive(Debug, Clone)]
struct Press {
    at: Nanos,
    key: String,
    /// When it went up; until then it is down.
    up: Option<Nanos>,
}

impl Recording {
    /// From now on.
    pub fn new(now: Nanos) -> Recording {
        Recording {
            started: now,
            presses: Vec::new(),
        }
    }

    /// A key goes down or up.
    pub fn hear(&mut self, now: Nanos, key: &str, down: bool) {
        if !down {
            let held = self.presses.iter_mut().rev().find(|press| press.key == key);
            if let Some(press) = held {
                press.up.get_or_insert(now);
            }
        } else if self.presses.len() < MOST {
            self.presses.push(Press {
                at: now,
                key: key.to_owned(),
                up: None,
            });
        }
    }

    /// How many presses there are.
    pub fn len(&self) -> usize {
        self.presses.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.presses.is_empty()
    }

    /// The scenario, of a controller of this kind with these options that has just been switched on; `now` ends it.
    pub fn scenario(&self, kind: &str, options: &[String], now: Nanos) -> String {
        let mut text = format!("bench {kind}");
        for option in options {
            // Writing to a text cannot fail.
            let _ = write!(text, " {option}");
        }
        text.push_str("\npower on\nrun until idle\n");
        let mut reached = self.started;
        for press in &self.presses {
            wait(&mut text, &mut reached, press.at);
            let held = press.up.unwrap_or(now).since(press.at);
            let key = &press.key;
            let _ = match HELD.contains(&key.as_str()) {
                true => writeln!(text, "hold {key} {}s", seconds(held)),
                false => writeln!(text, "press {key}"),
            };
        }
        wait(&mut text, &mut reached, now);
        text
    }
}

/// Lets time pass until `to`.
fn wait(text: &mut String, reached: &mut Nanos, to: Nanos) {
    let waited = to.since(*reached);
    if waited > Nanos::ZERO {
        let _ = writeln!(text, "run {}s", seconds(waited));
        *reached = to;
    }
}

fn seconds(time: Nanos) -> String {
    let text = format!("{:.3}", time.seconds().max(0.001));
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_pressed_is_a_scenario_that_presses_it() {
        let at = |millis: u64| Nanos::from_millis(5000 + millis);
        let mut recording = Recording::new(at(0));
        recording.hear(at(100), "SLW", true);
        recording.hear(at(180), "SLW", false);
        recording.hear(at(1100), "UP", true);
        recording.hear(at(1200), "RIGHT", true);
        recording.hear(at(1600), "UP", false);
        recording.hear(at(2600), "RIGHT", false);
        let text = recording.scenario("unidex3", &["address=2".to_owned()], at(3000));
        let expected = "bench unidex3 address=2\npower on\nrun until idle\nrun 0.1s\npress SLW\nrun 1s\nhold UP 0.5s\n\
                        run 0.1s\nhold RIGHT 1.4s\nrun 1.8s\n";
        assert_eq!(text, expected);
        assert!(motionbench_core::scenario::Scenario::parse(&text).is_ok());
    }
}
