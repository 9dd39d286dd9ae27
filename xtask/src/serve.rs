//! `cargo xtask serve`: builds the page, serves it on loopback, builds again on a change.

use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::process::Command;
use std::time::Duration;

use crate::report::Report;
use crate::setup::Need::{Bindgen, Libraries, Node, Rust, Trunk};
use crate::{Result, offline, shell};

const FIRST_PORT: u16 = 8080;

/// Serves until it is stopped with Ctrl-C. `--dev` builds without optimising the page.
pub(crate) fn run(arguments: &[&str]) -> Result<()> {
    let (release, port) = options(arguments)?;
    let mut report = Report::default();
    for need in [Rust, Libraries, Bindgen, Trunk, Node] {
        if !need.provide(&mut report) {
            return report.expect_passed();
        }
    }
    // A folder of its own, so that a test of the site can run beside.
    let mut common = vec!["--offline", "--dist", "target/served"];
    common.extend(release.then_some("--release"));
    let what = if release {
        "built as it is published (2 to 3 minutes the first time)"
    } else {
        "built for development (1 to 2 minutes the first time)"
    };
    // The server would start on a build that failed, and serve nothing.
    report.step("page", what, || {
        shell::run(trunk(&[&["build"], &common[..]].concat()))
    });
    report.expect_passed()?;
    serve(&common, port)
}

/// Runs the server, says where when it answers, and waits for its end.
fn serve(common: &[&str], port: u16) -> Result<()> {
    println!("\n==> server: builds again when a source changes; reload the page to see it");
    let number = port.to_string();
    let arguments = [&["serve", "--port", &number], common].concat();
    let mut trunk = trunk(&arguments)
        .spawn()
        .map_err(|error| format!("trunk: {error}"))?;
    let mut announced = false;
    loop {
        let ended = trunk
            .try_wait()
            .map_err(|error| format!("trunk: {error}"))?;
        if let Some(status) = ended {
            return Err(format!("the server ended: {status}"));
        }
        if !announced && TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_ok() {
            announced = true;
            println!("\n    http://127.0.0.1:{port}/    (Ctrl-C stops)\n");
        }
        std::thread::sleep(Duration::from_millis(200));
    }
}

/// Trunk, for a page that is always the one built last: no service worker keeps it.
fn trunk(arguments: &[&str]) -> Command {
    let mut command = shell::command("trunk", arguments);
    command.env(offline::DEVELOPMENT, "1");
    command
}

/// Whether to build a release, and the port: the one asked for, else the first free one.
fn options(arguments: &[&str]) -> Result<(bool, u16)> {
    let mut release = true;
    let mut port = None;
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        match *argument {
            "--dev" => release = false,
            "--port" => {
                let number = rest.next().and_then(|number| number.parse().ok());
                port = Some(number.ok_or("--port needs a number from 1 to 65535")?);
            }
            other => {
                return Err(format!(
                    "serve does not know {other}; it knows --dev, --port N"
                ));
            }
        }
    }
    let free = |port: &u16| TcpListener::bind((Ipv4Addr::LOCALHOST, *port)).is_ok();
    match port {
        Some(port) if free(&port) => Ok((release, port)),
        Some(port) => Err(format!("port {port} is in use")),
        None => (FIRST_PORT..FIRST_PORT + 100)
            .find(free)
            .map(|port| (release, port))
            .ok_or_else(|| format!("no free port from {FIRST_PORT} on")),
    }
}
