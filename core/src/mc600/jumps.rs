//! The line numbers that a line's text jumps to: what RENUM changes and what must exist. Read from the tokens, so that
//! a statement with an error in it is renumbered, too.

use super::ast::LineRef;
use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::lexer::{Token, TokenKind, read_line_number, tokens};
use crate::language::Span;

/// A jump.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Jump {
    /// Where to. A number that is left out (line 0) has an empty place.
    pub line: LineRef,
    /// What the device says if there is no such line.
    pub error: ErrorCode,
}

/// The jumps of a text, from left to right: behind GOTO and GOSUB, with the lists of ON, behind THEN, ELSE and RUN, and
/// the first argument of INTSETUP.
pub fn jumps(text: &[u8]) -> Vec<Jump> {
    let tokens = tokens(text, 0);
    let mut finder = Finder {
        text,
        found: Vec::new(),
    };
    let mut in_mask = false;
    for (index, token) in tokens.iter().enumerate() {
        // A file mask without quotes may look like anything.
        in_mask = !ends_statement(token) && (in_mask || is_mask(token));
        if let (TokenKind::Keyword(keyword), false) = (token.kind, in_mask) {
            let rest = tokens.get(index + 1..).unwrap_or_default();
            finder.behind(keyword, token, rest);
        }
    }
    finder.found
}

struct Finder<'a> {
    text: &'a [u8],
    found: Vec<Jump>,
}

impl Finder<'_> {
    /// Finds the jumps that `word` makes of the tokens behind it.
    fn behind(&mut self, keyword: Keyword, word: &Token, rest: &[Token]) {
        match (keyword, rest) {
            (Keyword::Goto | Keyword::GoTo | Keyword::Gosub, _) => self.list(word, rest),
            (Keyword::Then | Keyword::Else, [line, ..]) => {
                self.number(line, ErrorCode::UndefdStatement)
            }
            (Keyword::Intsetup, [_, line, comma, ..]) if comma.kind == TokenKind::Comma => {
                self.number(line, ErrorCode::UndefdStatement);
            }
            (Keyword::Run, _) => match rest.split(ends_statement).next() {
                Some([line]) => self.number(line, ErrorCode::UndefinedLineNumber),
                Some([.., comma, line]) if comma.kind == TokenKind::Comma => {
                    self.number(line, ErrorCode::UndefinedLineNumber);
                }
                _ => {}
            },
            _ => {}
        }
    }

    /// One number, or several with commas between; each may be left out.
    fn list(&mut self, word: &Token, mut rest: &[Token]) {
        let mut before = word;
        loop {
            match rest {
                [line, behind @ ..] if is_integer(line) => {
                    self.number(line, ErrorCode::UndefdStatement);
                    rest = behind;
                }
                _ if is_over(rest) => self.found.push(Jump {
                    line: LineRef {
                        number: 0,
                        span: Span {
                            start: before.span.end,
                            end: before.span.end,
                        },
                    },
                    error: ErrorCode::UndefdStatement,
                }),
                _ => return,
            }
            match rest {
                [comma, behind @ ..] if comma.kind == TokenKind::Comma => {
                    (before, rest) = (comma, behind)
                }
                _ => return,
            }
        }
    }

    fn number(&mut self, line: &Token, error: ErrorCode) {
        if let Some(number) = read_line_number(line.span.of(self.text)) {
            self.found.push(Jump {
                line: LineRef {
                    number,
                    span: line.span,
                },
                error,
            });
        }
    }
}

fn is_mask(token: &Token) -> bool {
    matches!(
        token.kind,
        TokenKind::Keyword(Keyword::Files | Keyword::Erase | Keyword::Format)
    )
}

fn is_integer(token: &Token) -> bool {
    matches!(token.kind, TokenKind::Integer(_))
}

fn ends_statement(token: &Token) -> bool {
    matches!(
        token.kind,
        TokenKind::Colon | TokenKind::Keyword(Keyword::Else)
    )
}

/// Whether a number was left out before these tokens.
fn is_over(rest: &[Token]) -> bool {
    rest.first()
        .is_none_or(|token| ends_statement(token) || token.kind == TokenKind::Comma)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_every_jump_in_order() {
        for (text, expected) in [
            ("GOTO100", &[100][..]),
            ("GO TO 50: GOSUB 60", &[50, 60]),
            ("GOTO", &[0]),
            ("GOTO X", &[]),
            ("ON X GOTO 100,,300:PRINT 5,6", &[100, 0, 300]),
            ("IF A=1 THEN 10 ELSE 20", &[10, 20]),
            ("IF A=1 THEN PRINT 10 ELSE PRINT 20", &[]),
            ("IF A GOTO 7 ELSE 8", &[7, 8]),
            ("RUN 500", &[500]),
            ("RUN \"A.BAS\",500: STOP", &[500]),
            ("IF A THEN RUN 500 ELSE RUN", &[500]),
            ("RUN X+5", &[]),
            ("FILES GOTO10.BAS: GOTO 10", &[10]),
            ("INTSETUP(1000,3,1)", &[1000]),
            ("INTSETUP(L%,3,1)", &[]),
            ("REM GOTO 10", &[]),
            ("DATA GOTO 10: GOTO 20", &[20]),
            ("PRINT \"GOTO 10\"", &[]),
            ("A=GOTO 70000", &[]),
            ("X = = 5: GOTO 9", &[9]),
        ] {
            let found: Vec<u16> = jumps(text.as_bytes())
                .iter()
                .map(|jump| jump.line.number)
                .collect();
            assert_eq!(found, expected, "{text}");
        }
    }
}
