//! The picture as a file.

use leptos::prelude::*;
use leptos::wasm_bindgen::prelude::*;
use web_sys::{Blob, CanvasRenderingContext2d, HtmlCanvasElement};

use super::Sheets;
use crate::state::order::sort_few;
use crate::state::{Store, words};
use crate::storage::files;

/// Room for names and units on the left, and between the strips, CSS pixels.
const LABELS: f64 = 120.0;
const GAP: f64 = 8.0;
/// Text and its lines, CSS pixels.
const TEXT: f64 = 13.0;
const LINE: f64 = 18.0;

/// Gives the user the strips in sight with their names as a PNG.
pub(super) fn picture(store: Store, sheets: Sheets) {
    if let Some(sheet) = compose(store, sheets) {
        let taken = Closure::once_into_js(|contents: Option<Blob>| {
            if let Some(contents) = contents {
                // What the browser refuses, it says itself.
                let _ = files::save_blob("motionbench-scope.png", &contents);
            }
        });
        // A canvas of a size that the browser cannot give is none.
        let _ = sheet.to_blob(taken.unchecked_ref());
    }
}

/// One canvas of all.
fn compose(store: Store, sheets: Sheets) -> Option<HtmlCanvasElement> {
    let density = window().device_pixel_ratio();
    let mut strips = sheets.strips.get_value();
    let order = |name: &str| {
        store.with_scope(|scope| scope.strips().iter().position(|strip| strip.name == name))
    };
    strips.retain(|(_, canvas)| canvas.width() > 0 && canvas.height() > 0);
    sort_few(&mut strips, |a, b| order(&a.0) < order(&b.0));
    strips.push((String::new(), sheets.time.get_untracked()?));
    let width = strips.iter().map(|(_, canvas)| canvas.width()).max()?;
    let height: f64 = strips
        .iter()
        .map(|(_, canvas)| f64::from(canvas.height()) + GAP * density)
        .sum();
    let sheet: HtmlCanvasElement = document().create_element("canvas").ok()?.dyn_into().ok()?;
    sheet.set_width(width + (LABELS * density) as u32);
    sheet.set_height(height as u32);
    let context: CanvasRenderingContext2d = sheet.get_context("2d").ok()??.dyn_into().ok()?;
    let style = window()
        .get_computed_style(&document().document_element()?)
        .ok()??;
    let color = |name: &str| style.get_property_value(name).unwrap_or_default();
    context.set_fill_style_str(&color("--surface"));
    context.fill_rect(
        0.0,
        0.0,
        f64::from(sheet.width()),
        f64::from(sheet.height()),
    );
    context.set_fill_style_str(&color("--ink"));
    context.set_font(&format!("{}px system-ui, sans-serif", TEXT * density));
    let mut top = 0.0;
    for (name, canvas) in &strips {
        let at = (LABELS * density, top);
        context
            .draw_image_with_html_canvas_element(canvas, at.0, at.1)
            .ok()?;
        for (line, text) in labels(store, name).iter().enumerate() {
            let baseline = top + LINE * density * (line as f64 + 1.0);
            context.fill_text(text, GAP * density, baseline).ok()?;
        }
        top += f64::from(canvas.height()) + GAP * density;
    }
    Some(sheet)
}

/// What stands beside a plot: the name, the unit, and what tells its lines apart.
fn labels(store: Store, strip: &str) -> Vec<String> {
    store.with_scope(|scope| {
        let Some(strip) = scope.strip(strip) else {
            return Vec::new();
        };
        let mut labels = vec![strip.name.clone(), words::unit(&strip.unit)];
        if let [first, second, ..] = strip.traces.as_slice() {
            labels.push(first.name.clone());
            labels.push(format!("{}, dashed", second.name));
        }
        labels
    })
}
