//! From statements to operations: variables become registers, line numbers become places, and what cannot work becomes
//! an operation that raises the device's error when it is reached.

mod calls;
mod expressions;
mod flow;
mod statements;
mod texts;

use std::rc::Rc;

use super::ast::{LineRef, Statement, StatementKind};
use super::code::{Code, Image, Op, STRING_TEMPORARIES, SystemCall, TEMPORARIES};
use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::parser::parse_statements;
use super::program::Program;
use super::symbols::Symbols;
use super::sysvars::SysVar;
use crate::language::Span;

/// Something that will raise an error when it is reached.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// The program line; 0 in a direct line.
    pub line: u16,
    /// Where in the line's text.
    pub span: Span,
    /// What will be raised.
    pub error: ErrorCode,
    /// Why, in a plain sentence.
    pub cause: String,
}

/// Compiles a whole program, for a card that lacks the keyword `without`.
pub fn compile(program: &Program, symbols: &mut Symbols, without: Option<Keyword>) -> Image {
    compile_with_problems(program, symbols, without).0
}

/// What is wrong with a program, told without running it.
pub fn check(program: &Program) -> Vec<Problem> {
    compile_with_problems(program, &mut Symbols::default(), None).1
}

fn compile_with_problems(
    program: &Program,
    symbols: &mut Symbols,
    without: Option<Keyword>,
) -> (Image, Vec<Problem>) {
    let mut compiler = Compiler::new(symbols, Vec::new(), false);
    let mut lines = Vec::new();
    for (number, text) in program.lines() {
        compiler.line = number;
        lines.push((number, compiler.here()));
        let statements = parse_statements(text, without);
        compiler.gather_data(&statements);
        compiler.statements(&statements);
    }
    compiler.close_whiles();
    compiler.emit(Op::new(Code::End, 0, 0, 0));
    let Compiler {
        mut ops,
        fixups,
        mut problems,
        data,
        sysvars,
        ..
    } = compiler;
    let mut image = Image {
        program_ops: u32::try_from(ops.len()).unwrap_or(u32::MAX),
        lines: Rc::new(lines),
        ..Image::default()
    };
    resolve(&mut ops, &fixups, &image, &mut problems);
    image.ops = Rc::new(ops);
    image.data = Rc::new(data);
    image.sysvars = sysvars;
    (image, problems)
}

/// Compiles a direct line behind the program and returns its first operation.
pub fn compile_direct(
    text: &[u8],
    symbols: &mut Symbols,
    image: &mut Image,
    without: Option<Keyword>,
) -> u32 {
    let ops = Rc::make_mut(&mut image.ops);
    let start = image.program_ops;
    ops.truncate(usize::try_from(start).unwrap_or(usize::MAX));
    let mut compiler = Compiler::new(symbols, std::mem::take(&mut image.sysvars), true);
    compiler.ops = std::mem::take(ops);
    compiler.statements(&parse_statements(text, without));
    compiler.close_whiles();
    compiler.emit(Op::new(Code::End, 0, 0, 0));
    let Compiler {
        ops: mut compiled,
        fixups,
        mut problems,
        sysvars,
        ..
    } = compiler;
    resolve(&mut compiled, &fixups, image, &mut problems);
    image.ops = Rc::new(compiled);
    image.sysvars = sysvars;
    start
}

/// Points jumps at their lines; a jump to no line raises UNDEF'D STATEMENT when it is taken.
fn resolve(ops: &mut [Op], fixups: &[Fixup], image: &Image, problems: &mut Vec<Problem>) {
    for fixup in fixups {
        let Some(op) = ops.get_mut(fixup.op) else {
            continue;
        };
        match image.line_start(fixup.to.number) {
            Some(target) => op.set_target(target),
            None => {
                let error = ErrorCode::UndefdStatement;
                *op = Op {
                    cost: op.cost,
                    ..raise(error)
                };
                let cause = format!("there is no line {}", fixup.to.number);
                problems.push(Problem {
                    line: fixup.line,
                    span: fixup.to.span,
                    error,
                    cause,
                });
            }
        }
    }
}

fn raise(error: ErrorCode) -> Op {
    Op::new(Code::Raise, error as u16, 0, 0)
}

/// A jump whose line is not known yet.
struct Fixup {
    op: usize,
    to: LineRef,
    line: u16,
}

/// A WHILE that has not met its WHEND.
struct OpenWhile {
    /// Where its condition is evaluated.
    start: u32,
    /// The jump to behind the WHEND, if there is a condition.
    exit: Option<usize>,
    line: u16,
    span: Span,
}

/// Why a statement cannot be compiled.
pub(super) struct Refusal {
    error: ErrorCode,
    cause: String,
    span: Span,
}

struct Compiler<'a> {
    ops: Vec<Op>,
    symbols: &'a mut Symbols,
    sysvars: Vec<SysVar>,
    fixups: Vec<Fixup>,
    whiles: Vec<OpenWhile>,
    data: Vec<(u16, super::ast::DataItem)>,
    problems: Vec<Problem>,
    direct: bool,
    line: u16,
    /// The next free temporaries.
    number: u16,
    string: u16,
    /// Operands of the statement so far: they cost time.
    operands: u16,
    /// Numbers are compiled for printing: it matters which intermediate results are integers.
    printing: bool,
}

impl<'a> Compiler<'a> {
    fn new(symbols: &'a mut Symbols, sysvars: Vec<SysVar>, direct: bool) -> Compiler<'a> {
        Compiler {
            ops: Vec::new(),
            symbols,
            sysvars,
            fixups: Vec::new(),
            whiles: Vec::new(),
            data: Vec::new(),
            problems: Vec::new(),
            direct,
            line: 0,
            number: 0,
            string: 0,
            operands: 0,
            printing: false,
        }
    }

    fn here(&self) -> u32 {
        u32::try_from(self.ops.len()).unwrap_or(u32::MAX)
    }

    fn emit(&mut self, op: Op) -> usize {
        self.ops.push(op);
        self.ops.len() - 1
    }

    /// Lets an earlier jump go to the next operation.
    fn land(&mut self, jump: usize) {
        let here = self.here();
        if let Some(op) = self.ops.get_mut(jump) {
            op.set_target(here);
        }
    }

    /// Emits a jump to a line.
    fn jump_to_line(&mut self, code: Code, to: LineRef) {
        let op = self.emit(Op::jump(code, 0, 0));
        self.fixups.push(Fixup {
            op,
            to,
            line: self.line,
        });
    }

    /// The last operation carries the cost of the whole statement.
    fn charge(&mut self) {
        let cost = self.cost();
        if let Some(op) = self.ops.last_mut() {
            op.cost = cost;
        }
    }

    fn cost(&self) -> u8 {
        u8::try_from(super::firmware::STATEMENT_COST.saturating_add(self.operands))
            .unwrap_or(u8::MAX)
    }

    fn statements(&mut self, statements: &[Statement]) {
        for statement in statements {
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        (self.number, self.string, self.operands) = (0, 0, 0);
        let start = self.ops.len();
        if let Err(refusal) = self.compile_statement(statement) {
            self.emit(raise(refusal.error));
            let Refusal { error, cause, span } = refusal;
            self.problems.push(Problem {
                line: self.line,
                span,
                error,
                cause,
            });
        }
        if self.ops.len() == start {
            // Also what does nothing takes its time and can hold a breakpoint.
            self.emit(Op::new(Code::Nothing, 0, 0, 0));
            self.charge();
        }
    }

    /// DATA belongs to the program whether it is reached or not.
    fn gather_data(&mut self, statements: &[Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Data(items) => self
                    .data
                    .extend(items.iter().map(|item| (self.line, item.clone()))),
                StatementKind::If {
                    then, otherwise, ..
                } => {
                    self.gather_data(then);
                    self.gather_data(otherwise.as_deref().unwrap_or_default());
                }
                _ => {}
            }
        }
    }

    /// A WHILE without a WHEND can be entered but not skipped (D3).
    fn close_whiles(&mut self) {
        for open in std::mem::take(&mut self.whiles) {
            let error = ErrorCode::Syntax;
            if let Some(op) = open.exit.and_then(|exit| self.ops.get_mut(exit)) {
                *op = Op {
                    cost: op.cost,
                    ..raise(error)
                };
            }
            let cause = "this WHILE has no WHEND".to_owned();
            self.problems.push(Problem {
                line: open.line,
                span: open.span,
                error,
                cause,
            });
        }
    }

    fn number_temporary(&mut self, span: Span) -> Result<u16, Refusal> {
        if self.number == TEMPORARIES {
            return Err(too_complex(span));
        }
        self.number += 1;
        Ok(self.number - 1)
    }

    fn string_temporary(&mut self, span: Span) -> Result<u16, Refusal> {
        if self.string == STRING_TEMPORARIES {
            return Err(too_complex(span));
        }
        self.string += 1;
        Ok(self.string - 1)
    }

    fn sysvar(&mut self, var: SysVar) -> u16 {
        let known = self
            .sysvars
            .iter()
            .position(|&known| known == var)
            .unwrap_or_else(|| {
                self.sysvars.push(var);
                self.sysvars.len() - 1
            });
        // There are fewer system variables than 65536.
        u16::try_from(known).unwrap_or(u16::MAX)
    }

    fn system(&mut self, call: SystemCall, b: u16, c: u16) {
        self.emit(Op::new(Code::System, call as u16, b, c));
        self.charge();
    }
}

fn too_complex(span: Span) -> Refusal {
    Refusal {
        error: ErrorCode::FormulaTooComplex,
        cause: "this expression is nested too deeply".to_owned(),
        span,
    }
}

fn mismatch(span: Span, wanted: &str) -> Refusal {
    Refusal {
        error: ErrorCode::TypeMismatch,
        cause: format!("a {wanted} is wanted here"),
        span,
    }
}

/// Turns what the symbol table says into a refusal at a place.
fn at(span: Span) -> impl Fn(ErrorCode) -> Refusal {
    move |error| Refusal {
        error,
        cause: "there are too many variables and constants".to_owned(),
        span,
    }
}
