//! Bytes of a line to tokens. Lexing never fails: what cannot be read is a [`TokenKind::Bad`] token.
//!
//! Source: "Basic programming rules", "Programming numbers and variables". As in Commodore BASIC a keyword may be glued
//! to what follows it (`FORI=1TO10`); unlike there, a name with a keyword inside it is an error, as the manual says.

use super::ast::VariableKind;
use super::firmware::{ErrorCode, LARGEST, LAST_LINE, NAME_LENGTH, SMALLEST};
use super::keywords::{Keyword, longest_at};
use super::sysvars::SysVar;
use crate::language::{Cursor, Span};
use crate::number::{self, Constant};

/// One token with its place in the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Token {
    /// Bytes of the line, the line number counted.
    pub span: Span,
    /// What it is.
    pub kind: TokenKind,
}

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TokenKind {
    /// A word or an operator of the language, or a system variable.
    Keyword(Keyword),
    /// Digits within 32 bits, or `&H` with up to eight hexadecimal digits as a 32-bit pattern.
    Integer(i32),
    /// Any other number within the limits.
    Real(f64),
    /// A string constant with its quotes; the closing one may be missing at the end of the line.
    Text,
    /// A variable's name, its `%` or `$` included.
    Name(VariableKind),
    /// `(`
    ParenOpen,
    /// `)`
    ParenClose,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
    /// `#`
    Hash,
    /// What follows REM to the end of the line.
    Remark,
    /// What follows DATA to the end of the statement.
    Data,
    /// What the device cannot read.
    Bad(Bad),
}

/// Why a token cannot be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bad {
    /// A name with this keyword inside it.
    NameWithKeyword(Keyword),
    /// A name of more than 20 letters and digits.
    LongName,
    /// A name with an underscore that is no system variable.
    UnknownVariable,
    /// A number beyond 1.70141183E+38, or more than eight hexadecimal digits.
    Overflow,
    /// `&` without `H` and digits.
    Hexadecimal,
    /// A byte that means nothing outside a string.
    Byte(u8),
    /// A keyword that this card was put on the bench without; the parser marks it.
    Lacking(Keyword),
}

impl Bad {
    /// What the device says to it.
    pub fn error(self) -> ErrorCode {
        match self {
            Bad::Overflow => ErrorCode::Overflow,
            Bad::Lacking(_) => ErrorCode::NotImplemented,
            _ => ErrorCode::Syntax,
        }
    }

    /// Why, in a plain sentence; `written` is the token's text.
    pub fn cause(self, written: &str) -> String {
        match self {
            Bad::NameWithKeyword(keyword) => format!(
                "The name {written} has the keyword {} in it; a name must not.",
                keyword.word()
            ),
            Bad::LongName => {
                format!("The name {written} is longer than {NAME_LENGTH} characters.")
            }
            Bad::UnknownVariable => format!(
                "There is no system variable {written}, and other names have letters and digits only."
            ),
            Bad::Overflow => {
                format!("The number {written} is too large: 1.70141183E+38 is the limit.")
            }
            Bad::Hexadecimal => {
                "`&` begins a hexadecimal number, which goes on with H and digits.".into()
            }
            Bad::Lacking(keyword) => format!("This card has no {}.", keyword.word()),
            Bad::Byte(byte @ 0x20..=0x7e) => {
                format!("`{}` means nothing outside a string.", char::from(byte))
            }
            Bad::Byte(byte) => {
                format!("The character with code {byte} means nothing outside a string.")
            }
        }
    }
}

/// The number in front of a line and where the text behind it begins: `Ok(None)` without one.
///
/// # Errors
/// SYNTAX for a number above 63999.
pub fn line_number(line: &[u8]) -> (Result<Option<u16>, ErrorCode>, usize) {
    let mut cursor = Cursor::new(line, 0);
    cursor.take_while(is_blank);
    let digits = cursor.take_while(|byte| byte.is_ascii_digit());
    if digits.is_empty() {
        return (Ok(None), cursor.position());
    }
    let number = read_line_number(digits).ok_or(ErrorCode::Syntax);
    (number.map(Some), cursor.position())
}

/// Digits as a line number; `None` above 63999 or if there is anything else.
pub fn read_line_number(digits: &[u8]) -> Option<u16> {
    let digits = std::str::from_utf8(digits).ok()?;
    let number = digits.parse().ok()?;
    (number <= LAST_LINE && digits.starts_with(|c: char| c.is_ascii_digit())).then_some(number)
}

/// Blanks separate and mean nothing else.
pub fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t')
}

/// The tokens of `line` from byte `start` on.
pub fn tokens(line: &[u8], start: usize) -> Vec<Token> {
    let mut lexer = Lexer {
        line,
        cursor: Cursor::new(line, start),
        tokens: Vec::new(),
    };
    lexer.run();
    lexer.tokens
}

struct Lexer<'a> {
    line: &'a [u8],
    cursor: Cursor<'a>,
    tokens: Vec<Token>,
}

impl Lexer<'_> {
    fn run(&mut self) {
        loop {
            self.cursor.take_while(is_blank);
            let start = self.cursor.position();
            let Some(byte) = self.cursor.peek() else {
                return;
            };
            let kind = self.token(byte);
            self.push(start, kind);
            match kind {
                TokenKind::Keyword(Keyword::Rem) => self.remark(),
                TokenKind::Keyword(Keyword::Data) => self.data(),
                _ => {}
            }
        }
    }

    fn push(&mut self, start: usize, kind: TokenKind) {
        let span = Span::new(start, self.cursor.position());
        self.tokens.push(Token { span, kind });
    }

    /// Takes one token, of at least one byte.
    fn token(&mut self, byte: u8) -> TokenKind {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' => self.word(),
            b'0'..=b'9' | b'.' => self.number(),
            b'"' => self.text(),
            b'&' => self.hexadecimal(),
            b'<' | b'=' | b'>' => TokenKind::Keyword(self.relation()),
            b'{' => self.brace(),
            _ => {
                self.cursor.skip(1);
                mark(byte)
            }
        }
    }

    /// A system variable, a keyword with whatever is glued to it left, or a name.
    fn word(&mut self) -> TokenKind {
        let rest = self.cursor.rest();
        if let Some((variable, length)) = system_variable(rest) {
            self.cursor.skip(length);
            return TokenKind::Keyword(Keyword::System(variable));
        }
        if let Some((keyword, length)) = keyword_at(rest) {
            self.cursor.skip(length);
            return TokenKind::Keyword(keyword);
        }
        let name = self
            .cursor
            .take_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        let kind = match self.cursor.peek() {
            Some(b'%') => VariableKind::Integer,
            Some(b'$') => VariableKind::String,
            _ => VariableKind::Real,
        };
        if kind != VariableKind::Real {
            self.cursor.skip(1);
        }
        match bad_name(name, rest) {
            Some(bad) => TokenKind::Bad(bad),
            None => TokenKind::Name(kind),
        }
    }

    fn number(&mut self) -> TokenKind {
        let Some((value, length)) = number::unsigned(self.cursor.rest(), false) else {
            // Unreached: a digit or a point always gives a number.
            self.cursor.skip(1);
            return TokenKind::Integer(0);
        };
        self.cursor.skip(length);
        match value {
            Constant::Integer(value) => TokenKind::Integer(value),
            Constant::Real(value) if value > LARGEST => TokenKind::Bad(Bad::Overflow),
            Constant::Real(value) if value < SMALLEST => TokenKind::Real(0.0),
            Constant::Real(value) => TokenKind::Real(value),
        }
    }

    fn hexadecimal(&mut self) -> TokenKind {
        self.cursor.skip(1);
        if !(self.cursor.eat(b'H') || self.cursor.eat(b'h')) {
            return TokenKind::Bad(Bad::Hexadecimal);
        }
        let digits = self.cursor.take_while(|byte| byte.is_ascii_hexdigit());
        if digits.is_empty() {
            return TokenKind::Bad(Bad::Hexadecimal);
        }
        let pattern = std::str::from_utf8(digits)
            .ok()
            .and_then(|digits| u32::from_str_radix(digits, 16).ok());
        pattern.map_or(TokenKind::Bad(Bad::Overflow), |bits| {
            TokenKind::Integer(bits.cast_signed())
        })
    }

    fn text(&mut self) -> TokenKind {
        self.cursor.skip(1);
        self.cursor.take_while(|byte| byte != b'"');
        self.cursor.eat(b'"');
        TokenKind::Text
    }

    /// One or two of `< = >`, blanks between them allowed; two may stand in either order.
    fn relation(&mut self) -> Keyword {
        let first = self.cursor.bump();
        let mut behind = self.cursor;
        behind.take_while(is_blank);
        let both = match (first, behind.bump()) {
            (Some(b'<'), Some(b'=')) | (Some(b'='), Some(b'<')) => Keyword::LessEqual,
            (Some(b'>'), Some(b'=')) | (Some(b'='), Some(b'>')) => Keyword::GreaterEqual,
            (Some(b'<'), Some(b'>')) | (Some(b'>'), Some(b'<')) => Keyword::NotEqual,
            (Some(b'<'), _) => return Keyword::Less,
            (Some(b'>'), _) => return Keyword::Greater,
            _ => return Keyword::Equal,
        };
        self.cursor = behind;
        both
    }

    fn brace(&mut self) -> TokenKind {
        let word = b"{pi}";
        let found = self
            .cursor
            .rest()
            .get(..word.len())
            .is_some_and(|start| start.eq_ignore_ascii_case(word));
        self.cursor.skip(if found { word.len() } else { 1 });
        if found {
            TokenKind::Keyword(Keyword::Pi)
        } else {
            TokenKind::Bad(Bad::Byte(b'{'))
        }
    }

    fn remark(&mut self) {
        let start = self.cursor.position();
        self.cursor.skip(self.line.len());
        if self.cursor.position() > start {
            self.push(start, TokenKind::Remark);
        }
    }

    /// DATA takes everything up to a colon that does not stand in quotes.
    fn data(&mut self) {
        let start = self.cursor.position();
        let mut quoted = false;
        self.cursor.take_while(|byte| {
            quoted ^= byte == b'"';
            quoted || byte != b':'
        });
        if self.cursor.position() > start {
            self.push(start, TokenKind::Data);
        }
    }
}

/// Marks of one byte.
fn mark(byte: u8) -> TokenKind {
    match byte {
        b'(' => TokenKind::ParenOpen,
        b')' => TokenKind::ParenClose,
        b',' => TokenKind::Comma,
        b';' => TokenKind::Semicolon,
        b':' => TokenKind::Colon,
        b'#' => TokenKind::Hash,
        b'+' => TokenKind::Keyword(Keyword::Plus),
        b'-' => TokenKind::Keyword(Keyword::Minus),
        b'*' => TokenKind::Keyword(Keyword::Multiply),
        b'/' => TokenKind::Keyword(Keyword::Divide),
        b'^' => TokenKind::Keyword(Keyword::Power),
        b'?' => TokenKind::Keyword(Keyword::QuestionMark),
        other => TokenKind::Bad(Bad::Byte(other)),
    }
}

/// A system variable at the start of `text`, its `%` included.
fn system_variable(text: &[u8]) -> Option<(SysVar, usize)> {
    let mut cursor = Cursor::new(text, 0);
    cursor.take_while(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    if !cursor.eat(b'%') {
        return None;
    }
    let length = cursor.position();
    let word = std::str::from_utf8(text.get(..length)?).ok()?;
    Some((SysVar::from_word(word)?, length))
}

/// The longest keyword of letters at the start of `text`, and its length.
fn keyword_at(text: &[u8]) -> Option<(Keyword, usize)> {
    if let Some(length) = go_to(text) {
        return Some((Keyword::GoTo, length));
    }
    longest_at(text).filter(|&(keyword, length)| {
        let needs_parenthesis = matches!(keyword, Keyword::Tab | Keyword::Spc);
        !needs_parenthesis || opens_parenthesis(text, length)
    })
}

fn opens_parenthesis(text: &[u8], position: usize) -> bool {
    let mut cursor = Cursor::new(text, position);
    cursor.take_while(is_blank);
    cursor.peek() == Some(b'(')
}

/// The length of `GO TO` with blanks between at the start of `text`.
fn go_to(text: &[u8]) -> Option<usize> {
    let mut cursor = Cursor::new(text, 0);
    let go =
        cursor.bump()?.eq_ignore_ascii_case(&b'G') && cursor.bump()?.eq_ignore_ascii_case(&b'O');
    let blanks = cursor.take_while(is_blank).len();
    let to = cursor.rest().get(..2)?.eq_ignore_ascii_case(b"TO");
    (go && blanks > 0 && to).then_some(cursor.position() + 2)
}

/// What is wrong with a name that does not begin with a keyword; `rest` is the line from its start.
fn bad_name(name: &[u8], rest: &[u8]) -> Option<Bad> {
    if name.contains(&b'_') {
        return Some(Bad::UnknownVariable);
    }
    let inside = (1..name.len()).find_map(|start| {
        let (keyword, _) = keyword_at(rest.get(start..)?)?;
        (!may_stand_inside(keyword, name, start)).then_some(keyword)
    });
    if let Some(keyword) = inside {
        return Some(Bad::NameWithKeyword(keyword));
    }
    (name.len() > NAME_LENGTH).then_some(Bad::LongName)
}

/// The manual itself has names with these words inside them: those that the device does not implement, and the AND of
/// HANDLE. `GO` at a name's end, with TO behind a blank, is no keyword either.
fn may_stand_inside(keyword: Keyword, name: &[u8], start: usize) -> bool {
    match keyword {
        Keyword::Fclose | Keyword::Get | Keyword::Gotoxy | Keyword::Open | Keyword::GoTo => true,
        Keyword::And => name
            .get(start.wrapping_sub(1)..start + 5)
            .is_some_and(|around| around.eq_ignore_ascii_case(b"HANDLE")),
        _ => false,
    }
}
