//! Keys of a front panel as they are pressed, written down as a scenario that presses them again.

use std::fmt::Write as _;

use motionbench_core::catalog::Kind;
use motionbench_core::time::Nanos;

use crate::protocol::ToWorker;

/// Keys that act for as long as they are held.
const HELD: [&str; 4] = ["UP", "DOWN", "LEFT", "RIGHT"];
/// Presses that are kept.
const MOST: usize = 10_000;

/// What was pressed since when.
#[derive(Debug, Clone, Default)]
pub struct Recording {
    started: Nanos,
    /// The unit that the panel was switched to then.
    unit: usize,
    presses: Vec<Press>,
}

#[derive(Debug, Clone)]
struct Press {
    at: Nanos,
    what: What,
}

#[derive(Debug, Clone)]
enum What {
    /// When it went up; until then it is down.
    Key { key: String, up: Option<Nanos> },
    /// The selector was turned to this unit.
    Select(usize),
}

impl Recording {
    /// From now on; the panel is switched to this unit.
    pub fn new(now: Nanos, unit: usize) -> Recording {
        Recording {
            started: now,
            unit,
            presses: Vec::new(),
        }
    }

    /// A key goes down or up, or the selector is turned; other messages are passed over.
    pub fn hear(&mut self, now: Nanos, message: &ToWorker) {
        let what = match message {
            ToWorker::Key { key, down: true } => What::Key {
                key: key.clone(),
                up: None,
            },
            ToWorker::Key { key, down: false } => return self.release(now, key),
            ToWorker::Select(unit) => What::Select(*unit),
            _ => return,
        };
        if self.presses.len() < MOST {
            self.presses.push(Press { at: now, what });
        }
    }

    fn release(&mut self, now: Nanos, released: &str) {
        for press in self.presses.iter_mut().rev() {
            if let What::Key { key, up } = &mut press.what
                && key == released
            {
                up.get_or_insert(now);
                return;
            }
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

    /// The scenario, of controllers of this kind, each with its options, that have just been switched on; `now` ends it.
    pub fn scenario(&self, kind: &Kind, units: &[Vec<(String, String)>], now: Nanos) -> String {
        let (id, selector) = (kind.id, kind.face.map_or("", |face| face.selector));
        let mut text = String::new();
        for (unit, options) in units.iter().enumerate() {
            let name = match units.len() {
                1 => String::new(),
                _ => format!(" as unit{}", unit + 1),
            };
            let options = options.iter().map(|(key, value)| format!(" {key}={value}"));
            // Writing to a text cannot fail.
            let _ = writeln!(text, "bench {id}{name}{}", options.collect::<String>());
        }
        // What is pressed at the panel of one is pressed at that of all.
        let to = |unit: usize| match units.len() {
            1 => String::new(),
            _ => format!("unit{}: ", unit + 1),
        };
        let select = |text: &mut String, unit: usize| {
            let _ = writeln!(text, "{}wire {selector} {}", to(0), unit + 1);
        };
        for unit in 0..units.len() {
            let _ = writeln!(text, "{}power on", to(unit));
        }
        if self.unit > 0 {
            select(&mut text, self.unit);
        }
        text.push_str("run until idle\n");
        let mut reached = self.started;
        for Press { at, what } in &self.presses {
            wait(&mut text, &mut reached, *at);
            match what {
                What::Select(unit) => select(&mut text, *unit),
                What::Key { key, up } if HELD.contains(&key.as_str()) => {
                    let held = seconds(up.unwrap_or(now).since(*at));
                    let _ = writeln!(text, "{}hold {key} {held}s", to(0));
                }
                What::Key { key, .. } => {
                    let _ = writeln!(text, "{}press {key}", to(0));
                }
            }
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
    use motionbench_core::catalog::{kind, units};
    use motionbench_core::scenario::Scenario;

    use super::*;

    fn unidex3() -> &'static Kind {
        kind("unidex3").unwrap()
    }

    fn at(millis: u64) -> Nanos {
        Nanos::from_millis(5000 + millis)
    }

    fn option(key: &str, value: &str) -> (String, String) {
        (key.to_owned(), value.to_owned())
    }

    fn recorded(unit: usize, strokes: &[(u64, &str, bool)]) -> Recording {
        let mut recording = Recording::new(at(0), unit);
        for &(millis, key, down) in strokes {
            let key = key.to_owned();
            recording.hear(at(millis), &ToWorker::Key { key, down });
        }
        recording
    }

    #[test]
    fn what_was_pressed_is_a_scenario_that_presses_it() {
        let recording = recorded(
            0,
            &[
                (100, "SLW", true),
                (180, "SLW", false),
                (1100, "UP", true),
                (1200, "RIGHT", true),
                (1600, "UP", false),
                (2600, "RIGHT", false),
            ],
        );
        let text = recording.scenario(unidex3(), &[vec![option("address", "2")]], at(3000));
        let expected = "bench unidex3 address=2\npower on\nrun until idle\nrun 0.1s\npress SLW\nrun 1s\nhold UP 0.5s\n\
                        run 0.1s\nhold RIGHT 1.4s\nrun 1.8s\n";
        assert_eq!(text, expected);
        assert!(Scenario::parse(&text).is_ok());
    }

    #[test]
    fn the_selector_is_written_down_too() {
        let mut recording = recorded(1, &[(100, "SLW", true)]);
        recording.hear(at(200), &ToWorker::Select(0));
        let units = units("unidex3", &[option("units", "2")]).unwrap();
        let text = recording.scenario(unidex3(), &units, at(200));
        let expected = "bench unidex3 as unit1 keyboard=1 address=1 last=no\n\
                        bench unidex3 as unit2 keyboard=2 address=2\nunit1: power on\nunit2: power on\n\
                        unit1: wire PAIR 2\nrun until idle\nrun 0.1s\nunit1: press SLW\nrun 0.1s\nunit1: wire PAIR 1\n";
        assert_eq!(text, expected);
        assert!(Scenario::parse(&text).is_ok());
    }
}
