//! What a person is told of a controller before it runs: options, inputs and lamps, its face, how it keeps text.

/// An option of a kind of controller.
#[derive(Debug, Clone, Copy)]
pub struct Opt {
    /// Its key.
    pub key: &'static str,
    /// What it may be, and what it is without being given.
    pub help: &'static str,
}

/// A disk, for people.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DiskInfo {
    /// What stands before the names of its files: `B:`.
    pub prefix: &'static str,
    /// What it is, and what becomes of it without power.
    pub words: &'static str,
}

/// What a controller makes of the text of a program that it is given.
#[derive(Debug, Clone, Copy)]
pub struct TextRules {
    /// Its lines have numbers that stand in the text.
    pub numbered: bool,
    /// Capital and small letters are the same, but in texts.
    pub ignores_case: bool,
    /// Comments are kept with the program.
    pub keeps_comments: bool,
    /// What a controller lists that has no program.
    pub empty: &'static str,
    /// For each line of a text, parted by line feeds: the controller's own line that it becomes.
    pub device_lines: fn(&str) -> Vec<Option<u32>>,
}

/// What a terminal does besides what the line does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct TerminalSettings {
    /// Shows what is sent, for a controller that does not echo it.
    pub local_echo: bool,
    /// Goes to a new line at a CR, for a controller that sends no line feed behind it.
    pub line_feeds: bool,
}

/// Something outside that a person sets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wired {
    /// What stands beside it, where there is little room: `3`.
    pub label: &'static str,
    /// For people: `Input 3`.
    pub name: &'static str,
    /// As one of [`super::ControllerInfo::wires`].
    pub wire: &'static str,
    /// What can be done with it.
    pub handle: Handle,
    /// How it stands on a new bench.
    pub at: f64,
}

/// How something is set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Handle {
    /// 0 or 1.
    Switch,
    /// Any value of a range.
    Knob(Range),
    /// A switch between the ends of a range, and any value between them.
    Pin(Range),
    /// Pushed by one of these at a time; it has no value that stays.
    Jog(&'static [f64]),
}

/// What a knob can be turned to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The lowest value.
    pub from: f64,
    /// The highest value.
    pub to: f64,
    /// From one value to the next.
    pub step: f64,
    /// For people: `V`.
    pub unit: &'static str,
}

/// Lamps that a recorded signal lights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lamps {
    /// Its name in the controller's signals.
    pub signal: &'static str,
    /// The labels of its bits, the lowest first.
    pub labels: &'static [&'static str],
    /// The signal of the pulse that says that they are set anew, where there is one.
    pub strobe: Option<&'static str>,
}

/// What a person meets at a controller that is a device of its own: what its [`super::Panel`] does not tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// The keys of its front panel.
    pub keys: &'static [Keycap],
    /// The switches and jumpers that are set while it is off.
    pub settings: &'static [Setting],
    /// The joystick at its connector.
    pub joystick: Joystick,
    /// The wire of the selector, where several units share the front panel: as [`super::ControllerInfo::panel_selector`].
    pub selector: &'static str,
    /// How a newcomer gets from the first key to a motion: keys by what is printed on them, and what they do.
    pub steps: &'static [(&'static str, &'static str)],
}

/// A key and what is printed on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keycap {
    /// As one of [`super::ControllerInfo::keys`].
    pub key: &'static str,
    /// For people: `Edit`; empty where the legend says it.
    pub name: &'static str,
    /// What it means by itself, and behind SHIFT; empty where it means nothing else.
    pub legends: (&'static str, &'static str),
    /// What it types in a message, by itself and behind SHIFT, where its legends do not say it.
    pub message: (&'static str, &'static str),
}

/// A joystick: two wires that spring back to 0, and a button.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joystick {
    /// The wires of its directions, positive to the right and up, and the wire of its button.
    pub wires: [&'static str; 3],
    /// What a direction gives when it is pushed to its end.
    pub most: f64,
}

/// A switch or jumper, or several that are set together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// What it is kept by.
    pub key: &'static str,
    /// For people: `Device address`.
    pub name: &'static str,
    /// Where it is found, and what it is for.
    pub place: &'static str,
    /// How it can stand.
    pub choices: Choices,
}

/// How a [`Setting`] can stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choices {
    /// For people, and as the kind's options; the first is how it comes, without any.
    Words(&'static [(&'static str, &'static str)]),
    /// A number in binary switches, the highest first, each of which is off for a 1.
    Binary(Binary),
}

/// A number in binary switches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Binary {
    /// The number of the first switch, as printed beside it.
    pub first: u8,
    /// How many switches there are.
    pub switches: u8,
    /// What all switches on mean.
    pub from: u8,
    /// The greatest number that is used.
    pub to: u8,
    /// How it comes.
    pub at: u8,
}

/// One step of a newcomer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FirstStep {
    /// A line for the console, and what it does.
    Type(&'static str, &'static str),
    /// The mains switch goes off and on.
    PowerCycle,
}
