//! Conditions and sets.

use super::super::ast::{CompareOp, Condition, ConditionKind, Expr, ExprKind, Name};
use super::super::spelling::{look_alike, look_alike_help};
use super::super::token::Kind;
use super::expression::make;
use super::{Context, Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

pub(super) const BUILDER_HELP: &str = "a set is built as `{e for x ∈ S if condition}`";

fn both(
    kind: fn(Box<Condition>, Box<Condition>) -> ConditionKind,
    a: Condition,
    b: Condition,
) -> Condition {
    let span = a.span.to(b.span);
    Condition {
        kind: kind(Box::new(a), Box::new(b)),
        span,
    }
}

impl Parser<'_> {
    /// `a or b and c`.
    pub(super) fn condition(&mut self) -> Parsed<Condition> {
        let context = Context {
            condition: true,
            ..Context::PLAIN
        };
        self.within(context, |parser| parser.nested(Self::alternatives))
    }

    fn alternatives(&mut self) -> Parsed<Condition> {
        let mut left = self.conjunction()?;
        while self.kind() == Kind::Or {
            let span = self.here();
            self.advance();
            let right = self.conjunction()?;
            self.grow(span)?;
            left = both(ConditionKind::Or, left, right);
        }
        Ok(left)
    }

    fn conjunction(&mut self) -> Parsed<Condition> {
        let mut left = self.relation()?;
        while self.kind() == Kind::And {
            let span = self.here();
            self.advance();
            let right = self.relation()?;
            self.grow(span)?;
            left = both(ConditionKind::And, left, right);
        }
        Ok(left)
    }

    /// Whether `(` here groups a condition: it closes before what can follow a condition, and holds a relation.
    fn groups(&mut self) -> bool {
        let Some(close) = self.partner() else {
            return false;
        };
        let after = self.tokens[close + 1].kind;
        let ends = matches!(
            after,
            Kind::And
                | Kind::Or
                | Kind::RightParen
                | Kind::RightBrace
                | Kind::Comma
                | Kind::Branch
                | Kind::Newline
                | Kind::Where
                | Kind::With
                | Kind::End
        );
        if !ends {
            return false;
        }
        let mut index = self.at + 1;
        while index < close {
            self.steps += 1;
            let kind = self.tokens[index].kind;
            if kind.is_relation() {
                return true;
            }
            let partner = self.partners[index];
            let jump = partner != super::NONE && partner as usize > index;
            // A nested group decides by its own content, so that deep nesting is scanned once.
            if jump && index == self.at + 1 && kind == Kind::LeftParen {
                index += 1;
            } else {
                index = if jump { partner as usize } else { index } + 1;
            }
        }
        false
    }

    fn relation(&mut self) -> Parsed<Condition> {
        let start = self.here();
        if self.kind() == Kind::LeftParen && self.groups() {
            self.advance();
            let inner = self.condition()?;
            self.expect(Kind::RightParen, "`)`", "close the parenthesis")?;
            return Ok(inner);
        }
        let left = Box::new(self.expression()?);
        let negated = self.kind() == Kind::NotIn;
        if negated || self.kind() == Kind::In {
            self.advance();
            let set = Box::new(self.expression()?);
            let kind = ConditionKind::Member {
                item: left,
                negated,
                set,
            };
            let span = self.since(start);
            return Ok(Condition { kind, span });
        }
        let Some(op) = compare(self.kind()) else {
            let help = "a condition compares, as in `a < b`, or asks for membership, as in `a ∈ S`";
            return self.expected("a relation", help);
        };
        self.advance();
        let right = Box::new(self.expression()?);
        if compare(self.kind()).is_some() || matches!(self.kind(), Kind::In | Kind::NotIn) {
            return self.chained(left.span, right.span);
        }
        let kind = ConditionKind::Compare { op, left, right };
        let span = self.since(start);
        Ok(Condition { kind, span })
    }

    fn chained(&mut self, left: Span, middle: Span) -> Parsed<Condition> {
        let cut = |span: Span| self.text.get(span.start as usize..span.end as usize);
        let (left, middle) = (cut(left).unwrap_or("a"), cut(middle).unwrap_or("b"));
        let help = match left.len() + middle.len() < 60 {
            true => format!("write two relations, as in `{left} < {middle} and {middle} < …`"),
            false => "write two relations joined by `and`".to_owned(),
        };
        let error = Diagnostic::error(self.here(), "relations cannot be chained");
        self.fail(error.help(help))
    }

    /// `{a, b}`, `{e for x ∈ S if p}`, `{e | x ∈ S, p}`.
    pub(super) fn set(&mut self) -> Parsed<Expr> {
        self.within(Context::PLAIN, Self::set_inside)
    }

    fn set_inside(&mut self) -> Parsed<Expr> {
        let start = self.here();
        self.advance();
        if self.eat(Kind::RightBrace) {
            return Ok(make(ExprKind::Set(Vec::new()), self.since(start)));
        }
        let context = Context {
            builder: true,
            ..Context::PLAIN
        };
        let element = self.within(context, Self::expression)?;
        match self.kind() {
            Kind::For => self.builder(element, start, Kind::If),
            Kind::Bar => self.builder(element, start, Kind::Comma),
            Kind::Colon => {
                let help = "write `for` or `|` before the variable";
                self.expected("`for`", help)
            }
            _ => self.set_list(element, start),
        }
    }

    fn set_list(&mut self, first: Expr, start: Span) -> Parsed<Expr> {
        let mut list = vec![first];
        while self.eat(Kind::Comma) {
            list.push(self.expression()?);
        }
        let help = "a set is `{a, b}` or `{e for x ∈ S if condition}`";
        self.expect(Kind::RightBrace, "`,` or `}`", help)?;
        Ok(make(ExprKind::Set(list), self.since(start)))
    }

    fn builder(&mut self, element: Expr, start: Span, before_condition: Kind) -> Parsed<Expr> {
        let variables = self.builder_variables()?;
        let range = Box::new(self.expression()?);
        let condition = self.builder_condition(before_condition)?;
        let element = Box::new(element);
        let kind = ExprKind::Builder {
            element,
            variables,
            range,
            condition,
        };
        Ok(make(kind, self.since(start)))
    }

    fn builder_variables(&mut self) -> Parsed<Vec<Name>> {
        self.advance();
        let variables = self.bound_names("a variable", BUILDER_HELP)?;
        if self.kind() != Kind::In {
            self.no_look_alike(&variables)?;
        }
        self.expect(Kind::In, "`∈`", BUILDER_HELP)?;
        Ok(variables)
    }

    /// Reports a letter among bound names that looks like `∈`.
    pub(super) fn no_look_alike(&mut self, names: &[Name]) -> Parsed<()> {
        let others = names.iter().skip(1);
        let mut signs = others.filter(|name| look_alike(&name.text).is_some_and(|(s, _)| s == "∈"));
        let Some(name) = signs.next() else {
            return Ok(());
        };
        let message = format!("`{}` is a letter, not the sign of membership", name.text);
        let help = look_alike_help(&name.text).unwrap_or_default();
        self.fail(Diagnostic::error(name.span, message).help(help))
    }

    /// `i`, `i, j` or `(i, j)`: the members of a set, or the items of its tuples.
    pub(super) fn bound_names(&mut self, what: &str, help: &str) -> Parsed<Vec<Name>> {
        let wrapped = self.eat(Kind::LeftParen);
        let mut names = vec![self.name(what, help)?];
        while matches!(self.kind(), Kind::Comma | Kind::Name(_) | Kind::Function(_)) {
            self.eat(Kind::Comma);
            names.push(self.name(what, help)?);
        }
        if wrapped {
            self.expect(Kind::RightParen, "`)`", help)?;
        }
        Ok(names)
    }

    fn builder_condition(&mut self, before: Kind) -> Parsed<Option<Box<Condition>>> {
        let conditional = self.kind() == before || self.kind() == Kind::If;
        let condition = match conditional {
            true => {
                self.advance();
                Some(Box::new(self.condition()?))
            }
            false => None,
        };
        let what = match condition {
            Some(_) => "`}`",
            None => "`if` or `}`",
        };
        self.expect(Kind::RightBrace, what, BUILDER_HELP)?;
        Ok(condition)
    }

    /// Whether the `|` here stands for `for` in a set builder: names and `∈` follow.
    pub(super) fn is_builder_bar(&mut self) -> bool {
        let mut index = 1;
        while index < 32 && self.is_name(index) {
            index += 1;
            if self.ahead(index) == Kind::In {
                return true;
            }
            if self.ahead(index) == Kind::Comma {
                index += 1;
            }
        }
        false
    }
}

fn compare(kind: Kind) -> Option<CompareOp> {
    Some(match kind {
        Kind::Assign | Kind::EqualEqual => CompareOp::Equal,
        Kind::NotEqual => CompareOp::NotEqual,
        Kind::Less => CompareOp::Less,
        Kind::LessOrEqual => CompareOp::LessOrEqual,
        Kind::Greater => CompareOp::Greater,
        Kind::GreaterOrEqual => CompareOp::GreaterOrEqual,
        _ => return None,
    })
}
