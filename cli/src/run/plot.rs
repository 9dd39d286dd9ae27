//! Demanded and actual position and velocity, one strip above the other.

use motionbench_core::controller::ControllerInfo;
use motionbench_core::trace::Trace;
use plotters::coord::Shift;
use plotters::prelude::*;

const WIDTH: u32 = 1000;
const STRIP: u32 = 280;
const TITLE: u32 = 44;
/// The width of a plot's area in points: more than these are drawn as the extremes of each.
const POINTS: usize = 1600;

const INK: RGBColor = RGBColor(31, 41, 55);
const FAINT: RGBColor = RGBColor(229, 231, 235);
const AXIS: RGBColor = RGBColor(156, 163, 175);

/// A strip: signals of one unit over time.
struct Strip<'a> {
    title: String,
    unit: &'a str,
    lines: Vec<Line>,
}

/// One signal, ready to draw.
struct Line {
    look: Look,
    points: Vec<(f64, f64)>,
}

/// How a kind of signal is drawn.
#[derive(Clone, Copy)]
struct Look {
    label: &'static str,
    colour: RGBColor,
    width: u32,
}

impl Look {
    fn style(self) -> ShapeStyle {
        self.colour.stroke_width(self.width)
    }
}

/// What is demanded lies, wider, under what is.
const LOOKS: [Look; 2] = [
    Look {
        label: "demanded",
        colour: RGBColor(245, 158, 11),
        width: 4,
    },
    Look {
        label: "actual",
        colour: RGBColor(37, 99, 235),
        width: 2,
    },
];

/// The drawing, or one clear line why there is none.
pub(super) fn svg(
    info: &ControllerInfo,
    trace: Option<&Trace>,
    title: &str,
) -> Result<String, String> {
    let trace = trace
        .filter(|trace| !trace.is_empty())
        .ok_or("nothing was recorded")?;
    let strips: Vec<Strip> = info
        .axes
        .iter()
        .flat_map(|axis| {
            [
                strip(info, trace, axis, "position", ["command", "position"]),
                strip(info, trace, axis, "velocity", ["velocity", "speed"]),
            ]
        })
        .flatten()
        .collect();
    let height = TITLE + STRIP * u32::try_from(strips.len()).unwrap_or(0);
    let mut svg = String::new();
    draw(&mut svg, (WIDTH, height), title, &strips).map_err(|error| error.to_string())?;
    Ok(svg)
}

/// The strip of `[demanded, actual]`; `None` if the controller has neither.
fn strip<'a>(
    info: &'a ControllerInfo,
    trace: &Trace,
    axis: &str,
    quantity: &str,
    names: [&str; 2],
) -> Option<Strip<'a>> {
    let find = |name: &str| {
        let name = format!("{axis}.{name}");
        info.signals.iter().position(|signal| signal.name == name)
    };
    let found: Vec<usize> = names.iter().filter_map(|name| find(name)).collect();
    let first = *found.first()?;
    let lines = found.iter().zip(LOOKS).map(|(&signal, look)| Line {
        look,
        points: points(trace, signal),
    });
    let lines = lines.collect();
    Some(Strip {
        title: format!("{axis} {quantity}"),
        unit: &info.signals.get(first)?.unit,
        lines,
    })
}

/// A signal over seconds: every row, or of many rows the extremes of each point.
fn points(trace: &Trace, signal: usize) -> Vec<(f64, f64)> {
    if trace.len() <= POINTS {
        return trace
            .rows(signal)
            .map(|(at, value)| (at.seconds(), value))
            .collect();
    }
    let Some((from, to)) = trace.span() else {
        return Vec::new();
    };
    let width = (to.seconds() - from.seconds()) / POINTS as f64;
    let extremes = trace
        .extremes(signal, from, to, POINTS)
        .into_iter()
        .enumerate();
    extremes
        .filter_map(|(index, found)| Some((from.seconds() + (index as f64 + 0.5) * width, found?)))
        .flat_map(|(at, found)| [(at, found.min), (at, found.max)])
        .collect()
}

type Drawn = Result<(), Box<dyn std::error::Error>>;

fn draw(svg: &mut String, size: (u32, u32), title: &str, strips: &[Strip]) -> Drawn {
    let root = SVGBackend::with_string(svg, size).into_drawing_area();
    root.fill(&WHITE)?;
    let font = ("sans-serif", 20).into_font().color(&INK);
    root.draw(&Text::new(title.to_owned(), (16, 14), font))?;
    let font = ("sans-serif", 14).into_font().color(&INK);
    for (x, look) in (i32::try_from(WIDTH)? - 220..).step_by(110).zip(LOOKS) {
        root.draw(&PathElement::new([(x, 24), (x + 24, 24)], look.style()))?;
        root.draw(&Text::new(look.label, (x + 32, 18), font.clone()))?;
    }
    let (_, below) = root.split_vertically(TITLE);
    for (area, strip) in below
        .split_evenly((strips.len().max(1), 1))
        .iter()
        .zip(strips)
    {
        draw_strip(area, strip)?;
    }
    root.present()?;
    Ok(())
}

fn draw_strip(area: &DrawingArea<SVGBackend<'_>, Shift>, strip: &Strip) -> Drawn {
    let all = || strip.lines.iter().flat_map(|line| &line.points);
    let end = all().map(|point| point.0).fold(0.0, f64::max);
    let (low, high) = range(all().map(|point| point.1));
    let mut chart = ChartBuilder::on(area)
        .margin_right(24)
        .margin_left(8)
        .margin_top(10)
        .margin_bottom(4)
        .x_label_area_size(40)
        .y_label_area_size(90)
        .build_cartesian_2d(0.0..end.max(1e-3), low..high)?;
    let text = ("sans-serif", 14).into_font().color(&INK);
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .axis_style(AXIS)
        .x_labels(11)
        .y_labels(7)
        .x_label_formatter(&|value| number(*value))
        .y_label_formatter(&|value| number(*value))
        .label_style(text.clone())
        .axis_desc_style(text.clone())
        .x_desc("time [s]")
        .y_desc(format!("{} [{}]", strip.title, strip.unit))
        .draw()?;
    for line in &strip.lines {
        let points = line.points.iter().copied();
        chart.draw_series(LineSeries::new(points, line.look.style()))?;
    }
    Ok(())
}

/// The values' range with a little room, never empty.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return (-1.0, 1.0);
    }
    let room = ((high - low) * 0.06).max(high.abs() * 1e-6).max(0.5);
    (low - room, high + room)
}

/// A label of an axis: no more digits than it needs.
fn number(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    if rounded == 0.0 {
        "0".to_owned()
    } else {
        rounded.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_never_empty() {
        assert_eq!(range([].into_iter()), (-1.0, 1.0));
        assert_eq!(range([f64::NAN].into_iter()), (-1.0, 1.0));
        assert_eq!(range([5.0].into_iter()), (4.5, 5.5));
        let (low, high) = range([0.0, 100.0].into_iter());
        assert!(low < 0.0 && high > 100.0);
    }

    #[test]
    fn labels_have_no_rounding_noise() {
        assert_eq!(number(0.1 + 0.2), "0.3");
        assert_eq!(number(-1e-12), "0");
        assert_eq!(number(40960.0), "40960");
    }
}
