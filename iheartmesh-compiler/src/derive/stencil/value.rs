//! The value of a sum of terms, in the formulas of its derivatives.

use super::formula::{Formulas, Stop};
use super::{CASES, Stencil, is_short};
use crate::derive::Trouble;
use crate::derive::normal::Normal;
use crate::ir::{Binary, ExprId, Fold, Kind, Range, Unary};

impl<F> Stencil<'_, '_, F>
where
    F: FnMut(&mut Normal<'_>, ExprId) -> Result<ExprId, Trouble>,
{
    /// `factor` times a number in normal form. Loops, cases and factors are taken apart as [`Stencil::of`] does, so that
    /// what the value and its derivatives have in common is one expression.
    pub(in crate::derive) fn value(
        &mut self,
        y: ExprId,
        factor: Option<ExprId>,
        facts: &[(ExprId, bool)],
    ) -> ExprId {
        let kind = match self.is_active(y) {
            true => self.normal.kind(y),
            false => Kind::Fail,
        };
        match kind {
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                if self.is_one(a, b)
                    && let Some(whole) = self.formula(y, factor, facts, CASES)
                {
                    return whole;
                }
                let left = self.value(a, factor, facts);
                let right = match op {
                    Binary::Add => self.value(b, factor, facts),
                    _ => {
                        let minus = self.times(factor, -1.0);
                        self.value(b, Some(minus), facts)
                    }
                };
                self.normal.algebra().add(left, right)
            }
            Kind::Binary(Binary::Multiply, k, a) if !self.is_active(k) => {
                let k = self.scaled(k, factor);
                self.value(a, Some(k), facts)
            }
            Kind::Binary(Binary::Multiply, a, k) if !self.is_active(k) => {
                let k = self.scaled(k, factor);
                self.value(a, Some(k), facts)
            }
            Kind::Binary(Binary::Divide, a, k) if !self.is_active(k) => {
                let mut s = self.normal.algebra();
                let one = s.real(1.0);
                let k = s.divide(one, k);
                let k = self.scaled(k, factor);
                self.value(a, Some(k), facts)
            }
            Kind::Unary(Unary::Negate, a) => {
                let minus = self.times(factor, -1.0);
                self.value(a, Some(minus), facts)
            }
            Kind::If(condition, a, b) => {
                let inside = self.informed(facts, condition, true);
                let then = self.value(a, factor, &inside);
                let inside = self.informed(facts, condition, false);
                let otherwise = self.value(b, factor, &inside);
                let condition = self.condition(condition);
                self.normal.algebra().choose(condition, then, otherwise)
            }
            Kind::Fold {
                op: Fold::Sum,
                variable,
                range,
                condition,
                body,
            } if !is_short(self.normal, range)
                && !matches!(range, Range::Set(set) if self.is_active(set)) =>
            {
                let body = self.value(body, factor, facts);
                self.normal.summed(variable, range, condition, body)
            }
            Kind::Fail => self.scaled(y, factor),
            _ => match self.formula(y, factor, facts, CASES) {
                Some(value) => value,
                None => self.scaled(y, factor),
            },
        }
    }

    fn times(&mut self, factor: Option<ExprId>, k: f64) -> ExprId {
        let k = self.normal.algebra().real(k);
        self.scaled(k, factor)
    }

    fn scaled(&mut self, y: ExprId, factor: Option<ExprId>) -> ExprId {
        match factor {
            Some(factor) => self.normal.algebra().scale(factor, y),
            None => y,
        }
    }

    /// One term, if it has a formula.
    fn formula(
        &mut self,
        y: ExprId,
        factor: Option<ExprId>,
        facts: &[(ExprId, bool)],
        left: usize,
    ) -> Option<ExprId> {
        let mut formulas = Formulas::new(self.normal, self.x, facts);
        let found = formulas.number(y).map(|e| match factor {
            Some(factor) => formulas.numbers().multiply(factor, e),
            None => e,
        });
        match found {
            Ok(value) => Some(value),
            Err(Stop::Cases(condition)) if left > 1 => {
                let then = self.informed(facts, condition, true);
                let then = self.formula(y, factor, &then, left / 2)?;
                let otherwise = self.informed(facts, condition, false);
                let otherwise = self.formula(y, factor, &otherwise, left / 2)?;
                let condition = self.condition(condition);
                Some(self.normal.algebra().choose(condition, then, otherwise))
            }
            Err(_) => None,
        }
    }
}
