//! What a scenario makes of a console's output: a position up to which it has been matched, and the typed lines whose
//! echo has not been.

use std::collections::VecDeque;

/// Typed lines that are remembered; a reply needs the last, and those before it only where they look alike.
const MOST_TYPED: usize = 1000;

/// How far the output of one host line has been read. The output itself is kept outside, so that a checkpoint is small.
#[derive(Debug, Clone, Default)]
pub(super) struct Reader {
    /// Everything before has been matched.
    position: usize,
    typed: VecDeque<Typed>,
}

/// A line that was typed.
#[derive(Debug, Clone)]
struct Typed {
    text: Vec<u8>,
    /// Its echo is not before this.
    earliest: usize,
}

impl Reader {
    /// The output since the last match.
    pub(super) fn unmatched<'o>(&self, output: &'o [u8]) -> &'o [u8] {
        output.get(self.position..).unwrap_or_default()
    }

    /// Where the unmatched output starts.
    pub(super) fn position(&self) -> usize {
        self.position
    }

    /// Notes a typed line.
    pub(super) fn typed(&mut self, text: &[u8], output: &[u8]) {
        if self.typed.len() >= MOST_TYPED {
            self.typed.pop_front();
        }
        self.typed.push_back(Typed {
            text: text.to_vec(),
            earliest: output.len(),
        });
    }

    /// Moves behind the first `text` after the position; `false` if there is none.
    pub(super) fn expect(&mut self, text: &[u8], output: &[u8]) -> bool {
        let Some(at) = find(self.unmatched(output), text) else {
            return false;
        };
        self.move_to(self.position + at + text.len(), output);
        true
    }

    /// Moves behind everything.
    pub(super) fn finish(&mut self, output: &[u8]) {
        self.position = output.len();
        self.typed.clear();
    }

    fn move_to(&mut self, position: usize, output: &[u8]) {
        let matched = output.get(..position).unwrap_or(output);
        let mut from = self.position;
        while let Some(end) = self
            .typed
            .front()
            .and_then(|typed| typed.echo_end(matched, from))
        {
            from = end;
            self.typed.pop_front();
        }
        self.position = position;
    }

    /// What stands between the echo of the last typed line and the prompt at the end, without its last line end.
    pub(super) fn reply<'o>(&self, prompt: &[u8], output: &'o [u8]) -> Result<&'o [u8], NoReply> {
        let body = output.strip_suffix(prompt).ok_or(NoReply::Prompt)?;
        let mut from = self.position;
        if let Some(last) = self.typed.back() {
            // Echoes come in the order of the lines. A password's does not come at all; then the last line counts alone.
            let mut typed = self.typed.iter();
            let in_order = typed.try_fold(from, |from, line| line.echo_end(body, from));
            let alone = || last.echo_end(body, self.position);
            // A controller without a prompt may be one without an echo.
            let unechoed = || prompt.is_empty().then_some(from);
            from = in_order
                .or_else(alone)
                .or_else(unechoed)
                .ok_or(NoReply::Echo)?;
        }
        let reply = body.get(from..).ok_or(NoReply::Prompt)?;
        let (reply, ended) = strip_line_end(reply);
        // Without a line end before it, what looks like a prompt is the end of a line.
        match ended || reply.is_empty() || prompt.is_empty() {
            true => Ok(reply),
            false => Err(NoReply::Prompt),
        }
    }

    /// The last typed line.
    pub(super) fn last_typed(&self) -> &[u8] {
        self.typed.back().map_or(&[], |typed| &typed.text)
    }
}

/// Why there is no reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoReply {
    /// The output does not end with a prompt at the start of a line.
    Prompt,
    /// The last typed line was not echoed.
    Echo,
}

impl Typed {
    /// Behind the echo and its line end, if it stands after `from`.
    fn echo_end(&self, output: &[u8], from: usize) -> Option<usize> {
        let mut from = from.max(self.earliest);
        loop {
            let rest = output.get(from..)?;
            let at = find(rest, &self.text)?;
            let after = rest.get(at + self.text.len()..)?;
            let line_end = match after {
                [b'\r', b'\n', ..] => 2,
                [b'\r' | b'\n', ..] => 1,
                // The text alone may stand in a longer line.
                _ => {
                    from += at + 1;
                    continue;
                }
            };
            return Some(from + at + self.text.len() + line_end);
        }
    }
}

/// Text without its last line end, and whether it had one.
fn strip_line_end(text: &[u8]) -> (&[u8], bool) {
    match text {
        [text @ .., b'\r', b'\n'] | [text @ .., b'\r' | b'\n'] => (text, true),
        _ => (text, false),
    }
}

/// Where `text` first stands in `output`.
pub(super) fn find(output: &[u8], text: &[u8]) -> Option<usize> {
    if text.is_empty() {
        return Some(0);
    }
    output.windows(text.len()).position(|window| window == text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reply<'o>(typed: &[&str], output: &'o str) -> Result<&'o str, NoReply> {
        let mut reader = Reader::default();
        typed.iter().for_each(|t| reader.typed(t.as_bytes(), b""));
        let reply = reader.reply(b">", output.as_bytes())?;
        Ok(std::str::from_utf8(reply).unwrap())
    }

    #[test]
    fn a_reply_stands_between_the_last_echo_and_the_prompt() {
        assert_eq!(reply(&["?1"], ">?1\r\n 1 \r\n>"), Ok(" 1 "));
        assert_eq!(reply(&["A=1"], ">A=1\r\n>"), Ok(""));
        assert_eq!(reply(&["RUN"], ">RUN\r\n1\r\n\r\n2\r\n>"), Ok("1\r\n\r\n2"));
        assert_eq!(reply(&[], "\r\nHELLO\r\n>"), Ok("\r\nHELLO"));
        // The second of two lines, also where the first contains it.
        let listing = "10 PRINT \"RUN";
        assert_eq!(
            reply(&[listing, "RUN"], ">10 PRINT \"RUN\r\n>RUN\r\nRUN\r\n>"),
            Ok("RUN")
        );
    }

    #[test]
    fn without_an_echo_or_a_prompt_there_is_no_reply() {
        assert_eq!(reply(&["?1"], ">?2\r\n 2 \r\n>"), Err(NoReply::Echo));
        assert_eq!(reply(&["?1"], ">?1\r\n 1 "), Err(NoReply::Prompt));
        assert_eq!(reply(&["?1"], ">?1\r\nA>"), Err(NoReply::Prompt));
    }

    #[test]
    fn without_a_prompt_a_reply_is_all_there_is() {
        let mut reader = Reader::default();
        reader.typed(b"RP", b"");
        assert_eq!(reader.reply(b"", b"100\r"), Ok(&b"100"[..]));
        assert_eq!(reader.reply(b"", b"RP\r100\r"), Ok(&b"100"[..]));
        assert_eq!(reader.reply(b"", b"READY"), Ok(&b"READY"[..]));
    }

    #[test]
    fn an_echo_is_not_sought_before_its_line_was_typed() {
        let mut reader = Reader::default();
        let output = b">RUN\r\n1\r\n>";
        reader.typed(b"RUN", b"");
        reader.typed(b"1", output);
        let all = b">RUN\r\n1\r\n>1\r\n?SYNTAX ERROR\r\n>";
        assert_eq!(reader.reply(b">", all), Ok(&b"?SYNTAX ERROR"[..]));
    }

    #[test]
    fn a_line_without_an_echo_is_passed_over() {
        let mut reader = Reader::default();
        reader.typed(b"PRINT 5", b"");
        reader.typed(b"PASSWORD", b"PASSWORD? ");
        let asked = b"PASSWORD? *******\r\nPASSWORD? ********\r\n>";
        reader.typed(b"PRINT 5", asked);
        let all = [&asked[..], b"PRINT 5\r\n 5 \r\n>"].concat();
        assert_eq!(reader.reply(b">", &all), Ok(&b" 5 "[..]));
    }

    #[test]
    fn a_match_takes_the_echoes_before_it_along() {
        let mut reader = Reader::default();
        reader.typed(b"RUN", b"");
        let output = b">RUN\r\nRUN\r\n>";
        assert!(reader.expect(b"RUN\r\n", output));
        assert!(reader.typed.is_empty());
        assert_eq!(reader.reply(b">", output), Ok(&b"RUN"[..]));
        assert!(!reader.expect(b">R", output));
        reader.finish(output);
        assert!(reader.unmatched(output).is_empty());
    }
}
