//! The worker: runs the bench in short chunks, listens to the page between them, and reports to it.

pub mod engine;
pub mod pacing;
pub mod sender;
pub mod units;

use std::cell::RefCell;
use std::rc::Rc;

use gloo_timers::callback::Timeout;
use js_sys::{Array, Float64Array};
use motionbench_core::time::Nanos;
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageChannel, MessageEvent, MessagePort};

use crate::protocol::{Frame, FromWorker, MOST_UNTAKEN, ToWorker};
use engine::Engine;
use pacing::{Pacing, wall_ms};

/// Simulated time between looks at the clock.
const CHUNK: Nanos = Nanos::from_millis(10);
/// The worker listens to the page at least this often, ms.
const TURN_MS: f64 = 8.0;
/// How long it sleeps when simulated time has caught up, ms.
const REST_MS: u32 = 8;
/// Between frames, ms: while something happens, and while nothing does.
const FRAME_MS: f64 = 1000.0 / 60.0;
const QUIET_FRAME_MS: f64 = 100.0;

/// Starts to serve the page; returns at once, the browser calls back.
pub fn start() {
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let Ok(engine) = Engine::new(&scope.name()) else {
        wasm_bindgen::throw_str("the bench cannot be set up");
    };
    let Ok(channel) = MessageChannel::new() else {
        wasm_bindgen::throw_str("this browser has no MessageChannel");
    };
    let now = wall_ms();
    let host = Rc::new(RefCell::new(Host {
        pacing: Pacing::new(now, engine.now()),
        engine,
        sent: 0,
        taken: 0,
        last_frame_ms: now,
        news: true,
        next: Next::Nothing,
        wake: channel.port2(),
    }));
    let ready = FromWorker::Ready(host.borrow().engine.ready());
    listen(&host, &channel.port1());
    post(&ready, &[]);
    turn(&host);
}

/// The bench and its way to the page.
struct Host {
    engine: Engine,
    pacing: Pacing,
    /// Number of the last frame sent, and of the last that the page has taken.
    sent: u64,
    taken: u64,
    last_frame_ms: f64,
    /// The page has asked for something and is to see the effect soon.
    news: bool,
    next: Next,
    wake: MessagePort,
}

/// What calls the next turn.
enum Next {
    Nothing,
    /// A message to itself: after what the browser has to deliver, but without a timer's least wait of 4 ms.
    Message,
    /// Held, so that it can be cancelled.
    Timer(#[allow(dead_code)] Timeout),
}

/// Connects the browser's calls: the page's messages, and the worker's own.
fn listen(host: &Rc<RefCell<Host>>, own: &MessagePort) {
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let from_page = Closure::<dyn Fn(MessageEvent)>::new({
        let host = host.clone();
        move |event: MessageEvent| {
            let text = event.data().as_string().unwrap_or_default();
            // A page of another build reloads as soon as it has seen this one's name.
            if let Ok(message) = serde_json::from_str(&text) {
                host.borrow_mut().receive(&message);
                turn(&host);
            }
        }
    });
    scope.set_onmessage(Some(from_page.into_js_value().unchecked_ref()));
    let from_itself = Closure::<dyn Fn()>::new({
        let host = host.clone();
        move || {
            host.borrow_mut().next = Next::Nothing;
            turn(&host);
        }
    });
    own.set_onmessage(Some(from_itself.into_js_value().unchecked_ref()));
}

/// Simulates for a moment, reports, and arranges the next turn.
fn turn(host: &Rc<RefCell<Host>>) {
    let mut this = host.borrow_mut();
    let caught_up = this.simulate();
    this.report();
    if caught_up {
        if matches!(this.next, Next::Nothing) {
            let host = host.clone();
            this.next = Next::Timer(Timeout::new(REST_MS, move || {
                host.borrow_mut().next = Next::Nothing;
                turn(&host);
            }));
        }
    } else if !matches!(this.next, Next::Message) {
        this.next = Next::Message;
        // Posting to a port of its own cannot fail.
        let _ = this.wake.post_message(&JsValue::NULL);
    }
}

impl Host {
    fn receive(&mut self, message: &ToWorker) {
        match message {
            ToWorker::Taken(frame) => self.taken = *frame,
            ToWorker::Speed(speed) => self.pacing.set(*speed, wall_ms(), self.engine.now()),
            _ => {
                // What is asked for happens now, not when the last turn ended.
                self.simulate();
                let was_frozen = self.engine.is_frozen();
                if let Some(answer) = self.engine.act(message) {
                    post(&answer, &[]);
                }
                if was_frozen && !self.engine.is_frozen() {
                    self.pacing.go_on(wall_ms(), self.engine.now());
                }
            }
        }
        self.news |= !matches!(message, ToWorker::Taken(_));
    }

    /// Simulates until it has caught up with the wall, the page does not follow, or the turn is over; returns
    /// whether there is nothing to do for now.
    fn simulate(&mut self) -> bool {
        let start = wall_ms();
        let mut wall = start;
        while wall < start + TURN_MS {
            let now = self.engine.now();
            let goal = self.pacing.goal(wall, now);
            if goal <= now || self.engine.is_frozen() || self.engine.is_full() {
                return true;
            }
            self.engine.advance(goal.min(now + CHUNK));
            wall = wall_ms();
        }
        false
    }

    /// Sends a frame, if it is time for one and the page has taken those before.
    fn report(&mut self) {
        let wall = wall_ms();
        let soon = self.news || self.engine.is_busy() || self.engine.is_full();
        let wait = if soon { FRAME_MS } else { QUIET_FRAME_MS };
        // A turn comes every 8 ms: half a turn early is nearer than half a turn late.
        let early = f64::from(REST_MS) / 2.0;
        if self.sent - self.taken >= MOST_UNTAKEN || wall < self.last_frame_ms + wait - early {
            return;
        }
        let report = self.engine.report();
        self.sent += 1;
        let frame = Frame {
            number: self.sent,
            now: report.now,
            unit: report.unit,
            parts: report.parts,
            status: report.status,
            work: report.work,
            reached: self.pacing.reached(wall, report.now),
            panel: report.panel,
            bus: report.bus,
            learnt: report.learnt,
            console: report.console,
            received: report.received,
            pending: report.pending,
            frozen: report.frozen,
        };
        post(&FromWorker::Frame(frame), &report.samples);
        self.last_frame_ms = wall;
        self.news = false;
    }
}

/// Sends a message to the page, and samples by handing over their buffer.
fn post(message: &FromWorker, samples: &[f64]) {
    let text = serde_json::to_string(message).unwrap_or_default();
    let samples = Float64Array::from(samples);
    let scope: DedicatedWorkerGlobalScope = js_sys::global().unchecked_into();
    let buffer = samples.buffer();
    let parts = Array::of2(&JsValue::from(text), &samples);
    scope
        .post_message_with_transfer(&parts, &Array::of1(&buffer))
        .unwrap_throw();
}
