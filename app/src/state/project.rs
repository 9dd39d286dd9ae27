//! A project: everything of the user's that outlives the page, and the file that it is written to.
//!
//! The browser keeps the same JSON text that a user exports. A text is written as the list of its lines, each with its
//! line end; the bytes of a device are its characters, U+0000 to U+00FF. What is read has bounds and is checked whole.

mod lines;

use std::collections::BTreeMap;
use std::fmt;

use motionbench_core::catalog::kind;
use motionbench_core::controller::{Memory, MemoryItem, TerminalSettings};
use motionbench_core::serial::LineSettings;
use serde::de::{Deserializer, IgnoredAny};
use serde::{Deserialize, Serialize, Serializer};

use super::front::{self, Settings};
use crate::protocol::Speed;

/// The newest version that is written, where it is needed: for switches and jumpers that were set. It grows when an
/// older page could not read what a newer one writes.
pub const VERSION: u32 = 3;
/// What is written for several controllers, or a terminal that was set.
const SECOND_VERSION: u32 = 2;
/// What is written otherwise.
const FIRST_VERSION: u32 = 1;
/// What a project may have as a file, in bytes: every disk full of what takes most room, and a long program.
pub const LARGEST: usize = 16 << 20;
/// How the name of its file ends.
pub const EXTENSION: &str = ".motionbench.json";

const FORMAT: &str = "motionbench project";
/// Characters in the name of a project, a panel or a file of the device.
const LONGEST_NAME: usize = 100;
/// Files of the device, breakpoints, panels.
const MOST: usize = 10_000;

/// A project.
#[derive(Debug, Clone, PartialEq)]
pub struct Project {
    /// What the user does in the page.
    pub work: Work,
    /// What the device holds.
    pub device: Device,
}

/// What the user does in the page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Work {
    /// For people, and for the name of the file.
    pub name: String,
    /// The text in the editor.
    #[serde(with = "lines")]
    pub text: String,
    /// Lines of that text, from 0, at which the program stops.
    pub breakpoints: Vec<u32>,
    /// How the terminal's end of the line is set.
    pub line: LineSettings,
    /// How fast simulated time passes.
    pub speed: Speed,
    /// How the page is laid out.
    pub layout: Layout,
    /// What the terminal does besides, if not what suits the controller best.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub terminal: Option<TerminalSettings>,
    /// How the controller's switches and jumpers stand that do not stand as they came.
    #[serde(default, skip_serializing_if = "Settings::is_empty")]
    pub settings: Settings,
    /// The work with other controllers, which are not on the bench now.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Desk>,
}

/// The work with one controller.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Desk {
    /// As [`Work::text`].
    #[serde(with = "lines")]
    pub text: String,
    /// As [`Work::breakpoints`].
    pub breakpoints: Vec<u32>,
    /// As [`Work::line`].
    pub line: LineSettings,
    /// As [`Work::terminal`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub terminal: Option<TerminalSettings>,
    /// As [`Work::settings`].
    #[serde(default, skip_serializing_if = "Settings::is_empty")]
    pub settings: Settings,
    /// What it holds.
    pub device: Device,
}

/// How the page is laid out, by the panels' own names.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layout {
    /// What a panel takes of the room that it shares with its neighbour, in thousandths.
    pub shares: BTreeMap<String, u16>,
    /// Panels that are folded away.
    pub folded: Vec<String>,
    /// The panel that is shown where there is room for one.
    pub shown: Option<String>,
}

/// What the device holds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// Which controller it is: its `ControllerInfo::id`.
    pub controller: String,
    /// The mains switch.
    pub power: bool,
    /// What survives a reload of the page, in the device's own items: also programs and files in RAM.
    #[serde(with = "MemoryForm")]
    pub memory: Memory,
}

/// Why a text is not taken for a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ProjectError {
    /// Longer than [`LARGEST`].
    TooLarge,
    /// It is something else.
    NotAProject,
    /// Of a version that this page does not know.
    Newer(u32),
    /// Where, and what is wrong there.
    Broken(String),
}

impl fmt::Display for ProjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ProjectError::TooLarge => {
                write!(
                    f,
                    "This is larger than a project can be: {} MB.",
                    LARGEST >> 20
                )
            }
            ProjectError::NotAProject => write!(f, "This is not a Motionbench project."),
            ProjectError::Newer(version) => write!(
                f,
                "This project was written by a newer Motionbench: it has version {version} of the format, and this page reads versions up to {VERSION}."
            ),
            ProjectError::Broken(what) => write!(f, "This project cannot be read: {what}."),
        }
    }
}

/// The whole text; the parts stand in it as they are.
#[derive(Serialize)]
struct Written<'a> {
    format: &'static str,
    version: u32,
    work: &'a Work,
    device: &'a Device,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Read {
    #[serde(rename = "format")]
    _format: IgnoredAny,
    #[serde(rename = "version")]
    _version: IgnoredAny,
    work: Work,
    device: Device,
}

/// What every version has.
#[derive(Deserialize)]
struct Header {
    format: String,
    version: u32,
}

impl Project {
    /// The text of its file, for people too.
    pub fn file(&self) -> String {
        let written = Written {
            format: FORMAT,
            version: self.work.version(),
            work: &self.work,
            device: &self.device,
        };
        // Only maps with keys that are no text cannot be written, and there are none.
        let mut text = serde_json::to_string_pretty(&written).unwrap_or_default();
        text.push('\n');
        text
    }

    /// Reads what [`Project::file`] or [`kept`] wrote.
    ///
    /// # Errors
    /// [`ProjectError`], for people; nothing is taken then.
    pub fn read(text: &str) -> Result<Project, ProjectError> {
        if text.len() > LARGEST {
            return Err(ProjectError::TooLarge);
        }
        let broken = |error: serde_json::Error| ProjectError::Broken(error.to_string());
        let header: Header = serde_json::from_str(text).map_err(|error| {
            if error.is_data() {
                ProjectError::NotAProject
            } else {
                broken(error)
            }
        })?;
        if header.format != FORMAT {
            return Err(ProjectError::NotAProject);
        }
        if !(FIRST_VERSION..=VERSION).contains(&header.version) {
            return Err(ProjectError::Newer(header.version));
        }
        let Read { work, device, .. } = serde_json::from_str(text).map_err(broken)?;
        let project = Project { work, device };
        project.check().map_err(ProjectError::Broken)?;
        Ok(project)
    }

    /// A name for its file that every system takes.
    pub fn file_name(&self) -> String {
        let plain = |c: char| match c {
            c if c.is_alphanumeric() || "-_.".contains(c) => c,
            _ => '-',
        };
        let name: String = self.work.name.trim().chars().map(plain).collect();
        let name = name.trim_matches(['-', '.']);
        let name = if name.is_empty() { "project" } else { name };
        format!("{name}{EXTENSION}")
    }

    /// What the types allow and a page cannot use, in words.
    fn check(&self) -> Result<(), String> {
        let Project { work, device } = self;
        let layout = &work.layout;
        let others = || work.others.iter().map(|desk| &desk.device);
        let lines = work.others.iter().map(|desk| &desk.line);
        if !lines.chain([&work.line]).all(can_be_set) {
            return Err("no serial line can be set like its line".to_owned());
        }
        let controllers: Vec<&str> = others()
            .chain([device])
            .map(|device| device.controller.as_str())
            .collect();
        if let Some(unknown) = controllers.iter().find(|id| kind(id).is_none()) {
            let start: String = unknown.chars().take(20).collect();
            return Err(format!("there is no controller {start}"));
        }
        let settings = work.others.iter().map(|desk| &desk.settings);
        let set = others()
            .chain([device])
            .zip(settings.chain([&work.settings]));
        for (device, settings) in set {
            if !kind(&device.controller).is_some_and(|kind| front::can_be_set(kind, settings)) {
                return Err(format!(
                    "a {} cannot be set like its switches",
                    device.controller
                ));
            }
        }
        let is_again = |(at, id)| controllers.iter().take(at).any(|before| before == id);
        if controllers.iter().enumerate().any(is_again) {
            return Err("it has a controller twice".to_owned());
        }
        if let Speed::Times(times) = work.speed
            && !(0.01..=100.0).contains(&times)
        {
            return Err(format!("its speed {times} is not from 0.01 to 100"));
        }
        let panels = layout
            .shares
            .keys()
            .chain(&layout.folded)
            .chain(&layout.shown);
        let items = others()
            .chain([device])
            .flat_map(|device| &device.memory.items);
        let names: Vec<&String> = [&work.name]
            .into_iter()
            .chain(panels)
            .chain(items.map(|item| &item.name))
            .collect();
        let desks = work.others.iter().map(|desk| desk.breakpoints.len());
        let breakpoints = work.breakpoints.len() + desks.sum::<usize>();
        if names.len() > MOST || breakpoints > MOST {
            return Err(format!("it has more than {MOST} names or breakpoints"));
        }
        let long = names
            .iter()
            .find(|name| name.chars().count() > LONGEST_NAME);
        long.map_or(Ok(()), |name| {
            let start: String = name.chars().take(20).collect();
            Err(format!(
                "the name {start}... has more than {LONGEST_NAME} characters"
            ))
        })
    }
}

fn can_be_set(line: &LineSettings) -> bool {
    (50..=1_000_000).contains(&line.baud)
        && (7..=8).contains(&line.data_bits)
        && (1..=2).contains(&line.stop_bits)
}

impl Work {
    /// The version of the format that has all of it.
    fn version(&self) -> u32 {
        let desks = || self.others.iter().map(|desk| &desk.settings);
        if desks()
            .chain([&self.settings])
            .any(|settings| !settings.is_empty())
        {
            VERSION
        } else if self.others.is_empty() && self.terminal.is_none() {
            FIRST_VERSION
        } else {
            SECOND_VERSION
        }
    }
}

/// The text of `device` for [`kept`]: it changes less often than the rest, and may be long.
pub fn kept_device(device: &Device) -> String {
    serde_json::to_string(device).unwrap_or_default()
}

/// The text of a project without the blanks for people.
pub fn kept(work: &Work, device: &str) -> String {
    let version = work.version();
    let work = serde_json::to_string(work).unwrap_or_default();
    format!(r#"{{"format":"{FORMAT}","version":{version},"work":{work},"device":{device}}}"#)
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Memory", deny_unknown_fields)]
struct MemoryForm {
    version: u32,
    #[serde(serialize_with = "write_items", deserialize_with = "read_items")]
    items: Vec<MemoryItem>,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "MemoryItem", deny_unknown_fields)]
struct ItemForm {
    name: String,
    #[serde(rename = "text", with = "lines::bytes")]
    bytes: Vec<u8>,
}

fn write_items<S: Serializer>(items: &[MemoryItem], serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Item<'a>(#[serde(with = "ItemForm")] &'a MemoryItem);
    serializer.collect_seq(items.iter().map(Item))
}

fn read_items<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<MemoryItem>, D::Error> {
    #[derive(Deserialize)]
    struct Item(#[serde(with = "ItemForm")] MemoryItem);
    let items = Vec::<Item>::deserialize(deserializer)?;
    Ok(items.into_iter().map(|Item(item)| item).collect())
}

#[cfg(test)]
mod tests;
