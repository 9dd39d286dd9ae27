//! The system variables: what a program reads and writes of the planner, the drive and the I/O.
//!
//! Source: "The Motion planner", "The Motion functions", "The other system variables", "The I/O functions",
//! "Servobus".

/// A system variable of the MC-600.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SysVar {
    /// Counts per motor revolution: 0 is 4096, 1 is 65536.
    Mres,
    /// Acceleration and deceleration of the speed generator.
    SmAcc,
    /// Bit 0: the speed generator does not contribute; bit 2: at speed.
    SmFlag,
    /// Present demand of the speed generator.
    SmSpeed,
    /// Acceleration of moves.
    MvAcc,
    /// Deceleration of moves.
    MvDec,
    /// Highest speed of moves.
    MvSpeed,
    /// Bit 0: no move is active; bits 4 to 6: always positive, always negative, shortest way.
    MvFlag,
    /// Lowest speed of a merge.
    MinSpeed,
    /// Gear ratio, numerator.
    GrRation,
    /// Gear ratio, denominator.
    GrRatioid,
    /// Acceleration of the gear.
    GrAcc,
    /// Speed of the phase recovery.
    GrSpeed,
    /// Bit 0: engaging; bit 1: locked.
    GrFlag,
    /// Distance added to the phase recovery.
    GrPrepost,
    /// Position demand of the cam.
    CmCamout,
    /// Points of the cam table.
    CmNum,
    /// Last point of the cam table used.
    CmIndex,
    /// Bit 0: the cam ends with this modulus.
    CmFlag,
    /// Master position of the cam.
    CmMaster,
    /// Acceleration of the virtual axis.
    VxAcc,
    /// Deceleration of the virtual axis.
    VxDec,
    /// Highest speed of the virtual axis.
    VxSpeed,
    /// Position of the virtual axis.
    VxPos,
    /// Bit 0: the virtual axis is at its target; bit 2: without encoder.
    VxFlag,
    /// Acceleration of the virtual speed.
    VsAcc,
    /// Bit 0: no virtual speed; bit 2: at speed.
    VsFlag,
    /// Present demand of the virtual speed.
    VsSpeed,
    /// Acceleration of phasing.
    PhAcc,
    /// Deceleration of phasing.
    PhDec,
    /// Highest speed of phasing.
    PhSpeed,
    /// Bit 0: no phasing is active.
    PhFlag,
    /// Present phase.
    PhPosition,
    /// Bit 0: homing; bit 1: homed.
    HmFlag,
    /// Master position.
    GvMaster,
    /// Actual position.
    GvFeedback,
    /// Selected encoder.
    GvEncoder,
    /// Speed of the selected encoder.
    GvEncspeed,
    /// Modulus of the master; 0 is none.
    GvMmod,
    /// Modulus of the axis; 0 is none.
    GvSmod,
    /// Reference of the position loop.
    SlPosDemand,
    /// Speed of the position reference.
    SlSpdDemand,
    /// Drive and planner status.
    GvStatus,
    /// Control word of the drive.
    GvCommand,
    /// Drive error code.
    GvError,
    /// Drive warning code.
    GvWarning,
    /// Analog input 1.
    GvAnin1,
    /// Analog input 2.
    GvAnin2,
    /// Drive's trajectory status.
    GvTrjstat,
    /// Drive capture 1, rising.
    GvLatch1,
    /// Drive capture 1, falling.
    GvLatch1n,
    /// Drive capture 2, rising.
    GvLatch2,
    /// Drive capture 2, falling.
    GvLatch2n,
    /// Analog output 1.
    GvMonitor1,
    /// Analog output 2.
    GvMonitor2,
    /// Actual motor speed, 33554432/240000 a rpm.
    GvVelmot,
    /// Torque demand, 3280 at peak.
    GvCurmot,
    /// Bit 0: final position reached; 1: gear locked; 2: at speed; 3: cam locked; 4: homed.
    GvMflag,
    /// Digital input 0 to 12: 8 to 11 are IN1 to IN4 of the drive, 12 its ENABLE.
    GvIn(u8),
    /// Digital output 0 to 9: 8 and 9 are on the drive.
    GvOut(u8),
    /// User variable 1 to 16 of the drive; 9 to 16 are its own to write.
    GvUsvar(u8),
    /// Outputs of the position comparators.
    GvCompare,
    /// Position captured by input 2.
    GvCapposf,
    /// Position captured by input 3.
    GvCappos,
    /// What input 3 captures.
    GvCapsel,
    /// Variable sent on the ServoBus.
    GvCanout,
    /// Variable received from the ServoBus.
    GvCanin,
    /// Received telegrams, an array.
    CanData,
    /// Updated mailboxes.
    CanFlag,
}

impl SysVar {
    /// The variable of that name, in any case and with its `%`. The manual's misprint `minspped%` is understood.
    pub fn from_word(word: &str) -> Option<SysVar> {
        let word = if word.eq_ignore_ascii_case("MINSPPED%") {
            "MINSPEED%"
        } else {
            word
        };
        WORDS
            .iter()
            .find(|(known, _)| known.eq_ignore_ascii_case(word))
            .map(|&(_, var)| var)
    }

    /// Its name, in upper case; empty for an input, output or user variable that the device does not have.
    pub fn word(self) -> &'static str {
        WORDS
            .iter()
            .find(|&&(_, var)| var == self)
            .map_or("", |&(word, _)| word)
    }

    /// All of them, with their names.
    pub fn all() -> &'static [(&'static str, SysVar)] {
        WORDS
    }

    /// Whether a program cannot assign it. The manual says so of `cm_index%` and `vx_pos%`; the others are reports of
    /// the planner, the drive or an input (D68).
    pub fn is_read_only(self) -> bool {
        use SysVar::*;
        match self {
            SmFlag | SmSpeed | GrFlag | CmCamout | CmIndex | CmFlag | CmMaster | VxPos | VsFlag
            | VsSpeed | PhFlag | PhPosition | HmFlag | GvMaster | GvFeedback | GvEncoder
            | GvEncspeed | GvIn(_) | SlPosDemand | SlSpdDemand | GvStatus | GvError | GvWarning
            | GvAnin1 | GvAnin2 | GvTrjstat | GvLatch1 | GvLatch1n | GvLatch2 | GvLatch2n
            | GvVelmot | GvCurmot | GvMflag | GvCompare | GvCapposf | GvCappos | GvCanin
            | GvCanout | CanData => true,
            GvUsvar(number) => number > 8,
            Mres | SmAcc | MvAcc | MvDec | MvSpeed | MvFlag | MinSpeed | GrRation | GrRatioid
            | GrAcc | GrSpeed | GrPrepost | CmNum | VxAcc | VxDec | VxSpeed | VxFlag | VsAcc
            | PhAcc | PhDec | PhSpeed | GvMmod | GvSmod | GvCommand | GvMonitor1 | GvMonitor2
            | GvOut(_) | GvCapsel | CanFlag => false,
        }
    }

    /// Whether it is an array.
    pub fn is_array(self) -> bool {
        self == SysVar::CanData
    }
}

const WORDS: &[(&str, SysVar)] = &[
    ("MRES%", SysVar::Mres),
    ("SM_ACC%", SysVar::SmAcc),
    ("SM_FLAG%", SysVar::SmFlag),
    ("SM_SPEED%", SysVar::SmSpeed),
    ("MV_ACC%", SysVar::MvAcc),
    ("MV_DEC%", SysVar::MvDec),
    ("MV_SPEED%", SysVar::MvSpeed),
    ("MV_FLAG%", SysVar::MvFlag),
    ("MINSPEED%", SysVar::MinSpeed),
    ("GR_RATION%", SysVar::GrRation),
    ("GR_RATIOID%", SysVar::GrRatioid),
    ("GR_ACC%", SysVar::GrAcc),
    ("GR_SPEED%", SysVar::GrSpeed),
    ("GR_FLAG%", SysVar::GrFlag),
    ("GR_PREPOST%", SysVar::GrPrepost),
    ("CM_CAMOUT%", SysVar::CmCamout),
    ("CM_NUM%", SysVar::CmNum),
    ("CM_INDEX%", SysVar::CmIndex),
    ("CM_FLAG%", SysVar::CmFlag),
    ("CM_MASTER%", SysVar::CmMaster),
    ("VX_ACC%", SysVar::VxAcc),
    ("VX_DEC%", SysVar::VxDec),
    ("VX_SPEED%", SysVar::VxSpeed),
    ("VX_POS%", SysVar::VxPos),
    ("VX_FLAG%", SysVar::VxFlag),
    ("VS_ACC%", SysVar::VsAcc),
    ("VS_FLAG%", SysVar::VsFlag),
    ("VS_SPEED%", SysVar::VsSpeed),
    ("PH_ACC%", SysVar::PhAcc),
    ("PH_DEC%", SysVar::PhDec),
    ("PH_SPEED%", SysVar::PhSpeed),
    ("PH_FLAG%", SysVar::PhFlag),
    ("PH_POSITION%", SysVar::PhPosition),
    ("HM_FLAG%", SysVar::HmFlag),
    ("GV_MASTER%", SysVar::GvMaster),
    ("GV_FEEDBACK%", SysVar::GvFeedback),
    ("GV_ENCODER%", SysVar::GvEncoder),
    ("GV_ENCSPEED%", SysVar::GvEncspeed),
    ("GV_MMOD%", SysVar::GvMmod),
    ("GV_SMOD%", SysVar::GvSmod),
    ("SL_POSDEMAND%", SysVar::SlPosDemand),
    ("SL_SPDDEMAND%", SysVar::SlSpdDemand),
    ("GV_STATUS%", SysVar::GvStatus),
    ("GV_COMMAND%", SysVar::GvCommand),
    ("GV_ERROR%", SysVar::GvError),
    ("GV_WARNING%", SysVar::GvWarning),
    ("GV_ANIN1%", SysVar::GvAnin1),
    ("GV_ANIN2%", SysVar::GvAnin2),
    ("GV_TRJSTAT%", SysVar::GvTrjstat),
    ("GV_LATCH1%", SysVar::GvLatch1),
    ("GV_LATCH1N%", SysVar::GvLatch1n),
    ("GV_LATCH2%", SysVar::GvLatch2),
    ("GV_LATCH2N%", SysVar::GvLatch2n),
    ("GV_MONITOR1%", SysVar::GvMonitor1),
    ("GV_MONITOR2%", SysVar::GvMonitor2),
    ("GV_VELMOT%", SysVar::GvVelmot),
    ("GV_CURMOT%", SysVar::GvCurmot),
    ("GV_MFLAG%", SysVar::GvMflag),
    ("GV_IN0%", SysVar::GvIn(0)),
    ("GV_IN1%", SysVar::GvIn(1)),
    ("GV_IN2%", SysVar::GvIn(2)),
    ("GV_IN3%", SysVar::GvIn(3)),
    ("GV_IN4%", SysVar::GvIn(4)),
    ("GV_IN5%", SysVar::GvIn(5)),
    ("GV_IN6%", SysVar::GvIn(6)),
    ("GV_IN7%", SysVar::GvIn(7)),
    ("GV_IN8%", SysVar::GvIn(8)),
    ("GV_IN9%", SysVar::GvIn(9)),
    ("GV_IN10%", SysVar::GvIn(10)),
    ("GV_IN11%", SysVar::GvIn(11)),
    ("GV_IN12%", SysVar::GvIn(12)),
    ("GV_OUT0%", SysVar::GvOut(0)),
    ("GV_OUT1%", SysVar::GvOut(1)),
    ("GV_OUT2%", SysVar::GvOut(2)),
    ("GV_OUT3%", SysVar::GvOut(3)),
    ("GV_OUT4%", SysVar::GvOut(4)),
    ("GV_OUT5%", SysVar::GvOut(5)),
    ("GV_OUT6%", SysVar::GvOut(6)),
    ("GV_OUT7%", SysVar::GvOut(7)),
    ("GV_OUT8%", SysVar::GvOut(8)),
    ("GV_OUT9%", SysVar::GvOut(9)),
    ("GV_USVAR1%", SysVar::GvUsvar(1)),
    ("GV_USVAR2%", SysVar::GvUsvar(2)),
    ("GV_USVAR3%", SysVar::GvUsvar(3)),
    ("GV_USVAR4%", SysVar::GvUsvar(4)),
    ("GV_USVAR5%", SysVar::GvUsvar(5)),
    ("GV_USVAR6%", SysVar::GvUsvar(6)),
    ("GV_USVAR7%", SysVar::GvUsvar(7)),
    ("GV_USVAR8%", SysVar::GvUsvar(8)),
    ("GV_USVAR9%", SysVar::GvUsvar(9)),
    ("GV_USVAR10%", SysVar::GvUsvar(10)),
    ("GV_USVAR11%", SysVar::GvUsvar(11)),
    ("GV_USVAR12%", SysVar::GvUsvar(12)),
    ("GV_USVAR13%", SysVar::GvUsvar(13)),
    ("GV_USVAR14%", SysVar::GvUsvar(14)),
    ("GV_USVAR15%", SysVar::GvUsvar(15)),
    ("GV_USVAR16%", SysVar::GvUsvar(16)),
    ("GV_COMPARE%", SysVar::GvCompare),
    ("GV_CAPPOSF%", SysVar::GvCapposf),
    ("GV_CAPPOS%", SysVar::GvCappos),
    ("GV_CAPSEL%", SysVar::GvCapsel),
    ("GV_CANOUT%", SysVar::GvCanout),
    ("GV_CANIN%", SysVar::GvCanin),
    ("CAN_DATA%", SysVar::CanData),
    ("CAN_FLAG%", SysVar::CanFlag),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_names_its_variable() {
        for &(word, var) in SysVar::all() {
            assert_eq!(SysVar::from_word(word), Some(var));
            assert_eq!(SysVar::from_word(&word.to_lowercase()), Some(var));
            assert_eq!(var.word(), word);
            assert_eq!(SysVar::from_word(word.trim_end_matches('%')), None);
        }
        assert_eq!(SysVar::all().len(), 105);
    }

    #[test]
    fn the_misprint_is_understood() {
        assert_eq!(SysVar::from_word("minspped%"), Some(SysVar::MinSpeed));
    }

    #[test]
    fn inputs_and_outputs_are_numbered_as_on_the_connectors() {
        assert_eq!(SysVar::from_word("gv_in12%"), Some(SysVar::GvIn(12)));
        assert_eq!(SysVar::from_word("gv_in13%"), None);
        assert_eq!(SysVar::from_word("gv_out9%"), Some(SysVar::GvOut(9)));
        assert_eq!(SysVar::from_word("gv_out10%"), None);
        assert!(SysVar::GvUsvar(9).is_read_only() && !SysVar::GvUsvar(8).is_read_only());
    }
}
