//! The one file that names every controller.

use crate::controller::{
    Controller, DiskInfo, Face, FirstStep, Lamps, Opt, TerminalSettings, TextRules, Wired,
};
use crate::language::{Diagnostic, Highlight, KeywordRow};
use crate::mc600::{self, Mc600};
use crate::serial::LineSettings;
use crate::smartmotor::{self, SmartMotor};
use crate::unidex3::{self, Unidex3};

/// A station on the bench. An enum, not a box of `dyn`, so that the bench is `Clone` and a checkpoint is a copy.
#[derive(Debug, Clone)]
#[allow(missing_docs)]
pub enum Station {
    Mc600(Box<Mc600>),
    SmartMotor(Box<SmartMotor>),
    Unidex3(Box<Unidex3>),
}

impl Station {
    /// The station as the bench sees it.
    pub fn controller(&self) -> &dyn Controller {
        match self {
            Station::Mc600(station) => station.as_ref(),
            Station::SmartMotor(station) => station.as_ref(),
            Station::Unidex3(station) => station.as_ref(),
        }
    }

    /// The station as the bench drives it.
    pub fn controller_mut(&mut self) -> &mut dyn Controller {
        match self {
            Station::Mc600(station) => station.as_mut(),
            Station::SmartMotor(station) => station.as_mut(),
            Station::Unidex3(station) => station.as_mut(),
        }
    }
}

/// A kind of controller.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// The name in scenarios and on the command line.
    pub id: &'static str,
    /// For people.
    pub name: &'static str,
    /// What can be given when it is put on the bench.
    pub options: &'static [Opt],
    /// Its console's line without options.
    pub line: LineSettings,
    /// What is wrong with a program, told from its text alone.
    pub diagnose: fn(&str) -> Vec<Diagnostic>,
    /// The classes of a program line's parts, from the controller's own lexer.
    pub highlight: fn(&str) -> Vec<Highlight>,
    /// The words of the keyword table that a program line uses.
    pub words: fn(&str) -> Vec<&'static str>,
    /// Every word of its language.
    pub keywords: fn() -> Vec<&'static KeywordRow>,
    /// How the controller keeps a program's text.
    pub text: TextRules,
    /// A short program that moves an axis, for a first visit.
    pub first_program: &'static str,
    /// How a newcomer gets from the console to a program of their own that outlives the mains switch.
    pub first_steps: &'static [FirstStep],
    /// The command that enables the drive again after an emergency stop.
    pub enable: &'static str,
    /// What a person finds at its inputs on the bench.
    pub inputs: &'static [Wired],
    /// Which of them lets the drive be enabled.
    pub enable_input: Option<usize>,
    /// The lamps at its outputs.
    pub lamps: Lamps,
    /// Its front panel and what belongs to it; most controllers have none.
    pub face: Option<&'static Face>,
    /// It has cam tables that [`crate::controller::Debug::Cam`] tells.
    pub has_cam: bool,
    /// Where it keeps files.
    pub disks: &'static [DiskInfo],
    /// How a terminal at its console is best set.
    pub terminal: TerminalSettings,
}

/// Every kind there is.
pub const KINDS: &[Kind] = &[
    Kind {
        id: "mc600",
        name: "Danaher MC-600",
        options: mc600::OPTIONS,
        line: LineSettings::new(9600),
        diagnose: mc600::diagnose::diagnose,
        highlight: mc600::diagnose::highlight,
        words: mc600::diagnose::words,
        keywords: mc600::keywords::rows,
        text: TextRules {
            numbered: true,
            ignores_case: true,
            keeps_comments: true,
            empty: "",
            device_lines: mc600::diagnose::device_lines,
        },
        first_program: mc600::first_steps::PROGRAM,
        first_steps: mc600::first_steps::STEPS,
        enable: "MDRVEN()",
        inputs: mc600::wiring::INPUTS,
        enable_input: Some(mc600::wiring::ENABLE),
        lamps: mc600::wiring::LAMPS,
        face: None,
        has_cam: true,
        disks: mc600::disks::DISKS,
        terminal: TerminalSettings {
            local_echo: false,
            line_feeds: false,
        },
    },
    Kind {
        id: "smartmotor",
        name: "Animatics SmartMotor",
        options: smartmotor::OPTIONS,
        line: smartmotor::LINE,
        diagnose: smartmotor::diagnose::diagnose,
        highlight: smartmotor::diagnose::highlight,
        words: smartmotor::diagnose::words,
        keywords: smartmotor::keywords::rows,
        text: TextRules {
            numbered: false,
            ignores_case: false,
            keeps_comments: false,
            empty: "END",
            device_lines: smartmotor::diagnose::device_lines,
        },
        first_program: smartmotor::first_steps::PROGRAM,
        first_steps: smartmotor::first_steps::STEPS,
        enable: "G",
        inputs: smartmotor::wiring::INPUTS,
        enable_input: None,
        lamps: smartmotor::wiring::LAMPS,
        face: None,
        has_cam: false,
        disks: &[],
        // It does not echo, and ends its answers with a bare CR.
        terminal: TerminalSettings {
            local_echo: true,
            line_feeds: true,
        },
    },
    Kind {
        id: "unidex3",
        name: "Aerotech Unidex IIIa",
        options: unidex3::OPTIONS,
        line: unidex3::LINE,
        diagnose: unidex3::diagnose::diagnose,
        highlight: unidex3::diagnose::highlight,
        words: unidex3::diagnose::words,
        keywords: unidex3::keywords::rows,
        text: TextRules {
            numbered: false,
            ignores_case: false,
            keeps_comments: false,
            empty: "",
            device_lines: unidex3::diagnose::device_lines,
        },
        first_program: unidex3::first_steps::PROGRAM,
        first_steps: unidex3::first_steps::STEPS,
        enable: "I G10",
        inputs: unidex3::wiring::INPUTS,
        enable_input: None,
        lamps: unidex3::wiring::LAMPS,
        face: Some(&unidex3::face::FACE),
        has_cam: false,
        disks: &[],
        // It does not echo.
        terminal: TerminalSettings {
            local_echo: true,
            line_feeds: false,
        },
    },
];

impl Kind {
    /// Makes one, switched off.
    ///
    /// # Errors
    /// One clear line about an option that does not exist or a value that it cannot have.
    pub fn create(&self, options: &[(String, String)]) -> Result<Station, String> {
        create(self.id, options)
    }
}

/// Makes a controller of the kind called `id`, switched off. No part of [`KINDS`]: who only reads that carries no
/// simulator, and who only simulates carries no language tools and no help.
///
/// # Errors
/// One clear line about a kind or an option that does not exist, or a value that an option cannot have.
pub fn create(id: &str, options: &[(String, String)]) -> Result<Station, String> {
    Ok(match id {
        "mc600" => Station::Mc600(Box::new(Mc600::new(options)?)),
        "smartmotor" => Station::SmartMotor(Box::new(SmartMotor::new(options)?)),
        "unidex3" => Station::Unidex3(Box::new(Unidex3::new(options)?)),
        _ => return Err(format!("there is no controller {id}")),
    })
}

/// The options of each station that these options put on the bench, for [`create`]: more than one where units share a
/// front panel. The first is nearest to the host.
///
/// # Errors
/// One clear line about a number of units that there cannot be.
pub fn units(id: &str, options: &[(String, String)]) -> Result<Vec<Vec<(String, String)>>, String> {
    match id {
        "unidex3" => unidex3::units::units(options),
        _ => Ok(vec![options.to_vec()]),
    }
}

/// The kind called `id`.
pub fn kind(id: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.id == id)
}
