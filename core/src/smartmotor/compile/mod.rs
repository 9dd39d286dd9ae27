//! Commands become operations: expressions, assignments, orders. What directs the program is in `flow`.

mod flow;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::rc::Rc;

use super::ast::{
    Array, Expr, Index, Item, LineCommand, Operand, Operator, Place, Report, Statement,
    StatementKind, Target,
};
use super::code::{
    Code, HOST_CONSTANTS, Image, Op, PROGRAM_CONSTANTS, REGISTERS, Slow, System, TEMPORARY,
};
use super::motor::Flag;
use super::parser::parse_line;
use crate::language::{Cure, Span, split_lines};
use flow::Open;

/// Why a program is not downloaded.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// Line of the text, from 0.
    pub line: u32,
    /// Where in it.
    pub span: Span,
    /// What it is called: `missing LOOP`.
    pub name: String,
    /// Why, in one sentence.
    pub cause: String,
    /// What could be done about it.
    pub cure: Option<Cure>,
}

/// Compiles a program. What cannot work sets Bs when it is reached; the vendor's compiler refuses it.
pub fn compile(text: &[u8], without: Option<&str>) -> (Image, Vec<Problem>) {
    let mut compiler = Compiler::new(PROGRAM_CONSTANTS, REGISTERS);
    let mut ended = false;
    for line in split_lines(text) {
        compiler.lines.push(compiler.here());
        for statement in &parse_line(line, without).statements {
            ended |= statement.kind == StatementKind::End;
            compiler.place.span = statement.span;
            compiler.last = compiler.place;
            compiler.in_program(statement);
        }
        compiler.place.line = compiler.place.line.saturating_add(1);
    }
    compiler.finish(ended);
    compiler.image()
}

/// Compiles a command that the host sends.
pub fn compile_command(statements: &[Statement]) -> Image {
    let mut compiler = Compiler::new(HOST_CONSTANTS, usize::from(PROGRAM_CONSTANTS));
    for statement in statements {
        compiler.for_host(statement);
    }
    compiler.image().0
}

/// Where something stands.
#[derive(Debug, Clone, Copy, Default)]
struct At {
    line: u32,
    span: Span,
}

struct Compiler {
    ops: Vec<Op>,
    slow: Vec<Slow>,
    lines: Vec<u32>,
    labels: BTreeMap<u16, u32>,
    /// Jumps to labels, with the place where they stand.
    jumps: Vec<(usize, u16, At)>,
    /// Constants that have registers, which follow each other.
    values: Vec<i32>,
    first_constant: u16,
    /// Behind the last register for constants.
    limit: usize,
    /// Structures that are open, innermost last.
    open: Vec<Open>,
    problems: Vec<Problem>,
    /// Of the statement being compiled.
    place: At,
    /// Of the last statement.
    last: At,
}

impl Compiler {
    fn new(first_constant: u16, limit: usize) -> Compiler {
        Compiler {
            ops: Vec::new(),
            slow: Vec::new(),
            lines: Vec::new(),
            labels: BTreeMap::new(),
            jumps: Vec::new(),
            values: Vec::new(),
            first_constant,
            limit,
            open: Vec::new(),
            problems: Vec::new(),
            place: At::default(),
            last: At::default(),
        }
    }

    fn image(mut self) -> (Image, Vec<Problem>) {
        if self.ops.len() > usize::from(u16::MAX) {
            // No program that fits into the motor comes here; jumps could not name their targets.
            self.ops.clear();
            self.lines.clear();
            self.labels.clear();
        }
        let image = Image {
            ops: Rc::new(self.ops),
            slow: Rc::new(self.slow),
            lines: Rc::new(self.lines),
            labels: Rc::new(self.labels),
            constants: Rc::new(self.values),
        };
        (image, self.problems)
    }

    /// The index of the next operation.
    fn here(&self) -> u32 {
        u32::try_from(self.ops.len()).unwrap_or(u32::MAX)
    }

    /// The same as a jump's target.
    fn target(&self) -> u16 {
        u16::try_from(self.ops.len()).unwrap_or(u16::MAX)
    }

    fn emit(&mut self, code: Code, a: u16, b: u16, c: u16) -> usize {
        self.ops.push(Op::new(code, a, b, c));
        self.ops.len() - 1
    }

    fn slow(&mut self, slow: Slow, b: u16, c: u16) {
        let number = u16::try_from(self.slow.len()).unwrap_or(u16::MAX);
        self.slow.push(slow);
        self.emit(Code::Slow, number, b, c);
    }

    /// The last operation ends the statement.
    fn charge(&mut self) {
        if let Some(last) = self.ops.last_mut() {
            last.cost = 1;
        }
    }

    fn problem(&mut self, at: At, name: impl Into<String>, cause: impl Into<String>) {
        self.problems.push(Problem {
            line: at.line,
            span: at.span,
            name: name.into(),
            cause: cause.into(),
            cure: None,
        });
    }

    /// What cannot work sets Bs when it is reached.
    fn raise(&mut self) {
        self.slow(Slow::Raise(Flag::Syntax), 0, 0);
        self.charge();
    }

    fn for_host(&mut self, statement: &Statement) {
        use StatementKind as S;
        let system = match &statement.kind {
            S::Goto(label) => Some(System::Goto(*label)),
            S::Gosub(label) => Some(System::Gosub(*label)),
            S::End => Some(System::Stop),
            S::Line(LineCommand::Load) => Some(System::Load),
            S::Line(LineCommand::Upload { compiled }) => Some(System::Upload {
                compiled: *compiled,
            }),
            _ => None,
        };
        if let Some(system) = system {
            self.slow(Slow::System(system), 0, 0);
            self.charge();
        } else if !self.both(&statement.kind) {
            // Structures, labels, waits and RUN? have no meaning outside of a program (D137).
            self.raise();
        }
    }

    /// What programs and the host share; `false` for anything else.
    fn both(&mut self, kind: &StatementKind) -> bool {
        use StatementKind as S;
        match kind {
            S::Run => self.slow(Slow::System(System::Run), 0, 0),
            S::Reset => self.slow(Slow::System(System::Reset), 0, 0),
            S::Stack => self.slow(Slow::Stack, 0, 0),
            S::Assign(target, expr) => self.assign(*target, expr),
            S::Fill {
                array,
                index,
                values,
            } => {
                let index = self.index(*index, TEMPORARY);
                self.slow(Slow::Fill(*array, values.as_slice().into()), index, 0);
            }
            S::Motor(command) => self.slow(Slow::Motor(*command), 0, 0),
            S::ClearLine(flag) => self.slow(Slow::ClearLine(*flag), 0, 0),
            S::Report(report) => self.report(*report),
            S::Print { channel, items } => self.print(*channel, items),
            S::Store(range) => {
                let count = self.operand(range.count, TEMPORARY);
                let first = self.settled(range.first);
                self.slow(Slow::Save(first), count, TEMPORARY + 1);
            }
            S::Load(range) => {
                let count = self.operand(range.count, TEMPORARY);
                let first = self.settled(range.first);
                self.slow(Slow::Restore(first), count, TEMPORARY + 1);
            }
            S::Line(LineCommand::Load | LineCommand::Upload { .. }) => return false,
            S::Line(LineCommand::Pause) => self.slow(Slow::Pause, 0, 0),
            S::Line(command) => self.slow(Slow::Line(*command), 0, 0),
            S::ModuleOutput(expr) => {
                self.value(expr, None);
                self.slow(Slow::Nothing, 0, 0);
            }
            S::Malformed(_) => self.slow(Slow::Raise(Flag::Syntax), 0, 0),
            _ => return false,
        }
        self.charge();
        true
    }

    /// A place whose index stands in the second temporary.
    fn settled(&mut self, place: Place) -> Place {
        if let Place::Element(_, index) = place {
            let register = self.index(index, TEMPORARY + 1);
            if register != TEMPORARY + 1 {
                self.emit(Code::Move, register, 0, TEMPORARY + 1);
            }
        }
        place
    }

    fn assign(&mut self, target: Target, expr: &Expr) {
        match target {
            Target::Place(Place::Variable(register)) => {
                if let Some(number) = counts(register, expr) {
                    let (high, low) = halves(number);
                    self.emit(Code::Count, high, low, register);
                    return;
                }
                let before = self.ops.len();
                let value = self.value(expr, Some(register));
                // `a=a` is a statement, too.
                if value != register || self.ops.len() == before {
                    self.emit(Code::Move, value, 0, register);
                }
            }
            Target::Place(Place::Element(array, index)) => {
                let value = self.value(expr, None);
                let index = self.index(index, TEMPORARY + 2);
                self.emit(Code::Store, array_number(array), index, value);
            }
            Target::Register(_) | Target::EepromPointer | Target::Address => {
                let value = self.value(expr, None);
                self.slow(Slow::Set(target), value, 0);
            }
        }
    }

    /// The register of a constant; `temporary` if there is no room for it.
    fn constant(&mut self, value: i32, temporary: u16) -> u16 {
        // There are few enough to look at each.
        let known = self.values.iter().position(|&known| known == value);
        let index = known.unwrap_or(self.values.len());
        match u16::try_from(usize::from(self.first_constant) + index) {
            Ok(register) if usize::from(register) < self.limit => {
                if known.is_none() {
                    self.values.push(value);
                }
                register
            }
            _ => {
                let (high, low) = halves(value);
                self.emit(Code::Constant, high, low, temporary);
                temporary
            }
        }
    }

    /// Makes an index; the register that holds it.
    fn index(&mut self, index: Index, temporary: u16) -> u16 {
        match index {
            Index::Number(number) => self.constant(number, temporary),
            Index::Variable(register) => register,
            Index::Sum(a, b) => {
                self.emit(Code::Add, a, b, temporary);
                temporary
            }
            Index::Difference(a, b) => {
                self.emit(Code::Subtract, a, b, temporary);
                temporary
            }
        }
    }

    /// The register that holds an operand; what must be fetched goes to `temporary`.
    fn operand(&mut self, operand: Operand, temporary: u16) -> u16 {
        match operand {
            Operand::Number(value) => self.constant(value, temporary),
            Operand::Place(Place::Variable(register)) => register,
            Operand::Place(Place::Element(array, index)) => {
                let index = self.index(index, temporary);
                self.emit(Code::Load, array_number(array), index, temporary);
                temporary
            }
            Operand::Source(source) => {
                self.slow(Slow::Get(source), 0, temporary);
                temporary
            }
        }
    }

    /// The register that holds an expression; what is computed goes to `to`, or to a temporary.
    fn value(&mut self, expr: &Expr, to: Option<u16>) -> u16 {
        let to = to.unwrap_or(TEMPORARY);
        let Some((operator, right)) = expr.rest else {
            return self.operand(expr.left, to);
        };
        let left = self.operand(expr.left, TEMPORARY);
        let right_register = self.operand(right, TEMPORARY + 1);
        if operator == Operator::Divide && right == Operand::Number(0) {
            let at = self.place;
            self.problem(
                at,
                "division by zero",
                "The divisor is the constant 0, which no value can be divided by.",
            );
        }
        let (code, swapped) = match operator {
            Operator::Add => (Code::Add, false),
            Operator::Subtract => (Code::Subtract, false),
            Operator::Multiply => (Code::Multiply, false),
            Operator::Divide => (Code::Divide, false),
            Operator::And => (Code::And, false),
            Operator::Or => (Code::Or, false),
            Operator::Equal => (Code::Equal, false),
            Operator::NotEqual => (Code::NotEqual, false),
            Operator::Less => (Code::Less, false),
            Operator::LessEqual => (Code::LessEqual, false),
            Operator::Greater => (Code::Less, true),
            Operator::GreaterEqual => (Code::LessEqual, true),
        };
        match swapped {
            false => self.emit(code, left, right_register, to),
            true => self.emit(code, right_register, left, to),
        };
        to
    }

    fn report(&mut self, report: Report) {
        match report {
            Report::Value(operand) => {
                let register = self.operand(operand, TEMPORARY);
                self.slow(Slow::Report, register, 0);
            }
            Report::Text(text) => self.slow(Slow::ReportText(text), 0, 0),
        }
    }

    fn print(&mut self, channel: u8, items: &[Item]) {
        for item in items {
            match item {
                Item::Text(text) => self.slow(Slow::PrintText(text.as_slice().into()), 0, 0),
                Item::Number(expr) => {
                    let register = self.value(expr, None);
                    self.slow(Slow::PrintNumber, register, 0);
                }
                Item::Byte(expr) => {
                    let register = self.value(expr, None);
                    self.slow(Slow::PrintByte, register, 0);
                }
            }
        }
        self.slow(Slow::PrintEnd(channel), 0, 0);
    }
}

/// What an expression adds to the variable that it is assigned to, if it is a number and it does no more.
fn counts(variable: u16, expr: &Expr) -> Option<i32> {
    match expr.rest? {
        _ if expr.left != Operand::Place(Place::Variable(variable)) => None,
        (Operator::Add, Operand::Number(number)) => Some(number),
        (Operator::Subtract, Operand::Number(number)) => number.checked_neg(),
        _ => None,
    }
}

/// The number by which operations name an array.
fn array_number(array: Array) -> u16 {
    match array {
        Array::Bytes => 0,
        Array::Words => 1,
        Array::Longs => 2,
    }
}

/// A number as two operands.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // the two halves
fn halves(value: i32) -> (u16, u16) {
    let bits = value as u32;
    ((bits >> 16) as u16, bits as u16)
}
