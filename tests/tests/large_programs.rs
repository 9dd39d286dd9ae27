//! Programs that fill the card's memory: what is done with them as a whole takes simulated time, not the user's.
#![cfg(not(target_family = "wasm"))]

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::{RunState, Slot, Status};
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

const CARD: usize = 0;

/// A card with a program of 360,000 bytes behind `first`, at its prompt.
fn card(first: &str, speed: &str) -> Bench {
    let kind = catalog::kind("mc600").unwrap();
    let options = [("speed".to_owned(), speed.to_owned())];
    let mut bench = Bench::new();
    bench.add("card", kind.create(&options).unwrap(), None);
    bench.power(CARD, true);
    let remark = "X".repeat(66);
    let lines = (1000..6000).map(|line| format!("{line} REM {remark}\n"));
    let text = format!("{first}\n{}", lines.collect::<String>());
    let card = bench.station_mut(CARD).unwrap();
    card.load(&Slot::File("A:X.BAS".to_owned()), &text).unwrap();
    card.load(&Slot::Program, &text).unwrap();
    run(&mut bench, 20);
    bench
}

fn run(bench: &mut Bench, ms: u64) -> Status {
    bench.run_until(bench.now() + Nanos::from_millis(ms), &mut Probe::default());
    bench.station(CARD).unwrap().status()
}

#[test]
fn saving_takes_its_time_and_ctrl_c_does_not_wait_for_it() {
    let mut bench = card("10 END", "authentic");
    bench.send(0, b"SAVE \"B:Y\"\r");
    let saving = run(&mut bench, 100);
    assert_eq!((saving.run, saving.at_prompt), (RunState::Command, false));
    assert!(!run(&mut bench, 500).at_prompt);
    assert!(run(&mut bench, 200).at_prompt, "2 us a byte are 0.72 s");

    bench.send(0, b"SAVE \"B:Z\"\r");
    assert!(!run(&mut bench, 100).at_prompt);
    bench.send_urgent(0, &[0x03]);
    assert!(run(&mut bench, 50).at_prompt);
    let listing = |slot| bench.station(CARD).unwrap().listing(&slot);
    let saved = listing(Slot::File("B:Z.BAS".to_owned()));
    assert!(saved.is_some() && saved == listing(Slot::Program));
}

/// At 10,000 times the device's speed each of these would be done thousands of times a sample. They are the work of
/// seconds at the most for the whole test.
#[test]
fn a_program_that_handles_itself_does_not_stop_the_simulator() {
    for first in [
        "10 SAVE \"A:X\": GOTO 10",
        "10 RUN \"A:X\"",
        "10 SAVE \"A:X\": RUN \"A:X\"",
    ] {
        let mut bench = card(first, "fast");
        bench.send(0, b"RUN\r");
        let status = run(&mut bench, 40);
        assert_eq!(status.line, Some(10), "{first}: {status:?}");
        bench.send_urgent(0, &[0x03]);
        assert!(run(&mut bench, 50).at_prompt, "{first}");
    }
}
