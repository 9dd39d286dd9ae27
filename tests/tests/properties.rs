//! What holds for every number and every program.
#![cfg(not(target_family = "wasm"))]

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::Slot;
use motionbench_core::language::latin1;
use motionbench_core::number::{Constant, integer, leading, microsoft9};
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;
use proptest::collection::vec;
use proptest::prelude::*;

/// The limits of a real of MotionBasic.
const SMALLEST: f64 = 2.938_735_877_055_719e-39;
const LARGEST: f64 = 1.701_411_834_604_692_3e38;

/// Reals of every magnitude, many of them with few digits.
fn real() -> impl Strategy<Value = f64> {
    let short = (-999_999_999_i64..=999_999_999, -20_i32..20)
        .prop_map(|(digits, exponent)| format!("{digits}e{exponent}").parse().unwrap());
    let any = any::<f64>().prop_filter("within the limits", |value| {
        (SMALLEST..=LARGEST).contains(&value.abs())
    });
    prop_oneof![short, any]
}

fn printed(value: f64) -> String {
    let mut out = Vec::new();
    microsoft9(value, &mut out);
    String::from_utf8(out).unwrap()
}

/// The same text for a magnitude, from the standard library: nine digits, zeros behind them dropped. It rounds ties to
/// even, so they are left out by the caller.
fn expected(value: f64) -> String {
    let scientific = format!("{:.8e}", value.abs());
    let (digits, exponent) = scientific.split_once('e').unwrap();
    let exponent: i32 = exponent.parse().unwrap();
    let digits = digits.replace('.', "");
    let digits = digits.trim_end_matches('0');
    let sign = if value < 0.0 { "-" } else { " " };
    let text = match exponent {
        0..9 => {
            let whole = usize::try_from(exponent).unwrap() + 1;
            let padded = format!("{digits:0<whole$}");
            let (whole, part) = padded.split_at(whole);
            format!("{whole}.{part}").trim_end_matches('.').to_owned()
        }
        -2 => format!(".0{digits}"),
        -1 => format!(".{digits}"),
        _ => {
            let (first, rest) = digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            let sign = if exponent < 0 { '-' } else { '+' };
            format!("{first}{point}{rest}E{sign}{:02}", exponent.abs())
        }
    };
    format!("{sign}{text}")
}

/// Whether the digits behind the ninth are a five and nothing else.
fn is_tie(value: f64) -> bool {
    let exact = format!("{:.60e}", value.abs());
    let (digits, _) = exact.split_once('e').unwrap();
    digits[10..].trim_end_matches('0') == "5"
}

proptest! {
    #[test]
    fn a_printed_real_reads_back_and_prints_the_same(value in real()) {
        let text = printed(value);
        if value != 0.0 && !is_tie(value) {
            prop_assert_eq!(&text, &expected(value));
        }
        let (read, length) = leading(text.as_bytes()).unwrap();
        prop_assert_eq!(length, text.len());
        prop_assert!((read.real() - value).abs() <= value.abs() * 0.500_000_1e-8, "{}", text);
        prop_assert_eq!(printed(read.real()), text);
    }

    #[test]
    fn a_printed_integer_reads_back_as_itself(value in any::<i32>()) {
        let mut text = Vec::new();
        integer(value, &mut text);
        prop_assert_eq!(leading(&text), Some((Constant::Integer(value), text.len())));
    }
}

/// A statement of a program that jumps about; numbers in it stand for lines by their place.
fn statement() -> impl Strategy<Value = String> {
    let line = || (0..12_usize).prop_map(|place| format!("@{place}@"));
    prop_oneof![
        line().prop_map(|line| format!("GOTO {line}")),
        line().prop_map(|line| format!("GOSUB{line}: PRINT \"back\"")),
        (1..20, line(), line()).prop_map(|(n, a, b)| format!("IF X<{n} THEN {a} ELSE {b}")),
        (1..20, line()).prop_map(|(n, line)| format!("IF X>{n} GO TO {line}")),
        (line(), line(), line()).prop_map(|(a, b, c)| format!("ON X GOTO {a},{b} , {c}")),
        (line(), line()).prop_map(|(a, b)| format!("ON X-7 GOSUB {a},{b}: X=X+2")),
        line().prop_map(|line| format!("X=X+1: IF X=30 THEN RUN {line}")),
        line().prop_map(|line| format!("PRINT {line}: REM GOTO {line}")),
        Just("FOR I=1 TO 2: PRINT I: NEXT".to_owned()),
        Just("RETURN".to_owned()),
        Just("GOTO 9: REM no such line".to_owned()),
        Just("X=X+3".to_owned()),
    ]
}

/// A program: each line says its place, then does something.
fn program(statements: &[String], numbers: &[u16]) -> String {
    let number = |place: &str| {
        let place: usize = place.parse().unwrap();
        numbers[place % numbers.len()].to_string()
    };
    let lines = statements.iter().zip(numbers).enumerate();
    let lines = lines.map(|(place, (statement, line))| {
        // What PRINT and REM say is no jump, and stays.
        let jumps = !statement.starts_with("PRINT");
        let parts = statement.split('@').enumerate();
        let parts = parts.map(|(index, part)| match (index % 2, jumps) {
            (1, true) => number(part),
            _ => part.to_owned(),
        });
        format!(
            "{line} PRINT \"<{place}>\";: {}\n",
            parts.collect::<String>()
        )
    });
    lines.collect()
}

/// What the console sends when a program runs for a while after `command`, and the listing at the end.
fn run(program: &str, command: &str) -> (String, String) {
    let kind = catalog::kind("mc600").unwrap();
    let options = [("speed".to_owned(), "100".to_owned())];
    let mut bench = Bench::new();
    let station = bench.add("card", kind.create(&options).unwrap(), None);
    let mut probe = Probe::default();
    bench.power(station, true);
    let card = bench.station_mut(station).unwrap();
    card.load(&Slot::Program, program).unwrap();
    bench.send(0, format!("{command}\rRUN\r").as_bytes());
    bench.run_until(Nanos::from_millis(400), &mut probe);
    let output: Vec<u8> = probe.console.iter().map(|received| received.byte).collect();
    let output = latin1::text(&output);
    let (_, output) = output.split_once(">RUN\r\n").unwrap();
    let listing = bench.station(station).unwrap().listing(&Slot::Program);
    (output.to_owned(), listing.unwrap())
}

/// An output with the line numbers of its messages as places.
fn by_place(output: &str, numbers: &[u16]) -> String {
    let mut parts = output.split(" IN ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let number = part[..digits].parse();
        let place = numbers.iter().position(|line| Ok(line) == number.as_ref());
        // The last message may be cut short.
        let place = place.map_or("?".to_owned(), |place| place.to_string());
        format!("{text} IN line {place}{}", &part[digits..])
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn a_renumbered_program_does_the_same(
        statements in vec(statement(), 2..12),
        gaps in vec(1_u16..50, 12),
        start in 30_000_u16..63_000,
        increment in 1_u16..80,
    ) {
        let old: Vec<u16> = statements.iter().zip(&gaps).scan(9, |line, (_, gap)| {
            *line += gap;
            Some(*line)
        }).collect();
        let new: Vec<u16> = (start..).step_by(usize::from(increment)).take(old.len()).collect();
        let text = program(&statements, &old);
        let (before, _) = run(&text, "RENUM 90000");
        let (after, listing) = run(&text, &format!("RENUM {start},{increment}"));
        let (before, after) = (by_place(&before, &old), by_place(&after, &new));
        // A program that goes on is cut off a little sooner or later.
        let length = match after.ends_with("\r\n>") {
            true => before.len().max(after.len()),
            false => before.len().min(after.len()).saturating_sub(40),
        };
        let same = |text: &str| text.get(..length).unwrap_or(text).to_owned();
        prop_assert_eq!(same(&before), same(&after), "{}", text);
        prop_assert_eq!(listing.replace("\r\n", "\n"), program(&statements, &new));
    }
}
