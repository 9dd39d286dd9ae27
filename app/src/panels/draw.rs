//! Drawing at the browser's pace.

use std::cell::Cell;
use std::rc::Rc;

use std::time::Duration;

use leptos::prelude::{request_animation_frame, set_timeout};

/// Returns a function that has `draw` called before the browser next paints: once, however often it is asked to.
pub(super) fn before_paint(draw: impl Fn() + 'static) -> impl Fn() + Clone + 'static {
    once(draw, request_animation_frame)
}

/// Returns a function that has `act` called after `wait`: once, however often it is asked to meanwhile.
pub(super) fn after(wait: Duration, act: impl Fn() + 'static) -> impl Fn() + Clone + 'static {
    once(act, move |call| set_timeout(call, wait))
}

/// Returns a function to call at each of some events. As long as there are any, `tell` is told after each `wait` how many
/// there were meanwhile; the last time, that there was none.
pub(super) fn count(wait: Duration, tell: impl Fn(u32) + 'static) -> impl Fn() + Clone + 'static {
    let counter = Rc::new(Counter {
        wait,
        events: Cell::new(0),
        waits: Cell::new(false),
        tell: Box::new(tell),
    });
    move || {
        counter.events.set(counter.events.get() + 1);
        if !counter.waits.replace(true) {
            counter.clone().go_on();
        }
    }
}

struct Counter {
    wait: Duration,
    events: Cell<u32>,
    waits: Cell<bool>,
    tell: Box<dyn Fn(u32)>,
}

impl Counter {
    fn go_on(self: Rc<Counter>) {
        let wait = self.wait;
        set_timeout(
            move || {
                let events = self.events.take();
                (self.tell)(events);
                match events {
                    0 => self.waits.set(false),
                    _ => self.go_on(),
                }
            },
            wait,
        );
    }
}

fn once(
    act: impl Fn() + 'static,
    arrange: impl Fn(Box<dyn FnOnce()>) + Clone + 'static,
) -> impl Fn() + Clone + 'static {
    let asked = Rc::new(Cell::new(false));
    let act = Rc::new(act);
    move || {
        if asked.replace(true) {
            return;
        }
        let (asked, act) = (asked.clone(), act.clone());
        arrange(Box::new(move || {
            asked.set(false);
            act();
        }));
    }
}
