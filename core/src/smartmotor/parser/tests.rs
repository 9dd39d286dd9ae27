use super::super::ast::{
    Array, Expr, Index, LineCommand, Operand, Operator, Place, Report, Source, StatementKind,
    Target,
};
use super::super::motor::{Command, Register};
use super::parse_line;

fn kinds(line: &str) -> Vec<StatementKind> {
    let parsed = parse_line(line.as_bytes(), None);
    parsed.statements.into_iter().map(|s| s.kind).collect()
}

fn one(line: &str) -> StatementKind {
    let mut kinds = kinds(line);
    assert_eq!(kinds.len(), 1, "{line}: {kinds:?}");
    kinds.remove(0)
}

fn cause(line: &str) -> String {
    for kind in kinds(line) {
        if let StatementKind::Malformed(malformed) = kind {
            return malformed.cause;
        }
    }
    String::new()
}

const A: Operand = Operand::Place(Place::Variable(0));
const B: Operand = Operand::Place(Place::Variable(1));

#[test]
fn a_line_holds_several_commands() {
    use StatementKind as S;
    let assign =
        |register, value| S::Assign(Target::Register(register), Operand::Number(value).into());
    assert_eq!(
        kinds("A=100 V=-200  MV G 'go"),
        [
            assign(Register::Acceleration, 100),
            assign(Register::Velocity, -200),
            S::Motor(Command::from_word("MV").unwrap()),
            S::Motor(Command::Go)
        ]
    );
    assert_eq!(kinds("C5 RETURN"), [S::Label(5), S::Return]);
}

#[test]
fn an_expression_is_one_value_or_two() {
    let variable = Target::Place(Place::Variable(0));
    for (line, left, rest) in [
        ("a=b", B, None),
        ("a=b+a", B, Some((Operator::Add, A))),
        ("a=-5", Operand::Number(-5), None),
        ("a=b*-5", B, Some((Operator::Multiply, Operand::Number(-5)))),
        ("a=-b", Operand::Number(0), Some((Operator::Subtract, B))),
        ("a = b", B, None),
        ("a 7", Operand::Number(7), None),
        ("a -7", Operand::Number(-7), None),
        (
            "a=@P>=100",
            Operand::Source(Source::Register(Register::ActualPosition)),
            Some((Operator::GreaterEqual, Operand::Number(100))),
        ),
        ("a=-2147483648", Operand::Number(i32::MIN), None),
    ] {
        let expr = Expr { left, rest };
        assert_eq!(one(line), StatementKind::Assign(variable, expr), "{line}");
    }
    assert_eq!(cause("a=b+c+d"), "An expression has at most one operator.");
    assert!(cause("a=b +c").starts_with("An expression ends with a blank"));
    assert_eq!(cause("a=2147483648"), "A number has at most 32 bits.");
    assert_eq!(cause("a=1b=2"), "A command ends with a blank.");
}

#[test]
fn indices_are_a_number_a_variable_or_two() {
    for (text, index) in [
        ("7", Index::Number(7)),
        ("b", Index::Variable(1)),
        ("a+b", Index::Sum(0, 1)),
        ("a-b", Index::Difference(0, 1)),
    ] {
        let place = Place::Element(Array::Words, index);
        let report = Report::Value(Operand::Place(place));
        assert_eq!(one(&format!("Raw[{text}]")), StatementKind::Report(report));
    }
    for bad in [
        "aw[aa]=1",
        "aw[a*b]=1",
        "aw[a+1]=1",
        "aw[=1",
        "aw=1",
        "abc=1",
    ] {
        assert!(!cause(bad).is_empty(), "{bad}");
    }
}

#[test]
fn numbers_in_sequence_end_with_a_period() {
    assert_eq!(
        one("aw[t] 63 44 -98."),
        StatementKind::Fill {
            array: Array::Words,
            index: Index::Variable(19),
            values: vec![63, 44, -98]
        }
    );
    assert!(cause("aw[t] 63 44").contains("period"));
}

#[test]
fn words_with_numbers_are_checked() {
    assert_eq!(one("GOTO999"), StatementKind::Goto(999));
    assert_eq!(
        one("SADDR100"),
        StatementKind::Line(LineCommand::Address(100))
    );
    for bad in [
        "GOTO", "GOTO1000", "C", "GOSUBa", "SADDR101", "BAUD123", "GOTO 5",
    ] {
        assert!(!cause(bad).is_empty(), "{bad}");
    }
}

#[test]
fn what_a_host_may_still_be_typing_is_unfinished() {
    let unfinished = |line: &str| match kinds(line).pop() {
        Some(StatementKind::Malformed(malformed)) => malformed.unfinished,
        _ => false,
    };
    for line in [
        "a",
        "a=",
        "a=b+",
        "P",
        "aw[t]",
        "aw[t] 63",
        "WAIT",
        "PRINT(\"a",
        "PRINT(a,",
        "IF",
        "VST(a",
    ] {
        assert!(unfinished(line), "{line}");
    }
    for line in ["FOO", "a=1", "RP", "a]", "GOTO", "G"] {
        assert!(!unfinished(line), "{line}");
    }
}

#[test]
fn a_missing_word_is_unknown() {
    let parsed = parse_line(b"a=b+1 G", Some("+"));
    let malformed = |kind: &StatementKind| matches!(kind, StatementKind::Malformed(_));
    assert!(malformed(&parsed.statements[0].kind));
    assert!(!malformed(&parsed.statements.last().unwrap().kind));
}
