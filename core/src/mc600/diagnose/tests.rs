//! What a person reads of a program's text.

use super::*;

/// Line, message, cause and what the cure puts where the marked text is.
fn found(text: &str) -> Vec<(u32, String, String, Option<String>)> {
    let lines: Vec<&str> = text.split('\n').collect();
    let found = diagnose(text).into_iter().map(|found| {
        let line = lines[found.line as usize];
        let cured = found.cure.map(|cure| {
            let (start, end) = (cure.span.start as usize, cure.span.end as usize);
            let before: String = line.chars().take(start).collect();
            let behind: String = line.chars().skip(end).collect();
            format!("{before}{}{behind}", cure.replacement)
        });
        (found.line, found.message, found.cause, cured)
    });
    found.collect()
}

fn check(text: &str, expected: &[(u32, &str, &str, Option<&str>)]) {
    let found = found(text);
    let found: Vec<(u32, &str, &str, Option<&str>)> = found
        .iter()
        .map(|(line, message, cause, cured)| {
            (*line, message.as_str(), cause.as_str(), cured.as_deref())
        })
        .collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn a_good_program_is_left_alone() {
    check(
        "10 FOR I=1 TO 3\n20 PRINT I\n\n30 NEXT\n40 IF I>3 THEN 10 ELSE END\n",
        &[],
    );
    check("", &[]);
}

#[test]
fn errors_of_a_line_come_with_cause_and_cure() {
    check(
        "10 PRINT (1+2\n20 SCORE=1\n30 GET A$: PRINT#1\n40 PRINT \"A\"+1",
        &[
            (
                0,
                "?SYNTAX ERROR",
                "A closing parenthesis is missing.",
                Some("10 PRINT (1+2)"),
            ),
            (
                1,
                "?SYNTAX ERROR",
                "The name SCORE has the keyword OR in it; a name must not.",
                None,
            ),
            (
                2,
                "?NOT IMPLEMENTED ERROR",
                "GET: The device itself does not implement it.",
                None,
            ),
            (
                2,
                "?NOT IMPLEMENTED ERROR",
                "PRINT does not work with files: the device itself does not implement them.",
                None,
            ),
            (3, "?TYPE MISMATCH ERROR", "A string is wanted here.", None),
        ],
    );
}

#[test]
fn a_jump_to_no_line_offers_the_nearest() {
    check(
        "10 GOTO 100\n 25 IF A THEN X=1 ELSE 24\n30 RUN 500",
        &[
            (
                0,
                "?UNDEF'D STATEMENT ERROR",
                "There is no line 100.",
                Some("10 GOTO 30"),
            ),
            (
                1,
                "?UNDEF'D STATEMENT ERROR",
                "There is no line 24.",
                Some(" 25 IF A THEN X=1 ELSE 25"),
            ),
            (
                2,
                "?UNDEFINED LINE NUMBER ERROR",
                "There is no line 500.",
                Some("30 RUN 30"),
            ),
        ],
    );
}

#[test]
fn line_numbers_are_judged() {
    check(
        "20 END\n10 END\n10 STOP\n15\nPRINT 1\n70000 END",
        &[
            (
                1,
                "LINE 10 OUT OF ORDER",
                "The device sorts its lines: line 10 will stand before line 20.",
                None,
            ),
            (
                2,
                "LINE 10 TWICE",
                "Line 10 stands here a second time: this one replaces the first.",
                None,
            ),
            (
                3,
                "LINE 15 IS EMPTY",
                "A number alone deletes line 15.",
                None,
            ),
            (
                4,
                "?SYNTAX ERROR",
                "A program line begins with its number.",
                Some("25 PRINT 1"),
            ),
            (5, "?SYNTAX ERROR", "A line number is at most 63999.", None),
        ],
    );
}

#[test]
fn what_the_device_cannot_hold_is_shown() {
    let long = format!("10 PRINT \"{}\"", "X".repeat(80));
    let [found] = &diagnose(&long)[..] else {
        unreachable!("{long}");
    };
    assert_eq!(
        (found.span, found.message.as_str()),
        (Span::new(80, 91), "?STRING TOO LONG ERROR")
    );
    check(
        "10 PRINT \u{201c}A\"\n20 GOTO 10",
        &[(
            0,
            "?SYNTAX ERROR",
            "The device has no character \u{201c}.",
            Some("10 PRINT \"A\""),
        )],
    );
}

#[test]
fn what_replaces_a_line_is_not_told_at_its_old_place() {
    check(
        "10 GOTO 10\n10 MSETSB(1): \u{2126}",
        &[
            (
                1,
                "LINE 10 TWICE",
                "Line 10 stands here a second time: this one replaces the first.",
                None,
            ),
            (
                1,
                "?SYNTAX ERROR",
                "The device has no character \u{2126}.",
                Some("10 MSETSB(1): ?"),
            ),
        ],
    );
}

#[test]
fn spans_are_counted_in_characters() {
    let [found] = &diagnose("10 PRINT \"\u{e9}\u{e9}\": X=(")[..] else {
        unreachable!();
    };
    assert_eq!(found.span, Span::new(18, 18));
}

#[test]
fn highlights_the_parts_of_a_line() {
    use HighlightClass::*;
    let line = " 10 FORI=1TOX%:A$=CHR$(65)+\"\u{e9}\":MV_ACC%=SCORE AND{pi}:MMOVE(5):REM x";
    let parts: Vec<(String, HighlightClass)> = highlight(line)
        .into_iter()
        .map(|part| {
            let range = part.span.range();
            (
                line.chars().skip(range.start).take(range.len()).collect(),
                part.class,
            )
        })
        .collect();
    let expected = [
        ("10", LineNumber),
        ("FOR", Keyword),
        ("I", Variable),
        ("=", Operator),
        ("1", Number),
        ("TO", Keyword),
        ("X%", Variable),
        (":", Operator),
        ("A$", Variable),
        ("=", Operator),
        ("CHR$", Function),
        ("(", Operator),
        ("65", Number),
        (")", Operator),
        ("+", Operator),
        ("\"\u{e9}\"", Text),
        (":", Operator),
        ("MV_ACC%", SystemVariable),
        ("=", Operator),
        ("SCORE", Error),
        ("AND", Operator),
        ("{pi}", Number),
        (":", Operator),
        ("MMOVE", Function),
        ("(", Operator),
        ("5", Number),
        (")", Operator),
        (":", Operator),
        ("REM", Comment),
        (" x", Comment),
    ];
    let parts: Vec<(&str, HighlightClass)> = parts
        .iter()
        .map(|(text, class)| (text.as_str(), *class))
        .collect();
    assert_eq!(parts, expected);
    assert_eq!(highlight("70000 END")[0].class, Error);
}
