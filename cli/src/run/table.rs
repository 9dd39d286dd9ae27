//! The recorded signals as comma-separated values.

use std::fmt::Write;

use motionbench_core::controller::ControllerInfo;
use motionbench_core::trace::Trace;

/// A heading, then a row for each sample: the time in seconds, then the signals in their own units.
pub(super) fn csv(info: &ControllerInfo, trace: Option<&Trace>) -> String {
    let names = info.signals.iter().map(|signal| signal.name.as_str());
    let mut text = String::from("time_s");
    names.for_each(|name| text.extend([",", name]));
    text.push('\n');
    let Some(trace) = trace.filter(|trace| trace.signals() > 0) else {
        return text;
    };
    let times = trace.rows(0).map(|(at, _)| at);
    let mut columns: Vec<_> = (0..trace.signals())
        .map(|signal| trace.rows(signal).map(|(_, value)| value))
        .collect();
    for at in times {
        // Writing to a string cannot fail.
        let _ = write!(text, "{}", at.seconds());
        for value in columns.iter_mut().filter_map(Iterator::next) {
            let _ = write!(text, ",{value}");
        }
        text.push('\n');
    }
    text
}
