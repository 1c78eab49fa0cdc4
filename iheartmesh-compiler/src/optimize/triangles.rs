//! The cross product of two sides of a triangle is the same at each of its corners.
//!
//! ```text
//! (a - b) × (b - c)  ⟶  (a - b) × (a - c)      (a - c) × (b - c)  ⟶  (a - b) × (a - c)
//! ```
//!
//! Twice the vector area of the triangle, up to rounding. Used where terms of several corners are computed together, and to
//! find out that a value does not depend on the corner from which it is computed.

use std::collections::HashMap;

use super::{rewrite, share};
use crate::ir::{Arena, Binary, ExprId, Kind, Unary};

/// The common form of an expression in which the cross products of the sides of a triangle are one.
pub fn expression(arena: &mut Arena, e: ExprId) -> ExprId {
    rewrite::upward(arena, e, &mut HashMap::new(), &mut |arena, e| {
        let common = share::canonical(arena, e);
        match *arena.kind(common) {
            Kind::Unary(Unary::Negate, inner) => match area(arena, inner) {
                Some(area) => share::negate(arena, area),
                None => common,
            },
            _ => area(arena, common).unwrap_or(common),
        }
    })
}

/// The cross product of two sides of a triangle, computed from the first of its corners.
fn area(arena: &mut Arena, e: ExprId) -> Option<ExprId> {
    let Kind::Binary(Binary::Cross, first, second) = *arena.kind(e) else {
        return None;
    };
    let (p, q) = side(arena, first)?;
    let (r, s) = side(arena, second)?;
    // the sides as differences of their common corner and another one
    let (corner, to_first, to_second, mut is_reversed) = match () {
        () if p == r => (p, q, s, false),
        () if p == s => (p, q, r, true),
        () if q == r => (q, p, s, true),
        () if q == s => (q, p, r, false),
        () => return None,
    };
    if to_first == to_second {
        return None;
    }
    let mut corners = [corner, to_first, to_second];
    for (k, l) in [(0, 1), (1, 2), (0, 1)] {
        if corners[k] > corners[l] {
            corners.swap(k, l);
            is_reversed = !is_reversed;
        }
    }
    let [a, b, c] = corners;
    let (side, ty) = (arena.ty(first).clone(), arena.ty(e).clone());
    let [to_b, to_c] =
        [b, c].map(|end| arena.add(Kind::Binary(Binary::Subtract, a, end), side.clone()));
    let cross = arena.add(Kind::Binary(Binary::Cross, to_b, to_c), ty);
    let area = share::canonical(arena, cross);
    Some(match is_reversed {
        true => share::negate(arena, area),
        false => area,
    })
}

/// `p` and `q` of `p - q`.
fn side(arena: &Arena, e: ExprId) -> Option<(ExprId, ExprId)> {
    match *arena.kind(e) {
        Kind::Binary(Binary::Subtract, p, q) => Some((p, q)),
        _ => None,
    }
}
