//! Statements about the station itself: its disks and programs, mains switch, keys and wires, and what is checked of
//! its signals.

use crate::controller::{Input, LoadError, Slot, Value};
use crate::language::latin1;
use crate::time::Nanos;

use super::advance::Goal;
use super::condition::{Condition, show_value};
use super::runner::{Done, Failure, Runner, Scheduled};
use super::statement::Statement;
use super::text::{show, show_time};
use super::watch::{Fold, Source};
use super::{MOST_OUTPUT, program_text};

impl<'a> Runner<'a> {
    pub(super) fn axis(
        &mut self,
        station: usize,
        axis: &str,
        settings: &[(String, String)],
    ) -> Done {
        settings.iter().try_for_each(|(key, value)| {
            let input = Input::Plant {
                axis: axis.to_owned(),
                key: key.clone(),
                value: value.clone(),
            };
            self.input(station, input)
        })
    }

    fn file(&self, file: &str) -> &[u8] {
        // All files were read before the start.
        self.files.get(file).map_or(&[], Vec::as_slice)
    }

    pub(super) fn file_put(&mut self, station: usize, name: &str, file: &str) -> Done {
        let text = latin1::text(self.file(file));
        self.load_text(station, &Slot::File(name.to_owned()), &text)
            .map_err(|error| format!("{name}: {}", error.message).into())
    }

    fn listing(&mut self, station: usize, name: &str) -> Result<Option<String>, Failure> {
        let slot = Slot::File(name.to_owned());
        Ok(self.controller(station)?.listing(&slot))
    }

    pub(super) fn file_get(&mut self, station: usize, name: &str, file: &str) -> Done {
        let text = self.listing(station, name)?;
        let text = text.ok_or_else(|| format!("there is no file {name}"))?;
        self.taken.retain(|(other, _)| other != file);
        let taken: usize = self.taken.iter().map(|(_, bytes)| bytes.len()).sum();
        if taken + text.len() > MOST_OUTPUT {
            return Err("more is taken from the devices than a scenario keeps"
                .to_owned()
                .into());
        }
        self.taken.push((file.to_owned(), latin1::bytes(&text)));
        Ok(())
    }

    pub(super) fn file_expect(&mut self, station: usize, name: &str, text: Option<&[u8]>) -> Done {
        let found = self.listing(station, name)?;
        let message = match (text, found) {
            (None, None) => return Ok(()),
            (None, Some(found)) => {
                let found = show(&latin1::bytes(&found));
                format!("expected no file {name}, it holds {found}")
            }
            (Some(_), None) => format!("there is no file {name}"),
            (Some(text), Some(found)) => {
                let found = latin1::bytes(&found);
                if lines(text).eq(lines(&found)) {
                    return Ok(());
                }
                let (text, found) = (show(text), show(&found));
                format!("expected that {name} holds {text}, it holds {found}")
            }
        };
        Err(message.into())
    }

    pub(super) fn load(&mut self, station: usize, slot: Option<&Slot>, file: &str) -> Done {
        let text = program_text(self.file(file));
        let slot = self.program_slot(station, slot)?;
        self.load_text(station, &slot, &text).map_err(|error| {
            let line = error.line.saturating_add(1);
            format!("{file}:{line}: {}", error.message).into()
        })
    }

    /// `line` is that of the statement before the text.
    pub(super) fn program(
        &mut self,
        station: usize,
        slot: Option<&Slot>,
        text: &str,
        line: u32,
    ) -> Done {
        let slot = self.program_slot(station, slot)?;
        self.load_text(station, &slot, text)
            .map_err(|error| Failure {
                line: line.saturating_add(error.line).saturating_add(1),
                message: error.message,
            })
    }

    fn program_slot(&mut self, station: usize, slot: Option<&Slot>) -> Result<Slot, Failure> {
        Ok(match slot {
            Some(slot) => slot.clone(),
            None => self.controller(station)?.info().program_slot.clone(),
        })
    }

    fn load_text(&mut self, station: usize, slot: &Slot, text: &str) -> Result<(), LoadError> {
        match self.state.bench.station_mut(station) {
            Some(controller) => controller.load(slot, text).map(drop),
            None => Ok(()),
        }
    }

    pub(super) fn power(&mut self, station: usize, on: bool) -> Done {
        if self.controller(station)?.status().power == on {
            return Ok(());
        }
        self.state.bench.power(station, on);
        let now = self.state.bench.now();
        if let Some(powered) = self.state.powered.get_mut(station) {
            *powered = on.then_some(now);
        }
        if on {
            let watches = self.scenario.watches.iter();
            for (watch, fold) in watches.zip(&mut self.state.folds) {
                if watch.station == station {
                    *fold = Fold::default();
                }
            }
        }
        Ok(())
    }

    pub(super) fn key(&mut self, station: usize, key: &str, down: bool) -> Done {
        if self.controller(station)?.info().keys.is_empty() {
            return Err(self.has_no(station, "panel"));
        }
        let key = key.to_owned();
        self.input(station, Input::Key { key, down })
    }

    pub(super) fn press(&mut self, station: usize, keys: &[String]) -> Done {
        keys.iter().try_for_each(|key| {
            self.key(station, key, true)?;
            self.key(station, key, false)
        })
    }

    pub(super) fn hold(&mut self, station: usize, key: &'a str, time: Nanos) -> Done {
        self.key(station, key, true)?;
        let until = self.state.bench.now() + time;
        let release = Scheduled::Release { station, key };
        self.state.schedule(until, release).map_err(Failure::from)
    }

    pub(super) fn wire(&mut self, station: usize, name: &str, value: f64) -> Done {
        let name = name.to_owned();
        self.input(station, Input::Wire { name, value })
    }

    pub(super) fn fault(
        &mut self,
        station: usize,
        kind: &str,
        axis: Option<&str>,
        active: bool,
    ) -> Done {
        if !self.controller(station)?.info().faults.contains(&kind) {
            return Err(self.has_no(station, &format!("fault {kind}")));
        }
        let input = Input::Fault {
            kind: kind.to_owned(),
            axis: axis.map(str::to_owned),
            active,
        };
        self.input(station, input)
    }

    pub(super) fn at(&mut self, station: usize, time: Nanos, statement: &'a Statement) -> Done {
        let on = self.state.powered.get(station).copied().flatten();
        let on = on.ok_or_else(|| "times count from `power on`, and it is off".to_owned())?;
        let now = self.state.bench.now();
        if on + time < now {
            let now = show_time(now.since(on));
            return Err(format!("{} is over: it is {now}", show_time(time)).into());
        }
        let statement = Scheduled::Statement(statement);
        self.state
            .schedule(on + time, statement)
            .map_err(Failure::from)
    }

    pub(super) fn check(&mut self, station: usize, condition: &Condition) -> Done {
        let value = self.value(station, &condition.signal)?;
        match condition.holds(&value) {
            true => Ok(()),
            false => Err(format!("expected {condition}, it is {}", show_value(&value)).into()),
        }
    }

    /// The value of a signal or variable now.
    fn value(&mut self, station: usize, signal: &str) -> Result<Value, Failure> {
        let source = Source::new(self.controller(station)?.info(), signal);
        self.record(station);
        let Some(controller) = self.state.bench.station_mut(station) else {
            return Err("the controller is not on the bench".to_owned().into());
        };
        source.read(controller, &self.row).map_err(Failure::from)
    }

    pub(super) fn check_fold(&mut self, watch: usize) -> Done {
        let fold = self.state.folds.get(watch);
        let watch = self.scenario.watches.get(watch);
        match fold.zip(watch) {
            Some((fold, watch)) => fold.verdict(watch).map_err(Failure::from),
            None => Ok(()),
        }
    }

    /// Lets twice the time pass; in the second half the condition holds at every sample.
    pub(super) fn check_settled(
        &mut self,
        station: usize,
        condition: &'a Condition,
        within: Nanos,
    ) -> Done {
        // A name that does not exist is said at once.
        self.value(station, &condition.signal)?;
        self.advance(within, &mut Goal::Time)?;
        let value = self.value(station, &condition.signal)?;
        let mut unsettled = Some(value).filter(|value| !condition.holds(value));
        if unsettled.is_none() {
            let source = Source::new(self.controller(station)?.info(), &condition.signal);
            let mut goal = Goal::Breaks {
                station,
                condition,
                source,
                value: None,
            };
            self.advance(within, &mut goal)?;
            if let Goal::Breaks { value, .. } = goal {
                unsettled = value;
            }
        }
        let Some(value) = unsettled else {
            return Ok(());
        };
        let on = self.state.powered.get(station).copied().flatten();
        let now = self.state.bench.now().since(on.unwrap_or_default());
        let (value, within) = (show_value(&value), show_time(within));
        let now = show_time(now);
        Err(format!("expected {condition} settled within {within}, at {now} it was {value}").into())
    }
}

/// The lines of a text, whatever ends them, without the last line end.
fn lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    let text = text.strip_suffix(b"\n").unwrap_or(text);
    let lines = text.split(|&byte| byte == b'\n');
    lines.map(|line| line.strip_suffix(b"\r").unwrap_or(line))
}
