use super::*;
use proptest::prelude::*;

const WORDS: [&str; 45] = [
    "G", "G", "G", "X", "S", "OFF", "MP", "MV", "MT", "MD", "MF0", "MF1", "MF2", "MF4", "MFR",
    "MS0", "MS", "MSR", "MC", "MC2", "MC8", "F", "KGON", "KGOFF", "PID1", "PID2", "PID4", "PID8",
    "BRKENG", "BRKRLS", "BRKSRV", "BRKTRJ", "BRKC", "BRKI", "LIMD", "LIMN", "LIMH", "LIML", "UCP",
    "UCI", "UAO", "UG", "ZS", "Zr", "UDM",
];
const NAMES: [&str; 27] = [
    "A", "V", "P", "D", "T", "E", "O", "AMPS", "TH", "KP", "KI", "KD", "KL", "KS", "KV", "KA",
    "KG", "CLK", "MFMUL", "MFDIV", "BASE", "SIZE", "F", "UA", "UC", "UG", "D",
];

/// What a person can do to a motor.
#[derive(Debug, Clone)]
enum Deed {
    Say(usize),
    Set(usize, i32),
    Wire(usize, f64),
    Fault(usize, bool),
    Stream(i32, i32),
    Power(bool),
    Run(u32),
}

fn number() -> impl Strategy<Value = i32> {
    prop_oneof![
        any::<i32>(),
        -100_000i32..1_000_000,
        0i32..100,
        prop::sample::select(vec![i32::MIN, i32::MAX, 0, -1, 1023]),
    ]
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        8 => (0..WORDS.len()).prop_map(Deed::Say),
        8 => (0..NAMES.len(), number()).prop_map(|(name, value)| Deed::Set(name, value)),
        2 => (0..16usize, -10.0..1e7f64).prop_map(|(wire, value)| Deed::Wire(wire, value)),
        2 => (0..FAULTS.len(), any::<bool>()).prop_map(|(fault, on)| Deed::Fault(fault, on)),
        2 => (number(), number()).prop_map(|(position, time)| Deed::Stream(position, time)),
        1 => any::<bool>().prop_map(Deed::Power),
        6 => (1u32..2000).prop_map(Deed::Run),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Nothing overflows, the output keeps its limit, and what is off has no trajectory.
    #[test]
    fn any_order_of_things_leaves_a_motor(deeds in prop::collection::vec(deed(), 1..60)) {
        let mut motor = motor();
        for deed in deeds {
            match deed {
                Deed::Say(word) => motor.command(Command::from_word(WORDS[word]).unwrap()),
                Deed::Set(name, value) => motor.set(Register::writable(NAMES[name]).unwrap(), value),
                Deed::Wire(wire, value) => {
                    let _ = motor.wire(&Motor::wires()[wire], value);
                }
                Deed::Fault(fault, on) => motor.fault(FAULTS[fault], None, on).unwrap(),
                Deed::Stream(position, time) => {
                    motor.stream_position(position);
                    motor.stream_time(time);
                }
                Deed::Power(true) => motor.power_up(),
                Deed::Power(false) => motor.power_off(),
                Deed::Run(samples) => {
                    for _ in 0..samples {
                        motor.sample(|index| i16::from(index) * 300 - 9000);
                        prop_assert!(motor.output.abs() <= 1023);
                    }
                    prop_assert!(!(motor.is(Flag::Off) && motor.is(Flag::Trajectory)));
                }
            }
            let signals = motor.signals();
            prop_assert!(signals.shaft.is_finite() && signals.velocity.is_finite());
            let _ = (motor.is_moving(), motor.fault_words(), motor.mode_letter(), motor.status());
        }
    }
}
