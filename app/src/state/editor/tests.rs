//! An editor and a controller that agree and do not.

use motionbench_core::bench::Bench;
use motionbench_core::catalog::{self, Station};
use motionbench_core::controller::Slot;
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

use super::*;

const PROGRAM: &str = "10 MDRVEN()\n20 A=1\n30 PRINT A\n40 GOTO 20";

const NONE: [u32; 0] = [];

/// The editor of a page, and the controller that it loads into.
struct Desk {
    editor: EditorState,
    station: Station,
}

impl Desk {
    fn new(text: &str) -> Desk {
        let kind = catalog::kind("mc600").unwrap();
        let station = kind.create(&[]).unwrap();
        let editor = EditorState::new(kind, text);
        let mut desk = Desk { editor, station };
        desk.hear();
        desk
    }

    /// What the page does with every frame.
    fn hear(&mut self) {
        let controller = self.station.controller();
        let revision = controller.status().revision;
        if self.editor.heard_revision(revision) {
            let listing = controller.listing(&Slot::Program).unwrap();
            self.editor.heard_listing(revision, &listing);
        }
    }

    /// What the page does when Run is pressed.
    fn load(&mut self) -> Vec<u32> {
        let breakpoints = self.editor.send();
        self.arrive();
        breakpoints
    }

    fn arrive(&mut self) {
        let text = self.editor.sent.as_ref().unwrap().text.clone();
        let controller = self.station.controller_mut();
        match controller.load(&Slot::Program, &text) {
            Ok(revision) => self.editor.loaded(revision),
            Err(_) => self.editor.refused(),
        }
        self.hear();
    }

    /// Somebody gives the controller another program.
    fn elsewhere(&mut self, program: &str) {
        self.station
            .controller_mut()
            .load(&Slot::Program, program)
            .unwrap();
        self.hear();
    }

    /// Puts a line in front of one.
    fn insert(&mut self, before: u32, line: &str) {
        let mut lines: Vec<&str> = self.editor.text().split('\n').collect();
        lines.insert(usize::try_from(before).unwrap(), line);
        let text = lines.join("\n");
        let edit = Edit {
            first: before,
            at_start: true,
            last: before,
            at_end: false,
            breaks: 1,
        };
        self.editor.edit(text, &[edit]);
    }

    fn agreement(&self) -> Agreement {
        self.editor.agreement()
    }
}

#[test]
fn a_program_is_loaded_changed_and_changed_back() {
    let mut desk = Desk::new(PROGRAM);
    assert_eq!(desk.agreement(), Agreement::NotLoaded);
    desk.load();
    assert_eq!(desk.agreement(), Agreement::Same);
    desk.insert(1, "15 B=2");
    assert_eq!(desk.agreement(), Agreement::EditorChanged);
    let delete = Edit {
        first: 1,
        at_start: true,
        last: 2,
        at_end: false,
        breaks: 0,
    };
    desk.editor.edit(PROGRAM.to_owned(), &[delete]);
    assert_eq!(desk.agreement(), Agreement::Same);
}

#[test]
fn a_program_that_came_from_elsewhere_is_not_taken_for_ours() {
    let mut desk = Desk::new(PROGRAM);
    desk.load();
    desk.editor.toggle_breakpoint(2);
    desk.editor.set_running(Some(30));
    assert_eq!(desk.editor.running(), Some(2));
    desk.elsewhere("10 MDRVEN()\n30 STOP");
    assert_eq!(desk.agreement(), Agreement::ControllerDiffers);
    assert_eq!(desk.editor.running(), None);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), NONE);
    let numbers = desk
        .editor
        .differences()
        .into_iter()
        .map(|difference| difference.number);
    assert_eq!(numbers.collect::<Vec<_>>(), [20, 30, 40]);
}

#[test]
fn the_same_program_from_elsewhere_is_the_same() {
    let mut desk = Desk::new("10 print 5\n\n20 goto 10");
    desk.editor.toggle_breakpoint(2);
    desk.elsewhere("10 PRINT 5\r20 GOTO 10");
    assert_eq!(desk.agreement(), Agreement::Same);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [20]);
    desk.elsewhere("");
    assert_eq!(desk.agreement(), Agreement::NotLoaded);
}

#[test]
fn what_is_taken_from_the_controller_agrees_and_keeps_breakpoints() {
    let mut desk = Desk::new(PROGRAM);
    desk.load();
    desk.editor.toggle_breakpoint(1);
    desk.editor.toggle_breakpoint(3);
    desk.elsewhere("10 MDRVEN()\n15 B=1\n20 A=2\n30 PRINT A");
    let listing = desk.editor.listing().unwrap().to_owned();
    let takes = desk.editor.takes();
    desk.editor.take(&listing);
    assert_eq!(desk.agreement(), Agreement::Same);
    assert!(desk.editor.takes() > takes);
    // Line 20 stands lower now; line 40 is gone.
    assert_eq!(desk.editor.breakpoints(), [2]);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [20]);
}

#[test]
fn a_breakpoint_stays_with_its_line() {
    let mut desk = Desk::new(PROGRAM);
    assert_eq!(desk.editor.toggle_breakpoint(2), Toggled::Set);
    assert_eq!(desk.load(), [30]);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [30]);
    desk.insert(1, "15 B=2");
    assert_eq!(desk.editor.breakpoints(), [3]);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [30]);
    // A line that the controller does not have yet stops nothing.
    assert_eq!(desk.editor.toggle_breakpoint(1), Toggled::Set);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [30]);
    assert_eq!(desk.load(), [15, 30]);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [15, 30]);
    assert_eq!(desk.editor.toggle_breakpoint(3), Toggled::Cleared);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [15]);
}

#[test]
fn a_blank_line_takes_no_breakpoint() {
    let mut editor = Desk::new("10 END\n  \n20 REM X\n").editor;
    assert_eq!(editor.toggle_breakpoint(1), Toggled::Blank);
    assert_eq!(editor.toggle_breakpoint(3), Toggled::Blank);
    assert_eq!(editor.toggle_breakpoint(9), Toggled::Blank);
    assert_eq!(editor.breakpoints(), NONE);
}

#[test]
fn the_running_line_is_where_its_text_is_now() {
    let mut desk = Desk::new(PROGRAM);
    desk.load();
    assert!(desk.editor.set_running(Some(30)));
    assert!(!desk.editor.set_running(Some(30)));
    desk.insert(0, "5 REM");
    assert_eq!(desk.editor.running(), Some(3));
    // Another number is not what runs: the controller still has line 30.
    let text = desk.editor.text().replace("30 PRINT", "35 PRINT");
    let edit = Edit {
        first: 3,
        at_start: true,
        last: 3,
        at_end: false,
        breaks: 0,
    };
    desk.editor.edit(text, &[edit]);
    assert_eq!(desk.editor.running(), Some(3));
    desk.editor.set_running(None);
    assert_eq!(desk.editor.running(), None);
}

#[test]
fn an_edit_made_while_the_text_travels_moves_its_lines() {
    let mut desk = Desk::new(PROGRAM);
    desk.editor.toggle_breakpoint(2);
    desk.editor.send();
    desk.insert(0, "5 REM");
    desk.arrive();
    assert_eq!(desk.agreement(), Agreement::EditorChanged);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), [30]);
    assert_eq!(desk.editor.document_line(10), Some(1));
    assert_eq!(desk.editor.document_line(5), None);
}

#[test]
fn of_two_lines_with_one_number_the_later_runs() {
    let mut desk = Desk::new("10 A=1\n10 A=2\n20 END");
    desk.load();
    assert_eq!(desk.editor.document_line(10), Some(1));
    desk.editor.toggle_breakpoint(0);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), NONE);
}

#[test]
fn a_text_that_the_controller_refuses_changes_nothing() {
    let mut desk = Desk::new(PROGRAM);
    desk.load();
    desk.insert(0, "PRINT 1");
    desk.load();
    assert_eq!(desk.agreement(), Agreement::EditorChanged);
    assert_eq!(desk.editor.document_line(10), Some(1));
}

#[test]
fn the_first_program_moves_the_axis_to_and_fro_within_two_seconds() {
    let editor = Desk::new(catalog::KINDS[0].first_program).editor;
    assert_eq!(editor.problems().len(), 0);
    let kind = editor.kind();
    let mut bench = Bench::new();
    let station = bench.add(kind.id, kind.create(&[]).unwrap(), None);
    bench.power(station, true);
    let mut probe = Probe::recording();
    bench.run_until(Nanos::from_millis(500), &mut probe);
    let controller = bench.station_mut(station).unwrap();
    controller
        .load(&Slot::Program, catalog::KINDS[0].first_program)
        .unwrap();
    bench.send(bench.line_of(station).unwrap(), b"RUN\r");
    bench.run_until(Nanos::from_millis(2500), &mut probe);
    let printed: Vec<u8> = probe.console.iter().map(|sent| sent.byte).collect();
    let printed = String::from_utf8_lossy(&printed);
    assert!(
        printed.contains("RUN\r\nOUT 40960 \r\nBACK 0 \r\n"),
        "{printed}"
    );
}

#[test]
fn another_text_is_begun_with_its_own_breakpoints() {
    let mut desk = Desk::new(PROGRAM);
    desk.editor.toggle_breakpoint(3);
    desk.load();
    desk.editor.open("10 END\r\n20 END", [1]);
    assert_eq!(desk.editor.text(), "10 END\n20 END");
    assert_eq!(desk.editor.breakpoints(), [1]);
    assert_eq!(desk.editor.opens(), 1);
    // The controller still has the one before, which came from here.
    assert_eq!(desk.agreement(), Agreement::EditorChanged);
    assert_eq!(desk.editor.document_line(10), None);
    assert_eq!(desk.editor.breakpoints_as_device_lines(), NONE);
    desk.elsewhere(PROGRAM);
    assert_eq!(desk.agreement(), Agreement::ControllerDiffers);
    desk.editor.open(PROGRAM, []);
    assert_eq!(desk.agreement(), Agreement::Same);
    assert_eq!(desk.editor.document_line(10), Some(0));
    desk.load();
    desk.editor.open(PROGRAM, []);
    assert_eq!(desk.editor.document_line(40), Some(3));
}

#[test]
fn a_text_that_is_no_program_is_told_so_in_good_time() {
    let prose = "It was a dark and stormy night\n".repeat(1000);
    assert_eq!(Desk::new(&prose).editor.problems().len(), MOST_PROBLEMS);
    let endless = "10 PRINT\n".repeat(100_000);
    let found = Desk::new(&endless).editor.problems();
    assert_eq!(found.len(), 1);
    assert!(
        found[0].cause.contains("250\u{202f}000 characters"),
        "{}",
        found[0].cause
    );
}

#[test]
fn a_controller_that_begins_anew_is_asked_what_it_has() {
    let mut desk = Desk::new(PROGRAM);
    desk.load();
    assert_eq!(desk.editor.agreement(), Agreement::Same);
    // Another one that has changed its program as often.
    let revision = desk.station.controller().status().revision;
    let mut other = Desk::new(PROGRAM);
    while other.station.controller().status().revision < revision {
        other.elsewhere("10 END");
    }
    desk.station = other.station;
    desk.editor.forget_controller();
    desk.hear();
    assert_eq!(desk.editor.agreement(), Agreement::ControllerDiffers);
}
