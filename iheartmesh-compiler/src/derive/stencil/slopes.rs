//! First and second derivatives of each operation on real numbers. Where one is infinite or not defined, it is what the
//! first derivatives of `rules` and `elementary` have: 0 at the singular points of roots, norms and arc functions.

use super::numbers::Numbers;
use crate::ir::{Binary, Elementary, ExprId, Kind, Unary};
use crate::syntax::ast::CompareOp;

/// What an operation hands on: its derivatives by its operands, those that are there once, and the second ones by pairs.
#[derive(Debug, Default)]
pub(super) struct Slopes {
    pub(super) first: Vec<(ExprId, ExprId)>,
    pub(super) second: Vec<(ExprId, ExprId, ExprId)>,
}

impl Slopes {
    fn one(a: ExprId, first: ExprId, second: ExprId) -> Self {
        Self {
            first: vec![(a, first)],
            second: vec![(a, a, second)],
        }
    }
}

impl Numbers<'_> {
    /// The derivatives of an operation; `None` where they are not known here.
    pub(super) fn slopes(&mut self, e: ExprId) -> Option<Slopes> {
        let s = self;
        Some(match s.arena.kind(e).clone() {
            Kind::Unary(Unary::Negate, a) => Slopes {
                first: vec![(a, s.real(-1.0))],
                second: Vec::new(),
            },
            Kind::Binary(op @ (Binary::Add | Binary::Subtract), a, b) => {
                let sign = if op == Binary::Add { 1.0 } else { -1.0 };
                Slopes {
                    first: vec![(a, s.real(1.0)), (b, s.real(sign))],
                    second: Vec::new(),
                }
            }
            Kind::Binary(Binary::Multiply, a, b) if a == b => {
                let slope = s.times(2.0, a);
                let two = s.real(2.0);
                Slopes::one(a, slope, two)
            }
            Kind::Binary(Binary::Multiply, a, b) => Slopes {
                first: vec![(a, b), (b, a)],
                second: vec![(a, b, s.real(1.0))],
            },
            Kind::Binary(Binary::Divide, one, a) if s.number(one) == Some(1.0) => {
                s.slopes_of_reciprocal(e, a)
            }
            Kind::Binary(Binary::Power, a, p) => {
                let p = s.number(p)?;
                let r = s.reciprocal(a);
                let ratio = s.multiply(e, r);
                let slope = s.times(p, ratio);
                let slope = s.unless_zero(a, slope);
                let ratio = s.multiply(ratio, r);
                let curve = s.times(p * (p - 1.0), ratio);
                let curve = s.unless_zero(a, curve);
                Slopes::one(a, slope, curve)
            }
            Kind::Binary(Binary::Atan2, y, x) => {
                let (a, b) = (s.square(y), s.square(x));
                let sum = s.add(a, b);
                let r = s.reciprocal(sum);
                let r = s.unless_zero(sum, r);
                let square = s.square(r);
                let (by_y, by_x) = (s.multiply(x, r), s.multiply(y, r));
                let difference = s.subtract(a, b);
                let mixed = s.multiply(difference, square);
                let product = s.multiply(x, y);
                let product = s.multiply(product, square);
                Slopes {
                    first: vec![(y, by_y), (x, s.negate(by_x))],
                    second: vec![
                        (y, y, s.times(-2.0, product)),
                        (x, x, s.times(2.0, product)),
                        (y, x, mixed),
                    ],
                }
            }
            Kind::Unary(Unary::Absolute, a) => {
                let (zero, one, minus) = (s.real(0.0), s.real(1.0), s.real(-1.0));
                let greater = s.compare(CompareOp::Greater, a, zero);
                let less = s.compare(CompareOp::Less, a, zero);
                let below = s.choose(less, minus, zero);
                let sign = s.choose(greater, one, below);
                Slopes {
                    first: vec![(a, sign)],
                    second: Vec::new(),
                }
            }
            Kind::Unary(Unary::SquareRoot, a) => {
                let r = s.reciprocal(e);
                let r = s.unless_zero(e, r);
                let (square, slope) = (s.square(r), s.times(0.5, r));
                let cube = s.multiply(square, r);
                let curve = s.times(-0.25, cube);
                Slopes::one(a, slope, curve)
            }
            Kind::Unary(Unary::Apply(function), a) => s.elementary(function, a, e),
            _ => return None,
        })
    }

    /// The derivatives of `r = 1 / a`.
    pub(super) fn slopes_of_reciprocal(&mut self, r: ExprId, a: ExprId) -> Slopes {
        let square = self.square(r);
        let cube = self.multiply(square, r);
        let slope = self.negate(square);
        let curve = self.times(2.0, cube);
        Slopes::one(a, slope, curve)
    }

    fn elementary(&mut self, function: Elementary, a: ExprId, y: ExprId) -> Slopes {
        let s = self;
        let one = s.real(1.0);
        let apply = |s: &mut Self, f| s.unary(Unary::Apply(f), a);
        let (slope, curve) = match function {
            Elementary::Sin => (apply(s, Elementary::Cos), s.negate(y)),
            Elementary::Cos => {
                let sine = apply(s, Elementary::Sin);
                (s.negate(sine), s.negate(y))
            }
            Elementary::Tan | Elementary::Cot => {
                let square = s.square(y);
                let slope = s.add(one, square);
                let product = s.multiply(y, slope);
                let curve = s.times(2.0, product);
                match function {
                    Elementary::Tan => (slope, curve),
                    _ => (s.negate(slope), curve),
                }
            }
            Elementary::Sec | Elementary::Csc => {
                let other = match function {
                    Elementary::Sec => apply(s, Elementary::Tan),
                    _ => apply(s, Elementary::Cot),
                };
                let slope = s.multiply(y, other);
                let (p, q) = (s.square(y), s.square(other));
                let sum = s.add(p, q);
                let curve = s.multiply(y, sum);
                match function {
                    Elementary::Sec => (slope, curve),
                    _ => (s.negate(slope), curve),
                }
            }
            Elementary::Asin | Elementary::Acos | Elementary::Acosh | Elementary::Asinh => {
                let square = s.square(a);
                let inside = match function {
                    Elementary::Asinh => s.add(square, one),
                    Elementary::Acosh => s.subtract(square, one),
                    _ => s.subtract(one, square),
                };
                let root = s.unary(Unary::SquareRoot, inside);
                let slope = s.reciprocal(root);
                let slope = s.unless_zero(root, slope);
                let square = s.square(slope);
                let cube = s.multiply(square, slope);
                let curve = s.multiply(a, cube);
                match function {
                    Elementary::Asin => (slope, curve),
                    Elementary::Acos => (s.negate(slope), s.negate(curve)),
                    _ => (slope, s.negate(curve)),
                }
            }
            Elementary::Atan | Elementary::Atanh => {
                let square = s.square(a);
                let (below, sign) = match function {
                    Elementary::Atan => (s.add(one, square), -2.0),
                    _ => (s.subtract(one, square), 2.0),
                };
                let slope = s.reciprocal(below);
                let square = s.square(slope);
                let product = s.multiply(a, square);
                (slope, s.times(sign, product))
            }
            Elementary::Sinh => (apply(s, Elementary::Cosh), y),
            Elementary::Cosh => (apply(s, Elementary::Sinh), y),
            Elementary::Tanh => {
                let square = s.square(y);
                let slope = s.subtract(one, square);
                let product = s.multiply(y, slope);
                (slope, s.times(-2.0, product))
            }
            Elementary::Exp => (y, y),
            Elementary::Ln | Elementary::Log2 | Elementary::Log10 => {
                let scale = match function {
                    Elementary::Ln => 1.0,
                    Elementary::Log2 => std::f64::consts::LOG2_E,
                    _ => std::f64::consts::LOG10_E,
                };
                let r = s.reciprocal(a);
                let square = s.square(r);
                (s.times(scale, r), s.times(-scale, square))
            }
        };
        Slopes::one(a, slope, curve)
    }
}
