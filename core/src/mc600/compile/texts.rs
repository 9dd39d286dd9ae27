//! Expressions that yield strings.

use super::super::ast::{BinaryOp, Expr, ExprKind, Function, VariableKind};
use super::super::code::{Code, Op};
use super::{Compiler, Refusal, at, mismatch};
use crate::language::Span;

/// The terms of a sum from left to right; of anything else that alone.
fn terms(mut expr: &Expr) -> Vec<&Expr> {
    let mut terms = Vec::new();
    while let ExprKind::Binary(BinaryOp::Add, left, right) = &expr.kind {
        terms.push(right.as_ref());
        expr = left;
    }
    terms.push(expr);
    terms.reverse();
    terms
}

impl Compiler<'_> {
    /// A string in whatever place it is in.
    pub(super) fn text(&mut self, expr: &Expr) -> Result<u16, Refusal> {
        match &expr.kind {
            ExprKind::Text(text) => {
                self.operands += 1;
                self.symbols.text(text).map_err(at(expr.span))
            }
            ExprKind::Variable(name) if name.kind == VariableKind::String => {
                self.operands += 1;
                self.symbols.string(name).map_err(at(expr.span))
            }
            _ => {
                let temporary = self.string_temporary(expr.span)?;
                self.text_operation(expr, temporary)?;
                self.string = temporary + 1;
                Ok(temporary)
            }
        }
    }

    /// A string put into a place, which is changed only when the whole string is there.
    pub(super) fn text_into(&mut self, expr: &Expr, place: u16) -> Result<(), Refusal> {
        let terms = terms(expr);
        if let [first, rest @ ..] = terms.as_slice()
            && !rest.is_empty()
            && self.plain_text(first)? == Some(place)
        {
            // A$=A$+... appends in place.
            let rest = self.text_sum(rest)?;
            self.emit(Op::new(Code::StringAppend, rest, 0, place));
            return Ok(());
        }
        let from = self.text(expr)?;
        self.emit(Op::new(Code::StringMove, from, 0, place));
        Ok(())
    }

    /// A sum of strings in whatever place it is in.
    fn text_sum(&mut self, terms: &[&Expr]) -> Result<u16, Refusal> {
        match terms {
            [only] => self.text(only),
            _ => {
                let span = terms.first().map_or_else(Span::default, |term| term.span);
                let temporary = self.string_temporary(span)?;
                self.text_sum_into(terms, temporary)?;
                Ok(temporary)
            }
        }
    }

    fn text_sum_into(&mut self, terms: &[&Expr], to: u16) -> Result<(), Refusal> {
        let Some((first, rest)) = terms.split_first() else {
            return Ok(());
        };
        if matches!(first.kind, ExprKind::Text(_) | ExprKind::Variable(_)) {
            let first = self.text(first)?;
            self.emit(Op::new(Code::StringMove, first, 0, to));
        } else {
            self.text_operation(first, to)?;
        }
        for term in rest {
            let mark = self.string;
            let term = self.text(term)?;
            self.string = mark;
            self.emit(Op::new(Code::StringAppend, term, 0, to));
        }
        Ok(())
    }

    fn plain_text(&mut self, expr: &Expr) -> Result<Option<u16>, Refusal> {
        match &expr.kind {
            ExprKind::Variable(name) if name.kind == VariableKind::String => {
                Ok(Some(self.text(expr)?))
            }
            _ => Ok(None),
        }
    }

    fn text_operation(&mut self, expr: &Expr, to: u16) -> Result<(), Refusal> {
        let numbers = self.number;
        match &expr.kind {
            ExprKind::Element(name, subscripts) if name.kind == VariableKind::String => {
                let (array, index) = self.element(name, subscripts)?;
                self.emit(Op::new(Code::StringLoad, array, index, to));
            }
            ExprKind::Binary(BinaryOp::Add, ..) => self.text_sum_into(&terms(expr), to)?,
            ExprKind::Call(function, arguments) => {
                self.text_function(*function, arguments, to, expr.span)?
            }
            _ => return Err(mismatch(expr.span, "string")),
        }
        self.number = numbers;
        Ok(())
    }

    fn text_function(
        &mut self,
        function: Function,
        arguments: &[Expr],
        to: u16,
        span: Span,
    ) -> Result<(), Refusal> {
        self.operands += 1;
        let op = match (function, arguments) {
            (Function::ChrS, [code]) => Op::new(Code::Chr, self.number(code)?.register, 0, to),
            (Function::StrS, [value]) => {
                let number = self.printed_number(value)?;
                Op::new(Code::Str, number.register, u16::from(number.integer), to)
            }
            (Function::LeftS | Function::RightS, [text, length]) => {
                let text = self.text(text)?;
                let length = self.number(length)?.register;
                let code = if function == Function::LeftS {
                    Code::Left
                } else {
                    Code::Right
                };
                Op::new(code, text, length, to)
            }
            (Function::MidS, [text, start]) => {
                let text = self.text(text)?;
                Op::new(Code::MidRest, text, self.number(start)?.register, to)
            }
            (Function::MidS, [text, start, length]) => {
                let text = self.text(text)?;
                let first = self.number_temporary(span)?;
                self.number_into(start, first)?;
                self.number = first + 1;
                let second = self.number_temporary(span)?;
                self.number_into(length, second)?;
                Op::new(Code::Mid, text, first, to)
            }
            _ => return Err(mismatch(span, "string")),
        };
        self.emit(op);
        Ok(())
    }
}
