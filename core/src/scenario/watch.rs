//! Signals and variables by name, and what is folded of them at every sample.

use crate::controller::{Controller, ControllerInfo, Debug, DebugReply, Value};
use crate::time::Nanos;

use super::Watch;
use super::condition::show_value;
use super::text::show_time;

/// Where a value comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Source {
    /// A column of the recorded row.
    Column(usize),
    /// A variable of the controller.
    Variable(String),
}

impl Source {
    /// A recorded signal by its name, else a variable. An axis may be given by its number: `0.position`.
    pub(super) fn new(info: &ControllerInfo, name: &str) -> Source {
        let numbered = name.split_once('.').and_then(|(axis, rest)| {
            let axis = info.axes.get(axis.parse::<usize>().ok()?)?;
            Some(format!("{axis}.{rest}"))
        });
        let full = numbered.as_deref().unwrap_or(name);
        match info.signals.iter().position(|signal| signal.name == full) {
            Some(column) => Source::Column(column),
            None => Source::Variable(name.to_owned()),
        }
    }

    /// The value now, where `row` holds the recorded signals.
    ///
    /// # Errors
    /// The controller's own line about a name that it does not know.
    pub(super) fn read(&self, station: &mut dyn Controller, row: &[f64]) -> Result<Value, String> {
        match self {
            Source::Column(column) => {
                let value = row.get(*column).copied().unwrap_or(f64::NAN);
                Ok(Value::Number(value))
            }
            Source::Variable(name) => match station.debug(Debug::Read(name.clone())) {
                DebugReply::Value(value) => Ok(value),
                DebugReply::Refused(message) => Err(message),
                DebugReply::Done | DebugReply::Cam(_) => Err(format!("{name} has no value")),
            },
        }
    }
}

/// What has been seen of a watched condition since its station was switched on.
#[derive(Debug, Clone, Default)]
pub(super) struct Fold {
    /// Samples at which there was a value.
    seen: u64,
    /// Whether the condition held at some sample.
    held: bool,
    /// When it first did not, counted from `power on`, and what was there.
    broken: Option<(Nanos, Value)>,
    least: f64,
    most: f64,
}

impl Fold {
    /// Takes in the value of one sample, `at` after `power on`.
    pub(super) fn add(&mut self, watch: &Watch, at: Nanos, value: Value) {
        let number = match value {
            Value::Number(number) => number,
            Value::Text(_) => f64::NAN,
        };
        if self.seen == 0 {
            (self.least, self.most) = (number, number);
        }
        self.seen += 1;
        self.least = self.least.min(number);
        self.most = self.most.max(number);
        if watch.condition.holds(&value) {
            self.held = true;
        } else if self.broken.is_none() {
            self.broken = Some((at, value));
        }
    }

    /// Whether it came out as the watch asks.
    pub(super) fn verdict(&self, watch: &Watch) -> Result<(), String> {
        let condition = &watch.condition;
        if self.seen == 0 {
            return Err(format!("there was no value of {} yet", condition.signal));
        }
        match &self.broken {
            Some((at, value)) if !watch.ever => Err(format!(
                "expected always {condition}, at {} it was {}",
                show_time(*at),
                show_value(value)
            )),
            _ if watch.ever && !self.held => Err(match self.least <= self.most {
                true => format!(
                    "expected ever {condition}, it was {} to {}",
                    self.least, self.most
                ),
                false => format!("expected ever {condition}, it never was"),
            }),
            _ => Ok(()),
        }
    }
}
