//! What each statement may say: one function a group, no state.

use crate::controller::{Led, Slot};
use crate::language::latin1;
use crate::serial::{Flow, Parity};

use super::bus;
use super::statement::{Action, LineSetting};
use super::text::{Line, number};

/// Every statement of the language.
const STATEMENTS: &[&str] = &[
    "at",
    "axis",
    "bench",
    "break",
    "bus",
    "check",
    "clear",
    "display",
    "expect",
    "fault",
    "file",
    "hold",
    "known-failure",
    "lamp",
    "led",
    "line",
    "load",
    "power",
    "press",
    "printer",
    "program",
    "repeat",
    "reply",
    "rewind",
    "run",
    "send",
    "type",
    "wire",
];

/// Faults that some controller has.
const FAULTS: &[&str] = &[
    "limit+",
    "limit-",
    "stall",
    "drive",
    "encoder",
    "estop",
    "powerfail",
    "line",
    "rom",
    "sram",
    "uram",
    "battery",
    "internal",
];

pub(super) fn is_statement(word: &str) -> bool {
    STATEMENTS.contains(&word)
}

pub(super) fn unknown(word: &str) -> String {
    format!("`{word}` is not a statement")
}

/// Where a program goes: a number, or a file's name.
pub(super) fn slot(word: &str) -> Slot {
    match word.parse() {
        Ok(number) => Slot::Number(number),
        Err(_) => Slot::File(word.to_owned()),
    }
}

/// Reads the rest of a statement that starts with `word` and needs nothing but its line.
pub(super) fn action(word: &str, mut line: Line<'_>) -> Result<Action, String> {
    let action = match word {
        "type" => return Ok(Action::Type(literal(line)?)),
        "line" => line_settings(&mut line)?,
        "break" => Action::Break,
        "axis" => axis(&mut line)?,
        "file" => file(&mut line)?,
        "load" => load(&mut line)?,
        "power" => Action::Power(on_or_off(&mut line)?),
        "send" => Action::Send(line.bytes()?),
        "press" => press(&mut line)?,
        "hold" => Action::Hold {
            key: line.need("the key")?.to_owned(),
            time: line.time("how long")?,
        },
        "wire" => wire(&mut line)?,
        "fault" => fault(&mut line, true)?,
        "clear" => fault(&mut line, false)?,
        "run" => run(&mut line)?,
        "expect" => expect(&mut line)?,
        "reply" => Action::Reply {
            text: line.bytes()?,
            within: line.within()?,
        },
        "rewind" => Action::Rewind(line.time("how far")?),
        "display" => Action::Display(latin1::text(&line.bytes()?)),
        "led" => Action::Led {
            name: line.need("the LED")?.to_owned(),
            state: led_state(&mut line)?,
        },
        "lamp" => Action::Lamp {
            name: line.need("the lamp")?.to_owned(),
            on: on_or_off(&mut line)?,
        },
        "printer" => Action::Printer(not_empty(line.bytes()?)?),
        "bus" => bus::action(&mut line)?,
        _ => return Err(unknown(word)),
    };
    line.end()?;
    Ok(action)
}

fn literal(line: Line<'_>) -> Result<Vec<u8>, String> {
    let text = line.literal();
    match text.chars().find(|&c| latin1::byte(c).is_none()) {
        Some(c) => Err(format!(
            "`{c}` is not a character of eight bits: use `send`"
        )),
        None => Ok(latin1::bytes(text)),
    }
}

fn on_or_off(line: &mut Line<'_>) -> Result<bool, String> {
    match line.need("`on` or `off`")? {
        "on" => Ok(true),
        "off" => Ok(false),
        word => Err(format!("expected `on` or `off`, found `{word}`")),
    }
}

fn line_settings(line: &mut Line<'_>) -> Result<Action, String> {
    let mut settings = Vec::new();
    while let Some((key, value)) = line.setting()? {
        let setting = match (key.as_str(), value.as_str()) {
            ("baud", value) => value
                .parse()
                .ok()
                .filter(|baud| (50..=1_000_000).contains(baud))
                .map(LineSetting::Baud),
            ("parity", "N" | "n") => Some(LineSetting::Parity(Parity::None)),
            ("parity", "E" | "e") => Some(LineSetting::Parity(Parity::Even)),
            ("parity", "O" | "o") => Some(LineSetting::Parity(Parity::Odd)),
            ("bits", "7") => Some(LineSetting::DataBits(7)),
            ("bits", "8") => Some(LineSetting::DataBits(8)),
            ("stop", "1") => Some(LineSetting::StopBits(1)),
            ("stop", "2") => Some(LineSetting::StopBits(2)),
            ("flow", "xon") => Some(LineSetting::Flow(Flow::XonXoff)),
            ("flow", "none") => Some(LineSetting::Flow(Flow::None)),
            _ => None,
        };
        settings.push(setting.ok_or_else(|| {
            format!(
                "`{key}={value}` is none of baud=50..1000000 parity=N|E|O bits=7|8 stop=1|2 flow=xon|none"
            )
        })?);
    }
    if settings.is_empty() {
        return Err("the settings are missing: baud= parity= bits= stop= flow=".to_owned());
    }
    Ok(Action::Line(settings))
}

fn axis(line: &mut Line<'_>) -> Result<Action, String> {
    let axis = line.need("the axis")?.to_owned();
    let mut settings = Vec::new();
    while let Some(setting) = line.setting()? {
        settings.push(setting);
    }
    if settings.is_empty() {
        return Err("`key=value` is missing".to_owned());
    }
    Ok(Action::Axis { axis, settings })
}

fn file(line: &mut Line<'_>) -> Result<Action, String> {
    let what = line.need("`put`, `get` or `expect`")?;
    if !matches!(what, "put" | "get" | "expect") {
        return Err(format!("expected `put`, `get` or `expect`, found `{what}`"));
    }
    let name = line.need("the device's file")?.to_owned();
    Ok(match what {
        "put" => Action::FilePut {
            name,
            file: line.quoted()?,
        },
        "get" => Action::FileGet {
            name,
            file: line.quoted()?,
        },
        _ if line.eat("nothing") => Action::FileExpect { name, text: None },
        _ => Action::FileExpect {
            name,
            text: Some(line.bytes()?),
        },
    })
}

fn load(line: &mut Line<'_>) -> Result<Action, String> {
    let file = line.quoted()?;
    let slot = match line.eat("as") {
        true => Some(slot(line.need("the slot after `as`")?)),
        false => None,
    };
    Ok(Action::Load { slot, file })
}

fn press(line: &mut Line<'_>) -> Result<Action, String> {
    let mut keys = vec![line.need("the key")?.to_owned()];
    while let Some(key) = line.word() {
        keys.push(key.to_owned());
    }
    Ok(Action::Press(keys))
}

fn wire(line: &mut Line<'_>) -> Result<Action, String> {
    let name = line.need("the wire")?.to_owned();
    let word = line.need("the value")?;
    let value = match word {
        "on" => Some(1.0),
        "off" => Some(0.0),
        // The unit is the wire's own; to write it is for the reader.
        _ => number(
            word.strip_suffix("rpm")
                .or(word.strip_suffix('V'))
                .unwrap_or(word),
        ),
    };
    let value = value.ok_or_else(|| format!("`{word}` is not a number, `on` or `off`"))?;
    Ok(Action::Wire { name, value })
}

fn fault(line: &mut Line<'_>, active: bool) -> Result<Action, String> {
    let kind = line.need("the kind of fault")?.to_owned();
    if !FAULTS.contains(&kind.as_str()) {
        return Err(format!(
            "`{kind}` is none of the faults {}",
            FAULTS.join(" ")
        ));
    }
    let axis = line.word().map(str::to_owned);
    Ok(Action::Fault { kind, axis, active })
}

fn run(line: &mut Line<'_>) -> Result<Action, String> {
    if !line.eat("until") {
        return Ok(Action::Run(line.time("the time")?));
    }
    if line.is_quoted() {
        let text = not_empty(line.bytes()?)?;
        let within = line.within()?;
        return Ok(Action::RunUntil { text, within });
    }
    match line.need("`idle` or a text in double quotes")? {
        "idle" => Ok(Action::RunUntilIdle {
            within: line.within()?,
        }),
        word => Err(format!(
            "expected `idle` or a text in double quotes, found `{word}`"
        )),
    }
}

fn expect(line: &mut Line<'_>) -> Result<Action, String> {
    if line.eat("exactly") {
        return Ok(Action::ExpectExactly(line.bytes()?));
    }
    if line.eat("nothing") {
        return Ok(Action::ExpectNothing);
    }
    Ok(Action::Expect(not_empty(line.bytes()?)?))
}

/// An empty text is found in anything, so it asks nothing.
fn not_empty(text: Vec<u8>) -> Result<Vec<u8>, String> {
    match text.is_empty() {
        true => Err("the text is empty".to_owned()),
        false => Ok(text),
    }
}

fn led_state(line: &mut Line<'_>) -> Result<Led, String> {
    match line.need("`on`, `off` or `flashing`")? {
        "on" => Ok(Led::On),
        "off" => Ok(Led::Off),
        "flashing" => Ok(Led::Flashing),
        state => Err(format!("`{state}` is not a state of an LED")),
    }
}
