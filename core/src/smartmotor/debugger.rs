//! Breakpoints, holding and stepping. A breakpoint replaces the first operation of its line in a copy of the program;
//! what is held goes on with the copy's original.

use std::rc::Rc;

use super::code::{Code, Exit, Image, Op};
use super::vm::{Vm, World};
use crate::exec::Credit;
use crate::hold::Hold;

/// What the debugger wants of the running program.
#[derive(Debug, Clone, Default)]
pub struct Debugger {
    /// Lines with a breakpoint.
    lines: Vec<u32>,
    /// The program with its statements apart, for single steps.
    apart: Rc<Vec<Op>>,
    /// The same with breakpoints in it; `None` without any.
    patched: Option<Rc<Vec<Op>>>,
    /// Whether the program goes on.
    pub hold: Hold,
}

impl Debugger {
    /// Sets the breakpoints.
    pub fn set_breakpoints(&mut self, lines: Vec<u32>, image: &Image) {
        self.lines = lines;
        self.bind(image);
    }

    /// Puts the breakpoints into a newly compiled program.
    pub fn bind(&mut self, image: &Image) {
        let starts: Vec<usize> = self
            .lines
            .iter()
            .filter_map(|&line| usize::try_from(image.line_start(line)?).ok())
            .collect();
        let mut ops: Vec<Op> = image.ops.iter().map(|op| op.apart()).collect();
        self.apart = Rc::new(ops.clone());
        for &start in &starts {
            if let Some(op) = ops.get_mut(start) {
                op.code = Code::Break;
            }
        }
        self.patched = (!starts.is_empty()).then(|| Rc::new(ops));
    }

    /// Runs the program as far as the debugger lets it.
    pub fn run(&mut self, vm: &mut Vm, credit: &mut Credit, world: &mut World<'_>) -> Exit {
        match self.hold {
            Hold::Held => Exit::Break,
            Hold::Free => match self.patched.clone() {
                Some(patched) => vm.run_ops(&patched, credit, world),
                None => vm.run(credit, world),
            },
            Hold::Leaving => {
                let exit = vm.step(&self.apart, credit, world);
                if exit == Exit::Credit {
                    self.hold = Hold::Free;
                    return if credit.balance > 0 {
                        self.run(vm, credit, world)
                    } else {
                        exit
                    };
                }
                if !matches!(exit, Exit::Wait(_)) {
                    self.hold = Hold::Free;
                }
                exit
            }
            Hold::Until(_) => {
                // A step that waits is not over: it ends when the statement has cost something.
                let exit = vm.run_ops(&self.apart, credit, world);
                self.hold.arrive(credit.spent);
                exit
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::bench::Bench;
    use crate::catalog;
    use crate::controller::{Control, Controller, Debug, DebugReply, RunState, Slot, Value};
    use crate::probe::Probe;
    use crate::time::Nanos;

    const PROGRAM: &str = "a=0\n\n' loop\nWHILE a<3\na=a+1\nLOOP\nb=9\nWAIT=100\nEND\n";

    struct Bed(Bench, Probe);

    impl Bed {
        /// A motor with the program, and where its lines are in the motor.
        fn new() -> (Bed, Vec<Option<u32>>) {
            let kind = catalog::kind("smartmotor").unwrap();
            let mut bench = Bench::new();
            bench.add("motor", kind.create(&[]).unwrap(), None);
            bench.power(0, true);
            let mut bed = Bed(bench, Probe::default());
            let revision = bed.motor().load(&Slot::Program, PROGRAM).unwrap();
            (bed, revision.lines)
        }

        fn motor(&mut self) -> &mut dyn Controller {
            self.0.station_mut(0).unwrap()
        }

        fn run(&mut self, ms: u64) {
            let until = self.0.now() + Nanos::from_millis(ms);
            self.0.run_until(until, &mut self.1);
        }

        fn start(&mut self) {
            self.0.send(0, b"RUN\r");
            self.run(50);
        }

        fn value(&mut self, name: &str) -> f64 {
            match self.motor().debug(Debug::Read(name.to_owned())) {
                DebugReply::Value(Value::Number(number)) => number,
                other => panic!("{name}: {other:?}"),
            }
        }

        fn line(&mut self) -> Option<u32> {
            self.motor().status().line
        }
    }

    #[test]
    fn a_breakpoint_on_while_stops_every_pass() {
        let (mut bed, lines) = Bed::new();
        assert_eq!(lines[..5], [Some(1), None, None, Some(2), Some(3)]);
        bed.motor().debug(Debug::Breakpoints(vec![2]));
        bed.start();
        for pass in 0..4 {
            assert_eq!(bed.motor().status().run, RunState::Paused);
            assert_eq!((bed.line(), bed.value("a")), (Some(2), f64::from(pass)));
            // The motor is still there for its host.
            bed.0.send(0, b"c=c+1\r");
            bed.run(20);
            assert_eq!(bed.value("c"), f64::from(pass + 1));
            bed.motor().debug(Debug::Control(Control::Continue));
            bed.run(20);
        }
        assert_eq!(bed.value("b"), 9.0);
        bed.run(50);
        assert_eq!(bed.motor().status().run, RunState::Idle);
    }

    #[test]
    fn a_step_is_one_statement_and_a_wait_is_one_too() {
        let (mut bed, _) = Bed::new();
        bed.motor().debug(Debug::Breakpoints(vec![1]));
        bed.start();
        let mut seen = Vec::new();
        let mut spent = Vec::new();
        while bed.motor().status().run == RunState::Paused {
            seen.push(bed.line().unwrap());
            spent.push(bed.motor().status().spent);
            assert_eq!(
                bed.motor().debug(Debug::Control(Control::Step)),
                DebugReply::Done
            );
            bed.run(60);
        }
        assert_eq!(seen, [1, 2, 3, 4, 2, 3, 4, 2, 3, 4, 2, 5, 6, 7]);
        assert!(spent.is_sorted_by(|a, b| a < b));
        let refused = bed.motor().debug(Debug::Control(Control::Step));
        assert!(matches!(refused, DebugReply::Refused(_)));
        // The same place again, by what the statements have cost.
        bed.motor().debug(Debug::Breakpoints(Vec::new()));
        let start = bed.motor().status().spent;
        bed.motor().debug(Debug::Breakpoints(vec![1]));
        bed.start();
        let offset = bed.motor().status().spent - spent[0];
        assert!(offset > 0 && start < spent[0] + offset);
        bed.motor()
            .debug(Debug::Control(Control::RunTo(spent[5] + offset)));
        bed.run(60);
        assert_eq!((bed.line(), bed.value("a")), (Some(seen[5]), 1.0));
    }

    #[test]
    fn variables_are_read_and_set_by_their_names() {
        let (mut bed, _) = Bed::new();
        bed.run(1);
        let set = |bed: &mut Bed, name: &str, number: f64| {
            let command = Debug::Write(name.to_owned(), Value::Number(number));
            bed.motor().debug(command) == DebugReply::Done
        };
        assert!(set(&mut bed, "i", 2.0) && set(&mut bed, "al[i]", -7.0));
        assert_eq!((bed.value("cc"), bed.value("aw[5]")), (-7.0, -1.0));
        assert!(set(&mut bed, "V", 1000.0) && set(&mut bed, "EPTR", 5.0));
        assert_eq!((bed.value("V"), bed.value("EPTR")), (1000.0, 5.0));
        for (name, number) in [
            ("a", 0.5),
            ("a", 1e10),
            ("al[51]", 1.0),
            ("Bt", 1.0),
            ("", 1.0),
        ] {
            assert!(!set(&mut bed, name, number), "{name}");
        }
        let mode = bed.motor().debug(Debug::Read("RMODE".to_owned()));
        assert_eq!(mode, DebugReply::Value(Value::Text("O".to_owned())));
        for name in ["5", "G", "foo", "a+b", "al[99]"] {
            let read = bed.motor().debug(Debug::Read(name.to_owned()));
            assert!(matches!(read, DebugReply::Refused(_)), "{name}");
        }
    }
}
