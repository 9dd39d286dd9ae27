use super::super::line::Line;
use super::super::memory::Eeprom;
use super::super::motor::{Flag, Motor};
use super::super::vm::{Vm, World};
use super::*;
use crate::exec::Credit;

/// Runs a program to its end, or for ten million statements.
fn run(text: &str) -> (Vm, Motor) {
    let (image, problems) = compile(text.as_bytes(), None);
    assert_eq!(problems, [], "{text}");
    let (mut vm, mut motor) = (Vm::default(), Motor::new());
    let (mut line, mut eeprom) = (Line::new(0, false), Eeprom::default());
    motor.power_up();
    vm.set_program(image);
    vm.start(true);
    let mut credit = Credit {
        balance: i64::MAX / 2,
        spent: 0,
    };
    let mut world = World {
        motor: &mut motor,
        line: &mut line,
        eeprom: &mut eeprom,
        log: None,
        host: false,
        authentic: false,
        checksum: "",
    };
    assert_eq!(
        vm.run(&mut credit, &mut world),
        super::super::code::Exit::End
    );
    (vm, motor)
}

/// Variables a, b, c and so on after a program.
fn variables(text: &str, count: usize) -> Vec<i32> {
    run(text).0.registers[..count].to_vec()
}

#[test]
fn structures_direct_the_program() {
    for (text, expected) in [
        ("WHILE a<10 a=a+1 LOOP END", [10, 0, 0]),
        ("WHILE 1 a=a+1 IF a==4 BREAK ENDIF LOOP b=1 END", [4, 1, 0]),
        ("IF a b=1 ELSEIF a==0 b=2 ELSE b=3 ENDIF END", [0, 2, 0]),
        ("IF a==1 b=1 ELSE b=3 ENDIF c=1 END", [0, 3, 1]),
        (
            "a=2 SWITCH a CASE 1 b=1 BREAK CASE 2 b=2 CASE 3 c=3 BREAK DEFAULT b=9 ENDS END",
            [2, 2, 3],
        ),
        (
            "a=7 SWITCH a CASE 1 b=1 BREAK DEFAULT b=9 ENDS END",
            [7, 9, 0],
        ),
        ("a=7 SWITCH a CASE 1 b=1 BREAK ENDS c=4 END", [7, 0, 4]),
        (
            "a=5 b=3 SWITCH a-b CASE b-1 c=8 BREAK CASE a c=9 ENDS END",
            [5, 3, 8],
        ),
        (
            "WHILE a<3 a=a+1 SWITCH a CASE 2 b=b+1 BREAK ENDS LOOP END",
            [3, 1, 0],
        ),
        ("GOSUB5 b=2 END C5 a=a+1 RETURN", [1, 2, 0]),
        ("GOTO1 a=9 C1 b=1 END", [0, 1, 0]),
        ("C1 a=a+1 IF a<5 GOTO1 ENDIF END", [5, 0, 0]),
    ] {
        assert_eq!(variables(text, 3), expected, "{text}");
    }
}

#[test]
fn arithmetic_is_that_of_32_bits() {
    for (text, value, overflow) in [
        ("a=2147483647 a=a+1 END", i32::MIN, true),
        ("a=-2147483648 a=a-1 END", i32::MAX, true),
        ("b=65536 a=b*b END", 0, true),
        ("a=7 b=0 a=a/b END", 0, true),
        ("b=-7 a=b/2 END", -3, false),
        ("b=-2147483648 c=-1 a=b/c END", i32::MIN, true),
        ("b=12 a=b&10 END", 8, false),
        ("b=12 a=b|3 END", 15, false),
        ("b=3 a=b>2 END", 1, false),
        ("b=3 a=b>=4 END", 0, false),
        ("b=3 a=b!=3 END", 0, false),
        ("b=5 a=-b END", -5, false),
    ] {
        let (vm, motor) = run(text);
        assert_eq!(vm.registers[0], value, "{text}");
        assert_eq!(motor.is(Flag::MathOverflow), overflow, "{text}");
    }
}

#[test]
fn elements_share_memory_and_bad_indices_are_told() {
    let (vm, motor) = run("aa=66051 a=ab[0] b=ab[1] c=aw[0] d=1 al[d+d]=a e=cc END");
    assert_eq!(vm.registers[..5], [3, 2, 515, 1, 3]);
    assert!(!motor.is(Flag::IndexRange));
    let (vm, motor) = run("t=6 aw[t] 63 44 98. a=aw[6] b=aw[7] c=aw[8] END");
    assert_eq!(vm.registers[..3], [63, 44, 98]);
    assert!(!motor.is(Flag::IndexRange));
    for bad in ["ab[201]=1", "a=aw[101]", "i=-1 al[i]=5", "aw[100] 1 2."] {
        let (_, motor) = run(&format!("{bad} END"));
        assert!(motor.is(Flag::IndexRange), "{bad}");
    }
}

#[test]
fn structures_nest_as_deep_as_a_program_is_long() {
    let depth = 1500;
    let text = "IF 1 ".repeat(depth) + "a=1 " + &"ENDIF ".repeat(depth) + "END";
    assert_eq!(variables(&text, 1), [1]);
    let text =
        "WHILE 1 SWITCH 2 CASE 2 ".repeat(700) + "a=1 " + &"ENDS BREAK LOOP ".repeat(700) + "END";
    assert_eq!(variables(&text, 1), [1]);
}

#[test]
fn constants_beyond_the_registers_are_loaded() {
    let sums: String = (0..3000).map(|n| format!("a=a+{}\n", 70_000 + n)).collect();
    let expected = (0..3000).map(|n| 70_000 + n).sum::<i32>();
    assert_eq!(variables(&(sums + "END"), 1), [expected]);
}

#[test]
fn calls_nest_nine_deep() {
    let calls: String = (1..=9)
        .map(|n| format!("C{n} a=a+1 GOSUB{} RETURN ", n + 1))
        .collect();
    let nine = format!("GOSUB2 END {calls} C10 a=a+1 RETURN");
    let (vm, motor) = run(&nine);
    assert_eq!((vm.registers[0], motor.is(Flag::Syntax)), (9, false));
    let (vm, motor) = run(&nine.replace("GOSUB2 END", "GOSUB1 END"));
    assert_eq!((vm.registers[0], motor.is(Flag::Syntax)), (9, true));
    let (_, motor) = run("RETURN END");
    assert!(motor.is(Flag::Syntax));
    let (vm, motor) = run("GOSUB1 a=9 END C1 STACK RETURN b=1 END");
    assert_eq!(vm.registers[..2], [0, 1]);
    assert!(motor.is(Flag::Syntax));
}
