//! Boundary matrices: compressed columns, read by column and checked when they come from outside.
//!
//! Only the storage of `sprs` is used here, none of its products: a column is a slice of row numbers and a slice of
//! signs.

use std::ops::Range;

use sprs::CsMatI;

use crate::element::ElementKind;
use crate::mesh::MeshError;

/// A boundary matrix or a coboundary matrix (its transpose), signed or unsigned.
///
/// Compressed columns (CSC): `u32` column pointers, `u32` row numbers ascending in each column, `i8` entries −1, +1
/// (unsigned: 1), none of them zero.
pub type BoundaryMatrix = CsMatI<i8, u32>;

/// Largest number of elements of one kind: `sprs` needs one more than it to be a `u32`.
pub(crate) const MAX_ELEMENTS: usize = u32::MAX as usize - 1;

/// Largest number of edges: ∂¹ has two entries for each, whose number must be a `u32` too.
pub(crate) const MAX_EDGES: usize = u32::MAX as usize / 2;

/// The parts of a compressed-column matrix before they become a [`BoundaryMatrix`].
pub(crate) struct Columns {
    pub(crate) pointers: Vec<u32>,
    pub(crate) rows: Vec<u32>,
    pub(crate) signs: Vec<i8>,
}

impl Columns {
    /// The matrix with these columns and `n_rows` rows.
    ///
    /// `sprs` checks the structure once more, in time proportional to the number of entries.
    pub(crate) fn into_matrix(self, n_rows: usize) -> BoundaryMatrix {
        let n_columns = self.pointers.len() - 1;
        BoundaryMatrix::try_new_csc((n_rows, n_columns), self.pointers, self.rows, self.signs)
            .unwrap_or_else(|(.., error)| {
                panic!("bug in iheartmesh: malformed boundary matrix: {error}")
            })
    }
}

/// Column `j` of a matrix in compressed columns: row numbers (ascending) and entries.
#[inline]
pub(crate) fn column(matrix: &BoundaryMatrix, j: usize) -> (&[u32], &[i8]) {
    let range = column_range(matrix, j);
    (&matrix.indices()[range.clone()], &matrix.data()[range])
}

/// The row numbers of column `j`, ascending. Saves the bounds checks of the entries.
#[inline]
pub(crate) fn column_rows(matrix: &BoundaryMatrix, j: usize) -> &[u32] {
    &matrix.indices()[column_range(matrix, j)]
}

#[inline]
pub(crate) fn column_range(matrix: &BoundaryMatrix, j: usize) -> Range<usize> {
    let pointers = matrix.indptr().into_raw_storage();
    pointers[j] as usize..pointers[j + 1] as usize
}

/// The transpose, again in compressed columns. One counting sort: O(rows + columns + entries).
pub(crate) fn transpose(matrix: &BoundaryMatrix) -> BoundaryMatrix {
    let mut pointers = vec![0_u32; matrix.rows() + 1];
    for &row in matrix.indices() {
        pointers[row as usize + 1] += 1;
    }
    for row in 0..matrix.rows() {
        pointers[row + 1] += pointers[row];
    }
    let mut cursors = pointers.clone();
    let mut rows = vec![0; matrix.nnz()];
    let mut signs = vec![0; matrix.nnz()];
    for j in 0..matrix.cols() {
        let (column_rows, column_signs) = column(matrix, j);
        for (&row, &sign) in column_rows.iter().zip(column_signs) {
            let cursor = &mut cursors[row as usize];
            rows[*cursor as usize] = j as u32;
            signs[*cursor as usize] = sign;
            *cursor += 1;
        }
    }
    Columns {
        pointers,
        rows,
        signs,
    }
    .into_matrix(matrix.cols())
}

/// The matrix of absolute values.
pub(crate) fn unsigned(matrix: &BoundaryMatrix) -> BoundaryMatrix {
    matrix.map(|sign| sign.abs())
}

/// Brings ∂ᵏ as a user gives it into the form that this crate keeps, or says why it is no boundary matrix.
///
/// # Errors
/// [`MeshError::TooManyElements`], and [`MeshError::InvalidEntry`] for a stored entry other than −1 and +1.
pub(crate) fn checked(k: usize, matrix: &BoundaryMatrix) -> Result<BoundaryMatrix, MeshError> {
    for (count, kind) in [(matrix.rows(), kind(k - 1)), (matrix.cols(), kind(k))] {
        if count > MAX_ELEMENTS {
            return Err(MeshError::TooManyElements {
                kind,
                count,
                maximum: MAX_ELEMENTS,
            });
        }
    }
    // Converting the storage also makes the column pointers start at 0, which those of a slice need not.
    let matrix = if matrix.is_csr() {
        matrix.to_other_storage()
    } else {
        matrix.to_other_storage().to_other_storage()
    };
    for (column, entries) in matrix.outer_iterator().enumerate() {
        if let Some((row, &value)) = entries.iter().find(|(_, value)| value.abs_diff(0) != 1) {
            return Err(MeshError::InvalidEntry {
                k,
                row,
                column,
                value,
            });
        }
    }
    Ok(matrix)
}

/// The kind of element of a dimension from 0 to 3.
pub(crate) fn kind(dimension: usize) -> ElementKind {
    [
        ElementKind::Vertex,
        ElementKind::Edge,
        ElementKind::Face,
        ElementKind::Cell,
    ][dimension]
}
