use super::*;

fn arm(unit: &mut Unit, input: u8, interrupt: Interrupt, edge: Edge) {
    unit.indexer.arm(unit.now, input, interrupt, edge);
}

/// An input changes inside a sample.
fn wire_later(unit: &mut Unit, us: u64, name: &str, value: f64) {
    let at = unit.now + Nanos::from_micros(us);
    unit.indexer.wire(at, name, value).unwrap();
}

#[test]
fn an_abort_keeps_the_true_position() {
    let mut unit = Unit::stepper();
    arm(&mut unit, 3, Interrupt::Abort, Edge::Falling);
    unit.start(x(5000, 10_000));
    unit.run(100);
    // 10,000 steps/s: one each 100 us.
    wire_later(&mut unit, 450, "C3", 0.0);
    unit.run(50);
    assert_eq!((unit.registers().0, unit.tracking().0), (1004, 1004));
    assert!(unit.indexer.is_complete(true));
    let (at, event) = unit.indexer.take_event().unwrap();
    assert_eq!((at, event), (Nanos::from_micros(100_450), Event::Abort(3)));
}

#[test]
fn only_the_armed_edge_of_the_armed_input_interrupts() {
    let mut unit = Unit::stepper();
    arm(&mut unit, 1, Interrupt::Abort, Edge::Falling);
    arm(&mut unit, 1, Interrupt::Abort, Edge::Rising);
    arm(&mut unit, 2, Interrupt::Abort, Edge::Falling);
    unit.indexer.disarm(unit.now, 2);
    unit.start(x(10_000, 1000));
    for name in ["C1", "C2", "C3"] {
        unit.wire(name, 0.0);
    }
    unit.run(10);
    assert_eq!(unit.events(), []);
    unit.wire("C2", 1.0);
    unit.wire("C1", 1.0);
    assert_eq!(unit.events(), [Event::Abort(1)]);
}

#[test]
fn a_reset_input_stops_at_once_and_asks_for_the_reset() {
    let mut unit = Unit::dc();
    arm(&mut unit, 4, Interrupt::Reset, Edge::Falling);
    unit.start(x(10_000, 1000));
    unit.run(20);
    unit.wire("C4", 0.0);
    assert_eq!(unit.events(), [Event::Reset(4)]);
    assert!(!unit.indexer.is_busy(Axis::X));
    unit.indexer.reset(unit.now);
    assert_eq!(unit.registers(), (0, 0));
    unit.wire("C4", 1.0);
    unit.run(10);
    unit.wire("C4", 0.0);
    unit.run(10);
    assert_eq!(unit.events(), []);
}

/// 6-6: several inputs are like switches in series.
#[test]
fn all_inputs_must_release_a_hold() {
    let mut unit = Unit::stepper();
    unit.wire("C1", 0.0);
    unit.wire("C2", 0.0);
    unit.run(10);
    arm(&mut unit, 1, Interrupt::Feedhold, Edge::Rising);
    arm(&mut unit, 2, Interrupt::Feedhold, Edge::Rising);
    unit.start(x(1000, 10_000));
    unit.run(10);
    for (input, level, held) in [
        ("C1", 1.0, true),
        ("C2", 1.0, true),
        ("C1", 0.0, true),
        ("C2", 0.0, false),
    ] {
        unit.wire(input, level);
        assert_eq!(unit.indexer.is_held(), held, "{input} {level}");
        unit.run(10);
    }
    // 30 ms held: of 50 ms 20 went on.
    assert_eq!(unit.registers(), (200, 0));
    assert_eq!(unit.indexer.held_for(), Nanos::from_millis(30));
    unit.run(81);
    assert!(unit.indexer.is_complete(true));
    assert_eq!(unit.registers(), (1000, 0));
}

#[test]
fn a_feedhold_input_stops_the_clock_of_its_axis() {
    let mut unit = Unit::stepper();
    unit.start(Move::independent(
        Some(leg(100, 1000)),
        Some(leg(100, 1000)),
        None,
    ));
    unit.wire("feedholdy", 0.0);
    unit.run(101);
    assert_eq!(unit.registers(), (100, 0));
    unit.wire("feedholdy", 1.0);
    unit.run(101);
    assert_eq!(unit.registers(), (100, 100));
}

#[test]
fn a_bouncing_contact_is_one_edge_unless_the_jumper_says_otherwise() {
    for (debounced, edges) in [(true, 1), (false, 3)] {
        let mut unit = Unit::of(Config {
            debounced: [debounced; 4],
            ..Config::default()
        });
        arm(&mut unit, 1, Interrupt::Abort, Edge::Falling);
        for us in [100, 300, 500] {
            wire_later(&mut unit, us, "C1", 0.0);
            wire_later(&mut unit, us + 50, "C1", 1.0);
        }
        wire_later(&mut unit, 700, "C1", 1.0);
        unit.run(20);
        assert_eq!(unit.events().len(), edges);
        assert!(unit.indexer.input(1));
    }
}

/// 5-3.
#[test]
fn the_external_clock_is_counted() {
    let mut unit = Unit::dc();
    unit.wire("clock", 0.0);
    unit.indexer.count(unit.now, 3);
    for left in [3, 2, 1, 0, 0] {
        assert_eq!(unit.indexer.counts_left(), left);
        unit.wire("clock", 1.0);
        unit.wire("clock", 0.0);
    }
    unit.wire("clockrate", 500_000.0);
    unit.indexer.count(unit.now, 50_000);
    let seconds = unit.until(|indexer| indexer.counts_left() == 0);
    assert_eq!(seconds, 0.1);
    unit.indexer.count(unit.now, 50_000);
    arm(&mut unit, 1, Interrupt::Abort, Edge::Falling);
    unit.wire("C1", 0.0);
    assert_eq!(unit.indexer.counts_left(), 0);
}

#[test]
fn what_is_not_there_is_refused_in_one_line() {
    let mut unit = Unit::dc();
    let at = unit.now;
    for (name, value) in [
        ("C5", 1.0),
        ("C1", 2.0),
        ("C1", f64::NAN),
        ("clockrate", 500_001.0),
        ("joyx", f64::INFINITY),
    ] {
        let error = unit.indexer.wire(at, name, value).unwrap_err();
        assert!(error.contains(name) && !error.contains('\n'), "{error}");
    }
    let fault = |unit: &mut Unit, kind, axis| unit.indexer.fault(at, kind, axis, true);
    assert!(fault(&mut unit, "flood", None).is_err());
    assert!(fault(&mut unit, "stall", Some("z")).is_err());
    assert!(unit.indexer.configure(at, "z", "inertia", "1").is_err());
    assert!(unit.indexer.configure(at, "y", "colour", "1").is_err());
}
