//! What the user pasted or sends as a file, on its way to the worker: in portions, as the line takes them.

use crate::protocol::{Pace, ToWorker};

/// Characters in a portion. There is always a portion on the worker's side, so that the line never waits for the page.
const PORTION: usize = 8 << 10;
/// So few characters are typed, not sent: no one needs to see how far they are.
const TYPED: usize = 80;
/// The longest text that is sent, in characters: more than an hour of the line at 9600 baud.
pub const MOST: usize = 4 << 20;

/// What waits on the page's side.
#[derive(Debug, Default)]
pub struct Outbox {
    text: String,
    /// What the user calls it.
    name: String,
    pace: Option<Pace>,
    /// Bytes of the text that the worker has.
    given: usize,
    /// Characters of the text, and those of them that the worker has.
    total: usize,
    passed: usize,
}

/// How far it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Progress {
    /// What is sent.
    pub name: String,
    /// Characters that have been sent.
    pub sent: usize,
    /// Characters in all.
    pub total: usize,
}

impl Outbox {
    /// Takes a typed or pasted text; returns it if it need not wait here.
    pub fn add(&mut self, text: String) -> Option<String> {
        if self.is_empty() && text.len() <= TYPED {
            return Some(text);
        }
        if self.is_empty() {
            "the pasted text".clone_into(&mut self.name);
        }
        self.append(&text);
        None
    }

    /// Takes a file's text, to be sent at its pace behind what is sent already.
    pub fn add_file(&mut self, name: &str, text: &str, pace: Pace) {
        name.clone_into(&mut self.name);
        self.pace = Some(pace);
        self.append(text);
    }

    /// Whether there is room for all of a text.
    pub fn has_room(&self, text: &str) -> bool {
        text.len() <= self.room() || text.chars().count() <= self.room()
    }

    fn room(&self) -> usize {
        MOST.saturating_sub(self.total - self.passed)
    }

    fn append(&mut self, text: &str) {
        let room = self.room();
        let text = text
            .char_indices()
            .nth(room)
            .map_or(text, |(end, _)| &text[..end]);
        self.total += text.chars().count();
        self.text.push_str(text);
    }

    /// Whether all has gone to the worker, or nothing was to be sent.
    fn is_empty(&self) -> bool {
        self.given == self.text.len()
    }

    /// Forgets what waits.
    pub fn clear(&mut self) {
        *self = Outbox::default();
    }

    /// What the worker is to be given, when so many characters wait on its side.
    pub fn portion(&mut self, pending: usize) -> Option<ToWorker> {
        if self.is_empty() {
            if pending == 0 {
                self.clear();
            }
            return None;
        }
        if pending >= PORTION {
            return None;
        }
        let rest = &self.text[self.given..];
        let end = rest
            .char_indices()
            .nth(PORTION)
            .map_or(rest.len(), |(end, _)| end);
        let text = rest[..end].to_owned();
        self.given += end;
        self.passed += text.chars().count();
        Some(match self.pace {
            Some(pace) => ToWorker::SendPaced { text, pace },
            None => ToWorker::Send(text),
        })
    }

    /// How far it is, when so many characters wait on the worker's side; `None` if there is nothing to tell.
    pub fn progress(&self, pending: usize) -> Option<Progress> {
        let on_the_way = self.total > TYPED && (!self.is_empty() || pending > 0);
        on_the_way.then(|| Progress {
            name: self.name.clone(),
            sent: self.passed.saturating_sub(pending),
            total: self.total,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(message: Option<ToWorker>) -> String {
        match message {
            Some(ToWorker::Send(text) | ToWorker::SendPaced { text, .. }) => text,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn what_is_typed_goes_at_once_and_behind_a_paste() {
        let mut outbox = Outbox::default();
        assert_eq!(outbox.add("A".to_owned()).as_deref(), Some("A"));
        assert_eq!(outbox.progress(1), None);
        assert_eq!(outbox.add("\u{e9}".repeat(2 * PORTION)), None);
        assert_eq!(outbox.add("RUN\r".to_owned()), None);
        assert_eq!(text(outbox.portion(0)).chars().count(), PORTION);
        assert_eq!(outbox.portion(PORTION), None, "the line has enough to do");
        assert_eq!(text(outbox.portion(10)).chars().count(), PORTION);
        assert_eq!(text(outbox.portion(10)), "RUN\r");
    }

    #[test]
    fn a_paste_tells_how_far_it_is_until_the_line_has_sent_it() {
        let mut outbox = Outbox::default();
        outbox.add("X".repeat(1000));
        let progress =
            |outbox: &Outbox, pending| outbox.progress(pending).map(|p| (p.sent, p.total));
        assert_eq!(progress(&outbox, 0), Some((0, 1000)));
        outbox.portion(0);
        assert_eq!(progress(&outbox, 300), Some((700, 1000)));
        assert_eq!(outbox.portion(0), None);
        assert_eq!(progress(&outbox, 0), None);
        assert_eq!(outbox.add("A".to_owned()).as_deref(), Some("A"));
    }

    #[test]
    fn a_file_goes_at_its_pace_and_can_be_cancelled() {
        let mut outbox = Outbox::default();
        let pace = Pace {
            prompt: true,
            ..Pace::default()
        };
        outbox.add_file("CUT.BAS", "10 END\r", pace);
        let text = "10 END\r".to_owned();
        assert_eq!(outbox.portion(0), Some(ToWorker::SendPaced { text, pace }));
        outbox.add_file("CUT.BAS", &"10 END\r".repeat(5000), pace);
        assert_eq!(outbox.progress(7).unwrap().name, "CUT.BAS");
        outbox.clear();
        assert_eq!((outbox.portion(0), outbox.progress(5)), (None, None));
    }

    #[test]
    fn there_is_an_end_to_what_waits() {
        let mut outbox = Outbox::default();
        outbox.add("X".repeat(MOST + 5));
        outbox.add("Y".to_owned());
        assert_eq!(outbox.progress(0).unwrap().total, MOST);
    }
}
