//! Files that the user saves and chooses.

use js_sys::{Array, Promise};
use leptos::prelude::document;
use leptos::wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobPropertyBag, File, HtmlAnchorElement, HtmlInputElement, Url};

/// Gives the user a text of that media type as a file, as downloads are given.
///
/// # Errors
/// What the browser says.
pub fn save(name: &str, kind: &str, text: &str) -> Result<(), JsValue> {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = Array::of1(&text.into());
    let blob = Blob::new_with_str_sequence_and_options(&parts, &options)?;
    save_blob(name, &blob)
}

/// Gives the user a file of these contents.
///
/// # Errors
/// What the browser says.
pub fn save_blob(name: &str, contents: &Blob) -> Result<(), JsValue> {
    let address = Url::create_object_url_with_blob(contents)?;
    let link: HtmlAnchorElement = document().create_element("a")?.unchecked_into();
    link.set_href(&address);
    link.set_download(name);
    link.click();
    // The click has taken the contents.
    Url::revoke_object_url(&address)
}

/// Lets the user choose a project's file; `None` if the user chose none. Only a press of the user's may lead to this.
pub async fn choose() -> Option<File> {
    let input: HtmlInputElement = document().create_element("input").ok()?.unchecked_into();
    input.set_type("file");
    input.set_accept(".json,application/json");
    let chosen = Promise::new(&mut |resolve, _| {
        // An input takes any listener.
        for event in ["change", "cancel"] {
            let _ = input.add_event_listener_with_callback(event, &resolve);
        }
    });
    input.click();
    let _ = JsFuture::from(chosen).await;
    input.files()?.get(0)
}

/// Why a file's text is not to be had.
pub enum Unreadable {
    /// It has more bytes than are wanted.
    TooLarge,
    /// The browser cannot read it.
    Refused,
}

/// The text of a file of at most so many bytes.
///
/// # Errors
/// [`Unreadable`].
pub async fn text(file: &File, most: usize) -> Result<String, Unreadable> {
    if file.size() > most as f64 {
        return Err(Unreadable::TooLarge);
    }
    let text = JsFuture::from(file.text()).await;
    let text = text.ok().and_then(|text| text.as_string());
    text.ok_or(Unreadable::Refused)
}
