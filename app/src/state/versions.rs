//! The way back: earlier versions of a project, and which of them are kept.

use serde::{Deserialize, Serialize};

use super::order::sort_few;

/// What an edit can be gone back over at least, ms.
const APART_MS: f64 = 60_000.0;
/// Versions that are kept because time has passed, and others, each.
const MOST: usize = 20;

/// Names an earlier version.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Version {
    /// When it was kept, in ms since 1970.
    pub at_ms: f64,
    /// Why.
    pub reason: Reason,
}

/// Why a version has been kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reason {
    /// Time has passed.
    Time,
    /// A project was imported over it.
    Import,
    /// An earlier version was taken again.
    Back,
    /// The device was reset to its factory state.
    Reset,
    /// This page could not read it.
    Unreadable,
}

impl Reason {
    /// What a list of versions says of one.
    pub fn words(self) -> &'static str {
        match self {
            Reason::Time => "as it was then",
            Reason::Import => "before an import",
            Reason::Back => "before an earlier version was taken",
            Reason::Reset => "before the device was reset",
            Reason::Unreadable => "could not be read by this page",
        }
    }
}

/// Whether it is time for a new version.
pub fn is_due(versions: &[Version], now_ms: f64) -> bool {
    // A clock that was set back is no reason to keep none.
    versions
        .iter()
        .all(|version| (now_ms - version.at_ms).abs() >= APART_MS)
}

/// Takes out of `versions` what is too many, and returns it. What time has left grows sparser with age, so that both
/// the last minutes and the last months can be gone back to; of the others the newest are kept.
pub fn thin(versions: &mut Vec<Version>) -> Vec<Version> {
    sort_few(versions, |a, b| a.at_ms < b.at_ms);
    let (mut times, mut others): (Vec<Version>, Vec<Version>) = versions
        .iter()
        .partition(|version| version.reason == Reason::Time);
    let mut dropped: Vec<Version> = others.drain(..others.len().saturating_sub(MOST)).collect();
    while times.len() > MOST {
        dropped.push(times.remove(most_dispensable(&times)));
    }
    versions.retain(|version| !dropped.contains(version));
    dropped
}

/// The version between others whose loss leaves the smallest gap for its age.
fn most_dispensable(times: &[Version]) -> usize {
    let newest = times.last().map_or(0.0, |version| version.at_ms);
    let gap = |around: &[Version]| match around {
        [before, version, after] => {
            (after.at_ms - before.at_ms) / (newest - version.at_ms + APART_MS)
        }
        _ => f64::INFINITY,
    };
    let gaps = times.windows(3).map(gap).enumerate();
    // A window is named by its first, and the version is its second.
    gaps.min_by(|(_, a), (_, b)| a.total_cmp(b))
        .map_or(0, |(first, _)| first + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MINUTE_MS: f64 = 60_000.0;

    fn at(minute: f64, reason: Reason) -> Version {
        Version {
            at_ms: minute * MINUTE_MS,
            reason,
        }
    }

    /// What is left when a version is kept every minute of `minutes`.
    fn worked(minutes: u32) -> Vec<Version> {
        let mut versions = Vec::new();
        for minute in 0..minutes {
            let version = at(f64::from(minute), Reason::Time);
            assert!(is_due(&versions, version.at_ms));
            versions.push(version);
            thin(&mut versions);
        }
        versions
    }

    #[test]
    fn the_last_minutes_and_the_first_days_can_be_gone_back_to() {
        for minutes in [1, 20, 21, 100, 1000, 50_000] {
            let kept = worked(minutes);
            assert_eq!(kept.len(), MOST.min(minutes as usize));
            let ages: Vec<f64> = kept
                .iter()
                .rev()
                .map(|version| f64::from(minutes) - version.at_ms / MINUTE_MS)
                .collect();
            assert_eq!((ages[0], ages[ages.len() - 1]), (1.0, f64::from(minutes)));
            for pair in ages.windows(2) {
                assert!(pair[1] <= 3.0 * pair[0], "{minutes} minutes leave {ages:?}");
            }
        }
    }

    #[test]
    fn a_version_is_due_a_minute_after_the_last() {
        let versions = [at(5.0, Reason::Time)];
        assert!(is_due(&[], 0.0));
        assert!(!is_due(&versions, 5.9 * MINUTE_MS));
        assert!(is_due(&versions, 6.0 * MINUTE_MS));
        assert!(is_due(&versions, 1.0 * MINUTE_MS), "the clock was set back");
    }

    #[test]
    fn work_does_not_push_out_what_was_kept_before_an_import() {
        let mut versions = vec![at(0.5, Reason::Import)];
        versions.extend((1..=30).map(|minute| at(f64::from(minute), Reason::Time)));
        let dropped = thin(&mut versions);
        assert_eq!((versions.len(), dropped.len()), (21, 10));
        assert_eq!(versions[0].reason, Reason::Import);
        versions.extend((31..=60).map(|minute| at(f64::from(minute), Reason::Import)));
        thin(&mut versions);
        let imports = || {
            versions
                .iter()
                .filter(|version| version.reason == Reason::Import)
        };
        assert_eq!(imports().count(), MOST);
        assert_eq!(imports().next().copied(), Some(at(41.0, Reason::Import)));
    }
}
