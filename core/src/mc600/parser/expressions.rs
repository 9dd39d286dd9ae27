//! Expressions ("Expressions and operators", "Hierarchy of operations").

use super::{Fault, Parsed, Parser};
use crate::language::Span;
use crate::language::precedence::{Infix, Operands, climb};
use crate::mc600::arrays::DIMENSIONS;
use crate::mc600::ast::{BinaryOp, Expr, ExprKind, Function, Name, Target, UnaryOp, VariableKind};
use crate::mc600::firmware::{ErrorCode, PARENTHESES};
use crate::mc600::keywords::Keyword;
use crate::mc600::lexer::TokenKind;
use crate::number::{self, Constant};

// How tightly operators bind, the loosest first; one level goes from left to right.
const OR: u8 = 1;
const AND: u8 = 2;
const NOT: u8 = 3;
const RELATION: u8 = 4;
const SUM: u8 = 5;
const PRODUCT: u8 = 6;
const MINUS: u8 = 7;
const POWER: u8 = 8;

/// Prefix operators that may wait for one operand, as in `NOT NOT 1` (assumed: as many as a line of a screen can hold
/// is more than the device's stack could).
const PREFIXES: usize = 40;

/// The binary operator that a keyword is.
fn infix(keyword: Keyword) -> Option<Infix<BinaryOp>> {
    let (operator, level) = match keyword {
        Keyword::Power => (BinaryOp::Power, POWER),
        Keyword::Multiply => (BinaryOp::Multiply, PRODUCT),
        Keyword::Divide => (BinaryOp::Divide, PRODUCT),
        Keyword::Plus => (BinaryOp::Add, SUM),
        Keyword::Minus => (BinaryOp::Subtract, SUM),
        Keyword::Equal => (BinaryOp::Equal, RELATION),
        Keyword::NotEqual => (BinaryOp::NotEqual, RELATION),
        Keyword::Less => (BinaryOp::Less, RELATION),
        Keyword::LessEqual => (BinaryOp::LessEqual, RELATION),
        Keyword::Greater => (BinaryOp::Greater, RELATION),
        Keyword::GreaterEqual => (BinaryOp::GreaterEqual, RELATION),
        Keyword::And => (BinaryOp::And, AND),
        Keyword::Or => (BinaryOp::Or, OR),
        Keyword::Xor => (BinaryOp::Xor, OR),
        _ => return None,
    };
    Some(Infix { operator, level })
}

/// The function that a keyword is, with the fewest and the most arguments it takes.
fn function(keyword: Keyword) -> Option<(Function, usize, usize)> {
    Some(match keyword {
        Keyword::Abs => (Function::Abs, 1, 1),
        Keyword::Asc => (Function::Asc, 1, 1),
        Keyword::Atn => (Function::Atn, 1, 1),
        Keyword::ChrS => (Function::ChrS, 1, 1),
        Keyword::Cos => (Function::Cos, 1, 1),
        Keyword::Exp => (Function::Exp, 1, 1),
        Keyword::Insta | Keyword::Intsta => (Function::Insta, 0, 0),
        Keyword::Int => (Function::Int, 1, 1),
        Keyword::LeftS => (Function::LeftS, 2, 2),
        Keyword::Len => (Function::Len, 1, 1),
        Keyword::Log => (Function::Log, 1, 1),
        Keyword::MidS => (Function::MidS, 2, 3),
        Keyword::Mod => (Function::Mod, 2, 2),
        Keyword::Outsta => (Function::Outsta, 0, 0),
        Keyword::RightS => (Function::RightS, 2, 2),
        Keyword::Rnd => (Function::Rnd, 1, 1),
        Keyword::Sdoerror => (Function::Sdoerror, 0, 0),
        Keyword::Sdoread => (Function::Sdoread, 1, 1),
        Keyword::Sgn => (Function::Sgn, 1, 1),
        Keyword::Sin => (Function::Sin, 1, 1),
        Keyword::Sqr => (Function::Sqr, 1, 1),
        Keyword::Sqrt => (Function::Sqrt, 1, 1),
        Keyword::StrS => (Function::StrS, 1, 1),
        Keyword::Tan => (Function::Tan, 1, 1),
        Keyword::Val => (Function::Val, 1, 1),
        _ => return None,
    })
}

/// Whether a keyword is a function of an expression: TAB and SPC are only PRINT's.
pub(super) fn is_function(keyword: Keyword) -> bool {
    function(keyword).is_some()
}

impl Operands for Parser<'_> {
    type Operator = BinaryOp;
    type Expr = Expr;
    type Error = Fault;

    fn operand(&mut self) -> Parsed<Expr> {
        let span = self.here();
        let kind = match self.peek() {
            Some(TokenKind::Integer(value)) => ExprKind::Integer(value),
            Some(TokenKind::Real(value)) => ExprKind::Real(value),
            Some(TokenKind::Text) => ExprKind::Text(self.text_constant(span)),
            Some(TokenKind::ParenOpen) => return self.parenthesised(),
            Some(TokenKind::Name(kind)) => return self.variable(kind),
            Some(TokenKind::Keyword(keyword)) => return self.keyword_operand(keyword),
            _ => return Err(self.unexpected("A value should stand here.")),
        };
        self.next += 1;
        Ok(Expr { span, kind })
    }

    fn infix(&self) -> Option<Infix<BinaryOp>> {
        infix(self.peek_keyword()?)
    }

    fn advance(&mut self) {
        self.next += 1;
    }

    fn join(&mut self, operator: BinaryOp, left: Expr, right: Expr) -> Expr {
        let span = left.span.to(right.span);
        let kind = ExprKind::Binary(operator, Box::new(left), Box::new(right));
        Expr { span, kind }
    }
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        climb(self, 0)
    }

    fn keyword_operand(&mut self, keyword: Keyword) -> Parsed<Expr> {
        let span = self.here();
        match keyword {
            Keyword::Plus => {
                self.next += 1;
                let operand = self.prefixed(POWER, span)?;
                Ok(Expr {
                    span: span.to(operand.span),
                    ..operand
                })
            }
            Keyword::Minus => self.negation(),
            Keyword::Not => {
                self.next += 1;
                let operand = self.prefixed(NOT + 1, span)?;
                Ok(unary(UnaryOp::Not, span, operand))
            }
            Keyword::Pi => {
                self.next += 1;
                let kind = ExprKind::Real(std::f64::consts::PI);
                Ok(Expr { span, kind })
            }
            Keyword::System(variable) => {
                self.next += 1;
                let kind = if variable.is_array() {
                    ExprKind::Call(Function::CanData, self.arguments(keyword, 1, 1)?)
                } else {
                    ExprKind::System(variable)
                };
                let span = span.to(self.behind());
                Ok(Expr { span, kind })
            }
            _ if keyword.is_absent() => Err(Fault::NotImplemented(keyword)),
            _ => match function(keyword) {
                Some((function, least, most)) => {
                    self.next += 1;
                    let arguments = self.arguments(keyword, least, most)?;
                    let kind = ExprKind::Call(function, arguments);
                    let span = span.to(self.behind());
                    Ok(Expr { span, kind })
                }
                None => Err(self.unexpected("A value should stand here.")),
            },
        }
    }

    /// The operand of a prefix operator that has been taken.
    fn prefixed(&mut self, lowest: u8, operator: Span) -> Parsed<Expr> {
        if self.prefixes >= PREFIXES {
            let cause = format!("More than {PREFIXES} signs wait for one operand.");
            return Err(Fault::new(ErrorCode::FormulaTooComplex, operator, cause));
        }
        self.prefixes += 1;
        let operand = climb(self, lowest);
        self.prefixes -= 1;
        operand
    }

    fn negation(&mut self) -> Parsed<Expr> {
        let minus = self.here();
        self.next += 1;
        let operand = self.prefixed(MINUS + 1, minus)?;
        let span = minus.to(operand.span);
        // The least integer has no positive counterpart within 32 bits.
        if let ExprKind::Real(_) = operand.kind
            && let digits = operand.span.of(self.line)
            && let Some((Constant::Integer(value), length)) = number::unsigned(digits, true)
            && length == digits.len()
        {
            let kind = ExprKind::Integer(value);
            return Ok(Expr { span, kind });
        }
        Ok(unary(UnaryOp::Negate, minus, operand))
    }

    /// The bytes between the quotes.
    pub(super) fn text_constant(&self, span: Span) -> Vec<u8> {
        let quoted = span.of(self.line);
        let text = quoted.strip_prefix(b"\"").unwrap_or(quoted);
        text.strip_suffix(b"\"").unwrap_or(text).to_vec()
    }

    fn parenthesised(&mut self) -> Parsed<Expr> {
        let start = self.open()?;
        let inner = self.expression()?;
        let span = start.to(self.close()?);
        Ok(Expr {
            span,
            kind: inner.kind,
        })
    }

    /// `(`, at most ten deep.
    pub(super) fn open(&mut self) -> Parsed<Span> {
        let span = self.here();
        if !self.eat(TokenKind::ParenOpen) {
            return Err(self.unexpected("An opening parenthesis should stand here."));
        }
        if self.parentheses >= PARENTHESES {
            let cause = format!("Parentheses nest deeper than {PARENTHESES}.");
            return Err(Fault::new(ErrorCode::FormulaTooComplex, span, cause));
        }
        self.parentheses += 1;
        Ok(span)
    }

    /// `)`
    pub(super) fn close(&mut self) -> Parsed<Span> {
        let span = self.here();
        if !self.eat(TokenKind::ParenClose) {
            let fault = self.unexpected("A closing parenthesis is missing.");
            let behind = Span {
                start: self.behind().end,
                end: self.behind().end,
            };
            return Err(if self.at_end() {
                fault.with_cure("Add )", behind, ")")
            } else {
                fault
            });
        }
        self.parentheses -= 1;
        Ok(span)
    }

    /// The arguments of a keyword that has been taken, in parentheses. Without arguments the parentheses may be left
    /// out, as the manual's text does ("the function midle").
    pub(super) fn arguments(
        &mut self,
        keyword: Keyword,
        least: usize,
        most: usize,
    ) -> Parsed<Vec<Expr>> {
        let word = self.behind();
        if least == 0 && self.peek() != Some(TokenKind::ParenOpen) {
            return Ok(Vec::new());
        }
        self.open()?;
        let arguments = if self.peek() == Some(TokenKind::ParenClose) {
            Vec::new()
        } else {
            self.list()?
        };
        let span = word.to(self.close()?);
        if arguments.len() < least || arguments.len() > most {
            let syntax = keyword.syntax();
            return Err(Fault::syntax(
                span,
                format!("Wrong number of arguments: it is written {syntax}."),
            ));
        }
        Ok(arguments)
    }

    fn list(&mut self) -> Parsed<Vec<Expr>> {
        let mut list = vec![self.expression()?];
        while self.eat(TokenKind::Comma) {
            list.push(self.expression()?);
        }
        Ok(list)
    }

    fn variable(&mut self, kind: VariableKind) -> Parsed<Expr> {
        let start = self.here();
        let name = self.name(kind);
        let kind = match self.subscripts()? {
            Some(subscripts) => ExprKind::Element(name, subscripts),
            None => ExprKind::Variable(name),
        };
        let span = start.to(self.behind());
        Ok(Expr { span, kind })
    }

    /// Takes the name that comes next.
    pub(super) fn name(&mut self, kind: VariableKind) -> Name {
        let text = self.written(self.here()).to_ascii_uppercase();
        self.next += 1;
        Name {
            text: text.into_boxed_str(),
            kind,
        }
    }

    /// `(i,...)`, up to four; `None` if there is no parenthesis.
    pub(super) fn subscripts(&mut self) -> Parsed<Option<Vec<Expr>>> {
        if self.peek() != Some(TokenKind::ParenOpen) {
            return Ok(None);
        }
        let start = self.open()?;
        let subscripts = self.list()?;
        let span = start.to(self.close()?);
        if subscripts.len() > DIMENSIONS {
            let cause = format!("An array has at most {DIMENSIONS} subscripts.");
            return Err(Fault::new(ErrorCode::BadSubscript, span, cause));
        }
        Ok(Some(subscripts))
    }

    /// Something that can be assigned.
    pub(super) fn target(&mut self) -> Parsed<Target> {
        let span = self.here();
        match self.peek() {
            Some(TokenKind::Name(kind)) => {
                let name = self.name(kind);
                Ok(match self.subscripts()? {
                    Some(subscripts) => Target::Element(name, subscripts),
                    None => Target::Variable(name),
                })
            }
            Some(TokenKind::Keyword(Keyword::System(variable))) => {
                self.next += 1;
                if variable.is_read_only() {
                    let cause = format!("{} can only be read.", variable.word());
                    return Err(Fault::syntax(span, cause));
                }
                Ok(Target::System(variable))
            }
            _ => Err(self.unexpected("A variable should stand here.")),
        }
    }
}

fn unary(operator: UnaryOp, at: Span, operand: Expr) -> Expr {
    let span = at.to(operand.span);
    let kind = ExprKind::Unary(operator, Box::new(operand));
    Expr { span, kind }
}
