//! Positions that wrap, fractions of counts, limits of nothing.

use super::encoder::Encoder;
use super::*;

fn at(counts: i64) -> Planner {
    let mut planner = Planner::new(Encoder::new());
    planner.follow(counts << FRACTION, 0);
    planner
}

/// Where the axis went, in counts.
fn finish(planner: &mut Planner) -> i64 {
    let start = planner.reference.position;
    while planner.is_moving() {
        planner.sample(Blocked::default(), &Surroundings::default());
    }
    (planner.reference.position - start) >> FRACTION
}

fn here(planner: &Planner) -> i32 {
    planner.reading(planner.reference.position)
}

#[test]
fn positions_wrap_at_32_bits() {
    let mut planner = at(i64::from(i32::MAX));
    planner.move_by(10, false);
    assert_eq!(finish(&mut planner), 10);
    assert_eq!(here(&planner), i32::MIN + 9);
    planner.move_to(i32::MAX - 5, false);
    assert_eq!(
        finish(&mut planner),
        -15,
        "the shorter way, across the wrap"
    );
    assert_eq!(here(&planner), i32::MAX - 5);
}

#[test]
fn a_distance_that_does_not_fit_32_bits_wraps() {
    let mut planner = at(0);
    planner.move_by(i32::MAX, false);
    planner.move_by(i32::MAX, false);
    assert_eq!(finish(&mut planner), -2);
}

#[test]
fn a_move_lands_on_a_whole_count_wherever_it_starts() {
    let mut planner = at(0);
    planner.follow(1000 * 256 + 77, 12_345);
    planner.move_to(4000, false);
    finish(&mut planner);
    assert_eq!(planner.reference.position, 4000 << FRACTION);
}

#[test]
fn without_acceleration_nothing_moves_until_it_is_set() {
    let mut planner = at(0);
    planner.moves.acceleration = 0;
    planner.move_to(500, false);
    for _ in 0..100 {
        planner.sample(Blocked::default(), &Surroundings::default());
    }
    assert_eq!((here(&planner), planner.status()), (0, 1 << 13));
    planner.moves.acceleration = 70;
    assert_eq!(finish(&mut planner), 500);
}
