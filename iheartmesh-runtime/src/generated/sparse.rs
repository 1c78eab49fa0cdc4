//! Sparse matrices, through sprs.

use sprs::{CsMat, TriMat};

use super::array::{Array, Build};

/// The sparse matrix with these numbers on its diagonal.
pub fn sparse_diagonal(entries: &[f64]) -> CsMat<f64> {
    let n = entries.len();
    let mut triplets = TriMat::new((n, n));
    for (i, entry) in entries.iter().enumerate() {
        triplets.add_triplet(i, i, *entry);
    }
    triplets.to_csc()
}

/// The matrix without entries.
pub fn sparse_zeros(rows: usize, columns: usize) -> CsMat<f64> {
    TriMat::new((rows, columns)).to_csc()
}

/// A matrix with the entries other than 0 stored.
pub fn sparse(a: &impl Array<Item = f64>) -> CsMat<f64> {
    let mut triplets = TriMat::new((a.rows(), a.columns()));
    for j in 0..a.columns() {
        for i in 0..a.rows() {
            let entry = a.entry(i, j);
            if entry != 0.0 {
                triplets.add_triplet(i, j, entry);
            }
        }
    }
    triplets.to_csc()
}

/// The product of a sparse matrix and a dense one.
pub fn sparse_product<R: Build<Item = f64>>(a: &CsMat<f64>, b: &impl Array<Item = f64>) -> R {
    let mut all = R::zeros(a.rows(), b.columns());
    for (value, (i, k)) in a {
        for j in 0..b.columns() {
            let entry = all.entry(i, j) + value * b.entry(k, j);
            all.set(i, j, entry);
        }
    }
    all
}

/// The transpose in compressed columns.
pub fn sparse_transpose(a: &CsMat<f64>) -> CsMat<f64> {
    a.transpose_view().to_csc()
}
