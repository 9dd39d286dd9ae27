//! The console's password: asked for at power-up, changed by PASSWORD ("Installation", PASSWORD).

use super::console::{DELETE, Echo};
use super::firmware::{ErrorCode, LINE_LENGTH};
use super::{Mc600, Mode};

/// The password of a new card (Installation).
pub const FACTORY: &[u8] = b"PASSWORD";

/// What PASSWORD asks for.
#[derive(Debug, Clone, PartialEq)]
pub enum Question {
    /// The password that there is.
    Old,
    /// A new one.
    New,
    /// The new one, which was this, a second time.
    Again(Vec<u8>),
}

impl Question {
    fn words(&self) -> &'static str {
        match self {
            Question::Old => "PASSWORD? ",
            Question::New => "NEW PASSWORD? ",
            Question::Again(_) => "NEW PASSWORD AGAIN? ",
        }
    }
}

/// Whether these bytes can be typed as a password.
pub fn is_password(typed: &[u8]) -> bool {
    let is_typed = |byte: &u8| *byte >= b' ' && *byte != DELETE;
    (1..=LINE_LENGTH).contains(&typed.len()) && typed.iter().all(is_typed)
}

impl Mc600 {
    /// Whether the password is asked for at power-up where no application is named (D233).
    pub(super) fn is_locked(&self) -> bool {
        self.locked.unwrap_or(self.password != FACTORY)
    }

    /// The power-up password (Installation; D40).
    pub(super) fn unlock(&mut self, asked: bool) -> bool {
        if !asked {
            self.ask("PASSWORD? ");
            self.mode = Mode::Locked { asked: true };
            return true;
        }
        let Some(typed) = self.console.take_line() else {
            return false;
        };
        if !typed.too_long && typed.text == self.password {
            self.end_questions();
        } else {
            self.mode = Mode::Locked { asked: false };
        }
        true
    }

    /// PASSWORD. What runs is over, as with AUTO.
    pub(super) fn ask_for_password(&mut self) {
        self.finish();
        self.mode = Mode::Password {
            question: Question::Old,
            asked: false,
        };
    }

    /// Asks for the old password and twice for the new one; whatever is wrong, the old one stays (D232).
    pub(super) fn change_password(&mut self) -> bool {
        let Mode::Password { question, asked } = &self.mode else {
            return false;
        };
        let question = question.clone();
        if !asked {
            self.ask(question.words());
            self.mode = Mode::Password {
                question,
                asked: true,
            };
            return true;
        }
        let Some(typed) = self.console.take_line() else {
            return false;
        };
        let right = !typed.too_long
            && match &question {
                Question::Old => typed.text == self.password,
                Question::New => is_password(&typed.text),
                Question::Again(new) => typed.text == *new,
            };
        let next = match question {
            _ if !right => None,
            Question::Old => Some(Question::New),
            Question::New => Some(Question::Again(typed.text)),
            Question::Again(new) => {
                self.password = new;
                None
            }
        };
        match next {
            Some(question) => {
                self.mode = Mode::Password {
                    question,
                    asked: false,
                };
            }
            None => self.end_questions(),
        }
        if !right {
            self.report(ErrorCode::IllegalQuantity, None);
        }
        self.charge_a_line();
        true
    }

    /// Back to the prompt, where what is typed can be read.
    pub(super) fn end_questions(&mut self) {
        self.console.echo = Echo::Plain;
        self.finish();
    }

    /// A password is answered by stars.
    fn ask(&mut self, words: &str) {
        self.on_new_line(words);
        self.console.echo = Echo::Stars;
    }
}
