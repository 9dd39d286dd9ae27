//! How fast simulated time passes, and in which portions, changes nothing.

#![cfg(not(target_family = "wasm"))]

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::Slot;
use motionbench_core::probe::{ConsoleByte, Probe};
use motionbench_core::time::Nanos;
use proptest::prelude::*;

const PROGRAM: &str = "10 MDRVEN():MV_SPEED%=60000:MV_ACC%=700\n20 FOR I=1 TO 3:MMOVE(I*9000)\n\
                       30 PRINT I;GV_FEEDBACK%\n40 IF SL_POSDEMAND%<I*9000 THEN 30\n50 NEXT\n";
const END: Nanos = Nanos::from_millis(3000);

/// All that can be seen of a run in portions: every console byte, and every recorded number as its bits.
fn run(mut portions: impl Iterator<Item = u64>) -> (Vec<ConsoleByte>, Vec<u64>) {
    let kind = catalog::kind("mc600").unwrap();
    let mut bench = Bench::new();
    let station = bench.add("one", kind.create(&[]).unwrap(), None);
    let mut probe = Probe::recording();
    bench.power(station, true);
    bench
        .station_mut(station)
        .unwrap()
        .load(&Slot::Program, PROGRAM)
        .unwrap();
    bench.send(0, b"RUN\r");
    while bench.now() < END {
        let portion = portions
            .next()
            .map_or(END, |portion| bench.now() + Nanos(portion));
        bench.run_until(portion.min(END), &mut probe);
    }
    let trace = &probe.traces[station];
    let numbers = (0..trace.signals()).flat_map(|signal| trace.rows(signal));
    let bits = numbers
        .flat_map(|(at, value)| [at.0, value.to_bits()])
        .collect();
    (probe.console, bits)
}

#[test]
fn the_program_moves_and_prints() {
    let (console, bits) = run(std::iter::empty());
    let printed: Vec<u8> = console.iter().map(|received| received.byte).collect();
    assert!(
        printed.starts_with(b">RUN\r\n 1  "),
        "{}",
        String::from_utf8_lossy(&printed)
    );
    assert!(bits.contains(&27_000_f64.to_bits()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn portions_of_any_length_give_the_same_bits(
        portions in prop::collection::vec(prop_oneof![1_u64..100_000, 1_u64..5_000_000, 1_u64..400_000_000], 1..200)
    ) {
        let whole = run(std::iter::empty());
        prop_assert!(run(portions.into_iter().cycle()) == whole);
    }
}
