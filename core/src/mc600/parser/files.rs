//! What names files: the arguments of COPY, FILES, ERASE and FORMAT ("The BASIC Filesystem").

use super::expressions::is_function;
use super::{Parsed, Parser};
use crate::language::Span;
use crate::mc600::ast::{Expr, ExprKind, StatementKind, VariableKind};
use crate::mc600::lexer::{TokenKind, is_blank};

impl Parser<'_> {
    /// `from,to`
    pub(super) fn copy(&mut self) -> Parsed<StatementKind> {
        let from = self.expression()?;
        if !self.eat(TokenKind::Comma) {
            return Err(self.unexpected("A comma and the name of the copy should stand here."));
        }
        let to = self.expression()?;
        Ok(StatementKind::Copy { from, to })
    }

    /// A file mask where there must be one.
    pub(super) fn needed_mask(&mut self) -> Parsed<Expr> {
        match self.mask()? {
            Some(mask) => Ok(mask),
            None => Err(self.unexpected("The files or the disk should stand here.")),
        }
    }

    /// A file mask: a string expression, or bare as the manual's file system section writes it (`FILES *.TXT`). A bare
    /// mask ends at a blank or a colon, but for the colon behind a disk's letter.
    pub(super) fn mask(&mut self) -> Parsed<Option<Expr>> {
        let expression = match self.peek() {
            Some(TokenKind::Text | TokenKind::Name(VariableKind::String)) => true,
            Some(TokenKind::Keyword(keyword)) => {
                is_function(keyword) && keyword.word().ends_with('$')
            }
            None => return Ok(None),
            _ if self.at_end() => return Ok(None),
            _ => false,
        };
        if expression {
            return self.expression().map(Some);
        }
        let start = self.here().start as usize;
        let text = self.line.get(start..).unwrap_or_default();
        let disk = match text {
            [letter, b':', ..] if letter.is_ascii_alphabetic() => 2,
            _ => 0,
        };
        let length = text
            .iter()
            .skip(disk)
            .position(|&byte| byte == b':' || is_blank(byte))
            .map_or(text.len(), |length| disk + length);
        let span = Span::new(start, start + length);
        while self.next < self.tokens.len() && self.here().start < span.end {
            self.next += 1;
        }
        // LIST shows keywords in it in upper case, and files have no case.
        let kind = ExprKind::Text(span.of(self.line).to_ascii_uppercase());
        Ok(Some(Expr { span, kind }))
    }
}
