//! Two cards on one ServoBus stay locked for a simulated hour.
#![cfg(not(target_family = "wasm"))]

use motionbench_tests::conformance;

/// The follower compares its demand with the master's position as fast as it can; each minute ends at rest.
const HOUR: &str = "
bench mc600 as MASTER
bench mc600 as FOLLOWER encoder=servobus
MASTER: power on
FOLLOWER: power on
FOLLOWER: program
10 GR_RATION%=17: GR_RATIOID%=23: GR_ACC%=2000: MDRVEN()
20 IF GV_STATUS%<>1063 THEN 20
30 MGEAR(5)
40 IF GR_FLAG%<>2 THEN 40
50 IF GR_FLAG%<>2 THEN E%=E%+1
60 GOTO 50
end
MASTER: type MSETSB(1)
MASTER: reply \"\"
FOLLOWER: type RUN
run 1s
repeat 60
MASTER: wire encoder.speed 25600
run 59s
MASTER: wire encoder.speed 0
run 1s
end
MASTER: check gv_canout% = 177000000
FOLLOWER: check gv_canin% = 177000000
FOLLOWER: check gv_master% = 177000000
FOLLOWER: check gr_flag% = 2
FOLLOWER: check e% = 0
FOLLOWER: check sl_posdemand% = 130826087
FOLLOWER: check gv_feedback% = 130826087
";

#[test]
fn two_cards_stay_locked_for_an_hour() {
    let report = conformance::run_text("mc600/hour.scenario", HOUR);
    assert!(report.is_ok(), "{}: {}", report.line, report.message);
}
