use motionbench_core::{bench::Bench, catalog, probe::Probe, time::Nanos};
fn main() {
    let mut bench = Bench::new();
    let fast = std::env::args().any(|a| a == "fast");
    let options = if fast {
        vec![("speed".to_string(), "fast".to_string())]
    } else {
        vec![]
    };
    let station = (catalog::kind("mc600").unwrap().create)(&options).unwrap();
    bench.add("mc600", station, None);
    bench.power(0, true);
    let mut probe = Probe::default();
    probe.log_motion = true;
    let mut t = 0u64;
    for line in std::io::stdin().lines() {
        let line = line.unwrap();
        if let Some(ms) = line.strip_prefix("!run ") {
            t += ms.parse::<u64>().unwrap();
            bench.run_until(Nanos::from_millis(t), &mut probe);
            continue;
        }
        if line == "!c" {
            bench.send(0, b"\x03");
        } else {
            bench.send(0, line.as_bytes());
            bench.send(0, b"\r");
        }
        loop {
            t += 10;
            bench.run_until(Nanos::from_millis(t), &mut probe);
            let s = bench.station(0).unwrap().status();
            if bench.is_quiet() && s.at_prompt && s.unread == 0 {
                break;
            }
            if t > 100000 {
                println!("TIMEOUT {s:?}");
                break;
            }
            if line == "RUN" && !bench.is_quiet() {
                continue;
            }
            if matches!(s.run, motionbench_core::controller::RunState::Waiting(_))
                && bench.is_quiet()
            {
                break;
            }
        }
    }
    let text: Vec<u8> = probe.console.iter().map(|c| c.byte).collect();
    println!("{}", String::from_utf8_lossy(&text));
    println!("{:?} {:?}", probe.motion, bench.now());
}
