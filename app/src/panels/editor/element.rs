//! The element `<program-editor>`, which `app/editor/element.js` defines.

use js_sys::{Function, Uint32Array};
use leptos::wasm_bindgen::closure::WasmClosure;
use leptos::wasm_bindgen::prelude::*;
use motionbench_core::catalog::Kind;
use web_sys::HtmlElement;

use crate::state::editor::lines::{CLASSES, Edit};

#[wasm_bindgen]
extern "C" {
    /// CodeMirror in a shadow root. Lines count from 0, columns in UTF-16.
    #[wasm_bindgen(extends = HtmlElement)]
    #[derive(Clone)]
    pub(super) type ProgramEditor;

    #[wasm_bindgen(method, setter)]
    fn set_label(this: &ProgramEditor, label: &str);
    #[wasm_bindgen(method, setter)]
    fn set_classes(this: &ProgramEditor, classes: Vec<String>);
    #[wasm_bindgen(method, setter)]
    fn set_words(this: &ProgramEditor, words: &JsValue);
    #[wasm_bindgen(method, setter)]
    fn set_capitals(this: &ProgramEditor, capitals: &str);
    #[wasm_bindgen(method, setter)]
    fn set_highlight(this: &ProgramEditor, highlight: &Function);
    #[wasm_bindgen(method, setter)]
    fn set_problems(this: &ProgramEditor, problems: &Function);
    #[wasm_bindgen(method, setter)]
    fn set_edited(this: &ProgramEditor, edited: &Function);
    #[wasm_bindgen(method, setter)]
    fn set_cursor(this: &ProgramEditor, cursor: &Function);
    #[wasm_bindgen(method, setter)]
    fn set_toggle(this: &ProgramEditor, toggle: &Function);

    #[wasm_bindgen(method)]
    fn start(this: &ProgramEditor, text: &str);
    #[wasm_bindgen(method)]
    pub(super) fn stop(this: &ProgramEditor);
    #[wasm_bindgen(method)]
    pub(super) fn open(this: &ProgramEditor, text: &str);
    #[wasm_bindgen(method, js_name = setText)]
    pub(super) fn set_text(this: &ProgramEditor, text: &str);
    #[wasm_bindgen(method)]
    pub(super) fn replace(this: &ProgramEditor, line: u32, from: u32, to: u32, text: &str);
    #[wasm_bindgen(method, js_name = setBreakpoints)]
    pub(super) fn set_breakpoints(this: &ProgramEditor, lines: Vec<u32>);
    #[wasm_bindgen(method, js_name = setRunning)]
    pub(super) fn set_running(this: &ProgramEditor, line: i32, follow: bool);
    #[wasm_bindgen(method, js_name = setReadOnly)]
    pub(super) fn set_read_only(this: &ProgramEditor, read_only: bool);
    #[wasm_bindgen(method, js_name = goTo)]
    pub(super) fn go_to(this: &ProgramEditor, line: u32, column: u32);
    #[wasm_bindgen(method, js_name = nextProblem)]
    pub(super) fn next_problem(this: &ProgramEditor);
    #[wasm_bindgen(method)]
    pub(super) fn announce(this: &ProgramEditor, words: &str);
}

/// What the element asks and tells.
pub(super) struct Answers<H, P, E, C, T> {
    /// The parts of a line, as [`crate::state::editor::lines::highlights`] gives them.
    pub(super) highlight: H,
    /// What is wrong with the text, as JSON.
    pub(super) problems: P,
    /// The user changed the text.
    pub(super) edited: E,
    /// The cursor is in another line.
    pub(super) cursor: C,
    /// A breakpoint is wanted or not wanted any more.
    pub(super) toggle: T,
}

impl ProgramEditor {
    /// Whether the script that defines the element has run.
    pub(super) fn is_defined(&self) -> bool {
        js_sys::Reflect::has(self, &"start".into()).unwrap_or(false)
    }

    /// The words of a kind of controller, and the letters that it wants, from the next text that is shown.
    pub(super) fn use_words(&self, kind: &Kind) {
        let words = serde_json::to_string(&(kind.keywords)()).unwrap_or_default();
        self.set_words(&parsed(&words));
        self.set_capitals(match kind.text.ignores_case {
            true => "characters",
            false => "none",
        });
    }

    /// Shows the editor with a text, after [`ProgramEditor::use_words`]. The answers stay as long as the page does.
    pub(super) fn begin<H, P, E, C, T>(&self, text: &str, answers: Answers<H, P, E, C, T>)
    where
        H: Fn(&str) -> Vec<u32> + 'static,
        P: Fn() -> String + 'static,
        E: Fn(String, Vec<Edit>) + 'static,
        C: Fn(u32) + 'static,
        T: Fn(u32) + 'static,
    {
        let Answers {
            highlight,
            problems,
            edited,
            cursor,
            toggle,
        } = answers;
        self.set_label("Program");
        self.set_classes(CLASSES.map(str::to_owned).to_vec());
        let highlight = move |line: String| Uint32Array::from(highlight(&line).as_slice());
        self.set_highlight(&function(Closure::<dyn Fn(String) -> Uint32Array>::new(
            highlight,
        )));
        self.set_problems(&function(Closure::<dyn Fn() -> JsValue>::new(move || {
            parsed(&problems())
        })));
        let edited = move |text: String, edits: Vec<u32>| edited(text, read_edits(&edits));
        self.set_edited(&function(Closure::<dyn Fn(String, Vec<u32>)>::new(edited)));
        self.set_cursor(&function(Closure::<dyn Fn(u32)>::new(cursor)));
        self.set_toggle(&function(Closure::<dyn Fn(u32)>::new(toggle)));
        self.start(text);
    }
}

fn function<T: ?Sized + WasmClosure>(closure: Closure<T>) -> Function {
    closure.into_js_value().unchecked_into()
}

fn parsed(json: &str) -> JsValue {
    js_sys::JSON::parse(json).unwrap_or_else(|_| js_sys::Array::new().into())
}

/// Edits as the element describes them, five numbers each.
fn read_edits(numbers: &[u32]) -> Vec<Edit> {
    let edits = numbers.chunks_exact(5).map(|edit| Edit {
        first: edit[0],
        at_start: edit[1] != 0,
        last: edit[2],
        at_end: edit[3] != 0,
        breaks: edit[4],
    });
    edits.collect()
}
