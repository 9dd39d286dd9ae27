//! Tokens of a line to its statements. Parsing never fails: what cannot be understood becomes a statement that raises
//! its error when it is reached. Types are the compiler's affair.

mod expressions;
mod files;
mod statements;
#[cfg(test)]
mod tests;

use super::ast::{Malformed, Statement, StatementKind};
use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::lexer::{Bad, Token, TokenKind, line_number, tokens};
use super::program::STORED_LENGTH;
use crate::language::{Cure, Cursor, Span, latin1};

/// What a line says.
#[derive(Debug, Clone, PartialEq)]
pub struct ParsedLine {
    /// The number in front: `Ok(None)` for a direct line, SYNTAX for a number above 63999.
    pub number: Result<Option<u16>, ErrorCode>,
    /// Where the text behind the number begins.
    pub body: usize,
    /// The statements behind the number.
    pub statements: Vec<Statement>,
}

/// Parses a line as typed or as listed. Spans count from its first byte.
pub fn parse_line(line: &[u8]) -> ParsedLine {
    let (number, body) = line_number(line);
    ParsedLine {
        number,
        body,
        statements: parse(line, body, None),
    }
}

/// Parses the text behind a line number, for a card that lacks the keyword `without`. Spans count from its first byte.
pub fn parse_statements(text: &[u8], without: Option<Keyword>) -> Vec<Statement> {
    parse(text, 0, without)
}

/// A line of more than 255 bytes, which the device cannot hold, is one malformed statement; so everything below works
/// on little text and nests no deeper than that allows.
fn parse(line: &[u8], start: usize, without: Option<Keyword>) -> Vec<Statement> {
    if line.len() > STORED_LENGTH {
        let cause = format!("The line has more than {STORED_LENGTH} characters.");
        let span = Span::new(start, line.len());
        return vec![Fault::syntax(span, cause).statement(span)];
    }
    let mut tokens = tokens(line, start);
    if let Some(keyword) = without {
        let lacking = |token: &&mut Token| token.kind == TokenKind::Keyword(keyword);
        let bad = TokenKind::Bad(Bad::Lacking(keyword));
        tokens
            .iter_mut()
            .filter(lacking)
            .for_each(|token| token.kind = bad);
    }
    let mut parser = Parser {
        line,
        tokens,
        next: 0,
        parentheses: 0,
        prefixes: 0,
        branches: 0,
    };
    parser.statements()
}

/// Why a statement cannot be taken.
enum Fault {
    Malformed(Malformed),
    NotImplemented(Keyword),
}

type Parsed<T> = Result<T, Fault>;

impl Fault {
    fn new(error: ErrorCode, span: Span, cause: String) -> Fault {
        Fault::Malformed(Malformed {
            error,
            span,
            cause,
            cure: None,
        })
    }

    fn syntax(span: Span, cause: impl Into<String>) -> Fault {
        Fault::new(ErrorCode::Syntax, span, cause.into())
    }

    fn with_cure(mut self, label: &str, span: Span, replacement: &str) -> Fault {
        if let Fault::Malformed(malformed) = &mut self {
            malformed.cure = Some(Cure {
                label: label.into(),
                span,
                replacement: replacement.into(),
            });
        }
        self
    }

    fn statement(self, span: Span) -> Statement {
        let kind = match self {
            Fault::Malformed(malformed) => StatementKind::Malformed(malformed),
            Fault::NotImplemented(keyword) => StatementKind::NotImplemented(keyword),
        };
        Statement { span, kind }
    }
}

struct Parser<'a> {
    line: &'a [u8],
    tokens: Vec<Token>,
    /// Index of the next token.
    next: usize,
    /// Parentheses that are open.
    parentheses: usize,
    /// Prefix operators whose operand is being read.
    prefixes: usize,
    /// IFs whose ELSE may still come.
    branches: usize,
}

impl Parser<'_> {
    /// Statements up to the end of the line, or up to an ELSE that belongs to an IF around them.
    fn statements(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        loop {
            while self.eat(TokenKind::Colon) {}
            if self.at_end() {
                return statements;
            }
            statements.push(self.statement());
        }
    }

    fn statement(&mut self) -> Statement {
        self.checked(Self::statement_kind)
    }

    /// One statement, by its own function; it ends before a colon, an ELSE that ends it, or the end of the line.
    fn checked(&mut self, parse: impl FnOnce(&mut Self) -> Parsed<StatementKind>) -> Statement {
        let start = self.here();
        let result = parse(self).and_then(|kind| {
            if self.at_end() {
                Ok(kind)
            } else {
                Err(self.unexpected("A colon or the end of the line should stand here."))
            }
        });
        if result.is_err() {
            (self.parentheses, self.prefixes) = (0, 0);
            while !self.at_end() {
                self.next += 1;
            }
        }
        let span = start.to(self.behind());
        match result {
            Ok(kind) => Statement { span, kind },
            Err(Fault::Malformed(mut malformed)) => {
                malformed.cause += &self.name_like_keyword(malformed.span).unwrap_or_default();
                Fault::Malformed(malformed).statement(span)
            }
            Err(fault) => fault.statement(span),
        }
    }

    /// A hint where a keyword at `fault`, or just before it, goes on in letters: it was probably meant to be a name.
    fn name_like_keyword(&self, fault: Span) -> Option<String> {
        let at = self
            .tokens
            .partition_point(|token| token.span.start < fault.start);
        if matches!(self.tokens.get(at)?.kind, TokenKind::Bad(_)) {
            return None;
        }
        let is_word = |token: &&Token| {
            let letters = token
                .span
                .of(self.line)
                .first()
                .is_some_and(u8::is_ascii_alphabetic);
            let goes_on = self
                .line
                .get(token.span.range().end)
                .is_some_and(u8::is_ascii_alphabetic);
            matches!(token.kind, TokenKind::Keyword(_)) && letters && goes_on
        };
        let near = self.tokens.get(at.saturating_sub(1)..=at)?;
        let keyword = near.iter().find(is_word)?.span;
        let mut cursor = Cursor::new(self.line, keyword.range().end);
        let rest = latin1::text(cursor.take_while(|byte| byte.is_ascii_alphanumeric()));
        let word = self.written(keyword);
        Some(format!(
            " {word}{rest} is read as {word} {rest}: a name must not begin with a keyword."
        ))
    }

    fn peek(&self) -> Option<TokenKind> {
        self.tokens.get(self.next).map(|token| token.kind)
    }

    fn peek_keyword(&self) -> Option<Keyword> {
        match self.peek() {
            Some(TokenKind::Keyword(keyword)) => Some(keyword),
            _ => None,
        }
    }

    fn eat(&mut self, kind: TokenKind) -> bool {
        let found = self.peek() == Some(kind);
        if found {
            self.next += 1;
        }
        found
    }

    fn eat_keyword(&mut self, keyword: Keyword) -> bool {
        self.eat(TokenKind::Keyword(keyword))
    }

    /// Whether the statement is over.
    fn at_end(&self) -> bool {
        match self.peek() {
            None | Some(TokenKind::Colon) => true,
            Some(TokenKind::Keyword(Keyword::Else)) => self.branches > 0,
            _ => false,
        }
    }

    /// The place of the next token; empty behind the last one at the end of the line.
    fn here(&self) -> Span {
        let end = Span::new(self.line.len(), self.line.len());
        self.tokens.get(self.next).map_or(end, |token| token.span)
    }

    /// The place of the token taken last.
    fn behind(&self) -> Span {
        let last = self.next.checked_sub(1);
        let end = Span::new(self.line.len(), self.line.len());
        last.and_then(|last| self.tokens.get(last))
            .map_or(end, |token| token.span)
    }

    fn written(&self, span: Span) -> String {
        latin1::text(span.of(self.line))
    }

    /// The fault of the next token, which is not what was `expected` (a sentence).
    fn unexpected(&self, expected: &str) -> Fault {
        let span = self.here();
        match self.peek() {
            Some(TokenKind::Bad(Bad::Lacking(keyword))) => Fault::NotImplemented(keyword),
            Some(TokenKind::Bad(bad)) => {
                Fault::new(bad.error(), span, bad.cause(&self.written(span)))
            }
            Some(TokenKind::Keyword(keyword)) if keyword.is_absent() => {
                Fault::NotImplemented(keyword)
            }
            Some(TokenKind::Keyword(Keyword::Else)) => {
                Fault::syntax(span, "ELSE without an IF before it on the line.")
            }
            _ => Fault::syntax(span, expected),
        }
    }
}
