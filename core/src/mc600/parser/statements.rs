//! Statements and commands: one function for each that has a form of its own ("Description of BASIC keywords").

use super::expressions::is_function;
use super::{Fault, Parsed, Parser};
use crate::language::Span;
use crate::mc600::ast::{
    DataItem, Expr, LineRange, LineRef, Name, PrintItem, Statement, StatementKind, Target,
};
use crate::mc600::keywords::Keyword;
use crate::mc600::lexer::{TokenKind, read_line_number};
use crate::mc600::motion_calls;

impl Parser<'_> {
    pub(super) fn statement_kind(&mut self) -> Parsed<StatementKind> {
        match self.peek() {
            Some(TokenKind::Keyword(Keyword::System(_))) => self.assignment(),
            Some(TokenKind::Keyword(keyword)) if keyword.is_absent() => {
                Err(Fault::NotImplemented(keyword))
            }
            Some(TokenKind::Keyword(keyword)) => self.keyword_statement(keyword),
            Some(TokenKind::Name(_)) if self.is_close() => {
                Err(Fault::NotImplemented(Keyword::Fclose))
            }
            Some(TokenKind::Name(_)) => self.assignment(),
            _ => Err(self.unexpected("A statement should stand here.")),
        }
    }

    fn keyword_statement(&mut self, keyword: Keyword) -> Parsed<StatementKind> {
        let span = self.here();
        self.next += 1;
        match keyword {
            Keyword::Let => self.assignment(),
            Keyword::Print | Keyword::QuestionMark => self.print(),
            Keyword::Input => self.input(),
            Keyword::Goto | Keyword::GoTo => self.jump().map(StatementKind::Goto),
            Keyword::Gosub => self.jump().map(StatementKind::Gosub),
            Keyword::Return => Ok(StatementKind::Return),
            Keyword::Reti => Ok(StatementKind::Reti),
            Keyword::On => self.on(),
            Keyword::If => self.if_then(),
            Keyword::For => self.for_to(),
            Keyword::Next => self.next_names(),
            Keyword::While => self.condition().map(StatementKind::While),
            Keyword::Whend | Keyword::Wend => self.condition().map(StatementKind::Whend),
            Keyword::Rem => {
                self.eat(TokenKind::Remark);
                Ok(StatementKind::Rem)
            }
            Keyword::Data => Ok(self.data()),
            Keyword::Read => self.targets().map(StatementKind::Read),
            Keyword::Restore => Ok(StatementKind::Restore),
            Keyword::Dim => self.dim(),
            Keyword::End => Ok(StatementKind::End),
            Keyword::Stop => Ok(StatementKind::Stop),
            Keyword::New => Ok(StatementKind::New),
            Keyword::List => self.line_range().map(StatementKind::List),
            Keyword::Run => self.run(),
            Keyword::Cont => Ok(StatementKind::Cont),
            Keyword::Del => self.del(),
            Keyword::Renum => {
                let (start, increment) = self.numbering()?;
                Ok(StatementKind::Renum { start, increment })
            }
            Keyword::Auto => {
                let (start, increment) = self.numbering()?;
                Ok(StatementKind::Auto { start, increment })
            }
            Keyword::Files => self.mask().map(StatementKind::Files),
            Keyword::Save if self.at_end() => Ok(StatementKind::Save(None)),
            Keyword::Save => Ok(StatementKind::Save(Some(self.expression()?))),
            Keyword::Load => self.expression().map(StatementKind::Load),
            Keyword::Merge => self.expression().map(StatementKind::Merge),
            Keyword::Copy => self.copy(),
            Keyword::Erase => self.needed_mask().map(StatementKind::Erase),
            Keyword::Format => self.needed_mask().map(StatementKind::Format),
            Keyword::Password => Ok(StatementKind::Password),
            _ => self.call(keyword, span),
        }
    }

    fn call(&mut self, keyword: Keyword, span: Span) -> Parsed<StatementKind> {
        if let Some(count) = motion_calls::arguments(keyword) {
            let arguments = self.arguments(keyword, count, count)?;
            return Ok(StatementKind::Call { keyword, arguments });
        }
        let word = keyword.word();
        Err(Fault::syntax(
            span,
            match keyword {
                Keyword::Else => "ELSE without an IF before it on the line.".into(),
                _ if is_function(keyword) => {
                    format!("{word} gives a value: something must be done with it.")
                }
                _ => format!("{word} cannot begin a statement."),
            },
        ))
    }

    /// The manual's examples close files with CLOSE, which is no keyword: it is as little implemented as FCLOSE.
    fn is_close(&self) -> bool {
        let follows = self.tokens.get(self.next + 1).map(|token| token.kind);
        self.here().of(self.line).eq_ignore_ascii_case(b"CLOSE")
            && matches!(
                follows,
                Some(TokenKind::Name(_) | TokenKind::Integer(_) | TokenKind::Hash)
            )
    }

    fn assignment(&mut self) -> Parsed<StatementKind> {
        let target = self.target()?;
        if !self.eat_keyword(Keyword::Equal) {
            return Err(self.unexpected("An equal sign should stand here."));
        }
        let value = self.expression()?;
        Ok(StatementKind::Let { target, value })
    }

    fn print(&mut self) -> Parsed<StatementKind> {
        self.no_file(Keyword::Print)?;
        let mut items = Vec::new();
        while !self.at_end() {
            items.push(match self.peek() {
                Some(TokenKind::Comma) => {
                    self.next += 1;
                    PrintItem::Comma
                }
                Some(TokenKind::Semicolon) => {
                    self.next += 1;
                    PrintItem::Semicolon
                }
                Some(TokenKind::Keyword(Keyword::Tab)) => PrintItem::Tab(self.one_argument()?),
                Some(TokenKind::Keyword(Keyword::Spc)) => PrintItem::Spc(self.one_argument()?),
                _ => PrintItem::Expr(self.expression()?),
            });
        }
        Ok(StatementKind::Print(items))
    }

    fn one_argument(&mut self) -> Parsed<Expr> {
        self.next += 1;
        self.open()?;
        let argument = self.expression()?;
        self.close()?;
        Ok(argument)
    }

    /// `PRINT#` and `INPUT#` belong to files, which are not implemented.
    fn no_file(&self, keyword: Keyword) -> Parsed<()> {
        match self.peek() {
            Some(TokenKind::Hash) => Err(Fault::NotImplemented(keyword)),
            _ => Ok(()),
        }
    }

    fn input(&mut self) -> Parsed<StatementKind> {
        self.no_file(Keyword::Input)?;
        let span = self.here();
        let prompt = if self.eat(TokenKind::Text) {
            if !self.eat(TokenKind::Semicolon) {
                return Err(
                    self.unexpected("A semicolon should stand between prompt and variable.")
                );
            }
            Some(self.text_constant(span))
        } else {
            None
        };
        let targets = self.targets()?;
        Ok(StatementKind::Input { prompt, targets })
    }

    fn targets(&mut self) -> Parsed<Vec<Target>> {
        let mut targets = vec![self.target()?];
        while self.eat(TokenKind::Comma) {
            targets.push(self.target()?);
        }
        Ok(targets)
    }

    /// A line number if digits come next.
    fn line_ref(&mut self) -> Parsed<Option<LineRef>> {
        let span = self.here();
        let digits = span.of(self.line);
        let is_number = matches!(
            self.peek(),
            Some(TokenKind::Integer(_) | TokenKind::Real(_))
        );
        if !is_number {
            return Ok(None);
        }
        let Some(number) = read_line_number(digits) else {
            return Err(Fault::syntax(
                span,
                "A line number is a whole number up to 63999.",
            ));
        };
        self.next += 1;
        Ok(Some(LineRef { number, span }))
    }

    /// Line 0 where a line number is left out (GOTO; as Commodore BASIC elsewhere), with an empty place.
    fn line_zero(&self) -> LineRef {
        let end = self.behind().end;
        LineRef {
            number: 0,
            span: Span { start: end, end },
        }
    }

    fn jump(&mut self) -> Parsed<LineRef> {
        match self.line_ref()? {
            Some(line) => Ok(line),
            None if self.at_end() => Ok(self.line_zero()),
            None => Err(self.unexpected("A line number should stand here.")),
        }
    }

    fn on(&mut self) -> Parsed<StatementKind> {
        let selector = self.expression()?;
        let gosub = match self.peek_keyword() {
            Some(Keyword::Goto | Keyword::GoTo) => false,
            Some(Keyword::Gosub) => true,
            _ => return Err(self.unexpected("GOTO or GOSUB should stand here.")),
        };
        self.next += 1;
        let mut lines = Vec::new();
        loop {
            lines.push(match self.line_ref()? {
                Some(line) => line,
                None => self.line_zero(),
            });
            if !self.eat(TokenKind::Comma) {
                break;
            }
        }
        if !self.at_end() {
            return Err(self.unexpected("A line number should stand here."));
        }
        Ok(StatementKind::On {
            selector,
            gosub,
            lines,
        })
    }

    fn if_then(&mut self) -> Parsed<StatementKind> {
        let header = self
            .expression()
            .and_then(|condition| match self.peek_keyword() {
                Some(Keyword::Then | Keyword::Goto | Keyword::GoTo) => Ok(condition),
                _ => Err(self.unexpected("THEN or GOTO should stand here.")),
            });
        let condition = match header {
            Ok(condition) => condition,
            Err(fault) => {
                // What follows was meant to depend on the condition; an ELSE of it is none of the IFs around.
                self.next = self.tokens.len();
                return Err(fault);
            }
        };
        self.branches += 1;
        let then = if self.eat_keyword(Keyword::Then) {
            self.branch()
        } else {
            self.statements()
        };
        self.branches -= 1;
        let otherwise = self.eat_keyword(Keyword::Else).then(|| self.branch());
        Ok(StatementKind::If {
            condition,
            then,
            otherwise,
        })
    }

    /// What stands behind THEN or ELSE: a line number or statements.
    fn branch(&mut self) -> Vec<Statement> {
        let mut statements = Vec::new();
        if let Some(TokenKind::Integer(_) | TokenKind::Real(_)) = self.peek() {
            statements.push(self.checked(|parser| parser.jump().map(StatementKind::Goto)));
        }
        statements.extend(self.statements());
        statements
    }

    fn for_to(&mut self) -> Parsed<StatementKind> {
        let variable = self.simple_name()?;
        if !self.eat_keyword(Keyword::Equal) {
            return Err(self.unexpected("An equal sign should stand here."));
        }
        let start = self.expression()?;
        if !self.eat_keyword(Keyword::To) {
            return Err(self.unexpected("TO should stand here."));
        }
        let limit = self.expression()?;
        let step = if self.eat_keyword(Keyword::Step) {
            Some(self.expression()?)
        } else {
            None
        };
        Ok(StatementKind::For {
            variable,
            start,
            limit,
            step,
        })
    }

    /// The variable that a loop counts with.
    fn simple_name(&mut self) -> Parsed<Name> {
        match self.peek() {
            Some(TokenKind::Name(kind)) => {
                let name = self.name(kind);
                if self.peek() == Some(TokenKind::ParenOpen) {
                    return Err(self.unexpected("A loop counts with a simple variable."));
                }
                Ok(name)
            }
            _ => Err(self.unexpected("A simple variable should stand here.")),
        }
    }

    fn next_names(&mut self) -> Parsed<StatementKind> {
        let mut names = Vec::new();
        if !self.at_end() {
            names.push(self.simple_name()?);
            while self.eat(TokenKind::Comma) {
                names.push(self.simple_name()?);
            }
        }
        Ok(StatementKind::Next(names))
    }

    fn condition(&mut self) -> Parsed<Option<Expr>> {
        if self.at_end() {
            Ok(None)
        } else {
            self.expression().map(Some)
        }
    }

    /// Constants between commas: a quoted one keeps all its bytes, another loses the blanks around it.
    fn data(&mut self) -> StatementKind {
        let span = self.here();
        let text = if self.eat(TokenKind::Data) {
            span.of(self.line)
        } else {
            b""
        };
        let mut quoted = false;
        let items = text.split(|&byte| {
            quoted ^= byte == b'"';
            !quoted && byte == b','
        });
        StatementKind::Data(items.map(data_item).collect())
    }

    fn dim(&mut self) -> Parsed<StatementKind> {
        let mut arrays = Vec::new();
        loop {
            let Some(TokenKind::Name(kind)) = self.peek() else {
                return Err(self.unexpected("An array's name should stand here."));
            };
            let name = self.name(kind);
            let Some(sizes) = self.subscripts()? else {
                return Err(self.unexpected("The array's size in parentheses should stand here."));
            };
            arrays.push((name, sizes));
            if !self.eat(TokenKind::Comma) {
                return Ok(StatementKind::Dim(arrays));
            }
        }
    }

    /// `100`, `100-`, `-200`, `100-200`, or nothing.
    fn line_range(&mut self) -> Parsed<LineRange> {
        let first = self.line_ref()?;
        let open = self.eat_keyword(Keyword::Minus);
        let last = if open { self.line_ref()? } else { first };
        if open && first.is_none() && last.is_none() {
            return Err(self.unexpected("A line number should stand here."));
        }
        Ok(LineRange {
            first: first.map_or(0, |line| line.number),
            last: last.map_or(u16::MAX, |line| line.number),
        })
    }

    fn del(&mut self) -> Parsed<StatementKind> {
        let mut ranges = Vec::new();
        loop {
            let before = self.next;
            ranges.push(self.line_range()?);
            if self.next == before {
                return Err(self.unexpected("A line number should stand here."));
            }
            if !self.eat(TokenKind::Comma) {
                return Ok(StatementKind::Del(ranges));
            }
        }
    }

    fn run(&mut self) -> Parsed<StatementKind> {
        if let Some(line) = self.line_ref()? {
            let line = Some(line);
            return Ok(StatementKind::Run { file: None, line });
        }
        let file = match self.peek() {
            Some(TokenKind::Comma) => None,
            _ if self.at_end() => None,
            _ => Some(self.expression()?),
        };
        let line = if self.eat(TokenKind::Comma) {
            let line = self.line_ref()?;
            Some(line.ok_or_else(|| self.unexpected("A line number should stand here."))?)
        } else {
            None
        };
        Ok(StatementKind::Run { file, line })
    }

    /// `[start][,increment]`
    fn numbering(&mut self) -> Parsed<(Option<u16>, Option<u16>)> {
        let start = self.line_ref()?;
        let increment = if self.eat(TokenKind::Comma) {
            let increment = self.line_ref()?;
            Some(increment.ok_or_else(|| self.unexpected("An increment should stand here."))?)
        } else {
            None
        };
        let number = |line: LineRef| line.number;
        Ok((start.map(number), increment.map(number)))
    }
}

fn data_item(text: &[u8]) -> DataItem {
    let text = text.trim_ascii();
    let inner = text.strip_prefix(b"\"");
    // A closing quote may be missing; anything behind one makes it a plain item.
    match inner.map(|inner| inner.strip_suffix(b"\"").unwrap_or(inner)) {
        Some(inner) if !inner.contains(&b'"') => DataItem {
            text: inner.to_vec(),
            quoted: true,
        },
        _ => DataItem {
            text: text.to_vec(),
            quoted: false,
        },
    }
}
