//! The page.

use gloo_worker::Spawnable;
use leptos::prelude::*;
use motionbench_app::Engine;

fn main() {
    console_error_panic_hook::set_once();
    let (status, set_status) = signal(String::from("starting"));
    let engine = Engine::spawner()
        .callback(move |answer: String| set_status.set(answer))
        .with_loader(true)
        .spawn("./worker_loader.js");
    engine.send(String::from("ready"));
    // The page lives as long as its worker.
    std::mem::forget(engine);
    mount_to_body(
        move || view! { <main><h1>"Motionbench"</h1><p role="status">{status}</p></main> },
    );
}
