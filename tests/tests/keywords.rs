//! The keyword tables are complete: every word of a manual, with the group and the section it belongs to.

use std::collections::BTreeSet;

use motionbench_core::catalog;

/// Word, kind and section of each row.
type Rows<'a> = BTreeSet<(&'a str, &'a str, &'a str)>;

fn check(controller: &str, list: &str) {
    let expected: Vec<(&str, &str, &str)> = list
        .lines()
        .skip(1)
        .map(|line| {
            let mut columns = line.split('\t');
            let mut next = || columns.next().unwrap();
            (next(), next(), next())
        })
        .collect();
    let table = (catalog::kind(controller).unwrap().keywords)();
    let rows: Vec<(&str, &str, &str)> = table
        .iter()
        .map(|row| (row.word, row.kind, row.section.0))
        .collect();
    let missing: Vec<_> = expected.iter().filter(|row| !rows.contains(row)).collect();
    let strange: Vec<_> = rows.iter().filter(|row| !expected.contains(row)).collect();
    assert!(
        missing.is_empty() && strange.is_empty(),
        "{controller}: missing {missing:?}, not in the list {strange:?}"
    );
    assert_eq!(
        rows.len(),
        Rows::from_iter(rows.iter().copied()).len(),
        "a word stands twice"
    );
    for row in table {
        assert!(
            !row.syntax.is_empty() && !row.summary.is_empty(),
            "{}",
            row.word
        );
        assert!(row.summary.ends_with('.'), "{}", row.word);
    }
}

#[test]
fn mc600_has_every_word_of_its_manual() {
    check("mc600", include_str!("../keywords/mc600.tsv"));
}

#[test]
fn unidex3_has_every_word_of_its_manual() {
    check("unidex3", include_str!("../keywords/unidex3.tsv"));
}

#[test]
fn smartmotor_has_every_word_of_its_lists() {
    check("smartmotor", include_str!("../keywords/smartmotor.tsv"));
}
