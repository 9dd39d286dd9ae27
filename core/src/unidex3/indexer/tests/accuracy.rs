//! No pulse is ever lost or added: random moves against a counter of its own at the clock output.

use super::*;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) % bound
    }

    /// Often short, sometimes long, both ways.
    fn steps(&mut self) -> i64 {
        let most = [2, 10, 100, 400][self.below(4) as usize];
        let steps = self.below(most + 1) as i64;
        if self.below(2) == 0 { steps } else { -steps }
    }

    fn feedrate(&mut self) -> Feedrate {
        match self.below(3) {
            0 => Feedrate::frequency(150_000 - self.below(100_000) as u32),
            1 => Feedrate::frequency(5000 + self.below(20_000) as u32),
            _ => Feedrate::period(6 + self.below(100) as u32),
        }
        .unwrap()
    }

    fn ramp(&mut self, feedrate: Feedrate) -> Option<Ramp> {
        let time = 23 + self.below(40) as u32;
        match self.below(4) {
            0 => Some(Ramp::timed(
                Shape::Linear,
                time,
                Feedrate::start_stop(3000).unwrap(),
            )),
            1 => Some(Ramp::timed(
                Shape::Exponential,
                time,
                Feedrate::start_stop(166_500).unwrap(),
            )),
            2 => Some(Ramp::rated(feedrate, 5_000_000)),
            _ => None,
        }
    }

    fn order(&mut self) -> Move {
        let (steps, feedrate) = ((self.steps(), self.steps()), self.feedrate());
        let ramp = self.ramp(feedrate);
        let leg = |steps, feedrate| Some(Leg { steps, feedrate });
        match self.below(4) {
            0 => Move::vector(steps.0, steps.1, feedrate, ramp),
            1 => Move::independent(leg(steps.0, feedrate), None, ramp),
            2 => Move::independent(None, leg(steps.1, feedrate), ramp),
            _ => Move::independent(leg(steps.0, feedrate), leg(steps.1, self.feedrate()), ramp),
        }
    }
}

/// What the orders add up to, by axis.
#[derive(Default)]
struct Sum(i64, i64);

fn commanded(order: &Move) -> (i64, i64) {
    let of = |leg: Option<Leg>| leg.map_or(0, |leg| leg.steps);
    (of(order.legs.x), of(order.legs.y))
}

#[track_caller]
fn assert_counted(unit: &Unit) {
    let (x, y) = unit.registers();
    let counter = |axis| unit.indexer.signals(axis).clocked;
    assert_eq!((x as f64, y as f64), (counter(Axis::X), counter(Axis::Y)));
}

/// Moves that end on their count, moves that an input aborts and moves that a limit stops, in turn.
fn wander(seed: u64, moves: u32, drive: DriveKind) {
    let mut random = Random(seed);
    let mut unit = Unit::new(drive);
    let mut sum = Sum::default();
    for _ in 0..moves {
        let order = random.order();
        unit.start(order);
        match random.below(8) {
            0 => abort(&mut unit, &mut random),
            1 => limit(&mut unit, &mut random),
            _ => {
                unit.until(|indexer| indexer.is_complete(true));
                let (x, y) = commanded(&order);
                sum = Sum(sum.0 + x, sum.1 + y);
                assert_eq!(unit.registers(), (sum.0, sum.1), "{order:?}");
            }
        }
        assert_counted(&unit);
        let (x, y) = unit.registers();
        sum = Sum(x, y);
    }
    unit.until(|indexer| !indexer.is_moving());
    assert_eq!(unit.tracking(), unit.registers());
    unit.run(10);
    assert_counted(&unit);
}

/// An input ends the move at any microsecond; the register does not change any more.
fn abort(unit: &mut Unit, random: &mut Random) {
    unit.indexer
        .arm(unit.now, 2, Interrupt::Abort, Edge::Falling);
    let at = unit.now + Nanos::from_micros(random.below(3000));
    unit.indexer.wire(at, "C2", 0.0).unwrap();
    assert_eq!(unit.events(), [Event::Abort(2)]);
    let there = unit.registers();
    unit.run(9);
    assert_eq!(unit.registers(), there);
    unit.indexer.disarm(unit.now, 2);
    unit.wire("C2", 1.0);
    unit.run(6);
}

/// A limit switch that no axis pushes pulses into closes at any microsecond.
fn limit(unit: &mut Unit, random: &mut Random) {
    let at = unit.now + Nanos::from_micros(random.below(3000));
    let fault = |unit: &mut Unit, at, active| {
        let done = unit.indexer.fault(at, "limit+", Some("y"), active);
        done.unwrap();
    };
    fault(unit, at, true);
    assert_eq!(unit.events(), [Event::Limit(Axis::Y)]);
    let there = unit.registers();
    unit.run(4);
    assert_eq!(unit.registers(), there);
    fault(unit, unit.now, false);
}

/// Random moves between limit switches: a limit loses no count, and what its drive holds back is all that register and
/// tracking display differ by.
#[test]
fn between_limits_every_pulse_is_accounted_for() {
    for (drive, seed) in [(DriveKind::StepperLow, 5), (DriveKind::Dc, 6)] {
        let mut random = Random(seed);
        let mut unit = Unit::new(drive);
        unit.configure("x", "limits", "-300..300");
        unit.configure("y", "limits", "-100..500");
        let mut limits = 0;
        for _ in 0..500 {
            let barred = |unit: &Unit, axis| {
                [Direction::Positive, Direction::Negative]
                    .map(|direction| unit.indexer.is_barred(axis, direction))
            };
            let before = (unit.registers(), unit.tracking());
            let free = barred(&unit, Axis::X) == [false; 2] && barred(&unit, Axis::Y) == [false; 2];
            unit.start(random.order());
            unit.until(|indexer| indexer.is_complete(true) && !indexer.is_moving());
            assert_counted(&unit);
            limits += unit.events().len();
            let ((x0, y0), (tx0, ty0)) = before;
            let ((x, y), (tx, ty)) = (unit.registers(), unit.tracking());
            if free && drive == DriveKind::StepperLow {
                assert_eq!((x - x0, y - y0), (tx - tx0, ty - ty0));
            }
            assert!(
                (x - x0).abs() >= (tx - tx0).abs() - 1,
                "{x0} {x} {tx0} {tx}"
            );
            assert!(
                (y - y0).abs() >= (ty - ty0).abs() - 1,
                "{y0} {y} {ty0} {ty}"
            );
        }
        assert!(limits > 20, "{limits}");
        assert_ne!(unit.registers(), unit.tracking());
    }
}

#[test]
fn a_thousand_random_moves_count_true() {
    wander(1, 500, DriveKind::StepperLow);
    wander(2, 500, DriveKind::Dc);
}

/// `cargo test --release -p motionbench-core a_million -- --ignored`
#[test]
#[ignore = "a long run"]
fn a_million_random_moves_count_true() {
    wander(3, 600_000, DriveKind::StepperHigh);
    wander(4, 500_000, DriveKind::Dc);
}

/// One order, wire, fault or jumper of any kind at any microsecond.
fn anything(unit: &mut Unit, random: &mut Random) {
    let at = unit.now + Nanos::from_micros(random.below(1000));
    let axis = Axis::BOTH[random.below(2) as usize];
    let direction = Direction::of(random.below(2) as i64 - 1);
    let input = random.below(6) as u8;
    let indexer = &mut unit.indexer;
    match random.below(18) {
        0..3 => indexer.start(at, &random.order()),
        3 => indexer.slew(at, axis, direction, random.feedrate()),
        4 => indexer.step(at, axis, direction),
        5 => indexer.joystick(at, Some(random.below(70_000) as u32)),
        6 => indexer.stop_axis(at, axis),
        7 => {
            let interrupt = [Interrupt::Feedhold, Interrupt::Abort][random.below(2) as usize];
            let edge = [Edge::Falling, Edge::Rising][random.below(2) as usize];
            indexer.arm(at, input, interrupt, edge);
        }
        8 => indexer.disarm(at, input),
        9 => indexer.count(at, random.below(100)),
        10 => indexer.reset_drive(at, axis),
        11 => indexer.clear_tracking(at, axis),
        12 => indexer.set_config(
            at,
            Config {
                drive: [DriveKind::Dc, DriveKind::StepperLow][random.below(2) as usize],
                reversed: Pair::same(random.below(2) == 0),
                ..Config::default()
            },
        ),
        13..16 => {
            let wires = Indexer::wires();
            let name = &wires[random.below(wires.len() as u64) as usize];
            let value = [-2000.0, 0.0, 1.0, 1.0, 54_321.0][random.below(5) as usize];
            let _ = indexer.wire(at, name, value);
        }
        16 => {
            let kind = FAULTS[random.below(6) as usize];
            let name = ["x", "y"][random.below(2) as usize];
            let active = random.below(3) == 0;
            indexer.fault(at, kind, Some(name), active).unwrap();
        }
        _ => indexer.stop(at),
    }
}

#[test]
fn whatever_is_ordered_no_pulse_is_lost() {
    for seed in 0..20 {
        let mut random = Random(seed);
        let mut unit = Unit::dc();
        for _ in 0..500 {
            anything(&mut unit, &mut random);
            unit.run(1 + random.below(5));
            assert_counted(&unit);
            let copy = unit.indexer.clone();
            assert!(copy.signals(Axis::X).shaft.is_finite());
        }
        unit.indexer.power_off(unit.now);
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(unit.registers(), (0, 0));
    }
}
