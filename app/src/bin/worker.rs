//! The worker that owns the bench.

use gloo_worker::Registrable;
use motionbench_app::Engine;

fn main() {
    console_error_panic_hook::set_once();
    Engine::registrar().register();
}
