//! The layers of ARCHITECTURE.md, read from the sources: what each part may name, and where wall time may stand.
#![cfg(not(target_family = "wasm"))]

mod source;

use source::{Source, files, root};

/// Folders of `core/src` that are one controller each.
const CONTROLLERS: [&str; 4] = ["mc600", "mcbasic", "smartmotor", "unidex3"];

/// What core uses of the standard library: nothing that reaches outside the program.
const STANDARD: [&str; 24] = [
    "array",
    "ascii",
    "borrow",
    "boxed",
    "cell",
    "char",
    "cmp",
    "collections",
    "convert",
    "error",
    "f32",
    "f64",
    "fmt",
    "iter",
    "marker",
    "mem",
    "num",
    "ops",
    "option",
    "rc",
    "result",
    "slice",
    "str",
    "string",
];

/// What core names nowhere: wall time, threads and what is shared between them, globals, async, random orders.
const STRANGERS: [&str; 20] = [
    "Arc",
    "HashMap",
    "HashSet",
    "Instant",
    "JoinHandle",
    "LazyCell",
    "LazyLock",
    "Mutex",
    "Once",
    "OnceLock",
    "RwLock",
    "SystemTime",
    "async",
    "await",
    "extern",
    "js_sys",
    "leptos",
    "unsafe",
    "wasm_bindgen",
    "web_sys",
];

/// Macros that core does not use: what they read or write is outside.
const MACROS: [&str; 10] = [
    "dbg",
    "env",
    "eprint",
    "eprintln",
    "include_bytes",
    "include_str",
    "option_env",
    "print",
    "println",
    "thread_local",
];

/// Libraries that core stands on.
const LIBRARIES: [&str; 3] = ["libm", "serde", "smallvec"];

/// What app and runner reach core through.
const DOORS: [&str; 6] = [
    "bench",
    "catalog",
    "controller",
    "language",
    "scenario",
    "trace",
];

/// Plain data that passes through the doors, and the speed command's 32 axes.
const PASSING: [&str; 8] = [
    "exec::Wait",
    "ieee488",
    "motion::rig",
    "probe",
    "serial::Flow",
    "serial::LineSettings",
    "serial::Parity",
    "time",
];

/// Names by which the browser and the standard library tell the time.
const CLOCKS: [&str; 7] = [
    "Date",
    "Instant",
    "Performance",
    "SystemTime",
    "UNIX_EPOCH",
    "performance",
    "timeStamp",
];
/// The files of the app that ask for it: one sets the pace of the simulation, one knows the user's day.
const CLOCK_FILES: [&str; 2] = ["app/src/worker/pacing.rs", "app/src/clock.rs"];

/// Names of timers: they call later, and do not tell the time.
const TIMERS: [&str; 6] = [
    "Interval",
    "Timeout",
    "TimeoutFuture",
    "set_interval",
    "set_timeout",
    "setTimeout",
];
/// The files of the app that set them: the worker rests until there is something to simulate, the page waits before it
/// does again what it is asked to too often, or keeps what has changed.
const TIMER_FILES: [&str; 3] = [
    "app/src/worker/mod.rs",
    "app/src/panels/draw.rs",
    "app/src/clock.rs",
];

/// Lines of a source file, "about 500".
const LONGEST: usize = 520;

/// What breaks a rule, a sentence each.
type Broken = Vec<String>;

fn told(source: &Source, line: usize, what: &str) -> String {
    format!("{}:{line}: {what}", source.name)
}

/// The controller that a file of core belongs to.
fn owner(source: &Source) -> Option<&'static str> {
    let inside = source.name.strip_prefix("core/src/")?;
    CONTROLLERS.into_iter().find(|id| {
        inside
            .strip_prefix(id)
            .is_some_and(|rest| rest.starts_with(['/', '.']))
    })
}

/// Core is a pure function of state, inputs and simulated time.
fn core_is_pure(source: &Source) -> Broken {
    let paths = source.paths();
    let outside = paths.iter().filter(|(_, path)| {
        let mut parts = path.split("::");
        let standard = matches!(parts.next(), Some("std" | "core" | "alloc"));
        standard
            && !parts
                .next()
                .is_some_and(|module| STANDARD.contains(&module))
    });
    let outside = outside.map(|(line, path)| told(source, *line, &format!("core uses {path}")));
    let tokens = source.tokens();
    let pairs = tokens
        .windows(2)
        .map(|pair| (pair[0].0, pair[0].1, pair[1].1));
    let strange = pairs.filter(|&(_, name, next)| {
        let shared = STRANGERS.contains(&name) || name.starts_with("Atomic");
        shared || MACROS.contains(&name) && next == "!" || name == "static" && next == "mut"
    });
    let strange =
        strange.map(|(line, name, next)| told(source, line, &format!("core has {name} {next}")));
    outside.chain(strange).collect()
}

/// Controllers do not know each other, and only the catalogue knows them.
fn controllers_stand_alone(source: &Source) -> Broken {
    let owner = owner(source);
    if source.name == "core/src/catalog.rs" {
        return Broken::new();
    }
    let mut before = "";
    let mut broken = Broken::new();
    for (line, name) in source.tokens() {
        // Types are named after them, too: Mc600.
        let lower = name.to_ascii_lowercase();
        let named = CONTROLLERS.into_iter().find(|id| lower.contains(id));
        let declared = source.name == "core/src/lib.rs" && before == "mod";
        if named.is_some_and(|id| Some(id) != owner) && !declared {
            let what = match owner {
                Some(owner) => format!("{owner} names {name}"),
                None => format!("a shared module names {name}"),
            };
            broken.push(told(source, line, &what));
        }
        before = name;
    }
    broken
}

/// App and runner see of core only what is meant for them.
fn core_is_entered_by_its_doors(source: &Source) -> Broken {
    let paths = source.paths();
    let inside = paths.iter().filter_map(|(line, path)| {
        let path = match path.strip_prefix("motionbench_core") {
            Some("") => "",
            Some(rest) => rest.strip_prefix("::")?,
            None => return None,
        };
        Some((line, path))
    });
    let within = |path: &str, place: &str| {
        path.strip_prefix(place)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with("::"))
    };
    inside
        .filter(|(_, path)| {
            !DOORS
                .iter()
                .chain(&PASSING)
                .any(|place| within(path, place))
        })
        .map(|(line, path)| told(source, *line, &format!("reaches into core::{path}")))
        .collect()
}

/// Few files ask what time it is on the wall, or set timers.
fn time_is_simulated(source: &Source) -> Broken {
    let file = source.name.as_str();
    let clock = |name: &str| CLOCKS.contains(&name) && !CLOCK_FILES.contains(&file);
    let timer = |name: &str| TIMERS.contains(&name) && !TIMER_FILES.contains(&file);
    let tokens = source.tokens();
    let found = tokens.iter().filter(|(_, name)| clock(name) || timer(name));
    let told = |(line, name): &(usize, &str)| {
        let (clocks, timers) = (CLOCK_FILES.join(", "), TIMER_FILES.join(", "));
        told(
            source,
            *line,
            &format!("{name}: clocks belong in {clocks}, timers in {timers}"),
        )
    };
    found.map(told).collect()
}

/// Files can be read in one go.
fn files_are_short(source: &Source) -> Broken {
    let lines = source.text.lines().count();
    match lines > LONGEST {
        true => vec![format!("{} has {lines} lines", source.name)],
        false => Broken::new(),
    }
}

/// Nothing names a folder of the machine that it was written on.
fn no_machine_is_named(source: &Source) -> Broken {
    let folders = ["work", "tmp", "root", "home"].map(|folder| format!("/{folder}/"));
    let lines = source.text.lines().enumerate();
    let named = lines.filter(|(_, line)| folders.iter().any(|folder| line.contains(folder)));
    named
        .map(|(index, line)| {
            told(
                source,
                index + 1,
                &format!("names a folder of a machine: {}", line.trim()),
            )
        })
        .collect()
}

/// Names of the libraries in the section of a manifest.
fn dependencies<'a>(manifest: &'a str, section: &str) -> Vec<&'a str> {
    let lines = manifest.lines().skip_while(|line| *line != section).skip(1);
    lines
        .take_while(|line| !line.starts_with('['))
        .filter_map(|line| Some(line.split_once(['.', '='])?.0.trim()))
        .collect()
}

/// Reads `folders` and applies a rule to every file.
#[track_caller]
fn check(folders: &[&str], endings: &[&str], rule: fn(&Source) -> Broken) {
    let read: Vec<Source> = folders
        .iter()
        .flat_map(|folder| files(folder, endings))
        .collect();
    assert!(!read.is_empty(), "there is nothing in {folders:?}");
    let broken: Vec<String> = read.iter().flat_map(rule).collect();
    assert!(broken.is_empty(), "\n{}", broken.join("\n"));
}

#[test]
fn core_names_nothing_outside_itself() {
    check(&["core/src"], &[".rs"], core_is_pure);
    let manifest = std::fs::read_to_string(root().join("core/Cargo.toml")).unwrap();
    assert_eq!(dependencies(&manifest, "[dependencies]"), LIBRARIES);
}

#[test]
fn controllers_are_named_by_the_catalogue_alone() {
    check(&["core/src"], &[".rs"], controllers_stand_alone);
}

#[test]
fn app_and_runner_enter_core_by_its_doors() {
    check(
        &["app/src", "cli/src"],
        &[".rs"],
        core_is_entered_by_its_doors,
    );
}

#[test]
fn wall_time_stands_in_few_files_of_the_app() {
    check(&["app/src"], &[".rs"], time_is_simulated);
    let named = |file: &str, names: &[&str]| {
        let found = files("app/src", &[".rs"]);
        let found = found.iter().find(|source| source.name == file);
        found.is_some_and(|source| source.tokens().iter().any(|(_, name)| names.contains(name)))
    };
    for file in CLOCK_FILES {
        assert!(named(file, &CLOCKS), "{file} asks no clock any more");
    }
    for file in TIMER_FILES {
        assert!(named(file, &TIMERS), "{file} sets no timer any more");
    }
}

#[test]
fn files_have_about_500_lines_at_most() {
    check(&[""], &[".rs", ".mjs", ".js"], files_are_short);
}

#[test]
fn no_file_names_a_folder_of_a_machine() {
    let endings = [
        ".rs",
        ".toml",
        ".md",
        ".mjs",
        ".js",
        ".css",
        ".html",
        ".json",
        ".scenario",
        ".tsv",
        ".lock",
        "run",
    ];
    check(&[""], &endings, no_machine_is_named);
}

/// The rules notice what they are for.
#[test]
fn broken_rules_are_noticed() {
    let breaks = |rule: fn(&Source) -> Broken, name: &str, text: &str| {
        let source = Source {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        rule(&source).len()
    };
    for text in [
        "use std::time::Instant;",
        "use std::{fmt, thread};",
        "use std as rust;",
        "use std::*;",
        "fn f() { std::fs::read(\"x\"); }",
        "fn f() { core::hint::spin_loop(); }",
        "use std::net::TcpStream;",
        "use std::process;",
        "fn f() { std::env::var(\"X\"); }",
        "type T = std::collections::HashMap<u8, u8>;",
        "thread_local! { static X: u8 = 0; }",
        "static mut X: u8 = 0;",
        "static X: AtomicU8 = AtomicU8::new(0);",
        "async fn f() {}",
        "use web_sys::Window;",
        "fn f() { println!(\"\"); }",
    ] {
        assert_ne!(breaks(core_is_pure, "core/src/files.rs", text), 0, "{text}");
    }
    let pure = "use std::{fmt::{self, Write}, rc::Rc}; // std::time\nfn f() -> &'static str { \"std::fs\" }";
    assert_eq!(breaks(core_is_pure, "core/src/files.rs", pure), 0);

    for (name, text, count) in [
        ("core/src/mcbasic/run.rs", "use crate::mc600::value;", 1),
        (
            "core/src/mc600/run.rs",
            "use crate::smartmotor::{line, unit};",
            1,
        ),
        (
            "core/src/mc600/run.rs",
            "use crate::mc600::value; // mcbasic",
            0,
        ),
        ("core/src/bench.rs", "use crate::mc600::Mc600;", 2),
        (
            "core/src/bench.rs",
            "match station { Station::Unidex3(_) => {} }",
            1,
        ),
        ("core/src/bench.rs", "fn f() { kind(\"mc600\") }", 0),
        ("core/src/catalog.rs", "use crate::mc600::Mc600;", 0),
        ("core/src/lib.rs", "pub mod mc600; pub use mc600::Mc600;", 2),
    ] {
        assert_eq!(
            breaks(controllers_stand_alone, name, text),
            count,
            "{name}: {text}"
        );
    }

    for (text, count) in [
        ("use motionbench_core::mc600::parser;", 1),
        (
            "use motionbench_core::{bench::Bench, plant, time::Nanos};",
            1,
        ),
        ("use motionbench_core as core;", 1),
        ("use motionbench_core::*;", 1),
        ("fn f() { motionbench_core::servo::new(); }", 1),
        ("use motionbench_core::serial::Transmitter;", 1),
        ("use motionbench_core::benchmark::X;", 1),
        (
            "use motionbench_core::bench::Bench; use motionbench_core::serial::{LineSettings, Parity};",
            0,
        ),
    ] {
        assert_eq!(
            breaks(core_is_entered_by_its_doors, "app/src/client.rs", text),
            count,
            "{text}"
        );
    }

    for (name, text, count) in [
        ("app/src/client.rs", "fn f() { js_sys::Date::now(); }", 1),
        (
            "app/src/panels/scope.rs",
            "fn f() { window().performance(); }",
            1,
        ),
        ("app/src/worker/engine.rs", "use std::time::Instant;", 1),
        (
            "app/src/client.rs",
            "use gloo_timers::callback::Timeout;",
            1,
        ),
        (
            "app/src/worker/mod.rs",
            "use gloo_timers::callback::Timeout;",
            0,
        ),
        ("app/src/worker/mod.rs", "fn f() { scope.performance() }", 1),
        (
            "app/src/worker/pacing.rs",
            "fn f() { scope.performance() }",
            0,
        ),
    ] {
        assert_eq!(
            breaks(time_is_simulated, name, text),
            count,
            "{name}: {text}"
        );
    }

    assert_eq!(
        breaks(
            files_are_short,
            "core/src/bench.rs",
            &"\n".repeat(LONGEST + 1)
        ),
        1
    );
    assert_eq!(
        breaks(files_are_short, "core/src/bench.rs", &"\n".repeat(LONGEST)),
        0
    );

    let path = ["see /ho", "me/someone/notes"].concat();
    assert_eq!(breaks(no_machine_is_named, "README.md", &path), 1);
    assert_eq!(
        breaks(no_machine_is_named, "README.md", "the network/home switch"),
        0
    );

    let manifest = "[dependencies]\nlibm.workspace = true\nweb-sys = \"0.3\"\n\n[dev-dependencies]\nproptest = \"1\"\n";
    assert_eq!(
        dependencies(manifest, "[dependencies]"),
        ["libm", "web-sys"]
    );
}
