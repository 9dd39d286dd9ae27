//! What the fuzzers start from: the examples of the keyword table, and the scenarios.

use motionbench_core::catalog;
use motionbench_core::language::latin1;

use crate::{conformance, programs};

/// Names and bytes of a fuzzer's seeds.
///
/// # Panics
/// If there is no such fuzzer.
pub fn seeds(target: &str) -> Vec<(String, Vec<u8>)> {
    match target {
        "mc600_text" => mc600("\n", |text| text.into_bytes()),
        "mc600_console" => {
            // In front, the card's options: one of speed and password for each.
            let typed = |text: String| {
                let options = u8::try_from(text.len() % 8).unwrap_or_default();
                [&[options][..], &latin1::bytes(&text), b"\r"].concat()
            };
            let outside = OUTSIDE.iter().enumerate();
            let outside = outside
                .map(|(index, text)| (format!("outside-{index}"), typed((*text).to_owned())));
            mc600("\r", typed).into_iter().chain(outside).collect()
        }
        "scenario" => {
            let names = conformance::scenarios();
            let text = |name: &str| conformance::text(name).into_bytes();
            names.map(|name| (file_name(name), text(name))).collect()
        }
        other => panic!("there is no fuzzer {other}"),
    }
}

/// Consoles that more happens to than typing; what follows ESC is in `fuzz`.
const OUTSIDE: [&str; 5] = [
    "10 MDRVEN():MMOVE(40960)\r20 GOTO 20\rRUN\r\x1br\x1bc\x1br\x1bpLIST",
    "10 INPUT A$:PRINT A$:GOTO 10\rRUN\rX\r\x1bb\x1bsY\r\x1beZ\r\x1bc\x1bc",
    "MDRVEN():MSPEED(34952)\r\x1br\x1bA\x1br\x1bB\x1br\x1bH\x1b3\x1b4MCLRFAULT()\rPRINT GV_STATUS%,INSTA()",
    "AUTO\rPRINT \"X\"\r\x13\x1br\x11GOTO 10\r\rRUN\r\x13\x1br\x1bc\x08\x7f\x00\x1b\x1b",
    "10 A$=A$+\"XXXXXXXX\":PRINT LEN(A$);:GOTO 10\rRUN\r\x1boRUN\r\x1bpRUN",
];

/// The examples of the keyword table and the programs of the scenarios, with their lines joined.
fn mc600(joint: &str, bytes: impl Fn(String) -> Vec<u8>) -> Vec<(String, Vec<u8>)> {
    let kind = catalog::kind("mc600").expect("the catalogue has it");
    let rows = (kind.keywords)();
    let examples = rows.iter().enumerate();
    let examples =
        examples.map(|(index, row)| (format!("example-{index}"), bytes(row.example.to_owned())));
    let names = conformance::scenarios().filter(|name| name.starts_with("mc600/"));
    let programs = names.map(|name| {
        let lines = programs::lines(name).join(joint);
        (file_name(name), bytes(lines))
    });
    examples.chain(programs).collect()
}

fn file_name(name: &str) -> String {
    name.replace('/', "-").replace(".scenario", "")
}
