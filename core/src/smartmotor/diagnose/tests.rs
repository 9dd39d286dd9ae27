use super::*;

/// Message and line of what is wrong.
fn found(text: &str) -> Vec<(u32, String)> {
    let found = diagnose(text).into_iter();
    found.map(|found| (found.line, found.message)).collect()
}

#[test]
fn every_error_of_the_compiler_has_its_name_and_line() {
    for (text, line, name) in [
        ("C1\nC1\nEND", 1, "duplicate label C1"),
        ("GOTO5\nEND", 0, "missing label C5"),
        ("a=1\nGOSUB7\nEND", 1, "missing label C7"),
        ("SWITCH a\nDEFAULT\nDEFAULT\nENDS\nEND", 2, "second DEFAULT"),
        (
            "SWITCH a\nDEFAULT\nCASE 1\nENDS\nEND",
            2,
            "CASE after DEFAULT",
        ),
        ("BREAK\nEND", 0, "BREAK outside WHILE and SWITCH"),
        ("IF a BREAK ENDIF\nEND", 0, "BREAK outside WHILE and SWITCH"),
        ("IF a\nELSE\nELSEIF b\nENDIF\nEND", 2, "ELSEIF after ELSE"),
        ("IF a\nELSE\nELSE\nENDIF\nEND", 2, "ELSE after ELSE"),
        ("a=1\nb=2", 1, "missing END"),
        ("a=1\nIF a\nb=1\nEND", 1, "missing ENDIF"),
        ("WHILE 1\nEND", 0, "missing LOOP"),
        ("SWITCH a\nCASE 1\nEND", 0, "missing ENDS"),
        ("WHILE 1\nIF a\nLOOP\nEND", 1, "missing ENDIF"),
        ("LOOP\nEND", 0, "LOOP without WHILE"),
        ("ENDIF\nEND", 0, "ENDIF without IF"),
        ("CASE 1\nEND", 0, "CASE without SWITCH"),
        ("ENDS\nEND", 0, "ENDS without SWITCH"),
        ("a=1\nLOAD\nEND", 1, "LOAD in a program"),
        ("UPLOAD\nEND", 0, "UPLOAD in a program"),
        ("UP\nEND", 0, "UP in a program"),
        ("a=b/0\nEND", 0, "division by zero"),
        ("a==1\nEND", 0, "syntax error"),
        ("C1000\nEND", 0, "syntax error"),
        ("FOO\nEND", 0, "syntax error"),
    ] {
        assert_eq!(found(text), [(line, name.to_owned())], "{text}");
    }
    assert_eq!(found("WHILE 1 BREAK LOOP C1 GOSUB1 END"), []);
}

#[test]
fn causes_and_cures_are_plain() {
    let one = diagnose("a=b +1\nEND");
    assert_eq!(one.len(), 1);
    let cure = one[0].cure.clone().unwrap();
    assert_eq!(
        (one[0].line, cure.span, cure.replacement.as_str()),
        (0, Span { start: 3, end: 4 }, "")
    );
    assert_eq!(found("a=b + c\nEND"), [(0, "syntax error".to_owned())]);
    let found = diagnose("a=b+c+d END");
    assert_eq!(found[0].cause, "An expression has at most one operator.");
    let found = diagnose("WHILE 1 \u{2018}always\nLOOP END");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].cure.as_ref().unwrap().replacement, "'");
}

#[test]
fn a_program_that_is_too_long_is_told() {
    // Nothing else is said of it, and that at once.
    for text in ["a=1\n", "IF 1 BREAK ", "WHILE 1 ELSE "] {
        let text = text.repeat(200_000);
        assert_eq!(found(&text), [(0, "program too long".to_owned())]);
    }
    let deep = "IF 1 ".repeat(6000);
    assert_eq!(found(&deep).len(), 6001);
}

#[test]
fn colours_follow_the_lexer() {
    use HighlightClass::*;
    let classes = |line: &str| -> Vec<HighlightClass> {
        highlight(line).into_iter().map(|part| part.class).collect()
    };
    assert_eq!(
        classes("WHILE a<10 'x"),
        [Keyword, Variable, Operator, Number, Comment]
    );
    assert_eq!(
        classes("GOSUB5 C5 V=1000 IF Bt"),
        [
            Keyword,
            Keyword,
            Function,
            Operator,
            Number,
            Keyword,
            SystemVariable
        ]
    );
    assert_eq!(
        classes("PRINT(\"a\",#13) $"),
        [
            Function, Operator, Text, Operator, Operator, Number, Operator, Error
        ]
    );
}
