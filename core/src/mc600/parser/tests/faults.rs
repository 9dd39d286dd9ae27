//! What cannot be understood: the device's error and a plain cause, and nothing that follows is lost.

use super::{check, show_line};
use crate::language::Span;
use crate::mc600::ast::StatementKind;
use crate::mc600::firmware::ErrorCode;
use crate::mc600::parser::{parse_line, parse_statements};

#[test]
fn statements() {
    for (text, cause) in [
        ("X", "An equal sign should stand here."),
        ("X=", "A value should stand here."),
        ("X=5 6", "A colon or the end of the line should stand here."),
        (": 5", "A statement should stand here."),
        ("\"A\"", "A statement should stand here."),
        ("(A)=5", "A statement should stand here."),
        (
            "SIN(5)",
            "SIN gives a value: something must be done with it.",
        ),
        ("AND", "AND cannot begin a statement."),
        ("THEN 10", "THEN cannot begin a statement."),
        ("ELSE 10", "ELSE without an IF before it on the line."),
        (
            "PRINT 1 ELSE 10",
            "ELSE without an IF before it on the line.",
        ),
        ("IF A PRINT 1", "THEN or GOTO should stand here."),
        (
            "COPY \"A\"",
            "A comma and the name of the copy should stand here.",
        ),
        ("ERASE", "The files or the disk should stand here."),
        ("FORMAT", "The files or the disk should stand here."),
        ("IF THEN 10", "A value should stand here."),
        ("GOTO X", "A line number should stand here."),
        ("GOTO 64000", "A line number is a whole number up to 63999."),
        ("GOTO 1.5", "A line number is a whole number up to 63999."),
        ("GOTO &H10", "A line number is a whole number up to 63999."),
        (
            "GOTO 10,20",
            "A colon or the end of the line should stand here.",
        ),
        ("ON X PRINT", "GOTO or GOSUB should stand here."),
        ("ON X GOTO 10,A", "A line number should stand here."),
        ("FOR A(1)=1 TO 2", "A loop counts with a simple variable."),
        ("FOR MRES%=1 TO 2", "A simple variable should stand here."),
        ("FOR I=1", "TO should stand here."),
        ("NEXT 5", "A simple variable should stand here."),
        (
            "INPUT \"A\",B",
            "A semicolon should stand between prompt and variable.",
        ),
        ("INPUT", "A variable should stand here."),
        ("READ 5", "A variable should stand here."),
        (
            "DIM A",
            "The array's size in parentheses should stand here.",
        ),
        ("DIM", "An array's name should stand here."),
        ("DEL", "A line number should stand here."),
        ("DEL -", "A line number should stand here."),
        ("LOAD", "A value should stand here."),
        (
            "RETURN 5",
            "A colon or the end of the line should stand here.",
        ),
        ("GV_FEEDBACK%=0", "GV_FEEDBACK% can only be read."),
        ("INPUT GV_IN1%", "GV_IN1% can only be read."),
        (
            "SCORE=1",
            "The name SCORE has the keyword OR in it; a name must not.",
        ),
        (
            "IFBTHEN10",
            "The name BTHEN10 has the keyword THEN in it; a name must not.",
        ),
        (
            "MYCHR$=A$",
            "The name MYCHR$ has the keyword CHR$ in it; a name must not.",
        ),
        (
            "CAMTAB(1)=5",
            "The name CAMTAB has the keyword TAB in it; a name must not.",
        ),
        (
            "GV_INX%=1",
            "There is no system variable GV_INX%, and other names have letters and digits only.",
        ),
        ("PRINT 5 !", "`!` means nothing outside a string."),
        ("PRINT {x}", "`{` means nothing outside a string."),
        (
            "PRINT &5",
            "`&` begins a hexadecimal number, which goes on with H and digits.",
        ),
        ("PRINT (5", "A closing parenthesis is missing."),
        ("PRINT 5)", "A value should stand here."),
        (
            "PRINT ABS()",
            "Wrong number of arguments: it is written ABS(number).",
        ),
        (
            "PRINT LEFT$(A$)",
            "Wrong number of arguments: it is written LEFT$(string,count).",
        ),
        (
            "PRINT MID$(A$,1,2,3)",
            "Wrong number of arguments: it is written MID$(string,start[,count]).",
        ),
        ("PRINT ABS 5", "An opening parenthesis should stand here."),
        (
            "X=VALUE",
            "An opening parenthesis should stand here. VALUE is read as VAL UE: a name must not begin with a keyword.",
        ),
        (
            "MMOVE()",
            "Wrong number of arguments: it is written MMOVE(position).",
        ),
        (
            "MDRVEN(1)",
            "Wrong number of arguments: it is written MDRVEN().",
        ),
    ] {
        check(text, &format!("?SYNTAX: {cause}"));
    }
}

#[test]
fn other_errors_of_constants_and_expressions() {
    for (text, expected) in [
        (
            "X=1E39",
            "?OVERFLOW: The number 1E39 is too large: 1.70141183E+38 is the limit.",
        ),
        (
            "X=&H123456789",
            "?OVERFLOW: The number &H123456789 is too large: 1.70141183E+38 is the limit.",
        ),
        (
            "A(1,2,3,4,5)=1",
            "?BAD SUBSCRIPT: An array has at most 4 subscripts.",
        ),
        ("X=((((((((((1))))))))))", "X := 1"),
        (
            "X=(((((((((((1)))))))))))",
            "?FORMULA TOO COMPLEX: Parentheses nest deeper than 10.",
        ),
        (
            "X=ABS(A(ABS(A(ABS(A(ABS(A(ABS(A((1)))))))))))",
            "?FORMULA TOO COMPLEX: Parentheses nest deeper than 10.",
        ),
    ] {
        check(text, expected);
    }
}

#[test]
fn what_does_not_work_says_so_whatever_it_is_written_with() {
    for (text, word) in [
        ("FCLOSE FHNDL1%", "FCLOSE"),
        ("CLOSE FHNDL1%", "FCLOSE"),
        ("FILE1% = OPEN \"MATRIX.TXT\"", "OPEN"),
        ("GET A$", "GET"),
        ("GOTOXY 50, 10", "GOTOXY"),
        ("INPUT#1,AA,BB,CC", "INPUT"),
        ("PRINT#1,A", "PRINT"),
    ] {
        check(text, &format!("absent {word}"));
        check(
            &format!("PRINT 1: {text}: PRINT 2"),
            &format!("print 1 | absent {word} | print 2"),
        );
    }
    check("CLOSE=5: PRINT CLOSE", "CLOSE := 5 | print CLOSE");
}

#[test]
fn the_fault_is_placed_and_the_next_statement_stands() {
    let parsed = parse_line(b"10 PRINT 1: X=(2+: GOTO 5");
    let shown = "print 1 | ?SYNTAX: A value should stand here. | goto 5";
    assert_eq!(show_line(b"10 PRINT 1: X=(2+: GOTO 5"), shown);
    let StatementKind::Malformed(bad) = &parsed.statements[1].kind else {
        unreachable!("{parsed:?}");
    };
    assert_eq!(
        bad.span,
        Span::new(17, 18),
        "the colon, where a value is wanted"
    );
    assert_eq!(parsed.statements[1].span, Span::new(12, 17));
    assert_eq!((parsed.number, parsed.body), (Ok(Some(10)), 2));

    let parsed = parse_line(b"X=ABS(Y");
    let StatementKind::Malformed(bad) = &parsed.statements[0].kind else {
        unreachable!("{parsed:?}");
    };
    let cure = bad.cure.as_ref().unwrap();
    assert_eq!(
        (cure.span, cure.replacement.as_str()),
        (Span::new(7, 7), ")")
    );
}

#[test]
fn line_numbers() {
    for (line, number, body) in [
        ("10 PRINT", Ok(Some(10)), 2),
        ("  0010PRINT", Ok(Some(10)), 6),
        ("63999", Ok(Some(63999)), 5),
        ("64000 PRINT", Err(ErrorCode::Syntax), 5),
        ("99999999999999999999 END", Err(ErrorCode::Syntax), 20),
        ("PRINT", Ok(None), 0),
        (" PRINT", Ok(None), 1),
        ("0 END", Ok(Some(0)), 1),
    ] {
        let parsed = parse_line(line.as_bytes());
        assert_eq!((parsed.number, parsed.body), (number, body), "{line}");
    }
}

#[test]
fn endless_text_nests_no_deeper_than_a_line() {
    for part in [
        "(",
        "-",
        "NOT ",
        "IF A THEN ",
        "ABS(",
        "A(",
        "1+",
        "1^-",
        "ELSE ",
        "\"",
        "GOTO 1:",
        "2*NOT ",
    ] {
        let long = part.repeat(65_536 / part.len());
        assert_eq!(parse_statements(long.as_bytes(), None).len(), 1, "{part}");
        let most = part.repeat(255 / part.len());
        parse_statements(most.as_bytes(), None);
        parse_statements(format!("PRINT {}", &most[..240]).as_bytes(), None);
    }
    check(
        &format!("X={}1", "-".repeat(41)),
        "?FORMULA TOO COMPLEX: More than 40 signs wait for one operand.",
    );
}
