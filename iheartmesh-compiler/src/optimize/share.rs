//! Expressions are brought to a common form, so that equal values are one expression.
//!
//! ```text
//! b - a        ⟶  -(a - b)      where a comes before b      a + (-b)  ⟶  a - b
//! u × v        ⟶  -(v × u)      where v comes before u      (-u)⋅v    ⟶  -(u⋅v)
//! ‖-u‖         ⟶  ‖u‖           ‖u‖²                        ⟶  u⋅u
//! ```
//!
//! All of these keep the value bit for bit (IEEE 754 arithmetic is symmetric in sign and its sums and products are
//! commutative), except `‖u‖²`, whose new form is the more exact one, and
//!
//! ```text
//! ∑ 3 u        ⟶  3 ∑ u         ∑ u / 3                     ⟶  (∑ u) / 3
//! ```
//!
//! which rounds less often.

use std::collections::HashMap;

use super::rewrite;
use crate::ir::{Arena, Binary, ExprId, Fold, Kind, Program, Unary};
use crate::types::Type;

/// Brings all of a program to the common form.
pub fn run(program: &mut Program) {
    rewrite::program(program, canonical);
}

/// Brings one expression to the common form.
pub fn expression(arena: &mut Arena, e: ExprId) -> ExprId {
    rewrite::upward(arena, e, &mut HashMap::new(), &mut canonical)
}

fn negated(arena: &Arena, e: ExprId) -> Option<ExprId> {
    match arena.kind(e) {
        Kind::Unary(Unary::Negate, inner) => Some(*inner),
        _ => None,
    }
}

/// The negative of an expression.
pub fn negate(arena: &mut Arena, e: ExprId) -> ExprId {
    if let Some(inner) = negated(arena, e) {
        return inner;
    }
    let ty = arena.ty(e).clone();
    arena.add(Kind::Unary(Unary::Negate, e), ty)
}

fn real(arena: &Arena, e: ExprId) -> Option<f64> {
    match arena.kind(e) {
        Kind::Real(bits) => Some(f64::from_bits(*bits)),
        _ => None,
    }
}

/// The common form of an expression whose operands are in common form.
pub fn canonical(arena: &mut Arena, e: ExprId) -> ExprId {
    let ty = arena.ty(e).clone();
    match arena.kind(e).clone() {
        // where integers may be too large, every step must be as it is written
        Kind::Unary(Unary::Negate, _) if super::may_overflow(arena, e) => e,
        Kind::Binary(op, a, b) if super::may_overflow(arena, e) => match op {
            Binary::Add | Binary::Multiply => ordered(arena, op, a, b, ty),
            _ => e,
        },
        Kind::Unary(Unary::Negate, a) => match (negated(arena, a), real(arena, a)) {
            (Some(inner), _) => inner,
            (_, Some(value)) => arena.real(-value),
            _ => e,
        },
        Kind::Unary(op @ (Unary::Norm | Unary::Absolute), a) => match negated(arena, a) {
            Some(inner) => arena.add(Kind::Unary(op, inner), ty),
            None => e,
        },
        Kind::Binary(op, a, b) => binary(arena, e, op, a, b, ty),
        Kind::Fold {
            op: Fold::Sum,
            body,
            ..
        } if ty == Type::REAL || ty.fixed_vector().is_some() => factor_out(arena, e, body, ty),
        _ => e,
    }
}

/// A sum without the constant factor of its terms, times that.
fn factor_out(arena: &mut Arena, sum: ExprId, term: ExprId, ty: Type) -> ExprId {
    // the sign stays inside, so that the sum of nothing is 0 and not -0
    let inner = negated(arena, term);
    let is_negated = inner.is_some();
    let Kind::Binary(op, a, b) = *arena.kind(inner.unwrap_or(term)) else {
        return sum;
    };
    let (factor, rest) = match op {
        Binary::Multiply => (a, b),
        Binary::Divide => (b, a),
        _ => return sum,
    };
    let is_constant = real(arena, factor).is_some_and(|c| c.is_normal() && c > 0.0);
    if !is_constant || *arena.ty(rest) != ty {
        return sum;
    }
    let rest = match is_negated {
        true => negate(arena, rest),
        false => rest,
    };
    let mut kind = arena.kind(sum).clone();
    if let Kind::Fold { body, .. } = &mut kind {
        *body = rest;
    }
    let plain = arena.add(kind, ty.clone());
    if let Some(span) = arena.origin(sum) {
        arena.note_origin(plain, span);
    }
    let plain = canonical(arena, plain);
    let kind = match op {
        Binary::Multiply => Kind::Binary(op, factor, plain),
        _ => Kind::Binary(op, plain, factor),
    };
    let scaled = arena.add(kind, ty);
    canonical(arena, scaled)
}

fn binary(arena: &mut Arena, e: ExprId, op: Binary, a: ExprId, b: ExprId, ty: Type) -> ExprId {
    let (na, nb) = (negated(arena, a), negated(arena, b));
    match op {
        Binary::Add => match (na, nb) {
            (None, Some(b)) => subtract(arena, a, b, ty),
            (Some(a), None) => subtract(arena, b, a, ty),
            (Some(a), Some(b)) => {
                let sum = ordered(arena, Binary::Add, a, b, ty);
                negate(arena, sum)
            }
            (None, None) => ordered(arena, op, a, b, ty),
        },
        Binary::Subtract => match (na, nb) {
            (None, Some(b)) => ordered(arena, Binary::Add, a, b, ty),
            (Some(a), None) => {
                let sum = ordered(arena, Binary::Add, a, b, ty);
                negate(arena, sum)
            }
            (Some(a), Some(b)) => subtract(arena, b, a, ty),
            (None, None) => subtract(arena, a, b, ty),
        },
        Binary::Multiply | Binary::Dot | Binary::Cross | Binary::Divide
            if na.is_some() || nb.is_some() =>
        {
            let (inner_a, inner_b) = (na.unwrap_or(a), nb.unwrap_or(b));
            let raw = arena.add(Kind::Binary(op, inner_a, inner_b), ty);
            let inner = canonical(arena, raw);
            if na.is_some() && nb.is_some() {
                inner
            } else {
                negate(arena, inner)
            }
        }
        Binary::Multiply => {
            if real(arena, a) == Some(1.0) {
                return b;
            }
            if ty.is_scalar() && real(arena, b) == Some(1.0) {
                return a;
            }
            if let (Kind::Unary(Unary::Norm, u), true) = (arena.kind(a).clone(), a == b) {
                return square(arena, u);
            }
            if ty.is_scalar() {
                ordered(arena, op, a, b, ty)
            } else {
                e
            }
        }
        Binary::Dot => ordered(arena, op, a, b, ty),
        Binary::Cross if a > b => {
            let cross = arena.add(Kind::Binary(Binary::Cross, b, a), ty);
            negate(arena, cross)
        }
        Binary::Divide if real(arena, b) == Some(1.0) => a,
        Binary::Atan2 => match na {
            Some(y) => {
                let angle = arena.add(Kind::Binary(Binary::Atan2, y, b), ty);
                negate(arena, angle)
            }
            None => e,
        },
        Binary::Power => match real(arena, b) {
            Some(1.0) => a,
            Some(2.0) => match arena.kind(a).clone() {
                Kind::Unary(Unary::Norm, u) => square(arena, u),
                _ => {
                    let a = na.unwrap_or(a);
                    arena.add(Kind::Binary(Binary::Multiply, a, a), ty)
                }
            },
            _ => e,
        },
        Binary::Min | Binary::Max => ordered(arena, op, a, b, ty),
        _ => e,
    }
}

/// The sum of the squares of all entries.
fn square(arena: &mut Arena, u: ExprId) -> ExprId {
    let op = match arena.ty(u) {
        Type::Matrix { .. } => Binary::Frobenius,
        _ => Binary::Dot,
    };
    arena.add(Kind::Binary(op, u, u), Type::REAL)
}

/// An operation whose operands may be exchanged.
fn ordered(arena: &mut Arena, op: Binary, a: ExprId, b: ExprId, ty: Type) -> ExprId {
    let (a, b) = if a <= b { (a, b) } else { (b, a) };
    arena.add(Kind::Binary(op, a, b), ty)
}

fn subtract(arena: &mut Arena, a: ExprId, b: ExprId, ty: Type) -> ExprId {
    if a <= b {
        return arena.add(Kind::Binary(Binary::Subtract, a, b), ty);
    }
    let difference = arena.add(Kind::Binary(Binary::Subtract, b, a), ty);
    negate(arena, difference)
}
