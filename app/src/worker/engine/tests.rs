use super::*;
use crate::protocol::Pace;
use crate::protocol::ToWorker::{Power, Run, Send, Stop};

/// Acts, lets simulated time pass, and returns what the console printed and the samples.
fn after(engine: &mut Engine, messages: &[ToWorker], millis: u64) -> Report {
    for message in messages {
        engine.act(message);
    }
    engine.advance(engine.now() + Nanos::from_millis(millis));
    engine.report()
}

fn text(text: &str) -> ToWorker {
    Send(text.to_owned())
}

fn bench() -> Engine {
    let mut engine = Engine::new("mc600").unwrap();
    let printed = after(&mut engine, &[], 500).console;
    assert!(printed.ends_with('>'), "{printed:?}");
    engine
}

#[test]
fn a_typed_program_moves_the_axis_and_answers() {
    let mut engine = bench();
    let program = text("10 MDRVEN()\r20 MMOVE(40960)\rRUN\r");
    let report = after(&mut engine, &[program], 3000);
    assert!(report.console.ends_with("RUN\r\n>"), "{:?}", report.console);
    let rows = report.samples.len() / (engine.info.signals.len() + 1);
    assert_eq!(rows, 1500);
    let command = engine
        .info
        .signals
        .iter()
        .position(|signal| signal.name == "x.command");
    let newest = report.samples[(command.unwrap() + 2) * rows - 1];
    assert_eq!(newest, 40_960.0);
    assert!(
        after(&mut engine, &[], 0).samples.is_empty(),
        "reported once"
    );
}

#[test]
fn characters_travel_at_line_speed() {
    let mut engine = bench();
    // 100 characters of 10 bits at 9600 baud take 104 ms.
    let report = after(&mut engine, &[text(&"A".repeat(100))], 50);
    assert!(
        (40..=48).contains(&report.console.len()),
        "{}",
        report.console.len()
    );
    assert!((50..=54).contains(&report.pending), "{}", report.pending);
}

#[test]
fn stop_acts_under_a_busy_program_and_a_paste() {
    let mut engine = bench();
    after(
        &mut engine,
        &[text("10 GOTO 10\rRUN\r"), text(&"X".repeat(100_000))],
        200,
    );
    let report = after(&mut engine, &[Stop], 100);
    assert!(
        report.console.ends_with("BREAK IN 10\r\n>"),
        "{:?}",
        report.console
    );
    assert_eq!((report.status.run, report.pending), (RunState::Idle, 0));
}

#[test]
fn run_starts_the_program_whatever_the_console_is_at() {
    let mut engine = bench();
    after(&mut engine, &[text("10 PRINT \"HELLO\"\r")], 200);
    assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
    after(&mut engine, &[text("20 HALF A LI")], 200);
    assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
    after(&mut engine, &[text("30 GOTO 30\rRUN\r")], 200);
    assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
}

const LOOP: &str = "10 A=A+1\n20 B=A*2\n30 GOTO 10";

fn load(text: &str) -> ToWorker {
    ToWorker::Load {
        text: text.to_owned(),
        start: true,
    }
}

#[test]
fn a_program_of_the_page_is_loaded_and_visibly_started() {
    let mut engine = bench();
    let Some(FromWorker::Loaded(Ok(revision))) = engine.act(&load("10 ?\"HI\"\n\n20 END")) else {
        panic!("not loaded");
    };
    assert_eq!(revision.lines, [Some(10), None, Some(20)]);
    let report = after(&mut engine, &[], 200);
    assert_eq!(report.console, "RUN\r\nHI\r\n>");
    assert_eq!(report.status.revision, revision.number);
    let refused = engine.act(&load("10 END\nEND"));
    let Some(FromWorker::Loaded(Err(refused))) = refused else {
        panic!("loaded");
    };
    assert_eq!(refused.line, 1);
    let listing = FromWorker::Listing {
        text: "10 ?\"HI\"\r\n20 END\r\n".to_owned(),
        revision: revision.number,
    };
    assert_eq!(engine.act(&ToWorker::Take), Some(listing));
}

#[test]
fn a_breakpoint_holds_program_and_time_and_a_step_runs_one_statement() {
    let mut engine = bench();
    after(
        &mut engine,
        &[ToWorker::Breakpoints(vec![20]), load(LOOP)],
        1000,
    );
    let held = engine.report();
    assert!(held.frozen);
    assert_eq!(
        (held.status.run, held.status.line),
        (RunState::Paused, Some(20))
    );
    let stepped = after(&mut engine, &[ToWorker::Step], 1000);
    assert_eq!(stepped.status.line, Some(30));
    assert!(stepped.frozen && stepped.now.since(held.now) < Nanos::from_millis(10));
    let again = after(&mut engine, &[ToWorker::Freeze(false)], 1000);
    assert_eq!((again.status.line, again.frozen), (Some(20), true));
    let free = [ToWorker::Breakpoints(Vec::new()), ToWorker::Freeze(false)];
    let free = after(&mut engine, &free, 1000);
    assert_eq!((free.status.run, free.frozen), (RunState::Running, false));
    let stopped = after(&mut engine, &[ToWorker::Freeze(true), Stop], 100);
    assert!(stopped.console.ends_with("\r\n>"), "{:?}", stopped.console);
}

#[test]
fn stop_ends_a_program_that_is_held() {
    let held_at = [
        ("mc600", LOOP, 20),
        ("smartmotor", "a=1\nWHILE 1\na=a+1\nLOOP\nEND", 2),
        ("unidex3", "M47 *\nX1 F100 *\nM30 *", 1),
    ];
    for (kind, program, line) in held_at {
        let mut engine = Engine::new(kind).unwrap();
        after(&mut engine, &[], 6000);
        engine.act(&ToWorker::Breakpoints(vec![line]));
        engine.act(&load(program));
        let held = after(&mut engine, &[], 1000);
        assert_eq!(
            (held.frozen, held.status.run),
            (true, RunState::Paused),
            "{kind}"
        );
        let stopped = after(&mut engine, &[Stop], 1000);
        assert_eq!(
            (stopped.frozen, stopped.status.run),
            (false, RunState::Idle),
            "{kind}"
        );
    }
}

#[test]
fn what_is_kept_comes_back_into_another_bench() {
    let mut engine = bench();
    after(&mut engine, &[load("10 END")], 200);
    after(&mut engine, &[text("SAVE \"B:ONE\"\rSAVE \"TWO\"\r")], 300);
    let Some(FromWorker::Kept(memory)) = engine.act(&ToWorker::Keep) else {
        panic!("nothing kept");
    };
    assert_eq!(engine.act(&ToWorker::Keep), None, "nothing has changed");
    let mut other = bench();
    let answer = after(
        &mut other,
        &[ToWorker::Restore(memory), text("LIST\rFILES\r")],
        300,
    );
    assert!(
        answer.console.contains("10 END\r\n"),
        "{:?}",
        answer.console
    );
    assert!(answer.console.contains("TWO.BAS"), "{:?}", answer.console);
    let off_and_on = after(
        &mut other,
        &[Power(false), Power(true), text("LOAD \"B:ONE\"\rLIST\r")],
        500,
    );
    assert!(
        off_and_on.console.ends_with("10 END\r\n>"),
        "{:?}",
        off_and_on.console
    );
}

#[test]
fn the_emergency_stop_acts_under_any_program() {
    let mut engine = bench();
    let spin = "10 MDRVEN()\n20 MSPEED(34952)\n30 GOTO 30";
    assert!(after(&mut engine, &[load(spin)], 2000).status.moving);
    let stopped = after(&mut engine, &[ToWorker::EmergencyStop(true)], 1000).status;
    assert!(!stopped.moving && !stopped.enabled, "{stopped:?}");
    assert_eq!(stopped.run, RunState::Running);
}

#[test]
fn the_mains_switch_forgets_the_program_and_what_was_being_sent() {
    let mut engine = bench();
    after(
        &mut engine,
        &[text("10 GOTO 10\rRUN\r"), text(&"X".repeat(1000))],
        100,
    );
    let report = after(&mut engine, &[Power(false)], 100);
    assert_eq!((report.status.power, report.pending), (false, 0));
    let report = after(&mut engine, &[Power(true)], 500);
    assert!(report.console.ends_with('>'), "{:?}", report.console);
    assert_eq!(
        after(&mut engine, &[text("LIST\r")], 200).console,
        "LIST\r\n>"
    );
}

#[test]
fn a_page_that_does_not_listen_stops_the_simulation() {
    let mut engine = bench();
    while !engine.is_full() {
        engine.advance(engine.now() + Nanos::from_millis(1000));
        assert!(engine.now() < Nanos::from_millis(1_000_000));
    }
    engine.report();
    assert!(!engine.is_full());
}

#[test]
fn a_file_is_sent_line_by_line_as_the_controller_asks_for_it() {
    let mut engine = bench();
    let program: String = (1..=50)
        .map(|n| format!("{}0 REM {}\r", n, "X".repeat(60)))
        .collect();
    let pace = Pace {
        character: Nanos::ZERO,
        line: Nanos::from_millis(20),
        prompt: true,
    };
    let send = ToWorker::SendPaced {
        text: program,
        pace,
    };
    let report = after(&mut engine, &[send, text("LIST 500\r")], 1000);
    assert!(report.pending > 2000, "{}", report.pending);
    // What the user types meanwhile comes behind it.
    let report = after(&mut engine, &[], 9000);
    assert_eq!(report.pending, 0);
    let listed = format!("LIST 500\r\n500 REM {}\r\n>", "X".repeat(60));
    assert!(report.console.ends_with(&listed), "{:?}", report.console);
}

#[test]
fn a_file_that_is_being_sent_can_be_cancelled_and_is_forgotten_by_a_stop() {
    let mut engine = bench();
    let send = || ToWorker::SendPaced {
        text: "10 REM\r".repeat(1000),
        pace: Pace::default(),
    };
    assert!(after(&mut engine, &[send()], 100).pending > 5000);
    assert_eq!(after(&mut engine, &[ToWorker::Cancel], 0).pending, 0);
    assert!(after(&mut engine, &[send()], 100).pending > 5000);
    assert!(after(&mut engine, &[Stop], 100).pending == 0);
}

/// Three units behind one panel, each with its message of a cleared memory put away.
fn panel_of_three() -> Engine {
    let mut engine = Engine::new("unidex3 units=3 memory=28k").unwrap();
    after(&mut engine, &[], 6000);
    engine
}

fn keys(names: &str) -> Vec<ToWorker> {
    let stroke = |name: &str, down| ToWorker::Key {
        key: name.to_owned(),
        down,
    };
    let names = names.split(' ');
    names
        .flat_map(|name| [stroke(name, true), stroke(name, false)])
        .collect()
}

#[test]
fn the_panel_and_what_is_told_are_those_of_the_selected_unit() {
    let mut engine = panel_of_three();
    assert_eq!(engine.ready().units, 3);
    let [first, second] = [0, 1].map(ToWorker::Select);
    let mut type_to = |unit: ToWorker, names: &str| {
        after(&mut engine, &[unit], 100);
        for key in keys(names) {
            after(&mut engine, &[key], 60);
        }
        after(&mut engine, &[], 1000)
    };
    let one = type_to(first, "IMD X 1 0 EXC");
    let two = type_to(second, "SLW");
    let x = |report: &Report| report.panel.as_ref().unwrap().tracking[0].1.clone();
    assert_eq!((one.unit, x(&one).as_str()), (0, "10"));
    assert_eq!((two.unit, x(&two).as_str()), (1, "0"));
    assert_eq!(two.panel.unwrap().display.trim(), "SLEW");
    assert_eq!(two.parts.len(), 3);
    assert!(two.parts.iter().all(|part| *part == two.parts[0]));
    assert_eq!(two.parts.iter().sum::<usize>(), two.samples.len());
    let back = type_to(ToWorker::Select(0), "CE");
    assert_eq!(x(&back), "10");
    let none = type_to(ToWorker::Select(3), "CE");
    assert_eq!(none.unit, 0, "there is no fourth");
}

#[test]
fn run_and_stop_work_whoever_has_the_unit() {
    let long = "G91 *\nX100000 F100 *";
    for before in ["EDT", "EDT 0 5 EXC X 1", "IMD X 1 0", "SLW", "AUT 0 1 EXC"] {
        let mut engine = Engine::new("unidex3").unwrap();
        after(&mut engine, &[], 6000);
        engine.act(&ToWorker::Load {
            text: long.to_owned(),
            start: false,
        });
        let press = |engine: &mut Engine, names: &str| {
            for key in keys(names) {
                after(engine, &[key], 60);
            }
        };
        press(&mut engine, before);
        assert!(!engine.status().listens, "{before}: the panel has it");
        engine.act(&load(long));
        assert!(after(&mut engine, &[], 2000).status.moving, "{before}");
        let stopped = after(&mut engine, &[Stop], 2000).status;
        assert!(!stopped.moving && stopped.run == RunState::Idle, "{before}");
        // And a program that was started at the panel.
        press(&mut engine, "RES");
        after(&mut engine, &[], 2000);
        press(&mut engine, "AUT 0 1 EXC");
        assert!(after(&mut engine, &[], 100).status.moving, "{before}");
        let stopped = after(&mut engine, &[Stop], 2000).status;
        assert!(!stopped.moving && stopped.run == RunState::Idle, "{before}");
    }
}

#[test]
fn run_is_heard_behind_a_line_that_was_left_half_typed() {
    let mut engine = Engine::new("unidex3").unwrap();
    after(&mut engine, &[], 6000);
    after(&mut engine, &[text("\u{1b}01\rIX1")], 100);
    for key in keys("RMT EDT") {
        after(&mut engine, &[key], 60);
    }
    engine.act(&load("G91 *\nX100000 F100 *"));
    assert!(after(&mut engine, &[], 3000).status.moving);
}

#[test]
fn run_takes_a_unit_from_the_bus() {
    let mut engine = Engine::new("unidex3").unwrap();
    after(&mut engine, &[], 6000);
    let orders = [
        ieee488::Order::RemoteEnable(true),
        ieee488::Order::Listen(vec![1]),
        ieee488::Order::Send(b"I G91 X10 F500\r\n".to_vec(), true),
    ];
    for order in orders {
        after(&mut engine, &[ToWorker::Bus(order)], 200);
    }
    assert!(!engine.status().listens && !engine.status().moving);
    engine.act(&load("G91 *\nX100000 F100 *"));
    assert!(after(&mut engine, &[], 3000).status.moving);
}

#[test]
fn run_starts_the_unit_that_is_selected_at_its_address() {
    for (name, unit) in [("unidex3 address=17", 0), ("unidex3 units=3 address=5", 2)] {
        let mut engine = Engine::new(name).unwrap();
        after(&mut engine, &[ToWorker::Select(unit)], 6000);
        engine.act(&load("G91 *\nX100000 F100 *"));
        after(&mut engine, &[], 1000);
        let moving = engine.stations().map(|unit| unit.status().moving);
        let expected: Vec<bool> = (0..engine.bench.len()).map(|at| at == unit).collect();
        assert_eq!(moving.collect::<Vec<bool>>(), expected);
    }
}

#[test]
fn stop_reaches_every_unit_behind_the_panel() {
    let mut engine = panel_of_three();
    for unit in 0..3 {
        engine.act(&ToWorker::Select(unit));
        let text = "G91 *\nX100000 F100 *".to_owned();
        engine.act(&ToWorker::Load { text, start: false });
        for key in keys("AUT 0 1 EXC") {
            after(&mut engine, &[key], 60);
        }
    }
    engine.act(&ToWorker::Select(1));
    let moving = |engine: &Engine| {
        engine
            .stations()
            .filter(|unit| unit.status().moving)
            .count()
    };
    assert_eq!(moving(&engine), 3);
    assert_eq!(after(&mut engine, &[Stop], 6000).unit, 1);
    assert_eq!(moving(&engine), 0);
}

#[test]
fn what_each_unit_holds_outlives_the_simulator() {
    let mut engine = panel_of_three();
    for unit in 0..3 {
        engine.act(&ToWorker::Select(unit));
        let text = format!("X{unit}");
        let loaded = engine.act(&ToWorker::Load { text, start: false });
        assert!(matches!(loaded, Some(FromWorker::Loaded(Ok(_)))));
    }
    let Some(FromWorker::Kept(memory)) = engine.act(&ToWorker::Keep) else {
        panic!("it has changed");
    };
    let mut again = panel_of_three();
    again.act(&ToWorker::Restore(memory));
    for unit in 0..3 {
        again.act(&ToWorker::Select(unit));
        let Some(FromWorker::Listing { text, .. }) = again.act(&ToWorker::Take) else {
            panic!("a unit has a program");
        };
        assert!(text.contains(&format!("X{unit}")), "{text}");
    }
}

#[test]
fn a_program_of_any_unit_that_is_held_holds_everything() {
    let mut engine = panel_of_three();
    engine.act(&ToWorker::Select(2));
    let text = "G91 *\nX1000 F100 *\nX1000 F100 *".to_owned();
    engine.act(&ToWorker::Load { text, start: false });
    engine.act(&ToWorker::Breakpoints(vec![1]));
    for key in keys("AUT 0 1 EXC") {
        after(&mut engine, &[key], 60);
    }
    engine.act(&ToWorker::Select(0));
    assert!(after(&mut engine, &[], 3000).frozen);
    let report = after(&mut engine, &[ToWorker::Freeze(false)], 100);
    assert!(!report.frozen);
    let third = after(&mut engine, &[ToWorker::Select(2)], 100);
    assert!(third.status.moving);
}

#[test]
fn a_step_in_one_unit_leaves_another_held() {
    let mut engine = panel_of_three();
    let long = format!("G91 *{}", "\nX100 F100 *".repeat(50));
    let programs = ["G91 *\nX400 F100 *\nX100 *", long.as_str()];
    for (unit, text) in programs.into_iter().enumerate() {
        engine.act(&ToWorker::Select(unit));
        let text = text.to_owned();
        engine.act(&ToWorker::Load { text, start: false });
        for key in keys("AUT 0 1 EXC") {
            after(&mut engine, &[key], 60);
        }
    }
    engine.act(&ToWorker::Select(0));
    engine.act(&ToWorker::Breakpoints(vec![2]));
    assert!(after(&mut engine, &[], 10_000).frozen);
    let mut step = |unit| {
        let report = after(
            &mut engine,
            &[ToWorker::Select(unit), ToWorker::Step],
            10_000,
        );
        assert!(report.frozen);
        report.status.line.unwrap()
    };
    // The first one holds it where it is.
    let first = step(1);
    assert_eq!([step(1), step(1)], [first, first + 1]);
    // The other one is where it was held.
    assert_eq!(step(0), 3);
}

#[test]
fn a_breakpoint_is_in_the_program_of_the_editor_alone() {
    let mut engine = Engine::new("unidex3").unwrap();
    after(&mut engine, &[], 6000);
    let text = "G91 *\nX1 F100 *\nX1000 F100 *".to_owned();
    engine.act(&ToWorker::Load { text, start: false });
    engine.act(&ToWorker::Breakpoints(vec![2]));
    let mut press = |names: &str| {
        for key in keys(names) {
            after(&mut engine, &[key], 60);
        }
        after(&mut engine, &[], 1000)
    };
    let other = press("EDT 0 7 EXC G 9 1 * X 5 0 0 F 1 0 0 * M 2 * AUT EXC");
    assert!(other.status.moving && !other.frozen);
    assert_eq!(other.status.line, None);
    press("RES");
    let own = press("AUT 0 1 EXC");
    assert!(own.frozen);
    assert_eq!(own.status.line, Some(2));
}
