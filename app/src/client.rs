//! The page's end of the wire: the only code that knows there is a worker.

use std::cell::RefCell;
use std::rc::Rc;

use js_sys::{Array, Float64Array};
use wasm_bindgen::prelude::*;
use web_sys::{ErrorEvent, MessageEvent, Worker, WorkerOptions, WorkerType};

use crate::offline;
use crate::protocol::{BUILD, FromWorker, ToWorker};
use crate::state::{Fault, News};

/// The worker. Dropped, it ends.
#[derive(Clone)]
pub struct Client(Rc<RefCell<Connection>>);

struct Connection {
    worker: Option<Worker>,
    /// What waits until the worker listens; `None` since it does.
    waiting: Option<Vec<ToWorker>>,
}

impl Client {
    /// Starts a worker with the controller of a [`crate::protocol::bench_name`]; `tell` is called with all that is heard
    /// from it. What goes wrong is told too.
    pub fn start(name: &str, tell: impl Fn(News) + 'static) -> Client {
        let options = WorkerOptions::new();
        // The worker reads what it simulates from its own name: it is to be known before any message.
        options.set_name(name);
        options.set_type(WorkerType::Module);
        let address = offline::own_address("worker_loader.js");
        let worker = Worker::new_with_options(&address, &options);
        let client = Client(Rc::new(RefCell::new(Connection {
            worker: worker.ok(),
            waiting: Some(Vec::new()),
        })));
        client.listen(Rc::new(tell));
        client
    }

    /// Sends a message, now or as soon as the worker listens.
    pub fn send(&self, message: ToWorker) {
        let mut this = self.0.borrow_mut();
        match &mut this.waiting {
            Some(waiting) => waiting.push(message),
            None => this.post(&message),
        }
    }

    fn listen(&self, tell: Rc<dyn Fn(News)>) {
        let this = self.0.borrow();
        let Some(worker) = &this.worker else {
            tell(News::Fault(Fault::NotStarted));
            return;
        };
        let on_message = Closure::<dyn Fn(MessageEvent)>::new({
            let (client, tell) = (self.clone(), tell.clone());
            move |event: MessageEvent| client.hear(&event.data(), &*tell)
        });
        worker.set_onmessage(Some(on_message.into_js_value().unchecked_ref()));
        let on_error = Closure::<dyn Fn(ErrorEvent)>::new({
            let client = self.clone();
            move |_| {
                // Without a word from it, its files could not be loaded; the browser's console says why.
                let started = client.0.borrow().waiting.is_none();
                let fault = if started {
                    Fault::Died
                } else {
                    Fault::NotStarted
                };
                client.end();
                tell(News::Fault(fault));
            }
        });
        worker.set_onerror(Some(on_error.into_js_value().unchecked_ref()));
    }

    /// Takes what the worker posted: text, and samples beside it.
    fn hear(&self, data: &JsValue, tell: &dyn Fn(News)) {
        let parts: &Array = data.unchecked_ref();
        let text = parts.get(0).as_string().unwrap_or_default();
        let samples: Float64Array = parts.get(1).unchecked_into();
        match serde_json::from_str(&text) {
            Ok(FromWorker::Ready(ready)) if ready.build == BUILD => {
                let mut this = self.0.borrow_mut();
                let waiting = this.waiting.take().unwrap_or_default();
                waiting.iter().for_each(|message| this.post(message));
                drop(this);
                tell(News::Ready(ready));
            }
            Ok(FromWorker::Frame(frame)) if self.0.borrow().waiting.is_none() => {
                let number = frame.number;
                tell(News::Frame(frame, samples.to_vec()));
                self.send(ToWorker::Taken(number));
            }
            Ok(answer) if self.0.borrow().waiting.is_none() => tell(News::Answer(answer)),
            // Of another build, so that not even its messages need be understood.
            _ => {
                self.end();
                tell(News::Fault(Fault::OtherBuild));
            }
        }
    }

    /// Ends the worker.
    pub fn end(&self) {
        if let Some(worker) = self.0.borrow_mut().worker.take() {
            worker.terminate();
        }
    }
}

impl Connection {
    fn post(&self, message: &ToWorker) {
        if let (Some(worker), Ok(text)) = (&self.worker, serde_json::to_string(message)) {
            // Text can always be copied to a worker.
            let _ = worker.post_message(&JsValue::from(text));
        }
    }
}
