//! Panels in a browser, told what a simulator would tell.

use std::any::Any;
use std::cell::Cell;
use std::rc::Rc;

use leptos::mount::mount_to;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use motionbench_core::catalog::kind;
use motionbench_core::controller::{self, Led, RunState, Signal};
use motionbench_core::serial::LineSettings;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::{Element, Event, HtmlElement, PointerEvent};

use super::{estop, front, io, status, terminal};
use crate::clock::within;
use crate::offline::Updates;
use crate::protocol::{BUILD, Frame, Ready};
use crate::state::{News, Store};
use crate::storage::Keeper;

wasm_bindgen_test_configure!(run_in_browser);

/// A panel that is the only thing in the page.
struct Panel {
    store: Store,
    element: Element,
    /// Dropped, it takes the panel out of the page.
    _mounted: Box<dyn Any>,
}

impl Panel {
    /// Shows what `view` makes.
    fn show<V: IntoView + 'static>(view: impl FnOnce(Store) -> V + 'static) -> Panel {
        let element = document().create_element("div").unwrap();
        document().body().unwrap().append_child(&element).unwrap();
        let home = element.clone().unchecked_into::<HtmlElement>();
        let made = Rc::new(Cell::new(None));
        let mounted = mount_to(home, {
            let made = made.clone();
            move || {
                let store = Store::without_simulator();
                made.set(Some(store));
                view(store)
            }
        });
        Panel {
            store: made.get().expect("mounted at once"),
            element,
            _mounted: Box::new(mounted),
        }
    }

    fn find(&self, selector: &str) -> HtmlElement {
        let found = self.element.query_selector(selector).unwrap();
        let found = found.unwrap_or_else(|| panic!("{selector} in {}", self.element.inner_html()));
        found.unchecked_into()
    }

    fn text(&self, selector: &str) -> String {
        self.find(selector).text_content().unwrap_or_default()
    }

    /// The terminal's lines, without the empty ones at the end.
    fn rows(&self) -> Vec<String> {
        let text = self.find(".rows").inner_text();
        // First what a character is measured by.
        let mut rows: Vec<String> = text
            .lines()
            .skip(1)
            .map(|row| row.trim_end().to_owned())
            .collect();
        while rows.last().is_some_and(String::is_empty) {
            rows.pop();
        }
        rows
    }

    /// Presses a button, and lets the page draw.
    async fn press(&self, selector: &str) {
        self.find(selector).click();
        drawn().await;
    }

    /// The simulator stands.
    fn ready(&self) {
        let signals = ["x.command", "outputs"].map(|name| Signal {
            name: name.to_owned(),
            unit: "counts".to_owned(),
        });
        self.store.hear(&News::Ready(Ready {
            build: BUILD.to_owned(),
            controller: "Danaher MC-600".to_owned(),
            line: LineSettings::new(9600),
            signals: signals.to_vec(),
            units: 1,
        }));
    }

    /// The simulator tells what has happened.
    async fn frame(&self, number: u64, change: impl FnOnce(&mut Frame), samples: &[f64]) {
        let mut frame = Frame {
            number,
            parts: vec![samples.len()],
            ..Frame::first(RunState::Running)
        };
        change(&mut frame);
        self.store.hear(&News::Frame(frame, samples.to_vec()));
        drawn().await;
    }
}

/// Until the page has drawn.
async fn drawn() {
    within::<()>(100, std::future::pending()).await;
}

#[wasm_bindgen_test]
async fn a_switch_and_a_lamp_show_how_they_stand() {
    let panel = Panel::show(|store| view! { <io::Io store /> });
    let switch = "[aria-label='Input 3']";
    let stands = || panel.find(switch).get_attribute("aria-checked");
    assert_eq!(stands().as_deref(), Some("false"));
    panel.press(switch).await;
    assert_eq!(stands().as_deref(), Some("true"));
    panel.press(switch).await;
    assert_eq!(stands().as_deref(), Some("false"));
    panel.ready();
    let lamps = ".points:last-child";
    assert!(panel.text(lamps).contains("output 2 off"));
    panel.frame(1, |_| (), &[1e6, 0.0, 4.0]).await;
    assert!(panel.text(lamps).contains("output 2 on"));
    assert!(panel.text(lamps).contains("output 1 off"));
    panel
        .frame(2, |frame| frame.status.power = false, &[2e6, 0.0, 4.0])
        .await;
    assert!(
        panel.text(lamps).contains("output 2 off"),
        "dark without mains"
    );
}

fn front_panel() -> Panel {
    Panel::show(|store| {
        let kind = kind("unidex3").unwrap();
        store.editor.update(|editor| editor.change_kind(kind));
        view! { <front::Front store face=kind.face.unwrap() /> }
    })
}

#[wasm_bindgen_test]
async fn a_front_panel_says_what_it_shows() {
    let panel = front_panel();
    panel.ready();
    let shown = controller::Panel {
        display: "EDIT 25 ".to_owned(),
        leds: vec![
            ("EDIT".to_owned(), Led::Flashing),
            ("XLMT".to_owned(), Led::On),
        ],
        tracking: vec![
            ("x".to_owned(), "-4567".to_owned()),
            ("y".to_owned(), String::new()),
        ],
    };
    panel.frame(1, |frame| frame.panel = Some(shown), &[]).await;
    let text = panel.text(".stand .unseen");
    for said in [
        "Display: EDIT 25",
        "X -4567",
        "Y dark",
        "EDIT flashing",
        "XLMT on",
    ] {
        assert!(text.contains(said), "{said} in {text}");
    }
    assert!(
        panel.text(".stand [role=status]").is_empty(),
        "not before it rests"
    );
    within::<()>(1000, std::future::pending()).await;
    assert_eq!(
        panel.text(".stand [role=status]"),
        "EDIT 25, EDIT flashing, XLMT on"
    );
    assert!(panel.find(".mode .led").class_list().contains("flashing"));
    panel
        .frame(2, |frame| frame.status.power = false, &[])
        .await;
    assert!(panel.text(".note[role=status]").contains("Power"));
}

#[wasm_bindgen_test]
async fn a_key_is_down_while_a_finger_holds_it() {
    let panel = front_panel();
    panel.ready();
    let key = panel.find(".cap.UP");
    let finger = |what| PointerEvent::new(what).unwrap();
    let is_down = || key.class_list().contains("down");
    for end in ["pointerup", "pointercancel", "lostpointercapture"] {
        key.dispatch_event(&finger("pointerdown")).unwrap();
        drawn().await;
        assert!(is_down(), "{end}");
        key.dispatch_event(&finger(end)).unwrap();
        drawn().await;
        assert!(!is_down(), "{end}");
    }
    key.dispatch_event(&finger("pointerdown")).unwrap();
    window()
        .dispatch_event(&Event::new("blur").unwrap())
        .unwrap();
    drawn().await;
    assert!(!is_down(), "the window went to the back");
}

#[wasm_bindgen_test]
async fn the_emergency_stop_is_latched_and_says_the_cure() {
    let panel = Panel::show(|store| {
        view! { <estop::EStop store /><estop::EStopNotice store /> }
    });
    assert_eq!(panel.text("[role=status]"), "");
    panel.press(".estop").await;
    assert_eq!(panel.text(".estop"), "Release E-STOP");
    assert!(panel.text("[role=status]").contains("MDRVEN()"));
    panel.press(".estop").await;
    assert_eq!(panel.text(".estop"), "E-STOP");
    assert_eq!(panel.text("[role=status]"), "");
}

#[wasm_bindgen_test]
async fn the_terminal_shows_what_the_console_sent() {
    let panel = Panel::show(|store| view! { <terminal::Terminal store /> });
    panel.ready();
    panel
        .frame(1, |frame| frame.console = "OUT 40960\r\n>".to_owned(), &[])
        .await;
    assert_eq!(panel.rows(), ["OUT 40960", ">"]);
    // The prompt of another start is on a line of its own.
    panel
        .frame(2, |frame| frame.status.power = false, &[])
        .await;
    panel
        .frame(3, |frame| frame.console = ">".to_owned(), &[])
        .await;
    assert_eq!(panel.rows(), ["OUT 40960", ">", ">"]);
}

#[wasm_bindgen_test]
async fn the_status_line_says_what_is_true() {
    let panel = Panel::show(|store| {
        let keeper = Keeper::new("motionbench-status");
        let updates = Updates::start();
        view! { <status::StatusLine store keeper updates /> }
    });
    assert_eq!(panel.text(".activity"), "starting");
    panel.ready();
    panel
        .frame(1, |frame| frame.status.moving = true, &[])
        .await;
    assert_eq!(panel.text(".activity"), "running");
    assert_eq!(panel.text(".line"), "line 20");
    assert_eq!(panel.text(".moving"), "axis moves");
    assert_eq!(panel.text(".time"), "t = 00:01.500");
    assert_eq!(panel.text(".settings"), "9600 8N1");
    let error = "?SYNTAX ERROR IN 20";
    panel
        .frame(
            2,
            |frame| {
                frame.status.run = RunState::Idle;
                frame.status.error = Some(error.to_owned());
            },
            &[],
        )
        .await;
    assert_eq!(panel.text(".activity"), "idle");
    assert_eq!(panel.text(".error"), error);
    assert_eq!(panel.text(".line"), "");
}
