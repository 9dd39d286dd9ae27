//! Characters of light: sixteen segments and a point for text, seven segments for numbers.

use leptos::prelude::*;

/// The segments of a text character, in the order of the bits below, in a box of 13 by 20.
const TEXT: [&str; 17] = [
    "M2.4 1.5H5.4",
    "M6.6 1.5H9.6",
    "M10.5 2.4V9.2",
    "M10.5 10.8V17.6",
    "M2.4 18.5H5.4",
    "M6.6 18.5H9.6",
    "M1.5 10.8V17.6",
    "M1.5 2.4V9.2",
    "M2.4 10H5.4",
    "M6.6 10H9.6",
    "M2.8 3.2L5 8.6",
    "M6 2.7V8.9",
    "M9.2 3.2L7 8.6",
    "M2.8 16.8L5 11.4",
    "M6 11.1V17.3",
    "M9.2 16.8L7 11.4",
    "M11.9 18.5h.9",
];

/// What each character from the blank to the underline lights.
#[rustfmt::skip]
const LIT: [u32; 64] = [
    0x00000, 0x14800, 0x00880, 0x04b3c, 0x04bbb, 0x07ba9, 0x08d71, 0x00800,
    0x09000, 0x02400, 0x0ff00, 0x04b00, 0x02000, 0x00300, 0x10000, 0x03000,
    0x030ff, 0x0100c, 0x00377, 0x0023f, 0x0038c, 0x003bb, 0x003fb, 0x0000f,
    0x003ff, 0x003bf, 0x04800, 0x02800, 0x09000, 0x00330, 0x02400, 0x04207,
    0x00af7, 0x003cf, 0x04a3f, 0x000f3, 0x0483f, 0x001f3, 0x001c3, 0x002fb,
    0x003cc, 0x04833, 0x0007c, 0x091c0, 0x000f0, 0x014cc, 0x084cc, 0x000ff,
    0x003c7, 0x080ff, 0x083c7, 0x003bb, 0x04803, 0x000fc, 0x030c0, 0x0a0cc,
    0x0b400, 0x05400, 0x03033, 0x04822, 0x08400, 0x04811, 0x0a000, 0x00030,
];

/// The segments of a digit.
const NUMBER: [&str; 7] = [
    "M2.4 1.5H9.6",
    "M10.5 2.4V9.2",
    "M10.5 10.8V17.6",
    "M2.4 18.5H9.6",
    "M1.5 10.8V17.6",
    "M1.5 2.4V9.2",
    "M2.4 10H9.6",
];

/// What each digit lights.
const DIGITS: [u32; 10] = [0x3f, 0x06, 0x5b, 0x4f, 0x66, 0x6d, 0x7d, 0x07, 0x7f, 0x6f];

/// The segments that a character of text lights; none for what the display does not have.
fn text(character: char) -> u32 {
    let place = u32::from(character.to_ascii_uppercase()).wrapping_sub(0x20);
    LIT.get(place as usize).copied().unwrap_or_default()
}

/// The segments that a character of a number lights.
fn number(character: char) -> u32 {
    match (character, character.to_digit(10)) {
        ('-', _) => 1 << 6,
        (_, Some(digit)) => DIGITS.get(digit as usize).copied().unwrap_or_default(),
        _ => 0,
    }
}

fn drawn(segments: &[&str], lit: u32) -> String {
    let lit = (0..).zip(segments).filter(|(bit, _)| lit >> bit & 1 != 0);
    lit.map(|(_, segment)| *segment).collect()
}

/// A row of characters as wide as `places`, which shows what is read; what does not fit is cut off.
#[component]
pub(super) fn Segments(
    places: usize,
    /// Digits and a sign, not text.
    #[prop(optional)]
    numeric: bool,
    #[prop(into)] shows: Signal<String>,
) -> impl IntoView {
    let (segments, lit): (&[&str], fn(char) -> u32) = match numeric {
        true => (&NUMBER, number),
        false => (&TEXT, text),
    };
    let place = |place: usize| {
        let shown = Memo::new(move |_| shows.with(|shown| shown.chars().nth(place).unwrap_or(' ')));
        view! {
            <svg viewBox="-1 -1 15 22">
                <path class="dark" d=drawn(segments, u32::MAX) />
                <path class="lit" d=move || drawn(segments, lit(shown.get())) />
            </svg>
        }
    };
    view! { <div class="segments" aria-hidden="true">{(0..places).map(place).collect_view()}</div> }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_light_what_tells_them_apart() {
        let mut seen: Vec<u32> = ('A'..='Z').chain('0'..='9').map(text).collect();
        seen.sort_unstable();
        // S is written as 5.
        let before = seen.len();
        seen.dedup();
        assert_eq!(before - seen.len(), 1);
        assert!(seen.iter().all(|&segments| segments != 0));
        assert_eq!(text('g'), text('G'));
        assert_eq!((text(' '), text('\u{e9}'), text('~')), (0, 0, 0));
        assert_eq!(number('8').count_ones(), 7);
        assert_eq!(
            (number(' '), drawn(&NUMBER, number('-')).as_str()),
            (0, "M2.4 10H9.6")
        );
    }
}
