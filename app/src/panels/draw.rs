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

/// Returns a function to call at each of some events. As long as there are any, `tell` is told after each `wait` whether
/// there was one meanwhile; the last time, that there was none.
pub(super) fn watch(wait: Duration, tell: impl Fn(bool) + 'static) -> impl Fn() + Clone + 'static {
    let watch = Rc::new(Watch {
        wait,
        happened: Cell::new(false),
        waits: Cell::new(false),
        tell: Box::new(tell),
    });
    move || {
        watch.happened.set(true);
        if !watch.waits.replace(true) {
            watch.clone().go_on();
        }
    }
}

struct Watch {
    wait: Duration,
    happened: Cell<bool>,
    waits: Cell<bool>,
    tell: Box<dyn Fn(bool)>,
}

impl Watch {
    fn go_on(self: Rc<Watch>) {
        let wait = self.wait;
        set_timeout(
            move || {
                let happened = self.happened.take();
                (self.tell)(happened);
                match happened {
                    true => self.go_on(),
                    false => self.waits.set(false),
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
