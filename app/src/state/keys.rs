//! What a key or a pasted text is to the controller's console.

/// A key as the browser names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Press<'a> {
    /// `Enter`, `a`, ...
    pub key: &'a str,
    /// Ctrl is down.
    pub ctrl: bool,
    /// Shift is down.
    pub shift: bool,
    /// Alt or the command key is down.
    pub other: bool,
    /// Text of the page is selected.
    pub selection: bool,
}

/// What a key does in the terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Sends this character.
    Send(char),
    /// Stops the program.
    Stop,
    /// Shows what was printed before (-1) or after (1), a page at a time.
    Scroll(i8),
    /// Is the browser's: characters come as text, Tab moves on, Ctrl-C copies what is selected.
    Leave,
}

/// What a key does in the terminal.
pub fn stroke(press: Press) -> Stroke {
    match (press.key, press.ctrl, press.other) {
        ("Enter", false, false) => Stroke::Send('\r'),
        ("Backspace", false, false) => Stroke::Send('\x08'),
        ("Delete", false, false) => Stroke::Send('\x7f'),
        ("Escape", false, false) => Stroke::Send('\x1b'),
        ("PageUp", false, false) => Stroke::Scroll(-1),
        ("PageDown", false, false) => Stroke::Scroll(1),
        ("c", true, false) if !press.selection && !press.shift => Stroke::Stop,
        _ => Stroke::Leave,
    }
}

/// What a key does wherever the keyboard is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Shortcut {
    Run,
    Stop,
    /// Simulated time stands still, or goes on.
    Pause,
    Step,
}

/// What a key does wherever the keyboard is: only keys that write nothing, that no screen reader takes, and of the
/// browser's none but the one that would throw the page away.
pub fn shortcut(press: Press) -> Option<Shortcut> {
    match (press.key, press.ctrl, press.shift, press.other) {
        ("F5", false, false, false) => Some(Shortcut::Run),
        ("F5", false, true, false) => Some(Shortcut::Stop),
        ("F2", false, false, false) => Some(Shortcut::Pause),
        ("F10", false, false, false) => Some(Shortcut::Step),
        _ => None,
    }
}

/// What a typed or pasted text sends: any line end is a carriage return; what the line cannot carry is left out.
pub fn sent(text: &str) -> String {
    text.replace("\r\n", "\r")
        .chars()
        .map(|c| if c == '\n' { '\r' } else { c })
        .filter(|&c| c <= '\u{ff}')
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(key: &str) -> Press<'_> {
        Press {
            key,
            ..Press::default()
        }
    }

    #[test]
    fn keys_that_are_not_characters_send_their_code() {
        assert_eq!(stroke(key("Enter")), Stroke::Send('\r'));
        assert_eq!(stroke(key("Backspace")), Stroke::Send('\x08'));
        assert_eq!(stroke(key("a")), Stroke::Leave);
        assert_eq!(stroke(key("ArrowUp")), Stroke::Leave);
        assert_eq!(stroke(key("Tab")), Stroke::Leave);
    }

    #[test]
    fn ctrl_c_stops_unless_it_copies() {
        let ctrl_c = Press {
            ctrl: true,
            ..key("c")
        };
        assert_eq!(stroke(ctrl_c), Stroke::Stop);
        let selection = true;
        assert_eq!(
            stroke(Press {
                selection,
                ..ctrl_c
            }),
            Stroke::Leave
        );
        let shift = true;
        assert_eq!(stroke(Press { shift, ..ctrl_c }), Stroke::Leave);
    }

    #[test]
    fn shortcuts_leave_the_browser_its_own() {
        let ctrl = true;
        let shift = true;
        assert_eq!(shortcut(key("F5")), Some(Shortcut::Run));
        assert_eq!(shortcut(Press { shift, ..key("F5") }), Some(Shortcut::Stop));
        assert_eq!(
            shortcut(Press { ctrl, ..key("F5") }),
            None,
            "loads the page again"
        );
        assert_eq!(
            shortcut(Press {
                shift,
                ..key("F10")
            }),
            None,
            "opens the menu of the thing"
        );
        assert_eq!(
            shortcut(key("F8")),
            None,
            "goes to the next problem of the program"
        );
    }

    #[test]
    fn a_paste_is_lines_of_eight_bit_characters() {
        assert_eq!(sent("10 A=1\r\n20 B=2\nRUN\r"), "10 A=1\r20 B=2\rRUN\r");
        assert_eq!(sent("\u{2192}\u{e9}\u{1f600}"), "\u{e9}");
    }
}
