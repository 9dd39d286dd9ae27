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
        "mc600_text" => of("mc600", "\n", |text| text.into_bytes()),
        "mc600_console" => {
            // In front, the card's options: one of speed and password for each.
            let typed = |text: String| {
                let options = u8::try_from(text.len() % 8).unwrap_or_default();
                [&[options][..], &latin1::bytes(&text), b"\r"].concat()
            };
            let outside = OUTSIDE.iter().enumerate();
            let outside = outside
                .map(|(index, text)| (format!("outside-{index}"), typed((*text).to_owned())));
            of("mc600", "\r", typed)
                .into_iter()
                .chain(outside)
                .collect()
        }
        "smartmotor_text" => of("smartmotor", "\n", |text| text.into_bytes()),
        "smartmotor_serial" => {
            // In front, the motors' options.
            let sent = |text: String| {
                let options = u8::try_from(text.len() % 16).unwrap_or_default();
                [&[options][..], &latin1::bytes(&text), b"\r"].concat()
            };
            let outside = CHAINS.iter().enumerate();
            let outside =
                outside.map(|(index, text)| (format!("chain-{index}"), sent((*text).to_owned())));
            let seeds = of("smartmotor", "\r", sent);
            seeds.into_iter().chain(outside).collect()
        }
        "unidex3_text" => of("unidex3", "\n", |text| text.into_bytes()),
        "unidex3_keys" => {
            // Each as keys (EDT 2 5 EXC in front, RES behind), and on the line as program 25, which is run.
            let seeds = of("unidex3", "", |text| text.into_bytes());
            let both = |(name, text): (String, Vec<u8>)| {
                let keys = [b"\x0125\n", &text[..], b"\x02\n\x8f"].concat();
                let line = [
                    b"\xff\x1b1\r\nE25\r\n",
                    &text[..],
                    b"%\r\nA25\r\nQ\r\nP25\r\n\xff\xf0",
                ];
                [
                    (format!("keys-{name}"), keys),
                    (format!("line-{name}"), line.concat()),
                ]
            };
            seeds.into_iter().flat_map(both).collect()
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

/// Lines of motors that more happens to than commands.
const CHAINS: [&str; 5] = [
    "\u{80}SADDR1\rECHO\rSLEEP\r\u{80}SADDR2\rECHO\r\u{80}WAKE\r\u{81}Ra\r\u{82}Ra\r\u{1b}pRP",
    "LOAD\rC1 a=a+1 PRINT(a,#13) GOTO1\rEND\r\u{ff}RUN\r\u{1b}r\u{1b}d\u{1b}rUPLOAD\rUP\rEND",
    "MV A=100 V=200000 G\r\u{1b}r\u{1b}A\u{1b}r\u{1b}B\u{1b}r\u{1b}H\u{1b}3\u{1b}4ZS RW RPW\r\u{1b}w",
    "OCHN(RS2,0,E,19200,1,8,D)\r\u{1b}sX\r\u{1b}bY\r\u{1b}eZ\rCCHN(RS2,0)\r\u{1b}oRa",
    "MD\r\u{fa}\u{0}\u{0}\u{1}\u{0}\r\u{fb}\u{0}\u{0}\u{1}\u{0}\rG\rQ\r\u{fe}\u{1}\u{2}\u{3}\u{80}RP",
];

/// The examples of the keyword table and the programs of the scenarios, with their lines joined.
fn of(controller: &str, joint: &str, bytes: impl Fn(String) -> Vec<u8>) -> Vec<(String, Vec<u8>)> {
    let kind = catalog::kind(controller).expect("the catalogue has it");
    let rows = (kind.keywords)();
    let examples = rows.iter().enumerate();
    let examples =
        examples.map(|(index, row)| (format!("example-{index}"), bytes(row.example.to_owned())));
    let names = conformance::scenarios().filter(|name| {
        name.strip_prefix(controller)
            .is_some_and(|rest| rest.starts_with('/'))
    });
    let programs = names.map(|name| {
        let lines = programs::lines(name).join(joint);
        (file_name(name), bytes(lines))
    });
    examples.chain(programs).collect()
}

fn file_name(name: &str) -> String {
    name.replace('/', "-").replace(".scenario", "")
}
