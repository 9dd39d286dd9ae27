//! The terminal on the console's line.

mod disks;
mod file;
mod line;
mod tools;

use std::sync::Arc;
use std::time::Duration;

use leptos::attr::custom::custom_attribute;
use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use motionbench_core::controller::FirstStep;
use web_sys::{ClipboardEvent, Element, HtmlTextAreaElement, KeyboardEvent};

use super::front::ToFront;
use super::{draw, popover, room};
use crate::protocol::ToWorker;
use crate::state::Store;
use crate::state::keys::{Press, Stroke, sent, stroke};
use crate::state::terminal::{Looks, Row};

/// More new rows than this in one drawing are too fast to be read: only the screen is drawn until they are fewer.
const FLOOD: u64 = 100;
/// The rows that were not drawn come when nothing was printed for so long; what a screen reader says, after so long.
const CALM: Duration = Duration::from_millis(200);
/// Text that goes on for so many times [`CALM`] is a stream: of a thousand rows the browser would move each with each new
/// one.
const STREAM: u32 = 5;
/// The height of a row, rem, as in the style sheet.
const ROW_REM: f64 = 1.25;
/// A line with fewer characters shows no one what a line looks like.
const SHORTEST_EXAMPLE: usize = 4;
/// Characters by whose width that of one is measured.
const RULER: &str = "00000000000000000000";

/// The character of the key Esc, by which some controllers are addressed.
pub(super) const ESCAPE: char = '\u{1b}';

/// The terminal.
#[component]
pub(super) fn Terminal(store: Store) -> impl IntoView {
    let screen = NodeRef::<html::Div>::new();
    let keys = NodeRef::<html::Textarea>::new();
    let focus = move || {
        if let Some(keys) = keys.get_untracked() {
            // What is removed from the page cannot take the keyboard, and need not.
            let _ = keys.focus();
        }
    };
    keys.on_load(move |_| request_animation_frame(focus));
    let keydown = move |event: KeyboardEvent| press(store, &event, screen, &focus);
    // The user looks at what was printed before.
    let looks_back = RwSignal::new(false);
    let scrolled = move |_| {
        let above = screen.get_untracked().map(|screen| screen.scroll_top());
        let back = above.is_some_and(|above| above < 0);
        if back != looks_back.get_untracked() {
            looks_back.set(back);
        }
    };
    // A click gives it the keyboard, unless text was selected.
    let mouseup = move |_| {
        if !has_selection() {
            focus();
        }
    };
    view! {
        <section class="panel terminal" aria-labelledby="terminal-title" class:typing=store.typing
            on:focusin=move |_| store.typing.set(true)
            on:focusout=move |_| store.typing.set(false)>
            <header class="panel-head">
                <h2 id="terminal-title">"Terminal"</h2>
                <ToFront store />
                <tools::Tools store />
            </header>
            <tools::Notices store />
            <div class="screen" node_ref=screen tabindex="-1" on:keydown=keydown on:mouseup=mouseup on:scroll=scrolled>
                <Screen store screen looks_back />
                <KeyCatcher store keys />
            </div>
            <Spoken store />
        </section>
    }
}

/// What a key does.
fn press(store: Store, event: &KeyboardEvent, screen: NodeRef<html::Div>, focus: &impl Fn()) {
    let key = event.key();
    let press = Press {
        key: &key,
        ctrl: event.ctrl_key(),
        shift: event.shift_key(),
        other: event.alt_key() || event.meta_key(),
        selection: has_selection(),
    };
    let stroke = stroke(press);
    // Escape first closes what is open over the page.
    if event.is_composing() || (key == "Escape" && popover::is_open()) {
        return;
    }
    match stroke {
        Stroke::Send(character) => store.type_text(character.to_string()),
        Stroke::Stop => store.send(ToWorker::Stop),
        Stroke::Scroll(pages) => scroll(screen, pages),
        // A character typed after a selection was made arrives as text, once the text field has the keyboard.
        Stroke::Leave if key.chars().count() == 1 && !press.ctrl && !press.other => return focus(),
        Stroke::Leave => return,
    }
    event.prevent_default();
    if !matches!(stroke, Stroke::Scroll(_)) {
        focus();
        scroll_to_end(screen);
    }
}

fn has_selection() -> bool {
    let selection = window().get_selection().ok().flatten();
    selection.is_some_and(|selection| !selection.is_collapsed())
}

fn scroll(screen: NodeRef<html::Div>, pages: i8) {
    if let Some(screen) = screen.get_untracked() {
        let page = screen.client_height() * 9 / 10;
        screen.set_scroll_top(screen.scroll_top() + i32::from(pages) * page);
    }
}

/// The newest line is at offset zero: the screen is laid out from its end, so that it stays there.
fn scroll_to_end(screen: NodeRef<html::Div>) {
    if let Some(screen) = screen.get_untracked() {
        screen.set_scroll_top(0);
    }
}

/// The rows.
#[component]
fn Screen(store: Store, screen: NodeRef<html::Div>, looks_back: RwSignal<bool>) -> impl IntoView {
    let rows = RwSignal::new(Vec::new());
    // Rows that are not drawn.
    let above = RwSignal::new(0_usize);
    let ever = StoredValue::new(0);
    // For how many times `CALM` text has come.
    let lasts = StoredValue::new(0);
    let draw = draw::before_paint(move || {
        let drawn = ever.get_value();
        let streams = lasts.get_value() >= STREAM;
        let at_end = streams && !looks_back.get_untracked() && !has_selection();
        store.with_terminal(|terminal| {
            ever.set_value(terminal.ever());
            // A screen that shrinks may have fewer rows than before.
            let flood = terminal.ever().saturating_sub(drawn) > FLOOD;
            let hidden = if flood || at_end { terminal.above() } else { 0 };
            above.set(hidden);
            rows.set(match flood {
                true => terminal.screen(),
                false => terminal.rows().into_iter().skip(hidden).collect(),
            });
        });
    });
    let watch = draw::watch(CALM, {
        let draw = draw.clone();
        move |printed| {
            lasts.update_value(|lasts| *lasts = if printed { *lasts + 1 } else { 0 });
            draw();
        }
    });
    Effect::new(move |_| {
        store.printed.track();
        looks_back.track();
        draw();
        watch();
    });
    let ruler = NodeRef::<html::Span>::new();
    screen.on_load(move |screen| {
        let screen: Element = screen.into();
        let fit = move |width: f64, height: f64| {
            let Some(ruler) = ruler.get_untracked() else {
                return;
            };
            let character = ruler.get_bounding_client_rect();
            let (wide, high) = (character.width() / RULER.len() as f64, character.height());
            if wide > 0.0 && high > 0.0 {
                store.resize_terminal((width / wide) as usize, (height / high) as usize);
            }
        };
        room::watch(&screen, fit);
    });
    view! {
        <div class="rows" aria-hidden="true">
            <span class="ruler" node_ref=ruler>{RULER}</span>
            <div style:height=move || format!("{}rem", above.get() as f64 * ROW_REM)></div>
            <For each=move || rows.get() key=|row| row.key children=|row| view! { <RowView row /> } />
        </div>
    }
}

#[component]
fn RowView(row: Arc<Row>) -> impl IntoView {
    let run = |run: &crate::state::terminal::Run| {
        let Looks {
            bold,
            underline,
            inverse,
            cursor,
        } = run.looks;
        if run.looks == Looks::default() {
            run.text.clone().into_any()
        } else {
            view! {
                <span class:bold=bold class:underline=underline class:inverse=inverse class:cursor=cursor>
                    {run.text.clone()}
                </span>
            }
            .into_any()
        }
    };
    view! { <div class="row">{row.runs.iter().map(run).collect_view()}</div> }
}

/// A text field out of sight that has the keyboard: so dead keys, input methods and paste work as everywhere.
#[component]
fn KeyCatcher(store: Store, keys: NodeRef<html::Textarea>) -> impl IntoView {
    let take = move || {
        if let Some(keys) = keys.get_untracked() {
            let keys: &HtmlTextAreaElement = &keys;
            store.type_text(sent(&keys.value()));
            keys.set_value("");
        }
    };
    let input = move |event: web_sys::Event| {
        let composing = event
            .dyn_ref::<web_sys::InputEvent>()
            .is_some_and(web_sys::InputEvent::is_composing);
        if !composing {
            take();
        }
    };
    let paste = move |event: ClipboardEvent| {
        event.prevent_default();
        let text = event
            .clipboard_data()
            .and_then(|data| data.get_data("text").ok());
        store.type_text(sent(&text.unwrap_or_default()));
    };
    view! {
        // A phone shows no keys for it: it has the field below.
        <textarea class="keys" node_ref=keys inputmode="none" rows="1" autocomplete="off" autocapitalize="off"
            spellcheck="false" aria-label="Terminal: keys go to the controller"
            on:input=input on:compositionend=move |_| take() on:paste=paste></textarea>
    }
}

/// What a screen reader says as it comes.
#[component]
fn Spoken(store: Store) -> impl IntoView {
    let lines = RwSignal::new(Vec::new());
    let speak = draw::after(CALM, move || {
        let spoken = store
            .with_terminal(|terminal| terminal.spoken())
            .unwrap_or_default();
        if lines.with_untracked(|lines| *lines != spoken) {
            lines.set(spoken);
        }
    });
    Effect::new(move |_| {
        store.printed.track();
        speak();
    });
    view! {
        <div class="unseen" role="log" aria-live="polite" aria-label="What the controller printed">
            <For each=move || lines.get() key=|(number, _)| *number children=|(_, line)| view! { <p>{line}</p> } />
        </div>
    }
}

/// A line to write and send, where there is no keyboard.
#[component]
pub(super) fn Compose(store: Store) -> impl IntoView {
    let line = RwSignal::new(String::new());
    let submit = move |event: ev::SubmitEvent| {
        event.prevent_default();
        store.type_text(format!("{}\r", sent(&line.get_untracked())));
        line.set(String::new());
    };
    let capitals = move || match store.kind().text.ignores_case {
        true => "characters",
        false => "none",
    };
    let needs_escape = Memo::new(move |_| {
        let mut steps = store.kind().first_steps.iter();
        steps.any(|step| matches!(step, FirstStep::Type(line, _) if line.contains(ESCAPE)))
    });
    let example = move || {
        let mut steps = store.kind().first_steps.iter();
        steps.find_map(|step| match step {
            FirstStep::Type(line, _)
                if !line.contains(ESCAPE) && line.len() >= SHORTEST_EXAMPLE =>
            {
                Some(*line)
            }
            _ => None,
        })
    };
    view! {
        <form class="compose" aria-label="Line for the controller" on:submit=submit>
            <input class="field" type="text" autocomplete="off" autocapitalize=capitals
                spellcheck="false" enterkeyhint="send" aria-label="A line for the controller"
                {..custom_attribute("autocorrect", "off")} placeholder=example bind:value=line />
            <Show when=move || needs_escape.get()>
                <button type="button" class="button" on:click=move |_| store.type_text(ESCAPE.to_string())>"Esc"</button>
            </Show>
            <button type="submit" class="button">"Send"</button>
        </form>
    }
}
