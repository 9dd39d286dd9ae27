//! Interrupts under the debugger: breakpoints in a subroutine, steps into and out of it, and places that tell apart.
#![cfg(not(target_family = "wasm"))]

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::{
    Control, Debug, DebugReply, Input, RunState, Slot, Status, Value,
};
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

const CARD: usize = 0;

const PROGRAM: &str = "10 INTSETUP(100,0,1)\n20 N=N+1: GOTO 20\n100 M=M+1\n110 RETI\n";

/// A card that runs the program, 50 ms after RUN was typed.
fn running() -> Bench {
    let kind = catalog::kind("mc600").unwrap();
    let mut bench = Bench::new();
    let line = bench.add("card", kind.create(&[]).unwrap(), None);
    bench.power(CARD, true);
    let card = bench.station_mut(CARD).unwrap();
    card.load(&Slot::Program, PROGRAM).unwrap();
    bench.send(bench.line_of(line).unwrap(), b"RUN\r");
    run(&mut bench, 50);
    bench
}

fn run(bench: &mut Bench, milliseconds: u64) {
    let until = bench.now() + Nanos(milliseconds * 1_000_000);
    bench.run_until(until, &mut Probe::default());
}

fn debug(bench: &mut Bench, command: Debug) -> DebugReply {
    bench.station_mut(CARD).unwrap().debug(command)
}

fn read(bench: &mut Bench, name: &str) -> f64 {
    match debug(bench, Debug::Read(name.to_owned())) {
        DebugReply::Value(Value::Number(number)) => number,
        other => panic!("{name}: {other:?}"),
    }
}

fn status(bench: &Bench) -> Status {
    bench.station(CARD).unwrap().status()
}

fn rise(bench: &mut Bench) {
    let name = "in0".to_owned();
    bench.input(CARD, Input::Wire { name, value: 1.0 }).unwrap();
}

fn step(bench: &mut Bench) -> (Option<u32>, u64) {
    debug(bench, Debug::Control(Control::Step));
    run(bench, 10);
    let status = status(bench);
    assert_eq!(status.run, RunState::Paused);
    (status.line, status.spent)
}

#[test]
fn a_breakpoint_in_the_subroutine_holds_and_steps_lead_back() {
    let mut bench = running();
    debug(&mut bench, Debug::Breakpoints(vec![100]));
    run(&mut bench, 20);
    assert_eq!(status(&bench).run, RunState::Running);
    rise(&mut bench);
    run(&mut bench, 20);
    assert_eq!(
        (status(&bench).run, status(&bench).line),
        (RunState::Paused, Some(100))
    );
    let n = read(&mut bench, "N");
    assert_eq!(read(&mut bench, "M"), 0.0);
    assert_eq!(step(&mut bench).0, Some(110));
    assert_eq!(read(&mut bench, "M"), 1.0);
    assert_eq!(step(&mut bench).0, Some(20));
    assert_eq!(read(&mut bench, "N"), n, "the program goes on where it was");
    debug(&mut bench, Debug::Control(Control::Continue));
    run(&mut bench, 20);
    assert!(read(&mut bench, "N") > n);
}

#[test]
fn before_the_interrupt_and_its_first_line_are_different_places() {
    let mut bench = running();
    debug(&mut bench, Debug::Control(Control::Pause));
    run(&mut bench, 10);
    let mut places = vec![(status(&bench).line, status(&bench).spent)];
    rise(&mut bench);
    run(&mut bench, 10);
    let start = bench.clone();
    while places.len() < 6 {
        places.push(step(&mut bench));
    }
    let lines: Vec<Option<u32>> = places.iter().map(|&(line, _)| line).collect();
    assert!(
        lines.contains(&Some(100)) && lines.contains(&Some(110)),
        "{lines:?}"
    );
    for (&(line, spent), &(_, next)) in places.iter().zip(&places[1..]) {
        assert!(next > spent);
        let mut again = start.clone();
        debug(&mut again, Debug::Control(Control::RunTo(spent)));
        run(&mut again, 50);
        assert_eq!((status(&again).line, status(&again).spent), (line, spent));
    }
}
