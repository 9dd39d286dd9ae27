//! Values: operands, variables, elements, and at most one operator.

use super::super::ast::{Array, Expr, Index, LineFlag, Operand, Operator, Place, Source, variable};
use super::super::lexer::{Token, TokenKind};
use super::super::motor::{Flag, Register};
use super::{Parse, Parser, error};
use crate::language::Span;

impl From<Operand> for Expr {
    fn from(left: Operand) -> Expr {
        Expr { left, rest: None }
    }
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Parse<Expr> {
        if let Some(token) = self.negated_place() {
            // A sign before anything but a number is the one operator (D146).
            self.note("-", token.span)?;
            let rest = Some((Operator::Subtract, self.operand()?));
            let left = Operand::Number(0);
            return Ok(Expr { left, rest });
        }
        let left = self.operand()?;
        let Some(TokenKind::Operator(operator)) = self.glued() else {
            return Ok(left.into());
        };
        let span = self.next().map(|token| token.span).unwrap_or_default();
        self.note(operator.word(), span)?;
        let right = self.operand()?;
        Ok(Expr {
            left,
            rest: Some((operator, right)),
        })
    }

    /// Takes a minus sign that stands before something else than a number.
    fn negated_place(&mut self) -> Option<Token> {
        let minus = self.peek()?;
        let is_minus = minus.kind == TokenKind::Operator(Operator::Subtract);
        if !is_minus || self.constant_follows() {
            return None;
        }
        self.next()
    }

    pub(super) fn operand(&mut self) -> Parse<Operand> {
        if self.constant_follows() {
            return self.constant().map(Operand::Number);
        }
        match self.peek() {
            Some(token) if token.kind == TokenKind::Name => {
                self.at += 1;
                self.place(token).map(Operand::Place)
            }
            Some(token) if token.kind == TokenKind::Word => {
                self.at += 1;
                let word = self.word_text(token.span).to_owned();
                let Some(source) = source(&word) else {
                    let cause = format!("{word} has no value.");
                    return Err(error(token.span, cause));
                };
                self.note(row_of(source, &word), token.span)?;
                Ok(Operand::Source(source))
            }
            _ => Err(self.expected("a number, a variable or a value of the motor")),
        }
    }

    /// A number with or without a minus sign.
    pub(super) fn constant(&mut self) -> Parse<i32> {
        let minus = self.eat(TokenKind::Operator(Operator::Subtract));
        if minus && !self.is_glued() {
            return Err(self.expected("a number without a blank"));
        }
        match self.next() {
            Some(Token {
                kind: TokenKind::Number(digits),
                span,
            }) => {
                let value = if minus { -digits } else { digits };
                i32::try_from(value)
                    .map_err(|_| error(span, "A number has at most 32 bits.".to_owned()))
            }
            _ => Err(self.expected("a number")),
        }
    }

    /// A variable, or an array and its index.
    pub(super) fn place(&mut self, name: Token) -> Parse<Place> {
        let text = self.text(name.span).to_vec();
        if let Some(array) = array(&text) {
            self.note(array_word(array), name.span)?;
            let index = self.index()?;
            return Ok(Place::Element(array, index));
        }
        let Some(number) = variable(&text) else {
            return Err(unknown_name(name.span));
        };
        let rows = ["a..z", "aa..zz", "aaa..zzz"];
        let row = rows.get(usize::from(number / 26)).copied();
        self.note(row.unwrap_or_default(), name.span)?;
        Ok(Place::Variable(number))
    }

    /// `[3]`, `[a]`, `[a+b]`, `[a-b]`
    pub(super) fn index(&mut self) -> Parse<Index> {
        self.need(TokenKind::OpenBracket, "an index in brackets")?;
        let index = if let Some(TokenKind::Number(digits)) = self.peek().map(|token| token.kind) {
            self.at += 1;
            Index::Number(i32::try_from(digits).unwrap_or(i32::MAX))
        } else {
            let first = self.index_variable()?;
            match self.peek().map(|token| token.kind) {
                Some(TokenKind::Operator(Operator::Add)) => {
                    self.at += 1;
                    Index::Sum(first, self.index_variable()?)
                }
                Some(TokenKind::Operator(Operator::Subtract)) => {
                    self.at += 1;
                    Index::Difference(first, self.index_variable()?)
                }
                _ => Index::Variable(first),
            }
        };
        self.need(TokenKind::CloseBracket, "the closing bracket")?;
        Ok(index)
    }

    fn index_variable(&mut self) -> Parse<u16> {
        let what = "a number, a variable a to z, or the sum or difference of two of them";
        match self.peek() {
            Some(token) if token.kind == TokenKind::Name => {
                self.at += 1;
                variable(self.text(token.span))
                    .filter(|&number| number < 26)
                    .ok_or_else(|| error(token.span, format!("An index is {what}.")))
            }
            _ => Err(self.expected(what)),
        }
    }
}

pub(super) fn unknown_name(span: Span) -> super::Malformed {
    let cause = "Variables are a to z, aa to zz, aaa to zzz, and the arrays ab, aw, al.";
    error(span, cause.to_owned())
}

pub(super) fn array(name: &[u8]) -> Option<Array> {
    match name {
        b"ab" => Some(Array::Bytes),
        b"aw" => Some(Array::Words),
        b"al" => Some(Array::Longs),
        _ => None,
    }
}

pub(super) fn array_word(array: Array) -> &'static str {
    match array {
        Array::Bytes => "ab[]",
        Array::Words => "aw[]",
        Array::Longs => "al[]",
    }
}

/// What a word of capitals stands for in an expression.
pub(super) fn source(word: &str) -> Option<Source> {
    let own = match word {
        "EPTR" => Some(Source::EepromPointer),
        "ADDR" => Some(Source::Address),
        "LEN" => Some(Source::Length),
        "GETCHR" => Some(Source::Character),
        _ => None,
    };
    own.or_else(|| flag(word))
        .or_else(|| Register::readable(word).map(Source::Register))
        .or_else(|| module_input(word))
}

/// `Bt` and so on.
fn flag(word: &str) -> Option<Source> {
    let &[b'B', letter] = word.as_bytes() else {
        return None;
    };
    line_flag(letter)
        .map(Source::LineFlag)
        .or_else(|| Flag::from_letter(letter).map(Source::Flag))
}

/// Bits of the serial line, by the letter of `Bb` or `Zb`.
pub(super) fn line_flag(letter: u8) -> Option<LineFlag> {
    match letter {
        b'b' => Some(LineFlag::Parity),
        b'c' => Some(LineFlag::Overflow),
        b'f' => Some(LineFlag::Framing),
        _ => None,
    }
}

/// `DINA0`, `AINB3`: module A to H, and its input.
fn module_input(word: &str) -> Option<Source> {
    let rest = word
        .strip_prefix("DIN")
        .or_else(|| word.strip_prefix("AIN"))?;
    is_module(rest).then_some(Source::ModuleInput)
}

/// A module's letter and up to two digits.
pub(super) fn is_module(text: &str) -> bool {
    match text.as_bytes() {
        [b'A'..=b'H', digits @ ..] => digits.len() <= 2 && digits.iter().all(u8::is_ascii_digit),
        _ => false,
    }
}

/// The row of the keyword table for a value that is read as `word`.
pub(super) fn row_of(source: Source, word: &str) -> &str {
    match source {
        Source::ModuleInput if word.starts_with('D') => "DIN#",
        Source::ModuleInput => "AIN#",
        _ => word,
    }
}
