//! The reference loop: a register machine written by hand for `FOR I=1 TO N: S=S+I: NEXT`, the
//! least that interpreting that program can cost. It has none of what a controller has: no
//! breakpoints, no lines, no interrupts, no statement times.

use std::hint::black_box;

/// A register, by its index: a byte, so that no index needs a check.
type Slot = u8;
type Slots = [f64; 256];

#[derive(Clone, Copy)]
enum Op {
    Add {
        to: Slot,
        left: Slot,
        right: Slot,
    },
    /// Adds one to the counter and goes back to `body` until it is past the limit.
    Next {
        counter: Slot,
        limit: Slot,
        body: u16,
    },
    End,
}

const COUNTER: Slot = 0;
const SUM: Slot = 1;
const LIMIT: Slot = 2;

const PROGRAM: [Op; 3] = [
    Op::Add {
        to: SUM,
        left: SUM,
        right: COUNTER,
    },
    Op::Next {
        counter: COUNTER,
        limit: LIMIT,
        body: 0,
    },
    Op::End,
];

/// Makes `passes` passes of the loop and returns the sum.
pub(super) fn run(passes: u32) -> f64 {
    let mut slots = [0.0; 256];
    slots[usize::from(COUNTER)] = 1.0;
    slots[usize::from(LIMIT)] = f64::from(passes);
    // The compiler must not see which program this is.
    execute(black_box(&PROGRAM), black_box(&mut slots));
    slots[usize::from(SUM)]
}

#[inline(never)]
fn execute(code: &[Op], slots: &mut Slots) {
    let mut at = 0;
    while let Some(op) = code.get(at) {
        at += 1;
        match *op {
            Op::Add { to, left, right } => {
                slots[usize::from(to)] = slots[usize::from(left)] + slots[usize::from(right)];
            }
            Op::Next {
                counter,
                limit,
                body,
            } => {
                let count = slots[usize::from(counter)] + 1.0;
                slots[usize::from(counter)] = count;
                if count <= slots[usize::from(limit)] {
                    at = usize::from(body);
                }
            }
            Op::End => return,
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_loop_adds_up() {
        assert_eq!(super::run(100), 5050.0);
    }
}
