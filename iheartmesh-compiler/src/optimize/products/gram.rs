//! The product of the transpose of a matrix and the matrix, where each row is put together in one round of a loop: a sum of
//! small blocks, in which nothing is searched for.
//!
//! ```text
//! J = ∑_k  a_k at row k, columns     JᵀJ  ⟶  ∑_k  a_kᵀ a_k at columns, columns
//! ```
//!
//! The rows of different rounds must be different, which holds where they are the number of the round, or each round has so many
//! rows of its own. This is the matrix of the Gauss-Newton method, with `J` the derivatives of the vector that is squared.

use std::collections::HashMap;

use super::Finder;
use crate::ir::{Arena, Binary, Block, ExprId, Fold, Kind, Unary, VariableId};
use crate::optimize::rewrite;
use crate::types::{Dimension, Shape, Type};

use super::blocks::LARGEST_BLOCK;

/// `k Jᵀ` and `J` of such a product.
#[derive(Clone, Copy)]
pub(super) struct Gram {
    pub(super) left: ExprId,
    pub(super) right: ExprId,
    factor: Option<ExprId>,
    /// The loop over the rows.
    rows: ExprId,
}

/// Whether an expression is such a product.
pub(super) fn find(finder: &Finder, arena: &Arena, e: ExprId) -> Option<Gram> {
    let Kind::Binary(Binary::Product, left, right) = *arena.kind(e) else {
        return None;
    };
    let (factor, transposed) = match *arena.kind(left) {
        Kind::Binary(Binary::Multiply, k, a) => (Some(k), a),
        _ => (None, left),
    };
    let Kind::Unary(Unary::Transpose, matrix) = *arena.kind(transposed) else {
        return None;
    };
    let rows = finder.value(arena, right);
    if finder.value(arena, matrix) != rows || !arena.ty(rows).is_sparse() {
        return None;
    }
    let Kind::Fold {
        op: Fold::Sum,
        variable,
        body,
        ..
    } = *arena.kind(rows)
    else {
        return None;
    };
    is_one_round(arena, body, variable).then_some(Gram {
        left,
        right,
        factor,
        rows,
    })
}

/// `JᵀJ` as a sum of blocks.
pub(super) fn sum_of_blocks(arena: &mut Arena, e: ExprId, gram: Gram) -> Option<ExprId> {
    let Kind::Fold {
        op,
        variable,
        range,
        condition,
        body,
    } = *arena.kind(gram.rows)
    else {
        return None;
    };
    let ty = arena.ty(e).clone();
    let body = of_round(arena, body, &ty)?;
    let kind = Kind::Fold {
        op,
        variable,
        range,
        condition,
        body,
    };
    let done = arena.add(kind, ty.clone());
    // the loop is written twice now
    let mut done = rewrite::substitute(arena, done, &HashMap::new());
    if let Some(k) = gram.factor {
        done = arena.add(Kind::Binary(Binary::Multiply, k, done), ty);
    }
    if let Some(span) = arena.origin(e) {
        arena.note_origin(done, span);
    }
    Some(done)
}

/// Whether a part of a round puts rows of their own together, and nothing else.
fn is_one_round(arena: &Arena, body: ExprId, variable: VariableId) -> bool {
    match arena.kind(body) {
        Kind::Assemble { sizes, blocks } => {
            sizes.len() == 2 && have_rows_of_their_own(arena, blocks, variable)
        }
        Kind::If(_, a, b) => is_one_round(arena, *a, variable) && is_one_round(arena, *b, variable),
        _ => false,
    }
}

/// What one round gives.
fn of_round(arena: &mut Arena, body: ExprId, ty: &Type) -> Option<ExprId> {
    match arena.kind(body).clone() {
        Kind::Assemble { sizes, blocks } => {
            let width = *sizes.get(1)?;
            let mut all: Vec<Block> = Vec::new();
            for left in &blocks {
                for right in blocks.iter().filter(|right| right.rows == left.rows) {
                    let value = product(arena, left.value, right.value)?;
                    let ty = arena.ty(value).clone();
                    let same = all.iter_mut().find(|other| {
                        other.rows == left.columns
                            && other.columns == right.columns
                            && *arena.ty(other.value) == ty
                    });
                    match same {
                        Some(other) => {
                            let sum = Kind::Binary(Binary::Add, other.value, value);
                            other.value = arena.add(sum, ty);
                        }
                        None => all.push(Block {
                            rows: left.columns.clone(),
                            columns: right.columns.clone(),
                            value,
                            core: None,
                        }),
                    }
                }
            }
            let kind = Kind::Assemble {
                sizes: vec![width, width],
                blocks: all,
            };
            Some(arena.add(kind, ty.clone()))
        }
        Kind::If(condition, a, b) => {
            let a = of_round(arena, a, ty)?;
            let b = of_round(arena, b, ty)?;
            Some(arena.add(Kind::If(condition, a, b), ty.clone()))
        }
        _ => None,
    }
}

/// Whether each block is one row, and no row is one of another round or of another block but with the same place.
fn have_rows_of_their_own(arena: &Arena, blocks: &[Block], variable: VariableId) -> bool {
    let mut strides = Vec::new();
    for block in blocks {
        let is_row = match arena.ty(block.value).shape() {
            Some(Shape::Scalar) => true,
            Some(Shape::Matrix(n, m)) => {
                n.value() == Some(1) && m.value().is_some_and(|m| (1..=LARGEST_BLOCK).contains(&m))
            }
            _ => false,
        };
        let ([row], true) = (&block.rows[..], is_row) else {
            return false;
        };
        match stride(arena, *row, variable) {
            Some(found) => strides.push(found),
            None => return false,
        }
    }
    strides.windows(2).all(|pair| pair[0] == pair[1])
}

/// How many rows each round has: a place is the number of the round `k`, or `(k - 1) n + 1` up to `(k - 1) n + n`.
fn stride(arena: &Arena, row: ExprId, variable: VariableId) -> Option<i64> {
    let is_number = |e: ExprId| match arena.kind(e) {
        Kind::Variable(v) => *v == variable,
        Kind::Unary(Unary::ToInteger, a) => *arena.kind(*a) == Kind::Variable(variable),
        _ => false,
    };
    if is_number(row) {
        return Some(1);
    }
    let integer = |e: ExprId| match arena.kind(e) {
        Kind::Integer(n) => Some(*n),
        _ => None,
    };
    let Kind::Binary(Binary::Add, start, k) = *arena.kind(row) else {
        return None;
    };
    let Kind::Binary(Binary::Multiply, before, n) = *arena.kind(start) else {
        return None;
    };
    let Kind::Binary(Binary::Subtract, number, one) = *arena.kind(before) else {
        return None;
    };
    let n = integer(n)?;
    let fits = is_number(number) && integer(one) == Some(1) && (1..=n).contains(&integer(k)?);
    fits.then_some(n)
}

/// `aᵀ b`, of rows or numbers.
fn product(arena: &mut Arena, a: ExprId, b: ExprId) -> Option<ExprId> {
    let width = |arena: &Arena, e: ExprId| match arena.ty(e).shape()? {
        Shape::Scalar => Some(1),
        Shape::Matrix(_, m) => m.value(),
        Shape::Vector(_) => None,
    };
    let (n, m) = (width(arena, a)?, width(arena, b)?);
    let are_numbers = [a, b].map(|e| arena.ty(e).is_scalar());
    let matrix = |n, m| Type::real_matrix(Dimension::known(n), Dimension::known(m));
    let column = match are_numbers[0] {
        true => a,
        false => match *arena.kind(a) {
            Kind::Unary(Unary::Transpose, inner) => inner,
            _ => arena.add(Kind::Unary(Unary::Transpose, a), matrix(n, 1)),
        },
    };
    let (op, ty) = match are_numbers {
        [true, true] => (Binary::Multiply, Type::REAL),
        [true, false] => (Binary::Multiply, matrix(1, m)),
        [false, true] => {
            let ty = arena.ty(column).clone();
            return Some(arena.add(Kind::Binary(Binary::Multiply, b, column), ty));
        }
        [false, false] => (Binary::Product, matrix(n, m)),
    };
    Some(arena.add(Kind::Binary(op, column, b), ty))
}
