//! The scenario runner itself: what it says when something does not hold.

#![cfg(not(target_family = "wasm"))]

use motionbench_core::scenario::{Outcome, Report, Scenario};

/// Runs a scenario about an MC-600 that is switched on, whose lines count from 3.
fn run(text: &str) -> Report {
    run_whole(&format!("bench mc600\npower on\n{text}"))
}

fn run_whole(text: &str) -> Report {
    let scenario = Scenario::parse(text).unwrap_or_else(|problem| panic!("{problem:?}\n{text}"));
    scenario.run(&mut |name| match name {
        "two.bas" => Ok(b"10 PRINT 1\n20 PRINT 2\n".to_vec()),
        "bad.bas" => Ok(b"10 PRINT 1\nPRINT 2\n".to_vec()),
        _ => Err(format!("{name}: no such file")),
    })
}

#[track_caller]
fn holds(text: &str) {
    let report = run(text);
    assert_eq!(
        (report.outcome, report.message.as_str()),
        (Outcome::Held, ""),
        "{text}"
    );
}

#[track_caller]
fn fails(text: &str, line: u32, message: &str) {
    let report = run(text);
    let found = (report.outcome, report.line, report.message.as_str());
    assert_eq!(found, (Outcome::Failed, line, message), "{text}");
}

#[test]
fn output_that_is_not_as_expected() {
    holds("run until idle\nexpect exactly \">\"\nexpect nothing");
    fails(
        "run until idle\nexpect \"READY\"",
        4,
        "expected \"READY\", the console sent \">\"",
    );
    fails(
        "expect \"READY\"",
        3,
        "expected \"READY\", the console sent nothing",
    );
    fails(
        "run until idle\nexpect exactly \"\\r\\n>\"",
        4,
        "expected exactly \"\\r\\n>\", the console sent \">\"",
    );
    fails(
        "run until idle\nexpect nothing",
        4,
        "expected nothing, the console sent \">\"",
    );
    // The position moves behind what was matched.
    fails(
        "type ?1\nrun until idle\nexpect \"?1\"\nexpect \"?1\"",
        6,
        "expected \"?1\", the console sent \"\\r\\n 1 \\r\\n>\"",
    );
}

#[test]
fn replies() {
    holds("type PRINT 6*7\nreply \" 42 \"\ntype A=1\nreply \"\"\nexpect nothing");
    holds("type PRINT 1\ntype PRINT 2\nreply \" 2 \"");
    fails(
        "type PRINT 6*7\nreply \"42\"",
        4,
        "expected the reply \"42\", it was \" 42 \"",
    );
    fails(
        "type 10 GOTO 10\ntype RUN\nreply \"\" within 1s",
        5,
        "no prompt within 1 s: the program runs in line 10; the console sent \">10 GOTO 10\\r\\n>RUN\\r\\n\"",
    );
}

#[test]
fn waiting() {
    fails(
        "type 10 INPUT \"HOW MANY\";A\ntype RUN\nrun until idle within 2s",
        5,
        "not idle within 2 s: the program waits for input in line 10; \
         the console sent last \">10 INPUT \\\"HOW MANY\\\";A\\r\\n>RUN\\r\\nHOW MANY? \"",
    );
    fails(
        "run until \"READY\" within 0.5s",
        3,
        "no \"READY\" within 0.5 s: all is idle; the console sent \">\"",
    );
    fails(
        "type MDRVEN():MMOVE(4000000)\nrun until idle within 1s",
        4,
        "not idle within 1 s: an axis moves; the console sent last \">MDRVEN():MMOVE(4000000)\\r\\n>\"",
    );
    // Time stands where the last byte came.
    holds(
        "type PRINT 1\nrun until \"\\r\\n\"\ncheck x.position = 0\nrun until \" 1 \\r\\n>\"\nexpect nothing",
    );
}

#[test]
fn signals_and_variables() {
    let moved = "type MDRVEN():MMOVE(4096)\nrun until idle\n";
    holds(&format!(
        "{moved}check x.position = 4096\ncheck 0.position = 4096\ncheck x.position != 0\n\
         check x.position = 4095 +- 1\ncheck always x.command <= 4096\ncheck ever x.command > 4000\n\
         check gv_mflag% >= 0"
    ));
    holds("type A$=\"HELLO\": B(3)=7\nreply \"\"\ncheck A$ = \"HELLO\"\ncheck B(3) = 7");
    fails(
        "check x.position = 5",
        3,
        "expected x.position = 5, it is 0",
    );
    fails(
        "check y.position = 5",
        3,
        "mc600 has no variable or signal 'y.position'",
    );
    let report = run(&format!(
        "{moved}check always x.command < 4000\ncheck ever x.command > 0"
    ));
    assert_eq!((report.outcome, report.line), (Outcome::Failed, 5));
    assert!(
        report
            .message
            .starts_with("expected always x.command < 4000, at 0."),
        "{}",
        report.message
    );
    fails(
        &format!("{moved}check ever x.position > 5000"),
        5,
        "expected ever x.position > 5000, it was 0 to 4096",
    );
    fails(
        "check ever x.position > 0",
        3,
        "there was no value of x.position yet",
    );
}

#[test]
fn folding_starts_at_power_on() {
    holds(
        "type MDRVEN():MMOVE(4096)\nrun until idle\npower off\nrun 1s\npower on\nrun 1s\n\
         check always x.command = 0",
    );
}

#[test]
fn settling() {
    let start = "type MDRVEN():MMOVE(4096)\n";
    holds(&format!(
        "{start}check settled x.position within 2s of 4096 +- 2"
    ));
    let report = run(&format!(
        "{start}check settled x.position within 0.1s of 4096 +- 2"
    ));
    assert_eq!((report.outcome, report.line), (Outcome::Failed, 4));
    assert!(
        report
            .message
            .starts_with("expected x.position = 4096 +- 2 settled within 0.1 s, at 0.1 s it was "),
        "{}",
        report.message
    );
}

#[test]
fn what_the_controller_does_not_have() {
    for (statement, message) in [
        ("press IMD", "mc600 has no panel"),
        ("hold IMD 0.5s", "mc600 has no panel"),
        ("display \"READY\"", "mc600 has no panel"),
        ("led READY flashing", "mc600 has no panel"),
        ("lamp READY on", "mc600 has no lamp READY"),
        ("printer \"X\"", "mc600 has no printer"),
        ("bus ieee488 spoll 2 = 0x40", "mc600 has no ieee488 bus"),
        ("fault sram", "mc600 has no fault sram"),
    ] {
        fails(statement, 3, message);
    }
    // In the controller's own words.
    for (statement, name) in [
        ("wire C1 1", "C1"),
        ("axis y inertia=2", "y"),
        ("axis x colour=2", "colour"),
    ] {
        let report = run(statement);
        assert_eq!(
            (report.outcome, report.line),
            (Outcome::Failed, 3),
            "{statement}"
        );
        assert!(report.message.contains(name), "{}", report.message);
    }
}

#[test]
fn what_the_bus_does_not_bring() {
    let start = "bench unidex3 as unit address=2\npower on\nrun 1s\nbus ieee488 ren on\n";
    for (statements, line, message) in [
        ("bus ieee488 spoll 3 = 0", 5, "no unit has that address"),
        (
            "bus ieee488 spoll 2 = 0x40",
            5,
            "expected 0x40, the poll gave 0x00",
        ),
        ("bus ieee488 srq = 1", 5, "no unit requests service"),
        (
            "bus ieee488 srq within 1s",
            5,
            "no unit requests service within 1 s: all is idle",
        ),
        (
            "bus ieee488 expect \"A\"",
            5,
            "expected \"A\" on the bus, there was \"\"",
        ),
        (
            "bus ieee488 send \"A\"\nbus ieee488 spoll 2 = 0 within 1s",
            6,
            "no poll within 1 s: no one listens on the bus",
        ),
        (
            "press AUT\nbus ieee488 listen 2\nbus ieee488 send \"A\"\nbus ieee488 ppoll within 1s",
            8,
            "no poll within 1 s: unit holds off the bus",
        ),
        (
            "bus ieee488 listen 2\nbus ieee488 send \"PX\\r\\n\"\nbus ieee488 talk 2\nrun until idle\n\
             bus ieee488 expect \"X0000000000\\r\\n\" end",
            9,
            "the last byte came without EOI",
        ),
    ] {
        let report = run_whole(&format!("{start}{statements}"));
        let found = (report.outcome, report.line, report.message.as_str());
        assert_eq!(found, (Outcome::Failed, line, message), "{statements}");
    }
}

/// What has come by the bus is taken back with the time.
#[test]
fn a_rewind_takes_the_bus_back() {
    let report = run_whole(
        "bench unidex3 address=2\npower on\nrun 1s\nbus ieee488 ren on\nbus ieee488 listen 2\n\
         bus ieee488 send \"PX\\r\\n\"\nrun 0.1s\nbus ieee488 talk 2\nrun 0.1s\nrewind 0.1s\n\
         bus ieee488 expect nothing\nbus ieee488 talk 2\nrun 0.1s\n\
         bus ieee488 expect \"X0000000000\\r\\n\"",
    );
    assert_eq!(
        (report.outcome, report.message.as_str()),
        (Outcome::Held, "")
    );
}

#[test]
fn programs_and_files() {
    holds("load \"two.bas\"\nexpect nothing\ntype RUN\nreply \" 1 \\r\\n 2 \"");
    holds("program\n10 PRINT 5\nend\ntype RUN\nreply \" 5 \"");
    holds("program B:P.BAS\n10 PRINT 5\nend\ntype RUN \"B:P.BAS\"\nreply \" 5 \"");
    holds(
        "file put B:T.BAS \"two.bas\"\nfile expect B:T.BAS \"10 PRINT 1\\n20 PRINT 2\\n\"\nfile expect A:T.BAS nothing",
    );
    fails(
        "file put B:T.BAS \"two.bas\"\nfile expect B:T.BAS \"10 PRINT 1\"",
        4,
        "expected that B:T.BAS holds \"10 PRINT 1\", it holds \"10 PRINT 1\\n20 PRINT 2\\n\"",
    );
    fails("file expect B:T.BAS \"\"", 3, "there is no file B:T.BAS");
    fails("file get B:T.BAS \"t.bas\"", 3, "there is no file B:T.BAS");
    let report = run("file put B:T.BAS \"two.bas\"\nfile get B:T.BAS \"copy.bas\"");
    assert_eq!(
        report.files,
        [("copy.bas".to_owned(), b"10 PRINT 1\n20 PRINT 2\n".to_vec())]
    );
    let report = run("type RUN\nload \"none.bas\"");
    let found = (report.outcome, report.line, report.message.as_str());
    assert_eq!(found, (Outcome::Unusable, 4, "none.bas: no such file"));
    assert_eq!(report.simulated.0, 0, "nothing has run");
}

#[test]
fn programs_that_cannot_be_loaded() {
    let report = run("load \"bad.bas\"");
    assert_eq!((report.outcome, report.line), (Outcome::Failed, 3));
    assert!(
        report.message.starts_with("bad.bas:2: ?"),
        "{}",
        report.message
    );
    let report = run("program\n10 PRINT 1\nPRINT 2\nend");
    assert_eq!((report.outcome, report.line), (Outcome::Failed, 5));
}

#[test]
fn repeating() {
    holds(
        "repeat 3\ntype A=A+1\nrepeat 2\ntype B=B+1\nend\nend\nreply \"\"\ncheck A = 3\ncheck B = 6",
    );
    fails(
        "repeat 3\ntype A=A+1\nreply \"\"\ncheck A < 3\nend",
        6,
        "expected A < 3, it is 3",
    );
}

#[test]
fn scheduling() {
    holds(
        "run 0.5s\nat 1s check in3 = 0\nat 1s wire in3 1\nat 0.9s check in3 = 0\nrun 1s\ncheck in3 = 1",
    );
    // At the same time: in the order in which they were scheduled.
    holds("at 1s wire in3 1\nat 1s wire in3 0\nrun 1s\nrun 2ms\ncheck in3 = 0");
    fails(
        "run 0.5s\nat 0.2s wire in3 1",
        4,
        "0.2 s is over: it is 0.5 s",
    );
    fails(
        "at 1s wire in3 1\nrun 0.4s",
        3,
        "the scenario ends 0.6 s before this is due",
    );
    fails(
        "at 0.2s check x.position = 5\nrun 1s",
        3,
        "expected x.position = 5, it is 0",
    );
    fails(
        "power off\nat 1s wire in3 1",
        4,
        "times count from `power on`, and it is off",
    );
}

#[test]
fn rewinding() {
    // Everything is as it was: motion, variables, output, what is scheduled, what was folded.
    holds(
        "type A=1:MDRVEN():MMOVE(40960)\nrun 1s\ntype A=2\nrun 1s\ncheck A = 2\nrewind 1s\nrun 0.5s\ncheck A = 2\n\
         rewind 1s\ncheck A = 1\nrun until idle\ncheck x.position = 40960",
    );
    holds("at 0.5s wire in3 1\nrun 0.75s\nrewind 0.5s\ncheck in3 = 0\nrun 0.5s\ncheck in3 = 1");
    holds(
        "run 1s\ntype PRINT 1\nreply \" 1 \"\nrun 1s\nrewind 1.5s\nexpect \">\"\nexpect nothing\nrun 0.5s",
    );
    fails("run 1s\nrewind 2s", 4, "only 1 s can be taken back");
}

#[test]
fn a_rewound_run_goes_on_as_it_did() {
    let straight = run("type MDRVEN():MMOVE(40960)\nrun 3s");
    let rewound =
        run("type MDRVEN():MMOVE(40960)\nrun 2.5s\nrewind 1.7s\nrun 0.1s\nrewind 0.1s\nrun 2.2s");
    assert_eq!(straight.outcome, Outcome::Held);
    assert_eq!(straight.simulated, rewound.simulated);
    assert_eq!(straight.digest, rewound.digest);
}

#[test]
fn known_failures() {
    let report = run("known-failure \"not yet\"\ncheck x.position = 5");
    assert_eq!((report.outcome, report.line), (Outcome::KnownFailure, 4));
    assert_eq!(
        report.message,
        "expected x.position = 5, it is 0 (known failure: not yet)"
    );
    assert!(report.is_ok());
    fails(
        "known-failure \"not yet\"\ncheck x.position = 0",
        3,
        "marked as a known failure (not yet), but everything held",
    );
    // A missing file is no failure of the controller.
    let report = run("known-failure \"not yet\"\nload \"none.bas\"");
    assert_eq!(report.outcome, Outcome::Unusable);
}

#[test]
fn two_stations_have_their_own_consoles() {
    let report = run_whole(
        "bench mc600 as left\nbench mc600 as right\nleft: power on\nright: power on\nleft: type A=1\ntype A=2\n\
         left: reply \"\"\nreply \"\"\nleft: check A = 1\ncheck A = 2\nleft: check ever A = 1\n\
         at 1s wire in1 1\nrun 2s\ncheck in1 = 1\nleft: check in1 = 0",
    );
    assert_eq!(
        (report.outcome, report.message.as_str()),
        (Outcome::Held, "")
    );
    let report = run_whole(
        "bench mc600 as left\nbench mc600 as right\nleft: power on\nleft: type 10 GOTO 10\nleft: type RUN\n\
         left: run until idle within 1s",
    );
    assert!(
        report
            .message
            .starts_with("not idle within 1 s: left: the program runs in line 10; "),
        "{}",
        report.message
    );
}

#[test]
fn the_line_and_its_settings() {
    holds("line baud=9600 parity=N bits=8 stop=1 flow=xon\ntype PRINT 1\nreply \" 1 \"");
    let report = run("line baud=1200\ntype PRINT 1\nreply \" 1 \" within 2s");
    assert_eq!(report.outcome, Outcome::Failed);
    holds("break\ntype PRINT 1\nrun 1s");
}

#[test]
fn endless_scenarios_end() {
    fails(
        "run 1s\nrun 1440min",
        4,
        "a scenario simulates at most 86400 s",
    );
    fails(
        "repeat 1000000\nrepeat 1000000\nexpect exactly \"\"\nend\nend",
        5,
        "a scenario executes at most 10000000 statements",
    );
}

#[test]
fn the_schedule_is_bounded() {
    fails(
        "repeat 10001\nat 1s check x.position = 0\nend",
        4,
        "at most 10000 statements wait for their time",
    );
}
