//! Who presses the keys: fingers, the mouse, the computer's keyboard. Whatever takes them away lets the keys go.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use motionbench_core::controller::Keycap;
use web_sys::{Element, KeyboardEvent, PointerEvent};

use crate::protocol::ToWorker;
use crate::state::Store;
use crate::state::front::{Hand, Held};

/// What the legend of a blank looks like.
const BLANK: &str = "\u{2423}";

/// The hands on the keys. A handle: copies are of the same hands.
#[derive(Clone, Copy)]
pub(super) struct Hands {
    store: Store,
    held: StoredValue<Held>,
    /// Grows when a key goes down or up.
    changed: RwSignal<u64>,
    /// Takes what is typed.
    catcher: NodeRef<html::Textarea>,
}

impl Hands {
    pub fn new(store: Store, catcher: NodeRef<html::Textarea>) -> Hands {
        let hands = Hands {
            store,
            held: StoredValue::new(Held::default()),
            changed: RwSignal::new(0),
            catcher,
        };
        let blur = window_event_listener(ev::blur, move |_| hands.let_go());
        let hidden = window_event_listener(ev::visibilitychange, move |_| {
            if document().hidden() {
                hands.let_go();
            }
        });
        on_cleanup(move || {
            blur.remove();
            hidden.remove();
            hands.let_go();
        });
        hands
    }

    fn send(&self, key: String, down: bool) {
        self.store.send(ToWorker::Key { key, down });
        self.changed.try_update(|count| *count += 1);
    }

    /// A hand presses a key.
    pub fn press(&self, hand: Hand, key: &str) {
        let down = self.held.try_update_value(|held| held.press(hand, key));
        if down == Some(true) {
            self.send(key.to_owned(), true);
        }
    }

    /// A hand lets go.
    pub fn release(&self, hand: &Hand) {
        let up = self.held.try_update_value(|held| held.release(hand));
        if let Some(Some(key)) = up {
            self.send(key, false);
        }
    }

    /// All hands let go.
    pub fn let_go(&self) {
        let up = self.held.try_update_value(Held::release_all);
        for key in up.unwrap_or_default() {
            self.send(key, false);
        }
    }

    /// Gives the panel the keyboard.
    pub fn focus(&self) {
        if let Some(Some(catcher)) = self.catcher.try_get_untracked() {
            // What is removed from the page cannot take the keyboard, and need not.
            let _ = catcher.focus();
        }
    }

    /// Whether a key is seen to be down, whichever of its names it is pressed by.
    fn is_down(&self, cap: &Keycap) -> bool {
        self.changed.track();
        let names = [cap.key, cap.legends.1, cap.message.0, cap.message.1];
        self.held.with_value(|held| {
            names
                .iter()
                .any(|name| held.is_held(if *name == BLANK { "SPACE" } else { name }))
        })
    }

    /// A key of the computer goes down; whether it means something here.
    fn typed(&self, event: &KeyboardEvent, keys: &[Keycap]) -> bool {
        let key = event.key();
        let plain = !event.ctrl_key() && !event.alt_key() && !event.meta_key();
        let graph = event.get_modifier_state("AltGraph");
        let Some(name) = meaning(&key, keys).filter(|_| plain || graph) else {
            return false;
        };
        if !event.repeat() {
            self.press(Hand::Typed(event.code()), &name);
        }
        true
    }
}

/// The key of the panel that a key of the computer presses.
pub(super) fn meaning(key: &str, keys: &[Keycap]) -> Option<String> {
    let named = NAMED.iter().find(|(known, _)| *known == key);
    if let Some((_, name)) = named {
        return Some((*name).to_owned());
    }
    if key.chars().count() != 1 {
        return None;
    }
    let character = key.to_ascii_uppercase();
    let legend = if character == " " { BLANK } else { &character };
    let printed = |cap: &Keycap| {
        let legends = [cap.legends.0, cap.legends.1, cap.message.0, cap.message.1];
        legends.contains(&legend)
    };
    let name = if legend == BLANK { "SPACE" } else { legend };
    keys.iter().any(printed).then(|| name.to_owned())
}

/// Keys of the computer that type no character, and what they press.
pub(super) const NAMED: [(&str, &str); 12] = [
    ("Enter", "EXC"),
    ("Backspace", "CE"),
    ("Delete", "CC"),
    ("ArrowUp", "UP"),
    ("ArrowDown", "DOWN"),
    ("ArrowLeft", "LEFT"),
    ("ArrowRight", "RIGHT"),
    ("Insert", "SHIFT"),
    ("Home", "SCH"),
    ("End", "RES"),
    ("PageUp", "CLRX"),
    ("PageDown", "CLRY"),
];

/// A text field out of sight that has the keyboard, so that a screen reader lets every key through.
#[component]
pub(super) fn Catcher(hands: Hands, keys: &'static [Keycap]) -> impl IntoView {
    hands
        .catcher
        .on_load(move |_| request_animation_frame(move || hands.focus()));
    let down = move |event: KeyboardEvent| {
        if !event.is_composing() && hands.typed(&event, keys) {
            event.prevent_default();
        }
    };
    // What was written with a dead key or an input method.
    let written = move |_| {
        let Some(catcher) = hands.catcher.get_untracked() else {
            return;
        };
        for character in catcher.value().chars() {
            if let Some(name) = meaning(&character.to_string(), keys) {
                tap(hands, &name);
            }
        }
        catcher.set_value("");
    };
    view! {
        <textarea class="keys" node_ref=hands.catcher inputmode="none" rows="1" autocomplete="off"
            autocapitalize="off" spellcheck="false" aria-label="Front panel: what is typed presses its keys"
            on:keydown=down on:keyup=move |event| hands.release(&Hand::Typed(event.code()))
            on:input=written on:blur=move |_| hands.let_go()></textarea>
    }
}

fn tap(hands: Hands, key: &str) {
    let hand = || Hand::Typed("a tap".to_owned());
    hands.press(hand(), key);
    hands.release(&hand());
}

/// A key: its shifted meaning above, its own below, and in the corners what they type in a message. Only its own is
/// text; the style sheet prints the others.
#[component]
pub(super) fn Key(hands: Hands, cap: &'static Keycap) -> impl IntoView {
    let down = Memo::new(move |_| hands.is_down(cap));
    // A click that no finger has begun comes from a screen reader.
    let touched = StoredValue::new(false);
    let press = move |event: PointerEvent| {
        touched.set_value(true);
        if event.button() != 0 {
            return;
        }
        let target = event.current_target();
        if let Some(button) = target.and_then(|target| target.dyn_into::<Element>().ok()) {
            // Without it, a finger that slides off the key still holds it.
            let _ = button.set_pointer_capture(event.pointer_id());
        }
        hands.press(Hand::Pointer(event.pointer_id()), cap.key);
    };
    let release = move |event: PointerEvent| hands.release(&Hand::Pointer(event.pointer_id()));
    let click = move |_| {
        if !touched.try_update_value(std::mem::take).unwrap_or_default() {
            tap(hands, cap.key);
        }
    };
    let (plain, shifted) = cap.legends;
    let two = !shifted.is_empty() || !cap.message.1.is_empty();
    view! {
        <button type="button" class=format!("cap {}", class(cap)) class:down=down class:two=two tabindex="-1"
            aria-label=spoken(cap) title=title(cap)
            on:pointerdown=press on:pointerup=release on:pointercancel=release on:lostpointercapture=release
            on:contextmenu=|event| event.prevent_default() on:click=click>
            {two.then(|| view! {
                <span class="upper" data-legend=shifted data-message=cap.message.1></span>
            })}
            <span class="lower" data-message=cap.message.0>{plain}</span>
        </button>
    }
}

/// Its class in the style sheet; the keys of the pad have none of their own.
fn class(cap: &Keycap) -> &'static str {
    match cap.key.len() {
        1 => "pad-key",
        _ => cap.key,
    }
}

/// What a screen reader says of it.
fn spoken(cap: &Keycap) -> String {
    let mut words = match (cap.name, cap.legends.0.is_ascii()) {
        ("", _) => cap.legends.0.to_owned(),
        (name, false) => format!("{name} {}", cap.legends.0),
        (name, true) => format!("{} {name}", cap.legends.0),
    };
    if !cap.legends.1.is_empty() {
        words = format!("{words}, with SHIFT {}", cap.legends.1);
    }
    words
}

/// What it is, and what presses it on the computer's keyboard.
fn title(cap: &Keycap) -> String {
    let mut keys: Vec<String> = Vec::new();
    for name in [cap.key, cap.legends.1] {
        let named = NAMED.iter().filter(|(_, pressed)| *pressed == name);
        keys.extend(named.map(|(key, _)| words(key)));
    }
    for letter in [cap.legends.0, cap.legends.1, cap.message.0, cap.message.1] {
        if letter.len() == 1 {
            keys.push(letter.to_owned());
        } else if letter == BLANK {
            keys.push("Space".to_owned());
        }
    }
    let name = if cap.name.is_empty() {
        cap.legends.0
    } else {
        cap.name
    };
    format!("{name} (keyboard: {})", keys.join(", "))
}

/// A key of the computer, for people.
pub(super) fn words(key: &str) -> String {
    match key.strip_prefix("Arrow") {
        Some(direction) => format!("{} arrow", direction.to_ascii_lowercase()),
        None => match key {
            "PageUp" => "Page Up".to_owned(),
            "PageDown" => "Page Down".to_owned(),
            key => key.to_owned(),
        },
    }
}

#[cfg(test)]
mod tests {
    use motionbench_core::catalog::kind;

    use super::*;

    #[test]
    fn what_is_typed_presses_the_key_that_bears_it() {
        let keys = kind("unidex3").unwrap().face.unwrap().keys;
        let meaning = |key| meaning(key, keys);
        assert_eq!(meaning("g").as_deref(), Some("G"));
        assert_eq!(meaning(" ").as_deref(), Some("SPACE"));
        assert_eq!(meaning("ArrowLeft").as_deref(), Some("LEFT"));
        assert_eq!(meaning("Tab"), None);
        assert_eq!(meaning("Shift"), None);
        assert_eq!(meaning("\u{e9}"), None);
        let typed = ('A'..='Z').chain('0'..='9').chain("=-*<>+\"/".chars());
        let info = kind("unidex3").unwrap().create(&[]).unwrap();
        let known = &info.controller().info().keys;
        for character in typed {
            let name = super::meaning(&character.to_string(), keys).unwrap();
            assert!(known.contains(&name.as_str()), "{name}");
        }
        for (_, name) in NAMED {
            assert!(known.contains(&name), "{name}");
        }
        assert!(keys.iter().all(|cap| known.contains(&cap.key)));
    }
}
