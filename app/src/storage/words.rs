//! What is said of kept work.

use std::fmt;

use super::{Fault, Keeping, Persistence};
use crate::clock;
use crate::state::project::LARGEST;

impl Keeping {
    /// For the status line.
    pub fn words(&self) -> String {
        match self {
            Keeping::Opening => String::new(),
            Keeping::Unchanged => "saved".to_owned(),
            Keeping::Changed => "saving".to_owned(),
            Keeping::Kept(at_ms) => format!("saved {}", clock::time_of_day(*at_ms)),
            Keeping::ReadOnly | Keeping::Freed => "read-only".to_owned(),
            Keeping::Failed(_) => "not saved".to_owned(),
        }
    }

    /// What the user must know and do, where there is something.
    pub fn notice(&self) -> Option<String> {
        match self {
            Keeping::ReadOnly => Some(Fault::Elsewhere.to_string()),
            Keeping::Freed => {
                Some("The other tab has closed the project: reload to work on it here.".to_owned())
            }
            Keeping::Failed(fault) => Some(fault.to_string()),
            _ => None,
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Refused => f.write_str(
                "This browser does not let the page keep your work: export it to a file before you close the page.",
            ),
            Fault::Full => f.write_str(
                "The browser has no more room to keep your work: export it to a file, then free some room.",
            ),
            Fault::TooLarge => write!(
                f,
                "The project is larger than {} MB and is not kept any more: export it to a file, then shorten it.",
                LARGEST >> 20
            ),
            Fault::Unreadable(error) => write!(
                f,
                "{error} It stays as it is, and nothing else is kept until you start over."
            ),
            Fault::Closed => f.write_str(
                "The browser has closed its store, so your work is not kept now: it is tried again.",
            ),
            Fault::Elsewhere => {
                f.write_str("This project is open in another tab: here it is read-only.")
            }
            Fault::Gone => f.write_str("This version is not kept any more."),
        }
    }
}

impl Persistence {
    /// What the user is told of it.
    pub fn words(self) -> &'static str {
        match self {
            Persistence::Unasked => "",
            Persistence::UntilDeleted => "Your work is kept in this browser until you delete it.",
            Persistence::WhileThereIsRoom => {
                "Your work is kept in this browser, which may delete it when it runs out of room: export what matters."
            }
        }
    }
}
