//! Variables, arrays and the EEPROM. In the order of the words' bytes.

use super::{VARIABLES, row_of};
use crate::language::KeywordRow;
use crate::language::Support::Full;

#[rustfmt::skip] // a table
pub(super) const ROWS: &[KeywordRow] = &[
    // word, kind, section, support; syntax, summary, example
    row_of("EPTR=", "variable", VARIABLES, Full,
        ["EPTR=expression", "Sets the place in the EEPROM, 0 to 7999, for VST and VLD.", "EPTR=100"]),
    row_of("VLD", "variable", VARIABLES, Full,
        ["VLD(variable,count)", "Loads variables from the EEPROM.", "VLD(al[0],4)"]),
    row_of("VST", "variable", VARIABLES, Full,
        ["VST(variable,count)", "Stores variables in the EEPROM.", "VST(al[0],4)"]),
    row_of("a..z", "variable", VARIABLES, Full,
        ["a ... z", "26 variables of 32 bits.", "a=1"]),
    row_of("aa..zz", "variable", VARIABLES, Full,
        ["aa ... zz", "26 more; they share memory with the arrays.", "aa=1"]),
    row_of("aaa..zzz", "variable", VARIABLES, Full,
        ["aaa ... zzz", "26 more; they share memory with the arrays.", "aaa=1"]),
    row_of("ab[]", "variable", VARIABLES, Full,
        ["ab[i]", "201 signed bytes, from 0 on.", "ab[0]=1"]),
    row_of("al[]", "variable", VARIABLES, Full,
        ["al[i]", "51 numbers of 32 bits, from 0 on; al[0] is aa.", "al[a+b]=1"]),
    row_of("aw[]", "variable", VARIABLES, Full,
        ["aw[i]", "101 signed words of 16 bits, from 0 on.", "aw[a] 63 44 98."]),
];
