//! What is said where an expression has no value.

use super::{Binary, ExprId, Fold, Kind, Program, Unary};
use crate::types::{Shape, Type};

/// Why an expression has no value when its operands have theirs.
pub fn failure(program: &Program, e: ExprId) -> String {
    let arena = &program.arena;
    let text = match arena.kind(e) {
        Kind::SetItem(_, index) => match arena.kind(*index) {
            Kind::Integer(k) => return format!("the set has no member {k}"),
            _ => "the set has no member of this number",
        },
        // of the set that the element is the first of
        Kind::Neighbor(..) => "the set has no member 1",
        Kind::Sized(_, n) => return format!("the set does not have exactly {n} members"),
        Kind::Item(_, index) if arena.ty(*index).is_element() => "the sequence has no such item",
        Kind::Item(..) => "the sequence has no item of this number",
        Kind::Component(..) => "the vector has no entry of this number",
        Kind::Fold {
            op: Fold::Min | Fold::ArgMin,
            ..
        } => "the minimum of an empty set",
        Kind::Fold {
            op: Fold::Max | Fold::ArgMax,
            ..
        } => "the maximum of an empty set",
        Kind::Optimum { greatest, .. } => {
            let [_, _, unsettled] = no_optimum(*greatest);
            return unsettled;
        }
        Kind::Integral { .. } => "the integral diverges, or is not known to 10 digits,",
        Kind::Fail => "no case applies",
        Kind::Fold { op: Fold::Sum, .. } if arena.ty(e).shape() != Some(Shape::Scalar) => {
            "terms of different sizes, or none of a size that is not known,"
        }
        Kind::Blocks(_) | Kind::Tabulate { .. } => "the sizes do not fit",
        Kind::Binary(
            Binary::Add
            | Binary::Subtract
            | Binary::Hadamard
            | Binary::Dot
            | Binary::Frobenius
            | Binary::Product
            | Binary::NormWeighted,
            ..,
        ) if *arena.ty(e) != Type::INTEGER => "the sizes do not fit",
        Kind::Fold { .. }
        | Kind::Unary(Unary::Negate | Unary::Absolute, _)
        | Kind::Binary(Binary::Add | Binary::Subtract | Binary::Multiply, ..) => {
            "an integer is too large"
        }
        Kind::At(..) | Kind::Stored(..) => "the matrix has no such entry",
        Kind::Scatter { .. } => "a place lies outside of the matrix",
        Kind::Update(..) => "a place that is set does not exist",
        Kind::RowOf(..) => "the matrix has no such row",
        Kind::Assemble { .. } => "a derivative by an item that there is not",
        Kind::ColumnOf(..) => "the matrix has no such column",
        Kind::Agree(..) if *arena.ty(e) == Type::INTEGER => {
            "two sizes differ that one index runs over,"
        }
        Kind::Agree(..) => "two sizes differ",
        Kind::Unary(Unary::Rank | Unary::NullSpace | Unary::OrthogonalBasis, _) => {
            "a matrix with NaN or ∞ has no rank:"
        }
        Kind::Filled(..) | Kind::Identity(_) => {
            "a size is negative, or there would be too many entries,"
        }
        Kind::Unary(Unary::Inverse, _) => "a singular matrix has no inverse:",
        Kind::Binary(Binary::Solve, ..) => "the matrix of the system is singular",
        Kind::Binary(Binary::MatrixPower, ..) => "this power of the matrix does not exist",
        Kind::Binary(Binary::Unstack, ..) => "the sizes do not fit",
        Kind::Unary(op @ (Unary::Least | Unary::Greatest), a) => {
            let word = if *op == Unary::Least {
                "minimum"
            } else {
                "maximum"
            };
            let of = match arena.ty(*a) {
                Type::Sequence { .. } => "a sequence",
                Type::Matrix { .. } => "a matrix",
                _ => "a vector",
            };
            return format!("the {word} of {of} without entries");
        }
        Kind::Call(id, _) => return format!("`{}` has no value", program.function(*id).name),
        _ => "there is no such element",
    };
    text.to_owned()
}

/// Why there is no optimum: the objective has no bound, nothing satisfies the restrictions, the search does not settle.
pub fn no_optimum(greatest: bool) -> [String; 3] {
    let (word, limit) = match greatest {
        true => ("maximum", "above"),
        false => ("minimum", "below"),
    };
    [
        format!("there is no {word}, since the objective has no bound from {limit},"),
        "no point was found that satisfies the restrictions".to_owned(),
        format!("no {word} was found: the search does not settle"),
    ]
}
