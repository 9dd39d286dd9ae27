//! Lines on a canvas. Text is drawn without being measured: plotters would measure it in the document, which costs
//! layouts and needs inline styles.

use js_sys::Array;
use leptos::prelude::*;
use leptos::wasm_bindgen::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, MediaQueryList};

use super::fine::{FINE, Fine};
use crate::state::scope::{Line, Picture, Scale, thin};
use crate::state::words;

/// Height of a strip that its line leaves free above and below, as a part of the whole.
const MARGIN: f64 = 0.1;
/// Beside the lines, in the page's own size of text, as in the style sheet: room for the numbers on the left, and for
/// half of the last one on the right.
const LEFT: f64 = 2.75;
const RIGHT: f64 = 1.0;
/// The least distance of two marks of a strip, CSS pixels.
const MARK: f64 = 40.0;
/// Small text, in the page's own size.
const TEXT: f64 = 0.6875;
/// A line, the second line of a strip and its strokes, CSS pixels: where both lie on each other both are seen.
const LINE: f64 = 2.0;
const SECOND: f64 = 1.5;
const DASH: f64 = 5.0;
const GAP: f64 = 5.0;

type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Colours of the page, by its style sheet.
pub(super) struct Colors {
    surface: RGBColor,
    line: RGBColor,
    muted: RGBColor,
    traces: [RGBColor; 4],
    /// The page's own size of text, CSS pixels: the user may have chosen a larger one.
    pub(super) rem: f64,
}

impl Colors {
    /// As they are now, light or dark.
    pub(super) fn of_page() -> Option<Colors> {
        let style = window()
            .get_computed_style(&document().document_element()?)
            .ok()??;
        let color = |name: &str| parse(style.get_property_value(name).ok()?.trim());
        let size = style.get_property_value("font-size").ok()?;
        let size = size.strip_suffix("px")?;
        Some(Colors {
            surface: color("--surface")?,
            line: color("--line")?,
            muted: color("--muted")?,
            traces: [
                color("--trace-1")?,
                color("--trace-2")?,
                color("--trace-3")?,
                color("--trace-4")?,
            ],
            rem: size.parse().ok()?,
        })
    }
}

impl Colors {
    fn of(&self, line: &Line) -> &RGBColor {
        &self.traces[(line.color + 3) % 4]
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
    context: CanvasRenderingContext2d,
    /// Pixels of the screen in a CSS pixel.
    density: f64,
    /// As in [`Colors`].
    rem: f64,
}

impl Surface {
    /// `None` for one without room.
    pub(super) fn of(canvas: &HtmlCanvasElement, colors: &Colors) -> Option<Surface> {
        if canvas.width() == 0 || canvas.height() == 0 {
            return None;
        }
        let context = canvas.get_context("2d").ok()??;
        Some(Surface {
            area: Fine::of(canvas)?.into_drawing_area(),
            context: context.dyn_into().ok()?,
            density: window().device_pixel_ratio(),
            rem: colors.rem,
        })
    }

    /// Pixels that a line has from left to right.
    pub(super) fn columns(&self) -> usize {
        ((self.width() - self.units(self.rem * (LEFT + RIGHT))) / FINE).max(1) as usize
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

    fn text(&self, text: &str, at: (i32, i32), place: HPos, colors: &Colors) {
        let size = f64::from(self.units(self.rem * TEXT));
        let style = ("system-ui, sans-serif", size)
            .into_font()
            .color(&colors.muted)
            .pos(Pos::new(place, VPos::Center));
        // A canvas that the browser has taken away shows nothing, and needs nothing.
        let _ = self.area.draw_text(text, &style, at);
    }

    /// Draws within these edges only, in strokes if wanted.
    fn clipped(&self, edges: &Range2, dashed: bool, draw: impl FnOnce() -> Drawn) -> Drawn {
        let context = &self.context;
        context.save();
        let (left, top) = (f64::from(edges.0.start), f64::from(edges.1.start));
        let (right, bottom) = (f64::from(edges.0.end), f64::from(edges.1.end));
        context.begin_path();
        context.rect(left, top, right - left, bottom - top);
        context.clip();
        context.set_line_join("round");
        if dashed {
            let strokes = [DASH, GAP].map(|css| JsValue::from(self.units(css)));
            // Without strokes it is a line all the same.
            let _ = context.set_line_dash(&Array::of2(&strokes[0], &strokes[1]));
        }
        let drawn = draw();
        context.restore();
        drawn
    }
}

/// From left to right, and from top to bottom.
type Range2 = (std::ops::Range<i32>, std::ops::Range<i32>);

/// A strip: its marks, their numbers, and its lines.
pub(super) fn strip(surface: &Surface, time: Scale, picture: &Picture, colors: &Colors) {
    let scale = picture.scale;
    let lanes = !picture.lanes.is_empty();
    let margin = if lanes { 0.0 } else { MARGIN };
    let margin = (scale.high - scale.low) * margin;
    let (low, high) = (scale.low - margin, scale.high + margin);
    let draw = || -> Drawn {
        surface.area.fill(&colors.surface)?;
        let chart = ChartBuilder::on(&surface.area)
            .margin_left(surface.units(surface.rem * LEFT))
            .margin_right(surface.units(surface.rem * RIGHT))
            .build_cartesian_2d(time.low..time.high, low..high)?;
        let plot = chart.plotting_area();
        for at in time.marks() {
            let ends = [low, high].map(|value| plot.map_coordinate(&(at, value)));
            surface.grid_line(ends, &colors.line)?;
        }
        let number = |value: f64, text: &str| {
            let (left, y) = plot.map_coordinate(&(time.low, value));
            let half = surface.units(surface.rem * TEXT) / 2;
            if y >= half && y <= surface.height() - half {
                let at = (left - surface.units(6.0), y);
                surface.text(text, at, HPos::Right, colors);
            }
        };
        for value in scale.marks() {
            let ends = [time.low, time.high].map(|at| plot.map_coordinate(&(at, value)));
            surface.grid_line(ends, &colors.line)?;
            if !lanes {
                number(value, &words::short(value, scale.digits()));
            }
        }
        for (lane, bit) in picture.lanes.iter().enumerate() {
            number(lane as f64 + 0.5, &bit.to_string());
        }
        let edges = plot.get_pixel_range();
        for line in &picture.lines {
            surface.clipped(&edges, line.second, || {
                let width = if line.second { SECOND } else { LINE };
                let style = surface.stroke(colors.of(line), width);
                let points = line.points.iter().map(|point| plot.map_coordinate(point));
                let points = thin(points, FINE / 4);
                surface.area.draw(&PathElement::new(points, style))?;
                Ok(())
            })?;
        }
        Ok(())
    };
    // A canvas that the browser has taken away shows nothing, and needs nothing.
    let _ = draw();
}

/// The numbers of the time axis.
pub(super) fn time_axis(surface: &Surface, time: Scale, colors: &Colors) {
    // As in `strip`.
    let _ = surface.area.fill(&colors.surface);
    let (left, right) = (
        surface.units(surface.rem * LEFT),
        surface.units(surface.rem * RIGHT),
    );
    let width = f64::from(surface.width() - left - right);
    for (index, at) in time.marks().enumerate() {
        let x = left + ((at - time.low) / (time.high - time.low) * width).round() as i32;
        let text = match index {
            0 if at == 0.0 => "0 s".to_owned(),
            0 => format!("{} s", words::number(at, time.digits())),
            _ => words::number(at, time.digits()),
        };
        let at = (x, surface.height() / 2);
        surface.text(&text, at, HPos::Center, colors);
    }
}
