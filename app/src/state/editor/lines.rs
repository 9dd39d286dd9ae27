//! Lines of the text: where they go when it is edited, and what they are to the controller.

use motionbench_core::catalog::Kind;
use motionbench_core::language::{Diagnostic, HighlightClass, Span};

/// A part of the text was replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edit {
    /// The line in which the part began.
    pub first: u32,
    /// It began at the very start of that line.
    pub at_start: bool,
    /// The line in which it ended.
    pub last: u32,
    /// It ended at the very end of that line.
    pub at_end: bool,
    /// Line ends in what replaced it.
    pub breaks: u32,
}

impl Edit {
    /// Where the line that was `line` is now; `None` if all of it is gone.
    pub fn moved(&self, line: u32) -> Option<u32> {
        let tail = self.first + self.breaks;
        if line < self.first {
            Some(line)
        } else if line > self.last {
            Some(line - self.last + tail)
        } else if self.first == self.last {
            // Pushed down by what was put in front of it; otherwise its start stays where it is.
            Some(if self.at_start && !self.at_end {
                tail
            } else {
                line
            })
        } else if line == self.first && !self.at_start {
            Some(line)
        } else if line == self.last && !self.at_end {
            Some(tail)
        } else {
            None
        }
    }
}

/// Where the lines of an earlier text are now.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moved(Vec<Option<u32>>);

impl Moved {
    /// All lines of `text` where they are.
    pub fn none(text: &str) -> Moved {
        Moved(
            (0u32..)
                .zip(text.split('\n'))
                .map(|(line, _)| Some(line))
                .collect(),
        )
    }

    /// Those of the first `lines` lines that `places` tells the places of; the others are gone.
    pub fn to(lines: usize, places: impl IntoIterator<Item = (u32, u32)>) -> Moved {
        let mut all = vec![None; lines];
        for (line, place) in places {
            let line = usize::try_from(line).ok();
            if let Some(moved) = line.and_then(|line| all.get_mut(line)) {
                *moved = Some(place);
            }
        }
        Moved(all)
    }

    /// No line of the earlier text is left.
    pub fn all_gone() -> Moved {
        Moved(Vec::new())
    }

    /// The text was edited.
    pub fn follow(&mut self, edit: &Edit) {
        for place in &mut self.0 {
            *place = place.and_then(|line| edit.moved(line));
        }
    }

    /// The text was replaced, and its lines have moved so.
    pub fn follow_all(&mut self, moved: &Moved) {
        for place in &mut self.0 {
            *place = place.and_then(|line| moved.place(line));
        }
    }

    /// Where a line of the earlier text is.
    pub fn place(&self, line: u32) -> Option<u32> {
        *self.0.get(usize::try_from(line).ok()?)?
    }

    /// Where each line is, in the order of the earlier text.
    pub fn all(&self) -> &[Option<u32>] {
        &self.0
    }
}

/// The text with every line end a line feed, as the editor counts lines.
pub fn with_line_feeds(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

/// The number that stands in a line, read by the controller's own lexer.
pub fn written_number(kind: &Kind, line: &str) -> Option<u32> {
    let parts = (kind.highlight)(line);
    let number = parts
        .first()
        .filter(|part| part.class == HighlightClass::LineNumber)?;
    let digits = line
        .chars()
        .skip(number.span.range().start)
        .take(number.span.range().len());
    digits.collect::<String>().parse().ok()
}

/// The classes of a line's parts, by the names that the editor's style sheet knows them.
pub const CLASSES: [&str; 10] = [
    "line-number",
    "keyword",
    "function",
    "variable",
    "system-variable",
    "number",
    "text",
    "comment",
    "operator",
    "error",
];

/// The index of a class in [`CLASSES`].
fn class_index(class: HighlightClass) -> u32 {
    match class {
        HighlightClass::LineNumber => 0,
        HighlightClass::Keyword => 1,
        HighlightClass::Function => 2,
        HighlightClass::Variable => 3,
        HighlightClass::SystemVariable => 4,
        HighlightClass::Number => 5,
        HighlightClass::Text => 6,
        HighlightClass::Comment => 7,
        HighlightClass::Operator => 8,
        HighlightClass::Error => 9,
    }
}

/// The parts of a line for the editor: start, end and index of the class of each, counted in UTF-16.
pub fn highlights(kind: &Kind, line: &str) -> Vec<u32> {
    let units = Units::of(line);
    let parts = (kind.highlight)(line).into_iter();
    let triple = |part: motionbench_core::language::Highlight| {
        let span = units.span(part.span);
        [span.start, span.end, class_index(part.class)]
    };
    parts.flat_map(triple).collect()
}

/// Counts the places of problems in UTF-16 instead of characters.
pub fn count_in_utf16(text: &str, problems: &mut [Diagnostic]) {
    let mut lines = (0u32..).zip(text.split('\n')).peekable();
    // Problems come in the order of the lines.
    for problem in problems {
        while lines
            .next_if(|(number, _)| *number < problem.line)
            .is_some()
        {}
        let Some((_, line)) = lines.peek() else {
            return;
        };
        let units = Units::of(line);
        problem.span = units.span(problem.span);
        if let Some(cure) = &mut problem.cure {
            cure.span = units.span(cure.span);
        }
    }
}

/// The positions of a line in UTF-16.
struct Units {
    /// Characters beyond the basic plane take two units: their indices.
    wide: Vec<u32>,
    /// Characters of the line.
    length: u32,
}

impl Units {
    fn of(line: &str) -> Units {
        let characters = (0u32..).zip(line.chars());
        let mut length = 0;
        let wide = characters
            .inspect(|(index, _)| length = index + 1)
            .filter(|(_, character)| character.len_utf16() > 1)
            .map(|(index, _)| index)
            .collect();
        Units { wide, length }
    }

    fn span(&self, span: Span) -> Span {
        let position = |character: u32| {
            let character = character.min(self.length);
            let before = self.wide.partition_point(|&wide| wide < character);
            character + u32::try_from(before).unwrap_or(u32::MAX)
        };
        Span {
            start: position(span.start),
            end: position(span.end),
        }
    }
}

#[cfg(test)]
mod tests {
    use motionbench_core::catalog::kind;

    use super::*;

    /// Lines of `before`, and where they are when `removed` (characters) has become `inserted`.
    fn moves(before: &str, removed: std::ops::Range<usize>, inserted: &str) -> Vec<Option<u32>> {
        let number = |at: usize| u32::try_from(before[..at].matches('\n').count()).unwrap();
        let edit = Edit {
            first: number(removed.start),
            at_start: removed.start == 0 || before[..removed.start].ends_with('\n'),
            last: number(removed.end),
            at_end: removed.end == before.len() || before[removed.end..].starts_with('\n'),
            breaks: u32::try_from(inserted.matches('\n').count()).unwrap(),
        };
        let mut moved = Moved::none(before);
        moved.follow(&edit);
        moved.all().to_vec()
    }

    #[test]
    fn a_line_goes_where_its_text_goes() {
        let text = "10 A\n20 B\n30 C\n40 D";
        let all = |lines: [i32; 4]| lines.map(|line| u32::try_from(line).ok()).to_vec();
        for (removed, inserted, expected) in [
            // Typed into a line, at its start, at its end.
            (7..7, "X", [0, 1, 2, 3]),
            (5..5, "X", [0, 1, 2, 3]),
            (9..9, "X", [0, 1, 2, 3]),
            // A line end at the start of a line pushes it down, at its end does not.
            (5..5, "\n", [0, 2, 3, 4]),
            (5..5, "15 X\n", [0, 2, 3, 4]),
            (9..9, "\n25 X", [0, 1, 3, 4]),
            (7..7, "\n", [0, 1, 3, 4]),
            // A whole line typed anew.
            (5..9, "20 Y", [0, 1, 2, 3]),
            // Lines deleted from start to start, and from end to end.
            (5..10, "", [0, -1, 1, 2]),
            (5..15, "", [0, -1, -1, 1]),
            (4..9, "", [0, -1, 1, 2]),
            (4..14, "", [0, -1, -1, 1]),
            // Two lines joined: both are there.
            (9..10, "", [0, 1, 1, 2]),
            // All replaced.
            (0..19, "1\n2\n3", [-1, -1, -1, -1]),
        ] {
            assert_eq!(
                moves(text, removed.clone(), inserted),
                all(expected),
                "{removed:?} {inserted:?}"
            );
        }
    }

    #[test]
    fn an_empty_line_leaves_what_follows_alone() {
        assert_eq!(moves("10 A\n\n30 C", 5..6, ""), [Some(0), None, Some(1)]);
        assert_eq!(moves("10 A\n\n30 C", 4..5, ""), [Some(0), None, Some(1)]);
        assert_eq!(
            moves("10 A\n\n30 C", 5..5, "\n"),
            [Some(0), Some(1), Some(3)]
        );
    }

    #[test]
    fn the_first_number_of_a_line_is_the_controllers_line() {
        let kind = kind("mc600").unwrap();
        assert_eq!(written_number(kind, "  120 PRINT 5"), Some(120));
        assert_eq!(written_number(kind, "120"), Some(120));
        assert_eq!(written_number(kind, "PRINT 5"), None);
        assert_eq!(written_number(kind, "70000 PRINT"), None);
        assert_eq!(written_number(kind, ""), None);
    }

    #[test]
    fn places_are_counted_as_the_editor_counts() {
        let kind = kind("mc600").unwrap();
        let line = "10 PRINT \"\u{1f600}\u{e9}\";A";
        let parts = highlights(kind, line);
        let parts: Vec<(String, &str)> = parts
            .chunks(3)
            .map(|part| {
                let units: Vec<u16> = line.encode_utf16().collect();
                let text = &units[part[0] as usize..part[1] as usize];
                (String::from_utf16(text).unwrap(), CLASSES[part[2] as usize])
            })
            .collect();
        let expected = [
            ("10", "line-number"),
            ("PRINT", "keyword"),
            ("\"\u{1f600}\u{e9}\"", "text"),
            (";", "operator"),
            ("A", "variable"),
        ];
        assert!(
            parts
                .iter()
                .map(|(text, class)| (text.as_str(), *class))
                .eq(expected),
            "{parts:?}"
        );

        let text = format!("10 A=1\n{line}\u{1f600}");
        let mut problems = (kind.diagnose)(&text);
        count_in_utf16(&text, &mut problems);
        let found: Vec<(u32, u32, u32)> = problems
            .iter()
            .filter_map(|problem| {
                Some((
                    problem.line,
                    problem.span.start,
                    problem.cure.as_ref()?.span.end,
                ))
            })
            .collect();
        assert_eq!(found, [(1, 10, 12), (1, 16, 18)]);
    }
}
