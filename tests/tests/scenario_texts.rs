//! What the parser says of texts that are no scenario.

#![cfg(not(target_family = "wasm"))]

use motionbench_core::scenario::Scenario;

#[track_caller]
fn is_no_scenario(text: &str, line: u32, message: &str) {
    let problem = Scenario::parse(text).expect_err(text);
    assert_eq!(
        (problem.line, problem.message.as_str()),
        (line, message),
        "{text}"
    );
}

#[test]
fn texts_that_are_no_scenario() {
    let on = "bench mc600\n";
    for (text, line, message) in [
        (
            "type RUN",
            1,
            "no controller is on the bench yet: a `bench` line comes first",
        ),
        (
            "bench mc600\r\nprogram\r\n10 END\r20 END\r\nend",
            3,
            "a carriage return stands in the middle of the line",
        ),
        (
            "\n# a comment\nfrobnicate",
            3,
            "`frobnicate` is not a statement",
        ),
        ("bench", 1, "the controller is missing"),
        (
            "bench mc601",
            1,
            "no controller is called `mc601`; there are: mc600, smartmotor, unidex3",
        ),
        (
            "bench mc600 as 1st",
            1,
            "`1st` is not a name: a letter, then letters, digits, `-` and `_`",
        ),
        (
            "bench mc600 as a\nbench mc600 as a",
            2,
            "`a` is on the bench already",
        ),
        (
            "bench mc600 locked",
            1,
            "expected `key=value`, found `locked`",
        ),
        ("bench mc600 locked=maybe", 1, "locked is yes or no"),
        ("bench mc600 line=a", 1, "mc600 has a host line of its own"),
        (
            "bench smartmotor line=2",
            1,
            "`2` is not a line's name: a letter, then letters, digits, `-` and `_`",
        ),
        (
            "bench smartmotor address=101",
            1,
            "address is a number from 1 to 100",
        ),
        (
            "known-failure \"a\"\nknown-failure \"b\"",
            2,
            "one `known-failure` is enough",
        ),
        (
            "known-failure why",
            1,
            "expected a text in double quotes, found `why`",
        ),
        ("end", 1, "`end` without `repeat` or `program`"),
    ] {
        is_no_scenario(text, line, message);
    }
    for (statement, message) in [
        (
            "left: power on",
            "no controller on the bench is called `left`",
        ),
        ("mc600: mc600: power on", "one station at a time"),
        ("power", "`on` or `off` is missing"),
        ("power up", "expected `on` or `off`, found `up`"),
        ("power on now", "`now` is one word too many"),
        (
            "line",
            "the settings are missing: baud= parity= bits= stop= flow=",
        ),
        (
            "line baud=9",
            "`baud=9` is none of baud=50..1000000 parity=N|E|O bits=7|8 stop=1|2 flow=xon|none",
        ),
        ("axis x", "`key=value` is missing"),
        ("file put A:X.BAS", "a text in double quotes is missing"),
        (
            "file list",
            "expected `put`, `get` or `expect`, found `list`",
        ),
        ("send \"a", "the text has no closing double quote"),
        ("run", "the time is missing"),
        (
            "run 5",
            "`5` is not a time: write 0.5s, 20ms, 100us or 2min",
        ),
        ("run 25000min", "`25000min` is more than a day"),
        (
            "run until done",
            "expected `idle` or a text in double quotes, found `done`",
        ),
        ("run until \"\"", "the text is empty"),
        (
            "run until idle within",
            "the time after `within` is missing",
        ),
        (
            "expect RUN",
            "expected a text in double quotes, found `RUN`",
        ),
        ("wire in1 high", "`high` is not a number, `on` or `off`"),
        (
            "fault fire",
            "`fire` is none of the faults limit+ limit- stall drive encoder estop powerfail line rom sram uram \
             battery internal",
        ),
        ("led READY bright", "`bright` is not a state of an LED"),
        (
            "check x.position",
            "after `x.position` one of = != < <= > >= is missing, with blanks around it",
        ),
        ("check x.position = far", "`far` is not a number"),
        ("check settled x.position of 5", "`within` is missing"),
        (
            "check always x.velocity <= 50",
            "`check always` holds of an axis that stands still: add a `check ever` about x",
        ),
        ("repeat 0", "`0` is not a count of 1 to 1000000"),
        ("repeat 2\npower on", "`repeat` without `end`"),
        ("program\n10 END", "`program` without `end`"),
        ("at 1s run 2s", "`run` takes time and cannot be scheduled"),
        (
            "at 1s check settled x.position within 1s of 5",
            "`settled` takes time and cannot be scheduled",
        ),
        ("bus ieee488", "what to do on the bus is missing"),
        (
            "bus ieee488 shout 2",
            "`shout` is none of ren ifc listen send talk get sdc dcl gtl llo spoll ppoll srq expect",
        ),
        ("bus ieee488 ren 1", "expected `on` or `off`, found `1`"),
        ("bus ieee488 listen 31", "`31` is not an address of 0 to 30"),
        ("bus ieee488 talk", "the address is missing"),
        ("bus ieee488 sdc", "the address is missing"),
        ("bus ieee488 spoll 2 = 256", "`256` is not a byte"),
        ("bus ieee488 srq = 2", "`2` is not a level: 0 or 1"),
        ("bus ieee488 llo 2", "`2` is one word too many"),
        (
            "at 1s bus ieee488 spoll 2",
            "`bus` takes time and cannot be scheduled",
        ),
        ("at 1s repeat 5", "`repeat` cannot be scheduled"),
        ("at 1s mc600: power on", "write `mc600:` before `at`"),
    ] {
        is_no_scenario(&format!("{on}{statement}"), 2, message);
    }
    is_no_scenario(
        &format!("{on}repeat 2\nbench mc600\nend"),
        3,
        "`bench` cannot stand in `repeat`",
    );
    let deep = "repeat 1\n".repeat(9);
    is_no_scenario(
        &format!("{on}{deep}"),
        10,
        "`repeat` stands in `repeat` at most 8 deep",
    );
    let long = "#".repeat((4 << 20) + 1);
    is_no_scenario(&long, 1, "a scenario has at most 4194304 bytes");
}

#[test]
fn no_text_makes_it_panic() {
    let good = "bench mc600 as a locked=no\npower on\na: type PRINT \"x\"\nrepeat 2\nat 1s check x.position = 5 +- 1\nend\n\
                program 5\n10 END\nend\nload \"x\" as A:X\nfile expect A:X nothing\nsend \"\\x13\\r\"\n\
                check settled x.position within 1s of 4 +- 1\nwire in1 1rpm\nrewind 2s\nrun until \"x\" within 5ms\n";
    assert!(Scenario::parse(good).is_ok());
    // Every prefix, and every text with one byte changed.
    let bytes = good.as_bytes();
    for cut in 0..bytes.len() {
        let _ = Scenario::parse(&String::from_utf8_lossy(&bytes[..cut]));
        for other in [b' ', b'"', b'\\', b'\n', b'=', b':', b'0', 0xFF] {
            let mut changed = bytes.to_vec();
            changed[cut] = other;
            let _ = Scenario::parse(&String::from_utf8_lossy(&changed));
        }
    }
}
