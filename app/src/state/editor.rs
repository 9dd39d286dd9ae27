//! The program that the user edits, its breakpoints, and how it stands to the controller's own.

use motionbench_core::catalog::Kind;
use motionbench_core::controller::Revision;
use motionbench_core::language::{Diagnostic, Severity, Span};

pub mod lines;
pub mod programs;

use super::order::in_order;
use super::words;
use lines::{Edit, Moved};
use programs::{Difference, Loaded, Sent};

/// Characters of a text that is checked while it is typed: more than a program has, and checked within two frames.
const MOST_CHECKED: usize = 250_000;

/// Problems that are told at a time.
pub const MOST_PROBLEMS: usize = 200;

/// The editor's program. Its lines are counted from 0; the controller's lines are called by its own numbers.
#[derive(Debug, Clone)]
pub struct EditorState {
    kind: &'static Kind,
    text: String,
    opens: u64,
    takes: u64,
    /// In order, each once.
    breakpoints: Vec<u32>,
    running: Option<u32>,
    sent: Option<Sent>,
    loaded: Option<Loaded>,
    /// The text is not the one that was loaded.
    changed: bool,
    controller: Option<Known>,
}

/// What the page knows of the controller's program.
#[derive(Debug, Clone)]
struct Known {
    revision: u64,
    /// `None` until the controller has told it.
    listing: Option<String>,
}

/// How the editor's program stands to the controller's.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Agreement {
    /// The controller's program is not known yet.
    Unknown,
    /// The controller has no program.
    NotLoaded,
    /// The controller has what the editor shows.
    Same,
    /// The text has changed since the controller got it.
    EditorChanged,
    /// The controller's program did not come from here: neither may replace the other unasked.
    ControllerDiffers,
}

/// What became of the wish for a breakpoint or against one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Toggled {
    /// There is one now.
    Set,
    /// There is none any more.
    Cleared,
    /// There is nothing in the line that could run.
    Blank,
}

impl Agreement {
    /// For people; nothing while there is nothing to say.
    pub fn words(self) -> &'static str {
        match self {
            Agreement::Unknown => "",
            Agreement::NotLoaded => "not in the controller",
            Agreement::Same => "same as in the controller",
            Agreement::EditorChanged => "changed since it was loaded",
            Agreement::ControllerDiffers => "controller differs",
        }
    }
}

impl EditorState {
    /// An editor for programs of one kind of controller.
    pub fn new(kind: &'static Kind, text: &str) -> EditorState {
        EditorState {
            kind,
            text: lines::with_line_feeds(text),
            opens: 0,
            takes: 0,
            breakpoints: Vec::new(),
            running: None,
            sent: None,
            loaded: None,
            changed: false,
            controller: None,
        }
    }

    /// From now on the editor is for programs of another kind of controller; a text is to be opened next.
    pub fn change_kind(&mut self, kind: &'static Kind) {
        let (opens, takes) = (self.opens, self.takes);
        *self = EditorState {
            opens,
            takes,
            ..EditorState::new(kind, "")
        };
    }

    /// The kind of controller that the program is for.
    pub fn kind(&self) -> &'static Kind {
        self.kind
    }

    /// The text, its lines parted by line feeds.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What the controller would say to the text, and what else can be said about it: the first [`MOST_PROBLEMS`].
    /// Places are counted as the editor counts, in UTF-16.
    pub fn problems(&self) -> Vec<Diagnostic> {
        if self.text.len() > MOST_CHECKED {
            return vec![too_long()];
        }
        let mut problems = (self.kind.diagnose)(&self.text);
        problems.truncate(MOST_PROBLEMS);
        lines::count_in_utf16(&self.text, &mut problems);
        problems
    }

    /// Begins with another text, which has nothing to do with this one, and its breakpoints. A program that the
    /// controller got from here stays one that may be replaced.
    pub fn open(&mut self, text: &str, breakpoints: impl IntoIterator<Item = u32>) {
        let text = lines::with_line_feeds(text);
        let mut loaded = self.loaded_now().cloned();
        if let Some(loaded) = &mut loaded {
            loaded.places = if loaded.text == text {
                Moved::none(&text)
            } else {
                Moved::all_gone()
            };
        }
        *self = EditorState {
            opens: self.opens + 1,
            takes: self.takes,
            breakpoints: in_order(breakpoints),
            running: self.running,
            loaded,
            controller: self.controller.take(),
            ..EditorState::new(self.kind, &text)
        };
        self.agree_with_listing();
        self.compare_with_loaded();
    }

    /// Grows when another text is begun with: then the editor must forget what was undone.
    pub fn opens(&self) -> u64 {
        self.opens
    }

    /// The user changed the text; `edits` go from the last place of the text to the first.
    pub fn edit(&mut self, text: String, edits: &[Edit]) {
        self.text = text;
        for edit in edits {
            let moved = |line: &u32| edit.moved(*line);
            self.breakpoints = in_order(self.breakpoints.iter().filter_map(moved));
            if let Some(sent) = &mut self.sent {
                sent.places.follow(edit);
            }
            if let Some(loaded) = &mut self.loaded {
                loaded.places.follow(edit);
            }
        }
        self.compare_with_loaded();
    }

    /// Puts another text in place of this one. Breakpoints stay with the controller's lines that they were at.
    pub fn take(&mut self, text: &str) {
        let text = lines::with_line_feeds(text);
        let moved = programs::same_lines(self.kind, &self.text, &text);
        let place = |&line: &u32| moved.place(line);
        self.breakpoints = in_order(self.breakpoints.iter().filter_map(place));
        if let Some(sent) = &mut self.sent {
            sent.places.follow_all(&moved);
        }
        if let Some(loaded) = &mut self.loaded {
            loaded.places.follow_all(&moved);
        }
        self.text = text;
        self.takes += 1;
        self.agree_with_listing();
        self.compare_with_loaded();
    }

    /// Grows when the text is replaced by [`EditorState::take`]: then the editor must show it.
    pub fn takes(&self) -> u64 {
        self.takes
    }

    /// What to call a line of the text: by its number where it has one.
    pub fn line_name(&self, line: u32) -> String {
        let number = self
            .line(line)
            .and_then(|text| lines::written_number(self.kind, text));
        match number {
            Some(number) => number.to_string(),
            None => format!("line {}", line + 1),
        }
    }

    /// What to call a line of the controller: by its number, or by where it stands in the text.
    pub fn device_line_name(&self, device_line: u32) -> String {
        match self.document_line(device_line) {
            Some(line) if !self.kind.text.numbered => format!("line {}", line + 1),
            _ => format!("line {device_line}"),
        }
    }

    /// Sets a breakpoint or clears it.
    pub fn toggle_breakpoint(&mut self, line: u32) -> Toggled {
        let place = match self.breakpoints.binary_search(&line) {
            Ok(place) => {
                self.breakpoints.remove(place);
                return Toggled::Cleared;
            }
            Err(place) => place,
        };
        let text = self.line(line).unwrap_or_default();
        if (self.kind.highlight)(text).is_empty() {
            return Toggled::Blank;
        }
        self.breakpoints.insert(place, line);
        Toggled::Set
    }

    /// Lines of the text with a breakpoint, in order.
    pub fn breakpoints(&self) -> Vec<u32> {
        self.breakpoints.clone()
    }

    /// The breakpoints as lines of the program that the controller has; none if that is not the editor's.
    pub fn breakpoints_as_device_lines(&self) -> Vec<u32> {
        let loaded = self.loaded_now();
        loaded.map_or(Vec::new(), |loaded| loaded.device_lines(&self.breakpoints))
    }

    /// The text is on its way to the controller: returns the lines of it at which the controller is to stop.
    pub fn send(&mut self) -> Vec<u32> {
        self.sent = Some(Sent::new(&self.text));
        let lines = (0..).zip((self.kind.text.device_lines)(&self.text));
        let held = lines.filter(|(line, _)| self.breakpoints.binary_search(line).is_ok());
        in_order(held.filter_map(|(_, device)| device))
    }

    /// The controller has taken what was sent.
    pub fn loaded(&mut self, revision: Revision) {
        let Some(sent) = self.sent.take() else {
            return;
        };
        self.controller = Some(Known {
            revision: revision.number,
            listing: None,
        });
        self.loaded = Some(Loaded::new(sent, revision));
        self.compare_with_loaded();
    }

    /// The controller refused what was sent.
    pub fn refused(&mut self) {
        self.sent = None;
        // What was heard of another program meanwhile was let pass.
        self.controller = None;
    }

    /// The controller begins anew, and counts its revisions from the start: what it has is not known any more.
    pub fn forget_controller(&mut self) {
        (self.sent, self.loaded, self.controller) = (None, None, None);
        self.running = None;
    }

    /// Whether the controller's program and its running line are as they were when last heard of.
    pub fn hears_nothing_new(&self, revision: u64, running: Option<u32>) -> bool {
        let known = self.controller.as_ref().map(|known| known.revision);
        known == Some(revision) && self.running == running
    }

    /// The controller's program is of this revision; returns whether its listing is wanted.
    pub fn heard_revision(&mut self, revision: u64) -> bool {
        let known = self.controller.as_ref().map(|known| known.revision) == Some(revision);
        if !known {
            self.controller = Some(Known {
                revision,
                listing: None,
            });
        }
        !known && self.sent.is_none() && self.loaded_now().is_none()
    }

    /// The controller's program of a revision. Where it is the same as the editor's, the two agree from now on.
    pub fn heard_listing(&mut self, revision: u64, listing: &str) {
        if self.sent.is_some() {
            return;
        }
        self.controller = Some(Known {
            revision,
            listing: Some(lines::with_line_feeds(listing)),
        });
        self.agree_with_listing();
        self.compare_with_loaded();
    }

    /// How the editor's program stands to the controller's.
    pub fn agreement(&self) -> Agreement {
        let Some(known) = &self.controller else {
            return Agreement::Unknown;
        };
        match (self.loaded_now(), &known.listing) {
            (Some(_), _) if self.changed => Agreement::EditorChanged,
            (Some(_), _) => Agreement::Same,
            (None, None) => Agreement::Unknown,
            (None, Some(listing)) if self.is_empty(listing) => Agreement::NotLoaded,
            (None, Some(_)) => Agreement::ControllerDiffers,
        }
    }

    /// The controller's program, where it is known and did not come from here.
    pub fn listing(&self) -> Option<&str> {
        self.controller.as_ref()?.listing.as_deref()
    }

    /// In which lines the controller's program differs; empty unless it did not come from here.
    pub fn differences(&self) -> Vec<Difference> {
        let listing = self.listing();
        listing.map_or_else(Vec::new, |listing| {
            programs::differences(self.kind, &self.text, listing)
        })
    }

    /// The controller's line that runs, as it says; returns whether that is news.
    pub fn set_running(&mut self, device_line: Option<u32>) -> bool {
        let news = self.running != device_line;
        self.running = device_line;
        news
    }

    /// The line of the text that runs: where the loaded line stands now, if the controller runs what came from here.
    pub fn running(&self) -> Option<u32> {
        self.document_line(self.running?)
    }

    /// Where a line of the controller's program stands in the text, if it came from here and is still there.
    pub fn document_line(&self, device_line: u32) -> Option<u32> {
        self.loaded_now()?.place(device_line)
    }

    /// Whether a listing is that of a controller without a program.
    fn is_empty(&self, listing: &str) -> bool {
        listing.trim_end() == self.kind.text.empty
    }

    fn line(&self, line: u32) -> Option<&str> {
        self.text.split('\n').nth(usize::try_from(line).ok()?)
    }

    /// What was loaded from here, as long as the controller still has it.
    fn loaded_now(&self) -> Option<&Loaded> {
        let revision = self.controller.as_ref()?.revision;
        self.loaded
            .as_ref()
            .filter(|loaded| loaded.revision.number == revision)
    }

    /// Takes the controller's program for the editor's if there is no difference between them.
    fn agree_with_listing(&mut self) {
        let Some(known) = &self.controller else {
            return;
        };
        let listing = known.listing.as_deref().unwrap_or_default();
        if self.is_empty(listing)
            || !programs::differences(self.kind, &self.text, listing).is_empty()
        {
            return;
        }
        let revision = Revision {
            number: known.revision,
            lines: (self.kind.text.device_lines)(&self.text),
        };
        self.loaded = Some(Loaded::new(Sent::new(&self.text), revision));
    }

    fn compare_with_loaded(&mut self) {
        let loaded = self.loaded.as_ref();
        self.changed = loaded.is_some_and(|loaded| loaded.text != self.text);
    }
}

/// What is said instead of checking.
fn too_long() -> Diagnostic {
    Diagnostic {
        line: 0,
        span: Span::default(),
        severity: Severity::Warning,
        message: "LONG PROGRAM".to_owned(),
        cause: format!(
            "A text of more than {} characters is not checked here; the controller checks it.",
            words::number(MOST_CHECKED as f64, 0)
        ),
        cure: None,
    }
}

#[cfg(test)]
mod tests;
