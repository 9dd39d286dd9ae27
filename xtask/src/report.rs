//! Steps: what each does, how it went and how long it took.

use std::time::{Duration, Instant};

use crate::Result;

/// How a step went.
enum Outcome {
    Passed,
    Failed(String),
    Skipped(String),
}

/// The steps so far, in order.
#[derive(Default)]
pub(crate) struct Report {
    steps: Vec<(String, Outcome, Duration)>,
}

impl Report {
    /// Does one step, saying `what` it does before and how it went after. Returns whether it
    /// passed.
    pub(crate) fn step(
        &mut self,
        name: &str,
        what: &str,
        run: impl FnOnce() -> Result<()>,
    ) -> bool {
        println!("\n==> {name}: {what}");
        let start = Instant::now();
        let outcome = match run() {
            Ok(()) => Outcome::Passed,
            Err(message) => Outcome::Failed(message),
        };
        let took = start.elapsed();
        match &outcome {
            Outcome::Failed(message) => println!("<== {name} FAILED, {}\n{message}", seconds(took)),
            _ => println!("<== {name} done, {}", seconds(took)),
        }
        let passed = matches!(outcome, Outcome::Passed);
        self.steps.push((name.to_owned(), outcome, took));
        passed
    }

    /// Notes a step that could not be tried.
    pub(crate) fn skip(&mut self, name: &str, why: String) {
        println!("\n==> {name}: skipped, {why}");
        self.steps
            .push((name.to_owned(), Outcome::Skipped(why), Duration::ZERO));
    }

    /// Prints the summary; an error if a step failed or was skipped.
    pub(crate) fn finish(self) -> Result<()> {
        let mut failed = 0;
        let total = self.steps.iter().map(|(_, _, took)| *took).sum();
        println!("\n{:<12} {:>9}  result", "step", "time");
        for (name, outcome, took) in &self.steps {
            let result = match outcome {
                Outcome::Passed => "ok".to_owned(),
                Outcome::Failed(message) => format!("FAILED: {}", first_line(message)),
                Outcome::Skipped(why) => format!("FAILED: not tried, {why}"),
            };
            failed += usize::from(!matches!(outcome, Outcome::Passed));
            println!("{name:<12} {:>9}  {result}", seconds(*took));
        }
        println!("{:<12} {:>9}", "all", seconds(total));
        println!(
            "\n{} passed, {failed} failed",
            self.steps.len().saturating_sub(failed)
        );
        if failed == 0 {
            Ok(())
        } else {
            Err(String::new())
        }
    }

    /// An error if a step failed; for commands that need no summary.
    pub(crate) fn expect_passed(&self) -> Result<()> {
        match self
            .steps
            .iter()
            .find(|(_, outcome, _)| !matches!(outcome, Outcome::Passed))
        {
            None => Ok(()),
            Some((name, _, _)) => Err(format!("stopped: {name} failed")),
        }
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_or_skipped_step_fails_the_run() {
        let mut good = Report::default();
        assert!(good.step("one", "passes", || Ok(())));
        assert!(good.finish().is_ok());

        let mut bad = Report::default();
        assert!(!bad.step("one", "fails", || Err("why".to_owned())));
        assert!(bad.expect_passed().is_err());
        assert!(bad.finish().is_err());

        let mut skipped = Report::default();
        skipped.skip("one", "needs another".to_owned());
        assert!(skipped.finish().is_err());
    }
}
