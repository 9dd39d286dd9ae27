//! One function a statement.

use super::super::ast::{Expr, Name, PrintItem, Statement, StatementKind, Target, VariableKind};
use super::super::code::{ANY, Code, Op, SystemCall};
use super::super::firmware::ErrorCode;
use super::expressions::Type;
use super::{Compiler, Refusal, at};
use crate::language::Span;

/// Where a value goes, with its subscripts already evaluated.
enum Place {
    Number {
        register: u16,
        integer: bool,
    },
    Text(u16),
    Element {
        array: u16,
        index: u16,
        kind: VariableKind,
    },
    System(u16),
}

impl Compiler<'_> {
    pub(super) fn compile_statement(&mut self, statement: &Statement) -> Result<(), Refusal> {
        let span = statement.span;
        match &statement.kind {
            StatementKind::Malformed(malformed) => {
                return Err(Refusal {
                    error: malformed.error,
                    cause: malformed.cause.clone(),
                    span,
                });
            }
            StatementKind::NotImplemented(keyword) => {
                let cause = format!("{} does not work yet", keyword.word());
                return Err(Refusal {
                    error: ErrorCode::NotImplemented,
                    cause,
                    span,
                });
            }
            StatementKind::Let { target, value } => self.assign(target, value)?,
            StatementKind::Print(items) => self.print(items, span)?,
            StatementKind::Input { prompt, targets } => {
                self.input(prompt.as_deref(), targets, span)?
            }
            StatementKind::Goto(to) => self.go(Code::Jump, *to),
            StatementKind::Gosub(to) => self.go(Code::Gosub, *to),
            StatementKind::Return => self.plain(Code::Return),
            StatementKind::Reti => self.plain(Code::ReturnFromInterrupt),
            StatementKind::On {
                selector,
                gosub,
                lines,
            } => self.on(selector, *gosub, lines)?,
            StatementKind::If {
                condition,
                then,
                otherwise,
            } => self.when(condition, then, otherwise.as_deref())?,
            StatementKind::For {
                variable,
                start,
                limit,
                step,
            } => {
                self.repeat(variable, start, limit, step.as_ref(), span)?;
            }
            StatementKind::Next(names) => self.next(names, span)?,
            StatementKind::While(condition) => self.open_while(condition.as_ref(), span)?,
            StatementKind::Whend(condition) => self.close_while(condition.as_ref(), span)?,
            StatementKind::Rem | StatementKind::Data(_) => {}
            StatementKind::Read(targets) => self.read(targets)?,
            StatementKind::Restore => self.plain(Code::Restore),
            StatementKind::Dim(arrays) => self.dim(arrays, span)?,
            StatementKind::End => self.plain(Code::End),
            StatementKind::Stop => self.plain(Code::Stop),
            StatementKind::Call { keyword, arguments } => self.call(*keyword, arguments, span)?,
            _ => self.command(&statement.kind)?,
        }
        Ok(())
    }

    /// What only the firmware around the interpreter can do.
    fn command(&mut self, kind: &StatementKind) -> Result<(), Refusal> {
        match kind {
            StatementKind::New => self.system(SystemCall::New, 0, 0),
            StatementKind::List(range) => self.system(SystemCall::List, range.first, range.last),
            StatementKind::Run {
                file: None,
                line: None,
            } => self.system(SystemCall::Run, 0, 0),
            StatementKind::Run {
                file: None,
                line: Some(line),
            } => self.system(SystemCall::RunLine, line.number, 0),
            StatementKind::Run {
                file: Some(computed),
                line: None,
            } if self.type_of(computed) != Type::Text => {
                let line = self.number(computed)?.register;
                self.system(SystemCall::RunAt, line, 0);
            }
            StatementKind::Run {
                file: Some(file),
                line,
            } => {
                let name = self.text(file)?;
                match line {
                    Some(line) => self.system(SystemCall::RunFileLine, name, line.number),
                    None => self.system(SystemCall::RunFile, name, 0),
                }
            }
            StatementKind::Cont => self.system(SystemCall::Cont, 0, 0),
            StatementKind::Del(ranges) => {
                ranges
                    .iter()
                    .for_each(|range| self.system(SystemCall::Del, range.first, range.last));
            }
            StatementKind::Renum { start, increment } => {
                self.system(
                    SystemCall::Renum,
                    start.unwrap_or(10),
                    increment.unwrap_or(10),
                );
            }
            StatementKind::Auto { start, increment } => {
                self.system(
                    SystemCall::Auto,
                    start.unwrap_or(10),
                    increment.unwrap_or(10),
                );
            }
            StatementKind::Files(mask) => self.file_call(SystemCall::Files, mask.as_ref())?,
            StatementKind::Save(name) => self.file_call(SystemCall::Save, name.as_ref())?,
            StatementKind::Load(name) => self.file_call(SystemCall::Load, Some(name))?,
            StatementKind::Merge(name) => self.file_call(SystemCall::Merge, Some(name))?,
            StatementKind::Copy { from, to } => {
                let [from, to] = [self.text(from)?, self.text(to)?];
                self.system(SystemCall::Copy, from, to);
            }
            StatementKind::Erase(mask) => self.file_call(SystemCall::Erase, Some(mask))?,
            StatementKind::Format(disk) => self.file_call(SystemCall::Format, Some(disk))?,
            StatementKind::Password => self.system(SystemCall::Password, 0, 0),
            _ => {}
        }
        Ok(())
    }

    fn file_call(&mut self, call: SystemCall, name: Option<&Expr>) -> Result<(), Refusal> {
        let name = name.map(|name| self.text(name)).transpose()?;
        self.system(call, name.unwrap_or(ANY), 0);
        Ok(())
    }

    pub(super) fn plain(&mut self, code: Code) {
        self.emit(Op::new(code, 0, 0, 0));
        self.charge();
    }

    fn assign(&mut self, target: &Target, value: &Expr) -> Result<(), Refusal> {
        let place = self.place(target)?;
        match place {
            Place::Number {
                register,
                integer: false,
            } => self.number_into(value, register)?,
            Place::Number {
                register,
                integer: true,
            } => self.integer_into(value, register)?,
            Place::Text(place) => self.text_into(value, place)?,
            Place::Element {
                kind: VariableKind::String,
                ..
            } => {
                let text = self.text(value)?;
                self.store(&place, text);
            }
            Place::Element { .. } | Place::System(_) => {
                let number = self.number(value)?.register;
                self.store(&place, number);
            }
        }
        self.charge();
        Ok(())
    }

    /// Evaluates the subscripts of a target.
    fn place(&mut self, target: &Target) -> Result<Place, Refusal> {
        self.operands += 1;
        Ok(match target {
            Target::Variable(name) if name.kind == VariableKind::String => {
                Place::Text(self.symbols.string(name).map_err(at(Span::default()))?)
            }
            Target::Variable(name) => Place::Number {
                register: self.symbols.number(name).map_err(at(Span::default()))?,
                integer: name.kind == VariableKind::Integer,
            },
            Target::Element(name, subscripts) => {
                let (array, index) = self.element(name, subscripts)?;
                Place::Element {
                    array,
                    index,
                    kind: name.kind,
                }
            }
            Target::System(var) => Place::System(self.sysvar(*var)),
        })
    }

    /// Stores what stands in a register, or in a string for a string target.
    fn store(&mut self, place: &Place, from: u16) {
        let last = self.ops.last().copied();
        let op = match *place {
            Place::Number {
                register,
                integer: false,
            } => Op::new(Code::Move, from, 0, register),
            Place::Number {
                register,
                integer: true,
            } => Op::new(Code::ToInteger, from, 0, register),
            Place::Text(place) => Op::new(Code::StringMove, from, 0, place),
            Place::Element {
                array,
                index,
                kind: VariableKind::String,
            } => Op::new(Code::StringStore, array, index, from),
            // Nothing was evaluated since the subscript.
            Place::Element { array, index, .. }
                if let Some(found) = last
                    && found.code == Code::Index1
                    && found.c == index =>
            {
                self.ops.pop();
                Op::new(Code::StoreAt, array, found.b, from)
            }
            Place::Element { array, index, .. } => Op::new(Code::Store, array, index, from),
            Place::System(var) => Op::new(Code::SetSystem, var, from, 0),
        };
        self.emit(op);
    }

    fn print(&mut self, items: &[PrintItem], span: Span) -> Result<(), Refusal> {
        let mut open = false;
        for item in items {
            (self.number, self.string) = (0, 0);
            open = false;
            match item {
                PrintItem::Expr(expr) => match self.type_of(expr) {
                    Type::Text => {
                        let text = self.text(expr)?;
                        self.emit(Op::new(Code::PrintString, text, 0, 0));
                    }
                    _ => {
                        let number = self.printed_number(expr)?;
                        self.emit(Op::new(
                            Code::PrintNumber,
                            number.register,
                            u16::from(number.integer),
                            0,
                        ));
                    }
                },
                PrintItem::Comma => {
                    self.emit(Op::new(Code::PrintComma, 0, 0, 0));
                    open = true;
                }
                PrintItem::Semicolon => open = true,
                PrintItem::Tab(column) => {
                    let column = self.number(column)?.register;
                    self.emit(Op::new(Code::PrintTab, column, 0, 0));
                    open = true;
                }
                PrintItem::Spc(count) => {
                    let count = self.number(count)?.register;
                    self.emit(Op::new(Code::PrintSpaces, count, 0, 0));
                    open = true;
                }
            }
        }
        let _ = span;
        if open {
            // A semicolon leaves no operation of its own, and the last one must carry the cost.
            self.emit(Op::new(Code::Nothing, 0, 0, 0));
        } else {
            self.emit(Op::new(Code::PrintEnd, 0, 0, 0));
        }
        self.charge();
        Ok(())
    }

    fn input(
        &mut self,
        prompt: Option<&[u8]>,
        targets: &[Target],
        span: Span,
    ) -> Result<(), Refusal> {
        if self.direct {
            let cause = "INPUT works only in a program".to_owned();
            return Err(Refusal {
                error: ErrorCode::IllegalDirect,
                cause,
                span,
            });
        }
        let prompt = prompt
            .map(|text| self.symbols.text(text))
            .transpose()
            .map_err(at(span))?;
        let begin = self.emit(Op::jump(Code::Input, prompt.unwrap_or(ANY), 0));
        for target in targets {
            self.fetch(target, Code::InputNumber, Code::InputString)?;
        }
        self.emit(Op::new(Code::InputEnd, 0, 0, 0));
        self.land(begin);
        self.plain(Code::Nothing);
        Ok(())
    }

    fn read(&mut self, targets: &[Target]) -> Result<(), Refusal> {
        for target in targets {
            self.fetch(target, Code::ReadNumber, Code::ReadString)?;
        }
        self.charge();
        Ok(())
    }

    /// Gets a value from the console or from DATA and stores it.
    fn fetch(&mut self, target: &Target, number: Code, text: Code) -> Result<(), Refusal> {
        (self.number, self.string) = (0, 0);
        let place = self.place(target)?;
        let is_text = matches!(
            place,
            Place::Text(_)
                | Place::Element {
                    kind: VariableKind::String,
                    ..
                }
        );
        let (code, temporary) = if is_text {
            (text, self.string_temporary(Span::default())?)
        } else {
            (number, self.number_temporary(Span::default())?)
        };
        self.emit(Op::new(code, 0, 0, temporary));
        self.store(&place, temporary);
        Ok(())
    }

    fn dim(&mut self, arrays: &[(Name, Vec<Expr>)], span: Span) -> Result<(), Refusal> {
        for (name, sizes) in arrays {
            (self.number, self.string) = (0, 0);
            let array = self.symbols.array(name).map_err(at(span))?;
            let first = self.consecutive(sizes)?;
            let count = u16::try_from(sizes.len()).unwrap_or(u16::MAX);
            self.emit(Op::new(Code::Dim, array, first, count));
        }
        self.charge();
        Ok(())
    }
}
