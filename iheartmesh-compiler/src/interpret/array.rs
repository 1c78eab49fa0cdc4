//! Numbers, vectors and matrices out of values.

use nalgebra::DMatrix;

use super::Value;
use crate::syntax::ast::CompareOp;
use crate::types::Type;

pub(super) fn compare(op: CompareOp, a: &Value, b: &Value) -> bool {
    let order = match (a, b) {
        (Value::Real(a), Value::Real(b)) => a.partial_cmp(b),
        _ if matches!(op, CompareOp::Equal | CompareOp::NotEqual) => None,
        _ => Some(a.order(b)),
    };
    match op {
        CompareOp::Equal => a.equals(b),
        CompareOp::NotEqual => !a.equals(b),
        CompareOp::Less => order.is_some_and(|o| o.is_lt()),
        CompareOp::LessOrEqual => order.is_some_and(|o| o.is_le()),
        CompareOp::Greater => order.is_some_and(|o| o.is_gt()),
        CompareOp::GreaterOrEqual => order.is_some_and(|o| o.is_ge()),
    }
}

/// A place from 0 for a number from 1.
pub(super) fn from_one(number: i64, size: usize) -> Option<usize> {
    let place = usize::try_from(number.checked_sub(1)?).ok()?;
    (place < size).then_some(place)
}

/// A negative size is none.
pub(super) fn size(number: i64) -> usize {
    usize::try_from(number).unwrap_or(0)
}

/// Rows and columns; a number has one of each.
pub(super) fn shape(value: &Value) -> (usize, usize) {
    match value {
        Value::Reals(a) => a.shape(),
        Value::Integers(a) => a.shape(),
        _ => (1, 1),
    }
}

/// A vector or matrix of the numbers of its type.
pub(super) fn numbers<'v>(
    ty: &Type,
    rows: usize,
    columns: usize,
    entry: impl Fn(usize, usize) -> &'v Value,
) -> Value {
    match ty.is_integer() {
        true => {
            let entry = |i, j| integer(entry(i, j).clone());
            Value::Integers(DMatrix::from_fn(rows, columns, entry))
        }
        false => {
            let entry = |i, j| real(entry(i, j).clone());
            Value::Reals(DMatrix::from_fn(rows, columns, entry))
        }
    }
}

/// A matrix of blocks, where those of a row have one height and those of a column one width.
pub(super) fn block_matrix(blocks: &[Vec<DMatrix<f64>>]) -> Option<DMatrix<f64>> {
    let heights: Vec<usize> = blocks.iter().map(|row| row[0].nrows()).collect();
    let mut matrix = DMatrix::zeros(heights.iter().sum(), 0);
    let mut top = 0;
    for (row, height) in blocks.iter().zip(&heights) {
        let mut left = 0;
        for block in row {
            if block.nrows() != *height {
                return None;
            }
            if top == 0 {
                matrix = matrix.resize_horizontally(left + block.ncols(), 0.0);
            }
            if left + block.ncols() > matrix.ncols() {
                return None;
            }
            matrix.view_mut((top, left), block.shape()).copy_from(block);
            left += block.ncols();
        }
        if left != matrix.ncols() {
            return None;
        }
        top += height;
    }
    Some(matrix)
}

/// The real number that a value is.
pub(super) fn real(value: Value) -> f64 {
    match value {
        Value::Real(x) => x,
        Value::Reals(a) if a.shape() == (1, 1) => a[(0, 0)],
        other => panic!("bug in iheartmesh: {other} is no real number"),
    }
}

/// The integer that a value is.
pub(super) fn integer(value: Value) -> i64 {
    match value {
        Value::Integer(k) => k,
        other => panic!("bug in iheartmesh: {other} is no integer"),
    }
}

/// The vector or matrix that a value is; a number is 1×1.
pub(super) fn reals(value: Value) -> DMatrix<f64> {
    match value {
        Value::Real(x) => DMatrix::from_element(1, 1, x),
        Value::Reals(a) => a,
        other => panic!("bug in iheartmesh: {other} is no array of real numbers"),
    }
}

pub(super) fn element(value: Value) -> u32 {
    match value {
        Value::Element(id) => id,
        other => panic!("bug in iheartmesh: {other} is no element"),
    }
}
