//! The forms and examples of the manual, keyword by keyword, and what goes wrong.

mod examples;
mod faults;
mod forms;
mod properties;

use super::parse_line;
use crate::language::latin1;
use crate::mc600::ast::{
    Expr, ExprKind, LineRange, PrintItem, Statement, StatementKind, Target, UnaryOp,
};

/// Parses a line and compares what it says, statements separated by ` | `.
pub(super) fn check(line: &str, expected: &str) {
    assert_eq!(show_line(line.as_bytes()), expected, "{line}");
}

/// What a line says, in prefix form.
pub(crate) fn show_line(line: &[u8]) -> String {
    statements(&parse_line(line).statements)
}

fn statements(list: &[Statement]) -> String {
    let shown: Vec<String> = list.iter().map(|one| statement(&one.kind)).collect();
    shown.join(" | ")
}

fn statement(kind: &StatementKind) -> String {
    use StatementKind as K;
    match kind {
        K::Malformed(bad) => format!("?{}: {}", bad.error.text(), bad.cause),
        K::NotImplemented(keyword) => format!("absent {}", keyword.word()),
        K::Let { target, value } => format!("{} := {}", place(target), expr(value)),
        K::Print(items) => format!("print{}", joined(items, print_item)),
        K::Input { prompt, targets } => {
            let prompt = prompt
                .as_ref()
                .map(|text| format!(" {:?}", latin1::text(text)));
            format!(
                "input{}{}",
                prompt.unwrap_or_default(),
                joined(targets, place)
            )
        }
        K::Goto(line) => format!("goto {}", line.number),
        K::Gosub(line) => format!("gosub {}", line.number),
        K::On {
            selector,
            gosub,
            lines,
        } => {
            let word = if *gosub { "gosub" } else { "goto" };
            format!(
                "on {} {word}{}",
                expr(selector),
                joined(lines, |line| line.number.to_string())
            )
        }
        K::If {
            condition,
            then,
            otherwise,
        } => {
            let otherwise = otherwise
                .as_ref()
                .map(|list| format!(" else {{{}}}", statements(list)));
            format!(
                "if {} {{{}}}{}",
                expr(condition),
                statements(then),
                otherwise.unwrap_or_default()
            )
        }
        K::For {
            variable,
            start,
            limit,
            step,
        } => {
            let step = step.as_ref().map(|step| format!(" step {}", expr(step)));
            let (start, limit) = (expr(start), expr(limit));
            format!(
                "for {} {start} to {limit}{}",
                variable.text,
                step.unwrap_or_default()
            )
        }
        K::Next(names) => format!("next{}", joined(names, |name| name.text.to_string())),
        K::While(condition) => format!("while{}", joined(condition.as_slice(), expr)),
        K::Whend(condition) => format!("whend{}", joined(condition.as_slice(), expr)),
        K::Data(items) => {
            format!(
                "data{}",
                joined(items, |item| format!(
                    "{}{:?}",
                    if item.quoted { "q" } else { "" },
                    latin1::text(&item.text)
                ))
            )
        }
        K::Read(targets) => format!("read{}", joined(targets, place)),
        K::Dim(arrays) => format!(
            "dim{}",
            joined(arrays, |(name, sizes)| format!(
                "{}[{}]",
                name.text,
                list(sizes)
            ))
        ),
        K::List(lines) => format!("list {}", range(lines)),
        K::Run { file, line } => {
            let line = line.map(|line| format!(" at {}", line.number));
            format!(
                "run{}{}",
                joined(file.as_slice(), expr),
                line.unwrap_or_default()
            )
        }
        K::Del(ranges) => format!("del{}", joined(ranges, range)),
        K::Renum { start, increment } => format!("renum {start:?} {increment:?}"),
        K::Auto { start, increment } => format!("auto {start:?} {increment:?}"),
        K::Files(mask) => format!("files{}", joined(mask.as_slice(), expr)),
        K::Save(name) => format!("save{}", joined(name.as_slice(), expr)),
        K::Load(name) => format!("load {}", expr(name)),
        K::Merge(name) => format!("merge {}", expr(name)),
        K::Copy { from, to } => format!("copy {} to {}", expr(from), expr(to)),
        K::Erase(mask) => format!("erase {}", expr(mask)),
        K::Format(disk) => format!("format {}", expr(disk)),
        K::Call { keyword, arguments } => format!("call {}({})", keyword.word(), list(arguments)),
        K::Return
        | K::Reti
        | K::Rem
        | K::Restore
        | K::End
        | K::Stop
        | K::New
        | K::Cont
        | K::Password => format!("{kind:?}").to_lowercase(),
    }
}

fn joined<T>(items: &[T], show: impl Fn(&T) -> String) -> String {
    items
        .iter()
        .map(|item| format!(" {}", show(item)))
        .collect()
}

fn list(items: &[Expr]) -> String {
    items.iter().map(expr).collect::<Vec<_>>().join(",")
}

fn range(lines: &LineRange) -> String {
    format!("{}..{}", lines.first, lines.last)
}

fn print_item(item: &PrintItem) -> String {
    match item {
        PrintItem::Expr(value) => expr(value),
        PrintItem::Comma => ",".into(),
        PrintItem::Semicolon => ";".into(),
        PrintItem::Tab(column) => format!("tab({})", expr(column)),
        PrintItem::Spc(count) => format!("spc({})", expr(count)),
    }
}

fn place(target: &Target) -> String {
    match target {
        Target::Variable(name) => name.text.to_string(),
        Target::Element(name, subscripts) => format!("{}[{}]", name.text, list(subscripts)),
        Target::System(variable) => format!("system {}", variable.word()),
    }
}

fn expr(value: &Expr) -> String {
    match &value.kind {
        ExprKind::Integer(value) => value.to_string(),
        ExprKind::Real(value) => format!("{value:?}r"),
        ExprKind::Text(text) => format!("{:?}", latin1::text(text)),
        ExprKind::Variable(name) => name.text.to_string(),
        ExprKind::Element(name, subscripts) => format!("{}[{}]", name.text, list(subscripts)),
        ExprKind::System(variable) => format!("system {}", variable.word()),
        ExprKind::Unary(UnaryOp::Negate, operand) => format!("(neg {})", expr(operand)),
        ExprKind::Unary(UnaryOp::Not, operand) => format!("(not {})", expr(operand)),
        ExprKind::Binary(operator, left, right) => {
            format!(
                "({} {} {})",
                format!("{operator:?}").to_lowercase(),
                expr(left),
                expr(right)
            )
        }
        ExprKind::Call(function, arguments) => {
            format!(
                "{}({})",
                format!("{function:?}").to_lowercase(),
                list(arguments)
            )
        }
    }
}
