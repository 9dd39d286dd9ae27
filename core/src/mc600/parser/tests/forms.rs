//! What may be written, and how it nests.

use super::check;

#[test]
fn operators_bind_by_the_hierarchy_of_operations() {
    for (text, expected) in [
        ("X=A+B", "(add A B)"),
        ("X=C^(D+E)/2", "(divide (power C (add D E)) 2)"),
        (
            "X=((X-C^(D+E)/2)*10)+1",
            "(add (multiply (subtract X (divide (power C (add D E)) 2)) 10) 1)",
        ),
        ("X=GG$>HH$", "(greater GG$ HH$)"),
        ("X=JJ$+\"MORE\"", "(add JJ$ \"MORE\")"),
        ("X=K%=1 AND M<>X", "(and (equal K% 1) (notequal M X))"),
        (
            "X=K%=2 OR (A=B AND M<X)",
            "(or (equal K% 2) (and (equal A B) (less M X)))",
        ),
        ("X=NOT (D=E)", "(not (equal D E))"),
        ("X=NOT A=B", "(not (equal A B))"),
        ("X=NOT A AND B", "(and (not A) B)"),
        ("X=A AND NOT B", "(and A (not B))"),
        ("X=A OR B XOR C OR D", "(or (xor (or A B) C) D)"),
        ("X=A OR B AND C", "(or A (and B C))"),
        ("X=A<B=C", "(equal (less A B) C)"),
        ("X=A-B-C", "(subtract (subtract A B) C)"),
        ("X=A/B*C", "(multiply (divide A B) C)"),
        ("X=2^3^2", "(power (power 2 3) 2)"),
        ("X=-2^2", "(neg (power 2 2))"),
        ("X=2^-2", "(power 2 (neg 2))"),
        ("X=2^-2^2", "(power 2 (neg (power 2 2)))"),
        ("X=-A*B", "(multiply (neg A) B)"),
        ("X=A*-B+C", "(add (multiply A (neg B)) C)"),
        ("X=A*NOT B=C", "(multiply A (not (equal B C)))"),
        ("X=4-(-2)", "(subtract 4 (neg 2))"),
        ("X=+44", "44"),
        ("X=--A", "(neg (neg A))"),
        ("X=10E-2+BR", "(add 0.1r BR)"),
    ] {
        check(text, &format!("X := {expected}"));
    }
}

#[test]
fn relations_are_one_or_two_marks_with_blanks_between() {
    for (text, name) in [
        ("<=", "lessequal"),
        ("=<", "lessequal"),
        ("< =", "lessequal"),
        (">=", "greaterequal"),
        ("=>", "greaterequal"),
        ("> =", "greaterequal"),
        ("<>", "notequal"),
        ("><", "notequal"),
        ("< >", "notequal"),
    ] {
        check(
            &format!("PRINT 15 {text} 15"),
            &format!("print ({name} 15 15)"),
        );
        check(
            &format!("PRINT 15{text}15"),
            &format!("print ({name} 15 15)"),
        );
    }
}

#[test]
fn constants() {
    for (text, expected) in [
        ("8765", "8765"),
        ("-3276878", "(neg 3276878)"),
        ("2147483647", "2147483647"),
        ("2147483648", "2147483648.0r"),
        ("-2147483648", "-2147483648"),
        ("- 2147483648", "-2147483648"),
        ("-2147483649", "(neg 2147483649.0r)"),
        ("-2147483648.", "(neg 2147483648.0r)"),
        ("-2147483648^2", "(neg (power 2147483648.0r 2))"),
        ("1.23", "1.23r"),
        (".7777777", "0.7777777r"),
        ("-333.", "(neg 333.0r)"),
        ("235.988E-3", "0.235988r"),
        ("2359E6", "2359000000.0r"),
        ("-7.09E-12", "(neg 7.09e-12r)"),
        ("1.70141183E+38", "1.70141183e38r"),
        ("2E-39", "0.0r"),
        (".", "0.0r"),
        ("&H1F", "31"),
        ("&hffffffff", "-1"),
        ("&H00000000FF", "255"),
        ("{pi}", "3.141592653589793r"),
        ("{PI}", "3.141592653589793r"),
        ("\"\"", "\"\""),
        ("\"$25,000.00\"", "\"$25,000.00\""),
        ("\"NO END: HERE", "\"NO END: HERE\""),
        ("\"", "\"\""),
        ("1 2", "1 2"),
        (
            "12ELSE",
            "?SYNTAX: ELSE without an IF before it on the line.",
        ),
    ] {
        let expected = match expected.strip_prefix('?') {
            Some(_) => expected.to_owned(),
            None => format!("print {expected}"),
        };
        check(&format!("PRINT {text}"), &expected);
    }
}

#[test]
fn a_keyword_may_be_glued_to_what_follows() {
    for (text, expected) in [
        ("FORI=1TO10", "for I 1 to 10"),
        ("fori=1to10step.5", "for I 1 to 10 step 0.5r"),
        ("PRINTA", "print A"),
        ("PRINTSIN(X)", "print sin(X)"),
        ("GOTO100", "goto 100"),
        ("GOSUB100:RETURN", "gosub 100 | return"),
        ("IFA=1THEN10", "if (equal A 1) {goto 10}"),
        (
            "IFA=1THEN10ELSE20",
            "if (equal A 1) {goto 10} else {goto 20}",
        ),
        (
            "ONXGOTO1,2",
            "?SYNTAX: The name XGOTO1 has the keyword GOTO in it; a name must not.",
        ),
        ("IF NOTA THEN 5", "if (not A) {goto 5}"),
        ("PRINT1ANDGV_IN1%", "print (and 1 system GV_IN1%)"),
        ("LETMV_SPEED%=5", "system MV_SPEED% := 5"),
        (
            "TOTAL=5",
            "?SYNTAX: TO cannot begin a statement. TOTAL is read as TO TAL: a name must not begin with a keyword.",
        ),
        ("PRINTTAB(5)A", "print tab(5) A"),
    ] {
        check(text, expected);
    }
}

#[test]
fn names() {
    for (text, expected) in [
        ("handle%=1", "HANDLE% := 1"),
        ("FILEHANDLE%=1", "FILEHANDLE% := 1"),
        ("TARGET=1", "TARGET := 1"),
        ("CAMTAB%=1", "CAMTAB% := 1"),
        ("CAMTAB%(5)=1", "CAMTAB%[5] := 1"),
        ("TAB=1", "TAB := 1"),
        ("TABLE=1", "TABLE := 1"),
        ("SPC=TAB", "SPC := TAB"),
        ("GO=1", "GO := 1"),
        (
            "A23456789012345678901=1",
            "?SYNTAX: The name A23456789012345678901 is longer than 20 characters.",
        ),
        ("A2345678901234567890%=1", "A2345678901234567890% := 1"),
        ("A(1,2,3,4)=B(X)", "A[1,2,3,4] := B[X]"),
        ("a$=B$", "A$ := B$"),
        ("MRES%=1", "system MRES% := 1"),
        ("MRES=1", "MRES := 1"),
        ("x=sl_posdemand%", "X := system SL_POSDEMAND%"),
    ] {
        check(text, expected);
    }
}

#[test]
fn an_if_takes_the_rest_of_the_line_and_else_belongs_to_the_nearest() {
    for (text, expected) in [
        ("IF A THEN X=1: PRINT X", "if A {X := 1 | print X}"),
        ("IF A THEN X=1: ELSE X=2", "if A {X := 1} else {X := 2}"),
        ("IF A GOTO 5", "if A {goto 5}"),
        ("IF A GO TO 5 ELSE 6", "if A {goto 5} else {goto 6}"),
        ("IF A GOTO", "if A {goto 0}"),
        ("IF A THEN GOTO 5: PRINT", "if A {goto 5 | print}"),
        ("IF A THEN 5: PRINT", "if A {goto 5 | print}"),
        ("IF A THEN", "if A {}"),
        ("IF A THEN ELSE 5", "if A {} else {goto 5}"),
        (
            "IF A THEN IF B THEN 1 ELSE 2",
            "if A {if B {goto 1} else {goto 2}}",
        ),
        (
            "IF A THEN IF B THEN 1 ELSE 2 ELSE 3",
            "if A {if B {goto 1} else {goto 2}} else {goto 3}",
        ),
        (
            "IF A THEN 1 ELSE IF B THEN 2 ELSE 3",
            "if A {goto 1} else {if B {goto 2} else {goto 3}}",
        ),
        (
            "IF A THEN PRINT 1,ELSE PRINT 2",
            "if A {print 1 ,} else {print 2}",
        ),
        ("IF A THEN REM ELSE 5", "if A {rem}"),
        (
            "IF A THEN X==1 ELSE 5",
            "if A {?SYNTAX: A value should stand here.} else {goto 5}",
        ),
        (
            "IF A THEN FILES *.BAS ELSE STOP",
            "if A {files \"*.BAS\"} else {stop}",
        ),
    ] {
        check(text, expected);
    }
}

#[test]
fn commands_parse_anywhere() {
    for (text, expected) in [
        ("LIST", "list 0..65535"),
        ("LIST 500", "list 500..500"),
        ("LIST 150-", "list 150..65535"),
        ("LIST -1000", "list 0..1000"),
        ("LIST 150-1000", "list 150..1000"),
        ("10 LIST: RUN", "list 0..65535 | run"),
        ("DEL 100-200, 300", "del 100..200 300..300"),
        ("AUTO", "auto None None"),
        ("AUTO 100, 25", "auto Some(100) Some(25)"),
        ("AUTO ,25", "auto None Some(25)"),
        ("RENUM", "renum None None"),
        ("RENUM 100", "renum Some(100) None"),
        ("RENUM 100,5", "renum Some(100) Some(5)"),
        ("RUN \"FOO.BAS\",500", "run \"FOO.BAS\" at 500"),
        ("RUN N$", "run N$"),
        ("RUN ,500", "run at 500"),
        ("SAVE", "save"),
        ("SAVE \"TEST", "save \"TEST\""),
        ("FILES", "files"),
        ("FILES \"A:\"", "files \"A:\""),
        ("FILES A:", "files \"A:\""),
        ("FILES M$+\"*\"", "files (add M$ \"*\")"),
        ("FILES CHR$(65)", "files chrs(65)"),
        ("files *.txt", "files \"*.TXT\""),
        (
            "files chap*.zip: list",
            "files \"CHAP*.ZIP\" | list 0..65535",
        ),
        ("files b:big*.*:list", "files \"B:BIG*.*\" | list 0..65535"),
        ("files data*.*", "files \"DATA*.*\""),
        ("ERASE yah???.bas: END", "erase \"YAH???.BAS\" | end"),
        ("ERASE B:*.*", "erase \"B:*.*\""),
        ("ERASE M$", "erase M$"),
        ("COPY A$,\"B:\"+A$", "copy A$ to (add \"B:\" A$)"),
        ("FORMAT B:", "format \"B:\""),
        ("FORMAT \"A:\": NEW", "format \"A:\" | new"),
        ("MERGE A$: PASSWORD", "merge A$ | password"),
        ("NEW: CONT", "new | cont"),
        (":: END :", "end"),
        ("", ""),
    ] {
        check(text, expected);
    }
}

#[test]
fn calls_without_arguments_may_leave_out_the_parentheses() {
    for (text, expected) in [
        ("MDRVEN()", "call MDRVEN()"),
        ("mdrven", "call MDRVEN()"),
        ("midle: mclrfault()", "call MIDLE() | call MCLRFAULT()"),
        (
            "PRINT INSTA;INTSTA();OUTSTA",
            "print insta() ; insta() ; outsta()",
        ),
        ("MMOVE(-40960)", "call MMOVE((neg 40960))"),
        (
            "MMOVE 5",
            "?SYNTAX: An opening parenthesis should stand here.",
        ),
    ] {
        check(text, expected);
    }
}

#[test]
fn data_items() {
    for (text, expected) in [
        ("DATA 1, -1.7E-9 ,A B ", "data \"1\" \"-1.7E-9\" \"A B\""),
        (
            "DATA \" A, B: \",C: PRINT",
            "data q\" A, B: \" \"C\" | print",
        ),
        ("DATA", "data \"\""),
        ("DATA ,", "data \"\" \"\""),
        ("DATA \"OPEN", "data q\"OPEN\""),
        ("DATA \"A\"B", "data \"\\\"A\\\"B\""),
        ("data PRINT,rem", "data \"PRINT\" \"rem\""),
    ] {
        check(text, expected);
    }
}
