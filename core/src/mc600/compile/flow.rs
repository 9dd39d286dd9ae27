//! Where a program goes: jumps, conditions and loops.

use super::super::ast::{BinaryOp, Expr, ExprKind, LineRef, Name, Statement, VariableKind};
use super::super::code::{ANY, Code, Op};
use super::super::firmware::ErrorCode;
use super::expressions::Type;
use super::{Compiler, OpenWhile, Refusal, at, mismatch};
use crate::language::Span;

impl Compiler<'_> {
    pub(super) fn go(&mut self, code: Code, to: LineRef) {
        self.jump_to_line(code, to);
        self.charge();
    }

    pub(super) fn on(
        &mut self,
        selector: &Expr,
        gosub: bool,
        lines: &[LineRef],
    ) -> Result<(), Refusal> {
        let selector = self.number(selector)?.register;
        let count = u16::try_from(lines.len()).unwrap_or(u16::MAX);
        self.emit(Op::new(Code::On, selector, count, 0));
        self.charge();
        for line in lines {
            self.jump_to_line(if gosub { Code::OnGosub } else { Code::OnGoto }, *line);
        }
        Ok(())
    }

    pub(super) fn when(
        &mut self,
        condition: &Expr,
        then: &[Statement],
        otherwise: Option<&[Statement]>,
    ) -> Result<(), Refusal> {
        let skip = self.unless(condition)?;
        self.statements(then);
        match otherwise {
            Some(otherwise) => {
                let end = self.emit(Op::jump(Code::Jump, 0, 0));
                self.land(skip);
                self.statements(otherwise);
                self.land(end);
            }
            None => self.land(skip),
        }
        Ok(())
    }

    /// Emits what evaluates a condition, and the jump that is taken unless it holds; returns the jump.
    fn unless(&mut self, condition: &Expr) -> Result<usize, Refusal> {
        let test = match self.comparison(condition)? {
            Some(comparison) => comparison,
            None => Op::new(Code::When, self.number(condition)?.register, 0, 0),
        };
        self.emit(test);
        self.charge();
        Ok(self.emit(Op::jump(Code::Jump, 0, 0)))
    }

    /// A comparison of numbers as an operation that decides whether the next one is taken.
    fn comparison(&mut self, condition: &Expr) -> Result<Option<Op>, Refusal> {
        let ExprKind::Binary(op, left, right) = &condition.kind else {
            return Ok(None);
        };
        if self.type_of(left) == Type::Text || self.type_of(right) == Type::Text {
            return Ok(None);
        }
        let (code, swap) = match op {
            BinaryOp::Equal => (Code::WhenEqual, false),
            BinaryOp::NotEqual => (Code::WhenNotEqual, false),
            BinaryOp::Less => (Code::WhenLess, false),
            BinaryOp::Greater => (Code::WhenLess, true),
            BinaryOp::LessEqual => (Code::WhenLessEqual, false),
            BinaryOp::GreaterEqual => (Code::WhenLessEqual, true),
            _ => return Ok(None),
        };
        let (a, b) = self.operands(left, right)?;
        let (a, b) = if swap { (b, a) } else { (a, b) };
        Ok(Some(Op::new(code, a, b, 0)))
    }

    pub(super) fn repeat(
        &mut self,
        variable: &Name,
        start: &Expr,
        limit: &Expr,
        step: Option<&Expr>,
        span: Span,
    ) -> Result<(), Refusal> {
        if variable.kind == VariableKind::String {
            return Err(mismatch(span, "number"));
        }
        let integer = variable.kind == VariableKind::Integer;
        let register = self.symbols.number(variable).map_err(at(span))?;
        if integer {
            self.integer_into(start, register)?;
        } else {
            self.number_into(start, register)?;
        }
        let limit = self.number(limit)?.register;
        let step = match step {
            Some(step) => self.number(step)?.register,
            None => self.symbols.constant(1.0).map_err(at(span))?,
        };
        let code = if integer { Code::ForInteger } else { Code::For };
        self.emit(Op::new(code, register, limit, step));
        self.charge();
        Ok(())
    }

    pub(super) fn next(&mut self, names: &[Name], span: Span) -> Result<(), Refusal> {
        if names.is_empty() {
            self.emit(Op::new(Code::Next, ANY, 0, 0));
            self.charge();
        }
        for name in names {
            if name.kind == VariableKind::String {
                return Err(mismatch(span, "number"));
            }
            let register = self.symbols.number(name).map_err(at(span))?;
            self.emit(Op::new(Code::Next, register, 0, 0));
            self.charge();
        }
        Ok(())
    }

    pub(super) fn open_while(
        &mut self,
        condition: Option<&Expr>,
        span: Span,
    ) -> Result<(), Refusal> {
        let start = self.here();
        let exit = match condition {
            Some(condition) => Some(self.unless(condition)?),
            None => {
                self.plain(Code::Nothing);
                None
            }
        };
        self.whiles.push(OpenWhile {
            start,
            exit,
            line: self.line,
            span,
        });
        Ok(())
    }

    pub(super) fn close_while(
        &mut self,
        condition: Option<&Expr>,
        span: Span,
    ) -> Result<(), Refusal> {
        let Some(open) = self.whiles.pop() else {
            let cause = "this WHEND has no WHILE".to_owned();
            return Err(Refusal {
                error: ErrorCode::Syntax,
                cause,
                span,
            });
        };
        match condition {
            Some(condition) => {
                let back = self.unless(condition)?;
                if let Some(op) = self.ops.get_mut(back) {
                    op.set_target(open.start);
                }
            }
            None => {
                self.emit(Op::jump(Code::Jump, 0, open.start));
                self.charge();
            }
        }
        if let Some(exit) = open.exit {
            self.land(exit);
        }
        Ok(())
    }
}
