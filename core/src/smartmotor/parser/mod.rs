//! Text becomes commands. Parsing never fails: what cannot be understood becomes [`StatementKind::Malformed`].
//!
//! A blank ends a command as soon as what stands before it is complete (D131), in a program as on the line.

mod expressions;
#[cfg(test)]
mod tests;
mod words;

use super::ast::{Array, Malformed, Place, Statement, StatementKind, Target};
use super::keywords;
use super::lexer::{Token, TokenKind, tokens};
use super::motor::{Command, Register};
use crate::language::{Cure, Span};

/// A line's commands.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Parsed {
    /// In order.
    pub statements: Vec<Statement>,
    /// The words of the keyword table that they use.
    pub used: Vec<&'static str>,
    /// A comment ends the line.
    pub comment: bool,
}

/// Reads a line. A motor may lack a word of the keyword table, for lessons and for the tests of the words.
pub fn parse_line(line: &[u8], without: Option<&str>) -> Parsed {
    let mut parser = Parser {
        line,
        tokens: tokens(line),
        at: 0,
        without,
        used: Vec::new(),
    };
    let mut statements = Vec::new();
    let mut comment = false;
    while let Some(token) = parser.peek() {
        if token.kind == TokenKind::Comment {
            comment = true;
            break;
        }
        statements.push(parser.statement(token));
    }
    Parsed {
        statements,
        used: parser.used,
        comment,
    }
}

type Parse<T> = Result<T, Malformed>;

struct Parser<'a> {
    line: &'a [u8],
    tokens: Vec<Token>,
    /// The next token.
    at: usize,
    without: Option<&'a str>,
    used: Vec<&'static str>,
}

impl Parser<'_> {
    fn peek(&self) -> Option<Token> {
        self.tokens.get(self.at).copied()
    }

    fn next(&mut self) -> Option<Token> {
        let token = self.peek()?;
        self.at += 1;
        Some(token)
    }

    /// Whether the next token stands right behind the last.
    fn is_glued(&self) -> bool {
        let last = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        let next = self.peek();
        matches!((last, next), (Some(last), Some(next)) if last.span.end == next.span.start)
    }

    /// The next token if it stands right behind the last.
    fn glued(&self) -> Option<TokenKind> {
        self.peek()
            .filter(|_| self.is_glued())
            .map(|token| token.kind)
    }

    fn eat(&mut self, kind: TokenKind) -> bool {
        let found = self.peek().is_some_and(|token| token.kind == kind);
        self.at += usize::from(found);
        found
    }

    fn need(&mut self, kind: TokenKind, what: &str) -> Parse<()> {
        match self.eat(kind) {
            true => Ok(()),
            false => Err(self.expected(what)),
        }
    }

    fn text(&self, span: Span) -> &[u8] {
        span.of(self.line)
    }

    /// The words are ASCII; anything else is no word.
    fn word_text(&self, span: Span) -> &str {
        std::str::from_utf8(self.text(span)).unwrap_or_default()
    }

    /// Notes a word of the table that the line uses.
    fn note(&mut self, word: &str, span: Span) -> Parse<()> {
        let known = keywords::find(word).or_else(|| keywords::find(&format!("{word}=")));
        let Some(known) = known else { return Ok(()) };
        self.used.push(known);
        match self.without == Some(known) {
            true => Err(error(span, format!("This motor does not know {word}."))),
            false => Ok(()),
        }
    }

    /// Where the line ends, or the next token.
    fn expected(&self, what: &str) -> Malformed {
        match self.peek() {
            Some(token) if token.kind != TokenKind::Comment => {
                error(token.span, format!("Here {what} must stand."))
            }
            _ => {
                let end = self
                    .at
                    .checked_sub(1)
                    .and_then(|at| self.tokens.get(at))
                    .map_or(0, |token| token.span.end);
                let span = Span { start: end, end };
                Malformed {
                    unfinished: self.peek().is_none(),
                    ..error(span, format!("Behind this {what} must stand."))
                }
            }
        }
    }

    fn statement(&mut self, first: Token) -> Statement {
        let start = self.at;
        let kind = self.command().and_then(|kind| match self.is_glued() {
            true if self.peek().map(|token| token.kind) == Some(TokenKind::Comment) => Ok(kind),
            true => Err(self.too_much()),
            false => Ok(kind),
        });
        let kind = kind.unwrap_or_else(|malformed| {
            self.skip(start);
            StatementKind::Malformed(malformed)
        });
        let last = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        let span = first.span.to(last.map_or(first.span, |token| token.span));
        Statement { kind, span }
    }

    /// Behind what is malformed the next blank begins something new.
    fn skip(&mut self, start: usize) {
        self.at = self.at.max(start + 1);
        let first = self.tokens.get(start).map(|token| token.kind);
        if matches!(first, Some(TokenKind::Operator(_) | TokenKind::Assign)) {
            // The operand belongs to it.
            self.at = self.at.max((start + 2).min(self.tokens.len()));
        }
        while self.glued().is_some_and(|kind| kind != TokenKind::Comment) {
            self.at += 1;
        }
    }

    /// Something stands right behind a complete command.
    fn too_much(&self) -> Malformed {
        let Some(token) = self.peek() else {
            return self.expected("a command");
        };
        if matches!(token.kind, TokenKind::Operator(_)) {
            let cause = "An expression has at most one operator.";
            return error(token.span, cause.to_owned());
        }
        let place = Span {
            start: token.span.start,
            end: token.span.start,
        };
        let cure = Cure {
            label: "Put a blank between them".to_owned(),
            span: place,
            replacement: " ".to_owned(),
        };
        Malformed {
            cure: Some(cure),
            ..error(token.span, "A command ends with a blank.".to_owned())
        }
    }

    fn command(&mut self) -> Parse<StatementKind> {
        let Some(token) = self.next() else {
            return Err(self.expected("a command"));
        };
        match token.kind {
            TokenKind::Word => self.word(token),
            TokenKind::Name => self.variable(token),
            TokenKind::Bang => {
                self.note("!", token.span)?;
                Ok(StatementKind::Line(super::ast::LineCommand::Pause))
            }
            TokenKind::Operator(_) | TokenKind::Assign => Err(self.blank_before(token)),
            _ => Err(error(token.span, "No command begins like this.".to_owned())),
        }
    }

    /// An operator where a command should begin: the expression before it has ended with the blank.
    fn blank_before(&self, token: Token) -> Malformed {
        let before = self.at.checked_sub(2).and_then(|at| self.tokens.get(at));
        let cure = before.map(|before| Cure {
            label: "Remove the blank".to_owned(),
            span: Span {
                start: before.span.end,
                end: token.span.start,
            },
            replacement: String::new(),
        });
        Malformed {
            cure,
            ..error(
                token.span,
                "An expression ends with a blank: write it without.".to_owned(),
            )
        }
    }

    /// A variable or an element in front: it is set.
    fn variable(&mut self, token: Token) -> Parse<StatementKind> {
        let place = self.place(token)?;
        if let Place::Element(array, index) = place
            && self.constant_follows()
        {
            return self.fill(array, index);
        }
        self.assign(Target::Place(place))
    }

    /// `=` and an expression, or a blank and a number.
    fn assign(&mut self, target: Target) -> Parse<StatementKind> {
        if self.constant_follows() && !self.is_glued() {
            let operand = self.operand()?;
            return Ok(StatementKind::Assign(target, operand.into()));
        }
        self.need(TokenKind::Assign, "= and a value")?;
        Ok(StatementKind::Assign(target, self.expression()?))
    }

    /// Whether a number comes next, with or without a sign.
    fn constant_follows(&self) -> bool {
        let kind = |ahead: usize| self.tokens.get(self.at + ahead).map(|token| token.kind);
        let is_number = |kind| matches!(kind, Some(TokenKind::Number(_)));
        let minus = Some(TokenKind::Operator(super::ast::Operator::Subtract));
        is_number(kind(0)) || (kind(0) == minus && is_number(kind(1)))
    }

    /// `aw[t] 63 44 98.`: numbers with blanks between them, and a period behind the last.
    fn fill(&mut self, array: Array, index: super::ast::Index) -> Parse<StatementKind> {
        let mut values = Vec::new();
        while self.constant_follows() {
            values.push(self.constant()?);
            if self.glued() == Some(TokenKind::Period) {
                self.at += 1;
                return Ok(StatementKind::Fill {
                    array,
                    index,
                    values,
                });
            }
        }
        Err(self.expected("a number, or a period behind the last number"))
    }

    /// The register that a word before `=` sets, if it is not a command on its own, or is followed by `=`.
    fn register_target(&self, word: &str) -> Option<Register> {
        let register = Register::writable(word)?;
        let assigned = self.peek().map(|token| token.kind) == Some(TokenKind::Assign);
        (Command::from_word(word).is_none() || (assigned && self.is_glued())).then_some(register)
    }
}

fn error(span: Span, cause: String) -> Malformed {
    Malformed {
        span,
        cause,
        cure: None,
        unfinished: false,
    }
}
