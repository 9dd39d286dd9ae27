//! Every word that works is held by scenarios: on a card without it they fail.
#![cfg(not(target_family = "wasm"))]

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

use motionbench_core::catalog::{self, Kind};
use motionbench_core::language::Support;
use motionbench_core::scenario::Outcome;
use motionbench_tests::{conformance, programs};

/// The words of the keyword table that a scenario's programs and commands use.
fn words(kind: &Kind, name: &str) -> BTreeSet<&'static str> {
    let lines = programs::lines(name);
    lines.iter().flat_map(|line| (kind.words)(line)).collect()
}

/// How a scenario ends with controllers that lack a word.
fn outcome_without(word: &str, kind: &Kind, name: &str) -> Outcome {
    let bench = format!("bench {}", kind.id);
    let word = word.replace('"', "\\\"");
    let text: String = conformance::text(name)
        .lines()
        .map(|line| match line.strip_prefix(&bench) {
            Some(rest) if rest.is_empty() || rest.starts_with(' ') => {
                format!("{line} without=\"{word}\"\n")
            }
            _ => format!("{line}\n"),
        })
        .collect();
    conformance::run_text(name, &text).outcome
}

/// The scenarios of a controller, the shortest first, with their words. One that fails anyhow holds nothing.
fn scenarios(kind: &Kind) -> BTreeMap<(usize, &'static str), BTreeSet<&'static str>> {
    let folder = format!("{}/", kind.id);
    let names = conformance::scenarios().filter(|name| name.starts_with(&folder));
    let sound = names.filter(|name| !conformance::text(name).contains("\nknown-failure "));
    sound
        .map(|name| ((conformance::text(name).len(), name), words(kind, name)))
        .collect()
}

/// What is wrong with how a word is covered.
fn gaps(
    kind: &Kind,
    word: &str,
    scenarios: &BTreeMap<(usize, &'static str), BTreeSet<&'static str>>,
) -> Vec<String> {
    let users = scenarios.iter().filter(|(_, words)| words.contains(word));
    // Those that are named after it are about it, all of them.
    let stem = format!("{}/keyword-{}", kind.id, word.to_uppercase());
    let (own, others): (Vec<&str>, Vec<&str>) =
        users.map(|((_, name), _)| name).partition(|name| {
            name.strip_prefix(&stem)
                .is_some_and(|rest| rest.starts_with(['.', '-']))
        });
    let fails = |name: &&str| outcome_without(word, kind, name) == Outcome::Failed;
    let mut gaps: Vec<String> = own
        .iter()
        .filter(|name| !fails(name))
        .map(|name| format!("{name} does not notice that {word} is missing"))
        .collect();
    if own.is_empty() && !others.iter().any(fails) {
        gaps.push(match others.len() {
            0 => format!("no scenario uses {word}"),
            count => format!("{count} scenarios use {word}, and none notices that it is missing"),
        });
    }
    gaps
}

/// Checks every word that the table does not call absent.
fn check(kind: &Kind) {
    let scenarios = scenarios(kind);
    let rows = (kind.keywords)();
    let supported = rows
        .iter()
        .filter(|row| !matches!(row.support, Support::Absent(_)));
    let words = Mutex::new(supported.map(|row| row.word));
    let found = Mutex::new(Vec::new());
    let next = || words.lock().unwrap().next();
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(word) = next() {
                    let gaps = gaps(kind, word, &scenarios);
                    found.lock().unwrap().extend(gaps);
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap();
    found.sort();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
fn scenarios_fail_without_their_word() {
    catalog::KINDS.iter().for_each(check);
}

/// The test above would notice.
#[test]
fn only_a_word_that_is_used_is_missed() {
    let kind = catalog::kind("mc600").unwrap();
    let name = "mc600/keyword-GOTO.scenario";
    for (word, outcome) in [
        ("GOTO", Outcome::Failed),
        ("PRINT", Outcome::Failed),
        ("DATA", Outcome::Held),
        ("gv_in3%", Outcome::Held),
    ] {
        assert_eq!(outcome_without(word, kind, name), outcome, "{word}");
    }
    let none = BTreeMap::from([((1, name), BTreeSet::new())]);
    assert_eq!(gaps(kind, "GOTO", &none), ["no scenario uses GOTO"]);
    let idle = BTreeMap::from([((1, name), BTreeSet::from(["DATA"]))]);
    assert_eq!(
        gaps(kind, "DATA", &idle),
        ["1 scenarios use DATA, and none notices that it is missing"]
    );
}

/// What a Unidex's display says, with one number of each kind.
const MESSAGES: [&str; 60] = [
    "SYS RDY", "ROM ERR", "SRAM ERR", "URAM ALT", "URAM CLR", "URAM ERR", "PWR FAIL", "EDITING!",
    "RUN   19", "REMOTE", "READY", "RUNNING", "PGM END", "WHAT?", "LOOKING", "CLEARED", "PRINTING",
    "TESTING", "MEM= 4K", "MEM=28K", "MODIFIED", "MOD. EOF", "ENTER >>", "C-ERR 10", "STK OVFL",
    "ILL.CHAR", "-F-ERROR", "-X-LIMIT", "-Y-LIMIT", "G25=", "G25=126", "SLEW=57", "ENTR MSG",
    "ENTER X", "ENTER Y", "ENTER X1", "ENTER X2", "ENTER X3", "ENTER X4", "ENTER Y1", "ENTER Y2",
    "ENTER Y3", "ENTER Y4", "ENTER M", "ENTER F", "ERROR 17", "-N-ERROR", "-G-ERROR", "-M-ERROR",
    "-D-ERROR", "EOB ERR", "NO PGM", "BUF FULL", "PGM <1>", "CLR ?<1>", "NOBOOT", "FREE MEM",
    "TST URAM", "PRNT DIR", "PRNT MES",
];

#[test]
fn every_message_of_the_panel_is_provoked_by_a_scenario() {
    let names = conformance::scenarios().filter(|name| name.starts_with("unidex3/"));
    let texts: Vec<String> = names.map(conformance::text).collect();
    let is_shown = |message: &&str| {
        let line = format!("display \"{message}\"");
        texts.iter().any(|text| text.contains(&line))
    };
    let missing: Vec<&str> = MESSAGES.into_iter().filter(|m| !is_shown(m)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
