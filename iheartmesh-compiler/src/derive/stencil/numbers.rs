//! Builds formulas of real numbers in a common form, so that equal numbers are one expression: constants are computed, signs
//! stand outside of products, operands that may be exchanged stand in order.

use std::collections::BTreeMap;

use crate::ir::{Arena, Binary, ExprId, Kind, Unary};
use crate::syntax::ast::CompareOp;
use crate::types::Type;

/// Builds formulas in an arena.
pub(super) struct Numbers<'a> {
    pub(super) arena: &'a mut Arena,
}

impl Numbers<'_> {
    pub(super) fn real(&mut self, value: f64) -> ExprId {
        self.arena.real(value)
    }

    /// The number that an expression is, if that is known.
    pub(super) fn number(&self, e: ExprId) -> Option<f64> {
        match self.arena.kind(e) {
            Kind::Real(bits) => Some(f64::from_bits(*bits)),
            Kind::Integer(value) => Some(*value as f64),
            Kind::Unary(Unary::ToReal, a) => self.number(*a),
            Kind::Unary(Unary::Negate, a) => self.number(*a).map(|value| -value),
            _ => None,
        }
    }

    pub(super) fn is_zero(&self, e: ExprId) -> bool {
        self.number(e) == Some(0.0)
    }

    fn added(&mut self, op: Binary, a: ExprId, b: ExprId) -> ExprId {
        self.arena.add(Kind::Binary(op, a, b), Type::REAL)
    }

    pub(super) fn unary(&mut self, op: Unary, a: ExprId) -> ExprId {
        self.arena.add(Kind::Unary(op, a), Type::REAL)
    }

    /// What an expression is the negative of.
    fn negated(&self, e: ExprId) -> Option<ExprId> {
        match self.arena.kind(e) {
            Kind::Unary(Unary::Negate, a) => Some(*a),
            _ => None,
        }
    }

    /// A number as a constant times another.
    fn scaled(&self, e: ExprId) -> (f64, ExprId) {
        if let Kind::Binary(Binary::Multiply, k, a) = self.arena.kind(e)
            && let Some(value) = self.number(*k)
        {
            return (value, *a);
        }
        (1.0, e)
    }

    pub(super) fn negate(&mut self, a: ExprId) -> ExprId {
        if let Some(value) = self.number(a) {
            return self.real(-value);
        }
        match self.negated(a) {
            Some(inner) => inner,
            None => self.unary(Unary::Negate, a),
        }
    }

    pub(super) fn add(&mut self, a: ExprId, b: ExprId) -> ExprId {
        match (self.number(a), self.number(b)) {
            (Some(x), Some(y)) => return self.real(x + y),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => {
                let sum = self.add(a, b);
                return self.negate(sum);
            }
            (None, Some(b)) => return self.subtract(a, b),
            (Some(a), None) => return self.subtract(b, a),
            _ => {}
        }
        let ((k, u), (l, v)) = (self.scaled(a), self.scaled(b));
        if u == v {
            let factor = self.real(k + l);
            return self.multiply(factor, u);
        }
        self.added(Binary::Add, a.min(b), a.max(b))
    }

    pub(super) fn subtract(&mut self, a: ExprId, b: ExprId) -> ExprId {
        match (self.number(a), self.number(b)) {
            (Some(x), Some(y)) => return self.real(x - y),
            (Some(0.0), _) => return self.negate(b),
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => return self.subtract(b, a),
            (None, Some(b)) => return self.add(a, b),
            (Some(a), None) => {
                let sum = self.add(a, b);
                return self.negate(sum);
            }
            _ => {}
        }
        let ((k, u), (l, v)) = (self.scaled(a), self.scaled(b));
        if u == v {
            let factor = self.real(k - l);
            return self.multiply(factor, u);
        }
        match a < b {
            true => self.added(Binary::Subtract, a, b),
            false => {
                let difference = self.added(Binary::Subtract, b, a);
                self.negate(difference)
            }
        }
    }

    pub(super) fn multiply(&mut self, a: ExprId, b: ExprId) -> ExprId {
        match (self.number(a), self.number(b)) {
            (Some(x), Some(y)) => return self.real(x * y),
            (Some(x), None) => return self.times(x, b),
            (None, Some(y)) => return self.times(y, a),
            _ => {}
        }
        let (na, nb) = (self.negated(a), self.negated(b));
        if na.is_some() || nb.is_some() {
            let product = self.multiply(na.unwrap_or(a), nb.unwrap_or(b));
            return match na.is_some() && nb.is_some() {
                true => product,
                false => self.negate(product),
            };
        }
        if let (Kind::Unary(Unary::SquareRoot, inner), true) = (self.arena.kind(a), a == b) {
            return *inner;
        }
        self.added(Binary::Multiply, a.min(b), a.max(b))
    }

    /// A constant times a number.
    pub(super) fn times(&mut self, k: f64, a: ExprId) -> ExprId {
        if let Some(inner) = self.negated(a) {
            return self.times(-k, inner);
        }
        match self.scaled(a) {
            _ if k == 0.0 => self.real(0.0),
            _ if k == 1.0 => a,
            _ if k < 0.0 => {
                let positive = self.times(-k, a);
                self.negate(positive)
            }
            (l, u) if l != 1.0 => self.times(k * l, u),
            _ => {
                let k = self.real(k);
                self.added(Binary::Multiply, k, a)
            }
        }
    }

    /// `1 / a`.
    pub(super) fn reciprocal(&mut self, a: ExprId) -> ExprId {
        if let Some(value) = self.number(a) {
            return self.real(1.0 / value);
        }
        match self.negated(a) {
            Some(inner) => {
                let reciprocal = self.reciprocal(inner);
                self.negate(reciprocal)
            }
            None => {
                let one = self.real(1.0);
                self.added(Binary::Divide, one, a)
            }
        }
    }

    pub(super) fn square(&mut self, a: ExprId) -> ExprId {
        self.multiply(a, a)
    }

    /// A number to the power of a constant.
    pub(super) fn power(&mut self, a: ExprId, p: f64) -> ExprId {
        if p.fract() == 0.0 && (0.0..=4.0).contains(&p) {
            let mut power = self.real(1.0);
            if p >= 2.0 {
                let square = self.square(a);
                power = match p {
                    4.0 => self.square(square),
                    _ => square,
                };
            }
            return match p % 2.0 == 1.0 {
                true => self.multiply(power, a),
                false => power,
            };
        }
        if p == -1.0 {
            return self.reciprocal(a);
        }
        let p = self.real(p);
        self.added(Binary::Power, a, p)
    }

    pub(super) fn atan2(&mut self, y: ExprId, x: ExprId) -> ExprId {
        self.added(Binary::Atan2, y, x)
    }

    pub(super) fn compare(&mut self, op: CompareOp, a: ExprId, b: ExprId) -> ExprId {
        self.arena.add(Kind::Compare(op, a, b), Type::Boolean)
    }

    pub(super) fn choose(&mut self, condition: ExprId, a: ExprId, b: ExprId) -> ExprId {
        match a == b {
            true => a,
            false => self.arena.add(Kind::If(condition, a, b), Type::REAL),
        }
    }

    /// `value` where `guard` is not 0, and 0 there.
    pub(super) fn unless_zero(&mut self, guard: ExprId, value: ExprId) -> ExprId {
        let zero = self.real(0.0);
        let differs = self.compare(CompareOp::NotEqual, guard, zero);
        self.choose(differs, value, zero)
    }

    /// The sum of the products of two lists of numbers.
    pub(super) fn inner(&mut self, a: &[ExprId], b: &[ExprId]) -> ExprId {
        let mut sum = self.real(0.0);
        for (a, b) in a.iter().zip(b) {
            let product = self.multiply(*a, *b);
            sum = self.add(sum, product);
        }
        sum
    }

    /// Adds the terms of a sum, `k` times, to others: what stands in it with its factor.
    pub(super) fn terms(&mut self, e: ExprId, k: f64, all: &mut BTreeMap<ExprId, f64>) {
        if let Some(value) = self.number(e) {
            let one = self.real(1.0);
            *all.entry(one).or_insert(0.0) += k * value;
            return;
        }
        match *self.arena.kind(e) {
            Kind::Unary(Unary::Negate, a) => self.terms(a, -k, all),
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                self.terms(a, k, all);
                let sign = if op == Binary::Add { 1.0 } else { -1.0 };
                self.terms(b, sign * k, all);
            }
            _ => {
                let (scale, a) = self.scaled(e);
                *all.entry(a).or_insert(0.0) += k * scale;
            }
        }
    }
}
