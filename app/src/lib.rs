//! The page, and the worker that owns the bench.

use gloo_worker::{HandlerId, Worker, WorkerScope};

/// Owns the bench.
pub struct Engine;

impl Worker for Engine {
    type Message = ();
    type Input = String;
    type Output = String;

    fn create(_: &WorkerScope<Self>) -> Self {
        Self
    }

    fn update(&mut self, _: &WorkerScope<Self>, _: Self::Message) {}

    fn received(&mut self, scope: &WorkerScope<Self>, input: Self::Input, id: HandlerId) {
        scope.respond(id, input);
    }
}
