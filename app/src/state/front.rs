//! The front panel and what belongs to it: the keys that are held, the switches and jumpers, the printer's paper.

use std::collections::{BTreeMap, VecDeque};

use motionbench_core::catalog::{self, Kind};
use motionbench_core::controller::{Binary, Choices, Setting};

use super::order::in_order;

/// What holds a key down.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Hand {
    /// A finger or the mouse, by the number that the browser gives it.
    Pointer(i32),
    /// A key of the computer, by its place on the keyboard.
    Typed(String),
}

/// The keys that are held, and by what.
#[derive(Debug, Default)]
pub struct Held(Vec<(Hand, String)>);

impl Held {
    /// A hand presses a key; returns whether the key goes down. A hand that holds one already holds on to that.
    pub fn press(&mut self, hand: Hand, key: &str) -> bool {
        if self.0.iter().any(|(holding, _)| *holding == hand) {
            return false;
        }
        let is_up = !self.is_held(key);
        self.0.push((hand, key.to_owned()));
        is_up
    }

    /// A hand lets go; returns the key that goes up.
    pub fn release(&mut self, hand: &Hand) -> Option<String> {
        let at = self.0.iter().position(|(holding, _)| holding == hand)?;
        let (_, key) = self.0.swap_remove(at);
        (!self.is_held(&key)).then_some(key)
    }

    /// All hands let go; returns the keys that go up, each once.
    pub fn release_all(&mut self) -> Vec<String> {
        in_order(self.0.drain(..).map(|(_, key)| key))
    }

    /// Whether some hand holds it.
    pub fn is_held(&self, key: &str) -> bool {
        self.0.iter().any(|(_, held)| held == key)
    }
}

/// How the switches and jumpers stand that do not stand as they came: for each its options.
pub type Settings = BTreeMap<String, String>;

/// The options that a bench is given for them.
pub fn options(settings: &Settings) -> Vec<(String, String)> {
    let words = settings.values().flat_map(|options| options.split(' '));
    let options = words.filter_map(|word| word.split_once('='));
    options
        .map(|(key, value)| (key.to_owned(), value.to_owned()))
        .collect()
}

/// Whether they are those of several units.
pub fn are_several(kind: &Kind, settings: &Settings) -> bool {
    catalog::units(kind.id, &options(settings)).is_ok_and(|units| units.len() > 1)
}

/// Whether a kind of controller can be set so.
pub fn can_be_set(kind: &Kind, settings: &Settings) -> bool {
    let known = kind.face.map_or(&[][..], |face| face.settings);
    settings.iter().all(|(key, options)| {
        let setting = known.iter().find(|setting| setting.key == key);
        setting.is_some_and(|setting| match setting.choices {
            Choices::Words(words) => words.iter().any(|(_, known)| known == options),
            Choices::Binary(binary) => number_of(key, options)
                .is_some_and(|number| (binary.from..=binary.to).contains(&number)),
        })
    })
}

/// Which of its words a setting stands at.
pub fn chosen(settings: &Settings, setting: &Setting, words: &[(&str, &str)]) -> usize {
    let options = settings.get(setting.key).map_or("", String::as_str);
    let place = words.iter().position(|(_, known)| *known == options);
    place.unwrap_or_default()
}

/// Sets it to one of its words.
pub fn choose(settings: &mut Settings, setting: &Setting, options: &str) {
    if options.is_empty() {
        settings.remove(setting.key);
    } else {
        settings.insert(setting.key.to_owned(), options.to_owned());
    }
}

/// The number that a setting stands at.
pub fn number(settings: &Settings, setting: &Setting, binary: Binary) -> u8 {
    let options = settings.get(setting.key);
    let set = options.and_then(|options| number_of(setting.key, options));
    set.unwrap_or(binary.at)
}

fn number_of(key: &str, options: &str) -> Option<u8> {
    options.strip_prefix(key)?.strip_prefix('=')?.parse().ok()
}

/// Whether a binary switch is on, `place` from 0: each is off for a 1.
pub fn is_on(binary: Binary, number: u8, place: u8) -> bool {
    number.saturating_sub(binary.from) & weight(binary, place) == 0
}

/// What a binary switch adds while it is off.
pub fn weight(binary: Binary, place: u8) -> u8 {
    1 << (binary.switches - 1 - place).min(7)
}

/// Turns a binary switch over; `false` if the number is not used, and nothing has changed.
pub fn turn(settings: &mut Settings, setting: &Setting, binary: Binary, place: u8) -> bool {
    let bits = number(settings, setting, binary).saturating_sub(binary.from);
    let turned = (bits ^ weight(binary, place)).saturating_add(binary.from);
    if turned > binary.to {
        return false;
    }
    if turned == binary.at {
        settings.remove(setting.key);
    } else {
        settings.insert(setting.key.to_owned(), format!("{}={turned}", setting.key));
    }
    true
}

/// Columns of the paper.
const COLUMNS: usize = 80;
/// Lines that the tray behind the printer holds.
const LINES: usize = 2000;

/// The printer's paper.
#[derive(Debug, Clone, Default)]
pub struct Paper {
    /// The finished lines, and how many there have been.
    lines: VecDeque<String>,
    ever: usize,
    /// The line under the head, and where the head is.
    line: Vec<char>,
    column: usize,
}

impl Paper {
    /// Prints what comes over the line.
    pub fn print(&mut self, text: &str) {
        for character in text.chars() {
            match character {
                '\r' => self.column = 0,
                '\n' => self.feed(),
                '\u{8}' => self.column = self.column.saturating_sub(1),
                '\t' => self.column = (self.column / 8 + 1) * 8,
                c if c.is_control() => {}
                c => self.strike(c),
            }
        }
    }

    /// The lines that there are, each with its number; the last may go on.
    pub fn lines(&self) -> impl Iterator<Item = (usize, String)> + '_ {
        let first = self.ever - self.lines.len();
        let last = (!self.line.is_empty()).then(|| self.line.iter().collect());
        (first..).zip(self.lines.iter().cloned().chain(last))
    }

    /// All of it.
    pub fn text(&self) -> String {
        self.lines().map(|(_, line)| line + "\n").collect()
    }

    /// Whether nothing has been printed.
    pub fn is_blank(&self) -> bool {
        self.lines.is_empty() && self.line.is_empty()
    }

    fn strike(&mut self, character: char) {
        if self.column >= COLUMNS {
            self.feed();
            self.column = 0;
        }
        if self.line.len() <= self.column {
            self.line.resize(self.column + 1, ' ');
        }
        if let Some(place) = self.line.get_mut(self.column) {
            *place = character;
        }
        self.column += 1;
    }

    fn feed(&mut self) {
        let line: String = std::mem::take(&mut self.line).into_iter().collect();
        self.lines.push_back(line.trim_end().to_owned());
        self.ever += 1;
        if self.lines.len() > LINES {
            self.lines.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use motionbench_core::catalog::kind;

    use super::*;

    fn setting(key: &str) -> &'static Setting {
        let face = kind("unidex3").unwrap().face.unwrap();
        face.settings.iter().find(|s| s.key == key).unwrap()
    }

    fn as_words(settings: &Settings) -> Vec<String> {
        let options = options(settings).into_iter();
        options
            .map(|(key, value)| format!("{key}={value}"))
            .collect()
    }

    #[test]
    fn a_key_goes_up_when_the_last_hand_lets_go() {
        let mut held = Held::default();
        let typed = || Hand::Typed("ArrowUp".to_owned());
        assert!(held.press(Hand::Pointer(1), "UP"));
        assert!(
            !held.press(Hand::Pointer(1), "DOWN"),
            "a finger has one key"
        );
        assert!(!held.press(typed(), "UP"), "it is down");
        assert!(held.press(Hand::Pointer(2), "SHIFT"));
        assert_eq!(held.release(&Hand::Pointer(1)), None);
        assert_eq!(held.release(&typed()).as_deref(), Some("UP"));
        assert_eq!(held.release(&typed()), None);
        held.press(Hand::Pointer(3), "SHIFT");
        held.press(typed(), "LEFT");
        assert_eq!(held.release_all(), ["LEFT", "SHIFT"]);
        assert!(held.release_all().is_empty());
    }

    #[test]
    fn switches_make_the_number_of_the_table() {
        let address = setting("address");
        let Choices::Binary(binary) = address.choices else {
            panic!("switches");
        };
        let mut settings = Settings::new();
        let switches = |settings: &Settings| {
            let number = number(settings, address, binary);
            (0..5)
                .map(|place| is_on(binary, number, place))
                .collect::<Vec<_>>()
        };
        assert_eq!(switches(&settings), [true, true, true, true, false]);
        for place in 0..4 {
            let unused = place == 3;
            assert_eq!(turn(&mut settings, address, binary, place), !unused);
        }
        assert_eq!(as_words(&settings), ["address=29"]);
        assert!(turn(&mut settings, address, binary, 4), "30 is the highest");
        assert!(
            turn(&mut settings, address, binary, 3) && number(&settings, address, binary) == 30
        );
        assert!(!turn(&mut settings, address, binary, 4), "31 is not used");
        assert!(can_be_set(kind("unidex3").unwrap(), &settings));
    }

    #[test]
    fn what_stands_as_it_came_is_not_kept() {
        let (drives, unidex) = (setting("configuration"), kind("unidex3").unwrap());
        let Choices::Words(words) = drives.choices else {
            panic!("words");
        };
        let mut settings = Settings::new();
        assert_eq!(chosen(&settings, drives, words), 0);
        choose(&mut settings, drives, words[4].1);
        assert_eq!(chosen(&settings, drives, words), 4);
        let expected = ["drive=stepper", "home=software", "home-y=ccw"];
        assert_eq!(as_words(&settings), expected);
        assert!(can_be_set(unidex, &settings));
        assert!(!can_be_set(kind("mc600").unwrap(), &settings));
        choose(&mut settings, drives, "");
        assert!(settings.is_empty());
        let made_up = Settings::from([("address".to_owned(), "address=31".to_owned())]);
        assert!(!can_be_set(unidex, &made_up));
    }

    #[test]
    fn paper_is_printed_on_as_a_printer_does() {
        let mut paper = Paper::default();
        assert!(paper.is_blank());
        paper.print("  ;DIRECTORY\r\n\nX:AXIS\u{3}");
        assert_eq!(paper.text(), "  ;DIRECTORY\n\nX:AXIS\n");
        paper.print("\rY\r\n");
        assert_eq!(paper.text(), "  ;DIRECTORY\n\nY:AXIS\n");
        paper.print(&"A".repeat(COLUMNS + 1));
        let lines: Vec<_> = paper.lines().collect();
        assert_eq!(lines[3].1.len(), COLUMNS);
        assert_eq!(lines[4], (4, "A".to_owned()));
        paper.print(&"\n".repeat(2 * LINES));
        assert_eq!(paper.lines().count(), LINES);
    }
}
