//! A program's text as lines.

/// The lines of a text; they end with CR, LF, or CR LF.
pub fn split_lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    // CR LF counts once: the LF ends nothing when the CR has.
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let end = text.iter().position(|&byte| matches!(byte, b'\r' | b'\n'));
        let Some(end) = end else {
            rest = None;
            return Some(text);
        };
        let behind = text.get(end..).unwrap_or_default();
        let next = match behind {
            [b'\r', b'\n', next @ ..] | [_, next @ ..] => next,
            [] => &[],
        };
        rest = Some(next);
        text.get(..end)
    })
}
