//! Expressions. Types are known before anything runs: a name's last character tells.

use super::super::ast::{BinaryOp, Expr, ExprKind, Function, Name, UnaryOp, VariableKind};
use super::super::code::{Code, Op};
use super::super::functions;
use super::{Compiler, Refusal, at, mismatch};
use crate::language::Span;

/// What an expression yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    Real,
    /// An integer where its value is one: it prints all its digits (D15).
    Integer,
    Text,
}

/// A number in a register.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number {
    pub(super) register: u16,
    pub(super) integer: bool,
}

/// What the result of an integer operation says of its operand: a constant or a variable surely is an integer, a sum
/// may have left 32 bits.
fn is_computed(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Binary(..) | ExprKind::Unary(..))
}

impl Compiler<'_> {
    pub(super) fn type_of(&self, expr: &Expr) -> Type {
        match &expr.kind {
            ExprKind::Integer(_) | ExprKind::System(_) => Type::Integer,
            ExprKind::Real(_) => Type::Real,
            ExprKind::Text(_) => Type::Text,
            ExprKind::Variable(name) | ExprKind::Element(name, _) => match name.kind {
                VariableKind::Real => Type::Real,
                VariableKind::Integer => Type::Integer,
                VariableKind::String => Type::Text,
            },
            ExprKind::Unary(UnaryOp::Not, _) => Type::Integer,
            ExprKind::Unary(UnaryOp::Negate, operand) => self.type_of(operand),
            ExprKind::Binary(op, left, right) => match op {
                BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide => {
                    match (self.type_of(left), self.type_of(right)) {
                        (Type::Text, _) => Type::Text,
                        (Type::Integer, Type::Integer) => Type::Integer,
                        _ => Type::Real,
                    }
                }
                BinaryOp::Power => Type::Real,
                _ => Type::Integer,
            },
            ExprKind::Call(function, arguments) => match function {
                Function::ChrS
                | Function::LeftS
                | Function::MidS
                | Function::RightS
                | Function::StrS => Type::Text,
                Function::Abs => arguments
                    .first()
                    .map_or(Type::Real, |argument| self.type_of(argument)),
                Function::Asc
                | Function::Insta
                | Function::Int
                | Function::Len
                | Function::Mod
                | Function::Outsta
                | Function::CanData
                | Function::Sdoerror
                | Function::Sdoread
                | Function::Sgn => Type::Integer,
                _ => Type::Real,
            },
        }
    }

    /// A number in whatever register it is in.
    pub(super) fn number(&mut self, expr: &Expr) -> Result<Number, Refusal> {
        let integer = self.type_of(expr) == Type::Integer;
        let register = match &expr.kind {
            ExprKind::Integer(value) => self.constant(f64::from(*value), expr.span)?,
            ExprKind::Real(value) => self.constant(*value, expr.span)?,
            ExprKind::Variable(name) if name.kind != VariableKind::String => {
                self.operands += 1;
                self.symbols.number(name).map_err(at(expr.span))?
            }
            _ => {
                let op = self.operation(expr)?;
                self.finish(op, expr.span)?
            }
        };
        Ok(Number { register, integer })
    }

    /// A number that is going to be printed: which intermediate results are integers decides how many digits show.
    pub(super) fn printed_number(&mut self, expr: &Expr) -> Result<Number, Refusal> {
        let was = std::mem::replace(&mut self.printing, true);
        let number = self.number(expr);
        self.printing = was;
        number
    }

    /// A number put into a register.
    pub(super) fn number_into(&mut self, expr: &Expr, register: u16) -> Result<(), Refusal> {
        let op = match self.plain_number(expr)? {
            Some(from) => Op::new(Code::Move, from, 0, register),
            None => self.operation(expr)?,
        };
        self.emit(Op { c: register, ..op });
        Ok(())
    }

    /// A number's floor put into a register.
    pub(super) fn integer_into(&mut self, expr: &Expr, register: u16) -> Result<(), Refusal> {
        let op = match &expr.kind {
            ExprKind::Binary(BinaryOp::Add, left, right) if self.type_of(expr) != Type::Text => {
                let (left, right) = self.operands(left, right)?;
                Op::new(Code::AddInteger, left, right, register)
            }
            _ => Op::new(Code::ToInteger, self.number(expr)?.register, 0, register),
        };
        self.emit(op);
        Ok(())
    }

    /// The register of a constant or a simple variable; `None` for anything else.
    fn plain_number(&mut self, expr: &Expr) -> Result<Option<u16>, Refusal> {
        let plain = match &expr.kind {
            ExprKind::Integer(_) | ExprKind::Real(_) => true,
            ExprKind::Variable(name) => name.kind != VariableKind::String,
            _ => false,
        };
        Ok(if plain {
            Some(self.number(expr)?.register)
        } else {
            None
        })
    }

    fn constant(&mut self, value: f64, span: Span) -> Result<u16, Refusal> {
        self.operands += 1;
        self.symbols.constant(value).map_err(at(span))
    }

    /// Emits an operation with a temporary as its result.
    fn finish(&mut self, op: Op, span: Span) -> Result<u16, Refusal> {
        let temporary = self.number_temporary(span)?;
        self.emit(Op { c: temporary, ..op });
        Ok(temporary)
    }

    /// Two operands in registers; their temporaries are free again for the result.
    pub(super) fn operands(&mut self, left: &Expr, right: &Expr) -> Result<(u16, u16), Refusal> {
        let mark = self.number;
        let left = self.operand(left)?;
        let right = self.operand(right)?;
        self.number = mark;
        Ok((left, right))
    }

    fn operand(&mut self, expr: &Expr) -> Result<u16, Refusal> {
        let number = self.number(expr)?;
        if self.printing && number.integer && is_computed(expr) {
            self.emit(Op::new(Code::CheckInteger, number.register, 0, 0));
        }
        Ok(number.register)
    }

    /// Everything but the last operation of a numeric expression, whose result is still to be placed.
    fn operation(&mut self, expr: &Expr) -> Result<Op, Refusal> {
        match &expr.kind {
            ExprKind::Element(name, subscripts) if name.kind != VariableKind::String => {
                let mark = self.number;
                if let [only] = subscripts.as_slice() {
                    let array = self.symbols.array(name).map_err(at(only.span))?;
                    let subscript = self.number(only)?.register;
                    self.number = mark;
                    return Ok(Op::new(Code::LoadAt, array, subscript, 0));
                }
                let (array, index) = self.element(name, subscripts)?;
                self.number = mark;
                Ok(Op::new(Code::Load, array, index, 0))
            }
            ExprKind::System(var) => {
                self.operands += 1;
                let var = self.sysvar(*var);
                Ok(Op::new(Code::GetSystem, var, 0, 0))
            }
            ExprKind::Unary(op, operand) => {
                let mark = self.number;
                let operand = self.operand(operand)?;
                self.number = mark;
                let code = match op {
                    UnaryOp::Negate => Code::Negate,
                    UnaryOp::Not => Code::Not,
                };
                Ok(Op::new(code, operand, 0, 0))
            }
            ExprKind::Binary(op, left, right) => self.binary(*op, left, right, expr.span),
            ExprKind::Call(function, arguments) => self.function(*function, arguments, expr.span),
            _ => Err(mismatch(expr.span, "number")),
        }
    }

    fn binary(
        &mut self,
        op: BinaryOp,
        left: &Expr,
        right: &Expr,
        span: Span,
    ) -> Result<Op, Refusal> {
        use BinaryOp::{Greater, GreaterEqual};
        // a > b is b < a; the operands are still evaluated from left to right.
        let swap = matches!(op, Greater | GreaterEqual);
        if self.type_of(left) == Type::Text || self.type_of(right) == Type::Text {
            let code = match op {
                BinaryOp::Equal => Code::StringEqual,
                BinaryOp::NotEqual => Code::StringNotEqual,
                BinaryOp::Less | Greater => Code::StringLess,
                BinaryOp::LessEqual | GreaterEqual => Code::StringLessEqual,
                _ => return Err(mismatch(span, "number")),
            };
            let mark = self.string;
            let (a, b) = (self.text(left)?, self.text(right)?);
            self.string = mark;
            return Ok(if swap {
                Op::new(code, b, a, 0)
            } else {
                Op::new(code, a, b, 0)
            });
        }
        let code = match op {
            BinaryOp::Power => Code::Power,
            BinaryOp::Multiply => Code::Multiply,
            BinaryOp::Divide => Code::Divide,
            BinaryOp::Add => Code::Add,
            BinaryOp::Subtract => Code::Subtract,
            BinaryOp::Equal => Code::Equal,
            BinaryOp::NotEqual => Code::NotEqual,
            BinaryOp::Less | Greater => Code::Less,
            BinaryOp::LessEqual | GreaterEqual => Code::LessEqual,
            BinaryOp::And => Code::And,
            BinaryOp::Or => Code::Or,
            BinaryOp::Xor => Code::Xor,
        };
        let (a, b) = self.operands(left, right)?;
        Ok(if swap {
            Op::new(code, b, a, 0)
        } else {
            Op::new(code, a, b, 0)
        })
    }

    fn function(
        &mut self,
        function: Function,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Op, Refusal> {
        self.operands += 1;
        // A function's result is an integer or not whatever its argument was on the way.
        let was = std::mem::replace(&mut self.printing, false);
        let op = self.function_op(function, arguments, span);
        self.printing = was;
        op
    }

    fn function_op(
        &mut self,
        function: Function,
        arguments: &[Expr],
        span: Span,
    ) -> Result<Op, Refusal> {
        match (function, arguments) {
            (Function::Len | Function::Asc | Function::Val, [text]) => {
                let mark = self.string;
                let text = self.text(text)?;
                self.string = mark;
                let code = match function {
                    Function::Len => Code::Len,
                    Function::Asc => Code::Asc,
                    _ => Code::Val,
                };
                Ok(Op::new(code, text, 0, 0))
            }
            (Function::Mod, [left, right]) => {
                let (left, right) = self.operands(left, right)?;
                Ok(Op::new(Code::Modulo, left, right, 0))
            }
            (Function::Int | Function::Sqrt, [argument]) => {
                let mark = self.number;
                let argument = self.number(argument)?.register;
                self.number = mark;
                let code = match function {
                    Function::Int => Code::Floor,
                    _ => Code::SquareRoot,
                };
                Ok(Op::new(code, argument, 0, 0))
            }
            (_, [] | [_]) => {
                let Some(number) = functions::number(function) else {
                    return Err(mismatch(span, "number"));
                };
                let mark = self.number;
                let argument = match arguments.first() {
                    Some(argument) => self.number(argument)?.register,
                    None => 0,
                };
                self.number = mark;
                Ok(Op::new(Code::Function, number, argument, 0))
            }
            _ => Err(mismatch(span, "number")),
        }
    }

    /// An array's number and the register with the linear index of an element.
    pub(super) fn element(
        &mut self,
        name: &Name,
        subscripts: &[Expr],
    ) -> Result<(u16, u16), Refusal> {
        let span = subscripts
            .first()
            .map_or_else(Span::default, |first| first.span);
        let array = self.symbols.array(name).map_err(at(span))?;
        let mark = self.number;
        let op = match subscripts {
            [only] => Op::new(Code::Index1, array, self.number(only)?.register, 0),
            _ => {
                let first = self.consecutive(subscripts)?;
                let count = u16::try_from(subscripts.len()).unwrap_or(u16::MAX);
                self.emit(Op::new(Code::Subscripts, count, 0, 0));
                Op::new(Code::Index, array, first, 0)
            }
        };
        self.number = mark;
        Ok((array, self.finish(op, span)?))
    }

    /// Puts numbers into temporaries that follow each other and returns the first.
    pub(super) fn consecutive(&mut self, exprs: &[Expr]) -> Result<u16, Refusal> {
        let first = self.number;
        for expr in exprs {
            let temporary = self.number_temporary(expr.span)?;
            self.number_into(expr, temporary)?;
            self.number = temporary + 1;
        }
        Ok(first)
    }
}
