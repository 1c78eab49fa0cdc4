//! Sizes that must agree, and that types do not prove to do so: some are known only from the values that have them.

use super::{Arena, Binary, ExprId, Kind};
use crate::types::{Atom, Dimension, Type};

/// A direction of an operand: 0 for its rows, 1 for its columns.
pub type Axis = (ExprId, u8);

/// The pairs of sizes of operands that an operation needs to agree, and that may differ at run time.
pub fn unproven(arena: &Arena, e: ExprId) -> Vec<(Axis, Axis)> {
    let pairs = match arena.kind(e) {
        Kind::Binary(
            Binary::Add | Binary::Subtract | Binary::Hadamard | Binary::Dot | Binary::Frobenius,
            a,
            b,
        ) => vec![((*a, 0), (*b, 0)), ((*a, 1), (*b, 1))],
        Kind::Binary(Binary::Product, a, b) => vec![((*a, 1), (*b, 0))],
        Kind::Binary(Binary::Solve | Binary::NormWeighted, a, b) => vec![((*a, 0), (*b, 0))],
        Kind::Blocks(rows) => {
            let heights = rows
                .iter()
                .flat_map(|row| row.iter().map(move |block| ((row[0], 0), (*block, 0))));
            let even = rows.iter().all(|row| row.len() == rows[0].len());
            let below = rows.iter().skip(1).filter(|_| even);
            let widths = below.flat_map(|row| rows[0].iter().zip(row));
            heights
                .chain(widths.map(|(first, block)| ((*first, 1), (*block, 1))))
                .collect()
        }
        _ => Vec::new(),
    };
    let is_unproven = |(a, b): &(Axis, Axis)| match (size(arena, *a), size(arena, *b)) {
        (Some(a), Some(b)) => a != b && (a.is_dynamic() || b.is_dynamic()),
        _ => false,
    };
    pairs.into_iter().filter(is_unproven).collect()
}

/// Whether a type has a size that is known only from a value, which may be another each time it is computed.
pub fn is_of_unknown_size(ty: &Type) -> bool {
    let mut unknown = false;
    ty.atoms(&mut |atom| unknown |= matches!(atom, Atom::Dynamic(_) | Atom::Item(..)));
    unknown
}

fn size(arena: &Arena, (e, axis): Axis) -> Option<Dimension> {
    match (arena.ty(e), axis) {
        (Type::Scalar(_), _) => Some(Dimension::known(1)),
        (
            Type::Vector {
                length,
                space: None,
                ..
            },
            0,
        ) => Some(length.clone()),
        (Type::Vector { space: None, .. }, _) => Some(Dimension::known(1)),
        (
            Type::Matrix {
                rows,
                columns,
                spaces: None,
                ..
            },
            axis,
        ) => Some(if axis == 0 { rows } else { columns }.clone()),
        _ => None,
    }
}
