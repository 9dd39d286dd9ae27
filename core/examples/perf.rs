use motionbench_core::{bench::Bench, catalog, controller::*, probe::Probe, time::Nanos};
use std::time::Instant;
fn run(text: &str) -> f64 {
    let mut bench = Bench::new();
    let station =
        (catalog::kind("mc600").unwrap().create)(&[("speed".into(), "fast".into())]).unwrap();
    bench.add("mc600", station, None);
    bench.power(0, true);
    bench
        .station_mut(0)
        .unwrap()
        .load(&Slot::Program, text)
        .unwrap();
    let mut probe = Probe::default();
    bench.send(0, b"RUN\r");
    bench.run_until(Nanos::from_millis(6), &mut probe);
    let t = Instant::now();
    let mut ms = 6;
    loop {
        ms += 2;
        bench.run_until(Nanos::from_millis(ms), &mut probe);
        if bench.is_quiet() && bench.station(0).unwrap().status().at_prompt {
            break;
        }
        if ms > 10_000_000 {
            panic!()
        }
    }
    let s: String = probe.console.iter().map(|c| c.byte as char).collect();
    if !s.contains("DONE") {
        println!("{s}");
    }
    t.elapsed().as_secs_f64() * 1e9
}
fn refloop(n: f64) -> f64 {
    // simple reference
    let code: Vec<[u16; 4]> = vec![[0, 0, 1, 0], [1, 1, 2, 3]];
    let mut r = [0.0f64; 16];
    r[1] = 1.0;
    r[2] = 1.0;
    r[3] = n;
    let t = Instant::now();
    let mut pc = 0usize;
    loop {
        let op = code[pc];
        pc += 1;
        match op[0] {
            0 => r[op[3] as usize & 15] = r[op[1] as usize & 15] + r[op[2] as usize & 15],
            1 => {
                let v = r[1] + r[2];
                r[1] = v;
                if v <= r[op[3] as usize & 15] {
                    pc = 0
                } else {
                    break;
                }
            }
            _ => {}
        }
    }
    let e = t.elapsed().as_secs_f64() * 1e9 / n;
    if r[0] < 0.0 {
        println!("x")
    }
    e
}
fn main() {
    println!("ref {:.2}", refloop(20e6));
    let progs: Vec<(&str, Box<dyn Fn(u64) -> String>, u64, f64)> = vec![
        (
            "1",
            Box::new(|n| {
                format!("10 S=0\n20 FOR I=1 TO {n}\n30 S=S+I\n40 NEXT\n50 PRINT \"DONE\"")
            }),
            2_000_000,
            1.0,
        ),
        (
            "1i",
            Box::new(|n| {
                format!("10 S%=0\n20 FOR I%=1 TO {n}\n30 S%=S%+1\n40 NEXT\n50 PRINT \"DONE\"")
            }),
            2_000_000,
            1.0,
        ),
        (
            "2",
            Box::new(|n| {
                format!(
                    "5 DIM F(7000)\n10 FOR Q=1 TO {n}\n20 FOR I=0 TO 7000:F(I)=1:NEXT\n30 FOR I=2 TO 7000\n40 IF F(I)=0 THEN 70\n50 FOR K=I+I TO 7000 STEP I:F(K)=0:NEXT\n70 NEXT I\n80 NEXT Q\n90 PRINT \"DONE\""
                )
            }),
            60,
            25602.0,
        ),
        (
            "3",
            Box::new(|n| {
                format!(
                    "10 FOR Q=1 TO {n}\n20 A$=\"\":T=0\n30 FOR I=1 TO 40:A$=A$+\"X\"+MID$(\"ABCDEFGH\",I-INT(I/8)*8+1,1):T=T+LEN(A$):NEXT\n40 FOR I=1 TO 80:IF MID$(A$,I,1)=\"X\" THEN T=T+1\n45 NEXT\n50 NEXT Q\n60 PRINT \"DONE\""
                )
            }),
            10000,
            120.0,
        ),
        (
            "4",
            Box::new(|n| {
                format!("10 FOR I=1 TO {n}:GOSUB 100:NEXT\n20 PRINT \"DONE\":END\n100 C=C+1:RETURN")
            }),
            1_000_000,
            1.0,
        ),
        (
            "5",
            Box::new(|n| {
                format!(
                    "10 FOR Q=1 TO {n}\n20 FOR I=1 TO 10:FOR J=1 TO 10:X=SQRT(I*J)+SIN(J):IF X>3 THEN A=A+1\n25 IF X<2 THEN B=B+1\n30 NEXT:NEXT:NEXT\n60 PRINT \"DONE\""
                )
            }),
            5000,
            100.0,
        ),
    ];
    for (name, f, n, passes) in progs {
        let a = run(&f(n));
        let b = run(&f(n * 2));
        println!("{name}: {:.2} ns", (b - a) / (n as f64 * passes));
    }
}
