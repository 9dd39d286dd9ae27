//! `SIGNAL = VALUE +- TOLERANCE`: what a check asks of a signal or variable.

use std::fmt;

use crate::controller::Value;
use crate::language::latin1;

use super::text::{Line, number, show};

/// What must hold of a signal.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Condition {
    pub(super) signal: String,
    pub(super) relation: Relation,
    pub(super) value: Value,
    /// Zero where none is given.
    pub(super) tolerance: f64,
}

/// How a value is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Relation {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

const RELATIONS: [(&str, Relation); 6] = [
    ("=", Relation::Equal),
    ("!=", Relation::NotEqual),
    ("<", Relation::Less),
    ("<=", Relation::LessEqual),
    (">", Relation::Greater),
    (">=", Relation::GreaterEqual),
];

impl Condition {
    /// Reads `SIGNAL RELATION VALUE [+- TOLERANCE]` to the end of the line.
    pub(super) fn parse(mut line: Line<'_>) -> Result<Condition, String> {
        let mut signal = line.need("the signal")?.to_owned();
        let relation = loop {
            let word = line.word().ok_or_else(|| {
                format!("after `{signal}` one of = != < <= > >= is missing, with blanks around it")
            })?;
            match RELATIONS.iter().find(|(text, _)| *text == word) {
                Some(&(_, relation)) => break relation,
                // An array element may be written with blanks: `A(1, 2)`.
                None => signal = format!("{signal} {word}"),
            }
        };
        Condition::with_value(signal, relation, line)
    }

    /// Reads `VALUE [+- TOLERANCE]` to the end of the line.
    pub(super) fn with_value(
        signal: String,
        relation: Relation,
        mut line: Line<'_>,
    ) -> Result<Condition, String> {
        let value = if line.is_quoted() {
            Value::Text(latin1::text(&line.bytes()?))
        } else {
            let word = line.need("the value")?;
            Value::Number(number(word).ok_or_else(|| format!("`{word}` is not a number"))?)
        };
        let mut tolerance = 0.0;
        if line.eat("+-") {
            let word = line.need("the tolerance")?;
            tolerance = number(word)
                .filter(|tolerance| *tolerance >= 0.0)
                .ok_or_else(|| format!("`{word}` is not a tolerance"))?;
        }
        line.end()?;
        let exact = matches!(relation, Relation::Equal | Relation::NotEqual);
        if tolerance > 0.0 && !exact {
            return Err("only = and != have a tolerance".to_owned());
        }
        if matches!(value, Value::Text(_)) && (!exact || tolerance > 0.0) {
            return Err("a text is compared with = or != alone".to_owned());
        }
        Ok(Condition {
            signal,
            relation,
            value,
            tolerance,
        })
    }

    /// Whether `actual` is as asked. A text is never as a number is asked, and not-a-number never as anything is.
    pub(super) fn holds(&self, actual: &Value) -> bool {
        match (actual, &self.value) {
            (Value::Number(actual), Value::Number(value)) => self.holds_for(*actual, *value),
            (Value::Text(actual), Value::Text(value)) => {
                (actual == value) == (self.relation == Relation::Equal)
            }
            _ => false,
        }
    }

    fn holds_for(&self, actual: f64, value: f64) -> bool {
        match self.relation {
            Relation::Equal => (actual - value).abs() <= self.tolerance,
            Relation::NotEqual => (actual - value).abs() > self.tolerance,
            Relation::Less => actual < value,
            Relation::LessEqual => actual <= value,
            Relation::Greater => actual > value,
            Relation::GreaterEqual => actual >= value,
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let relation = RELATIONS
            .iter()
            .find(|(_, relation)| *relation == self.relation)
            .map_or("", |(text, _)| text);
        write!(f, "{} {relation} {}", self.signal, show_value(&self.value))?;
        if self.tolerance > 0.0 {
            write!(f, " +- {}", self.tolerance)?;
        }
        Ok(())
    }
}

/// A value as a scenario would write it.
pub(super) fn show_value(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => show(&latin1::bytes(text)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Condition, String> {
        Condition::parse(Line::new(text))
    }

    fn holds(text: &str, actual: f64) -> bool {
        parse(text).unwrap().holds(&Value::Number(actual))
    }

    #[test]
    fn every_relation() {
        for (text, below, at, above) in [
            ("x = 5", false, true, false),
            ("x != 5", true, false, true),
            ("x < 5", true, false, false),
            ("x <= 5", true, true, false),
            ("x > 5", false, false, true),
            ("x >= 5", false, true, true),
            ("x = 5 +- 1", true, true, true),
            ("x = 5 +- 0.5", false, true, false),
            ("x != 5 +- 1", false, false, false),
        ] {
            assert_eq!(
                [4.0, 5.0, 6.0].map(|v| holds(text, v)),
                [below, at, above],
                "{text}"
            );
        }
        assert!(!holds("x = 5", f64::NAN) && !holds("x != 5", f64::NAN));
        assert!(!parse("x = 5").unwrap().holds(&Value::Text("5".into())));
    }

    #[test]
    fn texts_and_elements_are_written_back_as_read() {
        let condition = parse(r#"A$(1, 2) = "a\r""#).unwrap();
        assert!(condition.holds(&Value::Text("a\r".into())));
        assert_eq!(condition.to_string(), r#"A$(1, 2) = "a\r""#);
        assert_eq!(parse("x != 5 +- .5").unwrap().to_string(), "x != 5 +- 0.5");
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (text, why) in [
            ("", "the signal is missing"),
            (
                "x",
                "after `x` one of = != < <= > >= is missing, with blanks around it",
            ),
            (
                "x=5",
                "after `x=5` one of = != < <= > >= is missing, with blanks around it",
            ),
            ("x =", "the value is missing"),
            ("x = five", "`five` is not a number"),
            ("x = 5 +-", "the tolerance is missing"),
            ("x = 5 +- -1", "`-1` is not a tolerance"),
            ("x < 5 +- 1", "only = and != have a tolerance"),
            ("x < \"a\"", "a text is compared with = or != alone"),
            ("x = 5 6", "`6` is one word too many"),
        ] {
            assert_eq!(parse(text).unwrap_err(), why, "{text}");
        }
    }
}
