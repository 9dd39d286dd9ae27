//! The screen of the terminal on the console's line.

pub mod capture;
pub mod outbox;

use std::collections::VecDeque;
use std::sync::Arc;

use avt::observer::Observer;
use avt::{Line, Observation, ScreenKind};

/// Lines kept above the screen.
const SCROLLBACK: usize = 1000;
/// The size before it is known how much room there is, and the most columns: the width of the terminals of the time.
const COLUMNS: usize = 80;
const ROWS: usize = 24;
/// Lines that a screen reader may still be reading, and characters in one.
const SPOKEN_LINES: usize = 40;
const SPOKEN_CHARACTERS: usize = 400;

/// A terminal: what was printed, and what it looks like.
pub struct Terminal {
    emulator: avt::Terminal,
    kind: ScreenKind,
    /// Rows of the emulator, and those that have left its top since the rows below were made.
    total: usize,
    evicted: usize,
    /// The rows as they were when last asked for, and the number of the first since the terminal was made.
    rows: VecDeque<Arc<Row>>,
    first: u64,
    /// So many of them were above the screen, and have not changed since.
    settled: usize,
    changes: u64,
    spoken: Spoken,
    /// The question that the controller waits with has been spoken; what follows is the echo of the answer.
    asked: bool,
}

/// One row as it looks. Rows of equal [`Row::key`] look the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// Names the row and its looks.
    pub key: (u64, u64),
    /// Its text, in parts of equal looks.
    pub runs: Vec<Run>,
}

/// Some characters of equal looks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Run {
    /// The characters.
    pub text: String,
    /// How they look.
    pub looks: Looks,
}

/// How characters look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs)]
pub struct Looks {
    pub bold: bool,
    pub underline: bool,
    pub inverse: bool,
    /// The cursor stands here.
    pub cursor: bool,
}

/// Counts the rows that leave the top.
#[derive(Default)]
struct Evicted(usize);

impl Observer for &mut Evicted {
    type Output = ();

    fn evicted(&mut self, _: &mut Observation<'_>, _: &Line) {
        self.0 += 1;
    }

    fn end(&mut self, _: &mut Observation<'_>) {}
}

impl Default for Terminal {
    fn default() -> Terminal {
        let emulator = emulator(COLUMNS, ROWS);
        Terminal {
            kind: emulator.active_screen_kind(),
            total: ROWS,
            evicted: 0,
            emulator,
            rows: VecDeque::new(),
            first: 0,
            settled: 0,
            changes: 0,
            spoken: Spoken::default(),
            asked: false,
        }
    }
}

/// Of a size that is not zero.
fn emulator(columns: usize, rows: usize) -> avt::Terminal {
    avt::Terminal::with_scrollback(columns, rows, Some(SCROLLBACK))
        .expect("neither columns nor rows are zero")
}

impl Terminal {
    /// Prints what arrived, one character a byte.
    pub fn print(&mut self, text: &str) {
        // What the devices send above 7F is no control code, whatever a terminal thinks.
        let shown: String = text
            .chars()
            .map(|c| if is_c1(c) { '\u{fffd}' } else { c })
            .collect();
        let mut evicted = Evicted::default();
        self.emulator.feed_with(shown.as_str(), &mut evicted);
        self.spoken.hear(text);
        let total = self.emulator.screen().all_lines().count();
        let kind = self.emulator.active_screen_kind();
        if kind != self.kind || total + evicted.0 < self.total {
            // Another screen, or one that was erased with all above it.
            self.settled = 0;
        }
        self.kind = kind;
        self.total = total;
        self.evicted += evicted.0;
    }

    /// Fits it into so much room; columns beyond 80 stay empty.
    pub fn resize(&mut self, columns: usize, rows: usize) {
        let (columns, rows) = (columns.clamp(10, COLUMNS), rows.clamp(2, 200));
        if self.emulator.size() != (columns, rows) {
            let mut evicted = Evicted::default();
            self.emulator.resize_with(columns, rows, &mut evicted);
            self.total = self.emulator.screen().all_lines().count();
            self.evicted += evicted.0;
            self.settled = 0;
        }
    }

    /// All rows, oldest first.
    pub fn rows(&mut self) -> Vec<Arc<Row>> {
        self.refresh();
        self.rows.iter().cloned().collect()
    }

    /// The rows of the screen alone: for text that comes faster than anyone reads.
    pub fn screen(&mut self) -> Vec<Arc<Row>> {
        self.changes += 1;
        let above = self.above();
        let row = |index| Row {
            key: (self.number(index), self.changes),
            runs: self.runs(index),
        };
        (above..self.total)
            .map(|index| Arc::new(row(index)))
            .collect()
    }

    /// Shows nothing, as a new one of the same size.
    pub fn reset(&mut self) {
        let (columns, rows) = self.emulator.size();
        let changes = self.changes + 1;
        *self = Terminal::default();
        self.resize(columns, rows);
        self.changes = changes;
    }

    /// Goes to a new line where something stands in this one: what is printed next belongs to another start.
    pub fn on_new_line(&mut self) {
        let column = self.emulator.cursor().position().map(|(column, _)| column);
        if column.is_some_and(|column| column > 0) {
            self.print("\r\n");
        }
    }

    /// Forgets all rows but the one that the cursor is in.
    pub fn clear(&mut self) {
        let (columns, rows) = self.emulator.size();
        let cursor = self.emulator.cursor().position();
        let cursor = cursor.and_then(|(column, row)| {
            let line = self.emulator.screen().all_lines().nth(self.above() + row)?;
            Some(line.chars().take(column).collect::<String>())
        });
        self.first = self.ever();
        self.emulator = emulator(columns, rows);
        (self.total, self.evicted, self.settled) = (rows, 0, 0);
        self.rows.clear();
        self.emulator.feed(cursor.unwrap_or_default().as_str());
    }

    /// What all rows say; a line that was too long for a row is one line.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in self.emulator.screen().all_lines() {
            text.push_str(line.text().trim_end());
            if !line.is_wrapped() {
                text.push('\n');
            }
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
        text
    }

    /// How many rows are above the screen.
    pub fn above(&self) -> usize {
        self.total.saturating_sub(self.emulator.size().1)
    }

    /// How many rows there ever were.
    pub fn ever(&self) -> u64 {
        self.number(self.total)
    }

    /// What a screen reader reads: whole lines, numbered.
    pub fn spoken(&self) -> Vec<(u64, String)> {
        self.spoken.lines.iter().cloned().collect()
    }

    /// While the controller waits for an answer, its question is a line, though it has not ended.
    pub fn asks(&mut self, waits: bool) {
        if waits && !self.asked {
            self.spoken.end();
        }
        self.asked = waits;
    }

    /// The number of a row of the emulator.
    fn number(&self, index: usize) -> u64 {
        self.first + (self.evicted + index) as u64
    }

    /// The looks of a row of the emulator.
    fn runs(&self, index: usize) -> Vec<Run> {
        let cursor = self.emulator.cursor().position();
        let cursor = cursor.filter(|&(_, row)| self.above() + row == index);
        let line = self.emulator.screen().all_lines().nth(index);
        line.map_or_else(Vec::new, |line| {
            runs(line, cursor.map(|(column, _)| column))
        })
    }

    /// Makes the rows anew that may have changed.
    fn refresh(&mut self) {
        let settled = self.settled.saturating_sub(self.evicted);
        self.rows.drain(..self.evicted.min(self.rows.len()));
        self.first += self.evicted as u64;
        self.evicted = 0;
        self.rows.truncate(self.total);
        for index in settled..self.total {
            let runs = self.runs(index);
            if self.rows.get(index).is_some_and(|row| row.runs == runs) {
                continue;
            }
            self.changes += 1;
            let key = (self.number(index), self.changes);
            let row = Arc::new(Row { key, runs });
            match self.rows.get_mut(index) {
                Some(old) => *old = row,
                None => self.rows.push_back(row),
            }
        }
        self.settled = self.above();
    }
}

fn is_c1(character: char) -> bool {
    ('\u{80}'..='\u{9f}').contains(&character)
}

/// A line in parts of equal looks, without the blanks at its end.
fn runs(line: &Line, cursor: Option<usize>) -> Vec<Run> {
    // Behind the last column it waits on it.
    let cursor = cursor.map(|column| column.min(line.len().saturating_sub(1)));
    let mut runs: Vec<Run> = Vec::new();
    let mut blanks = 0;
    for (column, cell) in line
        .cells()
        .iter()
        .enumerate()
        .filter(|(_, cell)| cell.width() > 0)
    {
        let looks = Looks {
            bold: cell.pen().is_bold(),
            underline: cell.pen().is_underline(),
            inverse: cell.pen().is_inverse(),
            cursor: cursor == Some(column),
        };
        let plain = looks == Looks::default();
        if cell.char() == ' ' && plain {
            blanks += 1;
            continue;
        }
        if blanks > 0 {
            append(
                &mut runs,
                Looks::default(),
                std::iter::repeat_n(' ', blanks),
            );
            blanks = 0;
        }
        append(&mut runs, looks, std::iter::once(cell.char()));
    }
    runs
}

fn append(runs: &mut Vec<Run>, looks: Looks, characters: impl Iterator<Item = char>) {
    match runs.last_mut() {
        Some(run) if run.looks == looks => run.text.extend(characters),
        _ => runs.push(Run {
            text: characters.collect(),
            looks,
        }),
    }
}

/// What a screen reader reads: the lines as they come, without control codes.
#[derive(Debug, Default)]
struct Spoken {
    lines: VecDeque<(u64, String)>,
    line: String,
    ended: u64,
}

impl Spoken {
    fn hear(&mut self, text: &str) {
        for character in text.chars() {
            match character {
                '\n' => self.end(),
                '\x08' => {
                    self.line.pop();
                }
                c if c.is_control() => {}
                c => {
                    if self.line.len() < SPOKEN_CHARACTERS {
                        self.line.push(c);
                    }
                }
            }
        }
    }

    fn end(&mut self) {
        let line = std::mem::take(&mut self.line);
        if line.trim().is_empty() {
            return;
        }
        if self.lines.len() == SPOKEN_LINES {
            self.lines.pop_front();
        }
        self.ended += 1;
        self.lines.push_back((self.ended, line));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(terminal: &mut Terminal) -> Vec<String> {
        let text = |row: &Arc<Row>| {
            row.runs
                .iter()
                .map(|run| run.text.as_str())
                .collect::<String>()
        };
        let mut rows: Vec<String> = terminal.rows().iter().map(text).collect();
        while rows.last().is_some_and(|row| row.trim().is_empty()) {
            rows.pop();
        }
        rows
    }

    #[test]
    fn another_start_begins_on_a_new_line() {
        let mut terminal = Terminal::default();
        terminal.on_new_line();
        terminal.print(">");
        terminal.on_new_line();
        terminal.print(">");
        assert_eq!(terminal.text().trim_end(), ">\n>");
    }

    #[test]
    fn prints_lines_and_shows_the_cursor_behind_them() {
        let mut terminal = Terminal::default();
        terminal.print(">10 GOTO 10\r\n>");
        assert_eq!(text(&mut terminal), [">10 GOTO 10", "> "]);
        let cursor = Run {
            text: " ".to_owned(),
            looks: Looks {
                cursor: true,
                ..Looks::default()
            },
        };
        assert_eq!(terminal.rows()[1].runs[1], cursor);
    }

    #[test]
    fn backspace_space_backspace_erases() {
        let mut terminal = Terminal::default();
        terminal.print(">RUM\x08 \x08N");
        assert_eq!(text(&mut terminal), [">RUN "]);
    }

    #[test]
    fn rows_that_did_not_change_keep_their_key() {
        let mut terminal = Terminal::default();
        terminal.print(">ONE\r\n>TWO");
        let before = terminal.rows();
        terminal.print("X");
        let after = terminal.rows();
        assert_eq!(before[0].key, after[0].key);
        assert_ne!(before[1].key, after[1].key);
        assert_eq!(before[5].key, after[5].key);
    }

    #[test]
    fn a_flood_keeps_the_newest_lines_and_their_numbers() {
        let mut terminal = Terminal::default();
        terminal.print("first\r\n");
        let kept_rows = terminal.rows().len();
        for number in 0..5000 {
            terminal.print(&format!("{number}\r\n"));
            if number % 700 == 0 {
                terminal.rows();
            }
        }
        let shown = text(&mut terminal);
        assert_eq!(shown[shown.len() - 1], "4999");
        let rows = terminal.rows();
        assert!(
            rows.len() > kept_rows && rows.len() <= SCROLLBACK + ROWS,
            "{}",
            rows.len()
        );
        assert!(
            rows.windows(2)
                .all(|pair| pair[0].key.0 + 1 == pair[1].key.0)
        );
        assert_eq!(terminal.ever(), rows.last().unwrap().key.0 + 1);
        let screen = terminal.screen();
        let runs = |row: &Arc<Row>| row.runs.clone();
        assert!(
            screen
                .iter()
                .map(runs)
                .eq(rows[terminal.above()..].iter().map(runs))
        );
        // All at once gives the same.
        let mut at_once = Terminal::default();
        let all: String = (0..5000).map(|number| format!("{number}\r\n")).collect();
        at_once.print(&format!("first\r\n{all}"));
        assert_eq!(text(&mut at_once), shown);
    }

    #[test]
    fn a_narrow_terminal_wraps_and_a_wide_one_joins_again() {
        let mut terminal = Terminal::default();
        let line = format!(">{}", "A".repeat(60));
        terminal.print(&line);
        terminal.resize(40, 20);
        assert_eq!(text(&mut terminal).len(), 2);
        terminal.resize(400, 20);
        assert_eq!(text(&mut terminal), [format!("{line} ")]);
    }

    #[test]
    fn clearing_leaves_the_line_that_is_being_typed() {
        let mut terminal = Terminal::default();
        terminal.print(&"10 END\r\n".repeat(100));
        terminal.print(">LI");
        let last = terminal.rows().last().unwrap().key.0;
        terminal.clear();
        assert_eq!(text(&mut terminal), [">LI "]);
        assert!(terminal.rows()[0].key.0 > last, "new rows have new names");
        terminal.print("ST\r\n");
        assert_eq!(text(&mut terminal), [">LIST"]);
    }

    #[test]
    fn the_text_of_all_rows_has_the_lines_as_they_were_printed() {
        let mut terminal = Terminal::default();
        terminal.resize(20, 5);
        let long = "A".repeat(50);
        terminal.print(&format!("{long}\r\n\r\n>"));
        assert_eq!(terminal.text(), format!("{long}\n\n>\n"));
    }

    #[test]
    fn garbage_of_a_wrong_line_speed_is_printed_not_obeyed() {
        let mut terminal = Terminal::default();
        let garbage: String = (0..=255u8).cycle().take(100_000).map(char::from).collect();
        terminal.print(&garbage);
        terminal.print("\x18\x1bc\u{9b}2J>");
        assert_eq!(text(&mut terminal), ["\u{fffd}2J> "]);
    }

    #[test]
    fn a_screen_reader_hears_whole_lines_and_questions() {
        let mut terminal = Terminal::default();
        terminal.print(">RUX\x08N\r\n\r\nLENGTH? ");
        assert_eq!(terminal.spoken(), [(1, ">RUN".to_owned())]);
        terminal.asks(true);
        assert_eq!(terminal.spoken()[1], (2, "LENGTH? ".to_owned()));
        terminal.print("4096");
        terminal.asks(true);
        assert_eq!(terminal.spoken().len(), 2);
        terminal.print(&"line\r\n".repeat(100));
        assert_eq!(terminal.spoken().len(), SPOKEN_LINES);
    }
}
