//! The worker that owns the bench.

fn main() {
    console_error_panic_hook::set_once();
    motionbench_app::worker::start();
}
