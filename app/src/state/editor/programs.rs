//! Two programs, the editor's and the controller's: what was sent, and in what they differ.

use std::collections::BTreeMap;

use motionbench_core::catalog::Kind;
use motionbench_core::controller::Revision;
use motionbench_core::language::HighlightClass;

use super::lines::Moved;
use crate::state::order::in_order;

/// A text on its way to the controller.
#[derive(Debug, Clone)]
pub struct Sent {
    /// As it was when it was sent.
    pub text: String,
    /// Where its lines are now.
    pub places: Moved,
}

/// A text that the controller has.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// As it was when it was sent.
    pub text: String,
    /// Where its lines are now.
    pub places: Moved,
    /// What the controller made of it.
    pub revision: Revision,
}

impl Sent {
    /// All of a text.
    pub fn new(text: &str) -> Sent {
        Sent {
            text: text.to_owned(),
            places: Moved::none(text),
        }
    }
}

impl Loaded {
    /// What was sent, once the controller has taken it.
    pub fn new(sent: Sent, revision: Revision) -> Loaded {
        Loaded {
            text: sent.text,
            places: sent.places,
            revision,
        }
    }

    /// The lines of the controller that are at these lines of the text now; both in order.
    pub fn device_lines(&self, places: &[u32]) -> Vec<u32> {
        let lines = self.revision.lines.iter().zip(self.places.all());
        let there = lines.filter_map(|(&device, &place)| {
            let (device, place) = (device?, place?);
            let counts = places.binary_search(&place).is_ok() && self.place(device) == Some(place);
            counts.then_some(device)
        });
        in_order(there)
    }

    /// Where a line of the controller is in the text now. Of two with the same number the later counts.
    pub fn place(&self, device_line: u32) -> Option<u32> {
        let lines = self.revision.lines.iter().zip(self.places.all());
        let (_, place) = lines
            .rev()
            .find(|(device, _)| **device == Some(device_line))?;
        *place
    }
}

/// A line in which the two programs differ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The controller's number of the line.
    pub number: u32,
    /// What the editor has there.
    pub editor: Option<String>,
    /// What the controller has there.
    pub controller: Option<String>,
}

/// The lines in which a listing of the controller differs from a text, in the order of their numbers. Blanks, and for
/// some controllers the case of letters, count only in texts; comments only where the controller keeps them.
pub fn differences(kind: &Kind, text: &str, listing: &str) -> Vec<Difference> {
    let (editor, controller) = (numbered(kind, text), numbered(kind, listing));
    let mut all = controller.clone();
    all.extend(editor.iter().map(|(&number, &line)| (number, line)));
    let line = |program: &BTreeMap<u32, Line>, number| {
        program.get(&number).map(|line| line.text.to_owned())
    };
    all.into_keys()
        .filter(
            |number| match (editor.get(number), controller.get(number)) {
                (Some(ours), Some(theirs)) => !same(kind, ours.text, theirs.text, |_| true),
                _ => true,
            },
        )
        .map(|number| Difference {
            number,
            editor: line(&editor, number),
            controller: line(&controller, number),
        })
        .collect()
}

/// For lines of an old text, the lines of a new one that are the same lines of the controller: those in the same order
/// if the new text is the old one renumbered, otherwise those of the same number.
pub fn same_lines(kind: &Kind, old: &str, new: &str) -> Moved {
    let lines = old.split('\n').count();
    let (old, new) = (numbered(kind, old), numbered(kind, new));
    let but_numbers = |class| !matches!(class, HighlightClass::LineNumber | HighlightClass::Number);
    let in_order = || old.values().zip(new.values());
    let renumbered = old.len() == new.len()
        && in_order().all(|(old, new)| same(kind, old.text, new.text, but_numbers));
    if renumbered {
        return Moved::to(lines, in_order().map(|(old, new)| (old.place, new.place)));
    }
    if !kind.text.numbered {
        return Moved::to(lines, at_both_ends(kind, &old, &new));
    }
    let kept = |(number, old): (&u32, &Line)| Some((old.place, new.get(number)?.place));
    Moved::to(lines, old.iter().filter_map(kept))
}

/// The lines that are equal from the start on, and from the end back.
fn at_both_ends(
    kind: &Kind,
    old: &BTreeMap<u32, Line>,
    new: &BTreeMap<u32, Line>,
) -> Vec<(u32, u32)> {
    let equal = |(old, new): &(&Line, &Line)| same(kind, old.text, new.text, |_| true);
    let places = |(old, new): (&Line, &Line)| (old.place, new.place);
    let start = old.values().zip(new.values()).take_while(equal);
    let mut kept: Vec<(u32, u32)> = start.map(places).collect();
    let rest = old.len().min(new.len()) - kept.len();
    let end = old.values().rev().zip(new.values().rev());
    kept.extend(end.take(rest).take_while(equal).map(places));
    kept
}

/// A line of a program.
#[derive(Clone, Copy)]
struct Line<'a> {
    /// Its line in the text.
    place: u32,
    text: &'a str,
}

/// The lines of a program by their numbers, as the controller sorts them. Of two with the same number the later counts,
/// and a number alone deletes.
fn numbered<'a>(kind: &Kind, text: &'a str) -> BTreeMap<u32, Line<'a>> {
    let mut lines = BTreeMap::new();
    let numbers = (kind.text.device_lines)(text);
    for ((place, text), number) in (0u32..).zip(text.split('\n')).zip(numbers) {
        let Some(number) = number else { continue };
        if kind.text.numbered && (kind.highlight)(text).len() == 1 {
            lines.remove(&number);
        } else {
            lines.insert(number, Line { place, text });
        }
    }
    lines
}

/// Whether two lines have the same parts, of the classes that `count`.
fn same(kind: &Kind, one: &str, other: &str, counts: fn(HighlightClass) -> bool) -> bool {
    if one == other {
        return true;
    }
    let parts = |line: &str| {
        let is_kept = |class| kind.text.keeps_comments || class != HighlightClass::Comment;
        let parts = (kind.highlight)(line)
            .into_iter()
            .filter(|part| counts(part.class) && is_kept(part.class));
        let words = parts.map(|part| {
            let range = part.span.range();
            let word: String = line.chars().skip(range.start).take(range.len()).collect();
            if kind.text.ignores_case && part.class != HighlightClass::Text {
                word.to_ascii_uppercase()
            } else {
                word
            }
        });
        words.collect::<Vec<String>>()
    };
    parts(one) == parts(other)
}

#[cfg(test)]
mod tests {
    use motionbench_core::catalog::kind;

    use super::*;

    const NONE: [u32; 0] = [];

    fn differ(text: &str, listing: &str) -> Vec<u32> {
        let found = differences(kind("mc600").unwrap(), text, listing);
        found
            .into_iter()
            .map(|difference| difference.number)
            .collect()
    }

    #[test]
    fn lines_without_numbers_are_counted() {
        let kind = kind("smartmotor").unwrap();
        let text = "'OUT\nP=1000 G   'GO\n\nTWAIT\na=1\nEND";
        let differ = |listing| differences(kind, text, listing).len();
        assert_eq!(differ("P=1000 G\nTWAIT\na=1\nEND\n"), 0);
        assert_eq!(differ("P=1000 G\nTWAIT\nA=1\nEND\n"), 1);
        assert_eq!(differ("P=1000 G\nTWAIT\nEND\n"), 2);
        let longer = "V=1\nP=1000 G\nTWAIT\na=1\nEND";
        let moved = same_lines(kind, text, longer);
        let places = [None, Some(1), None, Some(2), Some(3), Some(4)];
        assert_eq!(moved.all(), places);
    }

    #[test]
    fn what_the_controller_writes_otherwise_is_no_difference() {
        let text = "\n10 print \"a b\"\n  20   goto 10 : rem Yes";
        assert_eq!(
            differ(text, "10 PRINT \"a b\"\n20   GOTO 10 : REM yes\n"),
            NONE
        );
        assert_eq!(
            differ(text, "10 PRINT \"A b\"\n20   GOTO 10 : REM Yes"),
            [10]
        );
        assert_eq!(differ("10 END\n10 STOP\n20 END\n20", "10 STOP"), NONE);
    }

    #[test]
    fn a_difference_shows_both_sides() {
        let kind = kind("mc600").unwrap();
        let found = differences(kind, "10 A=1\n20 B=2\n30 C=3", "10 A=1\n20 B=5\n40 D=4\n");
        let both = |number, editor: &str, controller: &str| Difference {
            number,
            editor: (!editor.is_empty()).then(|| editor.to_owned()),
            controller: (!controller.is_empty()).then(|| controller.to_owned()),
        };
        let expected = [
            both(20, "20 B=2", "20 B=5"),
            both(30, "30 C=3", ""),
            both(40, "", "40 D=4"),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_renumbered_program_has_its_lines_in_order() {
        let kind = kind("mc600").unwrap();
        let old = "10 A=1\n15 B=2\n20 GOTO 15";
        let moved = |new| same_lines(kind, old, new).all().to_vec();
        let renumbered = moved("10 A=1\n20 B=2\n30 GOTO 20");
        assert_eq!(renumbered, [Some(0), Some(1), Some(2)]);
        // Not the same program: by number.
        assert_eq!(moved("10 A=1\n20 GOTO 15"), [Some(0), None, Some(1)]);
        assert_eq!(moved("5 X=1\n10 A=1\n20 PRINT"), [Some(1), None, Some(2)]);
    }
}
