//! What goes to the controller's console and what comes from it: typed, pasted, sent from a file, kept for a file.

use leptos::prelude::*;
use motionbench_core::controller::TerminalSettings;
use motionbench_core::serial::LineSettings;

use super::Store;
use super::terminal::capture::Capture;
use super::terminal::outbox::{Outbox, Progress};
use super::words;
use crate::protocol::{Frame, Pace, ToWorker};

/// The console's part of the state. A handle, as [`Store`] is.
#[derive(Clone, Copy)]
pub struct Console {
    /// How far what is sent is.
    pub sending: RwSignal<Option<Progress>>,
    /// Bytes that have been kept for a file; `None` while nothing is kept.
    pub captured: RwSignal<Option<usize>>,
    /// What the terminal has to say of itself.
    pub said: RwSignal<Option<String>>,
    outbox: StoredValue<Outbox>,
    capture: StoredValue<Capture>,
}

impl Default for Console {
    fn default() -> Console {
        Console {
            sending: RwSignal::new(None),
            captured: RwSignal::new(None),
            said: RwSignal::new(None),
            outbox: StoredValue::new(Outbox::default()),
            capture: StoredValue::new(Capture::default()),
        }
    }
}

impl Store {
    /// Sends characters to the console, behind those that wait.
    pub fn type_text(&self, text: String) {
        if text.is_empty() {
            return;
        }
        let mut fits = true;
        let outbox = self.console.outbox;
        let at_once = outbox.try_update_value(|outbox| {
            fits = outbox.has_room(&text);
            outbox.add(text)
        });
        if !fits {
            self.say("That is more than can be sent: only the first 4 million characters are.");
        }
        match at_once.flatten() {
            Some(text) => self.send(ToWorker::Send(text)),
            None => self.feed_worker(),
        }
    }

    /// Sends the text of a file to the console.
    pub fn send_file(&self, name: &str, text: &str, pace: Pace) {
        let outbox = self.console.outbox;
        outbox.update_value(|outbox| outbox.add_file(name, text, pace));
        self.feed_worker();
    }

    /// Sets the terminal's end of the line.
    pub fn set_line(&self, settings: LineSettings) {
        self.device.update(|device| device.line = Some(settings));
        self.send(ToWorker::Line(settings));
    }

    /// What the terminal does besides what the line does.
    pub fn terminal_settings(&self) -> TerminalSettings {
        let kind = self.kind();
        self.terminal_settings.get().unwrap_or(kind.terminal)
    }

    /// Sets that; `None` is what suits the controller best.
    pub fn set_terminal(&self, settings: Option<TerminalSettings>) {
        let usual = untrack(|| self.kind().terminal);
        let settings = settings.filter(|settings| *settings != usual);
        self.terminal_settings.set(settings);
        self.send(ToWorker::Terminal(settings.unwrap_or(usual)));
    }

    /// Forgets what has not been sent.
    pub fn cancel_sending(&self) {
        self.send(ToWorker::Cancel);
    }

    /// Keeps what arrives from now on.
    pub fn start_capture(&self) {
        self.console.capture.set_value(Capture::default());
        self.console.captured.set(Some(0));
    }

    /// Ends that; returns what has been kept.
    pub fn end_capture(&self) -> String {
        self.console.captured.set(None);
        let capture = self.console.capture.try_update_value(std::mem::take);
        let capture = capture.unwrap_or_default();
        if capture.is_full() {
            let kept = words::number(capture.text().len() as f64, 0);
            self.say(&format!(
                "More arrived than could be kept: the file has the first {kept} characters."
            ));
        }
        capture.into_text()
    }

    /// Has the terminal say something of itself.
    pub fn say(&self, words: &str) {
        self.console.said.set(Some(words.to_owned()));
    }

    /// What the worker is asked to do may make what waits pointless.
    pub(super) fn before_sending(&self, message: &ToWorker) {
        use ToWorker::{Cancel, Load, Power, Run, Stop};
        if matches!(message, Cancel | Load { .. } | Power(_) | Run | Stop) {
            self.console.outbox.update_value(Outbox::clear);
            self.console.sending.set(None);
        }
    }

    /// What a frame brings from the console, and what it says of the way there.
    pub(super) fn hear_console(&self, frame: &Frame) {
        if self.console.captured.with_untracked(Option::is_some) && !frame.console.is_empty() {
            let kept = self.console.capture.try_update_value(|capture| {
                capture.take(&frame.console);
                capture.text().len()
            });
            self.console.captured.set(kept);
        }
        self.give(frame.pending);
    }

    fn feed_worker(&self) {
        let pending = self.device.with_untracked(|device| device.pending);
        self.give(pending);
    }

    /// Gives the worker the next portion, when so many characters wait there.
    fn give(&self, pending: usize) {
        let given = self
            .console
            .outbox
            .try_update_value(|outbox| (outbox.progress(pending), outbox.portion(pending)));
        let Some((progress, portion)) = given else {
            return;
        };
        if self
            .console
            .sending
            .with_untracked(|told| *told != progress)
        {
            self.console.sending.set(progress);
        }
        if let Some(portion) = portion {
            self.send(portion);
        }
    }
}
