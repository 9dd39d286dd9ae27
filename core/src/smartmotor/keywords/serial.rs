//! The serial line. In the order of the words' bytes.

use super::{SERIAL, row_of};
use crate::language::KeywordRow;
use crate::language::Support::{Full, Partial};

#[rustfmt::skip] // a table
pub(super) const ROWS: &[KeywordRow] = &[
    // word, kind, section, support; syntax, summary, example
    row_of("!", "serial", SERIAL, Full,
        ["!", "Holds the program until a character comes in.", "!"]),
    row_of("ADDR", "serial", SERIAL, Full,
        ["ADDR", "The motor's address; 0 is none.", "a=ADDR"]),
    row_of("ADDR=", "serial", SERIAL, Full,
        ["ADDR=expression", "Sets the motor's address.", "ADDR=2"]),
    row_of("BAUD#", "serial", SERIAL, Full,
        ["BAUDn", "Sets the rate of the host's line.", "BAUD19200"]),
    row_of("CCHN", "serial", SERIAL, Full,
        ["CCHN(type,channel)", "Closes a channel.", "CCHN(RS4,1)"]),
    row_of("CTR", "serial", SERIAL, Full,
        ["CTR", "The external encoder.", "a=CTR"]),
    row_of("ECHO", "serial", SERIAL, Full,
        ["ECHO", "Sends on what comes in, so that the next motor of a chain has it.", "ECHO"]),
    row_of("ECHO_OFF", "serial", SERIAL, Full,
        ["ECHO_OFF", "Does not send on what comes in.", "ECHO_OFF"]),
    row_of("GETCHR", "serial", SERIAL, Full,
        ["GETCHR", "Takes the next character that came as data; -1 if there is none.", "a=GETCHR"]),
    row_of("LEN", "serial", SERIAL, Full,
        ["LEN", "How many characters have come as data.", "IF LEN a=GETCHR ENDIF"]),
    row_of("LOAD", "serial", SERIAL, Full,
        ["LOAD", "Takes a program from the line, up to a byte of 255.", "LOAD"]),
    row_of("OCHN", "serial", SERIAL, Full,
        ["OCHN(type,channel,parity,rate,stop bits,data bits,mode)", "Opens a channel for commands (C) or data (D).", "OCHN(RS2,0,N,9600,1,8,D)"]),
    row_of("PRINT", "serial", SERIAL, Full,
        ["PRINT(part,...)", "Sends texts, numbers and, with #, bytes.", "PRINT(\"A=\",a,#13)"]),
    row_of("PRINT1", "serial", SERIAL, Partial("Nothing is connected to channel 1."),
        ["PRINT1(part,...)", "As PRINT, by channel 1.", "PRINT1(\"A\")"]),
    row_of("Q", "serial", SERIAL, Full,
        ["Q", "Reports how MD stands with the host.", "Q"]),
    row_of("SADDR#", "serial", SERIAL, Full,
        ["SADDRn", "Sets the motor's address, 1 to 100.", "SADDR1"]),
    row_of("SILENT", "serial", SERIAL, Full,
        ["SILENT", "The program's output is not sent.", "SILENT"]),
    row_of("SLEEP", "serial", SERIAL, Full,
        ["SLEEP", "Ignores commands until WAKE.", "SLEEP"]),
    row_of("TALK", "serial", SERIAL, Full,
        ["TALK", "The program's output is sent again.", "TALK"]),
    row_of("UP", "serial", SERIAL, Full,
        ["UP", "Sends the stored program with the places of its labels.", "UP"]),
    row_of("UPLOAD", "serial", SERIAL, Full,
        ["UPLOAD", "Sends the stored program.", "UPLOAD"]),
    row_of("WAKE", "serial", SERIAL, Full,
        ["WAKE", "Takes commands again.", "WAKE"]),
];
