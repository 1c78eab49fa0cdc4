//! Derivatives and the operators `∇`, `Δ`.

use super::super::ast::{Expr, ExprKind};
use super::super::token::Kind;
use super::expression::make;
use super::{Parsed, Parser};
use crate::diagnostic::Diagnostic;

const HELP: &str = "write `∂y/∂x`, `∂²y/∂x²`, `∂(…)/∂x` or `∂/∂x (…)`, without blanks around `/`";

impl Parser<'_> {
    /// `∂²y/∂x²`, `∂/∂x y`, and the same with `𝕕`.
    pub(super) fn derivative(&mut self) -> Parsed<Expr> {
        let start = self.here();
        let sign = self.advance().kind;
        let order = self.order()?;
        let applied = self.kind() == Kind::Slash;
        let mut numerator = match applied {
            true => None,
            false => Some(self.power()?),
        };
        let slash = self.kind() == Kind::Slash && self.ahead(1) == sign;
        if !slash && self.context.integral && sign == Kind::Partial {
            let help = "an integral ends with `𝕕` and its variable, as `∫_[0,1] t² 𝕕t` does";
            return self.expected("`/` and what to differentiate by", help);
        }
        if !slash {
            return self.expected("`/` and what to differentiate by", HELP);
        }
        self.advance();
        let mut denominators = Vec::new();
        while self.kind() == sign && (denominators.is_empty() || self.tight(0)) {
            self.advance();
            denominators.push(self.denominator()?);
        }
        if numerator.is_none() {
            numerator = Some(self.prefix()?);
        }
        let Some(numerator) = numerator.map(Box::new) else {
            return self.expected("what to differentiate", HELP);
        };
        let kind = ExprKind::Derivative {
            total: sign == Kind::Total,
            order: order.unwrap_or(1),
            numerator,
            denominators,
        };
        Ok(make(kind, self.since(start)))
    }

    fn denominator(&mut self) -> Parsed<(Expr, u32)> {
        let start = self.here();
        let name = self.name("a variable", HELP)?;
        let span = name.span;
        let mut variable = make(ExprKind::Name(name), span);
        if let Some(subscripts) = self.subscripts()? {
            let base = Box::new(variable);
            let kind = ExprKind::Subscript { base, subscripts };
            variable = make(kind, self.since(start));
        }
        let order = self.order()?;
        Ok((variable, order.unwrap_or(1)))
    }

    /// `²` or `^2`.
    fn order(&mut self) -> Parsed<Option<u32>> {
        let start = self.here();
        let (number, tokens) = match self.kind() {
            Kind::SuperscriptNumber(number) => (Some(number), 1),
            Kind::SuperscriptLetter(_) => (None, 1),
            Kind::Caret => match self.ahead(1) {
                Kind::Integer(number) => (Some(number), 2),
                _ => (None, 2),
            },
            _ => return Ok(None),
        };
        for _ in 0..tokens {
            self.advance();
        }
        let order = number.and_then(|number| u32::try_from(number).ok());
        match order.filter(|order| (1..=64).contains(order)) {
            Some(order) => Ok(Some(order)),
            None => {
                let error = Diagnostic::error(
                    self.since(start),
                    "the order of a derivative is a small number",
                );
                self.fail(error.help("write `∂²y/∂x²` for a second derivative"))
            }
        }
    }

    /// `∇_x y`, `∇ₓ y`, `∇y`, `∇⋅u`, `Δy`.
    pub(super) fn gradient(&mut self) -> Parsed<Expr> {
        let start = self.here();
        if self.advance().kind == Kind::Laplace {
            let operand = Box::new(self.prefix()?);
            return Ok(make(ExprKind::Laplacian(operand), self.since(start)));
        }
        if self.eat(Kind::Dot) {
            let operand = Box::new(self.prefix()?);
            return Ok(make(ExprKind::Divergence(operand), self.since(start)));
        }
        let token = self.token(0);
        let at = self.span(token);
        let name = match token.kind {
            Kind::SubscriptLetter(id) => {
                self.advance();
                Some(self.name_of(id, at))
            }
            Kind::Underscore => {
                self.advance();
                let help = "write `∇_x y`; a variable of several letters has to be declared";
                Some(self.name("a variable", help)?)
            }
            _ => None,
        };
        let variable = name.map(|name| {
            let span = name.span;
            Box::new(make(ExprKind::Name(name), span))
        });
        let operand = Box::new(self.prefix()?);
        let kind = ExprKind::Gradient { variable, operand };
        Ok(make(kind, self.since(start)))
    }
}
