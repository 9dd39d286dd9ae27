//! Lines on a canvas. Text is drawn without being measured: plotters would measure it in the document, which costs
//! layouts and needs inline styles.

use leptos::prelude::*;
use leptos::wasm_bindgen::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use web_sys::{HtmlCanvasElement, MediaQueryList};

use super::fine::{FINE, Fine};
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

type Drawn = Result<(), Box<dyn std::error::Error>>;

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

/// Gives the canvas as many pixels as the screen has in the room that it has, in CSS pixels.
pub(super) fn fit(canvas: &HtmlCanvasElement, width: f64, height: f64) {
    let density = window().device_pixel_ratio();
    canvas.set_width((width * density).round() as u32);
    canvas.set_height((height * density).round() as u32);
}

/// A canvas to draw on. Its unit is a part of a pixel.
pub(super) struct Surface {
    area: DrawingArea<Fine, Shift>,
    /// Pixels of the screen in a CSS pixel.
    density: f64,
}

impl Surface {
    /// `None` for one without room.
    pub(super) fn of(canvas: &HtmlCanvasElement) -> Option<Surface> {
        if canvas.width() == 0 || canvas.height() == 0 {
            return None;
        }
        Some(Surface {
            area: Fine::of(canvas)?.into_drawing_area(),
            density: window().device_pixel_ratio(),
        })
    }

    /// Pixels that a line has from left to right.
    pub(super) fn columns(&self) -> usize {
        ((self.width() - self.units(LEFT + RIGHT)) / FINE).max(1) as usize
    }

    /// How many marks a strip has room for.
    pub(super) fn marks(&self) -> f64 {
        (f64::from(self.height()) / f64::from(self.units(MARK))).clamp(2.0, 5.0)
    }

    fn width(&self) -> i32 {
        self.area.dim_in_pixel().0 as i32
    }

    fn height(&self) -> i32 {
        self.area.dim_in_pixel().1 as i32
    }

    /// CSS pixels in units of the drawing.
    fn units(&self, css: f64) -> i32 {
        (css * self.density * f64::from(FINE)).round() as i32
    }

    /// The style of a line so many CSS pixels wide.
    fn stroke(&self, color: &RGBColor, css: f64) -> ShapeStyle {
        color.stroke_width(self.units(css).unsigned_abs())
    }

    /// A straight line of the grid, moved to fill whole pixels, so that it is as thin as it can be.
    fn grid_line(&self, ends: [(i32, i32); 2], color: &RGBColor) -> Drawn {
        let width = self.density.round().max(1.0) as i32;
        let snap = |at: i32| at.div_euclid(FINE) * FINE + width % 2 * FINE / 2;
        let [from, to] = ends;
        let ends = if from.0 == to.0 {
            [(snap(from.0), from.1), (snap(to.0), to.1)]
        } else {
            [(from.0, snap(from.1)), (to.0, snap(to.1))]
        };
        let style = color.stroke_width((width * FINE).unsigned_abs());
        self.area.draw(&PathElement::new(ends, style))?;
        Ok(())
    }

    fn text(&self, text: &str, at: (i32, i32), place: HPos, color: &RGBColor) {
        let size = f64::from(self.units(TEXT));
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
    let draw = || -> Drawn {
        surface.area.fill(&colors.surface)?;
        let chart = ChartBuilder::on(&surface.area)
            .margin_left(surface.units(LEFT))
            .margin_right(surface.units(RIGHT))
            .build_cartesian_2d(time.low..time.high, low..high)?;
        let plot = chart.plotting_area();
        for at in time.marks() {
            let ends = [low, high].map(|value| plot.map_coordinate(&(at, value)));
            surface.grid_line(ends, &colors.line)?;
        }
        let text_height = surface.units(TEXT);
        for value in scale.marks() {
            let ends = [time.low, time.high].map(|at| plot.map_coordinate(&(at, value)));
            surface.grid_line(ends, &colors.line)?;
            let (left, y) = ends[0];
            if y >= text_height / 2 && y <= surface.height() - text_height / 2 {
                let number = words::number(value, scale.digits());
                let at = (left - surface.units(6.0), y);
                surface.text(&number, at, HPos::Right, &colors.muted);
            }
        }
        let style = surface.stroke(&colors.traces[trace], 2.0);
        plot.draw(&PathElement::new(line, style))?;
        Ok(())
    };
    // A canvas that the browser has taken away shows nothing, and needs nothing.
    let _ = draw();
}

/// The numbers of the time axis.
pub(super) fn time_axis(surface: &Surface, time: Scale, colors: &Colors) {
    // As in `strip`.
    let _ = surface.area.fill(&colors.surface);
    let (left, right) = (surface.units(LEFT), surface.units(RIGHT));
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
