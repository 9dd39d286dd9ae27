//! What directs the program: structures, labels, jumps, calls, waits.

use std::collections::btree_map::Entry;

use super::super::ast::{Expr, LineCommand, Operator, Statement, StatementKind};
use super::super::code::{Code, LOOP_AND_WHILE, Op, Slow, TEMPORARY};
use super::{At, Compiler};

/// A structure that has not been ended.
pub(super) struct Open {
    at: At,
    kind: Kind,
    /// Jumps to behind the structure.
    ends: Vec<usize>,
}

enum Kind {
    While {
        top: u16,
    },
    If {
        /// The jump that leaves the last condition if it does not hold.
        unless: Option<usize>,
        otherwise: bool,
    },
    Switch {
        /// The jump to where the cases are told apart.
        choice: usize,
        cases: Vec<(Expr, u16)>,
        default: Option<u16>,
    },
}

impl Kind {
    /// What is missing if it is not ended.
    fn end(&self) -> &'static str {
        match self {
            Kind::While { .. } => "LOOP",
            Kind::If { .. } => "ENDIF",
            Kind::Switch { .. } => "ENDS",
        }
    }

    fn begin(&self) -> &'static str {
        match self {
            Kind::While { .. } => "WHILE",
            Kind::If { .. } => "IF",
            Kind::Switch { .. } => "SWITCH",
        }
    }
}

impl Compiler {
    pub(super) fn in_program(&mut self, statement: &Statement) {
        use StatementKind as S;
        let at = self.place;
        match &statement.kind {
            S::Malformed(bad) => {
                self.problems.push(super::Problem {
                    line: at.line,
                    span: bad.span,
                    name: "syntax error".to_owned(),
                    cause: bad.cause.clone(),
                    cure: bad.cure.clone(),
                });
                self.raise();
            }
            S::Label(label) => self.label(*label),
            S::Goto(label) => self.jump(Code::Jump, *label),
            S::Gosub(label) => self.jump(Code::Gosub, *label),
            S::Return => self.simple(Code::Return),
            S::RunIfAsked => self.special(Slow::RunIfAsked, 0),
            S::End => self.special(Slow::End, 0),
            S::WaitForTrajectory => self.special(Slow::WaitForTrajectory, 0),
            S::Wait(expr) => {
                let register = self.value(expr, None);
                self.special(Slow::Wait, register);
            }
            S::While(expr) => {
                let top = self.target();
                let exit = self.unless(expr);
                let ends = vec![exit];
                self.open(Kind::While { top }, ends);
            }
            S::If(expr) => {
                let unless = Some(self.unless(expr));
                let otherwise = false;
                self.open(Kind::If { unless, otherwise }, Vec::new());
            }
            S::Switch(expr) => {
                let register = self.value(expr, Some(TEMPORARY));
                if register != TEMPORARY {
                    self.emit(Code::Move, register, 0, TEMPORARY);
                }
                let choice = self.emit(Code::Jump, 0, 0, 0);
                self.charge();
                let kind = Kind::Switch {
                    choice,
                    cases: Vec::new(),
                    default: None,
                };
                self.open(kind, Vec::new());
            }
            S::ElseIf(_) | S::Else => self.branch(&statement.kind),
            S::Case(_) | S::Default => self.case(&statement.kind),
            S::Break => self.leave(),
            S::Loop => self.close("WHILE"),
            S::EndIf => self.close("IF"),
            S::EndSwitch => self.close("SWITCH"),
            S::Line(LineCommand::Load) => self.host_only("LOAD"),
            S::Line(LineCommand::Upload { compiled: true }) => self.host_only("UP"),
            S::Line(LineCommand::Upload { compiled: false }) => self.host_only("UPLOAD"),
            other => {
                self.both(other);
            }
        }
    }

    /// The end of the text.
    pub(super) fn finish(&mut self, ended: bool) {
        while let Some(open) = self.open.last() {
            let (at, begin, end) = (open.at, open.kind.begin(), open.kind.end());
            let cause = format!("No {end} ends this {begin}.");
            self.problem(at, format!("missing {end}"), cause);
            self.ended();
        }
        for (op, label, at) in std::mem::take(&mut self.jumps) {
            let target = self.labels.get(&label).copied();
            match (
                target.and_then(|t| u16::try_from(t).ok()),
                self.ops.get_mut(op),
            ) {
                (Some(target), Some(op)) => op.c = target,
                (None, Some(op)) => {
                    // Sets Bs and goes on.
                    (op.code, op.a) = (
                        Code::Slow,
                        u16::try_from(self.slow.len()).unwrap_or(u16::MAX),
                    );
                    self.slow
                        .push(Slow::Raise(super::super::motor::Flag::Syntax));
                    let cause = format!("There is no label C{label}.");
                    self.problem(at, format!("missing label C{label}"), cause);
                }
                (_, None) => {}
            }
        }
        let last = self.last;
        if !ended {
            let cause = "A program has an END, where it stops.";
            self.problem(last, "missing END", cause);
        }
        self.special(Slow::End, 0);
    }

    fn simple(&mut self, code: Code) {
        self.emit(code, 0, 0, 0);
        self.charge();
    }

    fn special(&mut self, slow: Slow, register: u16) {
        self.slow(slow, register, 0);
        self.charge();
    }

    fn host_only(&mut self, word: &str) {
        let at = self.place;
        let cause = format!("{word} is for the host alone.");
        self.problem(at, format!("{word} in a program"), cause);
        self.raise();
    }

    fn label(&mut self, label: u16) {
        let here = self.here();
        match self.labels.entry(label) {
            Entry::Vacant(entry) => {
                entry.insert(here);
            }
            Entry::Occupied(_) => {
                let at = self.place;
                let cause = format!("C{label} stands at an earlier place, too.");
                self.problem(at, format!("duplicate label C{label}"), cause);
            }
        }
    }

    fn jump(&mut self, code: Code, label: u16) {
        let op = self.emit(code, 0, 0, 0);
        self.charge();
        self.jumps.push((op, label, self.place));
    }

    /// Jumps away unless the expression holds; the jump's target is set later.
    fn unless(&mut self, expr: &Expr) -> usize {
        let comparison = expr.rest.and_then(|(operator, right)| {
            let (code, swapped) = match operator {
                Operator::Equal => (Code::JumpIfNotEqual, false),
                Operator::NotEqual => (Code::JumpIfEqual, false),
                Operator::Less => (Code::JumpIfLessEqual, true),
                Operator::LessEqual => (Code::JumpIfLess, true),
                Operator::Greater => (Code::JumpIfLessEqual, false),
                Operator::GreaterEqual => (Code::JumpIfLess, false),
                _ => return None,
            };
            Some((code, swapped, right))
        });
        let op = match comparison {
            Some((code, swapped, right)) => {
                let left = self.operand(expr.left, TEMPORARY);
                let right = self.operand(right, TEMPORARY + 1);
                match swapped {
                    false => self.emit(code, left, right, 0),
                    true => self.emit(code, right, left, 0),
                }
            }
            None => {
                let register = self.value(expr, None);
                self.emit(Code::JumpIfZero, register, 0, 0)
            }
        };
        self.charge();
        op
    }

    fn open(&mut self, kind: Kind, ends: Vec<usize>) {
        let at = self.place;
        self.open.push(Open { at, kind, ends });
    }

    /// The jump goes to the next operation.
    fn land(&mut self, jump: usize) {
        let target = self.target();
        if let Some(op) = self.ops.get_mut(jump) {
            op.c = target;
        }
    }

    /// Ends the innermost structure.
    fn ended(&mut self) {
        let Some(open) = self.open.pop() else { return };
        match open.kind {
            Kind::While { top } => {
                // A condition of one operation is tested here: a jump less a repetition.
                let condition = self.ops.get(usize::from(top)).copied();
                let again = condition.and_then(|op| op.opposite(top.saturating_add(1)));
                match again {
                    Some(op) => self.ops.push(Op {
                        cost: LOOP_AND_WHILE,
                        ..op
                    }),
                    None => {
                        self.emit(Code::Jump, 0, 0, top);
                        self.charge();
                    }
                }
            }
            Kind::If { unless, .. } => {
                if let Some(unless) = unless {
                    self.land(unless);
                }
            }
            Kind::Switch {
                choice,
                cases,
                default,
            } => {
                let behind = self.emit(Code::Jump, 0, 0, 0);
                self.land(choice);
                for (expr, target) in cases {
                    let register = self.case_value(&expr);
                    let skip = self.emit(Code::JumpIfNotEqual, TEMPORARY, register, 0);
                    self.emit(Code::Jump, 0, 0, target);
                    self.land(skip);
                }
                if let Some(target) = default {
                    self.emit(Code::Jump, 0, 0, target);
                }
                self.land(behind);
            }
        }
        for jump in open.ends {
            self.land(jump);
        }
    }

    /// The value of a CASE, beside that of the SWITCH in the first temporary.
    fn case_value(&mut self, expr: &Expr) -> u16 {
        if expr.rest.is_none() {
            return self.operand(expr.left, TEMPORARY + 3);
        }
        self.emit(Code::Move, TEMPORARY, 0, TEMPORARY + 4);
        self.value(expr, Some(TEMPORARY + 3));
        self.emit(Code::Move, TEMPORARY + 4, 0, TEMPORARY);
        TEMPORARY + 3
    }

    /// Ends structures that stand open inside the one that `begin` has begun; `false` if there is none.
    fn back_to(&mut self, begin: &'static str) -> bool {
        if !self.open.iter().any(|open| open.kind.begin() == begin) {
            return false;
        }
        while let Some(open) = self.open.last() {
            if open.kind.begin() == begin {
                break;
            }
            let (at, inner, end) = (open.at, open.kind.begin(), open.kind.end());
            let cause = format!("No {end} ends this {inner}.");
            self.problem(at, format!("missing {end}"), cause);
            self.ended();
        }
        true
    }

    fn close(&mut self, begin: &'static str) {
        let end = match begin {
            "WHILE" => "LOOP",
            "IF" => "ENDIF",
            _ => "ENDS",
        };
        if self.back_to(begin) {
            self.ended();
        } else {
            self.outside(end, begin);
        }
    }

    fn outside(&mut self, word: &str, begin: &str) {
        let at = self.place;
        let cause = format!("No {begin} is open where this {word} stands.");
        self.problem(at, format!("{word} without {begin}"), cause);
        self.raise();
    }

    /// ELSEIF, ELSE.
    fn branch(&mut self, kind: &StatementKind) {
        let word = match kind {
            StatementKind::Else => "ELSE",
            _ => "ELSEIF",
        };
        if !self.back_to("IF") {
            self.outside(word, "IF");
            return;
        }
        let behind = self.emit(Code::Jump, 0, 0, 0);
        let place = self.place;
        let Some(Open {
            kind: Kind::If { unless, otherwise },
            ends,
            ..
        }) = self.open.last_mut()
        else {
            return;
        };
        ends.push(behind);
        let (landing, again) = (unless.take(), *otherwise);
        *otherwise |= word == "ELSE";
        if let Some(landing) = landing {
            self.land(landing);
        }
        if again {
            let cause = "ELSE is the last branch of an IF.";
            self.problem(place, format!("{word} after ELSE"), cause);
        }
        if let StatementKind::ElseIf(expr) = kind {
            let jump = self.unless(expr);
            if let Some(Open {
                kind: Kind::If { unless, .. },
                ..
            }) = self.open.last_mut()
            {
                *unless = Some(jump);
            }
        }
    }

    /// CASE, DEFAULT.
    fn case(&mut self, kind: &StatementKind) {
        let word = match kind {
            StatementKind::Case(_) => "CASE",
            _ => "DEFAULT",
        };
        if !self.back_to("SWITCH") {
            self.outside(word, "SWITCH");
            return;
        }
        let (here, at) = (self.target(), self.place);
        let Some(Open {
            kind: Kind::Switch { cases, default, .. },
            ..
        }) = self.open.last_mut()
        else {
            return;
        };
        let late = default.is_some();
        match kind {
            StatementKind::Case(expr) => {
                cases.push((*expr, here));
                if late {
                    let cause = "DEFAULT covers every other value: it stands last.";
                    self.problem(at, "CASE after DEFAULT", cause);
                }
            }
            _ if late => {
                let cause = "A SWITCH has one DEFAULT.";
                self.problem(at, "second DEFAULT", cause);
            }
            _ => *default = Some(here),
        }
    }

    /// BREAK.
    fn leave(&mut self) {
        let jump = self.emit(Code::Jump, 0, 0, 0);
        self.charge();
        let inner = self
            .open
            .iter_mut()
            .rev()
            .find(|open| !matches!(open.kind, Kind::If { .. }));
        match inner {
            Some(open) => open.ends.push(jump),
            None => {
                self.ops.pop();
                let at = self.place;
                let cause = "BREAK leaves a WHILE or a SWITCH, and none is open here.";
                self.problem(at, "BREAK outside WHILE and SWITCH", cause);
                self.raise();
            }
        }
    }
}
