//! Boundary matrices: compressed columns, read by column and checked when they come from outside.
//!
//! A column is a slice of row numbers and a slice of signs. For users there are matrices of `sprs`, made when they are asked for;
//! nothing here computes with them.

use std::ops::Range;

use sprs::CsMatI;

use crate::element::ElementKind;
use crate::generated::FIRST_MISSING;
use crate::mesh::MeshError;

/// A boundary matrix or a coboundary matrix (its transpose), signed or unsigned.
///
/// Compressed columns (CSC): `u32` column pointers, `u32` row numbers ascending in each column, `i8` entries −1, +1
/// (unsigned: 1), none of them zero.
pub type BoundaryMatrix = CsMatI<i8, u32>;

/// Largest number of elements of one kind: larger numbers stand for missing ones.
pub(crate) const MAX_ELEMENTS: usize = FIRST_MISSING as usize;

/// Largest number of edges: ∂¹ has two entries for each, whose number must be a `u32` too.
pub(crate) const MAX_EDGES: usize = u32::MAX as usize / 2;

/// A matrix with entries −1 and +1 in compressed columns, as this crate reads it.
///
/// What is the same in every column is not stored: how many entries there are, as two in ∂¹ and three in ∂² of triangles, and
/// which, as −1 and +1 in ∂¹.
#[derive(Clone)]
pub(crate) struct Columns {
    /// Where each column starts, and the end. Empty if each has `width` entries.
    pub(crate) pointers: Vec<u32>,
    /// How many entries each column has, where there are no pointers; otherwise without meaning.
    pub(crate) width: usize,
    /// Row numbers, ascending in each column.
    pub(crate) rows: Vec<u32>,
    /// The entries. Empty if those of each column are −1, +1.
    pub(crate) signs: Vec<i8>,
}

impl Columns {
    /// Row numbers (ascending) and entries of column `j`.
    #[inline]
    pub(crate) fn column(&self, j: usize) -> (&[u32], &[i8]) {
        if self.signs.is_empty() && !self.rows.is_empty() {
            return (self.pair(j), &[-1, 1]);
        }
        let range = self.range(j);
        (&self.rows[range.clone()], &self.signs[range])
    }

    /// The row numbers of column `j`, ascending. Saves the bounds checks of the entries.
    #[inline]
    pub(crate) fn column_rows(&self, j: usize) -> &[u32] {
        &self.rows[self.range(j)]
    }

    /// The two row numbers of column `j` of a matrix of which each column has two.
    #[inline]
    pub(crate) fn pair(&self, j: usize) -> &[u32; 2] {
        &self.rows.as_chunks().0[j]
    }

    /// Where column `j` stands.
    #[inline]
    pub(crate) fn range(&self, j: usize) -> Range<usize> {
        match self.pointers.is_empty() {
            true => self.width * j..self.width * (j + 1),
            false => self.pointers[j] as usize..self.pointers[j + 1] as usize,
        }
    }

    /// Number of columns.
    pub(crate) fn n(&self) -> usize {
        match self.pointers.is_empty() {
            true => self.rows.len() / self.width,
            false => self.pointers.len() - 1,
        }
    }

    /// The matrix with these columns and `n_rows` rows, for code outside of this crate: a copy, whose structure `sprs` checks.
    pub(crate) fn to_matrix(&self, n_rows: usize) -> BoundaryMatrix {
        let pointers = match self.pointers.is_empty() {
            true => (0..=self.n())
                .map(|column| (self.width * column) as u32)
                .collect(),
            false => self.pointers.clone(),
        };
        let signs = match self.signs.is_empty() {
            true => [-1, 1].repeat(self.rows.len() / 2),
            false => self.signs.clone(),
        };
        BoundaryMatrix::try_new_csc((n_rows, self.n()), pointers, self.rows.clone(), signs)
            .unwrap_or_else(|(.., error)| {
                panic!("bug in iheartmesh: malformed boundary matrix: {error}")
            })
    }

    /// The transpose of the matrix with these columns and `n_rows` rows. One counting sort: O(rows + columns + entries).
    pub(crate) fn transposed(&self, n_rows: usize) -> Columns {
        let mut pointers = vec![0_u32; n_rows + 1];
        for &row in &self.rows {
            pointers[row as usize + 1] += 1;
        }
        for row in 0..n_rows {
            pointers[row + 1] += pointers[row];
        }
        let mut cursors = pointers.clone();
        let mut rows = vec![0; self.rows.len()];
        let mut signs = vec![0; self.rows.len()];
        for j in 0..self.n() {
            let (column_rows, column_signs) = self.column(j);
            for (&row, &sign) in column_rows.iter().zip(column_signs) {
                let cursor = &mut cursors[row as usize];
                rows[*cursor as usize] = j as u32;
                signs[*cursor as usize] = sign;
                *cursor += 1;
            }
        }
        Columns {
            pointers,
            width: 0,
            rows,
            signs,
        }
    }
}

/// The matrix of absolute values.
pub(crate) fn unsigned(matrix: &BoundaryMatrix) -> BoundaryMatrix {
    matrix.map(|sign| sign.abs())
}

/// Brings ∂ᵏ as a user gives it into the form that this crate keeps, or says why it is no boundary matrix.
///
/// # Errors
/// [`MeshError::TooManyElements`], and [`MeshError::InvalidEntry`] for a stored entry other than −1 and +1.
pub(crate) fn checked(k: usize, matrix: &BoundaryMatrix) -> Result<Columns, MeshError> {
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
    let (pointers, rows, signs) = matrix.into_raw_storage();
    Ok(Columns {
        pointers,
        width: 0,
        rows,
        signs,
    })
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
