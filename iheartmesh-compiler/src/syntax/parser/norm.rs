//! Bars and angle brackets.

use super::super::ast::{Expr, ExprKind, NormSubscript, Subscript};
use super::super::token::Kind;
use super::expression::make;
use super::{Bars, Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;

impl Parser<'_> {
    /// `|x|`, `||x||`, `‖x‖` with a subscript.
    pub(super) fn norm(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let open = self.advance();
        let twin = open.kind == Kind::Bar && self.kind() == Kind::Bar && self.tight(0);
        if twin {
            self.advance();
        }
        let double = twin || open.kind == Kind::DoubleBar;
        let context = Context {
            bars: if double { Bars::Double } else { Bars::Single },
            ..Context::PLAIN
        };
        let operand = Box::new(self.within(context, Self::expression)?);
        let help = "close the bars around the operand";
        match (double, twin) {
            (false, _) => drop(self.expect(Kind::Bar, "`|`", help)?),
            (true, false) if self.kind() == Kind::DoubleBar => drop(self.advance()),
            _ => {
                let close = match self.kind() {
                    Kind::DoubleBar => 1,
                    Kind::Bar if self.ahead(1) == Kind::Bar && self.tight(1) => 2,
                    _ => return self.expected("`‖`", help),
                };
                for _ in 0..close {
                    self.advance();
                }
            }
        }
        let subscript = self.norm_subscript()?;
        let kind = ExprKind::Norm {
            double,
            operand,
            subscript,
        };
        Ok(make(kind, self.since(start)))
    }

    /// `_2`, `_∞`, `_*`, `_F`, `_(p)`, `₂`.
    pub(super) fn norm_subscript(&mut self) -> Parsed<Option<NormSubscript>> {
        let token = self.token(0);
        if token.space {
            return Ok(None);
        }
        let span = self.span(token);
        let kind = match token.kind {
            Kind::SubscriptNumber(number) => ExprKind::Integer(number),
            Kind::SubscriptLetter(id) => ExprKind::Name(self.name_of(id, span)),
            Kind::Underscore => {
                self.advance();
                return self.norm_subscript_after_line().map(Some);
            }
            _ => return Ok(None),
        };
        self.advance();
        Ok(Some(NormSubscript::Expr(Box::new(make(kind, span)))))
    }

    fn norm_subscript_after_line(&mut self) -> Parsed<NormSubscript> {
        let parenthesised = self.kind() == Kind::LeftParen;
        if parenthesised {
            self.advance();
        }
        let span = self.here();
        let subscript = match self.kind() {
            Kind::Infinity => {
                self.advance();
                NormSubscript::Infinity
            }
            Kind::Star => {
                self.advance();
                NormSubscript::Nuclear
            }
            _ if parenthesised => NormSubscript::Expr(Box::new(self.bracketed()?)),
            Kind::Integer(number) => {
                self.advance();
                NormSubscript::Expr(Box::new(make(ExprKind::Integer(number), span)))
            }
            _ => {
                let help = "write a number, `∞`, `F`, `*` or a name";
                let name = self.name("the kind of the norm", help)?;
                NormSubscript::Expr(Box::new(make(ExprKind::Name(name), span)))
            }
        };
        if parenthesised {
            self.expect(Kind::RightParen, "`)`", "close the subscript")?;
        }
        Ok(subscript)
    }

    /// Whether `<` here opens `<a, b>`: a comma and a `>` follow on the same level.
    pub(super) fn completes_inner(&mut self) -> bool {
        let mut comma = false;
        let mut index = self.at + 1;
        for _ in 0..64 {
            self.steps += 1;
            let Some(token) = self.tokens.get(index) else {
                return false;
            };
            match token.kind {
                Kind::Comma => comma = true,
                Kind::Greater => return comma,
                Kind::Newline | Kind::Row | Kind::Branch | Kind::Where | Kind::End => return false,
                Kind::And | Kind::Or | Kind::If | Kind::In | Kind::Assign | Kind::Less => {
                    return false;
                }
                Kind::RightParen | Kind::RightBracket | Kind::RightBrace => return false,
                _ => {}
            }
            let partner = self.partners[index];
            let jump = partner != super::NONE && partner as usize > index;
            index = if jump { partner as usize } else { index } + 1;
        }
        false
    }

    /// `⟨a, b⟩_P`.
    pub(super) fn inner(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let open = self.advance().kind;
        let close = match open {
            Kind::Less => (Kind::Greater, "`>`"),
            _ => (Kind::RightAngle, "`⟩`"),
        };
        let left = Box::new(self.bracketed()?);
        let help = "an inner product has two operands: `⟨a, b⟩`";
        self.expect(Kind::Comma, "`,`", help)?;
        let right = Box::new(self.bracketed()?);
        self.expect(close.0, close.1, "close the inner product")?;
        let at = self.here();
        let weight = match self.subscripts()? {
            None => None,
            Some(mut list) => match (list.pop(), list.is_empty()) {
                (Some(Subscript::Expr(weight)), true) => Some(Box::new(weight)),
                _ => {
                    let error = Diagnostic::error(at, "an inner product has one weight matrix");
                    return self.fail(error.help("write `⟨a, b⟩_P`"));
                }
            },
        };
        let kind = ExprKind::Inner {
            left,
            right,
            weight,
        };
        Ok(make(kind, self.since(start)))
    }
}
