//! Precedence climbing: turns operands and infix operators into a tree, by a table of how tightly each operator binds.

/// An infix operator and how tightly it binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Infix<Operator> {
    /// What it computes.
    pub operator: Operator,
    /// The higher, the tighter; operators of one level go from left to right.
    pub level: u8,
}

/// What a language's parser brings to [`climb`].
pub trait Operands {
    /// An infix operator.
    type Operator;
    /// A node of the tree.
    type Expr;
    /// Why there is none.
    type Error;

    /// Takes what stands between two infix operators: a constant, a variable, a call, a parenthesised expression, or a
    /// prefix operator with its own operand, which it gets by `climb` from the level above its own.
    ///
    /// # Errors
    /// Whatever the language says to something else.
    fn operand(&mut self) -> Result<Self::Expr, Self::Error>;

    /// The infix operator that comes next, not taken yet.
    fn infix(&self) -> Option<Infix<Self::Operator>>;

    /// Takes that operator.
    fn advance(&mut self);

    /// The node over two operands.
    fn join(&mut self, operator: Self::Operator, left: Self::Expr, right: Self::Expr)
    -> Self::Expr;
}

/// Takes the longest expression whose infix operators bind at least as tightly as `lowest`.
///
/// It calls itself once for each level in between, and `operand` may call it again: a language bounds how deeply its
/// parentheses and prefix operators nest.
///
/// # Errors
/// The first that `operand` gives.
pub fn climb<P: Operands>(parser: &mut P, lowest: u8) -> Result<P::Expr, P::Error> {
    let mut left = parser.operand()?;
    while let Some(infix) = parser.infix().filter(|infix| infix.level >= lowest) {
        parser.advance();
        let right = climb(parser, infix.level + 1)?;
        left = parser.join(infix.operator, left, right);
    }
    Ok(left)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Letters are operands, `~` is a prefix operator between `+` and `*`; the tree is written in prefix form.
    struct Letters<'a>(std::iter::Peekable<std::str::Chars<'a>>);

    impl Operands for Letters<'_> {
        type Operator = char;
        type Expr = String;
        type Error = ();

        fn operand(&mut self) -> Result<String, ()> {
            match self.0.next().ok_or(())? {
                '~' => Ok(format!("(~{})", climb(self, 2)?)),
                letter if letter.is_alphabetic() => Ok(letter.to_string()),
                _ => Err(()),
            }
        }

        fn infix(&self) -> Option<Infix<char>> {
            let operator = *self.0.clone().peek()?;
            let level = match operator {
                '+' | '-' => 1,
                '*' => 3,
                _ => return None,
            };
            Some(Infix { operator, level })
        }

        fn advance(&mut self) {
            self.0.next();
        }

        fn join(&mut self, operator: char, left: String, right: String) -> String {
            format!("({operator}{left}{right})")
        }
    }

    #[test]
    fn binds_by_level_and_from_left_to_right() {
        for (text, expected) in [
            ("a", Ok("a")),
            ("a-b-c", Ok("(-(-ab)c)")),
            ("a+b*c", Ok("(+a(*bc))")),
            ("a*b+c", Ok("(+(*ab)c)")),
            ("~a*b+c", Ok("(+(~(*ab))c)")),
            ("a*~b+c", Ok("(+(*a(~b))c)")),
            ("~~a", Ok("(~(~a))")),
            ("a+", Err(())),
            ("", Err(())),
        ] {
            let result = climb(&mut Letters(text.chars().peekable()), 0);
            assert_eq!(result.as_deref().map_err(|&()| ()), expected, "{text}");
        }
    }
}
