//! Reads a scenario: lines, blocks, and which station each statement is about. What one statement may say is in
//! `words`.

use std::iter::Enumerate;
use std::str::Lines;

use crate::catalog;
use crate::controller::Sharing;

use super::condition::Condition;
use super::statement::{Action, Statement};
use super::text::{Line, number};
use super::{MOST_REPEATS, MOST_STATIONS, MOST_TEXT, Planned, Problem, Scenario, Watch, words};

/// How deep `repeat` may stand in `repeat`.
const DEEPEST: usize = 8;

/// The axes' names in signals.
const AXES: [&str; 10] = ["x", "y", "z", "w", "a", "b", "c", "d", "t", "u"];

/// Reads a scenario; see [`Scenario::parse`].
pub(super) fn parse(text: &str) -> Result<Scenario, Problem> {
    if text.len() > MOST_TEXT {
        return Err(Problem {
            line: 1,
            message: format!("a scenario has at most {MOST_TEXT} bytes"),
        });
    }
    // Program text is counted in lines, too, and devices end theirs with it.
    if let Some(index) = text.lines().position(|line| line.contains('\r')) {
        return Err(Problem {
            line: u32::try_from(index + 1).unwrap_or(u32::MAX),
            message: "a carriage return stands in the middle of the line".to_owned(),
        });
    }
    let mut parser = Parser {
        lines: text.lines().enumerate(),
        line: 1,
        depth: 0,
        scenario: Scenario::default(),
    };
    match parser.block() {
        Ok(statements) => parser.scenario.statements = statements,
        Err(message) => {
            return Err(Problem {
                line: parser.line,
                message,
            });
        }
    }
    let mut scenario = parser.scenario;
    scenario.last_line = parser.line;
    always_needs_ever(&scenario)?;
    Ok(scenario)
}

struct Parser<'a> {
    lines: Enumerate<Lines<'a>>,
    /// Of the statement being read, from 1.
    line: u32,
    /// Blocks that are open.
    depth: usize,
    scenario: Scenario,
}

impl<'a> Parser<'a> {
    fn next_line(&mut self) -> Option<&'a str> {
        let (index, text) = self.lines.next()?;
        self.line = u32::try_from(index + 1).unwrap_or(u32::MAX);
        Some(text)
    }

    /// Reads statements to the `end` of the open block, or to the end of the text.
    fn block(&mut self) -> Result<Vec<Statement>, String> {
        let opened = self.line;
        let mut statements = Vec::new();
        while let Some(text) = self.next_line() {
            let line = Line::new(text);
            match line.peek() {
                None => {}
                Some(word) if word.starts_with('#') => {}
                Some("end") if self.depth > 0 => {
                    let mut line = line;
                    line.word();
                    line.end()?;
                    return Ok(statements);
                }
                Some("end") => return Err("`end` without `repeat` or `program`".to_owned()),
                Some(_) => statements.extend(self.statement(line, None)?),
            }
        }
        if self.depth > 0 {
            self.line = opened;
            return Err("`repeat` without `end`".to_owned());
        }
        Ok(statements)
    }

    /// Reads one statement; `None` for one that is about the scenario itself.
    fn statement(
        &mut self,
        mut line: Line<'a>,
        station: Option<usize>,
    ) -> Result<Option<Statement>, String> {
        let word = line.need("the statement")?;
        if let Some(name) = word.strip_suffix(':') {
            let named = self.scenario.stations.iter().position(|s| s.name == name);
            return match named {
                Some(_) if station.is_some() => Err("one station at a time".to_owned()),
                Some(named) => self.statement(line, Some(named)),
                None => Err(format!("no controller on the bench is called `{name}`")),
            };
        }
        if word == "bench" {
            return self.bench(line).map(Some);
        }
        if word == "known-failure" {
            return self.known_failure(line).map(|()| None);
        }
        let last = self.scenario.stations.len().checked_sub(1);
        let Some(station) = station.or(last) else {
            return Err(match words::is_statement(word) {
                true => "no controller is on the bench yet: a `bench` line comes first".to_owned(),
                false => words::unknown(word),
            });
        };
        // The number of the line is taken before a block moves it on.
        let number = self.line;
        let action = match word {
            "repeat" => self.repeat(line)?,
            "program" => self.program(line)?,
            "at" => self.at(line, station)?,
            "check" => self.check(line, station)?,
            _ => words::action(word, line)?,
        };
        if let Action::Rewind(time) = action {
            self.scenario.rewinds += time;
        }
        Ok(Some(Statement {
            line: number,
            station,
            action,
        }))
    }

    fn bench(&mut self, mut line: Line<'a>) -> Result<Statement, String> {
        if self.depth > 0 {
            return Err("`bench` cannot stand in `repeat`".to_owned());
        }
        let station = self.scenario.stations.len();
        if station >= MOST_STATIONS {
            return Err(format!(
                "at most {MOST_STATIONS} controllers fit on the bench"
            ));
        }
        let id = line.need("the controller")?;
        let kind = catalog::kind(id).ok_or_else(|| unknown_controller(id))?;
        let taken = |name: &str| self.scenario.stations.iter().any(|s| s.name == name);
        let name = if line.eat("as") {
            let name = line.need("the name")?;
            if !is_name(name) {
                return Err(format!(
                    "`{name}` is not a name: a letter, then letters, digits, `-` and `_`"
                ));
            }
            name.to_owned()
        } else {
            let numbered = (2..=MOST_STATIONS).map(|n| format!("{id}-{n}"));
            let mut free = std::iter::once(id.to_owned()).chain(numbered);
            free.find(|name| !taken(name)).unwrap_or_default()
        };
        if taken(&name) {
            return Err(format!("`{name}` is on the bench already"));
        }
        let mut options = Vec::new();
        while let Some(option) = line.setting()? {
            options.push(option);
        }
        let line = take_line(&mut options)?;
        let created = kind.create(&options)?;
        let shares = created.controller().info().sharing != Sharing::Alone;
        if line.is_some() && !shares {
            return Err(format!("{id} has a host line of its own"));
        }
        let mut earlier = self.scenario.stations.iter();
        let behind = earlier.position(|other| other.id == kind.id && other.line == line);
        self.scenario.stations.push(Planned {
            name,
            id: kind.id,
            station: created,
            behind: behind.filter(|_| shares),
            line,
        });
        Ok(Statement {
            line: self.line,
            station,
            action: Action::Bench,
        })
    }

    fn known_failure(&mut self, mut line: Line<'a>) -> Result<(), String> {
        let reason = line.quoted()?;
        line.end()?;
        if self.depth > 0 {
            return Err("`known-failure` cannot stand in `repeat`".to_owned());
        }
        if self.scenario.known_failure.is_some() {
            return Err("one `known-failure` is enough".to_owned());
        }
        self.scenario.known_failure = Some((self.line, reason));
        Ok(())
    }

    fn repeat(&mut self, mut line: Line<'a>) -> Result<Action, String> {
        let word = line.need("how often")?;
        line.end()?;
        let count = word
            .parse()
            .ok()
            .filter(|count| (1..=MOST_REPEATS).contains(count))
            .ok_or_else(|| format!("`{word}` is not a count of 1 to {MOST_REPEATS}"))?;
        if self.depth >= DEEPEST {
            return Err(format!(
                "`repeat` stands in `repeat` at most {DEEPEST} deep"
            ));
        }
        self.depth += 1;
        let body = self.block()?;
        self.depth -= 1;
        Ok(Action::Repeat { count, body })
    }

    /// The text between `program` and `end`, as it stands.
    fn program(&mut self, mut line: Line<'a>) -> Result<Action, String> {
        let opened = self.line;
        let slot = line.word().map(words::slot);
        line.end()?;
        let mut text = String::new();
        while let Some(line) = self.next_line() {
            if line.trim() == "end" {
                return Ok(Action::Program { slot, text });
            }
            text.push_str(line);
            text.push('\n');
        }
        self.line = opened;
        Err("`program` without `end`".to_owned())
    }

    fn at(&mut self, mut line: Line<'a>, station: usize) -> Result<Action, String> {
        let time = line.time("the time")?;
        let word = line.need("the statement")?;
        // The blocks' own words take lines, and `at` is on one.
        if matches!(
            word,
            "program" | "repeat" | "at" | "bench" | "known-failure"
        ) {
            return Err(format!("`{word}` cannot be scheduled"));
        }
        let mut again = line;
        let action = if word == "check" {
            self.check(again, station)?
        } else if let Some(name) = word.strip_suffix(':') {
            return Err(format!("write `{name}:` before `at`"));
        } else {
            words::action(word, again)?
        };
        if !action.is_momentary() {
            let what = again.word().filter(|w| *w == "settled").unwrap_or(word);
            return Err(format!("`{what}` takes time and cannot be scheduled"));
        }
        let statement = Box::new(Statement {
            line: self.line,
            station,
            action,
        });
        Ok(Action::At { time, statement })
    }

    fn check(&mut self, mut line: Line<'a>, station: usize) -> Result<Action, String> {
        if line.eat("settled") {
            return settled(line);
        }
        // A signal may be called `always` or `ever`, but then a relation follows.
        let watched = match line.peek() {
            Some("always") => Some(false),
            Some("ever") => Some(true),
            _ => None,
        };
        let Some(ever) = watched else {
            return Condition::parse(line).map(Action::Check);
        };
        line.word();
        let watch = self.scenario.watches.len();
        self.scenario.watches.push(Watch {
            line: self.line,
            station,
            ever,
            condition: Condition::parse(line)?,
        });
        Ok(match ever {
            true => Action::CheckEver(watch),
            false => Action::CheckAlways(watch),
        })
    }
}

/// `settled SIGNAL within TIME of VALUE +- TOLERANCE`
fn settled(mut line: Line<'_>) -> Result<Action, String> {
    let mut signal = line.need("the signal")?.to_owned();
    while let Some(word) = line.peek().filter(|word| *word != "within") {
        signal = format!("{signal} {word}");
        line.word();
    }
    line.keyword("within")?;
    let within = line.time("the time after `within`")?;
    line.keyword("of")?;
    let condition = Condition::with_value(signal, super::condition::Relation::Equal, line)?;
    Ok(Action::CheckSettled { condition, within })
}

/// `line=NAME` among the options of a station: the host line that it hangs on.
fn take_line(options: &mut Vec<(String, String)>) -> Result<Option<String>, String> {
    let at = options.iter().position(|(key, _)| key == "line");
    let line = at.map(|at| options.remove(at).1);
    match line {
        Some(name) if !is_name(&name) => Err(format!(
            "`{name}` is not a line's name: a letter, then letters, digits, `-` and `_`"
        )),
        line => Ok(line),
    }
}

fn is_name(name: &str) -> bool {
    let mut characters = name.chars();
    characters.next().is_some_and(|c| c.is_ascii_alphabetic())
        && characters.all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'))
}

fn unknown_controller(id: &str) -> String {
    let known: Vec<&str> = catalog::KINDS.iter().map(|kind| kind.id).collect();
    format!(
        "no controller is called `{id}`; there are: {}",
        known.join(", ")
    )
}

/// A limit that an axis keeps says nothing if the axis never moved, so an `always` about motion needs an `ever` about
/// the same axis. (That it always has one value may well mean that it never moves.)
fn always_needs_ever(scenario: &Scenario) -> Result<(), Problem> {
    let axis = |watch: &Watch| {
        let (axis, _) = watch.condition.signal.split_once('.')?;
        let is_axis = AXES.contains(&axis) || number(axis).is_some();
        is_axis.then(|| axis.to_owned())
    };
    for always in scenario.watches.iter().filter(|watch| !watch.ever) {
        let Some(name) = axis(always) else { continue };
        let equal = always.condition.relation == super::condition::Relation::Equal;
        let moved = scenario.watches.iter().any(|watch| {
            watch.ever && watch.station == always.station && axis(watch) == Some(name.clone())
        });
        if !equal && !moved {
            return Err(Problem {
                line: always.line,
                message: format!(
                    "`check always` holds of an axis that stands still: add a `check ever` about {name}"
                ),
            });
        }
    }
    Ok(())
}
