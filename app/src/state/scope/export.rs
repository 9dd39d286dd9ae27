//! What is shown, as numbers for other programs.

use std::fmt::Write;

use super::Scope;

impl Scope {
    /// The shown signals within the shown time as comma-separated values (RFC 4180): a line with their names and
    /// units, then one for each sample. Times are in s from the start of the simulation.
    pub fn csv(&self) -> String {
        let columns: Vec<usize> = self.traces().map(|(_, trace)| trace.signal).collect();
        let mut csv = "time (s)".to_owned();
        for &column in &columns {
            let signal = &self.signals[column];
            csv.push(',');
            csv.push_str(&field(format!("{} ({})", signal.name, signal.unit)));
        }
        csv.push_str("\r\n");
        let Some((first, last)) = self.recorded() else {
            return csv;
        };
        let (from, to) = self
            .view()
            .map_or((first, last), |v| (v.from, v.to.min(last)));
        let mut values: Vec<_> = columns
            .iter()
            .map(|&column| self.trace.rows(column).map(|(_, value)| value))
            .collect();
        for (at, _) in self.trace.rows(0) {
            let shown = at >= from && at <= to;
            if shown {
                // Writing to a string cannot fail.
                let _ = write!(csv, "{}", at.seconds());
            }
            for value in values.iter_mut().filter_map(Iterator::next) {
                if shown {
                    let _ = write!(csv, ",{value}");
                }
            }
            if shown {
                csv.push_str("\r\n");
            }
        }
        csv
    }
}

/// A field, in quotes where it needs them.
fn field(name: String) -> String {
    if name.contains([',', '"']) {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name
    }
}
