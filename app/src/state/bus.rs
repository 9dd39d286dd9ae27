//! The IEEE-488 bus as the bench's controller of it knows it: what was asked, and what came of it.

use std::collections::VecDeque;

use motionbench_core::bench::{BusView, BusWait};
use motionbench_core::ieee488::{Order, Report};

/// Lines that are kept.
const LINES: usize = 500;
/// A line of data that has no end is broken here.
const LONGEST: usize = 200;

/// What was asked and learnt, a line each.
#[derive(Debug, Clone, Default)]
pub struct BusLog {
    lines: VecDeque<BusLine>,
    ever: usize,
    /// What a talker has said of a line that is not at its end.
    said: String,
}

/// A line of the log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BusLine {
    /// From 0, ever growing.
    pub number: usize,
    /// It is what the user asked.
    pub asked: bool,
    /// For people.
    pub words: String,
}

impl BusLog {
    /// The user asks something.
    pub fn ask(&mut self, order: &Order) {
        self.end_line();
        self.add(true, order_words(order));
    }

    /// The controller of the bus has learnt something.
    pub fn learn(&mut self, report: Report) {
        let Report::Data(byte, end) = report else {
            self.end_line();
            return self.add(false, report_words(report));
        };
        match byte {
            b'\r' => {}
            b'\n' => self.end_line(),
            b' '..=b'~' => self.said.push(char::from(byte)),
            byte => self.said.push_str(&format!("<{byte:02X}>")),
        }
        if end {
            self.said.push_str(" (EOI)");
        }
        if end || self.said.len() >= LONGEST {
            self.end_line();
        }
    }

    /// The lines, the oldest first; the last may go on.
    pub fn lines(&self) -> Vec<BusLine> {
        let mut lines: Vec<BusLine> = self.lines.iter().cloned().collect();
        if !self.said.is_empty() {
            lines.push(BusLine {
                number: self.ever,
                asked: false,
                words: self.said.clone(),
            });
        }
        lines
    }

    fn end_line(&mut self) {
        if !self.said.is_empty() {
            let words = std::mem::take(&mut self.said);
            self.add(false, words);
        }
    }

    fn add(&mut self, asked: bool, words: String) {
        self.lines.push_back(BusLine {
            number: self.ever,
            asked,
            words,
        });
        self.ever += 1;
        if self.lines.len() > LINES {
            self.lines.pop_front();
        }
    }
}

/// What the bus is at.
pub fn state_words(view: &BusView) -> &'static str {
    match view.waits {
        Some(BusWait::NoListener) => "no one listens: IFC ends the wait",
        Some(BusWait::Station(_)) => "the listener holds data off: IFC ends the wait",
        None if view.busy => "busy",
        None => "free",
    }
}

fn order_words(order: &Order) -> String {
    let units = |units: &[u8]| {
        let units: Vec<String> = units.iter().map(u8::to_string).collect();
        units.join(" ")
    };
    match order {
        Order::RemoteEnable(true) => "REN on".to_owned(),
        Order::RemoteEnable(false) => "REN off".to_owned(),
        Order::InterfaceClear => "IFC".to_owned(),
        Order::Listen(none) if none.is_empty() => "no one listens".to_owned(),
        Order::Listen(to) => format!("listen {}", units(to)),
        Order::Send(bytes, end) => {
            let text: String = bytes.iter().map(|&byte| visible(byte)).collect();
            format!("{text}{}", if *end { " (EOI)" } else { "" })
        }
        Order::Talk(unit) => format!("talk {unit}"),
        Order::SerialPoll(unit) => format!("serial poll {unit}"),
        Order::ParallelPoll => "parallel poll".to_owned(),
        Order::Trigger(to) => format!("trigger {}", units(to)),
        Order::Clear(to) if to.is_empty() => "clear all".to_owned(),
        Order::Clear(to) => format!("clear {}", units(to)),
        Order::GoToLocal(to) => format!("go to local {}", units(to)),
        Order::LocalLockout => "local lockout".to_owned(),
    }
}

fn visible(byte: u8) -> String {
    match byte {
        b'\r' => "<CR>".to_owned(),
        b'\n' => "<LF>".to_owned(),
        b' '..=b'~' => char::from(byte).to_string(),
        byte => format!("<{byte:02X}>"),
    }
}

fn report_words(report: Report) -> String {
    match report {
        Report::Data(byte, _) => visible(byte),
        Report::SerialPoll(unit, Some(status)) => {
            format!("unit {unit}: {status:02X}h {status:08b}")
        }
        Report::SerialPoll(unit, None) => format!("there is no unit {unit}"),
        Report::ParallelPoll(0) => "no line answers".to_owned(),
        Report::ParallelPoll(bits) => {
            let lines = (1..=8).filter(|line| bits >> (line - 1) & 1 != 0);
            let lines: Vec<String> = lines.map(|line: u8| line.to_string()).collect();
            match lines.as_slice() {
                [line] => format!("line {line} answers"),
                lines => format!("lines {} answer", lines.join(" ")),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_log_has_a_line_for_each_thing() {
        let mut log = BusLog::default();
        log.ask(&Order::Send(b"PX\r\n".to_vec(), true));
        for byte in *b"X 0000000045\r\nY" {
            log.learn(Report::Data(byte, false));
        }
        log.learn(Report::ParallelPoll(0x83));
        log.learn(Report::SerialPoll(2, Some(0x40)));
        log.learn(Report::SerialPoll(9, None));
        let lines = log.lines();
        let words: Vec<&str> = lines.iter().map(|line| line.words.as_str()).collect();
        let expected = [
            "PX<CR><LF> (EOI)",
            "X 0000000045",
            "Y",
            "lines 1 2 8 answer",
            "unit 2: 40h 01000000",
            "there is no unit 9",
        ];
        assert_eq!(words, expected);
        assert!(lines[0].asked && !lines[1].asked);
        (0..2 * LINES).for_each(|_| log.ask(&Order::InterfaceClear));
        assert_eq!(log.lines().len(), LINES);
    }
}
