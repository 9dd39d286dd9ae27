//! The parts of a line: words, numbers, marks. A blank ends a command, so what stands together is for the parser to see
//! by the places of the parts.

use super::ast::Operator;
use crate::language::{Cursor, Span};

/// A part of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

/// What a part of a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TokenKind {
    /// Begins with a capital or `@`: `GOTO5`, `RUN?`, `UAI`, `@PE`, `Rab`.
    Word,
    /// Lower-case letters: a variable or an array.
    Name,
    /// Digits.
    Number(i64),
    /// `+` to `|`, comparisons.
    Operator(Operator),
    /// `=`
    Assign,
    /// `(`
    Open,
    /// `)`
    Close,
    /// `[`
    OpenBracket,
    /// `]`
    CloseBracket,
    /// `,`
    Comma,
    /// `#`
    Hash,
    /// `.`
    Period,
    /// `!`
    Bang,
    /// A text with its quotes; `false` if the second is missing.
    Text(bool),
    /// From `'` to the end of the line.
    Comment,
    /// A character that means nothing.
    Bad,
}

/// Blanks between commands.
pub fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n')
}

/// The parts of a line.
pub fn tokens(line: &[u8]) -> Vec<Token> {
    let mut cursor = Cursor::new(line, 0);
    let mut tokens = Vec::new();
    loop {
        cursor.take_while(is_blank);
        let start = cursor.position();
        let Some(byte) = cursor.bump() else {
            return tokens;
        };
        let kind = kind(byte, &mut cursor);
        let span = Span::new(start, cursor.position());
        tokens.push(Token { kind, span });
    }
}

fn kind(first: u8, cursor: &mut Cursor<'_>) -> TokenKind {
    match first {
        b'A'..=b'Z' | b'@' => {
            cursor.take_while(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'@'));
            cursor.eat(b'?');
            TokenKind::Word
        }
        b'a'..=b'z' => {
            cursor.take_while(|byte| byte.is_ascii_lowercase());
            TokenKind::Name
        }
        b'0'..=b'9' => {
            let rest = cursor.take_while(|byte| byte.is_ascii_digit());
            TokenKind::Number(number(first, rest))
        }
        b'"' => {
            cursor.take_while(|byte| byte != b'"');
            TokenKind::Text(cursor.eat(b'"'))
        }
        b'\'' => {
            cursor.skip(usize::MAX - cursor.position());
            TokenKind::Comment
        }
        b'(' => TokenKind::Open,
        b')' => TokenKind::Close,
        b'[' => TokenKind::OpenBracket,
        b']' => TokenKind::CloseBracket,
        b',' => TokenKind::Comma,
        b'#' => TokenKind::Hash,
        b'.' => TokenKind::Period,
        b'=' if !cursor.eat(b'=') => TokenKind::Assign,
        b'!' if !cursor.eat(b'=') => TokenKind::Bang,
        _ => operator(first, cursor).map_or(TokenKind::Bad, TokenKind::Operator),
    }
}

fn operator(first: u8, cursor: &mut Cursor<'_>) -> Option<Operator> {
    Some(match first {
        b'+' => Operator::Add,
        b'-' => Operator::Subtract,
        b'*' => Operator::Multiply,
        b'/' => Operator::Divide,
        b'&' => Operator::And,
        b'|' => Operator::Or,
        b'=' => Operator::Equal,
        b'!' => Operator::NotEqual,
        b'<' if cursor.eat(b'=') => Operator::LessEqual,
        b'<' => Operator::Less,
        b'>' if cursor.eat(b'=') => Operator::GreaterEqual,
        b'>' => Operator::Greater,
        _ => return None,
    })
}

fn number(first: u8, rest: &[u8]) -> i64 {
    let digits = std::iter::once(&first).chain(rest);
    digits.fold(0, |value: i64, digit| {
        let digit = i64::from(digit.wrapping_sub(b'0'));
        value.saturating_mul(10).saturating_add(digit)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(line: &str) -> Vec<TokenKind> {
        tokens(line.as_bytes()).iter().map(|t| t.kind).collect()
    }

    #[test]
    fn words_keep_their_digits_and_names_do_not_mix() {
        use TokenKind::*;
        assert_eq!(kinds("GOTO5 RUN? @PE ECHO_OFF"), [Word; 4]);
        assert_eq!(
            kinds("a=b+12"),
            [
                Name,
                Assign,
                Name,
                Operator(super::Operator::Add),
                Number(12)
            ]
        );
        assert_eq!(
            kinds("PRINT(\"a b\",#13) 'x y"),
            [
                Word,
                Open,
                Text(true),
                Comma,
                Hash,
                Number(13),
                Close,
                Comment
            ]
        );
        assert_eq!(kinds("\"open"), [Text(false)]);
        assert_eq!(kinds("!"), [Bang]);
        assert_eq!(kinds("99999999999999999999"), [Number(i64::MAX)]);
    }

    #[test]
    fn comparisons_are_told_from_assignment() {
        use TokenKind::{Assign, Operator as Op};
        assert_eq!(
            kinds("== != <= >= < > ="),
            [
                Op(Operator::Equal),
                Op(Operator::NotEqual),
                Op(Operator::LessEqual),
                Op(Operator::GreaterEqual),
                Op(Operator::Less),
                Op(Operator::Greater),
                Assign
            ]
        );
    }
}
