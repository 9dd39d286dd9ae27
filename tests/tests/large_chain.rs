//! As many SmartMotors on one line as there are addresses.
#![cfg(not(target_family = "wasm"))]

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::{Debug, DebugReply, Value};
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

const MOTORS: u8 = 100;

/// The byte in front of commands for a motor.
fn address(motor: u8) -> u8 {
    128 + motor
}

#[test]
fn a_hundred_motors_are_addressed_and_answer() {
    let kind = catalog::kind("smartmotor").unwrap();
    let mut bench = Bench::new();
    for index in 0..usize::from(MOTORS) {
        bench.add("motor", kind.create(&[]).unwrap(), (index > 0).then_some(0));
        bench.power(index, true);
    }
    let mut probe = Probe::default();
    let mut send = |bytes: &[u8], ms: u64| -> Vec<u8> {
        assert_eq!(bench.send(0, bytes), bytes.len());
        let until = bench.now() + Nanos::from_millis(ms);
        bench.run_until(until, &mut probe);
        let received = probe.console.drain(..).map(|received| received.byte);
        received.collect()
    };
    // The first that hears it gets the address, and then lets the rest through.
    for motor in 1..=MOTORS {
        let own = address(motor);
        let command = format!("SADDR{motor}\r");
        // Each word has its address: after ECHO the next motor hears it, too.
        let words = [&[own], &b"ECHO\r"[..], &[own], b"SLEEP\r"].concat();
        let bytes = [b"\x80", command.as_bytes(), &words].concat();
        send(&bytes, 30 + 2 * u64::from(motor));
    }
    send(b"\x80WAKE\r", 400);
    for motor in [1, 50, MOTORS] {
        let set = format!("a={} Ra\r", u32::from(motor) * 3);
        let answer = send(&[&[address(motor)], set.as_bytes()].concat(), 600);
        let expected = format!("{}\r", u32::from(motor) * 3);
        assert!(answer.ends_with(expected.as_bytes()), "{motor}: {answer:?}");
    }
    let values = (0..usize::from(MOTORS)).map(|index| {
        let station = bench.station_mut(index).unwrap();
        let mut read = |name: &str| station.debug(Debug::Read(name.to_owned()));
        ["ADDR", "a"].map(&mut read)
    });
    for (index, [own, a]) in (1u8..).zip(values) {
        assert_eq!(own, DebugReply::Value(Value::Number(f64::from(index))));
        let set = [1, 50, MOTORS].contains(&index);
        let expected = if set { f64::from(index) * 3.0 } else { 0.0 };
        assert_eq!(a, DebugReply::Value(Value::Number(expected)), "{index}");
    }
}
