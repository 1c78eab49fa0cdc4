//! What an array looks like to which blocks are added.

use sprs::CsMat;

/// The size of an array, and of a sparse one where its entries are.
#[derive(Debug)]
pub struct Pattern {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) entries: usize,
    /// Where columns start in `indices`; of a dense array both are empty.
    pub(super) pointers: Vec<usize>,
    /// Rows, ascending in each column.
    pub(super) indices: Vec<usize>,
}

impl Pattern {
    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.entries
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// A sparse matrix of this pattern.
    pub fn matrix(&self, data: Vec<f64>) -> CsMat<f64> {
        let size = (self.rows, self.columns);
        CsMat::new_csc(size, self.pointers.clone(), self.indices.clone(), data)
    }

    /// Whether a matrix has this pattern.
    pub(super) fn is_of(&self, matrix: &CsMat<f64>) -> bool {
        matrix.is_csc()
            && matrix.shape() == (self.rows, self.columns)
            && matrix.indices() == self.indices
            && matrix.proper_indptr().as_ref() == self.pointers
    }
}
