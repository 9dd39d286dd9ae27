//! Motion, drive, interrupt and I/O calls: arguments into registers that follow each other.

use super::super::ast::{Expr, ExprKind, VariableKind};
use super::super::code::{Code, Op};
use super::super::firmware::ErrorCode;
use super::super::keywords::Keyword;
use super::super::motion_calls;
use super::{Compiler, Refusal, at, mismatch};
use crate::language::Span;

impl Compiler<'_> {
    pub(super) fn call(
        &mut self,
        keyword: Keyword,
        arguments: &[Expr],
        span: Span,
    ) -> Result<(), Refusal> {
        let Some(number) = motion_calls::number(keyword) else {
            let cause = format!("{} does not work yet", keyword.word());
            return Err(Refusal {
                error: ErrorCode::NotImplemented,
                cause,
                span,
            });
        };
        let first = match arguments {
            [] => 0,
            [only] if !motion_calls::takes_table(keyword, 0) => self.number(only)?.register,
            _ => self.call_arguments(keyword, arguments)?,
        };
        self.emit(Op::new(Code::Motion, number, first, 0));
        self.charge();
        Ok(())
    }

    /// Puts the arguments into temporaries that follow each other and returns the first.
    fn call_arguments(&mut self, keyword: Keyword, arguments: &[Expr]) -> Result<u16, Refusal> {
        let first = self.number;
        for (at, argument) in arguments.iter().enumerate() {
            let temporary = self.number_temporary(argument.span)?;
            if motion_calls::takes_table(keyword, at) {
                let table = self.table(argument)?;
                self.emit(Op::new(Code::Move, table, 0, temporary));
            } else {
                self.number_into(argument, temporary)?;
            }
            self.number = temporary + 1;
        }
        Ok(first)
    }

    /// The constant that stands for an array of integers named without subscripts.
    fn table(&mut self, argument: &Expr) -> Result<u16, Refusal> {
        self.operands += 1;
        let span = argument.span;
        match &argument.kind {
            ExprKind::Variable(name) if name.kind == VariableKind::Integer => {
                let array = self.symbols.array(name).map_err(at(span))?;
                self.symbols.constant(f64::from(array)).map_err(at(span))
            }
            _ => Err(mismatch(span, "table: an integer array without subscripts")),
        }
    }
}
