//! Lines on a canvas. Text is drawn without being measured: plotters would measure it in the document, which costs
//! layouts and needs inline styles.

use leptos::prelude::*;
use leptos::wasm_bindgen::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters_canvas::CanvasBackend;
use web_sys::{HtmlCanvasElement, MediaQueryList};

use crate::state::scope::Scale;
use crate::state::words;

/// Height of a strip that its line leaves free above and below, as a part of the whole.
const MARGIN: f64 = 0.1;
/// Beside the lines, CSS pixels: room for the numbers on the left, and for half of the last one on the right.
const LEFT: f64 = 48.0;
const RIGHT: f64 = 16.0;
/// Text, and the least distance of two marks of a strip, CSS pixels.
const TEXT: f64 = 11.0;
const MARK: f64 = 48.0;
/// Pixels of the canvas in a CSS pixel, at least: plotters rounds to whole pixels, and more of them make it smooth.
const LEAST_DENSITY: f64 = 2.0;

/// Colours of the page, by its style sheet.
pub(super) struct Colors {
    surface: RGBColor,
    line: RGBColor,
    muted: RGBColor,
    traces: [RGBColor; 2],
}

impl Colors {
    /// As they are now, light or dark.
    pub(super) fn of_page() -> Option<Colors> {
        let style = window()
            .get_computed_style(&document().document_element()?)
            .ok()??;
        let color = |name: &str| parse(style.get_property_value(name).ok()?.trim());
        Some(Colors {
            surface: color("--surface")?,
            line: color("--line")?,
            muted: color("--muted")?,
            traces: [color("--trace-1")?, color("--trace-3")?],
        })
    }
}

/// `#rrggbb`.
fn parse(text: &str) -> Option<RGBColor> {
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6)?;
    let number = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some(RGBColor(number[1], number[2], number[3]))
}

/// Calls `tell` when the page turns light or dark.
pub(super) fn on_color_scheme(tell: impl Fn() + 'static) {
    let query = window().match_media("(prefers-color-scheme: dark)");
    let Ok(Some(query)) = query else { return };
    let changed = Closure::<dyn Fn()>::new(tell).into_js_value();
    query.set_onchange(Some(changed.unchecked_ref()));
    // The browser may forget a query that no one holds.
    let query: StoredValue<MediaQueryList, LocalStorage> = StoredValue::new_local(query);
    on_cleanup(move || query.with_value(|query| query.set_onchange(None)));
}

fn density() -> f64 {
    window().device_pixel_ratio().max(LEAST_DENSITY)
}

/// Gives the canvas pixels for the room that it has, in CSS pixels.
pub(super) fn fit(canvas: &HtmlCanvasElement, width: f64, height: f64) {
    let density = density();
    canvas.set_width((width * density).round() as u32);
    canvas.set_height((height * density).round() as u32);
}

/// A canvas to draw on.
pub(super) struct Surface {
    area: DrawingArea<CanvasBackend, Shift>,
    /// Pixels of the canvas in a CSS pixel.
    density: f64,
}

impl Surface {
    /// `None` for one without room.
    pub(super) fn of(canvas: &HtmlCanvasElement) -> Option<Surface> {
        if canvas.width() == 0 || canvas.height() == 0 {
            return None;
        }
        let backend = CanvasBackend::with_canvas_object(canvas.clone())?;
        let area = backend.into_drawing_area();
        Some(Surface {
            area,
            density: density(),
        })
    }

    /// Pixels that a line has from left to right.
    pub(super) fn columns(&self) -> usize {
        (self.width() - self.pixels(LEFT + RIGHT)).max(1) as usize
    }

    /// How many marks a strip has room for.
    pub(super) fn marks(&self) -> f64 {
        (f64::from(self.height()) / (self.density * MARK)).clamp(2.0, 5.0)
    }

    fn width(&self) -> i32 {
        self.area.dim_in_pixel().0 as i32
    }

    fn height(&self) -> i32 {
        self.area.dim_in_pixel().1 as i32
    }

    fn pixels(&self, css: f64) -> i32 {
        (css * self.density).round() as i32
    }

    fn text(&self, text: &str, at: (i32, i32), place: HPos, color: &RGBColor) {
        let size = TEXT * self.density;
        let style = ("system-ui, sans-serif", size)
            .into_font()
            .color(color)
            .pos(Pos::new(place, VPos::Center));
        // A canvas that the browser has taken away shows nothing, and needs nothing.
        let _ = self.area.draw_text(text, &style, at);
    }
}

/// A strip: its marks, their numbers, and the line in s and the signal's unit.
pub(super) fn strip(
    surface: &Surface,
    time: Scale,
    scale: Scale,
    line: &[(f64, f64)],
    colors: &Colors,
    trace: usize,
) {
    let margin = (scale.high - scale.low) * MARGIN;
    let (low, high) = (scale.low - margin, scale.high + margin);
    let draw = || -> Result<(), Box<dyn std::error::Error>> {
        surface.area.fill(&colors.surface)?;
        let chart = ChartBuilder::on(&surface.area)
            .margin_left(surface.pixels(LEFT))
            .margin_right(surface.pixels(RIGHT))
            .build_cartesian_2d(time.low..time.high, low..high)?;
        let plot = chart.plotting_area();
        let thin = colors.line.stroke_width(surface.pixels(1.0).unsigned_abs());
        for at in time.marks() {
            plot.draw(&PathElement::new([(at, low), (at, high)], thin))?;
        }
        let text_height = surface.pixels(TEXT);
        for value in scale.marks() {
            plot.draw(&PathElement::new(
                [(time.low, value), (time.high, value)],
                thin,
            ))?;
            let (left, y) = plot.map_coordinate(&(time.low, value));
            if y >= text_height / 2 && y <= surface.height() - text_height / 2 {
                let number = words::number(value, scale.digits());
                let at = (left - surface.pixels(6.0), y);
                surface.text(&number, at, HPos::Right, &colors.muted);
            }
        }
        let thick = colors.traces[trace].stroke_width(surface.pixels(2.0).unsigned_abs());
        plot.draw(&PathElement::new(line, thick))?;
        Ok(())
    };
    // A canvas that the browser has taken away shows nothing, and needs nothing.
    let _ = draw();
}

/// The numbers of the time axis.
pub(super) fn time_axis(surface: &Surface, time: Scale, colors: &Colors) {
    // As in `strip`.
    let _ = surface.area.fill(&colors.surface);
    let (left, right) = (surface.pixels(LEFT), surface.pixels(RIGHT));
    let width = f64::from(surface.width() - left - right);
    for (index, at) in time.marks().enumerate() {
        let x = left + ((at - time.low) / (time.high - time.low) * width).round() as i32;
        let text = match index {
            0 if at == 0.0 => "0 s".to_owned(),
            0 => format!("{} s", words::number(at, time.digits())),
            _ => words::number(at, time.digits()),
        };
        let at = (x, surface.height() / 2);
        surface.text(&text, at, HPos::Center, &colors.muted);
    }
}
