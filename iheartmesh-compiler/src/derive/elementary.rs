//! The derivatives of elementary functions.

use super::reverse::Reverse;
use crate::ir::{Elementary, ExprId, Unary};
use crate::types::Type;

impl Reverse<'_, '_> {
    /// The derivative of an elementary function at `a`, where its value is `y`. Where it is infinite, at the ends of
    /// `arcsin`, `arccos` and `arcosh`, it is taken as 0.
    pub(super) fn slope(&mut self, function: Elementary, a: ExprId, y: ExprId) -> ExprId {
        let mut s = self.algebra();
        let one = s.real(1.0);
        let apply =
            |s: &mut super::algebra::Algebra<'_>, f| s.unary(Unary::Apply(f), a, Type::REAL);
        match function {
            Elementary::Sin => apply(&mut s, Elementary::Cos),
            Elementary::Cos => {
                let sine = apply(&mut s, Elementary::Sin);
                s.negate(sine)
            }
            Elementary::Tan | Elementary::Cot => {
                let square = s.scale(y, y);
                let slope = s.add(one, square);
                match function {
                    Elementary::Tan => slope,
                    _ => s.negate(slope),
                }
            }
            Elementary::Sec => {
                let tangent = apply(&mut s, Elementary::Tan);
                s.scale(y, tangent)
            }
            Elementary::Csc => {
                let cotangent = apply(&mut s, Elementary::Cot);
                let slope = s.scale(y, cotangent);
                s.negate(slope)
            }
            Elementary::Asin | Elementary::Acos | Elementary::Acosh | Elementary::Asinh => {
                let square = s.scale(a, a);
                let inside = match function {
                    Elementary::Asinh => s.add(square, one),
                    Elementary::Acosh => s.subtract(square, one),
                    _ => s.subtract(one, square),
                };
                let root = s.unary(Unary::SquareRoot, inside, Type::REAL);
                let slope = s.divide(one, root);
                let slope = match function {
                    Elementary::Acos => s.negate(slope),
                    _ => slope,
                };
                match function {
                    Elementary::Asinh => slope,
                    _ => s.unless_zero(root, slope),
                }
            }
            Elementary::Atan => {
                let square = s.scale(a, a);
                let sum = s.add(one, square);
                s.divide(one, sum)
            }
            Elementary::Sinh => apply(&mut s, Elementary::Cosh),
            Elementary::Cosh => apply(&mut s, Elementary::Sinh),
            Elementary::Tanh => {
                let square = s.scale(y, y);
                s.subtract(one, square)
            }
            Elementary::Atanh => {
                let square = s.scale(a, a);
                let rest = s.subtract(one, square);
                s.divide(one, rest)
            }
            Elementary::Exp => y,
            Elementary::Ln => s.divide(one, a),
            Elementary::Log2 | Elementary::Log10 => {
                let base: f64 = match function {
                    Elementary::Log2 => 2.0,
                    _ => 10.0,
                };
                let base = s.real(base.ln());
                let scaled = s.scale(base, a);
                s.divide(one, scaled)
            }
        }
    }
}
