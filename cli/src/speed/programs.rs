//! The measured programs, each in a controller's own language and run by the controller on a bench, with breakpoints,
//! line tracking and credit in place.

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::{Controller, Debug, DebugReply, Value};
use motionbench_core::probe::Probe;
use motionbench_core::scenario::busy;
use motionbench_core::time::Nanos;

/// A program that repeats its innermost pass.
pub(super) struct Program {
    /// Controller and number.
    pub(super) name: &'static str,
    controller: &'static str,
    text: fn(u32) -> String,
    /// Innermost passes for each of what `text` is given.
    passes: f64,
    /// A variable, and what it is in the end.
    result: (&'static str, fn(f64) -> f64),
}

/// Every measured program, in its controller's language.
pub(super) const PROGRAMS: [Program; 8] = [
    Program {
        name: "mc600/1",
        controller: "mc600",
        text: |n| format!("10 S=0\n20 FOR I=1 TO {n}:S=S+I:NEXT\n"),
        passes: 1.0,
        result: ("S", |n| n * (n + 1.0) / 2.0),
    },
    Program {
        name: "mc600/1i",
        controller: "mc600",
        text: |n| format!("10 S%=0\n20 FOR I%=1 TO {n}:S%=S%+1:NEXT\n"),
        passes: 1.0,
        result: ("S%", |n| n),
    },
    Program {
        name: "mc600/2",
        controller: "mc600",
        text: sieve,
        passes: 25_602.0,
        result: ("C", |_| 900.0),
    },
    Program {
        name: "mc600/3",
        controller: "mc600",
        text: strings,
        passes: 120.0,
        result: ("L", |_| 1640.0),
    },
    Program {
        name: "mc600/4",
        controller: "mc600",
        text: |n| format!("10 C=0\n20 FOR I=1 TO {n}:GOSUB 100:NEXT\n30 END\n100 C=C+1:RETURN\n"),
        passes: 1.0,
        result: ("C", |n| n),
    },
    Program {
        name: "mc600/5",
        controller: "mc600",
        text: nested,
        passes: 100.0,
        result: ("C", |_| 84.0),
    },
    Program {
        name: "smartmotor/1i",
        controller: "smartmotor",
        text: |n| format!("WHILE i<{n}\ni=i+1\ns=s+1\nLOOP\nEND\n"),
        passes: 1.0,
        result: ("s", |n| n),
    },
    Program {
        name: "smartmotor/4",
        controller: "smartmotor",
        text: |n| format!("WHILE i<{n}\nGOSUB1\ni=i+1\nLOOP\nEND\nC1\nc=c+1\nRETURN\n"),
        passes: 1.0,
        result: ("c", |n| n),
    },
];

/// Primes below 7000: 7000 passes to fill, 6998 to look, 11604 to strike out.
fn sieve(n: u32) -> String {
    format!(
        "10 DIM F(7000)\n\
         20 FOR R=1 TO {n}:C=0\n\
         30 FOR I=0 TO 6999:F(I)=1:NEXT\n\
         40 FOR I=2 TO 6999\n\
         50 IF F(I)=0 THEN 90\n\
         60 C=C+1:IF I*I>6999 THEN 90\n\
         70 FOR K=I*I TO 6999 STEP I:F(K)=0:NEXT\n\
         90 NEXT\n\
         100 NEXT\n"
    )
}

/// 40 passes that append, 80 that look.
fn strings(n: u32) -> String {
    format!(
        "10 FOR R=1 TO {n}:A$=\"\":L=0:C=0\n\
         20 FOR I=1 TO 40\n\
         30 A$=A$+\"X\"+MID$(\"ABCDEFGH\",I-INT(I/8)*8+1,1):L=L+LEN(A$)\n\
         40 NEXT\n\
         50 FOR I=1 TO 80:IF MID$(A$,I,1)=\"X\" THEN C=C+1\n\
         60 NEXT\n\
         70 NEXT\n"
    )
}

fn nested(n: u32) -> String {
    format!(
        "10 FOR R=1 TO {n}:C=0\n\
         20 FOR I=1 TO 10:FOR J=1 TO 10\n\
         30 X=SQRT(I*J)+SIN(J)\n\
         40 IF X>3 THEN C=C+1\n\
         50 IF X>100 THEN C=0\n\
         60 NEXT:NEXT\n\
         70 NEXT\n"
    )
}

impl Program {
    /// Innermost passes when the program is run for `n`.
    pub(super) fn passes(&self, n: u32) -> f64 {
        f64::from(n) * self.passes
    }

    /// Runs the program for `n` at `speed`, from the mains switch to the next prompt. Returns the simulated time that it
    /// took; `None` if it did not compute what it should.
    pub(super) fn run(&self, n: u32, speed: &str) -> Option<Nanos> {
        let kind = catalog::kind(self.controller)?;
        let station = kind
            .create(&[("speed".to_owned(), speed.to_owned())])
            .ok()?;
        let info = station.controller().info().clone();
        let mut bench = Bench::new();
        let station = bench.add(info.id, station, None);
        bench.power(station, true);
        let loaded = bench
            .station_mut(station)?
            .load(&info.program_slot, &(self.text)(n));
        loaded.ok()?;
        bench.send(
            bench.line_of(station)?,
            format!("{}\r", info.start).as_bytes(),
        );
        let mut probe = Probe::default();
        // One that never ends is given up after an hour of simulated time.
        while bench.now() < Nanos::from_millis(3_600_000) {
            bench.run_until(bench.now() + info.sample, &mut probe);
            if bench.is_quiet() && busy(&bench.station(station)?.status()).is_none() {
                break;
            }
        }
        let result = read(bench.station_mut(station)?, self.result.0)?;
        (result == (self.result.1)(f64::from(n))).then_some(bench.now())
    }
}

fn read(station: &mut dyn Controller, variable: &str) -> Option<f64> {
    match station.debug(Debug::Read(variable.to_owned())) {
        DebugReply::Value(Value::Number(number)) => Some(number),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_program_computes_its_result() {
        for program in &PROGRAMS {
            for n in [1, 3] {
                assert!(program.run(n, "fast").is_some(), "{} {n}", program.name);
            }
        }
    }
}
