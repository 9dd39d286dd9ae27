#[test]
fn dbg() {
    println!(
        "{:?}",
        motionbench_core::mc600::parser::parse_statements(b"PRINT 2+2:RUN")
    );
    println!(
        "{:?}",
        motionbench_core::mc600::diagnose::diagnose("10 PRINT 2+2\n20 A$=5")
    );
}
