//! Commands that begin with a word.

use super::super::ast::{
    Channel, Item, LineCommand, Operand, Range, Report, Source, StatementKind, Target, TextReport,
    variable,
};
use super::super::lexer::{Token, TokenKind};
use super::super::motor::{Command, Register};
use super::expressions::{array, is_module, line_flag, source};
use super::{Parse, Parser, error};
use crate::language::Span;
use crate::serial::Parity;

/// The highest label.
const LAST_LABEL: u16 = 999;
/// The highest address of a motor on a chain.
const LAST_ADDRESS: u8 = 100;
/// What BAUD and OCHN can set.
const RATES: [u32; 9] = [300, 600, 1200, 2400, 4800, 9600, 19_200, 38_400, 57_600];

impl Parser<'_> {
    pub(super) fn word(&mut self, token: Token) -> Parse<StatementKind> {
        let word = self.word_text(token.span).to_owned();
        if let Some(kind) = self.flow(&word, token.span)? {
            return Ok(kind);
        }
        if let Some(kind) = self.numbered(&word, token.span)? {
            return Ok(kind);
        }
        if let Some(register) = self.register_target(&word) {
            self.note(&format!("{word}="), token.span)?;
            return self.assign(Target::Register(register));
        }
        if let Some(command) = Command::from_word(&word) {
            self.note(&word, token.span)?;
            return Ok(StatementKind::Motor(command));
        }
        if let Some(kind) = self.own(&word, token.span)? {
            return Ok(kind);
        }
        if let Some(report) = self.report(&word, token.span)? {
            return Ok(StatementKind::Report(report));
        }
        Err(self.unknown(&word, token.span))
    }

    fn unknown(&self, word: &str, span: Span) -> super::Malformed {
        let cause = match source(word) {
            Some(_) => {
                format!("{word} is a value: something must be done with it, as in a={word}.")
            }
            None => format!("{word} is not a word of the language."),
        };
        super::Malformed {
            // More may follow a word that is only a beginning: `WAIT =4`.
            unfinished: self.peek().is_none() && source(word).is_some(),
            ..error(span, cause)
        }
    }

    /// Words that direct the program.
    fn flow(&mut self, word: &str, span: Span) -> Parse<Option<StatementKind>> {
        let simple = match word {
            "RETURN" => Some(StatementKind::Return),
            "STACK" => Some(StatementKind::Stack),
            "RUN" => Some(StatementKind::Run),
            "RUN?" => Some(StatementKind::RunIfAsked),
            "END" => Some(StatementKind::End),
            "LOOP" => Some(StatementKind::Loop),
            "BREAK" => Some(StatementKind::Break),
            "ELSE" => Some(StatementKind::Else),
            "ENDIF" => Some(StatementKind::EndIf),
            "DEFAULT" => Some(StatementKind::Default),
            "ENDS" => Some(StatementKind::EndSwitch),
            "TWAIT" => Some(StatementKind::WaitForTrajectory),
            "Z" | "RESET" => Some(StatementKind::Reset),
            _ => None,
        };
        if simple.is_some() {
            self.note(word, span)?;
            return Ok(simple);
        }
        let with: fn(super::super::ast::Expr) -> StatementKind = match word {
            "WHILE" => StatementKind::While,
            "IF" => StatementKind::If,
            "ELSEIF" => StatementKind::ElseIf,
            "SWITCH" => StatementKind::Switch,
            "CASE" => StatementKind::Case,
            "WAIT" => StatementKind::Wait,
            _ => return Ok(None),
        };
        self.note(word, span)?;
        if word == "WAIT" {
            self.need(TokenKind::Assign, "= and a number of samples")?;
        } else if self.is_glued() {
            return Err(self.too_much());
        }
        self.expression().map(with).map(Some)
    }

    /// Words with a number right behind them.
    fn numbered(&mut self, word: &str, span: Span) -> Parse<Option<StatementKind>> {
        let digits = word.trim_start_matches(|c: char| c.is_ascii_uppercase());
        let stem = word.strip_suffix(digits).unwrap_or(word);
        let row = match stem {
            "C" => "C#",
            "GOTO" => "GOTO#",
            "GOSUB" => "GOSUB#",
            "SADDR" => "SADDR#",
            "BAUD" => "BAUD#",
            _ => return Ok(None),
        };
        self.note(row, span)?;
        let number = digits
            .parse::<u32>()
            .ok()
            .filter(|_| digits.bytes().all(|byte| byte.is_ascii_digit()));
        let wrong = |what: &str| error(span, format!("{stem} needs {what} right behind it."));
        let label = || {
            number
                .and_then(|number| u16::try_from(number).ok())
                .filter(|&number| number <= LAST_LABEL)
                .ok_or_else(|| wrong("a label's number from 0 to 999"))
        };
        Ok(Some(match stem {
            "C" => StatementKind::Label(label()?),
            "GOTO" => StatementKind::Goto(label()?),
            "GOSUB" => StatementKind::Gosub(label()?),
            "SADDR" => {
                let address = number
                    .and_then(|number| u8::try_from(number).ok())
                    .filter(|&number| number <= LAST_ADDRESS)
                    .ok_or_else(|| wrong("an address from 0 to 100"))?;
                StatementKind::Line(LineCommand::Address(address))
            }
            _ => {
                let rate = number
                    .filter(|rate| RATES.contains(rate))
                    .ok_or_else(|| wrong("a rate such as 9600 or 19200"))?;
                StatementKind::Line(LineCommand::Baud(rate))
            }
        }))
    }

    /// Words of the interpreter itself.
    fn own(&mut self, word: &str, span: Span) -> Parse<Option<StatementKind>> {
        let line = match word {
            "SLEEP" => Some(LineCommand::Sleep),
            "WAKE" => Some(LineCommand::Wake),
            "ECHO" => Some(LineCommand::Echo(true)),
            "ECHO_OFF" => Some(LineCommand::Echo(false)),
            "SILENT" => Some(LineCommand::Silent(true)),
            "TALK" => Some(LineCommand::Silent(false)),
            "LOAD" => Some(LineCommand::Load),
            "UPLOAD" => Some(LineCommand::Upload { compiled: false }),
            "UP" => Some(LineCommand::Upload { compiled: true }),
            "Q" => Some(LineCommand::Query),
            _ => None,
        };
        if let Some(line) = line {
            self.note(word, span)?;
            return Ok(Some(StatementKind::Line(line)));
        }
        if let &[b'Z', letter] = word.as_bytes()
            && let Some(flag) = line_flag(letter)
        {
            self.note(word, span)?;
            return Ok(Some(StatementKind::ClearLine(flag)));
        }
        let kind = match word {
            "EPTR" => {
                self.note("EPTR=", span)?;
                self.assign(Target::EepromPointer)?
            }
            "ADDR" => {
                self.note("ADDR=", span)?;
                self.assign(Target::Address)?
            }
            "PRINT" | "PRINT1" => {
                self.note(word, span)?;
                let channel = u8::from(word == "PRINT1");
                let items = self.items()?;
                StatementKind::Print { channel, items }
            }
            "VST" | "VLD" => {
                self.note(word, span)?;
                let range = self.range()?;
                match word {
                    "VST" => StatementKind::Store(range),
                    _ => StatementKind::Load(range),
                }
            }
            "OCHN" => {
                self.note(word, span)?;
                StatementKind::Line(LineCommand::Open(self.channel()?))
            }
            "CCHN" => {
                self.note(word, span)?;
                self.need(TokenKind::Open, "the channel in parentheses")?;
                let number = self.channel_number()?;
                self.need(TokenKind::Close, "the closing parenthesis")?;
                StatementKind::Line(LineCommand::Close(number))
            }
            _ => return self.module_output(word, span),
        };
        Ok(Some(kind))
    }

    /// `DOUTA0,1`, `AOUTA,5`
    fn module_output(&mut self, word: &str, span: Span) -> Parse<Option<StatementKind>> {
        let (row, rest) = match (word.strip_prefix("DOUT"), word.strip_prefix("AOUT")) {
            (Some(rest), _) => ("DOUT#", rest),
            (_, Some(rest)) => ("AOUT#", rest),
            _ => return Ok(None),
        };
        if !is_module(rest) {
            return Ok(None);
        }
        self.note(row, span)?;
        self.need(TokenKind::Comma, "a comma and a value")?;
        Ok(Some(StatementKind::ModuleOutput(self.expression()?)))
    }

    /// What PRINT sends: texts, numbers, `#` and a byte, with commas between them.
    fn items(&mut self) -> Parse<Vec<Item>> {
        self.need(TokenKind::Open, "the parts in parentheses")?;
        let mut items = Vec::new();
        loop {
            items.push(self.item()?);
            if self.eat(TokenKind::Close) {
                return Ok(items);
            }
            self.need(TokenKind::Comma, "a comma or the closing parenthesis")?;
        }
    }

    fn item(&mut self) -> Parse<Item> {
        match self.peek() {
            Some(Token {
                kind: TokenKind::Text(closed),
                span,
            }) => {
                self.at += 1;
                if !closed {
                    return Err(super::Malformed {
                        unfinished: true,
                        ..error(span, "The text has no second quote.".to_owned())
                    });
                }
                let inner = Span {
                    start: span.start + 1,
                    end: span.end.saturating_sub(1),
                };
                Ok(Item::Text(self.text(inner).to_vec()))
            }
            Some(Token {
                kind: TokenKind::Hash,
                ..
            }) => {
                self.at += 1;
                self.expression().map(Item::Byte)
            }
            _ => self.expression().map(Item::Number),
        }
    }

    /// `(al[0],4)`
    fn range(&mut self) -> Parse<Range> {
        self.need(TokenKind::Open, "a variable and a count in parentheses")?;
        let first = match self.next() {
            Some(token) if token.kind == TokenKind::Name => self.place(token)?,
            _ => {
                self.at = self.at.saturating_sub(1);
                return Err(self.expected("a variable"));
            }
        };
        self.need(TokenKind::Comma, "a comma and a count")?;
        let count = self.operand()?;
        self.need(TokenKind::Close, "the closing parenthesis")?;
        Ok(Range { first, count })
    }

    /// `(RS2,0,N,9600,1,8,C)`
    fn channel(&mut self) -> Parse<Channel> {
        let comma = |parser: &mut Self| parser.need(TokenKind::Comma, "a comma");
        self.need(
            TokenKind::Open,
            "type, channel, parity, rate, stop bits, data bits, mode",
        )?;
        let number = self.channel_number()?;
        comma(self)?;
        let parity = match self.choice("N, E or O for the parity")?.as_str() {
            "N" => Parity::None,
            "E" => Parity::Even,
            "O" => Parity::Odd,
            _ => return Err(self.wrong_choice("the parity is N, E or O")),
        };
        comma(self)?;
        let baud = self.constant()?;
        let Some(baud) = u32::try_from(baud).ok().filter(|rate| RATES.contains(rate)) else {
            return Err(self.wrong_choice("no such rate"));
        };
        comma(self)?;
        let stop_bits = self.one_of([1, 2], "stop bits are 1 or 2")?;
        comma(self)?;
        let data_bits = self.one_of([7, 8], "data bits are 7 or 8")?;
        comma(self)?;
        let data = match self.choice("C for commands or D for data")?.as_str() {
            "C" => false,
            "D" => true,
            _ => return Err(self.wrong_choice("the mode is C or D")),
        };
        self.need(TokenKind::Close, "the closing parenthesis")?;
        Ok(Channel {
            number,
            parity,
            baud,
            stop_bits,
            data_bits,
            data,
        })
    }

    /// `RS2,0`: the type belongs to the motor's wiring, the number tells the channel.
    fn channel_number(&mut self) -> Parse<u8> {
        let kind = self.choice("the type RS2 or RS4")?;
        if !matches!(kind.as_str(), "RS2" | "RS4") {
            return Err(self.wrong_choice("the type is RS2 or RS4"));
        }
        self.need(TokenKind::Comma, "a comma and the channel")?;
        self.one_of([0, 1], "the channel is 0 or 1")
    }

    fn one_of(&mut self, allowed: [u8; 2], what: &str) -> Parse<u8> {
        let number = self.constant()?;
        let found = allowed
            .into_iter()
            .find(|&value| i32::from(value) == number);
        found.ok_or_else(|| self.wrong_choice(what))
    }

    fn choice(&mut self, what: &str) -> Parse<String> {
        match self.peek() {
            Some(token) if token.kind == TokenKind::Word => {
                self.at += 1;
                Ok(self.word_text(token.span).to_owned())
            }
            _ => Err(self.expected(what)),
        }
    }

    /// The token just taken is none of the possible ones.
    fn wrong_choice(&self, cause: &str) -> super::Malformed {
        let last = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        let span = last.map(|token| token.span).unwrap_or_default();
        let mut sentence = cause.to_owned();
        if let Some(first) = sentence.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        error(span, format!("{sentence}."))
    }

    /// `R` and what is reported.
    fn report(&mut self, word: &str, span: Span) -> Parse<Option<Report>> {
        let Some(what) = word.strip_prefix('R').filter(|what| !what.is_empty()) else {
            return Ok(None);
        };
        let special = match what {
            "W" => Some(TextReport::Word),
            "S" => Some(TextReport::Byte),
            "PW" => Some(TextReport::PositionAndWord),
            "SP" => Some(TextReport::Sample),
            "CKS" => Some(TextReport::Checksum),
            "CS1" => Some(TextReport::Channel1),
            "MODE" => Some(TextReport::Mode),
            _ => None,
        };
        if let Some(special) = special {
            self.note(word, span)?;
            return Ok(Some(Report::Text(special)));
        }
        if let Some(array) = array(what.as_bytes()) {
            let row = format!("R{}", super::expressions::array_word(array));
            self.note(&row, span)?;
            let index = self.index()?;
            let place = super::super::ast::Place::Element(array, index);
            return Ok(Some(Report::Value(Operand::Place(place))));
        }
        if let Some(number) = variable(what.as_bytes()) {
            self.note("R<var>", span)?;
            let place = super::super::ast::Place::Variable(number);
            return Ok(Some(Report::Value(Operand::Place(place))));
        }
        // RP tells the actual position, as RV and RPE tell what is measured (D134).
        let source = match what {
            "P" => Some(Source::Register(Register::ActualPosition)),
            "V" => Some(Source::Register(Register::ActualVelocity)),
            "PE" => Some(Source::Register(Register::PositionError)),
            what => source(what),
        };
        let Some(source) = source else {
            return Ok(None);
        };
        let row = match source {
            Source::Flag(_) | Source::LineFlag(_) => "RB#",
            Source::Register(Register::Pin(_)) => "RUAI",
            Source::Register(Register::Analog(_)) => "RUAA",
            _ => word,
        };
        if super::keywords::find(row).is_none() {
            return Ok(None);
        }
        self.note(row, span)?;
        Ok(Some(Report::Value(Operand::Source(source))))
    }
}
