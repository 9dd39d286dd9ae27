//! The runner as a person or a script meets it: what it prints and how it exits.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of its own for one test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn file(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

fn motionbench(arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_motionbench"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(input.as_bytes())
        .unwrap();
    child.wait_with_output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[track_caller]
fn gives(arguments: &[&str], code: i32, out: &str, err: &str) {
    let output = motionbench(arguments, "");
    let found = (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    );
    assert_eq!(
        found,
        (Some(code), out.to_owned(), err.to_owned()),
        "{arguments:?}"
    );
}

#[test]
fn scenarios_hold_or_not() {
    let folder = folder("scenarios");
    let good = file(
        &folder,
        "good.scenario",
        "bench mc600\npower on\ntype PRINT 6*7\nreply \" 42 \"\n",
    );
    let wrong = file(
        &folder,
        "wrong.scenario",
        "bench mc600\npower on\ntype PRINT 6*7\nreply \" 43 \"\n",
    );
    let bad = file(&folder, "bad.scenario", "bench mc600\n\npower up\n");
    let lost = file(&folder, "lost.scenario", "bench mc600\nload \"none.bas\"\n");
    let none = folder.join("none.scenario").display().to_string();
    let held = format!("ok {good}\n");
    let failed = format!("{wrong}:4: expected the reply \" 43 \", it was \" 42 \"\n");
    gives(&["scenario", &good], 0, &held, "");
    gives(
        &["scenario", &wrong, &good],
        1,
        &format!("{failed}{held}"),
        "",
    );
    let unusable = format!("{bad}:3: expected `on` or `off`, found `up`\n");
    gives(&["scenario", &bad], 2, "", &unusable);
    gives(
        &["scenario", &wrong, &bad, &good],
        2,
        &format!("{failed}{held}"),
        &unusable,
    );
    gives(
        &["scenario", &none],
        2,
        "",
        &format!("{none}: no such file or directory\n"),
    );
    let missing = folder.join("none.bas").display().to_string();
    let message = format!("{lost}:2: {missing}: no such file or directory\n");
    gives(&["scenario", &lost], 2, "", &message);
    assert_eq!(motionbench(&["scenario"], "").status.code(), Some(2));
}

#[test]
fn a_known_failure_is_ok_and_said() {
    let folder = folder("known");
    let known = file(
        &folder,
        "known.scenario",
        "known-failure \"later\"\nbench mc600\npower on\ncheck x.position = 5\n",
    );
    gives(
        &["scenario", &known],
        0,
        &format!("ok {known}\n"),
        &format!("{known}:4: expected x.position = 5, it is 0 (known failure: later)\n"),
    );
}

#[test]
fn files_of_a_scenario_stay_in_its_folder() {
    let folder = folder("files");
    file(&folder, "two.bas", "10 PRINT 1\n20 PRINT 2\n");
    let start = "bench mc600\npower on\nfile put B:T.BAS \"two.bas\"\n";
    let copy = file(
        &folder,
        "copy.scenario",
        &format!("{start}file get B:T.BAS \"copy.bas\"\n"),
    );
    gives(&["scenario", &copy], 0, &format!("ok {copy}\n"), "");
    let copied = std::fs::read_to_string(folder.join("copy.bas")).unwrap();
    assert_eq!(copied, "10 PRINT 1\n20 PRINT 2\n");
    let out = file(
        &folder,
        "out.scenario",
        &format!("{start}file get B:T.BAS \"../out.bas\"\n"),
    );
    let message = format!("{out}: \"../out.bas\" is not in the scenario's folder\n");
    gives(&["scenario", &out], 2, "", &message);
    assert!(!folder.join("../out.bas").exists());
}

#[test]
fn a_program_is_run_to_its_end() {
    let folder = folder("program");
    let program = file(&folder, "two.bas", "10 PRINT 1\r\n20 PRINT 2\r\n");
    gives(
        &["run", "mc600", &program],
        0,
        ">RUN\r\n 1 \r\n 2 \r\n>",
        "",
    );
    let failing = file(&folder, "zero.bas", "10 PRINT 1/0\n");
    gives(
        &["run", "mc600", &failing],
        3,
        ">RUN\r\n?DIVISION BY ZERO ERROR IN 10\r\n>",
        "",
    );
    let bad = file(&folder, "bad.bas", "10 PRINT 1\n\nPRINT 2\n");
    let output = motionbench(&["run", "mc600", &bad], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(
        text(&output.stderr).starts_with(&format!("{bad}:3: ?")),
        "{output:?}"
    );
}

#[test]
fn an_endless_program_stops_in_time() {
    let folder = folder("endless");
    let program = file(&folder, "endless.bas", "10 GOTO 10\n");
    gives(
        &["run", "mc600", &program, "--for", "2s"],
        0,
        ">RUN\r\n",
        "",
    );
    gives(
        &["run", "mc600", &program],
        1,
        ">RUN\r\n",
        "stopped after ten minutes of simulated time: the program runs in line 10; --for sets another time\n",
    );
}

#[test]
fn input_comes_from_the_arguments_or_a_pipe() {
    let folder = folder("input");
    let program = file(&folder, "ask.bas", "10 INPUT A\n20 INPUT B\n30 PRINT A+B\n");
    let sum = ">RUN\r\n? 5\r\n? 7\r\n 12 \r\n>";
    gives(
        &["run", "mc600", &program, "--type", "5", "--type", "7"],
        0,
        sum,
        "",
    );
    let output = motionbench(&["run", "mc600", &program], "5\n7\nPRINT 1\n");
    assert_eq!(
        (output.status.code(), text(&output.stdout)),
        (Some(0), sum.to_owned())
    );
    let output = motionbench(&["run", "mc600", &program], "5\n");
    let found = (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    );
    let asked = ">RUN\r\n? 5\r\n? ".to_owned();
    let message = "stopped: the program waits for input in line 20, and there is none\n".to_owned();
    assert_eq!(found, (Some(1), asked, message));
}

#[test]
fn without_a_program_there_is_the_console() {
    let output = motionbench(&["run", "mc600"], "A=5\nPRINT A*A\n");
    assert_eq!(text(&output.stdout), ">A=5\r\n>PRINT A*A\r\n 25 \r\n>");
    assert_eq!(output.status.code(), Some(0));
    gives(
        &["run", "mc600", "--type", "PRINT 2"],
        0,
        ">PRINT 2\r\n 2 \r\n>",
        "",
    );
    gives(
        &["run", "mc600", "--option", "locked=yes"],
        0,
        "PASSWORD? ",
        "",
    );
}

#[test]
fn a_move_is_recorded_and_drawn() {
    let folder = folder("move");
    let program = file(&folder, "move.bas", "10 MDRVEN()\n20 MMOVE(40960)\n");
    let (csv, svg) = (folder.join("move.csv"), folder.join("move.svg"));
    let (csv_name, svg_name) = (csv.display().to_string(), svg.display().to_string());
    let arguments = [
        "run", "mc600", &program, "--csv", &csv_name, "--plot", &svg_name, "--json",
    ];
    let output = motionbench(&arguments, "");
    assert_eq!(
        (output.status.code(), text(&output.stderr).as_str()),
        (Some(0), "")
    );
    let state: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(state["controller"], "mc600");
    assert_eq!(state["ended"], "idle");
    assert_eq!(state["error"], serde_json::Value::Null);
    assert_eq!(state["console"], ">RUN\r\n>");
    assert_eq!(state["signals"]["x.position"]["value"], 40960.0);
    assert_eq!(state["signals"]["x.position"]["unit"], "counts");
    assert_eq!(state["status"]["moving"], false);

    let csv = std::fs::read_to_string(csv).unwrap();
    let mut lines = csv.lines();
    let heading: Vec<&str> = lines.next().unwrap().split(',').collect();
    let position = heading
        .iter()
        .position(|name| *name == "x.position")
        .unwrap();
    assert_eq!(heading[0], "time_s");
    let last: Vec<f64> = lines
        .next_back()
        .unwrap()
        .split(',')
        .map(|cell| cell.parse().unwrap())
        .collect();
    assert_eq!(last[position], 40960.0);
    assert!((last[0] - state["time_s"].as_f64().unwrap()).abs() < 0.0041);

    let svg = std::fs::read_to_string(svg).unwrap();
    for shown in [
        "<svg",
        "x position [counts]",
        "x velocity [",
        "time [s]",
        "demanded",
        "actual",
        "</svg>",
    ] {
        assert!(svg.contains(shown), "no {shown}");
    }
}

#[test]
fn findings_have_a_place() {
    let folder = folder("check");
    let good = file(&folder, "good.bas", "10 PRINT 1\n20 GOTO 10\n");
    gives(&["check", "mc600", &good], 0, "", "");
    let bad = file(&folder, "bad.bas", "10 PRINT 1\n20 GOTO 30\n");
    let output = motionbench(&["check", "mc600", &bad], "");
    let found = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        found.starts_with(&format!("{bad}:2:9: error: ?UNDEF'D STATEMENT ERROR")),
        "{found}"
    );
    let output = motionbench(&["check", "mc600", &bad, "--json"], "");
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&found[0]["line"], &found[0]["column"]),
        (&2.into(), &9.into())
    );
    assert_eq!(found[0]["severity"], "error");
    let none = folder.join("none.bas").display().to_string();
    gives(
        &["check", "mc600", &none],
        2,
        "",
        &format!("{none}: no such file or directory\n"),
    );
}

#[test]
fn keywords_are_listed() {
    let output = motionbench(&["keywords", "mc600"], "");
    assert_eq!(output.status.code(), Some(0));
    assert!(
        text(&output.stdout)
            .lines()
            .any(|line| line.starts_with("MMOVE "))
    );
    let output = motionbench(&["keywords", "mc600", "--json"], "");
    let rows: Vec<serde_json::Value> = serde_json::from_slice(&output.stdout).unwrap();
    let print = rows.iter().find(|row| row["word"] == "PRINT").unwrap();
    assert_eq!(print["support"], "full");
    for key in ["kind", "syntax", "summary", "section", "example"] {
        assert!(print[key].is_string(), "{key}");
    }
}

#[test]
fn bad_arguments_exit_with_2() {
    for arguments in [
        &["run"][..],
        &["run", "mc601"],
        &["run", "mc600", "--for", "5"],
        &["run", "mc600", "--option", "speed"],
        &["frobnicate"],
        &["check", "mc600"],
        &[],
    ] {
        let output = motionbench(arguments, "");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(
            output.stdout.is_empty() && !output.stderr.is_empty(),
            "{arguments:?}"
        );
    }
    let output = motionbench(&["run", "mc600", "--option", "colour=red"], "");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(message.starts_with("mc600 has no option 'colour'") && message.lines().count() == 1);
    for arguments in [&["--help"][..], &["run", "--help"], &["scenario", "--help"]] {
        let output = motionbench(arguments, "");
        assert_eq!(output.status.code(), Some(0));
        assert!(text(&output.stdout).contains("Example"), "{arguments:?}");
    }
}

#[test]
fn a_smartmotor_is_downloaded_and_run() {
    let folder = folder("smartmotor");
    let program = file(
        &folder,
        "move.sms",
        "A=100 V=300000 'gently\nP=4000 G TWAIT\nPRINT(\"there\",#13)\nEND\n",
    );
    gives(&["check", "smartmotor", &program], 0, "", "");
    gives(&["run", "smartmotor", &program], 0, "there\r", "");
    let asked = motionbench(&["run", "smartmotor"], "a=6*7\nRa\n");
    assert_eq!(text(&asked.stdout), "42\r");
    let bad = file(&folder, "bad.sms", "WHILE 1\nEND\n");
    let output = motionbench(&["check", "smartmotor", &bad], "");
    let expected = format!("{bad}:1:1: error: missing LOOP: No LOOP ends this WHILE.\n");
    assert_eq!(text(&output.stdout), expected);
    // What the vendor's compiler refuses does not reach the motor.
    let output = motionbench(&["run", "smartmotor", &bad], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("missing LOOP"));
}
